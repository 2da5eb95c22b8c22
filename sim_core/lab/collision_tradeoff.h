// SPDX-License-Identifier: Apache-2.0
// Cost and residual overlap of the collision levels: projections per step and list margin, coherent or listed
// again.
#pragma once

#include <vector>

#include "sim_core/lab/tradeoff.h"

namespace fulcrum::lab {

/// One study: the reference chain pushed by 1 mm into wall and neighbours; error: deepest overlap after
/// projection, mean over frames. "coherent" and "brute" are the names in a scene's fidelity
/// (fidelity.collision, fidelity.projection_iterations); both have the same result and differ in time.
std::vector<TradeoffStudy> collision_tradeoff();

}  // namespace fulcrum::lab
