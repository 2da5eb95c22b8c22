// SPDX-License-Identifier: Apache-2.0
// The uncut sheet: edges, sources of the springs, the bound on the frequencies; the state at rest.
#include "sim_core/membrane/cut_membrane.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "sim_core/membrane/membrane_system.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

std::int8_t corner_of(const Triangle& corners, std::int32_t vertex) {
    for (std::int8_t c = 0; c < 3; ++c) {
        if (corners[at(c)] == vertex) return c;
    }
    return -1;
}

// Free slots from `first` on; the lowest is taken first.
std::int32_t fill_free(std::vector<std::int32_t>& free, std::int32_t first, std::int32_t capacity) {
    free.assign(at(capacity), -1);
    std::int32_t count = 0;
    for (std::int32_t slot = capacity - 1; slot >= first; --slot) free[at(count++)] = slot;
    return count;
}

}  // namespace

CutMembrane::CutMembrane(const TriangleMesh& mesh, const MembraneMaterial& material,
                         const std::vector<Attachment>& attachments, std::int32_t most_pieces)
    : triangles_(mesh.triangles), rest_(mesh.vertices), material_(material), most_pieces_(most_pieces) {
    springs_ = derive_springs(mesh, material_);
    const auto roots = static_cast<std::int32_t>(triangles_.size());
    if (most_pieces < roots || most_pieces > 10000000)
        throw InputError("membrane", "most_pieces",
                         "the number of pieces is below the number of triangles or above 1e7",
                         "give at least one piece per triangle");
    attachment_.assign(rest_.size(), 0.0);
    for (const Attachment& a : attachments) {
        if (a.vertex < 0 || at(a.vertex) >= rest_.size() || !(a.stiffness > 0))
            throw InputError("membrane", "attachments",
                             "an attachment has a vertex that does not exist, or a stiffness not above 0",
                             "give vertex numbers of the mesh and stiffnesses in N/m");
        attachment_[at(a.vertex)] = a.stiffness;
    }
    double area = 0;
    for (const Triangle& t : triangles_) {
        root_area_.push_back(triangle_area(rest_[at(t[0])], rest_[at(t[1])], rest_[at(t[2])]));
        area += root_area_.back();
    }
    for (std::size_t r = 0; r < root_area_.size(); ++r) {
        if (!(root_area_[r] > 1e-9 * area / roots))
            throw InputError("membrane", "triangles/" + std::to_string(r),
                             "the triangle has no area and cannot be cut", "remove it");
        root_mass_.push_back(material_.mass * root_area_[r] / area);
    }
    density_ = material_.mass / area;
    derive_edges();
    derive_sources();
    bound_frequency();
    std::int32_t bends = 0;
    for (const MembraneSpring& spring : springs_) bends += spring.kind == SpringKind::bend ? 1 : 0;
    const std::int32_t extra = most_pieces - roots;
    most_nodes_ = 3 * most_pieces;
    most_contacts_ = static_cast<std::int32_t>(edges_.size()) + 6 * extra;
    most_bends_ = 2 * bends + 3 * extra;
    most_springs_ = (3 * most_pieces + most_contacts_ + most_bends_ + 3) / 4 * 4;
}

void CutMembrane::derive_edges() {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> number;
    std::vector<std::vector<std::int32_t>> around(rest_.size());
    vertex_mass_.assign(rest_.size(), 0.0);
    for (std::size_t r = 0; r < triangles_.size(); ++r) {
        root_edges_.push_back({});
        for (std::size_t e = 0; e < 3; ++e) {
            const std::int32_t a = triangles_[r][e], b = triangles_[r][(e + 1) % 3];
            around[at(a)].push_back(static_cast<std::int32_t>(r));
            vertex_mass_[at(a)] += root_mass_[r] / 3;
            const auto key = std::make_pair(std::min(a, b), std::max(a, b));
            const auto [place, fresh] = number.emplace(key, static_cast<std::int32_t>(edges_.size()));
            if (fresh) edges_.push_back({{key.first, key.second}, {-1, -1}, {0, 0}});
            Edge& edge = edges_[at(place->second)];
            const std::size_t side = edge.roots[0] < 0 ? 0 : 1;
            if (edge.roots[side] >= 0)
                throw InputError("membrane", "triangles/" + std::to_string(r),
                                 "an edge has more than two triangles",
                                 "give a sheet with at most two triangles per edge");
            edge.roots[side] = static_cast<std::int32_t>(r);
            edge.local[side] = static_cast<std::int8_t>(e);
            root_edges_.back()[e] = place->second;
        }
    }
    around_offsets_.push_back(0);
    for (const auto& roots : around) {
        around_.insert(around_.end(), roots.begin(), roots.end());
        around_offsets_.push_back(static_cast<std::int32_t>(around_.size()));
    }
}

void CutMembrane::derive_sources() {
    const auto edge_of = [&](std::int32_t a, std::int32_t b) {
        for (std::int32_t k = around_offsets_[at(a)]; k < around_offsets_[at(a) + 1]; ++k) {
            for (const std::int32_t e : root_edges_[at(around_[at(k)])]) {
                const auto& ends = edges_[at(e)].vertices;
                if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a)) return e;
            }
        }
        return -1;
    };
    // Root of an edge that traverses it from a to b, or the other one.
    const auto side_root = [&](std::int32_t edge, std::int32_t a, std::int32_t b, bool along) {
        for (const std::int32_t root : edges_[at(edge)].roots) {
            if (root < 0) continue;
            const std::int8_t c = corner_of(triangles_[at(root)], a);
            if ((triangles_[at(root)][at((c + 1) % 3)] == b) == along) return root;
        }
        return -1;
    };
    std::vector<std::vector<std::int32_t>> uses(triangles_.size());
    for (std::size_t s = 0; s < springs_.size(); ++s) {
        const MembraneSpring& spring = springs_[s];
        Source source;
        std::vector<std::int32_t> roots;
        if (spring.kind == SpringKind::bend) {
            const std::int32_t middle = spring.between[0];
            const std::int32_t near = edge_of(spring.first, middle), far = edge_of(middle, spring.second);
            for (const bool along : {true, false}) {
                Source::Side side;
                side.near = side_root(near, spring.first, middle, along);
                side.far = side_root(far, middle, spring.second, along);
                if (side.near < 0 || side.far < 0) continue;
                side.near_corner = corner_of(triangles_[at(side.near)], spring.first);
                side.near_middle = corner_of(triangles_[at(side.near)], middle);
                side.far_middle = corner_of(triangles_[at(side.far)], middle);
                side.far_corner = corner_of(triangles_[at(side.far)], spring.second);
                source.sides[at(source.side_count++)] = side;
                roots.push_back(side.near);
                roots.push_back(side.far);
            }
        } else {
            source.edge = spring.kind == SpringKind::structural
                              ? edge_of(spring.first, spring.second)
                              : edge_of(spring.between[0], spring.between[1]);
            for (const std::int32_t root : edges_[at(source.edge)].roots) {
                if (root >= 0) roots.push_back(root);
            }
        }
        for (const std::int32_t root : roots) {
            if (uses[at(root)].empty() || uses[at(root)].back() != static_cast<std::int32_t>(s))
                uses[at(root)].push_back(static_cast<std::int32_t>(s));
        }
        sources_.push_back(source);
    }
    use_offsets_.push_back(0);
    for (const auto& of_root : uses) {
        uses_.insert(uses_.end(), of_root.begin(), of_root.end());
        use_offsets_.push_back(static_cast<std::int32_t>(uses_.size()));
    }
}

void CutMembrane::bound_frequency() {
    // A piece of share a adds at most a times this stiffness to its copy of a corner and exactly a times a
    // third of the root's mass; by Gershgorin no squared frequency exceeds twice the largest ratio.
    std::vector<std::array<double, 3>> on_corner(triangles_.size(), {0, 0, 0});
    for (std::size_t s = 0; s < springs_.size(); ++s) {
        const Source& source = sources_[s];
        const double k = springs_[s].stiffness;
        if (springs_[s].kind == SpringKind::bend) {
            for (std::int8_t i = 0; i < source.side_count; ++i) {
                const Source::Side& side = source.sides[at(i)];
                on_corner[at(side.near)][at(side.near_corner)] += k / source.side_count;
                on_corner[at(side.far)][at(side.far_corner)] += k / source.side_count;
            }
            continue;
        }
        const Edge& edge = edges_[at(source.edge)];
        const int sides = edge.roots[1] < 0 ? 1 : 2;
        for (std::size_t i = 0; i < static_cast<std::size_t>(sides); ++i) {
            auto& corners = on_corner[at(edge.roots[i])];
            const std::int32_t local = edge.local[i];
            if (springs_[s].kind == SpringKind::structural) {
                corners[at(local)] += k / sides;
                corners[at((local + 1) % 3)] += k / sides;
            } else {
                corners[at((local + 2) % 3)] += k;
            }
        }
    }
    double squared = 0;
    for (std::size_t r = 0; r < triangles_.size(); ++r) {
        for (const double k : on_corner[r]) squared = std::max(squared, 2 * k / (root_mass_[r] / 3));
    }
    safe_frequency_ = std::sqrt(squared);
}

double CutMembrane::safe_time_step() const {
    const double w = safe_frequency_;
    const double ratio = 0.5 * (material_.stiffness_damping * w + (w > 0 ? material_.mass_damping / w : 0));
    return membrane_detail::stable_step(w, ratio);
}

CutMembraneState CutMembrane::make_state() const {
    CutMembraneState state;
    const std::size_t nodes = at(most_nodes_);
    state.positions.assign(nodes, Vector3::Zero());
    state.velocities.assign(nodes, Vector3::Zero());
    state.masses.assign(nodes, 0.0);
    state.vertex.assign(nodes, -1);
    state.held.assign(nodes, 0);
    state.isolated.assign(nodes, 0);
    for (std::size_t v = 0; v < rest_.size(); ++v) {
        state.positions[v] = rest_[v];
        state.masses[v] = vertex_mass_[v];
        state.vertex[v] = static_cast<std::int32_t>(v);
        state.held[v] = attachment_[v] > 0 ? 1 : 0;
    }
    state.node_end = static_cast<std::int32_t>(rest_.size());
    state.free_node_count = fill_free(state.free_nodes, state.node_end, most_nodes_);

    const auto roots = static_cast<std::int32_t>(triangles_.size());
    state.pieces.resize(at(most_pieces_));
    state.first_piece.assign(triangles_.size(), -1);
    for (std::int32_t r = 0; r < roots; ++r) {
        CutMembraneState::Piece& piece = state.pieces[at(r)];
        piece.root = r;
        piece.share = 1;
        piece.nodes = triangles_[at(r)];
        piece.corners = piece.edges = 7;
        state.first_piece[at(r)] = r;
    }

    state.contacts.resize(at(most_contacts_));
    state.first_contact.assign(edges_.size(), -1);
    std::int32_t contacts = 0;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        if (edges_[e].roots[1] < 0) continue;
        CutMembraneState::Contact& contact = state.contacts[at(contacts)];
        contact.first = edges_[e].roots[0];
        contact.second = edges_[e].roots[1];
        contact.share = 1;
        state.first_contact[e] = contacts++;
    }
    state.free_contact_count = fill_free(state.free_contacts, contacts, most_contacts_);

    const std::size_t springs = at(most_springs_);
    state.first.assign(springs, 0);
    state.second.assign(springs, 0);
    state.next_spring.assign(springs, -1);
    state.stiffness.assign(springs, 0.0);
    state.rest.assign(springs, 0.0);
    state.first_spring.assign(springs_.size(), -1);
    state.free_spring_count = fill_free(state.free_springs, 0, most_springs_);
    for (std::size_t s = 0; s < springs_.size(); ++s) make_springs(state, s);
    CutMembraneScratch scratch = make_scratch();
    find_isolated(state, scratch);
    return state;
}

CutMembraneScratch CutMembrane::make_scratch() const {
    CutMembraneScratch s;
    const std::size_t nodes = at(most_nodes_);
    s.position_.assign(nodes, all_lanes(0));
    s.velocity_.assign(nodes, all_lanes(0));
    s.gradient_.assign(nodes, all_lanes(0));
    s.inverse_mass_.assign(nodes, 0.0);
    s.anchor_.assign(nodes, 0.0);
    s.good_.assign(nodes, Vector3::Zero());
    s.driven_.assign(rest_.size(), -1);
    s.driven_nodes_.reserve(nodes);
    s.incidences_.reserve(at(most_pieces_));
    s.vertices_.reserve(rest_.size());
    s.parent_.assign(nodes, -1);
    s.vertex_stamp_.assign(rest_.size(), 0);
    s.spring_stamp_.assign(springs_.size(), 0);
    s.node_stamp_.assign(nodes, 0);
    s.place_of_piece_.assign(at(most_pieces_), -1);
    s.old_nodes_.assign(at(most_pieces_), {-1, -1, -1});
    return s;
}

Vector3 CutMembrane::point(const CutMembraneState& state, std::int32_t piece, const Vector3& b) noexcept {
    const auto& nodes = state.pieces[at(piece)].nodes;
    return b[0] * state.positions[at(nodes[0])] + b[1] * state.positions[at(nodes[1])] +
           b[2] * state.positions[at(nodes[2])];
}

Vector3 CutMembrane::velocity(const CutMembraneState& state, std::int32_t piece, const Vector3& b) noexcept {
    const auto& nodes = state.pieces[at(piece)].nodes;
    return b[0] * state.velocities[at(nodes[0])] + b[1] * state.velocities[at(nodes[1])] +
           b[2] * state.velocities[at(nodes[2])];
}

MembraneEnergy CutMembrane::energy(const CutMembraneState& state) const {
    MembraneEnergy energy;
    for (std::size_t s = 0; s < springs_.size(); ++s) {
        double& part = springs_[s].kind == SpringKind::structural ? energy.structural
                       : springs_[s].kind == SpringKind::shear    ? energy.shear
                                                                  : energy.bend;
        for (std::int32_t k = state.first_spring[s]; k >= 0; k = state.next_spring[at(k)]) {
            const double stretch =
                (state.positions[at(state.first[at(k)])] - state.positions[at(state.second[at(k)])]).norm() -
                state.rest[at(k)];
            part += 0.5 * state.stiffness[at(k)] * stretch * stretch;
        }
    }
    for (std::size_t n = 0; n < at(state.node_end); ++n) {
        energy.kinetic += 0.5 * state.masses[n] * state.velocities[n].squaredNorm();
        if (state.held[n] == 0 || state.vertex[n] < 0) continue;
        const std::size_t v = at(state.vertex[n]);
        if (!std::isfinite(attachment_[v])) continue;
        energy.structural += 0.5 * attachment_[v] * state.masses[n] / vertex_mass_[v] *
                             (state.positions[n] - rest_[v]).squaredNorm();
    }
    return energy;
}

double CutMembrane::mass(const CutMembraneState& state) const {
    double sum = 0;
    for (std::size_t n = 0; n < at(state.node_end); ++n) sum += state.masses[n];
    return sum;
}

Vector3 CutMembrane::momentum(const CutMembraneState& state) const {
    Vector3 sum = Vector3::Zero();
    for (std::size_t n = 0; n < at(state.node_end); ++n) sum += state.masses[n] * state.velocities[n];
    return sum;
}

Matrix3 CutMembrane::tension(const CutMembraneState& state, const Vector3& place,
                             double radius) const noexcept {
    Matrix3 sum = Matrix3::Zero();
    const double within = radius * radius;
    for (std::size_t s = 0; s < at(state.spring_end); ++s) {
        if (!(state.stiffness[s] > 0)) continue;
        const Vector3 &a = state.positions[at(state.first[s])], &b = state.positions[at(state.second[s])];
        if ((0.5 * (a + b) - place).squaredNorm() > within) continue;
        const Vector3 d = a - b;
        const double length = d.norm();
        if (length > 1e-12) sum += state.stiffness[s] * (length - state.rest[s]) / length * d * d.transpose();
    }
    double area = 0;
    for (std::size_t r = 0; r < triangles_.size(); ++r) {
        for_pieces(state, static_cast<std::int32_t>(r),
                   [&](std::int32_t slot, const CutMembraneState::Piece& piece) {
                       if ((point(state, slot, Vector3::Constant(1.0 / 3)) - place).squaredNorm() <= within)
                           area += piece.share * root_area_[r];
                   });
    }
    return area > 0 ? Matrix3(sum / area) : Matrix3(Matrix3::Zero());
}

std::size_t CutMembrane::bytes() const {
    return springs_.size() * (sizeof(MembraneSpring) + sizeof(Source)) + edges_.size() * sizeof(Edge) +
           rest_.size() * (sizeof(Vector3) + 2 * sizeof(double)) +
           triangles_.size() * (2 * sizeof(Triangle) + 2 * sizeof(double)) +
           (around_.size() + around_offsets_.size() + uses_.size() + use_offsets_.size()) *
               sizeof(std::int32_t);
}

std::size_t CutMembraneState::bytes() const {
    const auto own = [](const auto&... tables) {
        return (std::size_t{0} + ... + (tables.capacity() * sizeof(tables[0])));
    };
    return own(positions, velocities, masses, vertex, held, isolated, pieces, first_piece, contacts,
               first_contact, first, second, next_spring, stiffness, rest, first_spring, free_nodes,
               free_contacts, free_springs);
}

}  // namespace fulcrum
