// SPDX-License-Identifier: Apache-2.0
// How jaws take tissue, hold it and lose it, whatever the tissue.
#pragma once

namespace fulcrum::jaw_rules {

inline constexpr double close_share = 0.35,
                        open_share = 0.45;  // of the widest opening: hysteresis between taking and letting go
inline constexpr double least_grip = 0.2;   // N: weaker jaws hold nothing
inline constexpr double grasp_reach = 0.006;     // m from the middle of the jaws to the surface
inline constexpr double correction_time = 0.06;  // s: the tissue is drawn into the jaws in this time
inline constexpr double fastest_hold =
    2.0;                                    // m/s: a device that jumps does not tear the tissue along at once
inline constexpr double slip_delay = 0.02;  // s of overload before the tissue leaves the jaws
inline constexpr double pinch_share = 2.0;  // of the tissue's contact stiffness: both walls between the jaws

}  // namespace fulcrum::jaw_rules
