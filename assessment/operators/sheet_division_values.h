// SPDX-License-Identifier: Apache-2.0
// Distances, times and forces by which operators divide a sheet.
#pragma once

namespace fulcrum::sheet_division {

inline constexpr double open_share = 0.85, closed_share = 0.12;  // of the widest opening
inline constexpr double beyond_rim =
    0.0015;  // m outside the flap's edge where the jaws' middle goes down next to it
inline constexpr double deeper = 0.001;  // m further inwards at every further attempt
inline constexpr double hover = 0.022;   // m back along the shaft, on the way to a grasp
inline constexpr double shortest_close_s = 0.35;
inline constexpr double pull_step = 0.0025;      // m, longest single pull
inline constexpr double least_step = 0.0004;     // m, below it a pull is not worth making
inline constexpr double longest_pull = 0.030;    // m from where it was taken: then a new hold is better
inline constexpr double ahead = 0.012;           // m of the line by which a hold leads the cut
inline constexpr double reach_of_hold = 0.030;   // m of the line that one hold keeps taut
inline constexpr double blade_felt = 0.02;       // N, below it the blade is not on the sheet
inline constexpr double blade_height = 0.010;    // m above the sheet, between strokes
inline constexpr double press_step = 0.0015;     // m deeper when the blade has not broken through
inline constexpr double deepest_press = 0.012;   // m
inline constexpr double blade_depth = 0.0015;    // m below the sheet, of the tip in a stroke
inline constexpr double chunk = 0.007;           // m of the line in one sub-movement
inline constexpr double run_over = 0.003;        // m beyond either end of the line
inline constexpr double seconds_to_learn = 3.0;  // content with a tension that is not the one asked for
inline constexpr double seconds_to_wait = 5.0;   // for tension; then a new hold is taken

inline constexpr double jaw_clearance =
    0.003;                                    // m from the rectum's wall to the shaft's axis when jaws close
inline constexpr double nearer = 0.0015;      // m at every further attempt on the rectum
inline constexpr double over_septum = 0.001;  // m beyond a septum's rim
inline constexpr double inside_rim = 0.004;   // m of the line
inline constexpr double deepest_septum_press = 0.006;  // m: the next septum is not far behind
inline constexpr double further_on = 0.001;            // m along the line after a place that gave no hold
inline constexpr int most_misses = 4;
inline constexpr double near_enough = 0.010;   // m, of a point that is only passed
inline constexpr double lift_step = 0.0012;    // m, longest single pull on a rectum
inline constexpr double settle_s = 0.25;       // s until the tissue behind it has followed
inline constexpr double longest_lift = 0.045;  // m of the rectum from where it was taken
inline constexpr double lift_hover = 0.020;    // m off the rectum, on the way to a grasp

}  // namespace fulcrum::sheet_division
