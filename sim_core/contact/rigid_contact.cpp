// SPDX-License-Identifier: Apache-2.0
#include "sim_core/contact/rigid_contact.h"

#include <algorithm>
#include <cmath>

#include "sim_core/contact/contact_response.h"
#include "sim_core/contact/patch_surface.h"
#include "sim_core/contact/surface_walk.h"
#include "sim_core/geometry/closest_point.h"
#include "sim_core/instrument/tool_shapes.h"
#include "sim_core/rigid/targets.h"

namespace fulcrum {
namespace {

constexpr double wall_shaft =
    0.040;  // m of the shaft behind the tip that touch the wall; the rest is in the trocar
constexpr double wall_search = 0.020;     // m around the tip that a lost contact is searched in
constexpr double wall_curvature = 0.030;  // m

constexpr double shaft_friction = 0.1;  // between two shafts

// Solid fraction of the wall at a point: 0 on an open border, 1 from the next row of triangles on, so that a
// tip sliding over the border is released gradually.
double solid_share(const CavityModel& wall, std::int32_t triangle, const Vector3& barycentric) {
    const MeshAdjacency& adjacency = wall.adjacency();
    const auto on_rim = [&](std::int32_t vertex) {
        for (const std::int32_t t : adjacency.triangles_of(vertex)) {
            const Triangle& corner = wall.mesh().triangles[static_cast<std::size_t>(t)];
            for (std::size_t e = 0; e < 3; ++e) {
                if (corner[e] != vertex && corner[(e + 1) % 3] != vertex) continue;
                if (adjacency.triangle_neighbours[3 * static_cast<std::size_t>(t) + e] < 0) return true;
            }
        }
        return false;
    };
    const Triangle& corner = wall.mesh().triangles[static_cast<std::size_t>(triangle)];
    double share = 1;
    for (int k = 0; k < 3; ++k) {
        if (on_rim(corner[static_cast<std::size_t>(k)])) share -= barycentric[k];
    }
    return std::clamp(share, 0.0, 1.0);
}

}  // namespace

void touch_targets(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                   ToolContactResult& result) {
    double nearest = 1e9;
    for (std::size_t i = 0; i < static_cast<std::size_t>(local.target_count); ++i) {
        const TargetModel& target = local.targets[i];
        const SphereDepthResult found =
            sphere_depth(tool.tip, model.instrument.tip_radius, target.centre, target.radius);
        if (-found.depth < nearest) {
            nearest = -found.depth;
            result.target = target.id;
        }
        if (!(found.depth > 0)) continue;
        result.touching_target = true;
        if (!target.solid) continue;
        ContactResponse response;
        response.stiffness = target.stiffness;
        response.damping = target.damping;
        response.friction = 0.2;
        response.onset_depth = model.onset_depth;
        const Vector3 force = response.force_on_tissue(found.depth, found.normal, tool.tip_velocity);
        result.target_force += force;
        const Vector3 arm = target.centre + target.radius * found.normal - tool.trocar;
        const Matrix3 stiffness = target.stiffness * found.normal * found.normal.transpose();
        result.touches.add(found.normal, found.depth);
        result.torque += arm.cross(force);
        result.tissue_load.add(arm, force, response.spring_force(found.depth, found.normal), stiffness,
                               target.damping * Matrix3::Identity());
        result.stiffness += stiffness;
        result.damping = std::max(result.damping, target.damping);
    }
    result.target_distance = nearest;
    if (!result.touching_target) result.target = -1;
}

void touch_wall(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                ToolContactState& state, ToolContactResult& result) {
    if (model.cavity == nullptr) return;
    const auto count = static_cast<std::int32_t>(model.cavity->triangles().size());
    WallSurface surface(*model.cavity);
    WalkOptions options;
    options.curvature_radius = wall_curvature;
    const double length = std::min(wall_shaft, tool.insertion);  // m of the shaft that touch
    const Vector3 behind = tool.tip - length * tool.axis;
    WalkPoint walk;
    walk.at_border = true;
    const auto walk_from = [&](std::int32_t triangle, const Vector3& barycentric, double fraction) {
        WalkPoint found;
        found.at_border = true;
        if (triangle < 0 || triangle >= count) return found;
        found.triangle = triangle;
        found.barycentric = barycentric;
        found.shaft = fraction;
        walk_surface(surface, behind, tool.tip, options, found);
        return found;
    };
    // From where it ended in the last tick, along the shaft as well: from the tip it would not come back in
    // the iterations of a tick where the triangles are small, and the contact would come and go.
    if (state.wall_triangle >= 0)
        walk = walk_from(state.wall_triangle, state.wall_barycentric,
                         length > 0 ? 1 - state.wall_behind / length : 1);
    if (walk.at_border || !state.touching_wall) {
        const WalkPoint seeded = walk_from(local.cavity_seed, Vector3::Constant(1.0 / 3), 1);
        if (walk.at_border || (!seeded.at_border && seeded.distance < walk.distance)) walk = seeded;
    }
    if (walk.at_border && state.touching_wall) {
        // Lost, for example at a fan of slivers: use the exact closest point of the tip until the walk
        // recovers.
        const CavityPoint exact = model.cavity->closest(tool.tip, wall_search);
        walk = walk_from(exact.triangle, Vector3::Constant(1.0 / 3), 1);
        if (walk.at_border && exact.triangle >= 0) {
            walk.at_border = false;
            const CavityTriangle& corner =
                model.cavity->triangles()[static_cast<std::size_t>(exact.triangle)];
            walk.triangle = exact.triangle;
            walk.barycentric =
                closest_point_on_triangle(exact.position, corner.a, corner.b, corner.c).barycentric;
            walk.shaft = 1;  // it is the tip's
            walk.position = exact.position;
            walk.normal = exact.normal;
            walk.distance = exact.distance;
        }
    }
    state.touching_wall = false;
    if (walk.at_border) {
        state.wall_triangle = -1;
        return;
    }
    state.wall_triangle = walk.triangle;
    state.wall_barycentric = walk.barycentric;
    state.wall_behind = (1 - walk.shaft) * length;
    const double depth = model.instrument.tip_radius - walk.distance;
    if (!(depth > 0)) return;
    state.touching_wall = true;
    const double solid = solid_share(*model.cavity, walk.triangle, walk.barycentric);
    const double stiffness = solid * model.wall.most_stiffness;
    ContactResponse response;
    response.stiffness = stiffness;
    response.damping = solid * model.wall.damping;
    response.friction = model.wall.friction;
    response.onset_depth = model.onset_depth;
    // The fraction of the whole shaft: the walk's is that of its last part.
    const double shaft = 1 - (1 - walk.shaft) * length / tool.insertion;
    result.wall_force = response.force_on_tissue(depth, walk.normal, tool.sliding_velocity(shaft));
    const Vector3 arm = walk.position - tool.trocar;
    const Matrix3 slope = stiffness * walk.normal * walk.normal.transpose();
    result.torque += arm.cross(result.wall_force);
    result.tissue_load.add(arm, result.wall_force, response.spring_force(depth, walk.normal), slope,
                           response.damping * Matrix3::Identity());
    result.touches.add(walk.normal, solid * depth, shaft);
    result.touching_wall = true;
    result.stiffness += slope;
    result.damping = std::max(result.damping, response.damping);
}

void seed_wall(const CavityModel* cavity, const ToolKinematics& tool, double reach, LocalModel& model) {
    model.cavity_seed = cavity != nullptr && tool.inside ? cavity->closest(tool.tip, reach).triangle : -1;
}

namespace {

// The fractions of both shafts nearest to a point on a jaw.
SegmentPair fractions_at(const Vector3& point, const ToolKinematics& left, const ToolKinematics& right) {
    SegmentPair pair;
    pair.s = closest_points_of_segments(left.trocar, left.tip, point, point).s;
    pair.t = closest_points_of_segments(right.trocar, right.tip, point, point).s;
    return pair;
}

}  // namespace

double collide_tools(const ToolContactModel& left, const ToolKinematics& left_tool,
                     const ToolContactModel& right, const ToolKinematics& right_tool, ToolPairState& state,
                     ToolContactResult& left_result, ToolContactResult& right_result) {
    const ToolPairState before = state;
    state = ToolPairState();
    if (!left_tool.inside || !right_tool.inside) return -1.0;
    const SolidContact solid =
        collide_shapes(tool_shape(left.instrument, left_tool), tool_shape(right.instrument, right_tool));
    double depth = solid.depth;
    if (!(depth > 0)) return std::isfinite(depth) ? depth : -1.0;
    Vector3 normal = solid.normal;  // out of the right tool
    const SegmentPair pair = solid.by_jaw ? fractions_at(solid.point, left_tool, right_tool)
                                          : closest_points_of_segments(left_tool.trocar, left_tool.tip,
                                                                       right_tool.trocar, right_tool.tip);
    ContactResponse response;
    response.stiffness = shaft_stiffness;
    response.damping = shaft_damping;
    response.friction = shaft_friction;
    const Vector3 velocity = left_tool.shaft_velocity(pair.s) - right_tool.shaft_velocity(pair.t);
    if (before.touching && before.normal.dot(normal) < 0) {
        // One is more than half way through the other: depth as before plus the advance since.
        normal = before.normal;
        depth = before.depth - left.instrument.tick_period * velocity.dot(normal);
        if (!(depth > 0)) return depth;
    }
    const Vector3 force = response.force_on_tissue(depth, normal, velocity);
    if (!force.allFinite()) return depth;
    state.touching = true;
    state.normal = normal;
    state.depth = depth;
    const Matrix3 stiffness = shaft_stiffness * normal * normal.transpose();
    left_result.touches.add(normal, 0.5 * depth, pair.s);
    right_result.touches.add(-normal, 0.5 * depth, pair.t);
    left_result.tool_force = force;
    right_result.tool_force = -force;
    const Vector3 without_damping = response.spring_force(depth, normal);
    const Matrix3 damping = shaft_damping * Matrix3::Identity();
    left_result.tool_load.add(solid.point - left_tool.trocar, force, without_damping, stiffness, damping);
    right_result.tool_load.add(solid.point - right_tool.trocar, -force, -without_damping, stiffness, damping);
    for (ToolContactResult* result : {&left_result, &right_result}) {
        result->force += result->tool_force;
        result->touching_tool = true;
        result->stiffness += stiffness;
        result->damping = std::max(result->damping, shaft_damping);
    }
    return depth;
}

}  // namespace fulcrum
