// SPDX-License-Identifier: Apache-2.0
// Bands, vessels, nerve and the instruments that divide, stop and suck, as a part of the world (task B3).
// World thread. Nothing allocates after construction.
//
// A step: instruments are exchanged; bands are offered to jaws that close; jaws, clips and pedals; strands,
// tearing, heat, parting and sealing, bleeding, the pool, smoke; what is seen.
#pragma once

#include <array>
#include <vector>

#include "sim_core/contact/local_model.h"
#include "sim_core/instrument/tick_output.h"
#include "sim_core/numerics/state_hash.h"
#include "sim_core/scene/scene.h"
#include "sim_core/strand/strand.h"
#include "sim_core/world/field/operative_field.h"
#include "sim_core/world/part/part.h"
#include "sim_core/world/part/snapshot.h"
#include "sim_core/world/parts/bands/bands_layout.h"

namespace fulcrum {

class BandsPart : public Part {
  public:
    /// The scene lists bands.
    BandsPart(const Scene& scene, std::uint64_t seed);

    void exchange(int hand, const StepInput& input, HeldTool& held) noexcept override;
    double offer(int hand, const HeldTool& held) const noexcept override;
    bool holds(int hand) const noexcept override { return grips_[static_cast<std::size_t>(hand)].band >= 0; }
    GraspState grasp(int hand) const noexcept override;
    bool slipped(int hand) const noexcept override { return field_.hand(hand).jaws.slipped(); }
    void apply(const StepInput& input) noexcept override;
    std::uint32_t solve(const StepInput& input) noexcept override;
    /// What a hand holds for the tick, and whether its pedal gives energy.
    void publish_model(int hand, const TickOutput& last, LocalModel& model) noexcept override;
    void size_snapshot(WorldSnapshot& snapshot) const override;
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept override;
    const CavityModel* wall() const noexcept override { return &bed_; }
    void list_state(StateList& list) override;
    void add_costs(double us, std::vector<PartCost>& costs) const override;

    const BandsLayout& layout() const { return layout_; }
    const OperativeField& field() const { return field_; }
    const StrandState& strand(std::size_t band) const { return strands_[band]; }

  private:
    /// What a hand's jaws hold, and which band its power reaches.
    struct Grip {
        std::int32_t band = -1, touched = -1;
        std::uint32_t heated = 0;  ///< segments of `touched` that its power goes to, by bit
        StrandHold hold;
    };

    /// The band nearest to a place within Jaws::reach of it.
    struct Reach {
        std::int32_t band = -1, node = -1;  ///< -1: none is within reach
        double distance = no_offer;         ///< m
    };
    Reach nearest(const Vector3& place) const noexcept;

    void step_tool(int number, const StepInput& input) noexcept;
    /// takes: closing jaws take a band, and no tissue of another part.
    void step_jaws(int number, const ToolKinematics& tool, bool takes, double dt) noexcept;
    void take_band(int number, const ToolKinematics& tool) noexcept;
    void fire_clip(int number, const ToolKinematics& tool) noexcept;
    void apply_energy(int number, const ToolKinematics& tool, double duty) noexcept;
    void touch_with_blade(int number, const ToolKinematics& tool) noexcept;
    void step_strands(double dt) noexcept;
    void part_heated(double dt) noexcept;
    /// Whether a hand's power goes to a band.
    bool energises(int number, std::size_t band) const noexcept;
    void divide_heated(std::size_t band, double dt) noexcept;
    void part(std::size_t band, int segment, bool torn) noexcept;
    /// The vessel of a band, if it has one, ends at this cut next to its root.
    void open_trunk(std::size_t band, int segment, bool torn) noexcept;
    /// The branch at the vessel's root tears at the band's tension (N).
    void open_branch(std::size_t band, double tension) noexcept;
    /// Where outlets are and which tissue is around them: their bands move and part.
    void place_outlets() noexcept;
    std::size_t segment_patch(std::size_t band, int segment) const {
        return band * static_cast<std::size_t>(strand_segments) + static_cast<std::size_t>(segment);
    }
    std::size_t outlet_band(std::size_t outlet) const {
        return static_cast<std::size_t>(layout_.vessel_bands[outlet / 2]);
    }
    static bool is_trunk(std::size_t outlet) { return outlet % 2 == 0; }
    /// The outlet of the trunk of a band's vessel; -1 without one.
    std::int32_t trunk_of(std::size_t band) const {
        return layout_.bands[band].vessel < 0 ? -1 : 2 * layout_.bands[band].vessel;
    }

    BandsSpec spec_;
    BandsLayout layout_;
    CavityModel bed_;  ///< as instruments feel it
    StrandModel strand_model_;
    BandPatches patches_;
    OperativeField field_;  ///< outlets: 2 v trunk, 2 v + 1 branch of vessel v
    TissueSpec tissue_;
    std::int16_t tissue_index_ = -1;

    std::vector<StrandState> strands_;
    std::vector<double> overload_time_;    ///< s, by band
    std::vector<std::uint8_t> torn_;       ///< by band
    std::vector<std::uint32_t> clips_;     ///< by band, bit n: a clip sits at node n
    std::vector<double> progress_;         ///< of parting, by segment patch
    std::vector<double> sealed_;           ///< of a vessel there, by segment patch
    std::vector<double> parted_tension_;   ///< N, by band
    std::vector<std::int32_t> parted_at_;  ///< parted segment nearest to the root, by band; -1 none
    std::array<Grip, hand_count> grips_;
};

std::unique_ptr<Part> build_bands_part(const Scene& scene, std::uint64_t seed, const PartList& parts);

}  // namespace fulcrum
