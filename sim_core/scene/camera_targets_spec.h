// SPDX-License-Identifier: Apache-2.0
// Balls in open cups to be framed with an angled scope, and a tip that moves (task A1): their values in a
// scene. SI units.
#pragma once

#include <string>

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// The attempt's seed draws a place of the lens, a turn of the light post and a ball that they frame, cup by
/// cup, so that each can be seen into with this scope through this trocar.
struct CameraTargetsSpec {
    static constexpr int most = 16;
    int count = 12;              ///< cups, 1 .. most
    double ball_radius = 0.004;  ///< m
    double cup_radius = 0.0065;  ///< m, inside
    double wall = 0.0015;        ///< m, of a cup
    double cup_depth = 0.009;    ///< m, from the mouth to the ball's middle
    double distance = 0.045;     ///< m, from the lens at which a ball has the wanted size
    double spacing = 0.024;      ///< m, least distance between two cups
    double least_insertion = 0.04, most_insertion = 0.10;  ///< m, of the scope where the balls are framed
    double swing = 0.4014257279586958;  ///< rad, largest angle of the shaft from its nominal direction there
    double tilt = 0.13962634015954636;  ///< rad, largest angle of a cup from the line of sight
    double lens_radius = 0.005;         ///< m, of the scope's end
    Vector3 tip_centre = Vector3(0, -0.01, 0.02);       ///< m, about which the tip moves
    Vector3 tip_extent = Vector3(0.022, 0.012, 0.012);  ///< m, at most, to either side
    double tip_speed = 0.010;                           ///< m/s, largest along an axis
    std::string tissue = "cup";                         ///< label of cups and tip
};

}  // namespace fulcrum
