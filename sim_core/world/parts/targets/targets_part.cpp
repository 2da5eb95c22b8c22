// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/targets/targets_part.h"

#include <algorithm>
#include <string>

#include "sim_core/numerics/input_error.h"
#include "sim_core/rigid/targets.h"

namespace fulcrum {

TargetsPart::TargetsPart(const Scene& scene, std::uint64_t seed)
    : spheres_(place_targets(*scene.targets, seed)) {
    const auto tissue = static_cast<std::int16_t>(scene.tissue_index(scene.targets->tissue));
    for (const TargetSphere& sphere : spheres_) {
        TargetModel target;
        target.centre = sphere.centre;
        target.radius = sphere.radius;
        target.stiffness = scene.targets->stiffness;
        target.damping = scene.targets->damping;
        target.id = static_cast<std::int32_t>(models_.size());
        target.tissue = tissue;
        models_.push_back(target);
    }
    if (models_.size() > target_capacity) {
        throw InputError(scene.id, "/targets/per_hand",
                         QT_TRANSLATE_NOOP("errors", "more targets than the local model holds"),
                         {QT_TRANSLATE_NOOP("errors", "use at most %1"), target_capacity / 2});
    }
}

void TargetsPart::publish_model(int /*hand*/, const TickOutput& /*last*/, LocalModel& model) noexcept {
    model.target_count = static_cast<std::int32_t>(models_.size());
    std::copy(models_.begin(), models_.end(), model.targets.begin());
}

void TargetsPart::size_snapshot(WorldSnapshot& snapshot) const {
    snapshot.targets = spheres_;
}

void TargetsPart::add_costs(double us, std::vector<PartCost>& costs) const {
    costs.push_back({"targets", us, models_.capacity() * sizeof(TargetModel)});
}

std::unique_ptr<Part> build_targets_part(const Scene& scene, std::uint64_t seed, const PartList& /*parts*/) {
    return scene.targets ? std::make_unique<TargetsPart>(scene, seed) : nullptr;
}

}  // namespace fulcrum
