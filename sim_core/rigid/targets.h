// SPDX-License-Identifier: Apache-2.0
// Rigid spheres to touch (A2), placed from the attempt's seed.
#pragma once

#include <vector>

#include "sim_core/numerics/random.h"
#include "sim_core/rigid/target_sphere.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// Penetration of a sphere (the tool's tip) into a rigid sphere, and the outward direction.
struct SphereDepthResult {
    double depth = 0;                   ///< m, > 0 overlapping
    Vector3 normal = Vector3(0, 0, 1);  ///< unit, from the target to the tip; z if the centres coincide
};
SphereDepthResult sphere_depth(const Vector3& tip, double tip_radius, const Vector3& centre, double radius);

/// Draws per_hand targets per hand inside the field's box, hands alternating (left, right, left, ...), the
/// depth stratified over the box so that every hand works near and far; centres of one hand at least
/// minimum_distance apart (relaxed if the box is too small). Same seed, same targets.
std::vector<TargetSphere> place_targets(const TargetFieldSpec& field, std::uint64_t seed);

}  // namespace fulcrum
