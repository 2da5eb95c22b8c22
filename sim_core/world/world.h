// SPDX-License-Identifier: Apache-2.0
// The world of one attempt: the parts that a scene lists, stepped together (part.h), and what they show.
//
// World thread. step() neither allocates, locks nor throws. A part that the scene does not list is not in
// memory.
#pragma once

#include <atomic>
#include <memory>
#include <type_traits>
#include <vector>

#include "sim_core/contact/local_model.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/instrument/tick_output.h"
#include "sim_core/scene/scene.h"
#include "sim_core/telemetry/sample.h"
#include "sim_core/world/part/part.h"
#include "sim_core/world/part/snapshot.h"

namespace fulcrum {

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
    /// The wall that instruments feel, null without. Constant: any thread may read it.
    const CavityModel* wall() const noexcept { return wall_; }

    /// The part or coupling of a type, null where the scene does not list it. For the laboratory and tests.
    template <typename Kind>
    Kind* find() noexcept {
        if constexpr (std::is_base_of_v<Coupling, Kind>) {
            for (const std::unique_ptr<Coupling>& coupling : couplings_) {
                if (auto* found = dynamic_cast<Kind*>(coupling.get())) return found;
            }
            return nullptr;
        } else {
            return find_part<Kind>(parts_);
        }
    }
    template <typename Kind>
    const Kind* find() const noexcept {
        return const_cast<World*>(this)->find<Kind>();
    }

    /// All that changes from step to step: saved in mid-attempt, a world of the same scene and seed resumes
    /// from it bit for bit with the same tick outputs. Not for the real-time path.
    struct Saved;
    std::shared_ptr<const Saved> save() const;
    void restore(const Saved& saved);
    /// The same as bytes (key frames): for a world of the same scene and seed in the same build. Reading
    /// throws StateArchiveError; what was read until then stays.
    void transfer(StateArchive& archive);
    /// Hash of all parts now.
    std::uint64_t hash() const noexcept;

    /// Models that were read from bytes: their pointer to a layered wall is this world's.
    void point_to_wall(LocalModels& models) const noexcept;

    void measure(bool on);
    std::vector<PartCost> costs() const;
    /// For tests: each step that advances while this is true ends as a simulator fault. It must outlive this.
    void fail_while(const std::atomic<bool>* asked) noexcept { fails_ = asked; }

  private:
    /// A part and its coupling to what it hangs on, in the order of solving.
    struct Solved {
        Part* part = nullptr;
        Coupling* coupling = nullptr;  ///< null: it hangs on nothing
        double us = 0;                 ///< of apply and solve in the last step
    };
    void order_solving();
    void begin_input(const TickOutput* outputs, std::size_t count) noexcept;
    void decide_takers() noexcept;
    std::uint32_t advance() noexcept;
    void fill_models(const TickOutput& last) noexcept;
    void fill_snapshot(const TickOutput& last) noexcept;
    void show_grasp(std::size_t hand) noexcept;
    void show_lift(std::size_t hand, TouchList touches) noexcept;

    Scene scene_;
    PartList parts_;  ///< in the order of building, publishing and hashing
    std::vector<std::unique_ptr<Coupling>> couplings_;
    std::vector<Solved> solving_;
    const CavityModel* wall_ = nullptr;
    bool has_instrument_[hand_count] = {false, false};
    std::unique_ptr<ScopeModel> scope_;
    std::size_t last_holder_[hand_count] = {};  ///< in parts_; means something once a hold was shown
    StepInput input_;
    LocalModels models_;
    WorldSnapshot snapshot_;
    std::uint32_t steps_ = 0;
    std::uint32_t next_hash_tick_ = hash_every_ticks;
    bool measuring_ = false;
    const std::atomic<bool>* fails_ = nullptr;  ///< null: no test asks
    double models_us_ = 0, snapshot_us_ = 0;
};

}  // namespace fulcrum
