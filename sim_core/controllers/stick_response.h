// SPDX-License-Identifier: Apache-2.0
// How far a stick is pushed, and the speed that it asks for.
#pragma once

#include <algorithm>

namespace fulcrum {

inline constexpr double stick_dead_zone = 0.15;    ///< of the range: the middle of a stick is not exact
inline constexpr double stick_linear_part = 0.25;  ///< of the response; the rest is cubic, for fine movements

/// Share of the fastest speed for a stick pushed by `pushed` (0 to 1) in its own direction.
inline double stick_speed(double pushed) {
    const double beyond = (std::min(pushed, 1.0) - stick_dead_zone) / (1 - stick_dead_zone);
    if (!(beyond > 0)) return 0;
    return beyond * (stick_linear_part + (1 - stick_linear_part) * beyond * beyond);
}

}  // namespace fulcrum
