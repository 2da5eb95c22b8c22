// SPDX-License-Identifier: Apache-2.0
// Tidies the triangles of a cut within their roots: children only, and only where the union of the triangles
// stays the same (docs/THEORY.md, section 5). A vertex inside one root may move to any neighbour, one on the
// edge of two roots along that edge, one on the border along a straight border.
#include <algorithm>
#include <cmath>

#include "sim_core/cutting/cut_mesh.h"

namespace fulcrum {
namespace {

constexpr double good_enough = 0.25;  // quality above which no collapse is needed; 1: equilateral
constexpr double sliver = 0.1;        // quality below which the 1/8-area rule applies to a triangle
constexpr double straight = 1e-13;    // share of a root by which a collapse along the border may change area

}  // namespace

double CutMesh::quality(std::int32_t root, double share, std::int32_t a, std::int32_t b,
                        std::int32_t c) const {
    const Vector3 &x = state_.vertices[a].rest, &y = state_.vertices[b].rest, &z = state_.vertices[c].rest;
    const double squares = (y - x).squaredNorm() + (z - y).squaredNorm() + (x - z).squaredNorm();
    constexpr double four_root_three = 6.928203230275509;
    return squares > 0 ? four_root_three * share * model_->areas[static_cast<std::size_t>(root)] / squares
                       : -1;
}

double CutMesh::quality(const CutTriangle& triangle) const {
    return quality(triangle.root, triangle.share, triangle.vertices[0], triangle.vertices[1],
                   triangle.vertices[2]);
}

double CutMesh::quality(std::int32_t root, std::int32_t a, std::int32_t b, std::int32_t c) const {
    Vector3 at_a, at_b, at_c;
    if (!barycentric_in(*model_, state_.vertices[a], root, at_a) ||
        !barycentric_in(*model_, state_.vertices[b], root, at_b) ||
        !barycentric_in(*model_, state_.vertices[c], root, at_c))
        return -1;
    const double share = share_of(at_a, at_b, at_c);
    return share > 10 * least_share ? quality(root, share, a, b, c) : -1;
}

double CutMesh::worst_after(std::int32_t from, std::int32_t to, double enough) const {
    // around_ holds the triangles of `from`; the search stops once the quality falls below `enough`.
    double after = 1;
    for (const std::int32_t t : around_) {
        const CutTriangle& row = state_.triangles[t];
        const std::int32_t a = row.vertices[0], b = row.vertices[1], c = row.vertices[2];
        if (a == to || b == to || c == to) continue;
        after =
            std::min(after, quality(row.root, a == from ? to : a, b == from ? to : b, c == from ? to : c));
        if (after < enough) break;
    }
    return after;
}

bool CutMesh::tidy_vertex(std::int32_t vertex) {
    const CutVertex& here = state_.vertices[vertex];
    // A vertex that was divided stays: otherwise its other half would be inside an edge.
    if (vertex < model_->original_vertices || here.triangle < 0 || here.divided) return true;
    bool closed = false;
    around_.clear();
    for (const std::int32_t t : editor_.fan(vertex, closed))
        if (!around_.push(t)) return true;
    const std::int32_t count = around_.size();
    if (count < 2) return true;
    std::int32_t roots[2] = {state_.triangles[around_[0]].root, -1};
    for (const std::int32_t t : around_) {
        const std::int32_t r = state_.triangles[t].root;
        if (model_->flat[static_cast<std::size_t>(r)]) return true;
        if (r == roots[0] || r == roots[1]) continue;
        if (roots[1] >= 0) return true;
        roots[1] = r;
    }
    if (!closed && roots[1] >= 0) return true;
    std::int32_t next = -1, before = -1;
    if (!closed) {
        const CutTriangle &first = state_.triangles[around_[0]], &last = state_.triangles[around_[count - 1]];
        next = vertex_at(first, corner_of(first, vertex) + 1);
        before = vertex_at(last, corner_of(last, vertex) + 2);
        Vector3 middle, one, other;
        if (!barycentric_in(*model_, here, roots[0], middle) ||
            !barycentric_in(*model_, state_.vertices[next], roots[0], one) ||
            !barycentric_in(*model_, state_.vertices[before], roots[0], other))
            return true;
        if (std::abs(share_of(one, middle, other)) > straight || !((one - middle).dot(other - middle) < 0))
            return true;
    }
    std::int32_t best = -1;
    double best_after = 0, enough = good_enough;
    for (const std::int32_t t : around_) enough = std::min(enough, quality(state_.triangles[t]));
    const auto consider = [&](std::int32_t to) {
        const double after = worst_after(vertex, to, std::max(enough, best_after));
        if (after <= best_after || after < enough) return;
        best_after = after;
        best = to;
    };
    if (!closed) {
        consider(next);
        consider(before);
    }
    for (std::int32_t k = 0; closed && k < count; ++k) {
        const CutTriangle& row = state_.triangles[around_[k]];
        const std::int32_t to = vertex_at(row, corner_of(row, vertex) + 1);
        if (roots[1] >= 0) {
            Vector3 ignored;
            if (!barycentric_in(*model_, state_.vertices[to], roots[0], ignored) ||
                !barycentric_in(*model_, state_.vertices[to], roots[1], ignored))
                continue;
        }
        consider(to);
    }
    if (best >= 0) editor_.collapse(vertex, best);
    return editor_.lacking() == CutLimit::none;
}

bool CutMesh::tidy() {
    // All vertices that were touched, in the order in which they were touched.
    ++mark_;
    parts_.clear();
    for (const std::int32_t t : editor_.touched_triangles()) {
        if (!editor_.visible(t)) continue;
        for (const std::int32_t v : state_.triangles[t].vertices) {
            if (vertex_mark_[v] == mark_) continue;
            vertex_mark_[v] = mark_;
            if (v >= model_->original_vertices) parts_.push(v);
        }
    }
    for (const std::int32_t v : parts_)
        if (!tidy_vertex(v)) return false;
    return tidy_slivers() && turn_edges();
}

bool CutMesh::tidy_slivers() {
    // The 1/8-area rule: if a root's visible children are that small on average, the shortest edge of each
    // obtuse sliver among them is collapsed where allowed.
    for (std::int32_t i = 0; i < editor_.touched_roots().size(); ++i) {
        const std::int32_t r = editor_.touched_roots()[i];
        const CutRoot& root = state_.roots[r];
        if (root.visible_count == 0 || model_->flat[static_cast<std::size_t>(r)] ||
            8 * (1 - root.removed_share) >= root.visible_count)
            continue;
        parts_.clear();
        for (std::int32_t t = root.first_visible; t >= 0; t = state_.triangles[t].next_in_root)
            parts_.push(t);
        for (std::int32_t p = 0; p < parts_.size(); ++p) {
            const std::int32_t t = parts_[p];
            if (!visible(t)) continue;
            const CutTriangle row = state_.triangles[t];
            if (quality(row) > sliver) continue;
            double squares[3];
            for (int e = 0; e < 3; ++e)
                squares[e] =
                    (state_.vertices[vertex_at(row, e)].rest - state_.vertices[vertex_at(row, e + 1)].rest)
                        .squaredNorm();
            const int shortest = static_cast<int>(std::min_element(squares, squares + 3) - squares);
            const double longest = *std::max_element(squares, squares + 3);
            if (longest < squares[0] + squares[1] + squares[2] - longest)
                continue;  // no angle above 90 degrees
            if (!tidy_vertex(vertex_at(row, shortest))) return false;
            if (visible(t) && !tidy_vertex(vertex_at(row, shortest + 1))) return false;
        }
    }
    return true;
}

bool CutMesh::turn_edges() {
    // Flips diagonals within a root if that improves the worse of two triangles.
    parts_.clear();
    for (const std::int32_t t : editor_.touched_triangles())
        if (editor_.visible(t)) parts_.push(t);
    for (int pass = 0; pass < 2; ++pass) {
        bool turned = false;
        for (std::int32_t p = 0; p < parts_.size(); ++p) {
            for (int e = 0; e < 3; ++e) {
                const std::int32_t t = parts_[p];
                if (!visible(t)) break;
                const CutTriangle& row = state_.triangles[t];
                const std::int32_t n = neighbour_at(row, e);
                if (n < 0 || (n < t && editor_.touched(n)) || state_.triangles[n].root != row.root ||
                    model_->flat[static_cast<std::size_t>(row.root)])
                    continue;
                const CutTriangle& over = state_.triangles[n];
                const std::int32_t a = vertex_at(row, e), b = vertex_at(row, e + 1),
                                   c = vertex_at(row, e + 2);
                const int back = edge_of(over, b, a);
                if (back < 0) continue;
                const std::int32_t d = vertex_at(over, back + 2);
                const double now = std::min(quality(row), quality(over));
                if (now > 0.8) continue;
                const double then = std::min(quality(row.root, a, d, c), quality(row.root, d, b, c));
                if (then < 1.05 * now || then <= 0) continue;
                editor_.made().clear();
                if (!editor_.flip(t, e)) {
                    if (editor_.lacking() != CutLimit::none) return false;
                    continue;
                }
                parts_[p] = editor_.made()[0];
                turned = true;
            }
        }
        if (!turned) break;
    }
    return true;
}

}  // namespace fulcrum
