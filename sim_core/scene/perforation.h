// SPDX-License-Identifier: Apache-2.0
// The perforation force of each tissue in one attempt, drawn from the published distribution.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/scene/scene.h"

namespace fulcrum {

/// One value per tissue of the scene, N; 0 if the tissue has no perforation force. Depends only on the seed,
/// not on the other tissues' values. Never below 0.3 of the median.
std::vector<double> draw_perforation_forces(const Scene& scene, std::uint64_t seed);

}  // namespace fulcrum
