// SPDX-License-Identifier: Apache-2.0
// Cost and error of each membrane integrator compared with the reference, and the stability range of each.
#pragma once

#include <vector>

#include "sim_core/lab/stability.h"
#include "sim_core/lab/tradeoff.h"

namespace fulcrum::lab {

/// Integrators and iterations against implicit Euler by Newton to 1e-10 (energy of a frame), and resolution
/// against a 4 times finer sheet (sag).
std::vector<TradeoffStudy> membrane_tradeoff();

/// Symplectic Euler: time step against slivers up to aspect 1e6, with the theoretical limit.
StabilityMap membrane_sliver_map();

/// Time step against stiffness for each integrator, with the symplectic limit; and the sliver map.
std::vector<StabilityMap> membrane_stability();

}  // namespace fulcrum::lab
