// SPDX-License-Identifier: Apache-2.0
// Records of a cut surface: plain data that can be copied, compared and restored.
//
// Roots are the triangles of the original mesh and are permanent. A triangle is visible (drawn,
// load-carrying), split (its children are drawn instead), removed (taken by the blade) or vacant. A vertex is
// in one root at barycentric coordinates, so that texture, weights and rest position follow from the root's
// corners; vertices 0 .. n - 1 are those of the mesh. Lengths in m at rest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// A table of fixed length, indexed with std::int32_t like the meshes. Copies between tables of the same
/// length do not allocate.
template <typename Row>
class CutTable {
  public:
    CutTable() = default;
    explicit CutTable(std::int32_t rows, const Row& value = Row())
        : rows_(static_cast<std::size_t>(rows), value) {}
    Row& operator[](std::int32_t i) { return rows_[static_cast<std::size_t>(i)]; }
    const Row& operator[](std::int32_t i) const { return rows_[static_cast<std::size_t>(i)]; }
    std::int32_t size() const { return static_cast<std::int32_t>(rows_.size()); }
    std::uint64_t bytes() const { return rows_.size() * sizeof(Row); }
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(rows_);
    }

  private:
    std::vector<Row> rows_;
};

/// A list with a fixed capacity.
template <typename Entry>
class CutList {
  public:
    CutList() = default;
    explicit CutList(std::int32_t room) : entries_(room) {}
    void clear() { count_ = 0; }
    void resize(std::int32_t count) { count_ = count; }
    bool full() const { return count_ == entries_.size(); }
    /// False if it is full.
    bool push(const Entry& entry) {
        if (full()) return false;
        entries_[count_++] = entry;
        return true;
    }
    Entry pop() { return entries_[--count_]; }
    std::int32_t size() const { return count_; }
    Entry& operator[](std::int32_t i) { return entries_[i]; }
    const Entry& operator[](std::int32_t i) const { return entries_[i]; }
    const Entry* begin() const { return entries_.size() > 0 ? &entries_[0] : nullptr; }
    const Entry* end() const { return begin() + count_; }
    std::uint64_t bytes() const { return entries_.bytes(); }
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(entries_, count_);
    }

  private:
    CutTable<Entry> entries_;
    std::int32_t count_ = 0;
};

enum class CutTriangleState : std::uint8_t { vacant, visible, split, removed };

struct CutTriangle {
    Triangle vertices = {-1, -1, -1};                       ///< counterclockwise from outside
    std::array<std::int32_t, 3> neighbours = {-1, -1, -1};  ///< across ab, bc, ca; -1 at a border
    std::int32_t root = -1;
    std::int32_t parent = -1;  ///< triangle that was visible before the cut that created this one
    std::int32_t first_child = -1, next_sibling = -1;
    std::int32_t next_in_root = -1, previous_in_root = -1;  ///< visible triangles of a root
    std::int32_t fragment = -1;
    std::int32_t stroke = 0;    ///< number of the stroke that created it, 0 for roots
    std::uint32_t attempt = 0;  ///< number of the transaction that created it, 0 for roots
    CutTriangleState state = CutTriangleState::vacant;
    double share = 0;  ///< of the root's area
};

struct CutVertex {
    Vector3 rest = Vector3::Zero();         ///< m
    Vector3 barycentric = Vector3::Zero();  ///< in root, of its corners; exact zeros on its edges
    std::int32_t root = -1;
    std::int32_t triangle = -1;  ///< a visible triangle at this vertex; -1: the vertex is deleted
    bool fixed = false;
    bool divided = false;  ///< other vertices are at the same position: it once joined several fans
};

struct CutRoot {
    std::int32_t first_visible = -1;
    std::int32_t visible_count = 0;
    double removed_share = 0;  ///< of its area
};

/// Visible triangles of one root connected by shared edges. Fragment r is root r before any cut; a fragment
/// that falls apart keeps its number for the part with the largest area.
struct CutFragment {
    std::int32_t root = -1;
    std::int32_t from = -1;          ///< fragment that it separated from, -1 for the first of a root
    std::int32_t next_of_root = -1;  ///< the next fragment ever created in this root, -1: none
    std::int32_t triangles = 0;      ///< number of visible triangles; 0: nothing is left
    double share = 0;                ///< of the root's area
};

/// Effect of a stroke so far on a triangle that was visible when it began (for the ten cases).
struct StrokeTriangle {
    std::int32_t triangle = -1;
    std::array<std::int8_t, 3> side = {0, 0, 0};  ///< corners: +1 left of the blade, -1 right, 0 unknown
    std::array<bool, 3> inside = {false, false, false}, on_border = {false, false, false};
    Vector3 distance = Vector3::Zero();  ///< m from the blade's path, when `side` was last set
    bool start = false;
    std::int32_t end_step = -1;  ///< last step that ended in this triangle
};

/// Capacities of a surface; no allocation after construction.
struct CutCapacity {
    std::int32_t vertices = 0, triangles = 0, fragments = 0;
    std::int32_t stroke_triangles = 0;  ///< triangles met by one stroke
};

/// Everything that a cut changes.
struct CutState {
    CutTable<CutTriangle> triangles;
    CutTable<CutVertex> vertices;
    CutTable<CutRoot> roots;
    CutTable<CutFragment> fragments;
    CutList<std::int32_t> free_triangles, free_vertices;  ///< created and dropped within one transaction
    CutList<StrokeTriangle> stroke_triangles;
    CutTable<std::int32_t>
        stroke_place;  ///< index of a triangle in stroke_triangles, if that row refers to it
    std::int32_t vertex_count = 0, triangle_count = 0, fragment_count = 0;
    std::int32_t visible_count = 0;
    std::int32_t stroke = 0, stroke_step = 0;
    std::int32_t stroke_unnamed = 0;            ///< triangles that stroke_triangles had no room for
    std::uint32_t attempt = 0;                  ///< transactions begun
    std::uint64_t version = 0;                  ///< transactions committed
    std::uint64_t rolled_back = 0;              ///< transactions played back
    double area_visible = 0, area_removed = 0;  ///< m2 at rest

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(triangles, vertices, roots, fragments, free_triangles, free_vertices, stroke_triangles,
              stroke_place, vertex_count, triangle_count, fragment_count, visible_count, stroke, stroke_step,
              stroke_unnamed, attempt, version, rolled_back, area_visible, area_removed);
    }
};

}  // namespace fulcrum
