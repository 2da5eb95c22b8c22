// SPDX-License-Identifier: GPL-3.0-or-later
// Timing statistics of an attempt's threads: atomic counters that any thread may read at any time.
#pragma once

#include <atomic>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "app/live/histogram.h"
#include "sim_core/devices/tick_account.h"

namespace fulcrum::app {

/// Between the program's ticks and those of the process that drives its device.
struct DeviceTiming {
    Durations pose_age;     ///< from reading the device to the program's tick that uses it
    Durations force_delay;  ///< from the program's command to the device's tick that renders it
    Durations jitter;       ///< time between two readings, less the device's period
    std::uint64_t device_ticks = 0, device_late = 0;  ///< ticks of that process; those a period late
    std::uint64_t device_late_own = 0;                ///< of these: because of its own work or waits
    bool real_time_priority = false;                  ///< of that process
};

/// Missed ticks, late steps and durations.
struct LoopStatistics {
    std::uint64_t ticks = 0;
    std::uint64_t missed_by_program =
        0;  ///< ticks that began a period late because of the thread's own work or waits
    std::uint64_t missed_by_scheduler =
        0;                             ///< ticks that began a period late because the thread had no processor
    std::uint64_t waits_in_ticks = 0;  ///< voluntary context switches within ticks
    std::uint64_t preemptions_in_ticks = 0;  ///< involuntary context switches within ticks
    std::uint64_t page_faults_in_ticks = 0;
    std::uint64_t late_steps = 0;
    std::uint64_t lost_samples = 0;
    std::uint64_t replay_bytes = 0;  ///< memory of the key frames that are made for its replay
    Durations wake;                  ///< delay of waking
    Durations tick;                  ///< duration of a tick
    Durations own;                   ///< processor time of a tick
    Durations step;                  ///< duration of a world step
    bool real_time_priority = false;
    std::optional<DeviceTiming> device;  ///< none: the hands' device is read by the program itself
};

/// The format of `perform --realtime --json` and `lab clock`.
nlohmann::json statistics_json(const LoopStatistics& statistics);

/// Each counter has one writer: the world thread for the steps, the haptic thread for all others.
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
    /// All values except ticks and lost_samples, which are counted elsewhere.
    LoopStatistics read() const noexcept {
        LoopStatistics read;
        read.missed_by_program = missed_by_program_.load();
        read.missed_by_scheduler = missed_by_scheduler_.load();
        read.waits_in_ticks = waits_.load();
        read.preemptions_in_ticks = preemptions_.load();
        read.page_faults_in_ticks = page_faults_.load();
        read.late_steps = late_steps_.load();
        read.wake = wake_.read();
        read.tick = tick_.read();
        read.own = own_.read();
        read.step = step_.read();
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
