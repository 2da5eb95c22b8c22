// SPDX-License-Identifier: Apache-2.0
// The world of one attempt: the parts a scene lists, stepped together, and what they show to the others.
//
// World thread. step() neither allocates, locks nor throws. A part that the scene does not list is not in
// memory.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim_core/collision/cavity.h"
#include "sim_core/contact/local_model.h"
#include "sim_core/contact/tool_contact.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/instrument/tick_output.h"
#include "sim_core/scene/scene.h"
#include "sim_core/telemetry/sample.h"
#include "sim_core/world/parts/bands/bands_part.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/parts/sheet/sheet_part.h"
#include "sim_core/world/parts/structures/structures_part.h"
#include "sim_core/world/snapshot.h"

namespace fulcrum {

/// What one part costs: `fulcrum lab cost`.
struct PartCost {
    std::string part;
    double us_per_step = 0;  ///< of the last step, measured only after measure(true)
    std::size_t bytes = 0;
};

class World {
  public:
    static constexpr std::uint32_t hash_every_ticks = 100;

    /// Builds what the scene lists; the seed draws the variant. Throws InputError.
    World(const Scene& scene, std::uint64_t seed);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// One step of Scene::step_period() over the outputs of `count` ticks (at least one), oldest first. A
    /// step over a paused tick advances nothing.
    StepRecord step(const TickOutput* outputs, std::size_t count) noexcept;

    const WorldSnapshot& snapshot() const noexcept { return snapshot_; }
    const LocalModels& local_models() const noexcept { return models_; }
    const Scene& scene() const noexcept { return scene_; }

    /// Parts, null where the scene does not list them. Their constant data may be read by any thread.
    const BowelPart* bowel() const noexcept { return bowel_.get(); }
    BowelPart* bowel() noexcept { return bowel_.get(); }
    const SheetPart* sheet() const noexcept { return sheet_.get(); }
    SheetPart* sheet() noexcept { return sheet_.get(); }
    const BandsPart* bands() const noexcept { return bands_.get(); }
    const StructuresPart* structures() const noexcept { return structures_.get(); }
    const CavityModel* cavity() const noexcept { return cavity_.get(); }

    /// All that changes from step to step: saved in mid-attempt, a world of the same scene and seed goes on
    /// from it bit for bit with the same tick outputs. Null where the scene lists `membranes`, whose solver
    /// remembers more than their state. Not for the real-time path.
    struct Saved;
    std::shared_ptr<const Saved> save() const;
    void restore(const Saved& saved);

    void measure(bool on);
    std::vector<PartCost> costs() const;

  private:
    /// The instruments against the surface as the world sees it: the tick's own law, at the end of the step
    /// that is being made. The force that moves the bowel must not be the tick's: that one was made for a
    /// surface up to ten ticks old, and would throw a light bowel to and fro under a tool that does not move.
    struct HandContacts {
        ToolContactModel model[hand_count];
        ToolContactState state[hand_count];
        ToolContactScratch scratch[hand_count];
        ToolContactResult result[hand_count];
    };
    void build_anatomy(std::uint64_t seed);
    void hang_septa();
    HeldTool held(int hand, const TickOutput& last) const noexcept;
    void find_contacts(const TickOutput& last, ToolAction* actions) noexcept;
    void fill_models(const TickOutput& last) noexcept;
    void fill_snapshot(const TickOutput& last) noexcept;
    std::uint64_t hash() const noexcept;

    Scene scene_;
    std::unique_ptr<CavityModel> cavity_;
    std::unique_ptr<BowelPart> bowel_;
    std::unique_ptr<SheetPart> sheet_;
    std::unique_ptr<BandsPart> bands_;
    std::unique_ptr<StructuresPart> structures_;
    std::vector<TargetModel> targets_;
    InstrumentModel instruments_[hand_count];
    bool has_instrument_[hand_count] = {false, false};
    std::unique_ptr<ScopeModel> scope_;
    LocalModels models_;
    std::unique_ptr<HandContacts> contacts_;  ///< with a bowel
    WorldSnapshot snapshot_;
    std::uint32_t steps_ = 0;
    std::uint32_t next_hash_tick_ = hash_every_ticks;
    bool measuring_ = false;
    double models_us_ = 0, snapshot_us_ = 0, sheet_us_ = 0, bands_us_ = 0, structures_us_ = 0;
};

}  // namespace fulcrum
