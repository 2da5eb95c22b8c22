// SPDX-License-Identifier: Apache-2.0
// The bowel as a part of the world: rod, spheres, cage and surface, what holds it, what presses it
// (docs/THEORY.md 1 to 4). World thread. Nothing allocates after construction.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/bowel/bowel_skin.h"
#include "sim_core/bowel/dent.h"
#include "sim_core/bowel/luminal_volume.h"
#include "sim_core/bowel/wide_skin.h"
#include "sim_core/collision/sphere_collision.h"
#include "sim_core/contact/patch_builder.h"
#include "sim_core/contact/tool_contact.h"
#include "sim_core/instrument/tick_output.h"
#include "sim_core/instrument/tool_shapes.h"
#include "sim_core/numerics/state_hash.h"
#include "sim_core/rod/rod.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/parts/bowel/bowel_cut.h"
#include "sim_core/world/parts/membranes/membrane_part.h"
#include "sim_core/world/snapshot.h"
#include "sim_core/world/stopwatch.h"

namespace fulcrum {

/// Rest geometry of a bowel and how it lies in the body.
struct BowelAnatomy {
    TriangleMesh surface;                  ///< rest tube along +x, closed
    double length = 0;                     ///< m
    RadiusProfile radius;                  ///< lumen radius by rest arc length
    std::vector<Vector3> centre_line;      ///< in situ, patient frame, first = rectum
    std::vector<Vector3> root_line;        ///< mesenteric root on the wall, first = rectal end
    std::vector<MembraneSheet> membranes;  ///< one for each of Scene::membranes
    std::vector<RodTether> cranial_holds;  ///< not empty: its cranial end is free but for these
};

/// One hand over one step, as the bowel sees it.
struct ToolAction {
    const InstrumentSpec* instrument = nullptr;  ///< null: no such hand
    ToolKinematics tool;                         ///< at the step's last tick
    const ToolContactResult* contact =
        nullptr;  ///< with the surface as it would be at the step's end; null: none
    const ToolContactResult* near =
        nullptr;  ///< the same without contact too; null: the surface is out of reach
    bool slipping = false;
    bool busy = false;  ///< its jaws hold something else
};

/// How much deeper a tool's jaws are in a sphere of the bowel than its shaft: depth m, normal out of the
/// sphere into the jaw; by_jaw false for a tool without jaws.
SolidContact jaws_in_sphere(const ToolShape& tool, const Vector3& centre, double radius);

class BowelPart {
  public:
    /// Builds rod, cage and skin, lays the bowel into the cavity and lets it come to rest. cavity must
    /// outlive this. Throws InputError where the anatomy cannot carry a cage.
    BowelPart(const Scene& scene, BowelAnatomy anatomy, const CavityModel* cavity);

    /// One step of dt seconds: grasps, loads, rod, collision, rings, dents. Returns StepRecord::outcome.
    /// more: what else acts on the rod in this step, up to extra_loads; null: nothing. tick: that it ends
    /// with.
    std::uint32_t step(const ToolAction* actions, double dt, const std::vector<RodLoad>* more = nullptr,
                       std::uint32_t tick = 0) noexcept;
    static constexpr std::size_t extra_loads = 64;
    /// m, from the middle of a hand's jaws to the wall; the jaws' reach where it is further.
    double distance_to_jaws(const ToolAction& action) const noexcept;
    /// Turns every velocity off.
    void stop() noexcept;
    /// Hand's patch and grasp for the tick; leaves step, tick and targets alone.
    void fill_local_model(Hand hand, const PatchRequest& request, LocalModel& model) noexcept;
    /// What holds its tool along the wall: a blade in it, lips about it. After fill_local_model.
    void fill_blade(Hand hand, LocalModel& model) const noexcept {
        if (cut_) cut_->fill_local_model(static_cast<int>(hand), model);
    }
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept;
    void size_snapshot(WorldSnapshot& snapshot) const;
    void hash(StateHash& hash) const noexcept;
    /// All that changes from step to step; a part made for the same scene goes on from it bit for bit.
    /// Null with membranes, whose solver remembers more than their state.
    struct Saved;
    std::shared_ptr<const Saved> save() const;
    void restore(const Saved& saved);

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
    /// A step that advances nothing makes no events.
    void forget_events() noexcept {
        if (cut_) cut_->forget_events();
    }
    const std::vector<MembranePart>& membranes() const { return membranes_; }
    double weight() const;  ///< N
    /// N, of a hand's jaws on the bowel in the last step; zero but at the level "jaws" of tool_contact.
    const Vector3& jaw_force(Hand hand) const { return jaw_felt_[static_cast<int>(hand)].force; }
    std::size_t bytes_rod() const, bytes_collision() const, bytes_surface() const, bytes_membranes() const;

    /// Wall time of the last step's blocks, microseconds; measured only when asked for.
    struct Costs {
        double grasps = 0, loads = 0, collision = 0, rod = 0, rings = 0, dents = 0, patches = 0,
               membranes = 0;
    };
    void measure(bool on) { measuring_ = on; }
    const Costs& costs() const { return costs_; }

  private:
    struct HandGrasp {
        GraspState state;
        Vector3 correction = Vector3::Zero();   ///< m, wall point minus jaws when the grasp began; decays
        Vector3 target = Vector3::Zero();       ///< m, where the wall point was held last
        Vector3 velocity = Vector3::Zero();     ///< m/s, of the target
        Vector3 hold_offset = Vector3::Zero();  ///< m, tool frame, relative to the tip
        FilteredForce filtered;                 ///< shares of a pull at the grasp
        Matrix3 stiffness = Matrix3::Zero();    ///< N/m, rod seen at the wall point
        std::int32_t vertex = -1;
        bool ready = true;     ///< the jaws were open since the last grasp
        double slip_time = 0;  ///< s of load beyond what the jaws can hold
    };
    /// Jaws on a membrane: as on the bowel, by the sheet's own holds.
    struct SheetGrasp {
        int membrane = -1;  ///< that is held, -1: none
        Vector3 correction = Vector3::Zero(), target = Vector3::Zero(), velocity = Vector3::Zero(),
                hold_offset = Vector3::Zero();
        double stiffness = 0, slip_time = 0;
    };
    void lay_down();
    void update_grasps(const ToolAction* actions, double dt) noexcept;
    std::int32_t nearest_to(const Vector3& jaws, double& least) const noexcept;
    void begin_grasp(int hand, const ToolAction& action) noexcept;
    bool begin_sheet_grasp(int hand, const ToolAction& action, const Vector3& jaws,
                           double nearest_bowel) noexcept;
    void update_sheet_grasp(int hand, const ToolAction& action, double opening, double dt) noexcept;
    void fill_sheet_model(const SheetGrasp& grasp, int hand, LocalModel& model) const noexcept;
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
    std::vector<MembranePart> membranes_;
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
    HandGrasp grasps_[hand_count];
    SheetGrasp sheet_grasps_[hand_count];
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
    bool measuring_ = false;
    Costs costs_;
};

}  // namespace fulcrum
