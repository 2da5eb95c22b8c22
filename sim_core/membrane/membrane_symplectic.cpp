// SPDX-License-Identifier: Apache-2.0
// Symplectic Euler and its step limit.
#include <algorithm>
#include <cmath>

#include "sim_core/membrane/membrane_system.h"

namespace fulcrum {
namespace membrane_detail {

double bounding_eigenvalue(const Membrane::Tables& tables, const double* stiffness, Data& data) {
    // In every shape a spring's tangent is below stiffness times the identity, so the tangent is below the
    // springs' Laplacian, and that is below the same matrix with positive entries; for a positive vector u
    // the largest ratio (B u)_i / (m_i u_i) bounds its spectrum (Collatz and Wielandt). Power iteration only
    // improves u.
    const auto free = static_cast<std::size_t>(tables.free);
    if (free == 0) return 0;
    std::vector<double>&u = data.diagonal, &b = data.inertia;  // every step sets both again
    for (std::size_t i = 0; i < free; ++i) u[i] = 1;
    double bound = 0;
    for (int round = 0; round < 24; ++round) {
        std::fill(b.begin(), b.end(), 0.0);
        for (std::size_t s = 0; s < tables.first.size(); ++s) {
            const auto i = static_cast<std::size_t>(tables.first[s]),
                       j = static_cast<std::size_t>(tables.second[s]);
            const double sum = stiffness[s] * ((i < free ? u[i] : 0.0) + (j < free ? u[j] : 0.0));
            b[i] += sum;
            b[j] += sum;
        }
        double largest = 0;
        for (std::size_t i = 0; i < free; ++i) largest = std::max(largest, b[i] / (tables.mass[i] * u[i]));
        bound = round == 0 ? largest : std::min(bound, largest);
        if (!(largest > 0)) return 0;
        for (std::size_t i = 0; i < free; ++i) u[i] = std::max(b[i] / (tables.mass[i] * largest), 1e-6);
    }
    return bound;
}

double stable_step(double frequency, double damping_ratio) {
    if (!(frequency > 0)) return INFINITY;
    return 2 / frequency * (std::sqrt(1 + damping_ratio * damping_ratio) - damping_ratio);
}

void step_symplectic(const Membrane& membrane, MembraneInputs& inputs, double safe_limit, double dt,
                     const MembraneSolve& solve, MembraneReport& report, Data& d) {
    const Membrane::Tables& t = membrane.tables();
    const MembraneMaterial& material = membrane.material();
    const double wanted = std::ceil(dt / (0.98 * safe_limit));
    if (!(wanted <= solve.most_substeps)) {
        report.fault = MembraneFault::refused;
        report.converged = false;
        return;
    }
    report.substeps = std::max(1, static_cast<int>(wanted));
    if (report.substeps > 1) report.fault = MembraneFault::substepped;
    const double h = dt / report.substeps;
    for (std::int32_t n = t.free; n < t.nodes; ++n)
        d.start_velocity[at(n)] = all_lanes(1 / dt) * (d.position[at(n)] - d.start[at(n)]);
    // d.position holds the attachments' targets; d.trial is the moving state.
    std::copy(d.start.begin(), d.start.end(), d.trial.begin());
    for (int k = 0; k < report.substeps; ++k) {
        for (std::int32_t n = 0; n < t.nodes; ++n) {
            d.gradient[at(n)] =
                all_lanes(material.mass_damping * t.mass[at(n)]) * d.start_velocity[at(n)] - d.load[at(n)];
        }
        add_damped_springs({t.first.data(), t.second.data(), t.first.size()}, d.stiffness.data(),
                           d.rest.data(), material.stiffness_damping, d.trial.data(), d.start_velocity.data(),
                           d.gradient.data());
        const double share = static_cast<double>(k + 1) / report.substeps;
        // A held node is pulled by its spring's force at the end of the substep: stable for any stiffness. If
        // two jaws hold a node, they act one after the other.
        for (MembraneHold& hold : inputs.holds) {
            const std::int32_t node = t.node_of[at(hold.vertex)];
            if (k == 0) hold.reaction.setZero();
            if (node >= t.free) continue;
            const std::size_t n = at(node);
            const Lanes target = d.start[n] + all_lanes(share) * (lanes_of(hold.target) - d.start[n]);
            const Lanes end =
                d.trial[n] + all_lanes(h) * (d.start_velocity[n] - all_lanes(h / t.mass[n]) * d.gradient[n]);
            const Lanes force =
                all_lanes(hold.stiffness / (1 + h * h * hold.stiffness / t.mass[n])) * (target - end);
            d.gradient[n] -= force;
            hold.reaction += vector_of(force) / report.substeps;
        }
        for (std::int32_t n = 0; n < t.free; ++n) {
            d.start_velocity[at(n)] -= all_lanes(h / t.mass[at(n)]) * d.gradient[at(n)];
            d.trial[at(n)] += all_lanes(h) * d.start_velocity[at(n)];
        }
        for (std::int32_t n = t.free; n < t.nodes; ++n)
            d.trial[at(n)] = d.start[at(n)] + all_lanes(share) * (d.position[at(n)] - d.start[at(n)]);
        for (std::int32_t n = t.free; n < t.nodes; ++n)  // mean force on attached nodes
            d.residual[at(n)] = (k == 0 ? all_lanes(0) : d.residual[at(n)]) + d.gradient[at(n)];
    }
    for (std::int32_t n = t.free; n < t.nodes; ++n)
        d.gradient[at(n)] = all_lanes(1.0 / report.substeps) * d.residual[at(n)];
    for (std::int32_t n = 0; n < t.free; ++n) d.position[at(n)] = d.trial[at(n)];
}

}  // namespace membrane_detail

using namespace membrane_detail;

MembraneLimit Membrane::limit(const MembraneState& state, MembraneScratch& scratch) const {
    Data& d = *scratch.data_;
    const Tables& t = *tables_;
    const auto count = at(t.free);
    MembraneLimit limit;
    load_step(*this, state, {}, 0, d);
    limit.safe_frequency = std::sqrt(bounding_eigenvalue(t, d.stiffness.data(), d));
    make_tangent(t, d.stiffness.data(), d.rest.data(), d.position.data(), false, d);
    // Lanczos on M^-1/2 K M^-1/2 from a fixed, uneven start; the largest Ritz value by bisection of the
    // tridiagonal matrix.
    constexpr int steps = 60;
    double alpha[steps], beta[steps + 1] = {};
    std::fill(d.direction.begin(), d.direction.end(), all_lanes(0));
    std::fill(d.residual.begin(), d.residual.end(), all_lanes(0));
    std::uint32_t word = 12345;
    for (std::size_t i = 0; i < count; ++i) {
        for (int c = 0; c < 3; ++c) {
            word = word * 1664525U + 1013904223U;
            d.direction[i][c] = static_cast<double>(word >> 8U) / 16777216.0 - 0.5;
        }
    }
    double norm = std::sqrt(dot(d.direction.data(), d.direction.data(), count));
    int size = 0;
    for (int k = 0; k < steps && norm > 0; ++k) {
        for (std::size_t i = 0; i < count; ++i) d.direction[i] /= all_lanes(norm);
        for (std::size_t i = 0; i < at(t.nodes); ++i) {
            d.trial[i] = i < count ? d.direction[i] / all_lanes(std::sqrt(t.mass[i])) : all_lanes(0);
            d.product[i] = all_lanes(0);
        }
        multiply_tangent(t, d, d.trial.data(), d.product.data());
        for (std::size_t i = 0; i < count; ++i)
            d.product[i] =
                d.product[i] / all_lanes(std::sqrt(t.mass[i])) - all_lanes(beta[k]) * d.residual[i];
        alpha[k] = dot(d.direction.data(), d.product.data(), count);
        for (std::size_t i = 0; i < count; ++i) {
            d.product[i] -= all_lanes(alpha[k]) * d.direction[i];
            d.residual[i] = d.direction[i];
            d.direction[i] = d.product[i];
        }
        norm = beta[k + 1] = std::sqrt(dot(d.direction.data(), d.direction.data(), count));
        size = k + 1;
        if (beta[k + 1] <= 1e-12 * std::abs(alpha[0])) break;
    }
    double high = 0;
    for (int k = 0; k < size; ++k) high = std::max(high, alpha[k] + beta[k] + beta[k + 1]);
    double low = 0;
    for (int round = 0; round < 80 && high > low; ++round) {
        const double middle = 0.5 * (low + high);
        bool above = false;  // is an eigenvalue above the middle? then a pivot of T - middle is positive
        double pivot = -1;
        for (int k = 0; k < size && !above; ++k) {
            pivot = alpha[k] - middle - (k > 0 ? beta[k] * beta[k] / pivot : 0);
            above = pivot >= 0;
        }
        (above ? low : high) = middle;
    }
    limit.frequency = std::sqrt(std::max(0.0, low));
    const auto ratio = [&](double w) {
        return 0.5 * (material_.stiffness_damping * w + (w > 0 ? material_.mass_damping / w : 0));
    };
    limit.damping_ratio = ratio(limit.frequency);
    limit.time_step = stable_step(limit.frequency, limit.damping_ratio);
    limit.safe_time_step = stable_step(limit.safe_frequency, ratio(limit.safe_frequency));
    return limit;
}

}  // namespace fulcrum
