// SPDX-License-Identifier: Apache-2.0
// Row `skinning` of `fulcrum lab tradeoff` (docs/THEORY.md, section 8).
#pragma once

#include "sim_core/lab/tradeoff.h"

namespace fulcrum::lab {

/// Levels local, local2 and global at three spacings of the cage's spheres, in a quarter bend of three tube
/// radii. Two errors, compared separately: mean deviation of the vertices from global coordinates, and change
/// of the enclosed volume.
TradeoffStudy skinning_tradeoff();

}  // namespace fulcrum::lab
