// SPDX-License-Identifier: Apache-2.0
// Cuttable surface of the bowel (docs/THEORY.md, section 5; Pan et al. 2011, Figs. 10 to 13). The skin's
// triangles are the roots of a CutMesh, and every vertex created by a cut gets its own skinning row,
// interpolated from the rows of its root's corners. A cut surface therefore keeps following the cage, is
// evaluated like the skin, and receives forces through the same transposed weights.
//
// A row follows four rings. If the corners of a root follow more than four in total, the contribution of the
// outermost rings is attached rigidly to the next ring, which is exact in the rest pose.
//
// A cut does not change centre line, spheres and cage. The bowel bends, collides, self-collides and keeps the
// volume of its contents as if its wall were whole. (A cut wall has less hoop and bending stiffness; we know
// no source that quantifies this by length and direction of the cut.)
//
// A part without a path to a held vertex falls under gravity and is removed after `falling_time`.
//
// World thread; no allocation and no exception after construction. m, m2, s; frames and results: patient
// frame.
#pragma once

#include "sim_core/bowel/bowel_skin.h"
#include "sim_core/cutting/cut_mesh.h"

namespace fulcrum {

/// Row of the point with these barycentric coordinates in a triangle whose corners have these rows.
/// arc_lengths: of the rings, at rest.
SkinRow interpolate_rows(const SkinRow& a, const SkinRow& b, const SkinRow& c, const Vector3& barycentric,
                         const std::vector<double>& arc_lengths);

class CutSkin {
  public:
    static constexpr int most_loose = 8;         ///< pieces that can fall at once; further ones join the last
    static constexpr double falling_time = 1.0;  ///< s

    /// A detached part.
    struct Loose {
        bool falls = false;
        Vector3 displacement = Vector3::Zero(), velocity = Vector3::Zero();  ///< m, m/s
        double area = 0;                                                     ///< m2 at rest
        double age = 0;                                                      ///< s
    };
    /// Complete state.
    struct State {
        CutState surface;
        std::array<Loose, most_loose> loose{};
        std::vector<std::uint8_t> loose_of;  ///< per vertex: 0 attached, else 1 + index in loose
        std::int32_t fallen = 0;             ///< number of pieces detached so far
        std::uint64_t history = 0;

        template <typename Visit>
        void fields(Visit&& visit) {
            visit(surface, loose, loose_of, fallen, history);
        }
    };
    /// Result of one blade step.
    struct Report {
        CutReport cut;
        int parted = 0;          ///< pieces detached
        double parted_area = 0;  ///< m2, total
    };

    /// held: vertices that connect the bowel to the body. steps: number of blade steps to reserve room for.
    /// The skin must outlive this. Throws InputError as CutMesh does.
    CutSkin(const BowelSkin& skin, const std::vector<std::int32_t>& held, std::int32_t steps);

    /// Cuts at the current ring frames. A detached piece begins to fall.
    Report cut(const BladeStep& blade, const RingFrame* frames);
    void begin_stroke() { surface_.begin_stroke(); }
    /// Advances falling pieces by one step. Returns the area that was removed, m2.
    double fall(const Vector3& gravity, double dt);

    const BowelSkin& skin() const { return skin_; }
    const CutMesh& surface() const { return surface_; }
    const std::array<Loose, most_loose>& loose() const { return loose_; }
    std::int32_t fallen() const { return fallen_; }
    std::uint64_t version() const { return surface_.version(); }
    bool whole() const { return surface_.version() == 0; }
    /// True if area was removed from a triangle of the skin, or it was divided.
    bool touched(std::int32_t root) const {
        return surface_.root(root).visible_count != 1 || !surface_.visible(root);
    }
    /// 0: the vertex is attached, else 1 + index in loose().
    int loose_of(std::int32_t vertex) const { return loose_of_[static_cast<std::size_t>(vertex)]; }
    int loose_of_triangle(std::int32_t triangle) const {
        return loose_of(surface_.triangle(triangle).vertices[0]);
    }
    const SkinRow& row(std::int32_t vertex) const {
        const auto v = static_cast<std::size_t>(vertex);
        return v < skin_.rows().size() ? skin_.rows()[v] : rows_[v - skin_.rows().size()];
    }
    /// Position of a vertex under these frames (indexed by ring).
    template <typename Frames>
    Vector3 position(std::int32_t vertex, const Frames& frames) const {
        const Vector3 on_cage = skin_vertex(row(vertex), frames);
        const int piece = loose_of(vertex);
        return piece == 0 ? on_cage
                          : Vector3(on_cage + loose_[static_cast<std::size_t>(piece) - 1].displacement);
    }
    /// Positions of all existing vertices; positions: one for each of surface().capacity().vertices.
    void place_all(const RingFrame* frames, Vector3* positions) const;

    State save() const;
    void restore(const State& state);
    /// Hash of the roots that were touched, as they are after each commit, and of the falling pieces. O(1).
    std::uint64_t digest() const;
    std::size_t bytes() const;

  private:
    void place_near(std::int32_t root, const RingFrame* frames);
    void bind_new();
    void let_fall(std::int32_t first, Report& report);
    void remove(int piece);
    void note_commit();

    const BowelSkin& skin_;
    CutMesh surface_;
    std::vector<SkinRow> rows_;  ///< of the vertices created by cuts
    std::array<Loose, most_loose> loose_{};
    std::vector<std::uint8_t> loose_of_;
    std::int32_t fallen_ = 0;
    std::uint64_t history_ = 0;
    // Scratch.
    std::vector<Vector3> positions_;    // valid near the blade only
    std::vector<std::int32_t> queue_;   // triangles of a piece
    std::vector<std::uint32_t> marks_;  // by triangle
    std::uint32_t mark_ = 0;
};

}  // namespace fulcrum
