// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/couplings/septa_on_rectum.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/input_error.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/parts/sheet/sheet_part.h"

namespace fulcrum {
namespace {

constexpr double most_coupling = 0.5;  // solved in turn, the pair is stable below 4/3
constexpr double settle_time = 4.0;    // s at most in which rectum and septa come to rest together
constexpr double still = 2e-4;         // m/s, of the fastest node

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

SeptaEdge::SeptaEdge(const Scene& scene, SheetPart& septa, const Rod& rod, const RodState& state, double dt)
    : septa_(septa), arc_lengths_(septa.layout().arc_lengths) {
    const SheetLayout& layout = septa.layout();
    if (layout.driven.empty()) return;
    for (double& s : arc_lengths_) s = std::clamp(s, 0.0, rod.length());
    std::vector<DrivenVertex>& edge = septa.edge();
    edge.clear();
    for (std::size_t k = 0; k < layout.driven.size(); ++k) {
        const std::int32_t vertex = layout.driven[k];
        const Vector3& place = layout.mesh.vertices[at(vertex)];
        DrivenVertex driven;
        driven.vertex = vertex;
        driven.target = place;
        edge.push_back(driven);
        offsets_.push_back(rod.wall_offset(state, arc_lengths_[k / at(layout.columns)], place));
        arms_.push_back(Vector3::Zero());
    }
    pulls_.resize(at(layout.pieces));

    // The edge is moved by a trial step in each direction: the force that this takes beyond the rest's, over
    // the inertia of the bowel that it hangs on.
    const double displacement = 1e-6;  // m
    const auto [first, last] = std::minmax_element(arc_lengths_.begin(), arc_lengths_.end());
    const double reach = std::max(*last - *first, rod.length() / rod.segments());
    const double inertia = reach * rod.spec().linear_density / (dt * dt);
    const Vector3 at_rest = septa.trial_edge_force(-1, displacement, dt);
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3 moved = septa.trial_edge_force(axis, displacement, dt);
        coupling_ = std::max(coupling_, std::abs(moved[axis] - at_rest[axis]) / displacement / inertia);
    }
    if (!(coupling_ <= most_coupling)) {
        throw InputError(
            scene.id, "/septa",
            QT_TRANSLATE_NOOP("errors", "the septa are too stiff or heavy for the bowel's mass at this step"),
            QT_TRANSLATE_NOOP(
                "errors",
                "lower their stiffness, stiffness_damping or surface_density, or take fewer ticks_per_step"));
    }
}

void SeptaEdge::carry(const Rod& rod, const RodState& state, double dt) noexcept {
    std::vector<DrivenVertex>& edge = septa_.edge();
    for (std::size_t k = 0; k < edge.size(); ++k) {
        const double s = arc_lengths_[k / at(septa_.layout().columns)];
        const Vector3 point = rod.wall_point(state, s, offsets_[k]);
        edge[k].target = point + dt * rod.wall_velocity(state, s, offsets_[k]);
        arms_[k] = point - rod.frame_at(state, s).frame.position;
    }
}

void SeptaEdge::sum_pulls() noexcept {
    for (std::size_t i = 0; i < pulls_.size(); ++i) {
        pulls_[i] = RodLoad();
        pulls_[i].s = arc_lengths_[i];
    }
    const std::vector<DrivenVertex>& edge = septa_.edge();
    for (std::size_t k = 0; k < edge.size(); ++k) {
        RodLoad& pull = pulls_[k / at(septa_.layout().columns)];
        const Vector3 force = -edge[k].reaction;
        pull.force += force;
        pull.moment += arms_[k].cross(force);
    }
}

SeptaOnRectum::SeptaOnRectum(const Scene& scene, SheetPart& septa, BowelPart& rectum)
    : septa_(septa),
      rectum_(rectum),
      edge_(scene, septa, rectum.rod(), rectum.state(), scene.step_period()) {}

const Part& SeptaOnRectum::carried() const {
    return septa_;
}
const Part& SeptaOnRectum::carrier() const {
    return rectum_;
}

void SeptaOnRectum::carry(double dt) noexcept {
    edge_.carry(rectum_.rod(), rectum_.state(), dt);
}

void SeptaOnRectum::pull() noexcept {
    edge_.sum_pulls();
    for (const RodLoad& load : edge_.pulls()) rectum_.add_load(load);
}

void SeptaOnRectum::settle(double dt) {
    const SheetAction no_tool[hand_count];
    const ToolAction nothing[hand_count];
    const int steps = static_cast<int>(settle_time / dt);
    for (int i = 0; i < steps; ++i) {
        rectum_.apply(nothing, 0, dt);
        carry(dt);
        septa_.step(no_tool, 0, dt);
        pull();
        rectum_.solve(nothing, 0, dt);
        double fastest = 0;
        for (const Vector3& velocity : rectum_.state().velocities)
            fastest = std::max(fastest, velocity.norm());
        if (i > 100 && fastest < still) break;
    }
    septa_.stop();
    rectum_.stop();
}

std::unique_ptr<Coupling> build_septa_on_rectum(const Scene& scene, const PartList& parts) {
    auto* septa = find_part<SheetPart>(parts);
    auto* rectum = find_part<BowelPart>(parts);
    if (septa == nullptr || rectum == nullptr) return nullptr;
    return std::make_unique<SeptaOnRectum>(scene, *septa, *rectum);
}

}  // namespace fulcrum
