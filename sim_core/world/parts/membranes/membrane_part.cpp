// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/membranes/membrane_part.h"

#include <algorithm>
#include <string>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/world/part/sheet_material.h"

namespace fulcrum {
namespace {

constexpr double most_coupling = 0.5;  // solved in turn, the pair is stable below 4/3

std::vector<std::int32_t> held(const MembraneSheet& sheet) {
    std::vector<std::int32_t> vertices = sheet.bowel_vertices;
    vertices.insert(vertices.end(), sheet.wall_vertices.begin(), sheet.wall_vertices.end());
    return vertices;
}

MembraneSolve solve_of(const Fidelity& fidelity) {
    MembraneSolve solve;
    if (fidelity.membrane == MembraneIntegrator::symplectic) {
        solve.integrator = MembraneIntegrator::symplectic;
    } else if (fidelity.membrane == MembraneIntegrator::implicit) {
        solve.integrator = MembraneIntegrator::implicit;
        solve.tolerance = 1e-8;
        solve.iterations = 200;
    } else {
        solve.iterations = fidelity.membrane_iterations;
    }
    return solve;
}

std::uint32_t outcome_of(MembraneFault fault) {
    switch (fault) {
        case MembraneFault::none:
        case MembraneFault::substepped:
            return 0;  // dividing the step is how symplectic Euler works
        case MembraneFault::unconverged:
            return 1;
        case MembraneFault::refused:
        case MembraneFault::frozen:
            return 2;
    }
    return 2;
}

}  // namespace

MembranePart::MembranePart(const Scene& scene, std::size_t index, const MembraneSheet& sheet, const Rod& rod,
                           const RodState& rest, double dt)
    : membrane_(sheet.mesh, sheet_material(scene.membranes[index], sheet.mesh), held(sheet)),
      state_(membrane_.make_state()),
      good_(state_),
      scratch_(membrane_.make_scratch(dt)),
      solve_(solve_of(scene.fidelity)) {
    inputs_.gravity = scene.membranes[index].weight * scene.gravity;
    inputs_.holds.reserve(3 * hand_count);
    inputs_.reactions.resize(membrane_.attached().size(), Vector3::Zero());
    for (const std::int32_t v : membrane_.attached())
        inputs_.attachments.push_back(sheet.mesh.vertices[static_cast<std::size_t>(v)]);
    for (std::size_t k = 0; k < sheet.bowel_vertices.size(); ++k) {
        // The generator's arc length is the polyline's, the rod's its own: shares of the whole agree.
        arc_lengths_.push_back(std::clamp(sheet.bowel_arc_lengths[k], 0.0, rod.length()));
        offsets_.push_back(rod.wall_offset(rest, arc_lengths_.back(), inputs_.attachments[k]));
    }
    check_coupling(scene, index, rod, dt);
}

void MembranePart::check_coupling(const Scene& scene, std::size_t index, const Rod& rod, double dt) {
    if (arc_lengths_.empty()) return;
    // The edge is moved by a trial step in each direction: the force that this takes beyond the rest's, over
    // the inertia of the bowel that it hangs on.
    const double way = 1e-6;  // m
    const double reach = *std::max_element(arc_lengths_.begin(), arc_lengths_.end()) -
                         *std::min_element(arc_lengths_.begin(), arc_lengths_.end());
    const double inertia =
        std::max(reach, rod.length() / rod.segments()) * rod.spec().linear_density / (dt * dt);
    MembraneSolve exact;
    exact.integrator = MembraneIntegrator::implicit;
    exact.tolerance = 1e-6;
    Vector3 still = Vector3::Zero();
    for (int axis = -1; axis < 3; ++axis) {
        MembraneState trial = state_;
        MembraneInputs inputs = inputs_;
        if (axis >= 0) {
            for (std::size_t k = 0; k < arc_lengths_.size(); ++k) inputs.attachments[k][axis] += way;
        }
        membrane_.step(trial, inputs, dt, scratch_, exact);
        Vector3 sum = Vector3::Zero();
        for (std::size_t k = 0; k < arc_lengths_.size(); ++k) sum += inputs.reactions[k];
        if (axis < 0) {
            still = sum;
        } else {
            coupling_ = std::max(coupling_, std::abs(sum[axis] - still[axis]) / way / inertia);
        }
    }
    if (!(coupling_ <= most_coupling)) {
        throw InputError(
            scene.id, "/membranes/" + std::to_string(index),
            "the membrane is too stiff or heavy for the bowel's mass at this step",
            "lower its stiffness, stiffness_damping or surface_density, or take fewer ticks_per_step");
    }
}

std::uint32_t MembranePart::step(const Rod& rod, const RodState& state, double dt,
                                 std::vector<RodLoad>& loads) noexcept {
    good_.positions = state_.positions;
    for (std::size_t k = 0; k < arc_lengths_.size(); ++k) {
        inputs_.attachments[k] = rod.wall_point(state, arc_lengths_[k], offsets_[k]) +
                                 dt * rod.wall_velocity(state, arc_lengths_[k], offsets_[k]);
    }
    fill_holds();
    report_ = membrane_.step(state_, inputs_, dt, scratch_, solve_);
    read_holds();
    pull_.setZero();
    for (std::size_t k = 0; k < arc_lengths_.size() && loads.size() < loads.capacity(); ++k) {
        RodLoad load;
        load.s = arc_lengths_[k];
        load.force = -inputs_.reactions[k];
        const RodFrame frame = rod.frame_at(state, load.s).frame;
        load.moment = (frame.rotation * offsets_[k]).cross(load.force);
        pull_ += load.force;
        loads.push_back(load);
    }
    return outcome_of(report_.fault);
}

std::int32_t MembranePart::nearest_triangle(const Vector3& point, double& least,
                                            Vector3& closest) const noexcept {
    std::int32_t nearest = -1;
    const auto& triangles = membrane_.triangles();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle& corners = triangles[t];
        const auto at = [&](std::size_t c) -> const Vector3& {
            return state_.positions[static_cast<std::size_t>(corners[c])];
        };
        const Vector3 found = closest_point_on_triangle(point, at(0), at(1), at(2)).position;
        const double distance = (found - point).squaredNorm();
        if (distance >= least || !membrane_.any_free(corners)) continue;
        least = distance;
        nearest = static_cast<std::int32_t>(t);
        closest = found;
    }
    return nearest;
}

void MembranePart::take(int hand, std::int32_t triangle, const Vector3& point, double stiffness) noexcept {
    Hold& hold = holds_[hand];
    hold.grip = SheetGrip();
    hold.grip.held = true;
    hold.grip.triangle = triangle;
    hold.grip.point = hold.target = point;
    hold.stiffness = stiffness;
    const Triangle& corners = membrane_.triangles()[static_cast<std::size_t>(triangle)];
    for (std::size_t c = 0; c < 3; ++c)
        hold.offsets[c] = state_.positions[static_cast<std::size_t>(corners[c])] - point;
}

void MembranePart::carry(int hand, const Vector3& target) noexcept {
    holds_[hand].target = target;
}

void MembranePart::let_go(int hand) noexcept {
    holds_[hand].grip = SheetGrip();
}

double MembranePart::grip_stiffness(int hand) const noexcept {
    const Hold& hold = holds_[hand];
    if (!hold.grip.held) return 0;
    const Triangle& corners = membrane_.triangles()[static_cast<std::size_t>(hold.grip.triangle)];
    double springs = 0;
    for (std::size_t s = 0; s < membrane_.springs().size(); ++s) {
        if (state_.cut[s] != 0) continue;
        const MembraneSpring& spring = membrane_.springs()[s];
        const auto held = [&](std::int32_t v) {
            return v == corners[0] || v == corners[1] || v == corners[2];
        };
        if (held(spring.first) != held(spring.second)) springs += spring.stiffness;
    }
    const double both = springs + hold.stiffness;
    return both > 0 ? springs * hold.stiffness / both : 0;
}

void MembranePart::fill_holds() noexcept {
    inputs_.holds.clear();
    for (const Hold& hold : holds_) {
        if (!hold.grip.held) continue;
        const Triangle& corners = membrane_.triangles()[static_cast<std::size_t>(hold.grip.triangle)];
        for (std::size_t c = 0; c < 3; ++c) {
            MembraneHold corner;
            corner.vertex = corners[c];
            corner.stiffness = hold.stiffness / 3;
            corner.target = hold.target + hold.offsets[c];
            inputs_.holds.push_back(corner);
        }
    }
}

void MembranePart::read_holds() noexcept {
    std::size_t k = 0;
    for (Hold& hold : holds_) {
        if (!hold.grip.held) continue;
        hold.grip.point.setZero();
        hold.grip.reaction.setZero();
        for (std::size_t c = 0; c < 3; ++c, ++k) {
            const MembraneHold& corner = inputs_.holds[k];
            hold.grip.reaction += corner.reaction;
            hold.grip.point +=
                (state_.positions[static_cast<std::size_t>(corner.vertex)] - hold.offsets[c]) / 3;
        }
    }
}

void MembranePart::take_back() noexcept {
    state_.positions = good_.positions;
    stop();
}

void MembranePart::stop() noexcept {
    Membrane::stop(state_);
}

void MembranePart::size_snapshot(MembraneView& view) const {
    view.positions.resize(state_.positions.size());
    view.triangles = membrane_.triangles();
}

void MembranePart::fill_snapshot(MembraneView& view) const noexcept {
    std::copy(state_.positions.begin(), state_.positions.end(), view.positions.begin());
    view.topology = state_.topology;
}

void MembranePart::list_state(StateList& list) {
    list.hashed(state_.positions).hashed(state_.velocities).kept(state_.cut).hashed(state_.topology);
    list.hashed(holds_, [this](StateHash& hash) {
        for (const Hold& hold : holds_) {
            hash.add(static_cast<std::int64_t>(hold.grip.triangle));
            hash.add(hold.target);
            hash.add(hold.grip.reaction);
        }
    });
    // The solver remembers its matrix, what is held in it, and its last steps.
    list.kept(scratch_).kept(inputs_).kept(report_).kept(pull_);
}

std::size_t MembranePart::bytes() const {
    return membrane_.bytes() + scratch_.bytes() + 4 * state_.positions.capacity() * sizeof(Vector3) +
           offsets_.capacity() * (sizeof(Vector3) + sizeof(double));
}

}  // namespace fulcrum
