// SPDX-License-Identifier: Apache-2.0
// Newton's method on the rod's merit function, safeguarded by a shift of the matrix, a bound on the turn of
// any segment and a line search. Prescribed motions and multipliers enter the linear systems.
#pragma once

#include "sim_core/rod/rod_system.h"

namespace fulcrum {

struct NewtonResult {
    bool converged = false;
    bool finite = true;
    bool positive_definite = false;  ///< the last system needed no shift
    int iterations = 0;
    double residual = 0;        ///< relative
    double force_residual = 0;  ///< N
};

/// Starts from data.shape and stores the result there. `full_steps`: no line search (linearised).
NewtonResult newton(const Rod::Tables& tables, RodInputs& inputs, RodScratch::Data& data, int limit,
                    double tolerance, double constraint_tolerance, bool full_steps);

}  // namespace fulcrum
