// SPDX-License-Identifier: Apache-2.0
#include "sim_core/contact/tool_contact.h"

#include <algorithm>
#include <cmath>

#include "sim_core/bowel/dent.h"
#include "sim_core/contact/contact_response.h"
#include "sim_core/contact/jaws.h"
#include "sim_core/contact/patch_surface.h"
#include "sim_core/contact/rigid_contact.h"
#include "sim_core/contact/sheet_contact.h"

namespace fulcrum {
namespace {

constexpr double longest_carry =
    0.020;                           // s: maximum time over which rings are extrapolated by their velocity
constexpr double tip_blend = 0.005;  // m over which the proxy's radius changes from the tip's to the shaft's

// True for a pose that a force can be computed from: finite, with finite squares.
bool can_touch(const ToolKinematics& tool) {
    constexpr double furthest = 1e6, fastest = 1e6;  // m, m/s
    return tool.rotation.allFinite() && tool.tip.allFinite() && tool.tip.cwiseAbs().maxCoeff() < furthest &&
           tool.tip_velocity.allFinite() && tool.tip_velocity.cwiseAbs().maxCoeff() < fastest;
}

bool all_finite(const ToolContactResult& result) {
    return result.force.allFinite() && result.torque.allFinite() && result.stiffness.allFinite() &&
           result.point.allFinite() && result.normal.allFinite() && result.tissue_load.all_finite() &&
           std::isfinite(result.damping + result.distance + result.area + result.slip_ratio +
                         result.target_distance);
}

WalkPoint start_at_seed(const SurfacePatch& patch) {
    WalkPoint walk;
    walk.triangle = patch.seed_triangle;
    walk.shaft = patch.seed_shaft;
    return walk;
}

bool touches_border(const SurfacePatch& patch, std::int32_t triangle) {
    for (const std::int32_t vertex : patch.triangles[static_cast<std::size_t>(triangle)]) {
        if (patch.border[static_cast<std::size_t>(vertex)] != 0) return true;
    }
    return false;
}

void walk_patch(PatchSurface& surface, const SurfacePatch& patch, const ToolKinematics& tool,
                const WalkOptions& options, WalkPoint& walk) {
    walk_surface(surface, tool.trocar, tool.tip, options, walk);
    // Normals of border vertices include only some of their triangles.
    if (touches_border(patch, walk.triangle)) walk.at_border = true;
}

// Full search of the patch: the vertex nearest to the shaft, then the walk from a triangle at that vertex.
WalkPoint search_patch(PatchSurface& surface, const SurfacePatch& patch, const ToolKinematics& tool,
                       const WalkOptions& options) {
    const Vector3 shaft = tool.tip - tool.trocar;
    const double length2 = shaft.squaredNorm();
    double best2 = 1e30;
    WalkPoint walk = start_at_seed(patch);
    for (std::int32_t v = 0; v < patch.vertex_count; ++v) {
        if (patch.border[static_cast<std::size_t>(v)] != 0) continue;
        const Vector3 from_trocar = surface.position(v) - tool.trocar;
        const double s = length2 > 0 ? std::clamp(from_trocar.dot(shaft) / length2, 0.0, 1.0) : 1.0;
        const double distance2 = (from_trocar - s * shaft).squaredNorm();
        if (distance2 >= best2) continue;
        best2 = distance2;
        walk.triangle = patch.vertex_triangles[static_cast<std::size_t>(
            patch.vertex_triangle_offsets[static_cast<std::size_t>(v)])];
        walk.shaft = s;
    }
    walk_patch(surface, patch, tool, options, walk);
    return walk;
}

// The dynamic point of this tick; at_border if there is none.
WalkPoint find_point(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                     PatchSurface& surface, const ToolContactState& state, ToolContactResult& result) {
    const SurfacePatch& patch = local.patch;
    WalkOptions options;
    options.curvature_radius = patch.curvature_radius;
    if (model.search_always) {
        result.searched = true;
        return search_patch(surface, patch, tool, options);
    }
    WalkPoint walk;
    walk.at_border = true;
    const std::int32_t known =
        state.topology_version == local.topology_version ? patch.find_triangle(state.triangle_id) : -1;
    if (known >= 0) {
        walk.triangle = known;
        walk.barycentric = state.barycentric;
        walk.shaft = state.shaft;
        walk_patch(surface, patch, tool, options, walk);
    }
    // Without contact, the seed of a new model may be nearer; a lost point always restarts from the seed.
    const bool new_seed = !state.touching && state.model_step != local.step;
    if (walk.at_border || new_seed || (!state.touching && walk.distance > model.start_reach)) {
        WalkPoint seeded = start_at_seed(patch);
        walk_patch(surface, patch, tool, options, seeded);
        if (walk.at_border || (!seeded.at_border && seeded.distance < walk.distance)) walk = seeded;
    }
    // The seed is outdated, by time or by the path of a fast tool, or at the border: search all vertices,
    // once.
    const double since = result.age * model.instrument.tick_period;
    const bool outrun = tool.tip_velocity.norm() * since > model.start_reach;
    if (walk.at_border && (state.touching || known >= 0 || outrun)) {
        result.searched = true;
        walk = search_patch(surface, patch, tool, options);
    }
    return walk;
}

void filter_at(const ToolContactModel& model, const SurfacePatch& patch, const ToolKinematics& tool,
               PatchSurface& surface, std::int32_t vertex, const Vector3& normal, ToolContactResult& result) {
    TipBox box;
    box.edges = model.instrument.tip_box;
    box.axes.col(0) = tool.rotation.col(2);
    box.axes.col(1) = tool.rotation.col(0);
    box.axes.col(2) = tool.rotation.col(1);
    result.area = contact_area(box, normal);
    surface.skin_neighbourhood(vertex);
    filter_force(surface.view(), vertex, result.area, model.filter, result.filtered);
    result.grade = result.filtered.grade;
    result.vertex = patch.vertex_id[static_cast<std::size_t>(vertex)];
    result.tissue_patch = patch.tissue_patch[static_cast<std::size_t>(vertex)];
}

// Converts patch numbers to surface numbers.
void number_by_surface(const SurfacePatch& patch, FilteredForce& filtered) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(filtered.count); ++i) {
        filtered.vertex[i] = patch.vertex_id[static_cast<std::size_t>(filtered.vertex[i])];
    }
}

/// Response of the wall under the contact, N/m: force over depth, and its slope (0 where the slope is the
/// secant, relaxed or not).
struct SecantStiffness {
    double secant = 0, tangent = 0;
};

SecantStiffness wall_stiffness(const SurfacePatch& patch, const Triangle& corner, const Vector3& barycentric,
                               double depth, ToolContactResult& result) {
    const TissueContact& contact = patch.contact;
    SecantStiffness stiffness;
    if (contact.wall == nullptr) {
        WinklerBed bed;
        bed.stiffness_per_area = contact.stiffness_per_area;
        stiffness.secant = std::clamp(contact_stiffness(bed, patch.vertex_area.data(), result.filtered),
                                      contact.least_stiffness, contact.most_stiffness);
        return stiffness;
    }
    double nodule = 0;
    for (int k = 0; k < 3; ++k)
        nodule +=
            barycentric[k] * patch.nodule[static_cast<std::size_t>(corner[static_cast<std::size_t>(k)])];
    // At zero depth the secant is the tangent.
    constexpr double least_depth = 1e-6;
    const double at = std::max(depth, least_depth);
    const Indentation answer = contact.wall->indent(at, result.area, contact.puncture_force, nodule);
    stiffness.secant = answer.force / at;
    stiffness.tangent = answer.stiffness;
    result.punctured = answer.punctured;
    return stiffness;
}

// Residual depth after a hold. Tissue drawn into a fold has several places that are nearest to the tool in
// turn, each with a depth of its own: a depth that appears without a motion is residual, not a push.
void leave_in(const ToolContactModel& model, const ToolKinematics& tool, double depth,
              ToolContactState& state) {
    constexpr double tissue_speed = 1.0;  // m/s, that tissue which lets go of jaws hardly exceeds
    const double period = model.instrument.tick_period, inside = std::max(0.0, depth);
    const bool letting_out = !state.held && state.left_in > 0;
    if (state.held) state.left_in = inside;
    state.held = false;
    state.left_in = std::clamp(state.left_in - model.let_out_speed * period, 0.0, inside);
    const double most = state.pressed + (tool.tip_velocity.norm() + tissue_speed) * period;
    if (letting_out && inside - state.left_in > most) state.left_in = inside - state.pressed;
    state.pressed = inside - state.left_in;
}

void touch_surface(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                   PatchSurface& surface, ToolContactState& state, ToolContactResult& result) {
    const SurfacePatch& patch = local.patch;
    const WalkPoint walk = find_point(model, local, tool, surface, state, result);
    state.model_step = local.step;
    state.topology_version = local.topology_version;
    if (walk.at_border) {
        result.lost = state.touching;
        state.triangle_id = -1;
        state.touching = false;
        state.stiffness = 0;
        return;
    }
    state.triangle_id = patch.triangle_id[static_cast<std::size_t>(walk.triangle)];
    state.barycentric = walk.barycentric;
    state.shaft = walk.shaft;
    const InstrumentModel& instrument = model.instrument;
    const double from_tip = (1.0 - walk.shaft) * (tool.tip - tool.trocar).norm();
    const double radius = instrument.tip_radius + (instrument.shaft_radius - instrument.tip_radius) *
                                                      std::min(1.0, from_tip / tip_blend);
    const double depth = radius - walk.distance;
    result.point = walk.position;
    result.normal = walk.normal;
    result.distance = -depth;
    result.shaft = walk.shaft;
    result.triangle = state.triangle_id;
    leave_in(model, tool, depth, state);
    if (!(depth > 0) || !(patch.cover > 0)) {
        state.touching = false;
        state.stiffness = 0;
        return;
    }

    const Triangle& corner = surface.corner(walk.triangle);
    int largest = 0;
    walk.barycentric.maxCoeff(&largest);
    filter_at(model, patch, tool, surface, corner[static_cast<std::size_t>(largest)], walk.normal, result);
    const double pressed = depth - state.left_in;
    SecantStiffness wall = wall_stiffness(patch, corner, walk.barycentric, pressed, result);
    wall.secant *= patch.cover;
    wall.tangent *= patch.cover;
    number_by_surface(patch, result.filtered);
    // K follows its footprint with a delay, so that a step to another vertex causes no step in the force.
    const double period = instrument.tick_period;
    // (The secant of a layered wall follows the depth itself, and its area is that of Eq. 4, which is
    // continuous.)
    state.stiffness =
        state.touching && patch.contact.wall == nullptr
            ? state.stiffness + (wall.secant - state.stiffness) * period / (model.stiffness_time + period)
            : wall.secant;
    state.touching = true;

    Vector3 tissue_velocity = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
        tissue_velocity += walk.barycentric[k] * surface.velocity(corner[static_cast<std::size_t>(k)]);
    const Vector3 tool_velocity = tool.sliding_velocity(walk.shaft);
    ContactResponse response;
    response.stiffness = state.stiffness;
    response.damping = patch.cover * patch.contact.damping;
    response.friction = patch.contact.friction;
    response.onset_depth = model.onset_depth;
    result.surface_force = response.force_on_tissue(pressed, walk.normal, tool_velocity - tissue_velocity);
    result.torque += (walk.position - tool.trocar).cross(result.surface_force);
    result.tissue_load.add(walk.position - tool.trocar, result.surface_force,
                           response.spring_force(pressed, walk.normal),
                           std::max(state.stiffness, wall.tangent) * walk.normal * walk.normal.transpose(),
                           response.damping * Matrix3::Identity());
    result.touches.add(walk.normal, pressed, walk.shaft, result.vertex);
    result.touching_surface = true;
    result.stiffness += std::max(state.stiffness, wall.tangent) * walk.normal * walk.normal.transpose();
    result.damping = std::max(result.damping, patch.contact.damping);
}

void hold_tissue(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                 double seconds, PatchSurface& surface, ToolContactState& state, ToolContactResult& result) {
    const GraspModel& grasp = local.grasp;
    const Vector3 hold = tool.tip + tool.rotation * grasp.hold_offset;
    const Vector3 held = grasp.point + seconds * grasp.velocity;
    const Vector3 velocity =
        tool.tip_velocity + tool.angular_velocity.cross(tool.rotation * grasp.hold_offset);
    Vector3 without_damping = grasp.reaction + grasp.stiffness * (hold - held);
    Vector3 force = without_damping + grasp.damping * (velocity - grasp.velocity);
    result.slip_ratio = slip_ratio(force, tool.grip, grasp.friction);
    if (result.slip_ratio > 1) {
        // The faces hold no more than the friction cone allows: the rest slides through.
        force /= result.slip_ratio;
        result.slipping = true;
    }
    const double spring_slip = slip_ratio(without_damping, tool.grip, grasp.friction);
    if (spring_slip > 1) without_damping /= spring_slip;
    result.grasp_force = force;
    result.torque += (hold - tool.trocar).cross(force);
    result.tissue_load.add(hold - tool.trocar, force, without_damping, grasp.stiffness,
                           grasp.damping * Matrix3::Identity());
    result.grasping = true;
    result.jaw_area = grasp.area;
    result.point = hold;
    result.tissue_patch = grasp.tissue_patch;
    result.stiffness += grasp.stiffness;
    result.damping = std::max(result.damping, grasp.damping);
    state.touching = false;
    state.held = true;
    state.triangle_id = -1;
    state.stiffness = 0;
    const std::int32_t vertex = local.patch.triangle_count > 0 ? local.patch.find_vertex(grasp.vertex) : -1;
    if (vertex < 0) return;
    result.normal = surface.normal(vertex);
    filter_at(model, local.patch, tool, surface, vertex, result.normal, result);
    number_by_surface(local.patch, result.filtered);
    if (grasp.tissue_patch >= 0) result.tissue_patch = grasp.tissue_patch;
}

void press_jaws(const JawPushModel& jaws, const ToolKinematics& tool, ToolContactResult& result) {
    const Vector3 place = tool.tip - jaws.back * tool.axis;
    const Vector3 force = jaws.force + jaws.stiffness * (place - jaws.place);
    if (!(force.dot(jaws.force) > 0)) return;  // opened since: no attractive force
    result.jaw_force = force;
    result.force += force;
    result.torque += (jaws.point - tool.trocar).cross(force);
    result.tissue_load.add(jaws.point - tool.trocar, force, force, jaws.stiffness, Matrix3::Zero());
    result.stiffness += jaws.stiffness;
}

// The tissue of the largest force.
void name_tissue(const ToolContactModel& model, const LocalModel& local, ToolContactResult& result) {
    double largest = 0;
    const auto take = [&](const Vector3& force, std::int16_t tissue) {
        const double size = force.norm();
        if (size <= largest) return;
        largest = size;
        result.tissue = tissue;
    };
    take(result.surface_force, local.patch.contact.tissue);
    take(result.grasp_force, local.grasp.tissue);
    take(result.jaw_force, local.jaws.tissue);
    take(result.sheet_force, local.sheet.tissue);
    take(result.wall_force, model.wall.tissue);
    if (result.target_force.squaredNorm() > largest * largest) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(local.target_count); ++i) {
            if (local.targets[i].id == result.target) take(result.target_force, local.targets[i].tissue);
        }
    }
}

}  // namespace

ToolContactModel make_tool_contact(const Scene& scene, const InstrumentModel& instrument) {
    ToolContactModel model;
    model.instrument = instrument;
    model.filter.mode = filter_mode(scene.fidelity.filter);
    model.search_always = scene.fidelity.tool_contact == ToolContactLevel::query;
    return model;
}

void step_tool_contact(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                       std::uint32_t tick, ToolContactState& state, ToolContactScratch& scratch,
                       ToolContactResult& result) {
    result = ToolContactResult{};
    result.model_step = local.step;
    result.age = tick > local.tick ? tick - local.tick : 0;
    const double seconds = std::min(result.age * model.instrument.tick_period, longest_carry);
    if (!tool.inside || !can_touch(tool)) {
        state = ToolContactState{};
        return;
    }
    const bool has_patch = local.patch.triangle_count > 0 && local.patch.seed_triangle >= 0;
    if (has_patch || local.mode == LocalMode::grasp) {
        PatchSurface surface(local.patch, seconds, scratch);
        if (local.mode == LocalMode::grasp) {
            hold_tissue(model, local, tool, seconds, surface, state, result);
        } else if (local.mode == LocalMode::surface) {
            touch_surface(model, local, tool, surface, state, result);
        }
    }
    if (local.mode == LocalMode::none || !(has_patch || local.mode == LocalMode::grasp)) {
        state.touching = state.held = false;
        state.triangle_id = -1;
        state.stiffness = state.left_in = 0;
    }
    touch_targets(model, local, tool, result);
    touch_wall(model, local, tool, state, result);
    result.force = result.surface_force + result.grasp_force + result.target_force + result.wall_force;
    if (local.mode != LocalMode::grasp) touch_sheet(model, local, tool, result);
    if (local.jaws.tissue >= 0 && local.mode != LocalMode::grasp) press_jaws(local.jaws, tool, result);
    if (!all_finite(result)) {
        result = ToolContactResult{};
        result.model_step = local.step;
        result.lost = true;
        state = ToolContactState{};
        return;
    }
    name_tissue(model, local, result);
}

Vector3 predict_force(const ToolContactResult& last, const Vector3& motion) {
    const Vector3 force = last.force + last.stiffness * motion;
    // A contact that the motion opens exerts no force; it does not attract.
    if (!last.grasping && force.dot(last.force) < 0) return Vector3::Zero();
    return force;
}

Vector3 relax_contact_force(const Vector3& previous, const Vector3& from_tick, double contact_stiffness,
                            double tissue_stiffness) {
    const double ratio = tissue_stiffness > 0 ? std::max(0.0, contact_stiffness) / tissue_stiffness : 0.0;
    return previous + (from_tick - previous) / (1.0 + ratio);
}

}  // namespace fulcrum
