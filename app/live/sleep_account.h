// SPDX-License-Identifier: GPL-3.0-or-later
// How long the program stood still: the clock of the ticks does not advance while the machine sleeps, so no
// tick is late after that; how long it slept follows from a second clock.
//
// Haptic thread: no allocation, lock or exception. The result depends on the arguments only.
#pragma once

#include <cstdint>
#include <optional>

namespace fulcrum::app {

/// How long the program stood still between two ticks, the sleep of the machine included.
class SleepAccount {
  public:
    /// ns, when a tick begins `late` ns after its deadline. `paused`: the attempt is paused now. A sleep that
    /// began in a pause does not count, and neither does the delay around it: programs are stopped before
    /// the machine sleeps, and start again some time after it. Without a sleep the delay counts in a pause
    /// too.
    std::int64_t stood_still(std::int64_t late, std::int64_t monotonic, std::int64_t boot,
                             bool paused) noexcept {
        const std::int64_t asleep = slept(monotonic, boot);
        const bool in_pause = paused_;
        paused_ = paused;
        return in_pause && asleep >= least_sleep ? 0 : late + asleep;
    }
    /// ns by which CLOCK_BOOTTIME gained on CLOCK_MONOTONIC since the last call; 0 at the first. Where the
    /// thread was preempted between reading the clocks, it is that much too long, and the next one too short.
    std::int64_t slept(std::int64_t monotonic, std::int64_t boot) noexcept {
        const std::int64_t ahead = boot - monotonic, before = ahead_.value_or(ahead);
        ahead_ = ahead;
        return ahead - before;
    }

  private:
    static constexpr std::int64_t least_sleep = 20'000'000;  // ns; less may be a preempted thread

    std::optional<std::int64_t> ahead_;
    bool paused_ = false;  // when the last tick began
};

}  // namespace fulcrum::app
