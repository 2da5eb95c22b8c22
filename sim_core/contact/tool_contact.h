// SPDX-License-Identifier: Apache-2.0
// Tick side of the local model: at every tick the force between one instrument and everything it touches.
//
// Each contact is a proxy (god-object) on a surface, of the tool's radius, coupled by a spring and damper:
//     F = K d n - B v_rel   on the tool, d the depth; never attractive, tangential part within the friction
//     of the normal.
// K of tissue is the Winkler bed under the filter's footprint (docs/THEORY.md, section 4). Held tissue exerts
//     F = lambda + K (x - x0) + B (v - v0)   on the tissue, within the friction cone of the jaws.
// Model (const) / state / scratch / result; haptic thread: no allocation, lock, exception; always finite.
#pragma once

#include "sim_core/bowel/force_filter.h"
#include "sim_core/collision/cavity.h"
#include "sim_core/contact/local_model.h"
#include "sim_core/contact/surface_walk.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/instrument/lever.h"
#include "sim_core/instrument/proxy_pose.h"

namespace fulcrum {

/// Constant for an attempt.
struct ToolContactModel {
    InstrumentModel instrument;
    FilterOptions filter;
    const CavityModel* cavity = nullptr;  ///< null: no wall. Immutable, so the tick may read it
    TissueContact wall;                   ///< most_stiffness is K of the wall
    double stiffness_time = 0.010;        ///< s, time constant with which K follows a change of footprint
    double onset_depth = 0.0005;          ///< m of depth over which damping rises to its full value
    double start_reach = 0.008;  ///< m, a walk further away from the surface than this restarts from the seed
    bool search_always = false;  ///< fidelity "query": full search of the patch at every tick
    double let_out_speed = 0.02;  ///< m/s, rate at which residual depth after a hold becomes contact depth
};

/// Contact model of the instrument under the scene's fidelity, without a wall.
ToolContactModel make_tool_contact(const Scene& scene, const InstrumentModel& instrument);

/// Contact state of one hand between ticks; copyable.
struct ToolContactState {
    std::int32_t triangle_id = -1;  ///< surface triangle of the dynamic point, -1 none
    Vector3 barycentric = Vector3(1.0 / 3, 1.0 / 3, 1.0 / 3);
    double shaft = 1.0;
    double stiffness = 0;  ///< N/m, relaxed K; 0 out of contact
    /// m, residual depth after a hold, which exerts no force: jaws that open are still where the tissue was
    /// drawn to. Taken at the first contact after a hold; then it decreases with time and with every
    /// displacement of the tool out of the tissue.
    double left_in = 0;
    double pressed = 0;  ///< m, depth beyond left_in
    bool held = false;   ///< the jaws held tissue and no contact has been found since
    bool touching = false;
    std::int32_t wall_triangle = -1;
    Vector3 wall_barycentric = Vector3(1.0 / 3, 1.0 / 3, 1.0 / 3);
    double wall_behind = 0;  // m from the tip to the place of the shaft that this is nearest to
    bool touching_wall = false;
    std::uint32_t topology_version = 0;
    std::uint32_t model_step = 0;  ///< world step of the model whose seed was tried last
};

/// Work space: skinned positions and normals of the patch at the tick.
struct ToolContactScratch {
    std::array<Vector3, patch_vertex_capacity> positions;
    std::array<Vector3, patch_vertex_capacity> normals;
    std::array<std::uint32_t, patch_vertex_capacity> position_stamp{};
    std::array<std::uint32_t, patch_vertex_capacity> normal_stamp{};
    std::array<RingFrame, patch_ring_capacity> rings;
    std::uint32_t stamp = 0;
};

/// A load split into what springs give and what dampers add, and what gives them.
struct SplitLoad {
    ToolLoad spring, damper;
    ToolMatrix stiffness, damping;  ///< N/m, N s/m

    /// A contact at `arm` (m, point minus trocar): its whole force, the part without damping, and its K and
    /// B.
    void add(const Vector3& arm, const Vector3& force, const Vector3& without_damping, const Matrix3& k,
             const Matrix3& b) {
        spring.add(arm, without_damping);
        damper.add(arm, force - without_damping);
        stiffness.add(k, arm);
        damping.add(b, arm);
    }
    void add(const SplitLoad& other) {
        spring.force += other.spring.force;
        spring.moment += other.spring.moment;
        damper.force += other.damper.force;
        damper.moment += other.damper.moment;
        stiffness.add(other.stiffness);
        damping.add(other.damping);
    }
    bool all_finite() const {
        return spring.force.allFinite() && spring.moment.allFinite() && damper.force.allFinite() &&
               damper.moment.allFinite() && stiffness.all_finite() && damping.all_finite();
    }
};

/// All forces are those of the instrument on what it touches, N, patient frame; zero without contact.
struct ToolContactResult {
    Vector3 force = Vector3::Zero();          ///< sum
    Vector3 torque = Vector3::Zero();         ///< N m, of the sum about the trocar, without other instruments
    Vector3 surface_force = Vector3::Zero();  ///< on the bowel's surface, to be filtered
    Vector3 grasp_force = Vector3::Zero();    ///< on held tissue
    Vector3 target_force = Vector3::Zero();
    Vector3 wall_force = Vector3::Zero();
    Vector3 jaw_force = Vector3::Zero();    ///< of jaws as boxes on the bowel; the world applies it itself
    Vector3 sheet_force = Vector3::Zero();  ///< on a sheet that may be divided
    Vector3 tool_force = Vector3::Zero();   ///< on the other instrument (collide_tools)

    bool touching_surface = false, touching_wall = false, touching_target = false, touching_tool = false;
    bool grasping = false, slipping = false;
    bool cutting = false;            ///< the blade is in a sheet
    std::int16_t tissue = -1;        ///< of the largest force, -1 none
    std::int16_t tissue_patch = -1;  ///< under the contact or the jaws
    std::int32_t target = -1;        ///< TargetModel::id touched
    double target_distance = 0;  ///< m, tip surface to the nearest target's surface; valid only with targets

    Vector3 point = Vector3::Zero();          ///< m, contact point on the bowel's surface
    Vector3 normal = Vector3::Zero();         ///< unit, outward there
    double distance = 0;                      ///< m, tool surface to bowel surface; < 0: depth
    double shaft = 1.0;                       ///< fraction of the shaft at the contact
    std::int32_t vertex = -1, triangle = -1;  ///< surface numbers
    FilteredForce filtered;  ///< vertices in surface numbers; count 0 without surface contact
    double area = 0;         ///< m2, Eq. 4
    int grade = 0;           ///< Eq. 3

    TouchList touches;      ///< for the picture: how deep in the bowel, rigid bodies and the other instrument
    SplitLoad tissue_load;  ///< force and torque again, for the hand (lever.h)
    SplitLoad tool_load;    ///< tool_force with its moment about this instrument's trocar
    Matrix3 stiffness = Matrix3::Zero();  ///< N/m, -dF_on_tool/dx of all contacts
    double damping = 0;                   ///< N s/m, largest
    double jaw_area = 0;                  ///< m2, GraspModel::area while grasping
    double slip_ratio = 0;                ///< force over what the jaws can hold, 0 without grasp
    bool punctured = false;               ///< the wall's puncture force is reached
    bool searched = false;                ///< the patch was searched fully in this tick
    bool lost = false;                    ///< the dynamic point was lost and not found again
    std::uint32_t age = 0;                ///< ticks since the model's pose
    std::uint32_t model_step = 0;
};

/// Force of one instrument against its local model at `tick`. result is overwritten.
void step_tool_contact(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                       std::uint32_t tick, ToolContactState& state, ToolContactScratch& scratch,
                       ToolContactResult& result);

/// Force that the model behind `last` would give now that the tool's contact point has moved by `motion` (m),
/// N on the tissue: the old force in a bumpless swap, to first order, without keeping the old model.
Vector3 predict_force(const ToolContactResult& last, const Vector3& motion);

/// State of the contact between two instruments from tick to tick; copyable.
struct ToolPairState {
    bool touching = false;
    Vector3 normal = Vector3::UnitZ();  ///< unit, out of the right one
    double depth = 0;                   ///< m along it
};

/// K and B of the contact between two instruments; steel, softened to what the haptic loop can render stably.
inline constexpr double shaft_stiffness = 800, shaft_damping = 0.4;

/// Two instruments' shafts as capsules, jaws as boxes: adds tool_force to both results (opposite). A hand
/// without force feedback can move through the other instrument: as long as the two overlap they stay on the
/// sides from which they came. Returns the depth, m; <= 0 if separated.
double collide_tools(const ToolContactModel& left, const ToolKinematics& left_tool,
                     const ToolContactModel& right, const ToolKinematics& right_tool, ToolPairState& state,
                     ToolContactResult& left_result, ToolContactResult& right_result);

/// Force on the tissue of a tool whose contact stiffness is k against tissue of stiffness c
/// (Rod::stiffness_at): the world's side of the coupling. Applying the tick's force unrelaxed in the next
/// step diverges where k > c; this is the implicit step: previous + (tick - previous) / (1 + k / c).
Vector3 relax_contact_force(const Vector3& previous, const Vector3& from_tick, double contact_stiffness,
                            double tissue_stiffness);

}  // namespace fulcrum
