// SPDX-License-Identifier: Apache-2.0
// Septa on the rectum: their edge carried by the rod's wall points, their pull on it.
#include <algorithm>
#include <cmath>

#include "sim_core/numerics/input_error.h"
#include "sim_core/world/parts/sheet/sheet_part.h"

namespace fulcrum {
namespace {

constexpr double most_coupling = 0.5;  // solved in turn, the pair is stable below 4/3

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

void SheetPart::hang_on(const Scene& scene, const Rod& rod, const RodState& state, double dt) {
    if (layout_.driven.empty()) return;
    for (double& s : layout_.arc_lengths) s = std::clamp(s, 0.0, rod.length());
    inputs_.driven.clear();
    for (std::size_t k = 0; k < layout_.driven.size(); ++k) {
        const std::int32_t vertex = layout_.driven[k];
        const Vector3& place = layout_.mesh.vertices[at(vertex)];
        DrivenVertex driven;
        driven.vertex = vertex;
        driven.target = place;
        inputs_.driven.push_back(driven);
        offsets_.push_back(rod.wall_offset(state, layout_.arc_lengths[k / at(layout_.columns)], place));
        arms_.push_back(Vector3::Zero());
    }
    pulls_.resize(at(layout_.pieces));

    // The edge is moved by a trial step in each direction: the force that this takes beyond the rest's, over
    // the inertia of the bowel that it hangs on.
    const double way = 1e-6;  // m
    const auto [first, last] = std::minmax_element(layout_.arc_lengths.begin(), layout_.arc_lengths.end());
    const double reach = std::max(*last - *first, rod.length() / rod.segments());
    const double inertia = reach * rod.spec().linear_density / (dt * dt);
    Vector3 still = Vector3::Zero();
    for (int axis = -1; axis < 3; ++axis) {
        CutMembraneState trial = state_.membrane;
        CutMembraneInputs inputs = inputs_;
        for (DrivenVertex& driven : inputs.driven) {
            if (axis >= 0) driven.target[axis] += way;
        }
        membrane_.step(trial, inputs, dt, scratch_);
        Vector3 sum = Vector3::Zero();
        for (const DrivenVertex& driven : inputs.driven) sum += driven.reaction;
        if (axis < 0) {
            still = sum;
        } else {
            coupling_ = std::max(coupling_, std::abs(sum[axis] - still[axis]) / way / inertia);
        }
    }
    if (!(coupling_ <= most_coupling)) {
        throw InputError(
            scene.id, "/septa", "the septa are too stiff or heavy for the bowel's mass at this step",
            "lower their stiffness, stiffness_damping or surface_density, or take fewer ticks_per_step");
    }
}

void SheetPart::carry_edge(const Rod& rod, const RodState& state, double dt) noexcept {
    for (std::size_t k = 0; k < inputs_.driven.size(); ++k) {
        const double s = layout_.arc_lengths[k / at(layout_.columns)];
        const Vector3 point = rod.wall_point(state, s, offsets_[k]);
        inputs_.driven[k].target = point + dt * rod.wall_velocity(state, s, offsets_[k]);
        arms_[k] = point - rod.frame_at(state, s).frame.position;
    }
}

void SheetPart::sum_pulls() noexcept {
    for (std::size_t i = 0; i < pulls_.size(); ++i) {
        pulls_[i] = RodLoad();
        pulls_[i].s = layout_.arc_lengths[i];
    }
    for (std::size_t k = 0; k < inputs_.driven.size(); ++k) {
        RodLoad& pull = pulls_[k / at(layout_.columns)];
        const Vector3 force = -inputs_.driven[k].reaction;
        pull.force += force;
        pull.moment += arms_[k].cross(force);
    }
}

void SheetPart::stop() noexcept {
    for (Vector3& v : state_.membrane.velocities) v.setZero();
}

}  // namespace fulcrum
