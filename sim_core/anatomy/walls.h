// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim_core/anatomy/anatomy.h"

namespace fulcrum {

/// Height z of the posterior wall under (x, y), as make_cavity shapes it.
double posterior_wall(const PelvisParameters& pelvis, double x, double y);

}  // namespace fulcrum
