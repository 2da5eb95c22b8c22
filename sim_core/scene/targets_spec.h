// SPDX-License-Identifier: Apache-2.0
// Rigid spheres to touch (task A2): their values in a scene. SI units.
#pragma once

#include <string>

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// Rigid spheres to touch (A2). Positions are drawn from the attempt's seed inside the box, `per_hand` for
/// each hand, at varied depth.
struct TargetFieldSpec {
    int per_hand = 10;
    double radius = 0.006;                            ///< m
    Vector3 centre = Vector3::Zero();                 ///< m
    Vector3 half_extent = Vector3(0.05, 0.04, 0.03);  ///< m
    double minimum_distance = 0.02;                   ///< m between centres, for all hands together
    std::string tissue = "target";
    double stiffness = 600;  ///< N/m
    double damping = 0.5;    ///< N s/m
};

}  // namespace fulcrum
