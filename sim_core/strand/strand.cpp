// SPDX-License-Identifier: Apache-2.0
#include "sim_core/strand/strand.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr int most_rounds = 20;
constexpr int most_halvings = 12;
constexpr double enough = 1e-7;    // N, residual force on a node
constexpr double fastest = 50.0;   // m/s
constexpr double shortest = 1e-9;  // m, below which a segment has no direction
constexpr int inner = strand_nodes - 2;

using Nodes = std::array<Vector3, strand_nodes>;

struct Problem {
    const StrandModel& model;
    const StrandHold (&holds)[hand_count];
    const StrandState& state;
    Nodes inertial;
    double weight = 0;  // m / dt^2
};

bool is_inner(int node) {
    return node > 0 && node < strand_nodes - 1;
}

double energy(const Problem& problem, const Nodes& x) noexcept {
    double sum = 0;
    for (int i = 1; i <= inner; ++i) {
        const auto k = static_cast<std::size_t>(i);
        sum += 0.5 * problem.weight * (x[k] - problem.inertial[k]).squaredNorm();
    }
    for (int s = 0; s < strand_segments; ++s) {
        if (problem.state.is_parted(s)) continue;
        const auto k = static_cast<std::size_t>(s);
        const double stretch = (x[k + 1] - x[k]).norm() - problem.model.rest_length;
        if (stretch > 0) sum += 0.5 * problem.model.stiffness * stretch * stretch;
    }
    for (const StrandHold& hold : problem.holds) {
        if (!is_inner(hold.node)) continue;
        const double away = (x[static_cast<std::size_t>(hold.node)] - hold.target).norm();
        sum += hold.stiffness * away <= hold.most ? 0.5 * hold.stiffness * away * away
                                                  : hold.most * (away - 0.5 * hold.most / hold.stiffness);
    }
    return sum;
}

struct System {
    std::array<Matrix3, strand_nodes> diagonal;
    std::array<Matrix3, strand_segments> coupling;  // between node s and s + 1 (symmetric)
    Nodes gradient;
};

void assemble(const Problem& problem, const Nodes& x, System& system) noexcept {
    for (int i = 0; i < strand_nodes; ++i) {
        const auto k = static_cast<std::size_t>(i);
        system.diagonal[k] = problem.weight * Matrix3::Identity();
        system.gradient[k] = problem.weight * (x[k] - problem.inertial[k]);
    }
    for (int s = 0; s < strand_segments; ++s) {
        const auto k = static_cast<std::size_t>(s);
        system.coupling[k].setZero();
        if (problem.state.is_parted(s)) continue;
        const Vector3 along = x[k + 1] - x[k];
        const double length = along.norm();
        const double stretch = length - problem.model.rest_length;
        if (stretch <= 0 || length < shortest) continue;
        const Vector3 unit = along / length;
        const double stiffness = problem.model.stiffness;
        const Vector3 pull = stiffness * stretch * unit;
        const Matrix3 axial = unit * unit.transpose();
        const Matrix3 tangent = stiffness * (axial + stretch / length * (Matrix3::Identity() - axial));
        system.gradient[k] -= pull;
        system.gradient[k + 1] += pull;
        system.diagonal[k] += tangent;
        system.diagonal[k + 1] += tangent;
        system.coupling[k] = -tangent;
    }
    for (const StrandHold& hold : problem.holds) {
        if (!is_inner(hold.node)) continue;
        const auto k = static_cast<std::size_t>(hold.node);
        const Vector3 away = x[k] - hold.target;
        const double size = away.norm();
        if (hold.stiffness * size <= hold.most) {
            system.gradient[k] += hold.stiffness * away;
            system.diagonal[k] += hold.stiffness * Matrix3::Identity();
            continue;
        }
        const Vector3 unit = away / size;
        system.gradient[k] += hold.most * unit;
        system.diagonal[k] += hold.most / size * (Matrix3::Identity() - unit * unit.transpose());
    }
}

// Block Thomas over the inner nodes: direction = -H^-1 gradient.
void solve(System& system, Nodes& direction) noexcept {
    std::array<Matrix3, strand_nodes> inverse;
    Nodes right = system.gradient;
    inverse[1] = system.diagonal[1].inverse();
    for (int i = 2; i <= inner; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const Matrix3 factor = system.coupling[k - 1] * inverse[k - 1];
        right[k] -= factor * right[k - 1];
        inverse[k] = (system.diagonal[k] - factor * system.coupling[k - 1]).inverse();
    }
    direction[0] = direction[strand_nodes - 1] = Vector3::Zero();
    direction[inner] = -(inverse[inner] * right[inner]);
    for (int i = inner - 1; i >= 1; --i) {
        const auto k = static_cast<std::size_t>(i);
        direction[k] = -(inverse[k] * (right[k] + system.coupling[k] * direction[k + 1]));
    }
}

}  // namespace

StrandState make_strand_state(const Vector3& first, const Vector3& last) {
    StrandState state;
    for (int i = 0; i < strand_nodes; ++i) {
        state.position[static_cast<std::size_t>(i)] =
            first + (last - first) * (static_cast<double>(i) / strand_segments);
        state.velocity[static_cast<std::size_t>(i)].setZero();
    }
    return state;
}

StrandReport step_strand(const StrandModel& model, const StrandHold (&holds)[hand_count], double dt,
                         StrandState& state) noexcept {
    StrandReport report;
    if (!(dt > 0) || !std::isfinite(dt)) return report;
    StrandHold usable[hand_count];
    for (int hand = 0; hand < hand_count; ++hand) {
        usable[hand] = holds[hand];
        if (!holds[hand].target.allFinite() || !(holds[hand].stiffness >= 0) || !(holds[hand].most >= 0) ||
            holds[hand].target.norm() > 1e3)
            usable[hand].node = -1;
    }
    Problem problem{model, usable, state, state.position, model.node_mass / (dt * dt)};
    const double kept = 1 / (1 + model.damping * dt);
    for (int i = 1; i <= inner; ++i) {
        const auto k = static_cast<std::size_t>(i);
        problem.inertial[k] += dt * kept * state.velocity[k] + dt * dt * kept * model.gravity;
    }
    Nodes x = state.position, direction, trial;
    System system;
    double value = energy(problem, x);
    report.settled = false;
    while (report.rounds < most_rounds) {
        assemble(problem, x, system);
        report.residual = 0;
        for (int i = 1; i <= inner; ++i)
            report.residual = std::max(report.residual, system.gradient[static_cast<std::size_t>(i)].norm());
        if (report.residual < enough) {
            report.settled = true;
            break;
        }
        solve(system, direction);
        ++report.rounds;
        double step = 1, next = value;
        int halvings = 0;
        for (; halvings < most_halvings; ++halvings, step *= 0.5) {
            for (std::size_t k = 0; k < x.size(); ++k) trial[k] = x[k] + step * direction[k];
            next = energy(problem, trial);
            if (next <= value) break;
        }
        if (halvings == most_halvings || !std::isfinite(next)) break;  // minimum to working precision
        x = trial;
        value = next;
    }
    for (int i = 1; i <= inner; ++i) {
        const auto k = static_cast<std::size_t>(i);
        Vector3 velocity = (x[k] - state.position[k]) / dt;
        const double speed = velocity.norm();
        if (speed > fastest) velocity *= fastest / speed;
        state.velocity[k] = velocity;
        state.position[k] = x[k];
    }
    return report;
}

double strand_tension(const StrandModel& model, const StrandState& state, int segment) noexcept {
    if (segment < 0 || segment >= strand_segments || state.is_parted(segment)) return 0;
    const auto k = static_cast<std::size_t>(segment);
    return std::max(
        0.0, model.stiffness * ((state.position[k + 1] - state.position[k]).norm() - model.rest_length));
}

Vector3 hold_force(const StrandHold& hold, const StrandState& state) noexcept {
    if (hold.node < 0 || hold.node >= strand_nodes) return Vector3::Zero();
    const Vector3 force =
        hold.stiffness * (hold.target - state.position[static_cast<std::size_t>(hold.node)]);
    const double size = force.norm();
    return size > hold.most ? Vector3(hold.most / size * force) : force;
}

double strand_stiffness(const StrandModel& model, const StrandState& state, int node) noexcept {
    double sum = 0;
    for (const int segment : {node - 1, node}) {
        if (segment >= 0 && segment < strand_segments && !state.is_parted(segment)) sum += model.stiffness;
    }
    return sum;
}

int nearest_node(const StrandState& state, const Vector3& place, double& distance) noexcept {
    int nearest = -1;
    distance = 1e9;
    for (int s = 0; s < strand_segments; ++s) {
        if (state.is_parted(s)) continue;
        const auto k = static_cast<std::size_t>(s);
        const Vector3 a = state.position[k], b = state.position[k + 1];
        const double length = (b - a).squaredNorm();
        const double at = length > 0 ? std::clamp((place - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
        const double away = (a + at * (b - a) - place).norm();
        if (!(away < distance)) continue;
        distance = away;
        nearest = at < 0.5 ? s : s + 1;
    }
    return nearest;
}

}  // namespace fulcrum
