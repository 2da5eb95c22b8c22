// SPDX-License-Identifier: Apache-2.0
// The force at which a tissue gives way in one attempt: drawn from the published distribution, not one limit.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/scene/scene.h"

namespace fulcrum {

/// One draw a tissue of the scene, N; 0 where the tissue has no perforation force. The same for the same
/// seed, whatever the other tissues' values are. Never below 0.3 of the median.
std::vector<double> draw_perforation_forces(const Scene& scene, std::uint64_t seed);

}  // namespace fulcrum
