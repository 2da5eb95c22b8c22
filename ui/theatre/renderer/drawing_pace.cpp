// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/drawing_pace.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::ui {
namespace {

constexpr double shares[DrawingPace::levels] = {1.0, 0.91, 0.83, 0.76, 0.69, 0.63};
// Of the goal that one level finer may take, if all of a picture's time goes with its pixels: some of it does
// not, so that a step up under an even load is never taken back.
constexpr double spare = 0.92;

/// Pixels of a level as a share of those of another.
double pixels(int level, int of) {
    const double ratio = DrawingPace::share_at(level) / DrawingPace::share_at(of);
    return ratio * ratio;
}

}  // namespace

double DrawingPace::share_at(int level) {
    return shares[std::clamp(level, 0, levels - 1)];
}

bool DrawingPace::go_to(int level) {
    calm_windows_ = 0;
    if (level == level_) return false;
    level_ = level;
    return true;
}

bool DrawingPace::drawn(double ms) {
    if (!(ms >= 0) || !std::isfinite(ms)) return false;
    times_[count_++] = ms;
    if (count_ < window) return false;
    count_ = 0;
    std::nth_element(times_.begin(), times_.begin() + window / 2, times_.end());
    const double median = times_[window / 2];
    if (since_up_ < kept_windows && ++since_up_ == kept_windows) wanted_calm_ = calm;
    if (median > goal_ms) {
        // As far as it takes, if all of the time went with the pixels: rather once more than too far.
        int level = std::min(level_ + 1, levels - 1);
        while (level < levels - 1 && median * pixels(level, level_) > goal_ms) ++level;
        if (level != level_ && since_up_ < kept_windows) {
            wanted_calm_ = std::min(2 * wanted_calm_, most_calm);
            since_up_ = kept_windows;
        }
        return go_to(level);
    }
    if (level_ == 0 || median * pixels(level_ - 1, level_) > spare * goal_ms) return go_to(level_);
    if (++calm_windows_ < wanted_calm_) return false;
    since_up_ = 0;
    return go_to(level_ - 1);
}

}  // namespace fulcrum::ui
