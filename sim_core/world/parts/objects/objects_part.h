// SPDX-License-Identifier: Apache-2.0
// Rigid rings around pegs on a tray, taken, handed over and dropped by jaws, as a part of the world (task
// A3). Equations: docs/THEORY.md, section 12. World thread. Nothing allocates after construction.
//
// Jaws hold a ring at three points of a tube that do not lie on one line, so that it follows their turns.
// Open jaws pass on both sides of a tube: only the shaft behind them pushes rings; closed jaws push too.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "sim_core/rigid/capsule_bodies.h"
#include "sim_core/world/part/jaws.h"
#include "sim_core/world/part/part.h"
#include "sim_core/world/part/step_events.h"
#include "sim_core/world/parts/objects/objects_layout.h"

namespace fulcrum {

class ObjectsPart : public Part {
  public:
    /// A ring that is let go higher than this (m) above the tray, around no peg and in no other jaws, is
    /// dropped.
    static constexpr double drop_height = 0.005;

    /// The scene lists objects.
    ObjectsPart(const Scene& scene, std::uint64_t seed);

    void begin_step() noexcept override { events_.clear(); }
    double offer(int hand, const HeldTool& held) const noexcept override;
    bool holds(int hand) const noexcept override { return hands_[hand].object >= 0; }
    GraspState grasp(int hand) const noexcept override;
    bool slipped(int hand) const noexcept override { return hands_[hand].jaws.slipped(); }
    void apply(const StepInput& input) noexcept override;
    std::uint32_t solve(const StepInput& input) noexcept override;
    void publish_model(int hand, const TickOutput& last, LocalModel& model) noexcept override;
    void size_snapshot(WorldSnapshot& snapshot) const override;
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept override;
    const CavityModel* wall() const noexcept override { return &tray_; }
    void list_state(StateList& list) override;
    void add_costs(double us, std::vector<PartCost>& costs) const override;

    const std::vector<BodyState>& bodies() const { return bodies_; }

  private:
    /// One hand's jaws and what it did to rings in the last step.
    struct HandState {
        Jaws jaws;
        std::int32_t object = -1;               ///< that it holds
        std::array<Vector3, grip_points> at{};  ///< m, held points in the ring's frame
        Vector3 hold_force = Vector3::Zero();   ///< N, jaws on ring
        Vector3 push_force = Vector3::Zero();   ///< N, instrument on rings
        double push_back = 0;                   ///< m, from the tip back along the shaft to where it pushes
        Capsule pusher;                         ///< m, at the step's end
        bool present = false;
    };
    /// Nearest tube to a pair of jaws.
    struct Reach {
        std::int32_t object = -1;
        std::size_t tube = 0;
        double distance = 0;                ///< m, from the jaws' middle line to its surface
        Vector3 on_ring = Vector3::Zero();  ///< m
    };

    Reach nearest(const HeldTool& held) const noexcept;
    void take(int hand, const HeldTool& held) noexcept;
    void follow_jaws(int hand, const StepInput& input) noexcept;
    void place_pusher(int hand, const HeldTool& held) noexcept;
    void let_go(int hand, std::uint32_t tick) noexcept;
    std::int32_t peg_of(const BodyState& body) const noexcept;

    ObjectsSpec spec_;
    ObjectsLayout layout_;
    CavityModel tray_;
    TissueSpec tissue_;
    std::int16_t tissue_index_ = -1;

    std::vector<BodyState> bodies_;
    HandState hands_[hand_count];

    CapsuleBodies solver_;
    std::vector<BodyState> before_;
    BodyGrip grips_[hand_count];
    BodyPusher pushers_[hand_count];
    StepEvents<2 * hand_count> events_;
};

std::unique_ptr<Part> build_objects_part(const Scene& scene, std::uint64_t seed, const PartList& parts);

}  // namespace fulcrum
