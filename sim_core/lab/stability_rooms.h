// SPDX-License-Identifier: Apache-2.0
// The maps of each room; declare a new room here and list it in stability.cpp.
#pragma once

#include <vector>

#include "sim_core/lab/stability.h"

namespace fulcrum::lab {

/// Rod in implicit Euler steps: time step and stiffness, slenderness and segments, force and time step.
std::vector<StabilityMap> rod_stability();
/// Surface on its cage: slivers and bend.
std::vector<StabilityMap> skin_stability();

}  // namespace fulcrum::lab
