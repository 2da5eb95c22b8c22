// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/couplings/membranes_on_bowel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim_core/numerics/input_error.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/parts/membranes/membranes_part.h"

namespace fulcrum {
namespace {

constexpr double most_coupling = 0.5;  // solved in turn, the pair is stable below 4/3

}  // namespace

MembraneEdge::MembraneEdge(const Scene& scene, std::size_t index, MembranePart& membrane,
                           const MembraneSheet& sheet, const Rod& rod, const RodState& rest, double dt)
    : membrane_(membrane) {
    for (std::size_t k = 0; k < sheet.bowel_vertices.size(); ++k) {
        // The generator's arc length is the polyline's, the rod's its own: shares of the whole agree.
        arc_lengths_.push_back(std::clamp(sheet.bowel_arc_lengths[k], 0.0, rod.length()));
        offsets_.push_back(rod.wall_offset(rest, arc_lengths_.back(), membrane.edge()[k]));
    }
    pulls_.resize(arc_lengths_.size());
    if (arc_lengths_.empty()) return;
    // The edge is moved by a trial step in each direction: the force that this takes beyond the rest's, over
    // the inertia of the bowel that it hangs on.
    const double displacement = 1e-6;  // m
    const auto [first, last] = std::minmax_element(arc_lengths_.begin(), arc_lengths_.end());
    const double reach = std::max(*last - *first, rod.length() / rod.segments());
    const double inertia = reach * rod.spec().linear_density / (dt * dt);
    const Vector3 at_rest = membrane.trial_edge_force(-1, displacement, dt);
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3 moved = membrane.trial_edge_force(axis, displacement, dt);
        coupling_ = std::max(coupling_, std::abs(moved[axis] - at_rest[axis]) / displacement / inertia);
    }
    if (!(coupling_ <= most_coupling)) {
        throw InputError(
            scene.id, "/membranes/" + std::to_string(index),
            QT_TRANSLATE_NOOP("errors",
                              "the membrane is too stiff or heavy for the bowel's mass at this step"),
            QT_TRANSLATE_NOOP(
                "errors",
                "lower its stiffness, stiffness_damping or surface_density, or take fewer ticks_per_step"));
    }
}

void MembraneEdge::carry(const Rod& rod, const RodState& state, double dt) noexcept {
    for (std::size_t k = 0; k < arc_lengths_.size(); ++k) {
        membrane_.edge()[k] = rod.wall_point(state, arc_lengths_[k], offsets_[k]) +
                              dt * rod.wall_velocity(state, arc_lengths_[k], offsets_[k]);
    }
}

void MembraneEdge::sum_pulls(const Rod& rod, const RodState& state) noexcept {
    pull_.setZero();
    for (std::size_t k = 0; k < pulls_.size(); ++k) {
        RodLoad& load = pulls_[k];
        load.s = arc_lengths_[k];
        load.force = -membrane_.edge_reactions()[k];
        const RodFrame frame = rod.frame_at(state, load.s).frame;
        load.moment = (frame.rotation * offsets_[k]).cross(load.force);
        pull_ += load.force;
    }
}

MembranesOnBowel::MembranesOnBowel(const Scene& scene, MembranesPart& membranes, BowelPart& bowel)
    : membranes_(membranes), bowel_(bowel) {
    edges_.reserve(membranes.membranes().size());
    std::size_t loads = 0;
    for (std::size_t i = 0; i < membranes.membranes().size(); ++i) {
        edges_.emplace_back(scene, i, membranes.membranes()[i], membranes.layout()[i], bowel.rod(),
                            bowel.state(), scene.step_period());
        loads += edges_.back().pulls().size();
    }
    bowel.make_room_for_loads(loads);
}

const Part& MembranesOnBowel::carried() const {
    return membranes_;
}
const Part& MembranesOnBowel::carrier() const {
    return bowel_;
}

void MembranesOnBowel::carry(double dt) noexcept {
    for (MembraneEdge& edge : edges_) edge.carry(bowel_.rod(), bowel_.state(), dt);
}

void MembranesOnBowel::pull() noexcept {
    for (MembraneEdge& edge : edges_) {
        edge.sum_pulls(bowel_.rod(), bowel_.state());
        for (const RodLoad& load : edge.pulls()) bowel_.add_load(load);
    }
}

void MembranesOnBowel::follow() noexcept {
    if (bowel_.took_back()) membranes_.take_back();
}

void MembranesOnBowel::settle(double dt) {
    bowel_.lay_down([this, dt] {
        carry(dt);
        membranes_.step(dt);
        pull();
    });
    membranes_.stop();
}

std::unique_ptr<Coupling> build_membranes_on_bowel(const Scene& scene, const PartList& parts) {
    auto* membranes = find_part<MembranesPart>(parts);
    auto* bowel = find_part<BowelPart>(parts);
    if (membranes == nullptr || bowel == nullptr) return nullptr;
    return std::make_unique<MembranesOnBowel>(scene, *membranes, *bowel);
}

}  // namespace fulcrum
