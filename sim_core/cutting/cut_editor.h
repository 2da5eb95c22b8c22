// SPDX-License-Identifier: Apache-2.0
// Primitive operations on a cut surface, inside a transaction. Each keeps the surface conforming; the journal
// keeps the previous record of everything that is touched, so that roll_back() restores every bit.
//
// World thread; no allocation after construction, no exceptions, no I/O. An operation that lacks room changes
// nothing, returns its failure value and reports which table was full.
#pragma once

#include "sim_core/cutting/cut_state.h"

namespace fulcrum {

/// Constant part: the original mesh.
struct CutModel {
    TriangleMesh mesh;
    MeshAdjacency adjacency;
    std::vector<double> areas;     ///< m2 of each root
    std::vector<Vector3> centres;  ///< m, of each root at rest
    std::vector<double> radii;     ///< m, of a ball about the centre that contains the root
    std::vector<bool> flat;        ///< the root has negligible area: the shape of its children is not checked
    CutCapacity capacity;
    std::int32_t original_vertices = 0, root_count = 0;
    double area = 0;  ///< m2
};

/// Smallest share of a root's area (for a root that has area): a triangle below it counts as having none.
inline constexpr double least_share = 1e-11;

enum class CutLimit : std::uint8_t { none, vertices, triangles, fragments };

class CutEditor {
  public:
    CutEditor() = default;
    explicit CutEditor(const CutModel& model);

    /// Starts a transaction on a state. `positions`: current position of every vertex, m, with room for all
    /// the capacity.
    void begin(const CutModel& model, CutState& state, Vector3* positions);
    void commit();
    /// Replays the journal backwards: the state is bit for bit what it was at begin(), except for the counts
    /// of transactions begun and rolled back.
    void roll_back();
    CutLimit lacking() const { return lacking_; }
    /// Number of the transaction within this editor, unique.
    std::uint32_t stamp() const { return stamp_; }

    // Operations. Edge e of (a, b, c) is ab, bc, ca for e = 0, 1, 2.

    /// Splits an edge at `share` between its first and its second vertex: two triangles become four (at a
    /// border one becomes two). Returns the new vertex or -1.
    std::int32_t split_edge(std::int32_t triangle, int edge, double share);
    /// Removes triangles and divides every vertex whose remaining triangles no longer form one fan. The
    /// removed area is counted. False without room.
    bool remove(const CutList<std::int32_t>& doomed);
    /// Flips the edge between two triangles of one root. False without room or if a triangle would turn over.
    bool flip(std::int32_t triangle, int edge);
    /// Moves vertex `from` onto its neighbour `to` and drops the triangles between. The caller must have
    /// checked that the union is unchanged (see cut_tidy.cpp). False without room or if the surface would
    /// fold.
    bool collapse(std::int32_t from, std::int32_t to);

    // Journaled write access for this folder.
    CutTriangle& edit_triangle(std::int32_t triangle);
    CutVertex& edit_vertex(std::int32_t vertex);
    CutRoot& edit_root(std::int32_t root);
    CutFragment& edit_fragment(std::int32_t fragment);
    std::int32_t new_fragment(std::int32_t root, std::int32_t from);

    // Reading.
    const CutModel& model() const { return *model_; }
    const CutState& state() const { return *state_; }
    Vector3* positions() const { return positions_; }
    bool visible(std::int32_t triangle) const {
        return state_->triangles[triangle].state == CutTriangleState::visible;
    }
    bool made_now(std::int32_t triangle) const {
        return state_->triangles[triangle].attempt == state_->attempt;
    }
    bool touched(std::int32_t triangle) const { return triangle_stamp_[triangle] == stamp_; }
    const CutList<std::int32_t>& touched_triangles() const { return touched_triangles_; }
    const CutList<std::int32_t>& touched_roots() const { return touched_roots_; }
    const CutList<std::int32_t>& new_vertices() const { return new_vertices_; }
    /// Triangles that split_edge made since the list was last cleared.
    CutList<std::int32_t>& made() { return made_; }
    /// Triangles around a vertex, counterclockwise; at a border the first one has the border before it.
    /// closed: the fan has no border.
    const CutList<std::int32_t>& fan(std::int32_t vertex, bool& closed);
    /// Checks the invariants of docs/THEORY.md, section 5, on everything that this transaction touched:
    /// nullptr, or the violation that forbids the commit.
    const char* wrong_here();
    std::uint64_t bytes() const;

  private:
    template <typename Row>
    struct Undo {
        std::int32_t index = -1;
        Row row;
    };
    std::int32_t new_triangle();
    std::int32_t new_vertex();
    bool has_room(std::int32_t vertices, std::int32_t triangles);
    void show(std::int32_t triangle);
    void hide(std::int32_t triangle, CutTriangleState as);
    /// Record for a changed shape: the triangle itself if this transaction created it, else a new child of
    /// it. Adds it to made().
    std::int32_t reshape(std::int32_t triangle);
    std::int32_t sibling(std::int32_t triangle);
    void link(std::int32_t triangle, int edge, std::int32_t neighbour);
    void settle(std::int32_t triangle);
    void add_child(std::int32_t parent, std::int32_t child);

    const CutModel* model_ = nullptr;
    CutState* state_ = nullptr;
    Vector3* positions_ = nullptr;
    CutLimit lacking_ = CutLimit::none;
    std::uint32_t stamp_ = 0, removal_ = 0, checks_ = 0;
    CutTable<std::uint32_t> triangle_stamp_, vertex_stamp_, root_stamp_, fragment_stamp_;
    CutTable<std::uint32_t> doomed_stamp_, divided_stamp_, counted_stamp_;
    CutTable<std::int32_t> fan_count_;
    CutList<Undo<CutTriangle>> undo_triangles_;
    CutList<Undo<CutVertex>> undo_vertices_;
    CutList<Undo<CutRoot>> undo_roots_;
    CutList<Undo<CutFragment>> undo_fragments_;
    CutList<std::int32_t> touched_triangles_, touched_roots_, new_vertices_, made_, fan_;
    struct Counts {
        std::int32_t vertices = 0, triangles = 0, fragments = 0, visible = 0, free_triangles = 0,
                     free_vertices = 0;
        double area_visible = 0, area_removed = 0;
    } before_;
};

/// Barycentric coordinates of a vertex in a root that contains it (border included); false otherwise.
bool barycentric_in_other(const CutModel& model, const CutVertex& vertex, std::int32_t root,
                          Vector3& coordinates);
inline bool barycentric_in(const CutModel& model, const CutVertex& vertex, std::int32_t root,
                           Vector3& coordinates) {
    if (vertex.root != root) return barycentric_in_other(model, vertex, root, coordinates);
    coordinates = vertex.barycentric;
    return true;
}
/// Signed share of a root's area that three points given by barycentric coordinates span.
inline double share_of(const Vector3& a, const Vector3& b, const Vector3& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
}

inline int corner_of(const CutTriangle& triangle, std::int32_t vertex) {
    for (int i = 0; i < 3; ++i)
        if (triangle.vertices[static_cast<std::size_t>(i)] == vertex) return i;
    return -1;
}
/// Edge that runs from one vertex to another, -1 if there is none.
inline int edge_of(const CutTriangle& triangle, std::int32_t from, std::int32_t to) {
    const int i = corner_of(triangle, from);
    return i >= 0 && triangle.vertices[static_cast<std::size_t>((i + 1) % 3)] == to ? i : -1;
}
inline std::int32_t vertex_at(const CutTriangle& triangle, int corner) {
    return triangle.vertices[static_cast<std::size_t>(corner % 3)];
}
inline std::int32_t neighbour_at(const CutTriangle& triangle, int edge) {
    return triangle.neighbours[static_cast<std::size_t>(edge % 3)];
}

}  // namespace fulcrum
