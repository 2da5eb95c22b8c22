// SPDX-License-Identifier: Apache-2.0
// What a cheat sees, remembers and does to the hands; and the cheats by which a gate was once met without the
// work that it asks for (closed_loopholes.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "assessment/operators/operator.h"

namespace fulcrum {

/// What a cheat sees and remembers.
struct CheatView {
    double time = 0;                                 ///< s since the first tick
    TaskDisplay display;                             ///< as last shown
    std::array<GraspState, hand_count> grasps;       ///< as last shown
    std::array<bool, hand_count> vessel_held{};      ///< a band with a vessel is held
    RigSample first;                                 ///< before anything moved
    std::array<DeviceSample, hand_count> last_read;  ///< of the expert, the tick before
    std::array<DeviceSample, hand_count> kept;       ///< a pose that was frozen
    bool frozen = false, energy_used = false, energy_before = false;
    double pull = 0;          ///< m
    double released_at = -1;  ///< s, when the pedal came up last; negative: never
    double opens_until = 0;   ///< s
    int falls = 0;            ///< so often the bowel was let fall
};

namespace cheating {

inline std::int32_t counts(double metres) {
    return static_cast<std::int32_t>(std::lround(metres / device_length_unit));
}

/// Moves a tip along its shaft, positive deeper.
inline void along_shaft(DeviceSample& sample, double distance) {
    double squares = 0;
    for (const std::int32_t value : sample.handle) squares += static_cast<double>(value) * value;
    const double length = std::sqrt(squares);
    if (length <= 0) return;
    const double scale = std::max(0.02, 1 - distance / device_length_unit / length);
    for (std::int32_t& value : sample.handle)
        value = static_cast<std::int32_t>(std::lround(scale * static_cast<double>(value)));
}

inline void aside(DeviceSample& sample, double x, double y) {
    sample.handle[0] += counts(x);
    sample.handle[1] += counts(y);
}

inline constexpr double turned_away = 0.9;  // rad: nothing of the work is in the image
/// Turns the scope about its entry by so many rad.
void turn_scope(RigSample& sample, double angle);

inline constexpr double wait_s = 18;  // s before look_away() begins the task; a multiple of 2
/// Before the task is begun: the hands stay where they are and sway by less than 1 mm.
void wait_in_view(const CheatView& view, RigSample& sample);
/// The camera is turned away for more than a third of each ten seconds. The wait before once paid for that.
void look_away(CheatView& view, RigSample& sample);
/// In turns of four seconds the left hand tears and the blade, which the right hand then has, divides: what
/// tore was once as good as divided where a blade trimmed it.
void tear_and_trim(CheatView& view, RigSample& sample);
/// The pedal is down in the open air for one second of four, and for two seconds after each division, in jaws
/// that stay closed: that was once safe use, which outweighed the other.
void pedal_in_the_air(CheatView& view, RigSample& sample);
/// The lifted bowel is let fall three times and grasped again: only what slipped was once a drop.
void let_fall(CheatView& view, RigSample& sample);

}  // namespace cheating
}  // namespace fulcrum
