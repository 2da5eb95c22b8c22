// SPDX-License-Identifier: Apache-2.0
// Fragments of roots and pieces of the surface (cut_mesh.h).
#include <algorithm>
#include <cmath>

#include "sim_core/cutting/cut_mesh.h"

namespace fulcrum {

bool CutMesh::sort_fragments() {
    // Recomputes each touched root: its parts connected by shared edges. Of the parts of one fragment the one
    // with the largest area keeps the number.
    for (const std::int32_t r : editor_.touched_roots()) {
        parts_.clear();  // first triangle of each part
        ++mark_;
        const std::int32_t first = state_.roots[r].first_visible;
        const std::uint32_t base = mark_;
        for (std::int32_t t = first; t >= 0; t = state_.triangles[t].next_in_root) {
            if (triangle_mark_[t] >= base) continue;
            if (!parts_.push(t)) return false;
            const std::uint32_t name = mark_++;
            queue_.clear();
            queue_.push(t);
            triangle_mark_[t] = name;
            for (std::int32_t head = 0; head < queue_.size(); ++head) {
                for (const std::int32_t n : state_.triangles[queue_[head]].neighbours) {
                    if (n < 0 || state_.triangles[n].root != r || triangle_mark_[n] >= base) continue;
                    triangle_mark_[n] = name;
                    queue_.push(n);
                }
            }
        }
        // Fragments of this root: all that its triangles inherited, and any that have no triangle left.
        for (std::int32_t f = r; f >= 0;) {
            std::int32_t best = -1;
            double best_share = -1;
            for (std::int32_t p = 0; p < parts_.size(); ++p) {
                if (parts_[p] < 0 || state_.triangles[parts_[p]].fragment != f) continue;
                double share = 0;
                for (std::int32_t t = first; t >= 0; t = state_.triangles[t].next_in_root)
                    if (triangle_mark_[t] == base + static_cast<std::uint32_t>(p))
                        share += state_.triangles[t].share;
                if (share > best_share) {
                    best_share = share;
                    best = p;
                }
            }
            for (std::int32_t p = 0; p < parts_.size(); ++p) {
                if (p == best || parts_[p] < 0 || state_.triangles[parts_[p]].fragment != f) continue;
                const std::int32_t fresh = editor_.new_fragment(r, f);
                if (fresh < 0) return false;
                for (std::int32_t t = first; t >= 0; t = state_.triangles[t].next_in_root)
                    if (triangle_mark_[t] == base + static_cast<std::uint32_t>(p))
                        editor_.edit_triangle(t).fragment = fresh;
                parts_[p] = -1 - fresh;
            }
            f = state_.fragments[f].next_of_root;
        }
        for (std::int32_t f = r; f >= 0; f = state_.fragments[f].next_of_root) {
            CutFragment& row = editor_.edit_fragment(f);
            row.triangles = 0;
            row.share = 0;
        }
        for (std::int32_t t = first; t >= 0; t = state_.triangles[t].next_in_root) {
            CutFragment& row = editor_.edit_fragment(state_.triangles[t].fragment);
            ++row.triangles;
            row.share += state_.triangles[t].share;
        }
    }
    return true;
}

std::int32_t CutMesh::contacts_of(std::int32_t fragment, FragmentContact* contacts, std::int32_t room) const {
    const std::int32_t root = state_.fragments[fragment].root;
    std::int32_t count = 0;
    for (std::int32_t t = state_.roots[root].first_visible; t >= 0; t = state_.triangles[t].next_in_root) {
        const CutTriangle& row = state_.triangles[t];
        if (row.fragment != fragment) continue;
        Vector3 at[3];
        for (int i = 0; i < 3; ++i)
            if (!barycentric_in(*model_, state_.vertices[vertex_at(row, i)], root, at[i])) return count;
        for (int i = 0; i < 3; ++i) {
            const Vector3 &a = at[i], &b = at[(i + 1) % 3];
            for (int e = 0; e < 3; ++e) {
                const int opposite = (e + 2) % 3;
                if (a[opposite] != 0 || b[opposite] != 0) continue;
                const std::int32_t n = neighbour_at(row, i);
                const std::int32_t other = n < 0 ? -1 : state_.triangles[n].fragment;
                const double length = std::abs(b[e] - a[e]);
                std::int32_t k = 0;
                while (k < count && k < room && (contacts[k].edge != e || contacts[k].other != other)) ++k;
                if (k < std::min(count, room)) {
                    contacts[k].length_share += length;
                } else {
                    if (count < room) contacts[count] = {e, other, length};
                    ++count;
                }
            }
        }
    }
    return count;
}

std::int32_t CutMesh::find_pieces() {
    pieces_.clear();
    ++mark_;
    for (std::int32_t seed = 0; seed < state_.triangle_count; ++seed) {
        if (!visible(seed)) {
            piece_of_[seed] = -1;
            continue;
        }
        if (triangle_mark_[seed] == mark_) continue;
        CutPiece piece;
        piece.first = seed;
        queue_.clear();
        queue_.push(seed);
        triangle_mark_[seed] = mark_;
        for (std::int32_t head = 0; head < queue_.size(); ++head) {
            const std::int32_t t = queue_[head];
            const CutTriangle& row = state_.triangles[t];
            piece_of_[t] = pieces_.size();
            ++piece.triangles;
            piece.area += row.share * model_->areas[static_cast<std::size_t>(row.root)];
            for (const std::int32_t v : row.vertices) piece.fixed = piece.fixed || state_.vertices[v].fixed;
            for (const std::int32_t n : row.neighbours) {
                if (n < 0 || triangle_mark_[n] == mark_) continue;
                triangle_mark_[n] = mark_;
                queue_.push(n);
            }
        }
        pieces_.push(piece);
    }
    return pieces_.size();
}

std::int32_t CutMesh::find_parted(std::int32_t* firsts, std::int32_t room) {
    // Breadth first from all triangles that the cut touched at once: sides that meet are one piece.
    sides_met_.clear();
    queue_.clear();
    ++mark_;
    std::int32_t undecided = 0;
    bool held = false;  // one side is known to be held; otherwise the last undecided one must be
    const auto take = [&](std::int32_t t, std::int32_t side) {
        triangle_mark_[t] = mark_;
        piece_of_[t] = side;
        queue_.push(t);
        ++sides_met_[side].open;
        for (const std::int32_t v : state_.triangles[t].vertices) {
            if (!state_.vertices[v].fixed || sides_met_[side].fixed) continue;
            sides_met_[side].fixed = held = true;
            --undecided;
        }
    };
    for (const std::int32_t r : editor_.touched_roots()) {
        for (std::int32_t t = state_.roots[r].first_visible; t >= 0; t = state_.triangles[t].next_in_root) {
            sides_met_.push({t, -1, 0, false});
            ++undecided;
            take(t, sides_met_.size() - 1);
        }
    }
    std::int32_t parted = 0;
    for (std::int32_t head = 0; head < queue_.size(); ++head) {
        if (undecided == 0 || (undecided == 1 && !held)) break;
        const std::int32_t t = queue_[head];
        std::int32_t side = side_of(piece_of_[t]);
        for (const std::int32_t n : state_.triangles[t].neighbours) {
            if (n < 0) continue;
            if (triangle_mark_[n] != mark_) {
                take(n, side);
                continue;
            }
            const std::int32_t other = side_of(piece_of_[n]);
            if (other == side) continue;
            Side &kept = sides_met_[std::min(side, other)], &gone = sides_met_[std::max(side, other)];
            if (!kept.fixed || !gone.fixed) --undecided;
            kept.open += gone.open;
            kept.fixed = kept.fixed || gone.fixed;
            gone.parent = std::min(side, other);
            side = std::min(side, other);
        }
        Side& here = sides_met_[side];
        if (--here.open > 0 || here.fixed) continue;
        --undecided;  // all of it was visited
        if (parted < room) firsts[parted] = here.first;
        ++parted;
    }
    return parted;
}

}  // namespace fulcrum
