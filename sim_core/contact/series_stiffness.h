// SPDX-License-Identifier: Apache-2.0
// Two springs behind each other: the tissue under a tool yields in its own wall and as a whole.
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// Stiffness (N/m) of `tissue` in series with an isotropic spring `wall` > 0 N/m: symmetric, its eigenvalues
/// in [0, wall] whatever comes in. Where the tissue's own tangent has a negative eigenvalue (a solve that did
/// not converge stands on no minimum) the direction counts as free; what is not finite counts as rigid, so
/// that the wall alone answers. Any thread, no allocation, no exception.
Matrix3 stiffness_in_series(const Matrix3& tissue, double wall);

}  // namespace fulcrum
