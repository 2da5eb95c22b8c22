// SPDX-License-Identifier: Apache-2.0
// What becomes of a cut in springs, places and pieces.
#include <algorithm>
#include <cmath>

#include "sim_core/world/parts/sheet/sheet_body.h"

namespace fulcrum {

using sheet_rows::at;

using namespace blade_law;

namespace {

constexpr double line_reach = 0.012;  // m from the marked line within which a cut divides the sheet across it
constexpr double kept_slack = 1e-6;
constexpr std::uint16_t loose_steps = 200;  // what has come free falls for so long, then it is removed

}  // namespace

CutReport SheetBody::cut(const BladeStep& blade) noexcept {
    const CutReport report = surface_.cut(blade, state_.positions.data());
    if (report.outcome == CutOutcome::cut) {
        take_over();
        note_loose(tick_);
    }
    return report;
}

void SheetBody::remake_pieces() noexcept {
    cut_.clear();
    for (const std::int32_t root : surface_.touched_roots()) {
        cut_.roots.push_back(root);
        touched_[at(root)] = 1;
    }
    for (const std::int32_t root : surface_.touched_roots()) {
        for (std::int32_t f = root; f >= 0; f = surface_.fragment(f).next_of_root) {
            const CutFragment& row = surface_.fragment(f);
            if (row.triangles == 0) continue;
            MembranePiece piece;
            piece.slot = f;
            piece.root = root;
            piece.share = row.share;
            piece.from = f;
            while (state_.membrane.pieces[at(piece.from)].root < 0)
                piece.from = surface_.fragment(piece.from).from;
            if (piece.from != f) state_.loose[at(f)] = state_.loose[at(piece.from)];
            for (std::int32_t t = surface_.root(root).first_visible; t >= 0;
                 t = surface_.triangle(t).next_in_root) {
                if (surface_.fragment_of_triangle(t) != f) continue;
                for (const std::int32_t v : surface_.triangle(t).vertices) {
                    Vector3 b;
                    if (!barycentric_in(surface_.model(), surface_.vertex(v), root, b)) continue;
                    for (int c = 0; c < 3; ++c) {
                        if (b[c] == 1) piece.corners = static_cast<std::uint8_t>(piece.corners | 1 << c);
                    }
                }
            }
            FragmentContact contacts[32];
            const std::int32_t count = std::min(surface_.contacts_of(f, contacts, 32), 32);
            for (std::int32_t c = 0; c < count; ++c) {
                const FragmentContact& contact = contacts[c];
                if (!(contact.length_share > 0)) continue;
                piece.edges = static_cast<std::uint8_t>(piece.edges | 1 << contact.edge);
                if (contact.other < 0) continue;
                const bool both = touched_[at(surface_.fragment(contact.other).root)] != 0;
                if (both && contact.other < f) continue;  // named by the other
                cut_.contacts.push_back({f, contact.other, contact.edge, contact.length_share});
            }
            cut_.pieces.push_back(piece);
        }
    }
    for (const std::int32_t root : cut_.roots) touched_[at(root)] = 0;
}

void SheetBody::take_over() noexcept {
    // Where tips are, before their tissue changes.
    std::array<Vector3, hand_count> tips;
    for (std::size_t h = 0; h < hand_count; ++h) tips[h] = place(state_.hands[h].place);
    remake_pieces();
    if (!membrane_.part(state_.membrane, cut_, scratch_)) faults_ = 2;
    list_visible();
    const MeshAdjacency& adjacency = surface_.model().adjacency;
    for (const std::int32_t root : cut_.roots) {
        for (const std::int32_t corner : layout_.mesh.triangles[at(root)]) {
            for (const std::int32_t near : adjacency.triangles_of(corner)) {
                for (std::int32_t t = surface_.root(near).first_visible; t >= 0;
                     t = surface_.triangle(t).next_in_root) {
                    for (const std::int32_t v : surface_.triangle(t).vertices) bind(v);
                }
            }
        }
    }
    // A vertex that is gone hangs on nothing: what it hung on may be gone too.
    for (std::int32_t v = 0; v < surface_.vertex_count(); ++v) {
        if (surface_.vertex(v).triangle < 0) state_.bindings[at(v)] = SheetPlace();
    }
    update_positions();
    for (const std::int32_t root : cut_.roots) touched_[at(root)] = 1;
    const auto changed = [&](const SheetPlace& where) {
        return where.fragment >= 0 && touched_[at(surface_.fragment(where.fragment).root)] != 0;
    };
    for (std::size_t h = 0; h < hand_count; ++h) {
        SheetHand& hand = state_.hands[h];
        if (changed(hand.place)) {
            hand.place = closest(tips[h]);
            if ((place(hand.place) - tips[h]).norm() > off_by) hand.place = SheetPlace();
            hand.linked = hand.linked && hand.place.fragment >= 0;
        }
        // Jaws keep what is still between them.
        std::size_t kept = 0;
        for (std::size_t g = 0; kept < static_cast<std::size_t>(hand.jaws.count()); ++g) {
            SheetPlace held = hand.held_at[g];
            if (changed(held))
                held = find_in_root(surface_.fragment(held.fragment).root, held.barycentric, kept_slack);
            if (held.fragment >= 0) {
                hand.held_at[kept++] = held;
            } else {
                hand.jaws.drop_point(static_cast<int>(kept));
            }
        }
    }
    for (SheetPlace& point : state_.line) {
        if (!changed(point)) continue;
        const SheetPlace found = find_in_root(surface_.fragment(point.fragment).root, point.barycentric, 1e9);
        point.fragment = found.fragment;
        point.triangle = found.triangle;
    }
    for (const std::int32_t root : cut_.roots) touched_[at(root)] = 0;
}

void SheetBody::note_loose(std::uint32_t tick) noexcept {
    state_.any_loose = 0;
    bool fresh = false;
    for (std::int32_t f = 0; f < surface_.fragment_count(); ++f) {
        if (surface_.fragment(f).triangles == 0 || !state_.membrane.pieces[at(f)].isolated) continue;
        ++state_.any_loose;
        fresh = fresh || state_.loose[at(f)] == 0;
    }
    if (!fresh) return;
    const std::int32_t pieces = surface_.find_pieces();
    for (std::int32_t p = 0; p < pieces; ++p) {
        const CutPiece& piece = surface_.piece(p);
        const std::int32_t fragment = surface_.fragment_of_triangle(piece.first);
        if (piece.fixed || state_.loose[at(fragment)] != 0) continue;
        add_event(tick, EventKind::piece_fallen, -1, piece.area, 0);
    }
    for (const VisibleTriangle& t : visible_) {
        const std::int32_t fragment = surface_.fragment_of_triangle(t.number);
        if (state_.membrane.pieces[at(fragment)].isolated && state_.loose[at(fragment)] == 0)
            state_.loose[at(fragment)] = 1;
    }
}

void SheetBody::drop_loose(std::uint32_t tick) noexcept {
    if (state_.any_loose == 0) return;
    std::int32_t due = -1;
    for (std::int32_t f = 0; f < surface_.fragment_count(); ++f) {
        std::uint16_t& age = state_.loose[at(f)];
        if (age == 0 || surface_.fragment(f).triangles == 0) continue;
        if (age <= loose_steps) ++age;
        if (age > loose_steps && due < 0) due = f;
    }
    if (due < 0) return;
    surface_.find_pieces();
    for (std::int32_t t = surface_.root(surface_.fragment(due).root).first_visible; t >= 0;
         t = surface_.triangle(t).next_in_root) {
        if (surface_.fragment_of_triangle(t) != due) continue;
        const std::int32_t piece = surface_.piece_of_triangle(t);
        if (jaws_hold(piece)) {  // it hangs in the jaws: asked again when it has fallen for as long
            for (const VisibleTriangle& v : visible_) {
                if (surface_.piece_of_triangle(v.number) == piece)
                    state_.loose[at(surface_.fragment_of_triangle(v.number))] = 1;
            }
            return;
        }
        if (surface_.remove_piece(piece, state_.positions.data()).outcome == CutOutcome::cut) {
            take_over();
            note_loose(tick);
        }
        return;
    }
}

bool SheetBody::jaws_hold(std::int32_t piece) const noexcept {
    for (const SheetHand& hand : state_.hands) {
        for (int g = 0; hand.jaws.held() && g < hand.jaws.count(); ++g) {
            const std::int32_t triangle = hand.held_at[static_cast<std::size_t>(g)].triangle;
            if (triangle >= 0 && surface_.piece_of_triangle(triangle) == piece) return true;
        }
    }
    return false;
}

void SheetBody::mark_divided(const Vector3& from, const Vector3& to) noexcept {
    Vector3 way = to - from;
    const double length = way.norm();
    if (!(length > 0)) return;
    const Vector3 begin = from - overlap / length * way, end = to + overlap / length * way;
    for (std::size_t i = 0; i < state_.divided.size(); ++i) {
        const double x = line_positions_[i];
        if ((begin.x() - x) * (end.x() - x) > 0 || begin.x() == end.x()) continue;
        const double y = begin.y() + (x - begin.x()) / (end.x() - begin.x()) * (end.y() - begin.y());
        if (std::abs(y) < line_reach) state_.divided[i] = 1;
    }
}

}  // namespace fulcrum
