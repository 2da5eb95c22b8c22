// SPDX-License-Identifier: Apache-2.0
// The spring, damper and friction between a proxy and what it rests on.
#pragma once

#include <algorithm>

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// One contact of a tool: depth m, n unit out of the tissue, relative velocity of the tool against the tissue
/// m/s.
struct ContactResponse {
    double stiffness = 0, damping = 0;  ///< N/m, N s/m
    double friction = 0;
    double onset_depth = 0.0005;  ///< m over which damping comes in, so that touching is no jump

    /// Force of the tool on the tissue, N: never pulls, its tangential part at most friction times the normal
    /// one.
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
};

}  // namespace fulcrum
