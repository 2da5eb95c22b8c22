// SPDX-License-Identifier: Apache-2.0
// What a cut surface is made of: plain records that can be copied, compared and restored.
//
// Roots are the triangles of the mesh as it was made and stay for ever. A triangle is visible (it is drawn,
// it carries), split (its children are drawn instead), removed (ground that the blade took) or vacant. A
// vertex lies in one root at barycentric coordinates, so that texture, weights and rest position follow from
// the root's corners; vertices 0 .. n - 1 are the mesh's own. Lengths in m at rest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// A table of fixed length that is indexed as meshes are, with std::int32_t. Copying between tables of the
/// same length allocates nothing.
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

  private:
    std::vector<Row> rows_;
};

/// A list of at most as many entries as it was made for.
template <typename Entry>
class CutList {
  public:
    CutList() = default;
    explicit CutList(std::int32_t room) : entries_(room) {}
    void clear() { count_ = 0; }
    void resize(std::int32_t count) { count_ = count; }
    bool full() const { return count_ == entries_.size(); }
    /// False where there is no room.
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

  private:
    CutTable<Entry> entries_;
    std::int32_t count_ = 0;
};

enum class CutTriangleState : std::uint8_t { vacant, visible, split, removed };

struct CutTriangle {
    Triangle vertices = {-1, -1, -1};                       ///< counterclockwise from outside
    std::array<std::int32_t, 3> neighbours = {-1, -1, -1};  ///< across ab, bc, ca; -1 at a rim
    std::int32_t root = -1;
    std::int32_t parent = -1;  ///< the triangle that was visible before the cut that made this one
    std::int32_t first_child = -1, next_sibling = -1;
    std::int32_t next_in_root = -1, previous_in_root = -1;  ///< visible triangles of a root
    std::int32_t fragment = -1;
    std::int32_t stroke = 0;    ///< number of the stroke that made it, 0 for roots
    std::uint32_t attempt = 0;  ///< number of the transaction that made it, 0 for roots
    CutTriangleState state = CutTriangleState::vacant;
    double share = 0;  ///< of the root's area
};

struct CutVertex {
    Vector3 rest = Vector3::Zero();         ///< m
    Vector3 barycentric = Vector3::Zero();  ///< in root, of its corners; exact zeros on its edges
    std::int32_t root = -1;
    std::int32_t triangle = -1;  ///< a visible triangle at this vertex; -1: the vertex is gone
    bool fixed = false;
    bool divided = false;  ///< others lie at the same place: it joined several fans once
};

struct CutRoot {
    std::int32_t first_visible = -1;
    std::int32_t visible_count = 0;
    double removed_share = 0;  ///< of its area
};

/// Visible triangles of one root that hang together by shared edges. Fragment r is root r before any cut; a
/// fragment that falls apart keeps its number for the part with the greatest area.
struct CutFragment {
    std::int32_t root = -1;
    std::int32_t from = -1;          ///< fragment that it came off, -1 for the first of a root
    std::int32_t next_of_root = -1;  ///< the next fragment ever made of this root, -1: none
    std::int32_t triangles = 0;      ///< visible ones; 0: nothing is left of it
    double share = 0;                ///< of the root's area
};

/// What a stroke has done so far to a triangle that was visible when it began (for the ten cases).
struct StrokeTriangle {
    std::int32_t triangle = -1;
    std::array<std::int8_t, 3> side = {0, 0, 0};  ///< corners: +1 left of the blade, -1 right, 0 not known
    std::array<bool, 3> inside = {false, false, false}, on_border = {false, false, false};
    Vector3 distance = Vector3::Zero();  ///< m from the blade's way, of the side's latest word
    bool start = false;
    std::int32_t end_step = -1;  ///< latest step that ended in this triangle
};

/// How much a surface can hold; nothing allocates once it is made.
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
    CutList<std::int32_t> free_triangles, free_vertices;  ///< made and dropped within one transaction
    CutList<StrokeTriangle> stroke_triangles;
    CutTable<std::int32_t> stroke_place;  ///< of a triangle in stroke_triangles, if that row names it
    std::int32_t vertex_count = 0, triangle_count = 0, fragment_count = 0;
    std::int32_t visible_count = 0;
    std::int32_t stroke = 0, stroke_step = 0;
    std::int32_t stroke_unnamed = 0;            ///< triangles that stroke_triangles had no room for
    std::uint32_t attempt = 0;                  ///< transactions begun
    std::uint64_t version = 0;                  ///< transactions committed
    std::uint64_t rolled_back = 0;              ///< transactions played back
    double area_visible = 0, area_removed = 0;  ///< m2 at rest
};

}  // namespace fulcrum
