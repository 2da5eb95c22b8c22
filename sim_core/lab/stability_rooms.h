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
/// Force at the hand through the lever: insertion from 5 to 95 % and stiffness; the wall as the model is, and
/// each tissue as it is sent.
std::vector<StabilityMap> lever_stability();

}  // namespace fulcrum::lab
