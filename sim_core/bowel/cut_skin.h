// SPDX-License-Identifier: Apache-2.0
// The bowel's surface as one that can be cut (docs/THEORY.md 5; Pan et al. 2011, Figs. 10 to 13): the skin's
// triangles are the roots of a CutMesh, and every vertex that a cut makes gets a skinning row of its own,
// interpolated in its root from the rows of the corners. So a cut surface keeps following the cage, is
// carried to a moment as the skin is, and bears forces by the same transposed weights.
//
// A row follows four rings; where a root's corners follow more between them, what the outermost ring carries
// goes rigidly with the next one, exact in the rest pose.
//
// What a cut does not change: centre line, spheres and cage. They are the whole tube's, so the bowel bends,
// collides, folds on itself and keeps its contents' volume as if its wall were whole (a cut wall has less
// hoop and bending stiffness; how much, by the length and direction of a cut, no source that we know says).
//
// A part without a path to a held vertex falls as one under gravity and is removed after `falling_time`.
//
// World thread; after construction nothing allocates or throws. m, m2, s; frames and results: patient frame.
#pragma once

#include "sim_core/bowel/bowel_skin.h"
#include "sim_core/cutting/cut_mesh.h"

namespace fulcrum {

/// Row of the point with these coordinates in a triangle whose corners have these rows. arc_lengths: of the
/// rings, at rest.
SkinRow interpolate_rows(const SkinRow& a, const SkinRow& b, const SkinRow& c, const Vector3& barycentric,
                         const std::vector<double>& arc_lengths);

class CutSkin {
  public:
    static constexpr int most_loose = 8;         ///< pieces that fall at once; one more falls with the last
    static constexpr double falling_time = 1.0;  ///< s

    /// A part that came free.
    struct Loose {
        bool falls = false;
        Vector3 way = Vector3::Zero(), velocity = Vector3::Zero();  ///< m, m/s
        double area = 0;                                            ///< m2 at rest
        double age = 0;                                             ///< s
    };
    /// All that changes.
    struct State {
        CutState surface;
        std::array<Loose, most_loose> loose{};
        std::vector<std::uint8_t> loose_of;  ///< by vertex: 0 hangs on, else 1 + place in loose
        std::int32_t fallen = 0;             ///< pieces that came free so far
        std::uint64_t history = 0;
    };
    /// What a step of the blade did.
    struct Report {
        CutReport cut;
        int parted = 0;          ///< pieces that came free
        double parted_area = 0;  ///< m2, of all of them
    };

    /// held: vertices by which the bowel hangs together with the body. steps: of a blade that there is room
    /// for. The skin must outlive this. Throws InputError as CutMesh does.
    CutSkin(const BowelSkin& skin, const std::vector<std::int32_t>& held, std::int32_t steps);

    /// Cuts where the rings are now. A piece that comes free begins to fall.
    Report cut(const BladeStep& blade, const RingFrame* frames);
    void begin_stroke() { surface_.begin_stroke(); }
    /// One step of what falls. Returns the area that was removed, m2.
    double fall(const Vector3& gravity, double dt);

    const BowelSkin& skin() const { return skin_; }
    const CutMesh& surface() const { return surface_; }
    const std::array<Loose, most_loose>& loose() const { return loose_; }
    std::int32_t fallen() const { return fallen_; }
    std::uint64_t version() const { return surface_.version(); }
    bool whole() const { return surface_.version() == 0; }
    /// Ground was taken from a triangle of the skin, or it was divided.
    bool touched(std::int32_t root) const {
        return surface_.root(root).visible_count != 1 || !surface_.visible(root);
    }
    /// 0: the vertex hangs on, else 1 + place in loose().
    int loose_of(std::int32_t vertex) const { return loose_of_[static_cast<std::size_t>(vertex)]; }
    int loose_of_triangle(std::int32_t triangle) const {
        return loose_of(surface_.triangle(triangle).vertices[0]);
    }
    const SkinRow& row(std::int32_t vertex) const {
        const auto v = static_cast<std::size_t>(vertex);
        return v < skin_.rows().size() ? skin_.rows()[v] : rows_[v - skin_.rows().size()];
    }
    /// Where a vertex is under these frames (indexed by ring).
    template <typename Frames>
    Vector3 position(std::int32_t vertex, const Frames& frames) const {
        const Vector3 on_cage = skin_vertex(row(vertex), frames);
        const int piece = loose_of(vertex);
        return piece == 0 ? on_cage : Vector3(on_cage + loose_[static_cast<std::size_t>(piece) - 1].way);
    }
    /// All vertices that exist; positions: one for each of surface().capacity().vertices.
    void place_all(const RingFrame* frames, Vector3* positions) const;

    State save() const;
    void restore(const State& state);
    /// Hash of what every commit left of the roots it touched, and of what falls now. Costs nothing to ask.
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
    std::vector<SkinRow> rows_;  ///< of the vertices that cuts made
    std::array<Loose, most_loose> loose_{};
    std::vector<std::uint8_t> loose_of_;
    std::int32_t fallen_ = 0;
    std::uint64_t history_ = 0;
    // Scratch.
    std::vector<Vector3> positions_;    // right near the blade
    std::vector<std::int32_t> queue_;   // triangles of a piece
    std::vector<std::uint32_t> marks_;  // by triangle
    std::uint32_t mark_ = 0;
};

}  // namespace fulcrum
