// SPDX-License-Identifier: Apache-2.0
// How the hands' device was set up in an attempt, and how often it was read. Stored with the attempt
// (docs/FORMATS.md); nothing is computed from it.
#pragma once

#include <array>
#include <cstdint>

namespace fulcrum {

struct RigUse {
    double stated = 0;    ///< Hz, readings that the device or its driver states; 0: none stated
    double measured = 0;  ///< Hz, readings that arrived in the attempt, over its time; 0: not measured
    double motion = 1;    ///< movement of an instrument over that of its device
    /// Part of the device that moved the left and the right hand and the scope; -1: mouse and keyboard, or
    /// the device has no parts.
    std::array<int, 3> part = {-1, -1, -1};
    int pedal = -2;  ///< part whose button is the pedal of both hands; -1: keys alone; -2: that of each hand
};

/// Every value finite and in its range.
bool is_usable(const RigUse& use);

/// Counts readings over their time. A gap of more than half a second is not counted: a device that was lost
/// is not a slow one. One thread.
class RateMeter {
  public:
    /// `readings` arrived since the last call; `now` in seconds, of any clock.
    void add(int readings, double now) noexcept {
        const double gap = now - last_;
        if (begun_ && gap > 0 && gap <= 0.5) {
            seconds_ += gap;
            count_ += readings;
        }
        begun_ = true;
        last_ = now;
    }
    double rate() const noexcept { return seconds_ > 0 ? static_cast<double>(count_) / seconds_ : 0; }

  private:
    bool begun_ = false;
    std::int64_t count_ = 0;
    double last_ = 0, seconds_ = 0;
};

}  // namespace fulcrum
