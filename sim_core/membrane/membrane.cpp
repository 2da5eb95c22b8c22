// SPDX-License-Identifier: Apache-2.0
// The whole of one class's public side, a little over 500 lines; solvers and springs stand in files of their own.
#include "sim_core/membrane/membrane.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim_core/membrane/membrane_system.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {

using namespace membrane_detail;

namespace {

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

constexpr double strongest = 1e9;  // N and m/s2, a load beyond it is not one
constexpr double farthest = 1e4;   // m, a vertex beyond it has left all bounds
constexpr double fastest = 1e9;    // m/s

void check(const MembraneMaterial& m) {
    const auto within = [](double value, double least, double most, const char* name) {
        if (!(value >= least && value <= most))
            throw InputError("membrane", name, "out of range",
                             "give a finite value within the range of the header");
    };
    within(m.structural_stiffness, 0, 1e12, "structural_stiffness");
    within(m.shear_stiffness, 0, 1e12, "shear_stiffness");
    within(m.bend_stiffness, 0, 1e12, "bend_stiffness");
    within(m.mass, 1e-12, 1e6, "mass");
    within(m.pre_strain, -0.5, 1, "pre_strain");
    within(m.stiffness_damping, 0, 1e6, "stiffness_damping");
    within(m.mass_damping, 0, 1e6, "mass_damping");
}

std::unique_ptr<Membrane::Tables> make_tables(const std::vector<Vector3>& rest,
                                              const std::vector<MembraneSpring>& springs,
                                              const std::vector<std::int32_t>& attached,
                                              const std::vector<double>& masses) {
    auto made = std::make_unique<Membrane::Tables>();
    Membrane::Tables& t = *made;
    t.nodes = static_cast<std::int32_t>(rest.size());
    t.free = t.nodes - static_cast<std::int32_t>(attached.size());
    std::vector<std::uint8_t> held(rest.size(), 0);
    for (const std::int32_t v : attached) held[at(v)] = 1;

    // Edges that carry the bound, by vertices.
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> edge_number;
    std::vector<GraphEdge> by_vertex;
    const auto edge_of = [&](std::int32_t a, std::int32_t b) {
        const auto key = a < b ? std::make_pair(a, b) : std::make_pair(b, a);
        const auto [place, fresh] = edge_number.emplace(key, static_cast<std::int32_t>(by_vertex.size()));
        if (fresh) by_vertex.push_back({key.first, key.second});
        return place->second;
    };
    t.share_offsets.push_back(0);
    for (const MembraneSpring& spring : springs) {
        if (spring.between[0] < 0) {
            t.shares.push_back({edge_of(spring.first, spring.second), spring.stiffness});
        } else {
            // |a - b|^2 <= 2 |a - c|^2 + 2 |c - b|^2, halved where there are two ways round.
            const double weight = spring.between[1] < 0 ? 2 * spring.stiffness : spring.stiffness;
            for (const std::int32_t c : spring.between) {
                if (c < 0) continue;
                t.shares.push_back({edge_of(spring.first, c), weight});
                t.shares.push_back({edge_of(c, spring.second), weight});
            }
        }
        t.share_offsets.push_back(static_cast<std::int32_t>(t.shares.size()));
    }

    std::vector<std::int32_t> free_number(rest.size(), -1), free_vertices;
    for (std::size_t v = 0; v < rest.size(); ++v) {
        if (held[v] != 0) continue;
        free_number[v] = static_cast<std::int32_t>(free_vertices.size());
        free_vertices.push_back(static_cast<std::int32_t>(v));
    }
    std::vector<GraphEdge> free_edges;
    for (const GraphEdge& e : by_vertex) {
        if (held[at(e[0])] == 0 && held[at(e[1])] == 0)
            free_edges.push_back({free_number[at(e[0])], free_number[at(e[1])]});
    }
    const std::vector<std::int32_t> order =
        sweep_order(static_cast<std::int32_t>(free_vertices.size()), free_edges);
    t.node_of.assign(rest.size(), -1);
    for (const std::int32_t k : order) {
        t.node_of[at(free_vertices[at(k)])] = static_cast<std::int32_t>(t.vertex_of.size());
        t.vertex_of.push_back(free_vertices[at(k)]);
    }
    for (const std::int32_t v : attached) {
        t.node_of[at(v)] = static_cast<std::int32_t>(t.vertex_of.size());
        t.vertex_of.push_back(v);
    }
    for (const std::int32_t v : t.vertex_of) t.mass.push_back(masses[at(v)]);

    for (const GraphEdge& e : by_vertex) {
        GraphEdge edge = {t.node_of[at(e[0])], t.node_of[at(e[1])]};
        if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
        t.edges.push_back(edge);
        t.inner_edge.push_back(edge[1] < t.free ? static_cast<std::int32_t>(t.inner_edges.size()) : -1);
        if (edge[1] < t.free) t.inner_edges.push_back(edge);
    }

    // Springs in the order of their nodes, so that neighbours in memory are neighbours in the sheet.
    std::vector<std::int32_t> by_node(springs.size());
    for (std::size_t s = 0; s < springs.size(); ++s) by_node[s] = static_cast<std::int32_t>(s);
    const auto ends = [&](std::int32_t s) {
        const std::int32_t a = t.node_of[at(springs[at(s)].first)], b = t.node_of[at(springs[at(s)].second)];
        return a < b ? std::make_pair(a, b) : std::make_pair(b, a);
    };
    std::sort(by_node.begin(), by_node.end(),
              [&](std::int32_t a, std::int32_t b) { return ends(a) < ends(b); });
    t.place_of.resize(springs.size());
    for (const std::int32_t s : by_node) {
        t.place_of[at(s)] = static_cast<std::int32_t>(t.first.size());
        t.first.push_back(ends(s).first);
        t.second.push_back(ends(s).second);
        t.stiffness.push_back(springs[at(s)].stiffness);
        t.rest.push_back(springs[at(s)].rest_length);
        t.spring_of.push_back(s);
    }
    while (t.first.size() % 4 != 0) {
        t.first.push_back(0);
        t.second.push_back(0);
        t.stiffness.push_back(0);
        t.rest.push_back(0);
        t.spring_of.push_back(-1);
    }
    return made;
}

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

MembraneScratch::MembraneScratch() = default;
MembraneScratch::~MembraneScratch() = default;
MembraneScratch::MembraneScratch(MembraneScratch&&) noexcept = default;
MembraneScratch& MembraneScratch::operator=(MembraneScratch&&) noexcept = default;
int MembraneScratch::builds() const {
    return data_->builds;
}
int MembraneScratch::updates() const {
    return data_->updates;
}
MembraneScratch::Operations MembraneScratch::operations() const {
    return {data_->multigrid.build_operations(), data_->multigrid.solve_operations(),
            static_cast<std::int64_t>(data_->stiffness.size())};
}

std::size_t MembraneScratch::bytes() const {
    if (!data_) return 0;
    return data_->multigrid.bytes() +
           data_->position.size() * (13 * sizeof(Lanes) + 6 * Data::memory * sizeof(double)) +
           data_->stiffness.size() * (3 * sizeof(double) + sizeof(Lanes)) +
           (data_->edge_weight.size() + data_->inner_weight.size()) * sizeof(double) +
           data_->good.positions.size() * 2 * sizeof(Vector3);
}

Membrane::Membrane(const TriangleMesh& mesh, const MembraneMaterial& material,
                   std::vector<std::int32_t> attached)
    : triangles_(mesh.triangles), rest_(mesh.vertices), attached_(std::move(attached)), material_(material) {
    check(material_);
    std::vector<std::uint8_t> seen(mesh.vertices.size(), 0);
    for (const std::int32_t v : attached_) {
        if (v < 0 || at(v) >= seen.size())
            throw InputError("membrane", "attached", "a vertex that is not there",
                             "give vertex numbers of the mesh, from 0");
        if (seen[at(v)]++ != 0)
            throw InputError("membrane", "attached", "a vertex is named twice", "name it once");
    }
    springs_ = derive_springs(mesh, material_);
    masses_ = lumped_masses(mesh, material_.mass);
    auto tables = make_tables(rest_, springs_, attached_, masses_);
    Data data;
    data.diagonal.resize(at(tables->nodes));
    data.inertia.resize(at(tables->nodes));
    tables->bounding = bounding_eigenvalue(*tables, tables->stiffness.data(), data);
    tables_ = std::move(tables);
}

Membrane::~Membrane() = default;
Membrane::Membrane(Membrane&&) noexcept = default;

bool Membrane::any_free(const Triangle& corners) const noexcept {
    return std::any_of(corners.begin(), corners.end(),
                       [&](std::int32_t v) { return tables_->node_of[at(v)] < tables_->free; });
}

std::size_t Membrane::bytes() const {
    const Tables& t = *tables_;
    return springs_.size() * sizeof(MembraneSpring) + masses_.size() * sizeof(double) +
           rest_.size() * sizeof(Vector3) + triangles_.size() * sizeof(Triangle) +
           t.inner_edges.size() * sizeof(GraphEdge) +
           t.first.size() * (4 * sizeof(std::int32_t) + 2 * sizeof(double)) +
           t.shares.size() * sizeof(Tables::Share) +
           t.edges.size() * (sizeof(GraphEdge) + sizeof(std::int32_t)) +
           t.mass.size() * (sizeof(double) + 2 * sizeof(std::int32_t));
}

MembraneState Membrane::make_state() const {
    MembraneState state;
    state.positions = rest_;
    state.velocities.assign(rest_.size(), Vector3::Zero());
    state.cut.assign(springs_.size(), 0);
    return state;
}

MembraneScratch Membrane::make_scratch(double dt) const {
    MembraneScratch scratch;
    scratch.data_ = std::make_unique<Data>();
    Data& d = *scratch.data_;
    const std::size_t nodes = at(tables_->nodes), springs = tables_->first.size();
    for (auto* array :
         {&d.start, &d.start_velocity, &d.position, &d.trial, &d.target, &d.gradient, &d.trial_gradient,
          &d.direction, &d.load, &d.product, &d.residual, &d.preconditioned, &d.search}) {
        array->assign(nodes, all_lanes(0));
    }
    for (int m = 0; m < Data::memory; ++m) {
        d.moved[static_cast<std::size_t>(m)].assign(3 * nodes + 1, 0.0);
        d.turned[static_cast<std::size_t>(m)].assign(3 * nodes + 1, 0.0);
    }
    d.inertia.assign(nodes, 0);
    d.diagonal.assign(nodes, 0);
    d.stiffness.assign(springs, 0);
    d.rest.assign(springs, 0);
    d.across.assign(springs, 0);
    d.along.assign(springs, all_lanes(0));
    d.edge_weight.assign(tables_->edges.size(), 0);
    d.inner_weight.assign(tables_->inner_edges.size(), 0);
    d.multigrid = MeshMultigrid(tables_->free, tables_->inner_edges);
    d.good = make_state();
    d.built_cut = d.good.cut;
    refresh_matrix(*this, d.good, dt, d);
    return scratch;
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

// Writes the result back; support = what holds the attached nodes against springs, loads and their own
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
        } else if (!symplectic) {  // which has summed it up by itself
            hold.reaction = hold.stiffness * (hold.target - state.positions[at(hold.vertex)]);
        }
    }
}

void forget_reactions(MembraneInputs& inputs) {
    for (Vector3& r : inputs.reactions) r.setZero();
    for (MembraneHold& hold : inputs.holds) hold.reaction.setZero();
}

// A held sheet starts from where its velocity leads (d.position), or from where it is if that lies lower: its
// velocity may be noise that its springs undo within the step. (Its acceleration leads nowhere: what few
// iterations leave uncorrected, extrapolation carries on, and after 450 frames it was wrong by 11 %.)
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
        for (std::size_t s = 0; s < d.stiffness.size(); ++s) {  // dampers act by themselves here
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
        // A free membrane starts from where inertia and loads take it: its momentum is right from the first
        // iterate on. A held one from where its velocity takes it: loads and springs are near balance.
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
