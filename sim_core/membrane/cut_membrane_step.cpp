// SPDX-License-Identifier: Apache-2.0
// Symplectic Euler on the remaining sheet.
#include <algorithm>
#include <cmath>

#include "sim_core/membrane/cut_membrane.h"
#include "sim_core/membrane/membrane_system.h"

namespace fulcrum {
namespace {

constexpr double strongest = 1e9;  // N, m/s2, N/m
constexpr double farthest = 1e4;   // m
constexpr double fastest = 1e9;    // m/s

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

bool within(const Vector3& v, double limit) {
    return v.allFinite() && v.cwiseAbs().maxCoeff() <= limit;
}

bool usable(const CutMembraneState& state, const CutMembraneInputs& inputs, std::size_t vertices) {
    if (!within(inputs.gravity, strongest) || !within(inputs.isolated_gravity, strongest)) return false;
    for (const CutMembraneLink& link : inputs.links) {
        if (link.piece < 0 || at(link.piece) >= state.pieces.size() || state.pieces[at(link.piece)].root < 0)
            return false;
        if (!(link.stiffness >= 0 && link.stiffness <= strongest) || !(link.grip >= 0) ||
            !(link.friction >= 0))
            return false;
        if (!within(link.start, farthest) || !within(link.target, farthest) || !within(link.normal, 2) ||
            !within(link.barycentric, 1e3))
            return false;
    }
    for (const DrivenVertex& driven : inputs.driven) {
        if (driven.vertex < 0 || at(driven.vertex) >= vertices || !within(driven.target, farthest))
            return false;
    }
    return true;
}

bool finite(const CutMembraneState& state) {
    for (std::size_t n = 0; n < at(state.node_end); ++n) {
        if (!within(state.positions[n], farthest) || !within(state.velocities[n], fastest)) return false;
    }
    return true;
}

// Force of a link on the membrane for a displacement `displacement` (m) to its target with stiffness k.
Lanes link_force(const CutMembraneLink& link, const Lanes& displacement, double k) {
    const Lanes pull = all_lanes(k) * displacement, n = lanes_of(link.normal);
    if (!(sum_lanes(n * n) > 0)) {
        const double size = std::sqrt(sum_lanes(pull * pull));
        return size > link.grip ? all_lanes(link.grip / size) * pull : pull;
    }
    const double along = sum_lanes(pull * n);
    Lanes across = pull - all_lanes(along) * n;
    const double push = link.push ? std::min(0.0, along) : 0.0;
    const double size = std::sqrt(sum_lanes(across * across)), most = link.grip - link.friction * push;
    if (size > most) across = all_lanes(most / size) * across;
    return across + all_lanes(push) * n;
}

// Adds the links by their force at the end of the substep, one link after the other: stable for any
// stiffness. done: fraction of the step at the end of the substep.
template <class Carried>
void add_links(const CutMembraneState& state, CutMembraneInputs& inputs, double done, double h, int substeps,
               const double* inverse, const Carried& carried, Lanes* g) {
    for (CutMembraneLink& link : inputs.links) {
        const auto& corner = state.pieces[at(link.piece)].nodes;
        Lanes end = all_lanes(0);
        double give = 0;  // 1/kg, mobility of the point
        for (int c = 0; c < 3; ++c) {
            const std::size_t n = at(corner[at(c)]);
            end += all_lanes(link.barycentric[c]) * carried(n);
            give += link.barycentric[c] * link.barycentric[c] * inverse[n];
        }
        const Lanes target = lanes_of(link.start + done * (link.target - link.start));
        const Lanes force =
            link_force(link, target - end, link.stiffness / (1 + h * h * link.stiffness * give));
        for (int c = 0; c < 3; ++c) g[at(corner[at(c)])] -= all_lanes(link.barycentric[c]) * force;
        link.reaction += vector_of(force) / substeps;
    }
}

void store(const Lanes* x, const Lanes* v, std::size_t nodes, CutMembraneState& state) {
    for (std::size_t n = 0; n < nodes; ++n) {
        state.positions[n] = vector_of(x[n]);
        state.velocities[n] = vector_of(v[n]);
    }
}

// Restores the positions of the step's start, at rest.
void freeze(CutMembraneState& state, CutMembraneInputs& inputs, const std::vector<Vector3>& good,
            std::size_t nodes, MembraneReport& report) {
    for (std::size_t n = 0; n < nodes; ++n) {
        state.positions[n] = good[n];
        state.velocities[n].setZero();
    }
    for (CutMembraneLink& link : inputs.links) link.reaction.setZero();
    for (DrivenVertex& driven : inputs.driven) driven.reaction.setZero();
    report.fault = MembraneFault::frozen;
    report.finite = report.converged = false;
}

}  // namespace

MembraneReport CutMembrane::step(CutMembraneState& state, CutMembraneInputs& inputs, double dt,
                                 CutMembraneScratch& scratch, int most_substeps) const noexcept {
    MembraneReport report;
    for (CutMembraneLink& link : inputs.links) link.reaction.setZero();
    for (DrivenVertex& driven : inputs.driven) driven.reaction.setZero();
    const double wanted = std::ceil(dt / (0.98 * safe_time_step()));
    report.finite = usable(state, inputs, rest_.size()) && finite(state);
    if (!report.finite || !(dt >= 1e-9 && dt <= 1) || !(wanted <= most_substeps)) {
        report.fault = MembraneFault::refused;
        report.converged = false;
        return report;
    }
    report.substeps = std::max(1, static_cast<int>(wanted));
    const double h = dt / report.substeps;
    const std::size_t nodes = at(state.node_end);
    Lanes *x = scratch.position_.data(), *v = scratch.velocity_.data(), *g = scratch.gradient_.data();
    double *inverse = scratch.inverse_mass_.data(), *anchor = scratch.anchor_.data();
    for (std::size_t i = 0; i < inputs.driven.size(); ++i)
        scratch.driven_[at(inputs.driven[i].vertex)] = static_cast<std::int32_t>(i);
    scratch.driven_nodes_.clear();
    for (std::size_t n = 0; n < nodes; ++n) {
        scratch.good_[n] = state.positions[n];
        x[n] = lanes_of(state.positions[n]);
        v[n] = lanes_of(state.velocities[n]);
        inverse[n] = state.masses[n] > 0 ? 1 / state.masses[n] : 0;
        anchor[n] = 0;
        if (state.held[n] == 0 || state.vertex[n] < 0) continue;
        const std::size_t vertex = at(state.vertex[n]);
        if (std::isfinite(attachment_[vertex])) {
            anchor[n] = attachment_[vertex] * state.masses[n] / vertex_mass_[vertex];
        } else {
            inverse[n] = 0;
            v[n] = all_lanes(0);
            const std::int32_t number = scratch.driven_[vertex];
            if (number < 0) continue;
            DrivenVertex& driven = inputs.driven[at(number)];
            const Vector3 velocity = (driven.target - state.positions[n]) / dt;
            v[n] = lanes_of(velocity);
            driven.reaction += state.masses[n] / dt * (velocity - state.velocities[n]);
            scratch.driven_nodes_.emplace_back(static_cast<std::int32_t>(n), number);
        }
    }
    for (const DrivenVertex& driven : inputs.driven) scratch.driven_[at(driven.vertex)] = -1;
    const Lanes weight[2] = {lanes_of(inputs.gravity), lanes_of(inputs.isolated_gravity)};
    const membrane_detail::SpringEnds ends{state.first.data(), state.second.data(), at(state.spring_end)};
    const Lanes step = all_lanes(h);
    const auto carried = [&](std::size_t n) {  // position of the node with the forces so far
        return x[n] + step * (v[n] - all_lanes(h * inverse[n]) * g[n]);
    };
    for (int k = 0; k < report.substeps; ++k) {
        for (std::size_t n = 0; n < nodes; ++n)
            g[n] = all_lanes(state.masses[n]) *
                   (all_lanes(material_.mass_damping) * v[n] - weight[state.isolated[n]]);
        membrane_detail::add_damped_springs(ends, state.stiffness.data(), state.rest.data(),
                                            material_.stiffness_damping, x, v, g);
        for (std::size_t n = 0; n < nodes; ++n) {
            if (!(anchor[n] > 0)) continue;
            const double share = anchor[n] / (1 + h * h * anchor[n] * inverse[n]);
            g[n] -= all_lanes(share) * (lanes_of(rest_[at(state.vertex[n])]) - carried(n));
        }
        add_links(state, inputs, static_cast<double>(k + 1) / report.substeps, h, report.substeps, inverse,
                  carried, g);
        for (const auto& [node, number] : scratch.driven_nodes_)
            inputs.driven[at(number)].reaction += vector_of(g[at(node)]) / report.substeps;
        for (std::size_t n = 0; n < nodes; ++n) {
            v[n] -= all_lanes(h * inverse[n]) * g[n];
            x[n] += step * v[n];
        }
    }
    store(x, v, nodes, state);
    if (!finite(state)) freeze(state, inputs, scratch.good_, nodes, report);
    return report;
}

}  // namespace fulcrum
