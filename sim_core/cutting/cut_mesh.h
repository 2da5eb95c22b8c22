// SPDX-License-Identifier: Apache-2.0
// A surface that can be cut (Pan et al. 2011, Triangle subdivision, Figs. 10, 12, 13; docs/THEORY.md,
// section 5).
//
// One rule for all cuts: triangles that the blade's band meets and that are connected to the blade along the
// surface are split where a border crosses their edges (once per edge, so that both its triangles agree), the
// inside is removed, vertices left between two fans are divided, and the remainder is tidied within its root
// (collapse and flip of children only, where the union stays the same). Every step is a transaction: it is
// validated against the invariants below on all it touched, then committed with a new version, or rolled back
// bit for bit and tried again with borders moved to nearby vertices. If that fails too, the tissue stays
// uncut and the report says so. A band too thin for the triangles it meets (a thousandth of their size) is
// widened, and a border that would leave a part without area goes through the next vertex; both count as cut.
//
// Invariants after every commit: finite; no visible triangle without area; conforming (neighbours refer to
// each other across one directed edge, at most two triangles per edge, orientation kept); the triangles of a
// vertex form one fan, so borders are closed loops; rest area at the start = visible + removed.
//
// Threads: one at a time (the world's). cut() and all queries: no allocation, lock, exception or
// trigonometry; deterministic. Construction throws InputError. m, m2; positions in any one frame.
#pragma once

#include <memory>

#include "sim_core/cutting/blade.h"
#include "sim_core/cutting/cut_editor.h"

namespace fulcrum {

enum class CutOutcome : std::uint8_t {
    cut,          ///< committed
    nothing,      ///< the band met no visible tissue, or the step has no length
    rolled_back,  ///< no attempt was valid: the tissue is unchanged
    full,         ///< no room: the tissue is unchanged; CutReport::lacking names the capacity to raise
    invalid,      ///< the step or a position is not finite, or the band has no width: the tissue is unchanged
};

struct CutReport {
    CutOutcome outcome = CutOutcome::nothing;
    CutLimit lacking = CutLimit::none;
    std::int32_t roll_backs = 0;  ///< attempts rolled back in this call
    std::int32_t met = 0;         ///< visible triangles on the cutting list
    double removed_area = 0;      ///< m2 at rest, by this call
    double width = 0;  ///< m, of the band: that of the step, or more if the surface is too coarse for it
    std::int32_t root = -1;  ///< root from which the next step's search starts; -1: nothing was met
};

/// Cases of Fig. 12: [0] = 12a ... [9] = 12j. They count triangles that were visible when the stroke began
/// and that its band met. a-c: the triangle in which the stroke starts or ends, with no corner in the band,
/// one on its border, one in it. Others, and start or end triangles with more corners in the band: two
/// corners in with the third left (d) or right (e); one in, the others both left (f), both right (g), one on
/// each side (h); none in (i); all in (j).
struct CutCases {
    std::array<std::int32_t, 10> count = {};
    std::int32_t unnamed = 0;  ///< triangles not classified, beyond CutCapacity::stroke_triangles
};

/// A connected part of the visible surface (by shared edges).
struct CutPiece {
    std::int32_t triangles = 0;
    std::int32_t first = -1;  ///< one of its triangles
    double area = 0;          ///< m2 at rest
    bool fixed = false;       ///< it has a fixed vertex
};

/// Contact of two fragments (or of a fragment and a border) along an edge of their roots.
struct FragmentContact {
    int edge = 0;             ///< 0: corners 0 and 1 of the root, 1: 1 and 2, 2: 2 and 0
    std::int32_t other = -1;  ///< fragment across; -1: border
    double length_share = 0;  ///< of the root's edge
};

class CutMesh {
  public:
    /// fixed: vertices that are held. Throws InputError if the mesh is empty, not finite, uses a vertex twice
    /// in a triangle, has an edge with more than two triangles, neighbours of opposite orientation or a
    /// vertex that joins two fans, or if a capacity is smaller than the mesh itself needs.
    CutMesh(const TriangleMesh& mesh, const std::vector<std::int32_t>& fixed, const CutCapacity& capacity);
    /// Capacity for the mesh and `steps` steps of about twenty triangles each.
    static CutCapacity capacity_for(const TriangleMesh& mesh, std::int32_t steps);

    // -- Cutting. `positions`: current position of every vertex, with room for capacity().vertices; new
    // vertices are
    //    appended to it by interpolation.

    void begin_stroke();
    CutReport cut(const BladeStep& step, Vector3* positions);
    /// Cases of the stroke so far; the end triangle is the one in which its latest step ended.
    CutCases cases() const;
    /// Removes a connected part (number from find_pieces() of this version); its area counts as removed.
    CutReport remove_piece(std::int32_t piece, Vector3* positions);
    /// Restores the original mesh.
    void reset();

    // -- Queries.

    const TriangleMesh& mesh() const { return model_->mesh; }
    const CutModel& model() const { return *model_; }
    const CutCapacity& capacity() const { return model_->capacity; }
    /// Upper bounds of vertex and triangle numbers; some of them are deleted or hidden.
    std::int32_t vertex_count() const { return state_.vertex_count; }
    std::int32_t triangle_count() const { return state_.triangle_count; }
    const CutVertex& vertex(std::int32_t v) const { return state_.vertices[v]; }
    const CutTriangle& triangle(std::int32_t t) const { return state_.triangles[t]; }
    bool visible(std::int32_t t) const { return state_.triangles[t].state == CutTriangleState::visible; }
    std::int32_t visible_count() const { return state_.visible_count; }
    std::int32_t root_count() const { return model_->root_count; }
    const CutRoot& root(std::int32_t r) const { return state_.roots[r]; }
    double area_before() const { return model_->area; }
    double area_visible() const { return state_.area_visible; }
    double area_removed() const { return state_.area_removed; }
    std::uint64_t version() const { return state_.version; }
    std::uint64_t rolled_back() const { return state_.rolled_back; }
    /// Roots changed and vertices created by the latest commit.
    const CutList<std::int32_t>& touched_roots() const { return editor_.touched_roots(); }
    const CutList<std::int32_t>& new_vertices() const { return editor_.new_vertices(); }
    /// Visible triangles with their vertex numbers, in ascending order of triangle.
    std::vector<Triangle> visible_triangles() const;
    /// Root near a point: that of the nearest visible triangle, -1 if nothing is left. O(triangles).
    std::int32_t nearest_root(const Vector3& point, const Vector3* positions) const;

    // -- Fragments: the units that springs connect. Numbers are stable; fragment r is root r before any cut.
    // All
    //    that a root r ever had: for (f = r; f >= 0; f = fragment(f).next_of_root); one without triangles is
    //    gone.

    std::int32_t fragment_count() const { return state_.fragment_count; }
    const CutFragment& fragment(std::int32_t f) const { return state_.fragments[f]; }
    std::int32_t fragment_of_triangle(std::int32_t t) const { return state_.triangles[t].fragment; }
    /// Fragment that a vertex belongs to (any of those around it), -1 if the vertex is deleted.
    std::int32_t fragment_of_vertex(std::int32_t v) const;
    /// Neighbours of a fragment and the length of contact on each edge of its root, borders included (-1).
    /// Writes at most `room` rows, returns how many there are.
    std::int32_t contacts_of(std::int32_t fragment, FragmentContact* contacts, std::int32_t room) const;

    // -- Pieces, connected by shared edges. Valid until the next change.

    std::int32_t find_pieces();
    const CutPiece& piece(std::int32_t p) const { return pieces_[p]; }
    std::int32_t piece_of_triangle(std::int32_t t) const { return piece_of_[t]; }
    /// Pieces without a fixed vertex that the latest commit separated: a triangle of each (at most `room`)
    /// and how many there are. Searches only as far as where the sides of the cut meet again, so a cut that
    /// separates nothing costs no more than what it touched. Assumes that the surface was connected to a
    /// fixed vertex before; pieces that were loose already are found again when they are cut. Invalidates
    /// find_pieces().
    std::int32_t find_parted(std::int32_t* firsts, std::int32_t room);

    // -- Saving.

    const CutState& state() const { return state_; }
    /// State of a mesh made with the same arguments.
    void restore(const CutState& state) { state_ = state; }
    /// The same state, in place.
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(state_);
    }
    /// Hash of everything that a cut changes.
    std::uint64_t digest() const;
    std::uint64_t bytes() const;

  private:
    /// Bit masks of the planes that a vertex is outside or inside of by more than the tolerance.
    struct VertexSides {
        std::uint32_t stamp = 0;
        std::uint16_t outside = 0, inside = 0;
    };
    bool list_triangles(std::int32_t root, double inset, const Vector3* positions);
    const VertexSides& sides(std::int32_t vertex) {
        return sides_[vertex].stamp == editor_.stamp() ? sides_[vertex] : find_sides(vertex);
    }
    const VertexSides& find_sides(std::int32_t vertex);
    bool clip(double tolerance);
    bool clip_by(int plane);
    bool tidy();
    bool tidy_vertex(std::int32_t vertex);
    bool tidy_slivers();
    bool turn_edges();
    bool sort_fragments();
    void note_cases();
    CutOutcome attempt(const BladeStep& step, Vector3* positions, double of_width, double of_root,
                       CutReport& report);
    double quality(std::int32_t root, std::int32_t a, std::int32_t b, std::int32_t c) const;
    double quality(const CutTriangle& triangle) const;
    double quality(std::int32_t root, double share, std::int32_t a, std::int32_t b, std::int32_t c) const;
    double worst_after(std::int32_t from, std::int32_t to, double enough) const;

    std::shared_ptr<const CutModel> model_;
    CutState state_;
    CutEditor editor_;
    // Scratch of a step.
    BladeRegion region_;
    double tolerance_ = 0, give_ = 0;
    CutTable<VertexSides> sides_;
    CutTable<std::uint32_t> root_mark_, triangle_mark_, vertex_mark_;
    std::uint32_t mark_ = 0;
    CutList<std::int32_t> queue_, met_, band_, around_, parts_;
    CutTable<std::int32_t> piece_of_;
    CutList<CutPiece> pieces_;
    /// One side of the latest cut, while find_parted() determines how far it extends.
    struct Side {
        std::int32_t first = -1, parent = -1;  ///< parent: side that it has met, -1: none
        std::int32_t open = 0;                 ///< triangles whose neighbours were not visited
        bool fixed = false;
    };
    std::int32_t side_of(std::int32_t side) const {
        while (sides_met_[side].parent >= 0) side = sides_met_[side].parent;
        return side;
    }
    CutList<Side> sides_met_;
};

/// All requirements of docs/THEORY.md, section 5, on a surface, checked on all of it, geometry included.
struct CutCheck {
    bool finite = true;
    bool no_zero_area = true;  ///< share of each visible triangle above 0 in a root that has area
    bool conforming = true;    ///< neighbours refer to each other; no vertex lies inside another visible edge
    bool manifold_edges = true;   ///< at most two triangles per edge, in opposite directions
    bool one_fan = true;          ///< the triangles of each vertex form one fan
    bool rims_closed = true;      ///< every border is a closed loop
    bool oriented = true;         ///< no triangle is flipped in its root
    bool area_kept = true;        ///< original = visible + removed, relative error at most 1e-9
    bool hierarchy = true;        ///< a split triangle has children or is covered, visible ones are listed
    double area_error = 0;        ///< relative
    std::int32_t first_bad = -1;  ///< triangle or vertex
    bool passed() const {
        return finite && no_zero_area && conforming && manifold_edges && one_fan && rims_closed && oriented &&
               area_kept && hierarchy;
    }
    const char* complaint() const;
};
/// O(n log n), allocates: for tests and studies. positions may be null (then only the rest shape is checked).
CutCheck check_cut(const CutMesh& mesh, const Vector3* positions);

}  // namespace fulcrum
