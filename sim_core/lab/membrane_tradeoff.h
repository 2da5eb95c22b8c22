// SPDX-License-Identifier: Apache-2.0
// What each integrator of the membrane costs and how far it is from the reference; where each stays bounded.
#pragma once

#include <vector>

#include "sim_core/lab/stability.h"
#include "sim_core/lab/tradeoff.h"

namespace fulcrum::lab {

/// Integrators and iterations against implicit Euler by Newton to 1e-10 (energy of a frame), and resolution
/// against a 4 times finer sheet (sag).
std::vector<TradeoffStudy> membrane_tradeoff();

/// Symplectic Euler: time step against slivers up to aspect 1e6, its limit drawn in.
StabilityMap membrane_sliver_map();

/// Time step against stiffness for each integrator, the symplectic limit drawn in; and the sliver map.
std::vector<StabilityMap> membrane_stability();

}  // namespace fulcrum::lab
