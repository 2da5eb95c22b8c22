// SPDX-License-Identifier: Apache-2.0
// Applies a cut to the springs: pieces, nodes, masses, attachments, isolated parts.
#include <algorithm>

#include "sim_core/membrane/cut_membrane.h"

namespace fulcrum {
namespace {

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

// Root of the class, with the lowest number.
template <typename Parent>
std::int32_t class_of(Parent&& parent, std::int32_t i) {
    while (parent(i) != i) {
        parent(i) = parent(parent(i));
        i = parent(i);
    }
    return i;
}

template <typename Parent>
void join(Parent&& parent, std::int32_t a, std::int32_t b) {
    a = class_of(parent, a);
    b = class_of(parent, b);
    if (a < b) parent(b) = a;
    if (b < a) parent(a) = b;
}

}  // namespace

bool CutMembrane::fits(const CutMembraneState& state, const MembraneCut& cut) const noexcept {
    std::int32_t contacts = state.free_contact_count;
    for (const std::int32_t root : cut.roots) {
        for (const std::int32_t edge : root_edges_[at(root)]) {
            for (std::int32_t c = state.first_contact[at(edge)]; c >= 0; c = state.contacts[at(c)].next) {
                // An edge between two touched roots is visited from both: its contacts are counted by the
                // first.
                const std::int32_t owner = edges_[at(edge)].roots[0];
                const bool by_owner = std::find(cut.roots.begin(), cut.roots.end(), owner) != cut.roots.end();
                if (owner == root || !by_owner) ++contacts;
            }
        }
    }
    for (const MembranePiece& piece : cut.pieces) {
        if (piece.slot < 0 || piece.slot >= most_pieces_) return false;
    }
    return static_cast<std::size_t>(contacts) >= cut.contacts.size();
}

void CutMembrane::add_spring(CutMembraneState& state, std::size_t spring, std::int32_t a, std::int32_t b,
                             double stiffness) const noexcept {
    if (!(stiffness > 0)) return;
    std::int32_t* end = &state.first_spring[spring];
    for (; *end >= 0; end = &state.next_spring[at(*end)]) {
        if (state.first[at(*end)] == a && state.second[at(*end)] == b) {
            state.stiffness[at(*end)] += stiffness;
            return;
        }
    }
    if (state.free_spring_count == 0) return;
    const bool bend = springs_[spring].kind == SpringKind::bend;
    if (bend && state.bend_count >= most_bends_) return;  // full: dropping a spring only lowers the stiffness
    if (bend) ++state.bend_count;
    const std::int32_t slot = state.free_springs[at(--state.free_spring_count)];
    state.first[at(slot)] = a;
    state.second[at(slot)] = b;
    state.stiffness[at(slot)] = stiffness;
    state.rest[at(slot)] = springs_[spring].rest_length;
    state.next_spring[at(slot)] = -1;
    *end = slot;
    state.spring_end = std::max(state.spring_end, (slot + 4) / 4 * 4);
}

void CutMembrane::make_bend(CutMembraneState& state, std::size_t spring) const noexcept {
    const Source& source = sources_[spring];
    for (std::int8_t i = 0; i < source.side_count; ++i) {
        const Source::Side& side = source.sides[at(i)];
        for_pieces(state, side.near, [&](std::int32_t, const CutMembraneState::Piece& near) {
            for_pieces(state, side.far, [&](std::int32_t, const CutMembraneState::Piece& far) {
                if (near.nodes[at(side.near_middle)] != far.nodes[at(side.far_middle)]) return;
                add_spring(state, spring, near.nodes[at(side.near_corner)], far.nodes[at(side.far_corner)],
                           springs_[spring].stiffness * near.share * far.share / source.side_count);
            });
        });
    }
}

void CutMembrane::make_springs(CutMembraneState& state, std::size_t spring) const noexcept {
    for (std::int32_t slot = state.first_spring[spring]; slot >= 0;) {
        const std::int32_t next = state.next_spring[at(slot)];
        state.first[at(slot)] = state.second[at(slot)] = 0;
        state.stiffness[at(slot)] = state.rest[at(slot)] = 0;
        state.next_spring[at(slot)] = -1;
        state.free_springs[at(state.free_spring_count++)] = slot;
        if (springs_[spring].kind == SpringKind::bend) --state.bend_count;
        slot = next;
    }
    state.first_spring[spring] = -1;
    const double k = springs_[spring].stiffness;
    if (springs_[spring].kind == SpringKind::bend) {
        make_bend(state, spring);
        return;
    }
    const std::int32_t number = sources_[spring].edge;
    const Edge& edge = edges_[at(number)];
    if (springs_[spring].kind == SpringKind::structural) {
        const int sides = edge.roots[1] < 0 ? 1 : 2;
        for (std::size_t i = 0; i < static_cast<std::size_t>(sides); ++i) {
            const Triangle& corners = triangles_[at(edge.roots[i])];
            const auto c = static_cast<std::size_t>(edge.local[i]);
            const bool turned = corners[c] != edge.vertices[0];
            for_pieces(state, edge.roots[i], [&](std::int32_t, const CutMembraneState::Piece& piece) {
                std::int32_t a = piece.nodes[c], b = piece.nodes[(c + 1) % 3];
                if (turned) std::swap(a, b);
                add_spring(state, spring, a, b, k * piece.share / sides);
            });
        }
        return;
    }
    // Across the edge: the share of the edge along which both sides meet, times the smaller one's share of
    // its root's area. So the contacts of a piece together weigh no more than its mass, and none weighs more
    // than before the cut.
    const auto opposite = [&](std::size_t side, std::int32_t piece) {
        return state.pieces[at(piece)].nodes[at((edge.local[side] + 2) % 3)];
    };
    for (std::int32_t c = state.first_contact[at(number)]; c >= 0; c = state.contacts[at(c)].next) {
        const CutMembraneState::Contact& contact = state.contacts[at(c)];
        const double a = state.pieces[at(contact.first)].share, b = state.pieces[at(contact.second)].share;
        const double weight = contact.share * std::min(a, b);
        add_spring(state, spring, opposite(0, contact.first), opposite(1, contact.second), k * weight);
    }
}

void CutMembrane::collect(const CutMembraneState& state, std::int32_t vertex,
                          CutMembraneScratch& scratch) const noexcept {
    scratch.incidences_.clear();
    for (std::int32_t k = around_offsets_[at(vertex)]; k < around_offsets_[at(vertex) + 1]; ++k) {
        const std::int32_t root = around_[at(k)];
        std::int32_t corner = 0;
        while (triangles_[at(root)][at(corner)] != vertex) ++corner;
        for_pieces(state, root, [&](std::int32_t slot, const CutMembraneState::Piece& piece) {
            CutMembraneScratch::Incidence i;
            i.piece = slot;
            i.corner = corner;
            i.parent = static_cast<std::int32_t>(scratch.incidences_.size());
            i.node = piece.nodes[at(corner)];
            i.new_node = -1;
            i.mass = piece.share * root_mass_[at(root)] / 3;
            // An attachment holds the material at its vertex, and an edge between two held vertices.
            i.held = false;
            if (attachment_[at(vertex)] > 0) {
                const std::int32_t next = triangles_[at(root)][at((corner + 1) % 3)],
                                   last = triangles_[at(root)][at((corner + 2) % 3)];
                const int before = (corner + 2) % 3;
                i.held = ((piece.corners >> corner) & 1) != 0 ||
                         (((piece.edges >> corner) & 1) != 0 && attachment_[at(next)] > 0 &&
                          edges_[at(root_edges_[at(root)][at(corner)])].roots[1] < 0) ||
                         (((piece.edges >> before) & 1) != 0 && attachment_[at(last)] > 0 &&
                          edges_[at(root_edges_[at(root)][at(before)])].roots[1] < 0);
            }
            scratch.place_of_piece_[at(slot)] = i.parent;
            scratch.incidences_.push_back(i);
        });
    }
}

void CutMembrane::split_vertex(CutMembraneState& state, std::int32_t vertex,
                               CutMembraneScratch& scratch) const noexcept {
    collect(state, vertex, scratch);
    auto& all = scratch.incidences_;
    const auto parent = [&](std::int32_t i) -> std::int32_t& { return all[at(i)].parent; };
    for (std::int32_t k = around_offsets_[at(vertex)]; k < around_offsets_[at(vertex) + 1]; ++k) {
        for (const std::int32_t edge : root_edges_[at(around_[at(k)])]) {
            const auto& ends = edges_[at(edge)].vertices;
            if (ends[0] != vertex && ends[1] != vertex) continue;
            for (std::int32_t c = state.first_contact[at(edge)]; c >= 0; c = state.contacts[at(c)].next) {
                join(parent, scratch.place_of_piece_[at(state.contacts[at(c)].first)],
                     scratch.place_of_piece_[at(state.contacts[at(c)].second)]);
            }
        }
    }
    const auto count = static_cast<std::int32_t>(all.size());
    for (std::int32_t i = 0; i < count; ++i) {
        const std::int32_t head = class_of(parent, i);
        parent(i) = head;
        if (head == i) continue;
        all[at(head)].mass += all[at(i)].mass;
        all[at(head)].held = all[at(head)].held || all[at(i)].held;
    }
    // The heaviest class of a node keeps the node's number.
    for (std::int32_t i = 0; i < count; ++i) {
        if (parent(i) != i) continue;
        bool keeps = true;
        for (std::int32_t j = 0; j < count && keeps; ++j) {
            if (j == i || parent(j) != j || all[at(j)].node != all[at(i)].node) continue;
            keeps = all[at(i)].mass > all[at(j)].mass || (all[at(i)].mass == all[at(j)].mass && i < j);
        }
        const std::int32_t node = all[at(i)].node;
        std::int32_t mine = node;
        if (!keeps) {
            mine = state.free_nodes[at(--state.free_node_count)];
            state.node_end = std::max(state.node_end, mine + 1);
            state.positions[at(mine)] = state.positions[at(node)];
            state.velocities[at(mine)] = state.velocities[at(node)];
            state.vertex[at(mine)] = vertex;
        }
        all[at(i)].new_node = mine;
        state.masses[at(mine)] = all[at(i)].mass;
        state.held[at(mine)] = all[at(i)].held ? 1 : 0;
    }
    for (std::int32_t i = 0; i < count; ++i)
        state.pieces[at(all[at(i)].piece)].nodes[at(all[at(i)].corner)] = all[at(parent(i))].new_node;
}

bool CutMembrane::part(CutMembraneState& state, const MembraneCut& cut,
                       CutMembraneScratch& scratch) const noexcept {
    if (!fits(state, cut)) return false;
    ++scratch.stamp_;
    scratch.vertices_.clear();
    // All old pieces are read before the first new one is written, which may reuse their slots.
    for (const std::int32_t root : cut.roots) remove_pieces(state, root, scratch);
    for (const std::int32_t root : cut.roots) state.first_piece[at(root)] = -1;
    add_pieces(state, cut, scratch);
    free_unused_nodes(state, scratch);
    for (const std::int32_t v : scratch.vertices_) split_vertex(state, v, scratch);
    remake_springs(state, scratch);
    find_isolated(state, scratch);
    ++state.topology;
    return true;
}

void CutMembrane::remove_pieces(CutMembraneState& state, std::int32_t root,
                                CutMembraneScratch& scratch) const noexcept {
    for (std::int32_t slot = state.first_piece[at(root)]; slot >= 0;) {
        CutMembraneState::Piece& piece = state.pieces[at(slot)];
        const std::int32_t next = piece.next;
        scratch.old_nodes_[at(slot)] = piece.nodes;
        state.removed_mass += piece.share * root_mass_[at(root)];
        piece = CutMembraneState::Piece();
        slot = next;
    }
    for (const std::int32_t edge : root_edges_[at(root)]) {
        for (std::int32_t c = state.first_contact[at(edge)]; c >= 0;) {
            const std::int32_t next = state.contacts[at(c)].next;
            state.contacts[at(c)] = CutMembraneState::Contact();
            state.free_contacts[at(state.free_contact_count++)] = c;
            c = next;
        }
        state.first_contact[at(edge)] = -1;
    }
    for (const std::int32_t v : triangles_[at(root)]) {
        if (scratch.vertex_stamp_[at(v)] == scratch.stamp_) continue;
        scratch.vertex_stamp_[at(v)] = scratch.stamp_;
        scratch.vertices_.push_back(v);
    }
}

void CutMembrane::add_pieces(CutMembraneState& state, const MembraneCut& cut,
                             const CutMembraneScratch& scratch) const noexcept {
    for (const MembranePiece& from : cut.pieces) {
        CutMembraneState::Piece& piece = state.pieces[at(from.slot)];
        piece.root = from.root;
        piece.share = from.share;
        piece.corners = from.corners;
        piece.edges = from.edges;
        piece.nodes = scratch.old_nodes_[at(from.from)];
        piece.next = state.first_piece[at(from.root)];
        state.first_piece[at(from.root)] = from.slot;
        state.removed_mass -= from.share * root_mass_[at(from.root)];
    }
    for (const PieceContact& from : cut.contacts) {
        const std::int32_t c = state.free_contacts[at(--state.free_contact_count)];
        CutMembraneState::Contact& contact = state.contacts[at(c)];
        contact.first = from.first;
        contact.second = from.second;
        const std::int32_t root = state.pieces[at(contact.first)].root;
        const std::int32_t edge = root_edges_[at(root)][at(from.edge)];
        if (edges_[at(edge)].roots[0] != root) std::swap(contact.first, contact.second);
        contact.share = from.share;
        contact.next = state.first_contact[at(edge)];
        state.first_contact[at(edge)] = c;
    }
}

void CutMembrane::free_unused_nodes(CutMembraneState& state, CutMembraneScratch& scratch) const noexcept {
    for (const std::int32_t v : scratch.vertices_) {
        collect(state, v, scratch);
        for (const auto& incidence : scratch.incidences_)
            scratch.node_stamp_[at(incidence.node)] = scratch.stamp_;
    }
    for (std::int32_t n = 0; n < state.node_end; ++n) {
        const std::int32_t v = state.vertex[at(n)];
        if (v < 0 || scratch.vertex_stamp_[at(v)] != scratch.stamp_ ||
            scratch.node_stamp_[at(n)] == scratch.stamp_)
            continue;
        state.vertex[at(n)] = -1;
        state.masses[at(n)] = 0;
        state.held[at(n)] = state.isolated[at(n)] = 0;
        state.velocities[at(n)].setZero();
        state.free_nodes[at(state.free_node_count++)] = n;
    }
}

void CutMembrane::remake_springs(CutMembraneState& state, CutMembraneScratch& scratch) const noexcept {
    for (const std::int32_t v : scratch.vertices_) {
        for (std::int32_t k = around_offsets_[at(v)]; k < around_offsets_[at(v) + 1]; ++k) {
            const std::int32_t root = around_[at(k)];
            for (std::int32_t u = use_offsets_[at(root)]; u < use_offsets_[at(root) + 1]; ++u) {
                const std::int32_t spring = uses_[at(u)];
                if (scratch.spring_stamp_[at(spring)] == scratch.stamp_) continue;
                scratch.spring_stamp_[at(spring)] = scratch.stamp_;
                make_springs(state, at(spring));
            }
        }
    }
}

void CutMembrane::find_isolated(CutMembraneState& state, CutMembraneScratch& scratch) const noexcept {
    const auto parent = [&](std::int32_t i) -> std::int32_t& { return scratch.parent_[at(i)]; };
    for (std::int32_t n = 0; n < state.node_end; ++n) parent(n) = n;
    for (std::size_t r = 0; r < triangles_.size(); ++r) {
        for_pieces(state, static_cast<std::int32_t>(r),
                   [&](std::int32_t, const CutMembraneState::Piece& piece) {
                       join(parent, piece.nodes[0], piece.nodes[1]);
                       join(parent, piece.nodes[0], piece.nodes[2]);
                   });
    }
    for (std::int32_t n = 0; n < state.node_end; ++n) state.isolated[at(n)] = 1;
    for (std::int32_t n = 0; n < state.node_end; ++n) {
        if (state.held[at(n)] != 0) state.isolated[at(class_of(parent, n))] = 0;
    }
    for (std::int32_t n = 0; n < state.node_end; ++n)
        state.isolated[at(n)] = state.vertex[at(n)] >= 0 ? state.isolated[at(class_of(parent, n))] : 0;
    for (std::size_t r = 0; r < triangles_.size(); ++r) {
        for (std::int32_t p = state.first_piece[r]; p >= 0; p = state.pieces[at(p)].next)
            state.pieces[at(p)].isolated = state.isolated[at(state.pieces[at(p)].nodes[0])] != 0;
    }
}

}  // namespace fulcrum
