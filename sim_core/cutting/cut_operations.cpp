// SPDX-License-Identifier: Apache-2.0
// The primitive operations (cut_editor.h).
#include <cmath>

#include "sim_core/cutting/cut_editor.h"

namespace fulcrum {
namespace {

constexpr auto at = [](int i) { return static_cast<std::size_t>(i % 3); };

}  // namespace

std::int32_t CutEditor::split_edge(std::int32_t triangle, int edge, double share) {
    const std::int32_t other = neighbour_at(state_->triangles[triangle], edge);
    if (!has_room(1, 4)) return -1;
    const std::int32_t a = vertex_at(state_->triangles[triangle], edge);
    const std::int32_t b = vertex_at(state_->triangles[triangle], edge + 1);
    const std::int32_t root = state_->triangles[triangle].root;
    Vector3 first, second;
    if (!barycentric_in(*model_, state_->vertices[a], root, first) ||
        !barycentric_in(*model_, state_->vertices[b], root, second))
        return -1;
    const std::int32_t m = new_vertex();
    CutVertex& vertex = edit_vertex(m);
    vertex.root = root;
    vertex.barycentric = (1 - share) * first + share * second;
    vertex.rest = (1 - share) * state_->vertices[a].rest + share * state_->vertices[b].rest;
    vertex.fixed = state_->vertices[a].fixed && state_->vertices[b].fixed;
    positions_[m] = (1 - share) * positions_[a] + share * positions_[b];

    // Each side (x, y, z) with the edge xy becomes (x, m, z) and (m, y, z).
    const auto divide = [&](std::int32_t t, int e, double part, std::int32_t halves[2]) {
        const CutTriangle old = state_->triangles[t];
        const std::int32_t y = vertex_at(old, e + 1), z = vertex_at(old, e + 2);
        const std::int32_t near = reshape(t), far = sibling(near);
        CutTriangle& one = edit_triangle(near);
        one.vertices[at(e + 1)] = m;
        one.share = part * old.share;
        CutTriangle& two = edit_triangle(far);
        two.vertices = {m, y, z};
        two.share = old.share - one.share;
        two.neighbours = {-1, -1, -1};
        one.neighbours[at(e)] = -1;
        link(near, (e + 2) % 3, neighbour_at(old, e + 2));
        link(far, 1, neighbour_at(old, e + 1));
        link(near, (e + 1) % 3, far);
        settle(near);
        settle(far);
        halves[0] = near;
        halves[1] = far;
    };
    std::int32_t mine[2], theirs[2];
    int opposite = -1;
    if (other >= 0) opposite = edge_of(state_->triangles[other], b, a);
    divide(triangle, edge, share, mine);
    if (other >= 0 && opposite >= 0) {
        divide(other, opposite, 1 - share, theirs);
        link(mine[0], edge_of(state_->triangles[mine[0]], a, m), theirs[1]);
        link(mine[1], edge_of(state_->triangles[mine[1]], m, b), theirs[0]);
    }
    return m;
}

bool CutEditor::remove(const CutList<std::int32_t>& doomed) {
    ++removal_;
    for (const std::int32_t t : doomed) doomed_stamp_[t] = removal_;
    // Vertices first, while the fans around them are still complete.
    for (const std::int32_t t : doomed) {
        for (const std::int32_t v : state_->triangles[t].vertices) {
            if (divided_stamp_[v] == removal_) continue;
            divided_stamp_[v] = removal_;
            bool closed = false;
            const CutList<std::int32_t>& around = fan(v, closed);
            const std::int32_t count = around.size();
            if (count == 0) continue;
            std::int32_t start = 0;
            while (start < count && doomed_stamp_[around[start]] != removal_) ++start;
            std::int32_t name = -1;  // vertex for the current run of kept triangles
            bool first_run = true, in_run = false;
            const std::int32_t begin = closed ? start : 0;
            for (std::int32_t k = 0; k < count; ++k) {
                const std::int32_t here = around[(begin + k) % count];
                if (doomed_stamp_[here] == removal_) {
                    in_run = false;
                    continue;
                }
                if (!in_run) {
                    in_run = true;
                    if (first_run) {
                        name = v;
                        first_run = false;
                    } else {
                        if (!has_room(1, 0)) return false;
                        name = new_vertex();
                        divided_stamp_[name] = removal_;
                        edit_vertex(v).divided = true;
                        edit_vertex(name) = state_->vertices[v];
                        positions_[name] = positions_[v];
                    }
                    edit_vertex(name).triangle = here;
                }
                if (name != v) edit_triangle(here).vertices[at(corner_of(state_->triangles[here], v))] = name;
            }
            if (first_run) edit_vertex(v).triangle = -1;
        }
    }
    for (const std::int32_t t : doomed) {
        const CutTriangle old = state_->triangles[t];
        for (const std::int32_t n : old.neighbours) {
            if (n < 0 || doomed_stamp_[n] == removal_) continue;
            CutTriangle& row = edit_triangle(n);
            for (std::int32_t& back : row.neighbours)
                if (back == t) back = -1;
        }
        hide(t, CutTriangleState::removed);
        edit_root(old.root).removed_share += old.share;
        const double area = old.share * model_->areas[static_cast<std::size_t>(old.root)];
        state_->area_visible -= area;
        state_->area_removed += area;
    }
    return true;
}

bool CutEditor::flip(std::int32_t triangle, int edge) {
    const CutTriangle t = state_->triangles[triangle];
    const std::int32_t other = neighbour_at(t, edge);
    if (other < 0 || state_->triangles[other].root != t.root) return false;
    const CutTriangle u = state_->triangles[other];
    const std::int32_t a = vertex_at(t, edge), b = vertex_at(t, edge + 1), c = vertex_at(t, edge + 2);
    const int back = edge_of(u, b, a);
    if (back < 0) return false;
    const std::int32_t d = vertex_at(u, back + 2);
    if (c == d) return false;
    Vector3 at_a, at_b, at_c, at_d;
    if (!barycentric_in(*model_, state_->vertices[a], t.root, at_a) ||
        !barycentric_in(*model_, state_->vertices[b], t.root, at_b) ||
        !barycentric_in(*model_, state_->vertices[c], t.root, at_c) ||
        !barycentric_in(*model_, state_->vertices[d], t.root, at_d))
        return false;
    const double one = share_of(at_a, at_d, at_c), two = share_of(at_d, at_b, at_c);
    if (!(one > least_share) || !(two > least_share)) return false;
    // The new edge must not exist yet: d and c would then be joined twice.
    bool closed = false;
    for (const std::int32_t s : fan(c, closed))
        if (corner_of(state_->triangles[s], d) >= 0) return false;
    if (!has_room(0, 4)) return false;
    const std::int32_t p = reshape(triangle), q = reshape(other);
    CutTriangle& first = edit_triangle(p);
    first.vertices = {a, d, c};
    first.neighbours = {-1, -1, -1};
    first.share = one;
    CutTriangle& second = edit_triangle(q);
    second.vertices = {d, b, c};
    second.neighbours = {-1, -1, -1};
    second.share = two;
    // Outside: u = (b, a, d) has ad and db, t = (a, b, c) has bc and ca.
    link(p, 0, neighbour_at(u, back + 1));
    link(p, 2, neighbour_at(t, edge + 2));
    link(q, 0, neighbour_at(u, back + 2));
    link(q, 1, neighbour_at(t, edge + 1));
    link(p, 1, q);
    settle(p);
    settle(q);
    return true;
}

// Link condition: the rings of the two vertices share only the corners opposite their edge. gone: the
// `between` triangles that contain both.
static bool rings_are_apart(const CutState& state, const CutList<std::int32_t>& around, std::int32_t from,
                            std::int32_t to, const std::int32_t (&gone)[2], std::int32_t between) {
    for (const std::int32_t t : around) {
        if (t == gone[0] || t == gone[1]) continue;
        for (const std::int32_t v : state.triangles[t].vertices) {
            if (v == from) continue;
            bool opposite = false;
            for (std::int32_t k = 0; k < between; ++k)
                opposite = opposite || corner_of(state.triangles[gone[k]], v) >= 0;
            if (opposite) continue;
            // v is in the ring of `from` only, unless a triangle of its own fan contains `to`.
            const std::int32_t seed = state.vertices[v].triangle;
            std::int32_t s = seed;
            for (int sense = 0; sense < 2; ++sense) {
                s = seed;
                do {
                    const CutTriangle& row = state.triangles[s];
                    if (corner_of(row, to) >= 0) return false;
                    const int i = corner_of(row, v);
                    if (i < 0) return false;
                    s = neighbour_at(row, sense == 0 ? i : i + 2);
                } while (s >= 0 && s != seed);
                if (s == seed) break;
            }
        }
    }
    return true;
}

// True if the fan keeps its area, and every triangle a positive one, when `from` moves onto `to`.
static bool keeps_area(const CutModel& model, const CutState& state, const CutList<std::int32_t>& around,
                       std::int32_t from, std::int32_t to, const std::int32_t (&gone)[2]) {
    double before = 0, after = 0;
    std::int32_t touched_root = -1;
    for (std::int32_t k = 0; k < around.size(); ++k) {
        const std::int32_t t = around[k];
        const CutTriangle& row = state.triangles[t];
        if (touched_root < 0) touched_root = row.root;
        before += row.share * model.areas[static_cast<std::size_t>(row.root)];
        if (t == gone[0] || t == gone[1]) continue;
        Vector3 corners[3];
        for (int i = 0; i < 3; ++i) {
            const std::int32_t v = vertex_at(row, i) == from ? to : vertex_at(row, i);
            if (!barycentric_in(model, state.vertices[v], row.root, corners[i])) return false;
        }
        const double share = share_of(corners[0], corners[1], corners[2]);
        if (!(share > least_share)) return false;
        after += share * model.areas[static_cast<std::size_t>(row.root)];
    }
    const double area_of_root = model.areas[static_cast<std::size_t>(touched_root)];
    return std::abs(after - before) <= 1e-12 * area_of_root;
}

bool CutEditor::collapse(std::int32_t from, std::int32_t to) {
    bool closed = false;
    const CutList<std::int32_t>& around = fan(from, closed);
    const std::int32_t count = around.size();
    if (count < 2 || !has_room(0, count + 2)) return false;
    std::int32_t between = 0;
    std::int32_t gone[2] = {-1, -1};
    for (const std::int32_t t : around) {
        if (corner_of(state_->triangles[t], to) < 0) continue;
        if (between == 2) return false;
        gone[between++] = t;
    }
    if (between == 0 || between != (closed ? 2 : 1) || count <= between) return false;
    if (!rings_are_apart(*state_, around, from, to, gone, between)) return false;
    if (!keeps_area(*model_, *state_, around, from, to, gone)) return false;

    // Each triangle between them disappears and its two other neighbours become adjacent.
    for (std::int32_t k = 0; k < between; ++k) {
        const CutTriangle old = state_->triangles[gone[k]];
        const int i = corner_of(old, from), j = corner_of(old, to);
        const int x = 3 - i - j;                       // the opposite corner
        const int edge_to = j == (i + 1) % 3 ? j : x;  // between `to` and the opposite corner
        const int edge_from = j == (i + 1) % 3 ? x : i;
        const std::int32_t beyond = neighbour_at(old, edge_to), kept = neighbour_at(old, edge_from);
        const std::int32_t corner = vertex_at(old, x);
        hide(gone[k], CutTriangleState::split);
        // Every kept triangle of the fan is in `around` and is reshaped later. Link the two to each other.
        if (kept >= 0) {
            CutTriangle& row = edit_triangle(kept);
            for (std::int32_t& n : row.neighbours)
                if (n == gone[k]) n = beyond;
        }
        if (beyond >= 0) {
            CutTriangle& row = edit_triangle(beyond);
            for (std::int32_t& n : row.neighbours)
                if (n == gone[k]) n = kept;
        }
        const std::int32_t holder = kept >= 0 ? kept : beyond;
        if (state_->vertices[corner].triangle == gone[k]) edit_vertex(corner).triangle = holder;
        if (state_->vertices[to].triangle == gone[k]) edit_vertex(to).triangle = beyond >= 0 ? beyond : kept;
    }
    edit_vertex(from).triangle = -1;
    for (std::int32_t k = 0; k < count; ++k) {
        if (around[k] == gone[0] || around[k] == gone[1]) continue;
        const std::int32_t old = around[k], t = reshape(old);
        CutTriangle& row = edit_triangle(t);
        row.vertices[at(corner_of(row, from))] = to;
        Vector3 corners[3];
        for (int i = 0; i < 3; ++i)
            barycentric_in(*model_, state_->vertices[vertex_at(row, i)], row.root, corners[i]);
        row.share = share_of(corners[0], corners[1], corners[2]);
        if (t != old) {
            for (const std::int32_t n : row.neighbours) {
                if (n < 0) continue;
                for (std::int32_t& back : edit_triangle(n).neighbours)
                    if (back == old) back = t;
            }
        }
        settle(t);
    }
    return true;
}

}  // namespace fulcrum
