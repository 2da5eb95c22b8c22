// SPDX-License-Identifier: Apache-2.0
// The perforation force of each tissue in one attempt, drawn from the published distribution.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sim_core/scene/scene.h"

namespace fulcrum {

/// One value per tissue of the scene, N; 0 if the tissue has no perforation force. Depends only on the seed,
/// not on the other tissues' values. Never below 0.3 of the median.
std::vector<double> draw_perforation_forces(const Scene& scene, std::uint64_t seed);

/// m2: what two hemispheres of 1.5 mm diameter pinch at most, on both sides; perforation forces were measured
/// with them (Heijnsdijk et al. 2003).
inline constexpr double pinched_area = 2 * 3.14159265358979 * 0.00075 * 0.00075;

/// The force between those hemispheres that presses as much as jaws that close with `jaw_force` on an area
/// (m2, both faces); in the unit of jaw_force. 0 where the area is not known.
inline double pinch_force(double jaw_force, double area) {
    return area > 0 ? jaw_force * pinched_area / std::max(area, pinched_area) : 0.0;
}

}  // namespace fulcrum
