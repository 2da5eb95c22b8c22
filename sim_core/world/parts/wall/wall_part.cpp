// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/wall/wall_part.h"

#include "sim_core/anatomy/scene_anatomy.h"

namespace fulcrum {

std::unique_ptr<Part> build_wall_part(const Scene& scene, std::uint64_t /*seed*/, const PartList& /*parts*/) {
    if (scene.presacral) {
        return std::make_unique<WallPart>(make_presacral_wall(rectum_parameters(scene)), FreeSide::front);
    }
    if (scene.cavity) return std::make_unique<WallPart>(cavity_mesh(*scene.cavity), FreeSide::behind);
    return nullptr;
}

void WallPart::add_costs(double us, std::vector<PartCost>& costs) const {
    costs.push_back({"cavity", us, model_.bytes()});
}

}  // namespace fulcrum
