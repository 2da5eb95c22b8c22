// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/bowel/bowel_part.h"

#include <array>
#include <optional>

namespace fulcrum {

struct BowelPart::Saved {
    RodState state;
    RodInputs inputs;
    RodScratch scratch;  // the last factor is the stiffness that the next loads meet
    RodReport report;
    SphereCollision::Lists lists;
    SphereContacts contacts;
    std::vector<RingMotion> rings;
    std::vector<RingFrame> ring_frames;
    std::vector<double> ring_stretch;
    std::optional<LuminalVolume> lumen;
    std::array<HandGrasp, hand_count> grasps;
    std::array<SheetGrasp, hand_count> sheet_grasps;
    std::array<Vector3, hand_count> applied_push;
    std::array<std::vector<Vector3>, hand_count> jaw_pushes;
    std::array<JawPushModel, hand_count> jaw_felt;
    DentState dents;
    std::vector<float> patch_damage;
    std::vector<double> remembered_lambda;
    std::vector<Vector3> remembered_normal;
    std::uint32_t frozen_steps = 0;
    std::optional<BowelCut::State> cut;
};

std::shared_ptr<const BowelPart::Saved> BowelPart::save() const {
    if (!membranes_.empty()) return nullptr;
    auto saved = std::make_shared<Saved>();
    saved->state = state_;
    saved->inputs = inputs_;
    saved->scratch = scratch_;
    saved->report = report_;
    saved->lists = lists_;
    saved->contacts = contacts_;
    saved->rings = rings_;
    saved->ring_frames = ring_frames_;
    saved->ring_stretch = ring_stretch_;
    if (lumen_) saved->lumen = *lumen_;
    for (std::size_t h = 0; h < hand_count; ++h) {
        saved->grasps[h] = grasps_[h];
        saved->sheet_grasps[h] = sheet_grasps_[h];
        saved->applied_push[h] = applied_push_[h];
        saved->jaw_pushes[h] = jaw_pushes_[h];
        saved->jaw_felt[h] = jaw_felt_[h];
    }
    saved->dents = dents_;
    saved->patch_damage = patch_damage_;
    saved->remembered_lambda = remembered_lambda_;
    saved->remembered_normal = remembered_normal_;
    saved->frozen_steps = frozen_steps_;
    if (cut_) saved->cut = cut_->save();
    return saved;
}

void BowelPart::restore(const Saved& saved) {
    state_ = saved.state;
    inputs_ = saved.inputs;
    scratch_ = saved.scratch;
    report_ = saved.report;
    lists_ = saved.lists;
    contacts_ = saved.contacts;
    rings_ = saved.rings;
    ring_frames_ = saved.ring_frames;
    ring_stretch_ = saved.ring_stretch;
    if (saved.lumen) *lumen_ = *saved.lumen;
    for (std::size_t h = 0; h < hand_count; ++h) {
        grasps_[h] = saved.grasps[h];
        sheet_grasps_[h] = saved.sheet_grasps[h];
        applied_push_[h] = saved.applied_push[h];
        jaw_pushes_[h] = saved.jaw_pushes[h];
        jaw_felt_[h] = saved.jaw_felt[h];
    }
    dents_ = saved.dents;
    patch_damage_ = saved.patch_damage;
    remembered_lambda_ = saved.remembered_lambda;
    remembered_normal_ = saved.remembered_normal;
    frozen_steps_ = saved.frozen_steps;
    if (saved.cut) cut_->restore(*saved.cut);
}

}  // namespace fulcrum
