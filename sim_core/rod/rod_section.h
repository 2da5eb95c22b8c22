// SPDX-License-Identifier: Apache-2.0
// The rod's elastic energy under EXP2: the section's response (material/section.h) at every joint and
// segment.
//
// A segment of strain e has the axial part, length w(e, 0); a joint of cell c has the bending part c (w(em,
// k) - w(em, 0)), em the strain of the two segments beside it together, k^2 = 2 u / c^2 with u half the
// squared turn that the linear law takes too (so frame invariance, natural curvature and folding stay as they
// are). With no exponent left it is the linear rod.
#pragma once

#include <vector>

#include "sim_core/rod/rod_kernel.h"

namespace fulcrum {

/// Work space of section_terms, and what it says of the segments.
struct RodSectionTerms {
    RodJointTerms unit;                     ///< half the squared turn by joint, and its gradient
    std::vector<BendingResponse> response;  ///< per joint
    std::vector<double> bend;               ///< per joint: stiffness at this shape, N m
    std::vector<double> force;              ///< per segment, N, axial part
    std::vector<double> tangent;            ///< per segment, N/m
    double stretch = 0;                     ///< J

    void resize(int segments);
    std::size_t bytes() const;
};

/// Gradient and second derivative in edge variables as joint_terms gives them, coupling included. False where
/// a joint is folded or an energy is not finite.
bool section_terms(const Rod::Tables& tables, const RodShape& shape, bool hessian, RodSectionTerms& work,
                   RodJointTerms& out);

}  // namespace fulcrum
