// SPDX-License-Identifier: GPL-3.0-or-later
// How an attempt's threads kept their clock: counted by them in atomics, read by anybody at any time.
#pragma once

#include <atomic>
#include <cstdint>

#include "app/histogram.h"
#include "app/tick_account.h"

namespace fulcrum::app {

/// How the loop kept its clock.
struct LoopStatistics {
    std::uint64_t ticks = 0;
    std::uint64_t missed_by_program = 0;     ///< a tick began a period late by the thread's own work or waits
    std::uint64_t missed_by_scheduler = 0;   ///< a tick began a period late because it had no processor
    std::uint64_t waits_in_ticks = 0;        ///< times that the thread gave the processor up within a tick
    std::uint64_t preemptions_in_ticks = 0;  ///< times that the system ran another thread in its place
    std::uint64_t page_faults_in_ticks = 0;
    std::uint64_t late_steps = 0;
    std::uint64_t lost_samples = 0;
    double wake_p50_us = 0, wake_p99_us = 0, wake_p999_us = 0, wake_worst_us = 0;  ///< lateness of waking
    double tick_p50_us = 0, tick_p99_us = 0, tick_worst_us = 0;                    ///< duration of a tick
    double own_p50_us = 0, own_p99_us = 0, own_worst_us = 0;     ///< of it the thread's own processor time
    double step_p50_us = 0, step_p99_us = 0, step_worst_us = 0;  ///< duration of a world step
    bool real_time_priority = false;
};

/// One writer a counter: the haptic thread, but for the steps, which are the world thread's.
class LoopCounters {
  public:
    void tick_begins(std::int64_t late_ns, Lateness lateness) noexcept {
        wake_.add(us(late_ns));
        add(missed_by_program_, lateness == Lateness::by_program ? 1 : 0);
        add(missed_by_scheduler_, lateness == Lateness::by_scheduler ? 1 : 0);
    }
    void tick_ends(std::int64_t wall_ns, const ThreadUse& use) noexcept {
        tick_.add(us(wall_ns));
        own_.add(us(use.processor_ns));
        add(waits_, use.waits);
        add(preemptions_, use.preemptions);
        add(page_faults_, use.page_faults);
    }
    void step_is_late() noexcept { add(late_steps_, 1); }
    void step_ends(std::int64_t wall_ns) noexcept { step_.add(us(wall_ns)); }
    void real_time_priority(bool granted) noexcept {
        real_time_priority_.store(granted, std::memory_order_relaxed);
    }

    std::uint32_t missed() const noexcept {
        return static_cast<std::uint32_t>(missed_by_program_.load(std::memory_order_relaxed) +
                                          missed_by_scheduler_.load(std::memory_order_relaxed));
    }
    std::uint32_t late_steps() const noexcept { return static_cast<std::uint32_t>(late_steps_.load()); }
    /// All but ticks and lost_samples, which others count.
    LoopStatistics read() const noexcept {
        LoopStatistics read;
        read.missed_by_program = missed_by_program_.load();
        read.missed_by_scheduler = missed_by_scheduler_.load();
        read.waits_in_ticks = waits_.load();
        read.preemptions_in_ticks = preemptions_.load();
        read.page_faults_in_ticks = page_faults_.load();
        read.late_steps = late_steps_.load();
        read.wake_p50_us = wake_.quantile(0.5);
        read.wake_p99_us = wake_.quantile(0.99);
        read.wake_p999_us = wake_.quantile(0.999);
        read.wake_worst_us = wake_.worst();
        read.tick_p50_us = tick_.quantile(0.5);
        read.tick_p99_us = tick_.quantile(0.99);
        read.tick_worst_us = tick_.worst();
        read.own_p50_us = own_.quantile(0.5);
        read.own_p99_us = own_.quantile(0.99);
        read.own_worst_us = own_.worst();
        read.step_p50_us = step_.quantile(0.5);
        read.step_p99_us = step_.quantile(0.99);
        read.step_worst_us = step_.worst();
        read.real_time_priority = real_time_priority_.load();
        return read;
    }

  private:
    using Count = std::atomic<std::uint64_t>;
    static double us(std::int64_t ns) noexcept { return static_cast<double>(ns) * 1e-3; }
    static void add(Count& count, std::int64_t more) noexcept {
        count.fetch_add(static_cast<std::uint64_t>(more), std::memory_order_relaxed);
    }
    DurationHistogram wake_, tick_, own_, step_;
    Count missed_by_program_{0}, missed_by_scheduler_{0}, waits_{0}, preemptions_{0}, page_faults_{0};
    Count late_steps_{0};
    std::atomic<bool> real_time_priority_{false};
};

}  // namespace fulcrum::app
