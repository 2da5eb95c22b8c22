// SPDX-License-Identifier: Apache-2.0
// All membranes of a scene (Scene::membranes) as a part of the world. What carries their edges is a coupling.
// World thread. Nothing allocates after construction.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/world/part/jaws.h"
#include "sim_core/world/part/part.h"
#include "sim_core/world/parts/membranes/membrane_part.h"

namespace fulcrum {

class MembranesPart : public Part {
  public:
    explicit MembranesPart(const Scene& scene);

    double offer(int hand, const HeldTool& held) const noexcept override;
    bool holds(int hand) const noexcept override { return grasps_[hand].jaws.held(); }
    GraspState grasp(int hand) const noexcept override;
    bool slipped(int hand) const noexcept override { return grasps_[hand].jaws.slipped(); }
    /// Jaws.
    void apply(const StepInput& input) noexcept override;
    std::uint32_t solve(const StepInput& input) noexcept override { return step(input.dt); }
    void publish_model(int hand, const TickOutput& last, LocalModel& model) noexcept override;
    void size_snapshot(WorldSnapshot& snapshot) const override;
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept override;
    void list_state(StateList& list) override;
    void add_costs(double us, std::vector<PartCost>& costs) const override;

    /// Without jaws. Returns StepRecord::outcome.
    std::uint32_t step(double dt) noexcept;
    /// Takes the last step back, at rest.
    void take_back() noexcept;
    /// Turns every velocity off.
    void stop() noexcept;

    std::vector<MembranePart>& membranes() { return membranes_; }
    const std::vector<MembranePart>& membranes() const { return membranes_; }
    const std::vector<MembraneSheet>& layout() const { return layout_; }

  private:
    struct HandGrasp {
        Jaws jaws;
        int membrane = -1;     ///< that they hold, or held last
        double stiffness = 0;  ///< N/m, that the jaws feel
    };
    void take(int hand, const HeldTool& held) noexcept;

    TissueSpec tissue_;  ///< the bowel's: a mesentery has no tissue of its own
    std::int16_t tissue_index_ = -1;
    std::vector<MembraneSheet> layout_;
    std::vector<MembranePart> membranes_;
    HandGrasp grasps_[hand_count];
    std::uint32_t frozen_steps_ = 0;
};

std::unique_ptr<Part> build_membranes_part(const Scene& scene, std::uint64_t seed, const PartList& parts);

}  // namespace fulcrum
