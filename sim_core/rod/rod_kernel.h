// SPDX-License-Identifier: Apache-2.0
// Energy, gradient and exact second derivative of the joints, four at a time.
//
// A joint between unit tangents s (of edge a) and t (of edge b), c = s.t, curvature binormal k = 2 s x t / (1
// + c), has the energy
//     2 B (1 - c)/(1 + c) [- B (1 - c)^2 / 3 without natural curvature] + Re(w K_a) + B |K0|^2 / 2 + T (m -
//     m0)^2 / 2.
// The first three terms are B |K - K0|^2 / 2, where K = (k.d1 + i k.d2) is taken in directors rotated by half
// the twist m (symmetric between both edges), K_a = K e^(i m/2) in the directors of edge a, and
// w = -B conj(K0) e^(-i m/2). Directors follow tangents by parallel transport (Bergou et al. 2008, 2010). The
// derivatives are those of the map (a, b, angle_a, angle_b), exact to second order.
#pragma once

#include <cstddef>
#include <vector>

#include "sim_core/numerics/block_band.h"
#include "sim_core/rod/rod_tables.h"

namespace fulcrum {

/// A trial shape. Segment arrays are shifted by one: entries 0 and n + 1 are the end frames; padded for loads
/// of four.
struct RodShape {
    std::vector<double>
        position;  ///< 4 per node: x, y, z and the twist angle of segment i since the step's start
    std::vector<double> tx, ty, tz;  ///< unit tangents
    std::vector<double> dx, dy, dz;  ///< directors d1
    std::vector<double> inverse;     ///< 1 / edge length, 1/m; 0 at the end frames, which are prescribed
    std::vector<double> length;      ///< m
    std::vector<double> twist;       ///< per joint, rad, unwrapped

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(position, tx, ty, tz, dx, dy, dz, inverse, length, twist);
    }
    void resize(int segments);
    std::size_t bytes() const;
};

/// Output of the joints: second derivatives and gradients in edge variables (edge vector, twist angle), by
/// joint.
struct RodJointTerms {
    std::vector<double> gradient_a, gradient_b;  ///< 4 per joint
    std::vector<Block4> aa, bb, ab;              ///< ab: rows a, columns b
    std::vector<double> energy;                  ///< by joint, J; filled by unit_joint_terms only
    double bend = 0, twist = 0;                  ///< J

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(gradient_a, gradient_b, aa, bb, ab, energy, bend, twist);
    }

    void resize(int segments);
    std::size_t bytes() const;
};

/// Returns false if a joint is folded back on itself (1 + c below 1e-9), where the energy is unbounded.
bool joint_terms(const Rod::Tables& tables, const RodShape& shape, bool hessian, RodJointTerms& out);

/// As joint_terms, with the given bending stiffness of each joint (N m, padded) instead of that of the
/// tables.
bool joint_terms(const Rod::Tables& tables, const RodShape& shape, const std::vector<double>& bend,
                 bool hessian, RodJointTerms& out);

/// Bending energy and its gradient per joint for stiffness 1 and no twist: half the squared turning.
bool unit_joint_terms(const Rod::Tables& tables, const RodShape& shape, RodJointTerms& out);

}  // namespace fulcrum
