// SPDX-License-Identifier: GPL-3.0-or-later
// Whose doing is it that a tick begins late: the program's, or that of whoever took the processor away?
//
// The wall clock cannot tell: a tick of 20 us lasts 5 ms when the system runs another thread, or the host
// another machine, in the middle of it. The thread's own processor time can: it stands still meanwhile. It
// counts what the system does for the thread (page faults, system calls, and interrupts where the kernel does
// not tell them apart), so all of that is the program's. It also stands still while the thread waits for a
// lock or a disk, which is the program's doing; so a tick in which the thread gave the processor up by itself
// is charged with the time on the wall. A tick's work goes from the return of the clock's wait to the last
// thing before the next: the wait itself, and what the system does to end it, is the scheduler's.
//
// Haptic thread: no allocation, lock or exception. The account is a pure function of what it is given.
#pragma once

#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <cstdint>

namespace fulcrum::app {

/// What a thread has used, so far or between two moments.
struct ThreadUse {
    std::int64_t processor_ns = 0;
    std::int64_t waits = 0;        ///< times that it gave the processor up by itself
    std::int64_t preemptions = 0;  ///< times that the system gave its processor to another thread
    std::int64_t page_faults = 0;
};
inline ThreadUse operator-(const ThreadUse& a, const ThreadUse& b) noexcept {
    return {a.processor_ns - b.processor_ns, a.waits - b.waits, a.preemptions - b.preemptions,
            a.page_faults - b.page_faults};
}

/// Of the calling thread. Two system calls, half a microsecond.
inline ThreadUse use_of_this_thread() noexcept {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return {time.tv_sec * 1000000000LL + time.tv_nsec, usage.ru_nvcsw, usage.ru_nivcsw,
            usage.ru_minflt + usage.ru_majflt};
}

enum class Lateness : std::uint8_t { in_time, by_program, by_scheduler };

/// Follows how late the ticks would be had the thread always had its processor.
class TickAccount {
  public:
    explicit TickAccount(std::int64_t period_ns) : period_(period_ns) {}

    /// A tick begins `late_ns` after its deadline; the work of the one before took `wall_ns` and used `use`.
    /// Late by a period or more, it is missed: by the program if that work of its own, with what it was still
    /// behind by such work, fills the period.
    Lateness begin(std::int64_t late_ns, std::int64_t wall_ns, const ThreadUse& use) noexcept {
        const std::int64_t own = use.waits > 0 ? std::max(wall_ns, use.processor_ns) : use.processor_ns;
        const std::int64_t work = behind_ + own;
        behind_ = std::clamp<std::int64_t>(work - period_, 0, std::max<std::int64_t>(late_ns, 0));
        if (late_ns < period_) return Lateness::in_time;
        return work >= period_ ? Lateness::by_program : Lateness::by_scheduler;
    }
    /// The deadline was moved to now: nothing is left to catch up.
    void clock_moved() noexcept { behind_ = 0; }

  private:
    std::int64_t period_;
    std::int64_t behind_ = 0;  // ns by which own work alone makes the tick late; never more than it is
};

}  // namespace fulcrum::app
