// SPDX-License-Identifier: Apache-2.0
// Presacral veins, hypogastric nerves and the energy, blood and instruments before them, as a part of the
// world (task C4). World thread. Nothing allocates after construction.
//
// A step: instruments are exchanged; tips on the fascia open veins beneath it; blades divide nerves; the
// pedal heats what the blade reaches (a sheet that is being divided first of all), steam what is next to it;
// heat, sealing, bleeding, the pool, smoke.
//
// A vein opens where a tip is over it and
//   a blade lies deeper in the fascia than its cover: share (depth - cover) / (2 radius) of the lumen, or
//   a blunt tip presses with more than vein_tear_force: share force / vein_tear_force - 1,
// each at least least_opening. Depth is that of the tip's sphere below the wall, force what the wall answers
// with. An energised blade needs CuttingSpec::energy_factor of the cover. Openings of one vein within
// same_opening of each other are one outlet.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/contact/local_model.h"
#include "sim_core/instrument/tick_output.h"
#include "sim_core/numerics/state_hash.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/field/operative_field.h"
#include "sim_core/world/part/part.h"
#include "sim_core/world/part/snapshot.h"
#include "sim_core/world/parts/structures/structures_layout.h"

namespace fulcrum {

class StructuresPart : public Part {
  public:
    static constexpr double least_opening = 0.25;  ///< share of a vein's lumen; provisional
    static constexpr double same_opening = 0.004;  ///< m

    /// The scene lists structures. `wall` is asked during construction only; `felt` is that wall as
    /// instruments feel it, and lives as long as this part, as does `sheet`, which may be null.
    StructuresPart(const Scene& scene, const FieldWall& wall, const CavityModel& felt,
                   const HeatedSheet* sheet, std::uint64_t seed);

    /// What a hand holds; the tool as the tick knows it.
    HeldTool held(int hand, const ToolKinematics& tool) const noexcept;
    /// One step of dt over the outputs of `count` ticks (at least one), oldest first, after the sheet's.
    void step(const TickOutput* outputs, std::size_t count, double dt) noexcept;
    void exchange(int hand, const StepInput& /*input*/, HeldTool& now) noexcept override {
        now = held(hand, now.tool);
    }
    /// The whole step: what the hands do here depends on where the sheet is at its end.
    std::uint32_t solve(const StepInput& input) noexcept override {
        step(input.outputs, input.count, input.dt);
        return 0;
    }
    /// Whether the hand's pedal gives energy.
    void publish_model(int hand, const TickOutput& last, LocalModel& model) noexcept override;
    void size_snapshot(WorldSnapshot& snapshot) const override;
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept override;
    void list_state(StateList& list) override;
    void add_costs(double us, std::vector<PartCost>& costs) const override;

    const StructuresLayout& layout() const { return layout_; }
    const OperativeField& field() const { return field_; }
    /// Heat patch of a sheet's root triangle.
    std::size_t root_patch(std::int32_t root) const {
        return patches_.roots + static_cast<std::size_t>(root);
    }
    /// Vein of an outlet, -1 where it has not been used.
    std::int32_t vein_of(std::size_t outlet) const { return outlet_vein_[outlet]; }

  private:
    struct Patches {
        std::size_t outlets = 0, roots = 0;  ///< first of each
        std::int32_t root_count = 0;
    };
    static FieldModel make_field(const StructuresSpec& spec, const StructuresLayout& layout,
                                 const CavityModel& felt, const HeatedSheet* sheet, double thickness,
                                 Patches& patches);
    void step_tool(int number, const TickOutput* outputs, std::size_t count, double dt) noexcept;
    void press(const FieldHand& hand, const ToolKinematics& tool, bool energised) noexcept;
    void open_vein(std::int32_t vein, const Vector3& place, double share) noexcept;
    double conducting_share(const FieldHand& hand, const EnergyReach& reach) const noexcept;
    void apply_energy(int number, const ToolKinematics& tool, double duty) noexcept;

    StructuresSpec spec_;
    StructuresLayout layout_;
    const HeatedSheet* sheet_ = nullptr;
    Patches patches_;
    OperativeField field_;
    std::vector<double> root_area_;             ///< m2
    std::vector<std::uint8_t> root_is_target_;  ///< what energy on the sheet is for
    std::vector<std::int32_t> outlet_vein_;
    double wall_stiffness_ = 0, energy_factor_ = 1;
};

std::unique_ptr<Part> build_structures_part(const Scene& scene, std::uint64_t seed, const PartList& parts);

}  // namespace fulcrum
