// SPDX-License-Identifier: Apache-2.0
// What a bowel saves, hashes and costs.
#include "sim_core/world/parts/bowel/bowel_part.h"

namespace fulcrum {

void BowelPart::list_state(StateList& list) {
    list.hashed(state_.nodes).hashed(state_.directors).hashed(state_.joint_twist).hashed(state_.velocities);
    list.kept(state_.spins).kept(state_.ends);
    list.hashed(grasps_, [this](StateHash& hash) {
        for (const HandGrasp& grasp : grasps_) {
            hash.add(static_cast<std::int64_t>(grasp.state.held));
            hash.add(grasp.state.arc_length);
            hash.add(grasp.state.offset);
            hash.add(grasp.state.reaction);
        }
    });
    list.hashed(dents_, [this](StateHash& hash) {
        for (int i = 0; i < dents_.count; ++i) {
            hash.add(static_cast<std::int64_t>(dents_.entries[static_cast<std::size_t>(i)].vertex));
            hash.add(dents_.entries[static_cast<std::size_t>(i)].displacement);
        }
    });
    for (std::vector<Vector3>& pushes : jaw_pushes_) list.hashed(pushes);  // empty but at the level "jaws"
    list.kept(jaw_felt_).kept(applied_push_);
    list.hashed(patch_damage_);
    if (cut_) cut_->list_state(list);
    if (lumen_) list.kept(*lumen_);
    // The next step's loads meet the stiffness of the last factor, which is in the rod's scratch.
    list.kept(inputs_).kept(scratch_).kept(report_);
    list.kept(lists_).kept(contacts_).kept(remembered_lambda_).kept(remembered_normal_);
    list.kept(rings_).kept(ring_frames_).kept(ring_stretch_);
    list.kept(frozen_steps_);
    for (Touch& touch : touches_) list.kept(touch.state);
}

void BowelPart::add_costs(double /*us*/, std::vector<PartCost>& costs) const {
    costs.push_back({"rod", costs_.rod + costs_.grasps + costs_.loads, bytes_rod()});
    costs.push_back({"collision", costs_.collision, bytes_collision()});
    costs.push_back({"cage_and_surface", costs_.rings + costs_.dents, bytes_surface()});
    if (scene_.tethers)
        costs.push_back({"tethers", 0, sizeof(RodTether) * static_cast<std::size_t>(scene_.tethers->count)});
}

std::size_t BowelPart::bytes_rod() const {
    return rod_->bytes() + scratch_.bytes();
}
std::size_t BowelPart::bytes_collision() const {
    return collision_->bytes();
}
std::size_t BowelPart::bytes_surface() const {
    return skin_->bytes() + (wide_skin_ ? wide_skin_->bytes() : 0) + (cut_ ? cut_->bytes() : 0) +
           surface_.capacity() * sizeof(Vector3) + rings_.capacity() * sizeof(RingMotion);
}

}  // namespace fulcrum
