// SPDX-License-Identifier: Apache-2.0
// Decides whether a late tick was caused by the program or by the scheduler.
//
// Wall time cannot decide this: a tick of 20 us takes 5 ms if the system runs another thread, or the host
// another machine, in the middle of it. The thread's processor time can, because it does not advance while
// another thread runs. It includes the work of the system for the thread (page faults, system calls, and
// interrupts where the kernel does not separate them); this is attributed to the program. Processor time does
// not advance either while the thread waits for a lock or a disk, which the program causes; therefore a tick
// with a voluntary context switch counts with its wall time. The work of a tick lasts from the return of the
// clock's wait to the next wait; the wait itself is attributed to the scheduler.
//
// Haptic threads: no allocation, lock or exception. The result depends on the arguments only.
#pragma once

#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <cstdint>

namespace fulcrum {

/// Resources used by a thread, in total or between two moments.
struct ThreadUse {
    std::int64_t processor_ns = 0;
    std::int64_t waits = 0;        ///< voluntary context switches
    std::int64_t preemptions = 0;  ///< involuntary context switches
    std::int64_t page_faults = 0;
};
inline ThreadUse operator-(const ThreadUse& a, const ThreadUse& b) noexcept {
    return {a.processor_ns - b.processor_ns, a.waits - b.waits, a.preemptions - b.preemptions,
            a.page_faults - b.page_faults};
}

/// Resources used by the calling thread. Two system calls, half a microsecond.
inline ThreadUse use_of_this_thread() noexcept {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return {time.tv_sec * 1000000000LL + time.tv_nsec, usage.ru_nvcsw, usage.ru_nivcsw,
            usage.ru_minflt + usage.ru_majflt};
}

enum class Lateness : std::uint8_t { in_time, by_program, by_scheduler };

/// Tracks how late the ticks would be if the thread always had its processor.
class TickAccount {
  public:
    explicit TickAccount(std::int64_t period_ns) : period_(period_ns) {}

    /// A tick begins `late_ns` after its deadline; the work of the previous tick took `wall_ns` and used
    /// `use`. A tick that is late by a period or more is missed. The program missed it if its own work, with
    /// the delay left from its own earlier work, fills the period.
    Lateness begin(std::int64_t late_ns, std::int64_t wall_ns, const ThreadUse& use) noexcept {
        const std::int64_t own = use.waits > 0 ? std::max(wall_ns, use.processor_ns) : use.processor_ns;
        const std::int64_t work = behind_ + own;
        behind_ = std::clamp<std::int64_t>(work - period_, 0, std::max<std::int64_t>(late_ns, 0));
        if (late_ns < period_) return Lateness::in_time;
        return work >= period_ ? Lateness::by_program : Lateness::by_scheduler;
    }
    /// The deadline was moved to now: no delay is left to catch up.
    void clock_moved() noexcept { behind_ = 0; }

  private:
    std::int64_t period_;
    std::int64_t behind_ = 0;  // ns of delay caused by own work alone; at most the actual delay
};

}  // namespace fulcrum
