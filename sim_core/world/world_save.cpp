// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <optional>

#include "sim_core/world/world.h"

namespace fulcrum {

struct World::Saved {
    std::shared_ptr<const BowelPart::Saved> bowel;
    std::optional<SheetPart::State> sheet;
    std::optional<CutState> surface;
    std::optional<BandsPart> bands;
    std::optional<StructuresPart::Saved> structures;
    LocalModels models;
    std::array<ToolContactState, hand_count> contacts;
    WorldSnapshot snapshot;
    std::uint32_t steps = 0, next_hash_tick = 0;
};

std::shared_ptr<const World::Saved> World::save() const {
    auto saved = std::make_shared<Saved>();
    if (bowel_) {
        saved->bowel = bowel_->save();
        if (!saved->bowel) return nullptr;
    }
    if (sheet_) {
        saved->sheet = sheet_->state();
        saved->surface = sheet_->surface().state();
    }
    if (bands_) saved->bands = *bands_;
    if (structures_) saved->structures = structures_->save();
    saved->models = models_;
    for (std::size_t h = 0; contacts_ && h < hand_count; ++h) saved->contacts[h] = contacts_->state[h];
    saved->snapshot = snapshot_;
    saved->steps = steps_;
    saved->next_hash_tick = next_hash_tick_;
    return saved;
}

void World::restore(const Saved& saved) {
    if (bowel_) bowel_->restore(*saved.bowel);
    if (sheet_) sheet_->restore(*saved.sheet, *saved.surface);
    if (bands_) *bands_ = *saved.bands;
    if (structures_) structures_->restore(*saved.structures);
    models_ = saved.models;
    for (std::size_t h = 0; contacts_ && h < hand_count; ++h) contacts_->state[h] = saved.contacts[h];
    snapshot_ = saved.snapshot;
    steps_ = saved.steps;
    next_hash_tick_ = saved.next_hash_tick;
}

}  // namespace fulcrum
