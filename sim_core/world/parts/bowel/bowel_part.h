// SPDX-License-Identifier: Apache-2.0
// The bowel as a part of the world: rod, spheres, cage and surface, what holds it, what presses it
// (docs/THEORY.md 1 to 4). World thread. Nothing allocates after construction.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sim_core/bowel/bowel_skin.h"
#include "sim_core/bowel/dent.h"
#include "sim_core/bowel/luminal_volume.h"
#include "sim_core/bowel/wide_skin.h"
#include "sim_core/collision/sphere_collision.h"
#include "sim_core/contact/jaws.h"
#include "sim_core/contact/patch_builder.h"
#include "sim_core/contact/tool_contact.h"
#include "sim_core/instrument/tick_output.h"
#include "sim_core/instrument/tool_shapes.h"
#include "sim_core/numerics/state_hash.h"
#include "sim_core/rod/rod.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/jaws.h"
#include "sim_core/world/part/part.h"
#include "sim_core/world/part/snapshot.h"
#include "sim_core/world/part/stopwatch.h"
#include "sim_core/world/parts/bowel/bowel_anatomy.h"
#include "sim_core/world/parts/bowel/bowel_cut.h"

namespace fulcrum {

/// One hand over one step, as the bowel sees it.
struct ToolAction {
    const InstrumentSpec* instrument = nullptr;  ///< null: no such hand
    ToolKinematics tool;                         ///< at the step's last tick
    const ToolContactResult* contact =
        nullptr;  ///< with the surface as it would be at the step's end; null: none
    const ToolContactResult* near =
        nullptr;        ///< the same without contact too; null: the surface is out of reach
    bool busy = false;  ///< its jaws hold something else
    bool takes = true;  ///< jaws that close take hold here; false: something else is nearer
};

/// How much deeper a tool's jaws are in a sphere of the bowel than its shaft: depth m, normal out of the
/// sphere into the jaw; by_jaw false for a tool without jaws.
SolidContact jaws_in_sphere(const ToolShape& tool, const Vector3& centre, double radius);

class BowelPart : public Part {
  public:
    /// Builds rod, cage and skin, lays the bowel into the cavity and, without membranes, lets it come to
    /// rest: with them it does so together with what hangs on it. cavity must outlive this. Throws InputError
    /// where the anatomy cannot carry a cage.
    BowelPart(const Scene& scene, BowelAnatomy anatomy, const CavityModel* cavity);

    void begin_step() noexcept override;
    double offer(int hand, const HeldTool& held) const noexcept override;
    bool holds(int hand) const noexcept override { return grasps_[hand].jaws.held(); }
    GraspState grasp(int hand) const noexcept override;
    bool slipped(int hand) const noexcept override { return grasps_[hand].jaws.slipped(); }
    void apply(const StepInput& input) noexcept override;
    std::uint32_t solve(const StepInput& input) noexcept override;
    /// Patch, grasp and blade of a hand; leaves step, tick and targets alone.
    void publish_model(int hand, const TickOutput& last, LocalModel& model) noexcept override;
    void size_snapshot(WorldSnapshot& snapshot) const override;
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept override;
    /// It is drawn with its dents: an instrument is lifted out only as far as it is deeper than the dent.
    void show_touch(fulcrum::Touch& touch) const noexcept override;
    const LayeredWall* layered_wall() const noexcept override { return wall_.get(); }
    void list_state(StateList& list) override;
    void measure(bool on) override { measuring_ = on; }
    void add_costs(double us, std::vector<PartCost>& costs) const override;

    /// First half of a step of dt seconds that ends with this tick: grasps, and loads of tools and blades.
    void apply(const ToolAction* actions, std::uint32_t tick, double dt) noexcept;
    /// Lets it come to rest. `between_halves` is called between the two halves of each step.
    void lay_down(const std::function<void()>& between_halves);
    /// What else acts on the rod in this step; between the two halves. At most extra_loads, and those that
    /// room was made for.
    void add_load(const RodLoad& load) noexcept {
        if (inputs_.loads.size() < inputs_.loads.capacity()) inputs_.loads.push_back(load);
    }
    static constexpr std::size_t extra_loads = 64;
    void make_room_for_loads(std::size_t count);
    /// The last step had no finite solution: it was taken back.
    bool took_back() const { return took_back_; }
    /// Second half: collision, rod, rings, dents, cuts. Returns StepRecord::outcome.
    std::uint32_t solve(const ToolAction* actions, std::uint32_t tick, double dt) noexcept;
    /// Both halves, with nothing else acting on the rod.
    std::uint32_t step(const ToolAction* actions, double dt) noexcept {
        apply(actions, 0, dt);
        return solve(actions, 0, dt);
    }
    /// Turns every velocity off.
    void stop() noexcept;

    const BowelSkin& skin() const { return *skin_; }
    const Rod& rod() const { return *rod_; }
    const RodState& state() const { return state_; }
    const RodReport& report() const { return report_; }
    const GraspState& grasp(Hand hand) const { return grasps_[static_cast<int>(hand)].state; }
    const std::vector<std::int16_t>& tissue_patches() const { return patches_->tissue_patches(); }
    /// N, of the attempt: where a layered wall gives way.
    void set_puncture_force(double force) { patches_->set_puncture_force(force); }
    /// Contents of the lumen; null without.
    const LuminalVolume* lumen() const { return lumen_.get(); }
    /// Length over rest length at each ring.
    const std::vector<double>& ring_stretch() const { return ring_stretch_; }
    const SphereChain& spheres() const { return spheres_; }
    /// Null where the bowel's tissue is not cut.
    const BowelCut* cut() const { return cut_.get(); }
    BowelCut* cut() { return cut_.get(); }
    const RingFrame* ring_frames() const { return ring_frames_.data(); }
    double weight() const;  ///< N
    /// N, of a hand's jaws on the bowel in the last step; zero but at the level "jaws" of tool_contact.
    const Vector3& jaw_force(Hand hand) const { return jaw_felt_[static_cast<int>(hand)].force; }
    std::size_t bytes_rod() const, bytes_collision() const, bytes_surface() const;

    /// Wall time of the last step's blocks, microseconds; measured only when asked for.
    struct Costs {
        double grasps = 0, loads = 0, collision = 0, rod = 0, rings = 0, dents = 0, patches = 0;
    };
    const Costs& costs() const { return costs_; }

  private:
    static constexpr int planes_remembered = 6;  // a sphere, as SphereCollisionOptions::planes_per_sphere
    struct HandGrasp {
        Jaws jaws;
        GraspState state;
        FilteredForce filtered;               ///< shares of a pull at the grasp
        Matrix3 stiffness = Matrix3::Zero();  ///< N/m, rod seen at the wall point
        std::int32_t vertex = -1;
    };
    /// A hand's instrument against the surface as the world has it: the tick's own law, at the end of the
    /// step that is being made. The force that moves the bowel must not be the tick's: that one was made for
    /// a surface up to ten ticks old, and would throw a light bowel to and fro under a still tool.
    struct Touch {
        bool has_instrument = false;
        ToolContactModel model;
        ToolContactState state;
        ToolContactScratch scratch;
        ToolContactResult result;
    };
    void remember_forces() noexcept;
    void read_grasps() noexcept;
    std::uint32_t outcome_of() noexcept;
    void solve_rod(double dt) noexcept;
    void touch_tools(const StepInput& input) noexcept;
    void size_lists(const Scene& scene);
    void hang_tethers(const Scene& scene);
    void fill_grasp(int hand, const PatchRequest& request, LocalModel& model) noexcept;
    void update_grasps(const ToolAction* actions, double dt) noexcept;
    std::int32_t nearest_to(const Vector3& jaws, double& least) const noexcept;
    double area_in(const JawBox& box, const Vector3& middle) const noexcept;
    void begin_grasp(int hand, const ToolAction& action) noexcept;
    void end_grasp(int hand) noexcept;
    void gather_loads(const ToolAction* actions, double dt) noexcept;
    void press_jaws(const ToolAction* actions) noexcept;
    void press_blades(const ToolAction* actions, std::uint32_t tick, double dt) noexcept;
    void spread_pull(HandGrasp& grasp, const ToolAction& action) noexcept;
    void keep_hold(const ToolAction* actions) noexcept;
    void make_cut();
    void find_contacts() noexcept;
    void update_rings(double dt) noexcept;
    void update_dents(const ToolAction* actions, double dt) noexcept;
    void build_wall();

    const Scene& scene_;
    BowelAnatomy anatomy_;
    SphereChain spheres_;
    std::unique_ptr<Rod> rod_;
    std::unique_ptr<BowelSkin> skin_;
    std::unique_ptr<SphereCollision> collision_;
    std::unique_ptr<PatchBuilder> patches_;
    std::unique_ptr<WideSkin> wide_skin_;   ///< with a scope beyond local
    std::unique_ptr<LayeredWall> wall_;     ///< with layers
    std::unique_ptr<LuminalVolume> lumen_;  ///< with contents
    std::unique_ptr<BowelCut> cut_;         ///< with a tissue that blades cut
    WinklerBed bed_;
    RodSolve solve_;
    FilterMode filter_ = FilterMode::adaptive;

    RodState state_, good_;
    RodInputs inputs_, good_inputs_;
    RodScratch scratch_;
    RodReport report_;
    SphereCollision::Lists lists_;
    SphereContacts contacts_;
    std::vector<Vector3> centres_;
    std::vector<RingMotion> rings_;
    std::vector<RingFrame> ring_frames_;
    std::vector<double> ring_stretch_;
    std::vector<RingWrench> wrenches_;
    std::vector<Vector3> surface_;  ///< scratch positions for the filter at a grasp
    PatchBuilder::Scratch patch_scratch_;
    std::vector<Touch> touches_;      ///< by hand
    ToolAction actions_[hand_count];  ///< of the step
    HandGrasp grasps_[hand_count];
    Vector3 applied_push_[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    bool with_jaws_ = false;  ///< level "jaws"
    InstrumentModel jaw_models_[hand_count];
    std::vector<Vector3> jaw_pushes_[hand_count];  ///< N, on each sphere
    JawPushModel jaw_felt_[hand_count];            ///< their sum, as the haptic tick takes it up
    DentState dents_;
    std::vector<float> patch_damage_;
    std::vector<double> remembered_lambda_;  ///< last contact forces, by sphere and plane
    std::vector<Vector3> remembered_normal_;
    std::uint32_t frozen_steps_ = 0;
    bool took_back_ = false;  // scratch
    bool measuring_ = false;
    Costs costs_;
};

std::unique_ptr<Part> build_bowel_part(const Scene& scene, std::uint64_t seed, const PartList& parts);

}  // namespace fulcrum
