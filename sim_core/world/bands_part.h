// SPDX-License-Identifier: Apache-2.0
// Bands, vessels, nerve and the instruments that divide, stop and suck, as a part of the world (task B3).
// World thread. Nothing allocates after construction.
//
// A step: instruments (exchange, jaws, pedal), strands, tearing, heat, parting and sealing, bleeding, the
// pool, smoke, what is seen.
#pragma once

#include <array>
#include <vector>

#include "sim_core/bleeding/pool.h"
#include "sim_core/bleeding/vessel.h"
#include "sim_core/contact/local_model.h"
#include "sim_core/energy/energy_tool.h"
#include "sim_core/energy/heat.h"
#include "sim_core/haptics/tick_output.h"
#include "sim_core/scene/scene.h"
#include "sim_core/strand/strand.h"
#include "sim_core/world/bands_layout.h"
#include "sim_core/world/bands_view.h"
#include "sim_core/world/snapshot.h"
#include "sim_core/world/state_hash.h"

namespace fulcrum {

class BandsPart {
  public:
    /// The scene lists bands.
    BandsPart(const Scene& scene, std::uint64_t seed);

    /// One step of dt over the outputs of `count` ticks (at least one), oldest first. Returns
    /// StepRecord::outcome.
    std::uint32_t step(const TickOutput* outputs, std::size_t count, double dt) noexcept;
    /// What a hand holds for the tick, and whether its pedal gives energy.
    void fill_local_model(Hand hand, LocalModel& model) const noexcept;
    void size_snapshot(WorldSnapshot& snapshot) const;
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept;
    void hash(StateHash& hash) const noexcept;
    std::size_t bytes() const;

    const BandsLayout& layout() const { return layout_; }
    const HeatState& heat() const { return heat_state_; }
    const HeatModel& heat_model() const { return heat_.model; }
    const PoolState& pool() const { return pool_; }
    const StrandState& strand(std::size_t band) const { return strands_[band]; }
    const BleedState& outlet(std::size_t index) const { return outlets_[index].bleed; }

  private:
    struct Outlet {
        BleedState bleed;
        std::int32_t band = 0, vessel = 0;
        bool trunk = false, opened = false, injured = false;
    };
    struct HandTool {
        const InstrumentSpec* instrument = nullptr;
        std::array<ToolKind, 6> kinds{};
        int kind_count = 1, index = 0;
        double exchange_left = 0;   ///< s
        std::uint16_t buttons = 0;  ///< of the last tick
        bool ready = true;          ///< the jaws were open since they last closed
        bool active = false;
        EnergyTarget target = EnergyTarget::nothing;
        double nerve_distance = 1;  ///< m
        std::int32_t touched_band = -1;
        std::int32_t clips_fired = 0, last_clip_outlet = -1;
        double last_clip_distance = 0;  ///< m
        // What the jaws hold.
        std::int32_t band = -1;
        StrandHold hold;
        Vector3 correction = Vector3::Zero(), target_velocity = Vector3::Zero(),
                hold_offset = Vector3::Zero();
        double slip_time = 0;  ///< s
        bool slipped = false;
        // Energy.
        BladeState blade;
        std::array<std::int32_t, 16> touched{};  ///< heat patches that the blade touches
        int touched_count = 0;
        ToolKind kind() const { return kinds[static_cast<std::size_t>(index)]; }
        bool usable() const { return exchange_left <= 0; }
    };

    void step_tool(HandTool& hand, const TickOutput* outputs, std::size_t count, int number,
                   double dt) noexcept;
    void exchange(HandTool& hand, const TickOutput* outputs, std::size_t count, int number,
                  double dt) noexcept;
    void step_jaws(HandTool& hand, const ToolKinematics& tool, double dt) noexcept;
    void fire_clip(HandTool& hand, const ToolKinematics& tool) noexcept;
    void apply_energy(HandTool& hand, const ToolKinematics& tool, double duty) noexcept;
    void touch_with_blade(HandTool& hand, const ToolKinematics& tool) noexcept;
    void step_strands(double dt) noexcept;
    void part_heated(double dt) noexcept;
    void part(std::size_t band, int segment, bool torn) noexcept;
    void bleed(double dt) noexcept;
    Vector3 outlet_position(const Outlet& outlet) const noexcept;
    std::size_t segment_patch(std::size_t band, int segment) const {
        return band * static_cast<std::size_t>(strand_segments) + static_cast<std::size_t>(segment);
    }
    std::size_t outlet_patch(const Outlet& outlet) const noexcept;
    double temperature(std::size_t patch) const {
        return heat_.model.body_temperature + heat_state_.rise[patch];
    }

    BandsSpec spec_;
    BandsLayout layout_;
    StrandModel strand_model_;
    EnergyToolModel shears_ = harmonic_shears(), hook_ = monopolar_hook();
    VesselModel vessel_;
    SmokeModel smoke_model_;
    BandsHeat heat_;
    TissueSpec tissue_;
    std::int16_t tissue_index_ = -1;

    std::vector<StrandState> strands_;
    std::vector<double> overload_time_;     ///< s, by band
    std::vector<std::uint8_t> torn_;        ///< by band
    std::vector<std::int32_t> clip_nodes_;  ///< by band, -1 none
    std::vector<double> progress_;          ///< of parting, by segment patch
    std::vector<double> sealed_;            ///< of a vessel there, by segment patch
    std::vector<double> parted_tension_;    ///< N, by band
    std::vector<std::int32_t> parted_at_;   ///< first parted segment by band, -1 none
    std::vector<Outlet> outlets_;
    HeatState heat_state_;
    HeatInputs heat_inputs_;
    HeatScratch heat_scratch_;
    PoolState pool_;
    SmokeState smoke_;
    HandTool hands_[hand_count];
    bool suction_ = false;
    std::int32_t clips_left_ = 0;
};

}  // namespace fulcrum
