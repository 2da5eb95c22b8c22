// SPDX-License-Identifier: Apache-2.0
// What the levels of collision cost and what they leave: projections a step and list margin, coherent or
// listed anew.
#pragma once

#include <vector>

#include "sim_core/lab/tradeoff.h"

namespace fulcrum::lab {

/// One study: the reference chain brought out of a push of 1 mm into wall and neighbours; error: the deepest
/// overlap left after projection, mean over frames. "coherent" and "brute" are the names that a scene's
/// fidelity uses (fidelity.collision, fidelity.projection_iterations); they leave the same and differ in
/// time.
std::vector<TradeoffStudy> collision_tradeoff();

}  // namespace fulcrum::lab
