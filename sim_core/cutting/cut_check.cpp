// SPDX-License-Identifier: Apache-2.0
// The invariants of docs/THEORY.md, section 5: on what a transaction touched, and on the whole surface.
#include <algorithm>
#include <cmath>

#include "sim_core/cutting/cut_mesh.h"

namespace fulcrum {
namespace {

bool finite(const CutVertex& vertex, const Vector3* positions, std::int32_t v) {
    return vertex.rest.allFinite() && vertex.barycentric.allFinite() &&
           (positions == nullptr || positions[v].allFinite());
}

}  // namespace

const char* CutEditor::wrong_here() {
    ++checks_;
    for (const std::int32_t t : touched_triangles_) {
        if (!visible(t)) continue;
        const CutTriangle& row = state_->triangles[t];
        Vector3 at[3];
        for (int i = 0; i < 3; ++i) {
            const std::int32_t v = vertex_at(row, i);
            if (v < 0 || v >= state_->vertex_count || v == vertex_at(row, i + 1)) return "vertices";
            const CutVertex& vertex = state_->vertices[v];
            if (vertex.triangle < 0 || !visible(vertex.triangle)) return "a triangle uses a deleted vertex";
            if (!finite(vertex, positions_, v)) return "a vertex is not finite";
            if (!barycentric_in(*model_, vertex, row.root, at[i])) return "a vertex is outside its root";
            if (counted_stamp_[v] != checks_) {
                counted_stamp_[v] = checks_;
                fan_count_[v] = 0;
            }
            ++fan_count_[v];
            const std::int32_t n = neighbour_at(row, i);
            if (n < 0) continue;
            if (!visible(n)) return "a neighbour is not visible";
            const int back = edge_of(state_->triangles[n], vertex_at(row, i + 1), v);
            if (back < 0 || neighbour_at(state_->triangles[n], back) != t) return "neighbours disagree";
        }
        const double share = share_of(at[0], at[1], at[2]);
        if (std::abs(share - row.share) > 1e-12) return "a stored area share is wrong";
        if (!model_->flat[static_cast<std::size_t>(row.root)] && !(share > least_share))
            return "a triangle has no area";
    }
    for (const std::int32_t t : touched_triangles_) {
        if (!visible(t)) continue;
        for (const std::int32_t v : state_->triangles[t].vertices) {
            if (fan_count_[v] < 0) continue;
            bool closed = false;
            std::int32_t there = 0;
            for (const std::int32_t s : fan(v, closed)) there += touched(s) ? 1 : 0;
            if (there != fan_count_[v]) return "a vertex joins two triangle fans";
            fan_count_[v] = -1;
        }
    }
    for (const std::int32_t r : touched_roots_) {
        double sum = state_->roots[r].removed_share;
        std::int32_t count = 0;
        for (std::int32_t t = state_->roots[r].first_visible; t >= 0; t = state_->triangles[t].next_in_root) {
            sum += state_->triangles[t].share;
            ++count;
        }
        if (std::abs(sum - 1) > 1e-10) return "the area of a root does not add up";
        if (count != state_->roots[r].visible_count) return "the triangle list of a root is wrong";
    }
    return nullptr;
}

const char* CutCheck::complaint() const {
    if (!finite) return "a position is not finite";
    if (!no_zero_area) return "a triangle has no area";
    if (!conforming) return "the surface is not conforming";
    if (!manifold_edges) return "an edge has more than two triangles";
    if (!one_fan) return "a vertex joins two triangle fans";
    if (!rims_closed) return "a border is not a closed loop";
    if (!oriented) return "a triangle is flipped";
    if (!area_kept) return "area is not conserved";
    if (!hierarchy) return "the triangle hierarchy is inconsistent";
    return "";
}

namespace {

// A directed edge of a visible triangle.
struct VisibleEdge {
    std::int32_t from, to, triangle;
    bool operator<(const VisibleEdge& o) const {
        return from != o.from ? from < o.from : to != o.to ? to < o.to : triangle < o.triangle;
    }
};

// The steps of check_cut, in their order.
class SurfaceCheck {
  public:
    SurfaceCheck(const CutMesh& mesh, const Vector3* positions)
        : mesh_(mesh),
          model_(mesh.model()),
          positions_(positions),
          corners_(static_cast<std::size_t>(mesh.vertex_count()), 0) {}
    CutCheck run() {
        check_triangles();
        check_edges();
        check_fans();
        check_rims();
        check_insides();
        return check_;
    }

  private:
    void bad(bool& flag, std::int32_t what) {
        flag = false;
        if (check_.first_bad < 0) check_.first_bad = what;
    }
    void check_triangles();
    void check_triangle(std::int32_t t, double& visible_area);
    void check_edges();
    void check_fans();
    void check_rims();
    void check_insides();

    const CutMesh& mesh_;
    const CutModel& model_;
    const Vector3* positions_;
    CutCheck check_;
    std::vector<VisibleEdge> edges_, rim_;
    std::vector<std::int32_t> corners_;  // visible triangles at each vertex
};

void SurfaceCheck::check_triangle(std::int32_t t, double& visible_area) {
    const CutTriangle& row = mesh_.triangle(t);
    if (row.state == CutTriangleState::split && row.first_child < 0 && row.parent < 0 &&
        mesh_.root(row.root).visible_count == 0 && mesh_.root(row.root).removed_share == 0)
        bad(check_.hierarchy, t);
    for (std::int32_t c = row.first_child; c >= 0; c = mesh_.triangle(c).next_sibling)
        if (mesh_.triangle(c).parent != t || mesh_.triangle(c).root != row.root) bad(check_.hierarchy, c);
    if (!mesh_.visible(t)) return;
    if (row.first_child >= 0) bad(check_.hierarchy, t);
    Vector3 at[3];
    bool placed = true;
    for (int i = 0; i < 3; ++i) {
        const std::int32_t v = vertex_at(row, i);
        ++corners_[static_cast<std::size_t>(v)];
        const CutVertex& vertex = mesh_.vertex(v);
        if (vertex.triangle < 0) bad(check_.one_fan, v);
        if (!finite(vertex, positions_, v)) bad(check_.finite, v);
        placed = placed && barycentric_in(model_, vertex, row.root, at[i]);
        edges_.push_back({v, vertex_at(row, i + 1), t});
    }
    if (!placed) {
        bad(check_.conforming, t);
        return;
    }
    const double share = share_of(at[0], at[1], at[2]);
    visible_area += share * model_.areas[static_cast<std::size_t>(row.root)];
    if (!model_.flat[static_cast<std::size_t>(row.root)]) {
        if (!(share > 0)) bad(check_.oriented, t);
        if (!(share > least_share)) bad(check_.no_zero_area, t);
    }
}

void SurfaceCheck::check_triangles() {
    double visible_area = 0;
    std::int32_t visible = 0;
    for (std::int32_t t = 0; t < mesh_.triangle_count(); ++t) {
        if (mesh_.visible(t)) ++visible;
        check_triangle(t, visible_area);
    }
    if (visible != mesh_.visible_count()) bad(check_.hierarchy, visible);
    check_.area_error =
        std::abs(visible_area + mesh_.area_removed() - model_.area) / (model_.area > 0 ? model_.area : 1.0);
    check_.area_kept = check_.area_error <= 1e-9;
}

void SurfaceCheck::check_edges() {
    std::sort(edges_.begin(), edges_.end());
    const auto find = [this](std::int32_t from, std::int32_t to) {
        const auto place = std::lower_bound(edges_.begin(), edges_.end(), VisibleEdge{from, to, -1});
        return place != edges_.end() && place->from == from && place->to == to ? place->triangle : -1;
    };
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        const VisibleEdge& e = edges_[i];
        if (i > 0 && edges_[i - 1].from == e.from && edges_[i - 1].to == e.to)
            bad(check_.manifold_edges, e.triangle);
        const CutTriangle& row = mesh_.triangle(e.triangle);
        const std::int32_t named = neighbour_at(row, edge_of(row, e.from, e.to));
        if (named != find(e.to, e.from)) bad(check_.conforming, e.triangle);
        if (named < 0) rim_.push_back(e);
    }
}

// One fan: a walk around each vertex from its own triangle finds all its corners.
void SurfaceCheck::check_fans() {
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
        const std::int32_t seed = mesh_.vertex(v).triangle;
        const std::int32_t expected = corners_[static_cast<std::size_t>(v)];
        std::int32_t count = 0;
        if (seed >= 0 && mesh_.visible(seed)) {
            for (int sense = 0; sense < 2; ++sense) {
                std::int32_t t = seed;
                do {
                    const int i = corner_of(mesh_.triangle(t), v);
                    if (i < 0) break;
                    if (sense == 0 || t != seed) ++count;
                    t = neighbour_at(mesh_.triangle(t), sense == 0 ? i + 2 : i);
                } while (t >= 0 && t != seed && count <= expected);
                if (t == seed) break;
            }
        }
        if (count != expected) bad(check_.one_fan, v);
    }
}

// Borders: one edge leaves and one reaches each of their vertices, so that they are loops.
void SurfaceCheck::check_rims() {
    std::vector<std::int32_t> leaves(corners_.size(), 0), reaches(corners_.size(), 0);
    for (const VisibleEdge& e : rim_) {
        ++leaves[static_cast<std::size_t>(e.from)];
        ++reaches[static_cast<std::size_t>(e.to)];
    }
    for (std::size_t v = 0; v < leaves.size(); ++v)
        if (leaves[v] != reaches[v] || leaves[v] > 1) bad(check_.rims_closed, static_cast<std::int32_t>(v));
}

// No vertex inside another visible edge: border edges against the vertices of their root, and of the
// adjacent roots if the vertex is on the shared edge, by barycentric coordinates.
void SurfaceCheck::check_insides() {
    for (const VisibleEdge& e : rim_) {
        const std::int32_t root = mesh_.triangle(e.triangle).root;
        if (model_.flat[static_cast<std::size_t>(root)]) continue;
        Vector3 a, along, x;
        if (!barycentric_in(model_, mesh_.vertex(e.from), root, a) ||
            !barycentric_in(model_, mesh_.vertex(e.to), root, along))
            continue;
        along -= a;
        const double squared = along.squaredNorm();
        for (int side = -1; side < 3; ++side) {
            const std::int32_t r =
                side < 0 ? root
                         : model_.adjacency.triangle_neighbours[static_cast<std::size_t>(3 * root + side)];
            if (r < 0) continue;
            for (std::int32_t t = mesh_.root(r).first_visible; t >= 0; t = mesh_.triangle(t).next_in_root) {
                for (const std::int32_t v : mesh_.triangle(t).vertices) {
                    if (!barycentric_in(model_, mesh_.vertex(v), root, x)) continue;
                    x -= a;
                    const double s = x.dot(along) / squared;
                    if (s > 1e-7 && s < 1 - 1e-7 && (x - s * along).squaredNorm() < 1e-20 * squared)
                        bad(check_.conforming, v);
                }
            }
        }
    }
}

}  // namespace

CutCheck check_cut(const CutMesh& mesh, const Vector3* positions) {
    return SurfaceCheck(mesh, positions).run();
}

}  // namespace fulcrum
