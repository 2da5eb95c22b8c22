// SPDX-License-Identifier: Apache-2.0
// The bowel's surface cut on its cage: new vertices follow the cage, area is conserved, detached pieces fall,
// and the rest of the surface is unchanged.
#include "tests/sim_core/bowel/cut_skin_rig.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "sim_core/numerics/random.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

using test::CutTube;
using test::TubePoint;

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

std::vector<Vector3> positions_of(const CutSkin& cut, const std::vector<RingFrame>& frames) {
    std::vector<Vector3> positions(at(cut.surface().capacity().vertices), Vector3::Zero());
    cut.place_all(frames.data(), positions.data());
    return positions;
}

// A slit along the tube, one across it, a bow over a fold.
void cut_some(CutTube& tube) {
    tube.stroke(CutTube::line({0.05, 0.2}, {0.09, 0.5}, 30));
    tube.stroke(CutTube::line({0.07, -0.6}, {0.071, 1.4}, 30));
    tube.stroke(CutTube::line({0.10, 2.0}, {0.13, 3.4}, 36));
}

TEST(CutSkin, UncutSurfaceEqualsTheSkinBitForBit) {
    CutTube tube;
    for (const auto& frames : {test::rest_frames(tube.skin.cage()), test::bent_frames(tube.skin.cage(), 0.03),
                               test::twisted_frames(tube.skin.cage(), 12)}) {
        std::vector<Vector3> whole(at(tube.skin.vertices()));
        skin_all(tube.skin, frames.data(), whole.data());
        const std::vector<Vector3> cut = positions_of(tube.cut, frames);
        for (std::size_t v = 0; v < whole.size(); ++v) ASSERT_EQ(whole[v], cut[v]);
    }
    EXPECT_EQ(tube.cut.surface().visible_triangles(), tube.skin.rest().triangles);
    EXPECT_TRUE(tube.cut.whole());
}

TEST(CutSkin, NewVerticesKeepTheirRestPositions) {
    CutTube tube;
    tube.frames = test::bent_frames(tube.skin.cage(), 0.05);
    cut_some(tube);
    const auto rest = test::rest_frames(tube.skin.cage());
    double worst = 0, weights = 0;
    int made = 0;
    for (std::int32_t v = tube.skin.vertices(); v < tube.cut.surface().vertex_count(); ++v) {
        if (tube.cut.surface().vertex(v).triangle < 0) continue;
        ++made;
        const SkinRow& row = tube.cut.row(v);
        worst = std::max(worst, (skin_vertex(row, rest) - tube.cut.surface().vertex(v).rest).norm());
        weights =
            std::max(weights, std::abs(row.weight[0] + row.weight[1] + row.weight[2] + row.weight[3] - 1));
        ASSERT_GE(row.first_ring, 0);
        ASSERT_LE(row.first_ring + skin_rings, tube.skin.rings());
    }
    EXPECT_GT(made, 300);
    EXPECT_LE(worst, 1e-12);
    EXPECT_LE(weights, 1e-12);
}

// Reference: interpolation in the deformed root, which corresponds to a row with any number of rings. A row
// of four rings agrees to micrometres in the tightest bend of the bowel.
TEST(CutSkin, NewVerticesStayInTheirDeformedRoots) {
    CutTube tube;
    cut_some(tube);
    const CutMesh& surface = tube.cut.surface();
    const auto deviation = [&](const std::vector<RingFrame>& frames) {
        double worst = 0;
        for (std::int32_t v = tube.skin.vertices(); v < surface.vertex_count(); ++v) {
            const CutVertex& vertex = surface.vertex(v);
            if (vertex.triangle < 0) continue;
            Vector3 in_root = Vector3::Zero();
            for (int c = 0; c < 3; ++c)
                in_root += vertex.barycentric[c] *
                           skin_vertex(
                               tube.skin.rows()[at(
                                   tube.skin.rest().triangles[at(vertex.root)][static_cast<std::size_t>(c)])],
                               frames);
            worst = std::max(worst, (tube.cut.position(v, frames) - in_root).norm());
        }
        return worst;
    };
    const double bent = deviation(test::bent_frames(tube.skin.cage(), 0.03));
    const double twisted = deviation(test::twisted_frames(tube.skin.cage(), 12));
    std::printf("from the deformed root: bent to 30 mm %.3g m, twisted 12 rad/m %.3g m\n", bent, twisted);
    EXPECT_LE(bent, 1e-6);
    EXPECT_LE(twisted, 1e-6);
    EXPECT_GT(bent, 0);  // four rings are not five
}

TEST(CutSkin, KeepsAllInvariantsAndTheArea) {
    for (const double bend : {0.0, 0.04}) {
        CutTube tube;
        if (bend > 0) tube.frames = test::bent_frames(tube.skin.cage(), bend);
        cut_some(tube);
        tube.stroke(CutTube::circle({0.03, 1.0}, 0.005));
        const std::vector<Vector3> positions = positions_of(tube.cut, tube.frames);
        const CutCheck check = check_cut(tube.cut.surface(), positions.data());
        EXPECT_TRUE(check.passed()) << check.complaint();
        EXPECT_LE(check.area_error, 1e-9);
        const CutMesh& surface = tube.cut.surface();
        EXPECT_NEAR(surface.area_before(), surface.area_visible() + surface.area_removed(),
                    1e-9 * surface.area_before());
        EXPECT_GT(surface.area_removed(), 0.06 * CutTube::blade_width);
        EXPECT_EQ(surface.rolled_back(), 0U);
    }
}

TEST(CutSkin, DiscFallsAndIsRemovedButSpiralStays) {
    CutTube tube;
    const CutSkin::Report slit = tube.stroke(CutTube::line({0.05, 0.2}, {0.09, 0.5}, 30));
    EXPECT_EQ(slit.parted, 0);
    const double before = tube.cut.surface().area_visible();
    const double size = 0.006;
    const CutSkin::Report disc = tube.stroke(CutTube::circle({0.11, 1.0}, size));
    ASSERT_EQ(disc.parted, 1);
    const double inner = size - 0.5 * CutTube::blade_width;
    EXPECT_NEAR(disc.parted_area, 3.1416 * inner * inner, 0.15 * disc.parted_area);
    EXPECT_EQ(tube.cut.fallen(), 1);
    // It falls as one piece.
    const Vector3 gravity(0, 0, -9.81);
    const double dt = 0.005;
    double fallen = 0, removed = 0;
    for (int i = 0; i < 100; ++i) removed += tube.cut.fall(gravity, dt);
    for (std::int32_t v = 0; v < tube.cut.surface().vertex_count(); ++v) {
        if (tube.cut.loose_of(v) == 0) continue;
        fallen = (tube.cut.position(v, tube.frames) - skin_vertex(tube.cut.row(v), tube.frames)).z();
        EXPECT_NEAR(fallen, -0.5 * 9.81 * 0.25, 0.02);
    }
    EXPECT_LT(fallen, 0);
    EXPECT_EQ(removed, 0.0);
    for (int i = 0; i < 120; ++i) removed += tube.cut.fall(gravity, dt);
    EXPECT_NEAR(removed, disc.parted_area, 1e-12);
    EXPECT_NEAR(before, tube.cut.surface().area_visible() + disc.cut.removed_area + removed, 1e-9 * before);
    EXPECT_FALSE(tube.cut.loose()[0].falls);
    const std::vector<Vector3> positions = positions_of(tube.cut, tube.frames);
    const CutCheck check = check_cut(tube.cut.surface(), positions.data());
    EXPECT_TRUE(check.passed()) << check.complaint();
    // Several turns without closing.
    std::vector<TubePoint> spiral;
    for (int i = 0; i < 80; ++i) {
        double sine = 0, cosine = 1;
        math::sin_cos(0.25 * i, sine, cosine);
        const double r = 0.002 + 0.0001 * i;
        spiral.push_back({0.04 + r * cosine, 3.0 + r / CutTube::radius * sine});
    }
    EXPECT_EQ(tube.stroke(spiral).parted, 0);
}

// The local search compared with the full one, over strokes that cross each other at random.
TEST(CutSkin, LocalSearchFindsTheSamePiecesAsFullSearch) {
    Random random(11);
    int parted = 0;
    for (int round = 0; round < 4; ++round) {
        CutTube tube(600);
        for (int i = 0; i < 10; ++i) {
            const TubePoint centre{random.uniform(0.05, 0.09), random.uniform(0.0, 1.5)};
            const CutSkin::Report report = tube.stroke(CutTube::circle(centre, random.uniform(0.002, 0.008)));
            parted += report.parted;
            CutMesh copy = tube.cut.surface();
            const std::int32_t pieces = copy.find_pieces();
            for (std::int32_t p = 0; p < pieces; ++p) {
                ASSERT_EQ(copy.piece(p).fixed, tube.cut.loose_of_triangle(copy.piece(p).first) == 0);
            }
            for (int k = 0; k < 210 && i % 3 == 2; ++k) tube.cut.fall(Vector3(0, 0, -9.81), 0.005);
        }
    }
    EXPECT_GE(parted, 20);
}

TEST(CutSkin, TubeCutThroughStaysAttachedAtBothEnds) {
    CutTube tube;
    const CutSkin::Report once = tube.stroke(CutTube::line({0.06, 0}, {0.06, 6.4}, 90));
    EXPECT_EQ(once.parted, 0);
    CutMesh copy = tube.cut.surface();
    EXPECT_EQ(copy.find_pieces(), 2);
    // A piece between two such cuts is detached.
    const CutSkin::Report twice = tube.stroke(CutTube::line({0.08, 0}, {0.08, 6.4}, 90));
    EXPECT_EQ(twice.parted, 1);
    EXPECT_NEAR(twice.parted_area, 6.2832 * 0.016 * 0.0194, 0.2 * twice.parted_area);
}

TEST(CutSkin, ContinuesFromASavedStateBitForBit) {
    CutTube tube, other;
    tube.stroke(CutTube::circle({0.11, 1.0}, 0.006));
    const CutSkin::State saved = tube.cut.save();
    other.cut.restore(saved);
    for (CutTube* one : {&tube, &other}) {
        for (int i = 0; i < 50; ++i) one->cut.fall(Vector3(0, 0, -9.81), 0.005);
        one->stroke(CutTube::line({0.10, 0.2}, {0.12, 1.9}, 30));
    }
    EXPECT_EQ(tube.cut.digest(), other.cut.digest());
    EXPECT_EQ(tube.cut.surface().digest(), other.cut.surface().digest());
    for (std::int32_t v = 0; v < tube.cut.surface().vertex_count(); ++v)
        ASSERT_EQ(tube.cut.position(v, tube.frames), other.cut.position(v, other.frames));
}

TEST(CutSkin, AllocatesNothingAndReportsMissingCapacity) {
    CutTube tube(12);
    BladeStep blade;
    blade.width = CutTube::blade_width;
    blade.end = BladeEnd::round;
    bool full = false;
    std::uint64_t allocations = 0;
    for (int i = 0; i < 200 && !full; ++i) {
        const Vector3 from = tube.at_rest({0.05 + 0.0004 * i, 0.02 * i}),
                      to = tube.at_rest({0.0504 + 0.0004 * i, 0.02 * i + 0.02});
        blade.from = from;
        blade.to = to;
        blade.normal = Vector3(0, from.y(), from.z());
        blade.root = i == 0
                         ? tube.cut.surface().nearest_root(from, positions_of(tube.cut, tube.frames).data())
                         : blade.root;
        CutSkin::Report report;
        allocations += test::allocations_in([&] {
            report = tube.cut.cut(blade, tube.frames.data());
            tube.cut.fall(Vector3(0, 0, -9.81), 0.005);
        });
        if (report.cut.root >= 0) blade.root = report.cut.root;
        full = report.cut.outcome == CutOutcome::full;
        if (full) {
            EXPECT_NE(report.cut.lacking, CutLimit::none);
        }
    }
    EXPECT_TRUE(full);
    EXPECT_EQ(allocations, 0U);
    // Non-finite frames and blades cut nothing.
    blade.to.x() = std::nan("");
    EXPECT_EQ(tube.cut.cut(blade, tube.frames.data()).cut.outcome, CutOutcome::invalid);
    blade.to = tube.at_rest({0.06, 0.1});
    std::vector<RingFrame> thrown = tube.frames;
    for (RingFrame& frame : thrown) frame.position.y() = std::nan("");
    const std::uint64_t version = tube.cut.version();
    tube.cut.cut(blade, thrown.data());
    EXPECT_EQ(tube.cut.version(), version);
}

}  // namespace
}  // namespace fulcrum
