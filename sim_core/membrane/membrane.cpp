// SPDX-License-Identifier: Apache-2.0
#include "sim_core/membrane/membrane.h"

#include <algorithm>
#include <cmath>

#include "sim_core/membrane/membrane_system.h"

namespace fulcrum {

using namespace membrane_detail;

namespace {

constexpr double strongest = 1e9;  // N and m/s2, larger loads are refused
constexpr double farthest = 1e4;   // m, positions beyond it are out of bounds
constexpr double fastest = 1e9;    // m/s

}  // namespace

const char* name_of(MembraneFault fault) {
    switch (fault) {
        case MembraneFault::none:
            return "none";
        case MembraneFault::substepped:
            return "substepped";
        case MembraneFault::unconverged:
            return "unconverged";
        case MembraneFault::refused:
            return "refused";
        case MembraneFault::frozen:
            return "frozen";
    }
    return "frozen";
}

bool Membrane::any_free(const Triangle& corners) const noexcept {
    return std::any_of(corners.begin(), corners.end(),
                       [&](std::int32_t v) { return tables_->node_of[at(v)] < tables_->free; });
}

void Membrane::stop(MembraneState& state) noexcept {
    for (Vector3& v : state.velocities) v.setZero();
}

bool Membrane::finite(const MembraneState& state) {
    for (const Vector3& p : state.positions) {
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > farthest) return false;
    }
    for (const Vector3& v : state.velocities) {
        if (!v.allFinite() || v.cwiseAbs().maxCoeff() > fastest) return false;
    }
    return true;
}

namespace {

bool usable(const Membrane& membrane, const MembraneState& state, const MembraneInputs& inputs) {
    const auto n = static_cast<std::size_t>(membrane.vertices());
    if (state.positions.size() != n || state.velocities.size() != n ||
        state.cut.size() != membrane.springs().size())
        return false;
    if (!inputs.forces.empty() && inputs.forces.size() != n) return false;
    if (!inputs.attachments.empty() && inputs.attachments.size() != membrane.attached().size()) return false;
    const auto within = [](const Vector3& load) {
        return load.allFinite() && load.cwiseAbs().maxCoeff() <= strongest;
    };
    if (!within(inputs.gravity) || !Membrane::finite(state)) return false;
    for (const Vector3& f : inputs.forces) {
        if (!within(f)) return false;
    }
    if (inputs.holds.size() > Membrane::most_holds) return false;
    for (const MembraneHold& hold : inputs.holds) {
        if (hold.vertex < 0 || at(hold.vertex) >= n || !(hold.stiffness >= 0 && hold.stiffness <= strongest))
            return false;
        if (!hold.target.allFinite() || hold.target.cwiseAbs().maxCoeff() > farthest) return false;
    }
    for (const Vector3& a : inputs.attachments) {
        if (!a.allFinite() || a.cwiseAbs().maxCoeff() > farthest) return false;
    }
    return true;
}

// Writes the result back; support = force that holds the attached nodes against springs, loads and their own
// inertia.
void store_step(const Membrane& membrane, MembraneState& state, MembraneInputs& inputs, double dt,
                bool symplectic, Data& d) {
    const Membrane::Tables& t = membrane.tables();
    const double inverse = dt > 0 ? 1 / dt : 0;
    for (std::int32_t k = 0; k < t.nodes; ++k) {
        const std::size_t n = at(k), v = at(t.vertex_of[n]);
        const Vector3 old_velocity = state.velocities[v];
        state.positions[v] = vector_of(d.position[n]);
        state.velocities[v] = symplectic && k < t.free
                                  ? vector_of(d.start_velocity[n])
                                  : vector_of(all_lanes(inverse) * (d.position[n] - d.start[n]));
        if (k >= t.free && inputs.reactions.size() == membrane.attached().size()) {
            Vector3 support = vector_of(d.gradient[n]);
            if (!symplectic) support -= vector_of(d.load[n]);
            if (dt > 0) {
                support += t.mass[n] * inverse * (state.velocities[v] - old_velocity);
                if (!symplectic)
                    support += membrane.material().mass_damping * t.mass[n] * state.velocities[v];
            }
            inputs.reactions[static_cast<std::size_t>(k - t.free)] = support;
        }
    }
    for (MembraneHold& hold : inputs.holds) {
        if (t.node_of[at(hold.vertex)] >= t.free) {
            hold.reaction.setZero();
        } else if (!symplectic) {  // which has already summed it
            hold.reaction = hold.stiffness * (hold.target - state.positions[at(hold.vertex)]);
        }
    }
}

void forget_reactions(MembraneInputs& inputs) {
    for (Vector3& r : inputs.reactions) r.setZero();
    for (MembraneHold& hold : inputs.holds) hold.reaction.setZero();
}

// A held sheet starts from its velocity extrapolation (d.position), or from its present position if that has
// the lower potential: its velocity may be noise that the springs cancel within the step. (Extrapolating with
// the acceleration does not work: it amplifies the error that few iterations leave; after 450 frames the
// result was wrong by 11 %.)
void choose_start(const Membrane::Tables& t, Data& d) {
    const auto free = static_cast<std::ptrdiff_t>(t.free);
    std::copy(d.position.begin(), d.position.end(), d.trial.begin());
    std::copy(d.start.begin(), d.start.begin() + free, d.trial.begin());
    if (potential(t, d, d.trial.data(), d.trial_gradient.data()) <
        potential(t, d, d.position.data(), d.gradient.data()))
        d.position.swap(d.trial);
}

void freeze(MembraneState& state, MembraneInputs& inputs, const Data& d, MembraneReport& report) {
    state.positions = d.good.positions;
    Membrane::stop(state);
    forget_reactions(inputs);
    report.fault = MembraneFault::frozen;
    report.finite = false;
    report.converged = false;
    report.energy = report.potential = report.residual = 0;
}

MembraneReport refuse(MembraneInputs& inputs, bool finite) {
    MembraneReport report;
    forget_reactions(inputs);
    report.fault = MembraneFault::refused;
    report.finite = finite;
    report.converged = false;
    return report;
}

}  // namespace

MembraneReport Membrane::step(MembraneState& state, MembraneInputs& inputs, double dt,
                              MembraneScratch& scratch, const MembraneSolve& solve) const noexcept {
    Data& d = *scratch.data_;
    if (!(dt >= 1e-9 && dt <= 1)) return refuse(inputs, true);
    if (!usable(*this, state, inputs)) return refuse(inputs, false);
    MembraneReport report;
    d.good.positions = state.positions;
    const bool symplectic = solve.integrator == MembraneIntegrator::symplectic;
    load_step(*this, state, inputs, dt, d);
    if (symplectic) {
        for (std::size_t s = 0; s < d.stiffness.size(); ++s) {  // dampers are separate here
            d.stiffness[s] = d.stiffness[s] > 0 ? tables_->stiffness[s] : 0;
            d.rest[s] = tables_->rest[s];
        }
        const double w = std::sqrt(tables_->bounding);
        const double ratio =
            0.5 * (material_.stiffness_damping * w + (w > 0 ? material_.mass_damping / w : 0));
        step_symplectic(*this, inputs, stable_step(w, ratio), dt, solve, report, d);
        if (report.fault == MembraneFault::refused) return refuse(inputs, true);
    } else {
        if (!refresh_matrix(*this, state, dt, d)) {
            freeze(state, inputs, d, report);
            return report;
        }
        // A free membrane starts from its motion under inertia and loads, so its momentum is right from the
        // first iterate on. A held one starts from its velocity extrapolation: loads and springs are nearly
        // balanced.
        for (std::int32_t k = 0; k < tables_->free; ++k) {
            d.position[at(k)] = d.target[at(k)];
            if (attached_.empty()) d.position[at(k)] += all_lanes(1 / d.inertia[at(k)]) * d.load[at(k)];
        }
        if (!attached_.empty()) choose_start(*tables_, d);
        if (solve.integrator == MembraneIntegrator::implicit) {
            minimise_newton(*tables_, d, solve.iterations > 0 ? solve.iterations : 50,
                            solve.tolerance > 0 ? solve.tolerance : 1e-10, report);
        } else {
            minimise_quasi_newton(*tables_, d, solve.iterations > 0 ? solve.iterations : 4, solve.tolerance,
                                  report);
        }
        if (!report.converged) report.fault = MembraneFault::unconverged;
    }
    store_step(*this, state, inputs, dt, symplectic, d);
    if (!finite(state)) {
        freeze(state, inputs, d, report);
        return report;
    }
    std::fill(d.product.begin(), d.product.end(), all_lanes(0));
    for (std::size_t s = 0; s < d.stiffness.size(); ++s)
        d.across[s] = d.stiffness[s] > 0 ? tables_->stiffness[s] : 0;
    report.energy =
        add_springs(*tables_, d.across.data(), tables_->rest.data(), d.position.data(), d.product.data());
    return report;
}

MembraneReport Membrane::solve(MembraneState& state, MembraneInputs& inputs, MembraneScratch& scratch,
                               const MembraneSolve& solve) const noexcept {
    Data& d = *scratch.data_;
    if (attached_.empty() || solve.integrator == MembraneIntegrator::symplectic) return refuse(inputs, true);
    if (!usable(*this, state, inputs)) return refuse(inputs, false);
    MembraneReport report;
    d.good.positions = state.positions;
    load_step(*this, state, inputs, 0, d);
    bool good = refresh_matrix(*this, state, 0, d);
    if (good && solve.integrator == MembraneIntegrator::implicit) {
        minimise_newton(*tables_, d, solve.iterations > 0 ? solve.iterations : 200,
                        solve.tolerance > 0 ? solve.tolerance : 1e-10, report);
    } else if (good) {
        minimise_quasi_newton(*tables_, d, solve.iterations > 0 ? solve.iterations : 500, solve.tolerance,
                              report);
    }
    if (good) {
        if (!report.converged) report.fault = MembraneFault::unconverged;
        store_step(*this, state, inputs, 0, false, d);
        stop(state);
        good = finite(state);
    }
    if (!good) {
        freeze(state, inputs, d, report);
        return report;
    }
    report.energy = energy(state).elastic();
    return report;
}

MembraneEnergy Membrane::energy(const MembraneState& state) const {
    MembraneEnergy energy;
    for (std::size_t s = 0; s < springs_.size(); ++s) {
        if (state.cut[s] != 0) continue;
        const MembraneSpring& spring = springs_[s];
        const double stretch =
            (state.positions[at(spring.first)] - state.positions[at(spring.second)]).norm() -
            spring.rest_length;
        double& part = spring.kind == SpringKind::structural ? energy.structural
                       : spring.kind == SpringKind::shear    ? energy.shear
                                                             : energy.bend;
        part += 0.5 * spring.stiffness * stretch * stretch;
    }
    for (std::size_t v = 0; v < masses_.size(); ++v)
        energy.kinetic += 0.5 * masses_[v] * state.velocities[v].squaredNorm();
    return energy;
}

double Membrane::incremental_potential(const MembraneState& start, const MembraneState& end,
                                       const MembraneInputs& inputs, double dt,
                                       MembraneScratch& scratch) const {
    Data& d = *scratch.data_;
    load_step(*this, start, inputs, dt, d);
    for (std::int32_t k = 0; k < tables_->nodes; ++k)
        d.trial[at(k)] = lanes_of(end.positions[at(tables_->vertex_of[at(k)])]);
    return potential(*tables_, d, d.trial.data(), d.trial_gradient.data());
}

void Membrane::forces(const MembraneState& state, std::vector<Vector3>& forces) const {
    forces.assign(masses_.size(), Vector3::Zero());
    for (std::size_t s = 0; s < springs_.size(); ++s) {
        if (state.cut[s] != 0) continue;
        const MembraneSpring& spring = springs_[s];
        const Vector3 d = state.positions[at(spring.first)] - state.positions[at(spring.second)];
        const double length = std::max(d.norm(), 1e-12);
        const Vector3 pull = spring.stiffness * (1 - spring.rest_length / length) * d;
        forces[at(spring.first)] -= pull;
        forces[at(spring.second)] += pull;
    }
}

void Membrane::tangent_times(const MembraneState& state, const std::vector<Vector3>& direction,
                             std::vector<Vector3>& product) const {
    MembraneScratch scratch = make_scratch();
    Data& d = *scratch.data_;
    load_step(*this, state, {}, 0, d);
    for (std::int32_t k = 0; k < tables_->nodes; ++k)
        d.direction[at(k)] = lanes_of(direction[at(tables_->vertex_of[at(k)])]);
    make_tangent(*tables_, d.stiffness.data(), d.rest.data(), d.position.data(), false, d);
    std::fill(d.product.begin(), d.product.end(), all_lanes(0));
    multiply_tangent(*tables_, d, d.direction.data(), d.product.data());
    product.resize(masses_.size());
    for (std::int32_t k = 0; k < tables_->nodes; ++k)
        product[at(tables_->vertex_of[at(k)])] = vector_of(d.product[at(k)]);
}

}  // namespace fulcrum
