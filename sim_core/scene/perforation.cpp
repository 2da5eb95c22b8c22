// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/perforation.h"

#include <algorithm>

#include "sim_core/numerics/random.h"

namespace fulcrum {

std::vector<double> draw_perforation_forces(const Scene& scene, std::uint64_t seed) {
    constexpr std::uint64_t stream = 0x70657266;  // of the attempt's seed
    constexpr double least_share =
        0.3;  // of the median; the lower tail of the normal distribution would reach zero
    Random random(seed, stream);
    std::vector<double> forces;
    for (const TissueSpec& tissue : scene.tissues) {
        const double deviate =
            random.normal();  // drawn for every tissue, so that an added limit does not change the others
        const double drawn = tissue.perforation_force + deviate * tissue.perforation_spread;
        forces.push_back(
            tissue.perforation_force > 0 ? std::max(drawn, least_share * tissue.perforation_force) : 0.0);
    }
    return forces;
}

}  // namespace fulcrum
