// SPDX-License-Identifier: Apache-2.0
// Spring, damper and friction between a proxy and the surface that it touches.
#pragma once

#include <algorithm>

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// One contact of a tool: depth m, n unit normal out of the tissue, velocity of the tool relative to the
/// tissue m/s.
struct ContactResponse {
    double stiffness = 0, damping = 0;  ///< N/m, N s/m
    double friction = 0;
    double onset_depth =
        0.0005;  ///< m over which damping rises to its full value, so that first contact causes no jump

    /// Force of the tool on the tissue, N. Never attractive; its tangential part is at most friction times
    /// the normal part.
    Vector3 force_on_tissue(double depth, const Vector3& n, const Vector3& velocity) const {
        if (!(depth > 0)) return Vector3::Zero();
        const double share = std::min(1.0, depth / onset_depth);
        const double approach = velocity.dot(n);
        const double normal_force = std::max(0.0, stiffness * depth - share * damping * approach);
        Vector3 drag = share * damping * (velocity - approach * n);
        const double size = drag.norm(), most = friction * normal_force;
        if (size > most) drag *= most / size;
        return drag - normal_force * n;
    }
    /// The part of it that would be left without damping, N.
    Vector3 spring_force(double depth, const Vector3& n) const {
        return depth > 0 ? Vector3(-stiffness * depth * n) : Vector3(Vector3::Zero());
    }
};

}  // namespace fulcrum
