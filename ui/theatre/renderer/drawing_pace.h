// SPDX-License-Identifier: GPL-3.0-or-later
// How much of its full resolution a live scene is drawn in, from how long its last pictures took: where the
// machine is slow the picture grows coarser before it comes late, and is fine again when there is time. No
// clock and no state except the durations it is given; one thread.
#pragma once

#include <array>
#include <cstddef>

namespace fulcrum::ui {

class DrawingPace {
  public:
    static constexpr double goal_ms =
        15;  ///< half of the pictures may take longer; the budget is 20 ms, handing over included
    static constexpr int levels = 6;  ///< 0: full resolution
    /// Share of the full resolution, along each side, that a level draws in. Each shades 0.83 of the pixels
    /// of the one before.
    static double share_at(int level);

    /// A picture was drawn in that time, ms, at share(). What is no duration (negative, not finite) does not
    /// count. True: the share has changed.
    bool drawn(double ms);
    /// From the full resolution again; nothing is remembered.
    void restart() { *this = DrawingPace(); }
    int level() const { return level_; }
    double share() const { return share_at(level_); }

  private:
    static constexpr std::size_t window = 15;    // pictures that a median is taken of: half a second
    static constexpr int calm = 6;               // windows in a row that have time to spare before a step up
    static constexpr int most_calm = 16 * calm;  // that many after steps up that did not last
    static constexpr int kept_windows = 2 * calm;  // that long a step up lasts, to be called lasting

    bool go_to(int level);
    std::array<double, window> times_{};  // ms, since the last decision
    std::size_t count_ = 0;
    int level_ = 0;
    int calm_windows_ = 0, wanted_calm_ = calm;
    int since_up_ = kept_windows;  // windows, no more than kept_windows
};

}  // namespace fulcrum::ui
