// SPDX-License-Identifier: Apache-2.0
// A rigid sphere that one hand has to touch (A2), patient frame.
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

struct TargetSphere {
    Vector3 centre = Vector3::Zero();  ///< m
    double radius = 0;                 ///< m
    Hand hand = Hand::left;
};

}  // namespace fulcrum
