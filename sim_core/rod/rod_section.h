// SPDX-License-Identifier: Apache-2.0
// Elastic energy of the rod under EXP2: the section's response (material/section.h) at every joint and
// segment.
//
// A segment of strain e has the axial part, length w(e, 0). A joint of cell c has the bending part c (w(em,
// k)
// - w(em, 0)), with em the mean strain of the two adjacent segments and k^2 = 2 u / c^2, u half the squared
// turning of the linear law (so frame invariance, natural curvature and folding are unchanged). With exponent
// 0 it reduces to the linear rod.
#pragma once

#include <vector>

#include "sim_core/rod/rod_kernel.h"

namespace fulcrum {

/// Work space of section_terms and its results per segment.
struct RodSectionTerms {
    RodJointTerms unit;                     ///< half the squared turn by joint, and its gradient
    std::vector<BendingResponse> response;  ///< per joint
    std::vector<double> bend;               ///< per joint: stiffness at this shape, N m
    std::vector<double> force;              ///< per segment, N, axial part
    std::vector<double> tangent;            ///< per segment, N/m
    double stretch = 0;                     ///< J

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(unit, response, bend, force, tangent, stretch);
    }

    void resize(int segments);
    std::size_t bytes() const;
};

/// Gradient and second derivative in edge variables as joint_terms gives them, coupling included. Returns
/// false if a joint is folded or an energy is not finite.
bool section_terms(const Rod::Tables& tables, const RodShape& shape, bool hessian, RodSectionTerms& work,
                   RodJointTerms& out);

}  // namespace fulcrum
