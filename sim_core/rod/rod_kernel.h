// SPDX-License-Identifier: Apache-2.0
// Energy, gradient and exact second derivative of the joints, four at a time.
//
// A joint between unit tangents s (of edge a) and t (of edge b), c = s.t, curvature binormal k = 2 s x t / (1
// + c), has
//     2 B (1 - c)/(1 + c) [- B (1 - c)^2 / 3 without natural curvature] + Re(w K_a) + B |K0|^2 / 2 + T (m -
//     m0)^2 / 2,
// the first three terms being B |K - K0|^2 / 2 with K = (k.d1 + i k.d2) seen from directors turned half the
// twist m (so that both sides see the same), K_a = K e^(i m/2) seen from edge a, and w = -B conj(K0) e^(-i
// m/2). Directors follow tangents by parallel transport (Bergou et al. 2008, 2010); the derivatives are of
// the map (a, b, angle_a, angle_b), to second order exactly.
#pragma once

#include <cstddef>
#include <vector>

#include "sim_core/numerics/block_band.h"
#include "sim_core/rod/rod_tables.h"

namespace fulcrum {

/// A trial shape. Segment arrays are shifted by one: entry 0 and n + 1 are the end frames; padded for loads
/// of four.
struct RodShape {
    std::vector<double>
        position;  ///< 4 a node: x, y, z and the twist angle of segment i since the step's start
    std::vector<double> tx, ty, tz;  ///< unit tangents
    std::vector<double> dx, dy, dz;  ///< directors d1
    std::vector<double> inverse;     ///< 1 / edge length, 1/m; 0 at the end frames, which are given
    std::vector<double> length;      ///< m
    std::vector<double> twist;       ///< per joint, rad, unwrapped

    void resize(int segments);
    std::size_t bytes() const;
};

/// What the joints give: second derivatives and gradients in edge variables (edge vector, twist angle), by
/// joint.
struct RodJointTerms {
    std::vector<double> gradient_a, gradient_b;  ///< 4 a joint
    std::vector<Block4> aa, bb, ab;              ///< ab: rows a, columns b
    std::vector<double> energy;                  ///< by joint, J; filled by unit_joint_terms alone
    double bend = 0, twist = 0;                  ///< J

    void resize(int segments);
    std::size_t bytes() const;
};

/// False when a joint is folded back on itself (1 + c below 1e-9), where the energy has no bound.
bool joint_terms(const Rod::Tables& tables, const RodShape& shape, bool hessian, RodJointTerms& out);

/// As joint_terms, with the given bending stiffness of each joint (N m, padded) instead of the tables'.
bool joint_terms(const Rod::Tables& tables, const RodShape& shape, const std::vector<double>& bend,
                 bool hessian, RodJointTerms& out);

/// Bending energy and its gradient by joint for stiffness 1 and no twist: half the squared turn.
bool unit_joint_terms(const Rod::Tables& tables, const RodShape& shape, RodJointTerms& out);

}  // namespace fulcrum
