// SPDX-License-Identifier: Apache-2.0
// Two springs in series: the tissue under a tool yields in its own wall and as a whole.
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// Stiffness (N/m) of `tissue` in series with an isotropic spring `wall` > 0 N/m: symmetric, eigenvalues in
/// [0, wall] for every input. A negative eigenvalue of the tissue's tangent (a solve that did not converge is
/// not at a minimum) counts as a free direction; non-finite values count as rigid, so that only the wall
/// yields. Any thread, no allocation, no exception.
Matrix3 stiffness_in_series(const Matrix3& tissue, double wall);

}  // namespace fulcrum
