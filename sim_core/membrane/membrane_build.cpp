// SPDX-License-Identifier: Apache-2.0
// Construction of a membrane: checks, tables, states and scratch.
#include <algorithm>
#include <map>

#include "sim_core/membrane/membrane.h"
#include "sim_core/membrane/membrane_system.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/state_archive.h"

namespace fulcrum {

using namespace membrane_detail;

namespace {

void check(const MembraneMaterial& m) {
    const auto within = [](double value, double least, double most, const char* name) {
        if (!(value >= least && value <= most))
            throw InputError("membrane", name, "the value is out of range",
                             "give a finite value within the range stated in springs.h");
    };
    within(m.structural_stiffness, 0, 1e12, "structural_stiffness");
    within(m.shear_stiffness, 0, 1e12, "shear_stiffness");
    within(m.bend_stiffness, 0, 1e12, "bend_stiffness");
    within(m.mass, 1e-12, 1e6, "mass");
    within(m.pre_strain, -0.5, 1, "pre_strain");
    within(m.stiffness_damping, 0, 1e6, "stiffness_damping");
    within(m.mass_damping, 0, 1e6, "mass_damping");
}

// Springs in the order of their nodes, so that neighbours in the sheet are neighbours in memory; padded to a
// multiple of four.
void place_springs(const std::vector<MembraneSpring>& springs, Membrane::Tables& t) {
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

    // Edges of the bounding matrix, by vertices.
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
            // |a - b|^2 <= 2 |a - c|^2 + 2 |c - b|^2, halved if there are two paths.
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
    place_springs(springs, t);
    return made;
}

}  // namespace

MembraneScratch::MembraneScratch() = default;
MembraneScratch::~MembraneScratch() = default;
MembraneScratch::MembraneScratch(MembraneScratch&&) noexcept = default;
MembraneScratch& MembraneScratch::operator=(MembraneScratch&&) noexcept = default;
MembraneScratch::MembraneScratch(const MembraneScratch& other)
    : data_(other.data_ ? std::make_unique<Data>(*other.data_) : nullptr) {}
MembraneScratch& MembraneScratch::operator=(const MembraneScratch& other) {
    if (this != &other) data_ = other.data_ ? std::make_unique<Data>(*other.data_) : nullptr;
    return *this;
}
void MembraneScratch::fields(StateArchive& archive) {
    archive(*data_);
}
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
            throw InputError("membrane", "attached", "an attached vertex does not exist",
                             "give vertex numbers of the mesh, from 0");
        if (seen[at(v)]++ != 0)
            throw InputError("membrane", "attached", "an attached vertex is listed twice", "list it once");
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

}  // namespace fulcrum
