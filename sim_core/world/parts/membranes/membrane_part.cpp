// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/membranes/membrane_part.h"

#include <algorithm>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/world/part/sheet_material.h"

namespace fulcrum {
namespace {

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

MembranePart::MembranePart(const Scene& scene, std::size_t index, const MembraneSheet& sheet, double dt)
    : membrane_(sheet.mesh, sheet_material(scene.membranes[index], sheet.mesh), held(sheet)),
      state_(membrane_.make_state()),
      good_(state_),
      scratch_(membrane_.make_scratch(dt)),
      solve_(solve_of(scene.fidelity)),
      attachments_(sheet.bowel_vertices.size()) {
    inputs_.gravity = scene.membranes[index].weight * scene.gravity;
    inputs_.holds.reserve(3 * hand_count);
    inputs_.reactions.resize(membrane_.attached().size(), Vector3::Zero());
    for (const std::int32_t v : membrane_.attached())
        inputs_.attachments.push_back(sheet.mesh.vertices[static_cast<std::size_t>(v)]);
}

Vector3 MembranePart::trial_edge_force(int axis, double displacement, double dt) {
    MembraneSolve exact;
    exact.integrator = MembraneIntegrator::implicit;
    exact.tolerance = 1e-6;
    MembraneState trial = state_;
    MembraneInputs inputs = inputs_;
    if (axis >= 0) {
        for (std::size_t k = 0; k < attachments_; ++k) inputs.attachments[k][axis] += displacement;
    }
    membrane_.step(trial, inputs, dt, scratch_, exact);
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < attachments_; ++k) sum += inputs.reactions[k];
    return sum;
}

std::uint32_t MembranePart::step(double dt) noexcept {
    good_.positions = state_.positions;
    fill_holds();
    report_ = membrane_.step(state_, inputs_, dt, scratch_, solve_);
    read_holds();
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

double MembranePart::area_in(const JawBox& box) const noexcept {
    double area = 0;
    for (const Triangle& triangle : membrane_.triangles()) {
        const auto at = [&](std::size_t c) -> const Vector3& {
            return state_.positions[static_cast<std::size_t>(triangle[c])];
        };
        if (box.contains((at(0) + at(1) + at(2)) / 3)) area += (at(1) - at(0)).cross(at(2) - at(0)).norm();
    }
    return area;
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
    list.kept(scratch_).kept(inputs_).kept(report_);
}

std::size_t MembranePart::bytes() const {
    return membrane_.bytes() + scratch_.bytes() + 4 * state_.positions.capacity() * sizeof(Vector3);
}

}  // namespace fulcrum
