// SPDX-License-Identifier: Apache-2.0
// The finer scopes of skinning, the corrected patch rows, and the contents of the lumen.
#include "sim_core/bowel/wide_skin.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/bowel/luminal_volume.h"
#include "sim_core/bowel/mean_value.h"
#include "sim_core/contact/patch_builder.h"
#include "sim_core/geometry/mesh.h"
#include "tests/support/tube.h"

namespace fulcrum {
namespace {

const BowelSkin& skin() {
    static const BowelSkin skin = test::make_skin(0.3, 0.016, 0.016, 75, 24, test::haustral_radius(0.016));
    return skin;
}

TEST(WideSkin, GlobalIsMeanValueCoordinatesOfTheWholeCage) {
    const WideSkin global(skin(), SkinScope::global);
    const std::vector<RingFrame> rest = test::rest_frames(skin().cage()),
                                 bent = test::bent_frames(skin().cage(), 0.06);
    // The reference of the skin study: the closed cage, caps folded into their rings.
    const std::vector<Vector3> rest_cage = cage_vertices(skin().cage(), rest.data()),
                               bent_cage = cage_vertices(skin().cage(), bent.data());
    const CageTopology topology(cage_triangles(skin().rings()));
    MeanValueScratch scratch;
    std::vector<double> weights(rest_cage.size());
    for (std::int32_t v = 0; v < skin().vertices(); v += 37) {
        const Vector3& vertex = skin().rest().vertices[static_cast<std::size_t>(v)];
        mean_value_weights(rest_cage, topology, vertex, scratch, weights.data());
        Vector3 expected = Vector3::Zero();
        for (std::size_t i = 0; i < weights.size(); ++i) expected += weights[i] * bent_cage[i];
        EXPECT_LT((global.vertex(v, bent) - expected).norm(), 1e-12);
        EXPECT_LT((global.vertex(v, rest) - vertex).norm(), 1e-10);
    }
}

TEST(WideSkin, WiderLocalScopesAreCloserToGlobal) {
    const WideSkin global(skin(), SkinScope::global), wider(skin(), SkinScope::local2);
    const std::vector<RingFrame> bent = test::bent_frames(skin().cage(), 0.06);
    double local = 0, local2 = 0, largest = 0;
    for (std::int32_t v = 0; v < skin().vertices(); ++v) {
        const Vector3 exact = global.vertex(v, bent);
        const double deviation =
            (skin_vertex(skin().rows()[static_cast<std::size_t>(v)], bent) - exact).norm();
        local += deviation / skin().vertices();
        largest = std::max(largest, deviation);
        local2 += (wider.vertex(v, bent) - exact).norm() / skin().vertices();
    }
    EXPECT_LT(local2, local);
    EXPECT_LT(local, 0.0005) << "m, mean in a bend of 60 mm radius";
    EXPECT_GT(local, 1e-9) << "the scopes differ";
    RecordProperty("local_mean_m", std::to_string(local));
    RecordProperty("local_largest_m", std::to_string(largest));
    RecordProperty("local2_mean_m", std::to_string(local2));
}

TEST(WideSkin, PatchHasThePositionsOfItsScope) {
    for (const SkinScope scope : {SkinScope::local2, SkinScope::global}) {
        const WideSkin wide(skin(), scope);
        const std::vector<RingFrame> bent = test::bent_frames(skin().cage(), 0.06);
        for (std::int32_t v = 0; v < skin().vertices(); v += 11) {
            SkinRow row = skin().rows()[static_cast<std::size_t>(v)];
            wide.correct(v, bent, row);
            EXPECT_LT((skin_vertex(row, bent) - wide.vertex(v, bent)).norm(), 1e-12);
            // Extrapolated rigidly, the patch moves with its rings.
            std::vector<RingFrame> moved = bent;
            const Matrix3 turn = Eigen::AngleAxisd(0.3, Vector3(1, 2, 3).normalized()).toRotationMatrix();
            for (RingFrame& frame : moved) {
                frame.position = turn * frame.position + Vector3(0.1, 0, 0.2);
                frame.rotation = turn * frame.rotation;
            }
            EXPECT_LT((skin_vertex(row, moved) - wide.vertex(v, moved)).norm(), 1e-12);
        }
    }
}

TEST(LuminalVolume, ContentsConserveTheVolumeOfAStretchedTube) {
    const Cage& cage = skin().cage();
    LuminalSpec spec;
    LuminalVolume none(cage, spec);
    spec.bulk_modulus = 1e7;
    LuminalVolume filled(cage, spec);
    const auto rings = static_cast<std::size_t>(cage.rings());
    for (const double pull : {0.1, 0.3, 0.6}) {
        // Pulled in the middle only, as by two graspers.
        std::vector<double> stretch(rings, 1.0);
        for (std::size_t r = rings / 4; r < 3 * rings / 4; ++r) stretch[r] = 1 + pull;
        none.solve(stretch.data());
        EXPECT_GT(none.volume_ratio(stretch.data()), 1 + 0.4 * pull) << "without contents the volume grows";
        const double pressure = filled.solve(stretch.data());
        EXPECT_NEAR(filled.volume_ratio(stretch.data()), 1.0, 0.002) << pull;
        EXPECT_LT(pressure, 0) << "the wall is drawn in";
        EXPECT_NEAR(pressure, -1e7 * (filled.volume_ratio(stretch.data()) - 1), 1.0);
        EXPECT_EQ(none.scale(3), 1.0);

        // And the surface itself: rings apart by the stretch, scaled by the pressure.
        std::vector<RingFrame> frames = test::rest_frames(cage);
        double x = cage.arc_lengths.front();
        for (std::size_t r = 0; r < rings; ++r) {
            if (r > 0)
                x += (cage.arc_lengths[r] - cage.arc_lengths[r - 1]) * 0.5 * (stretch[r] + stretch[r - 1]);
            frames[r].position.x() = x;
        }
        std::vector<Vector3> positions(static_cast<std::size_t>(skin().vertices()));
        const double rest = enclosed_volume(skin().rest().vertices, skin().rest().triangles);
        skin_all(skin(), frames.data(), positions.data());
        const double open = enclosed_volume(positions, skin().rest().triangles) / rest;
        for (std::size_t r = 0; r < rings; ++r)
            frames[r].rotation.leftCols<2>() *= filled.scale(static_cast<int>(r));
        skin_all(skin(), frames.data(), positions.data());
        const double kept = enclosed_volume(positions, skin().rest().triangles) / rest;
        EXPECT_GT(open, 1 + 0.35 * pull);
        EXPECT_NEAR(kept, 1.0, 0.02) << "pull " << pull << ": " << open << " without contents";
        RecordProperty(("pull_" + std::to_string(std::lround(100 * pull))).c_str(),
                       std::to_string(open) + " open, " + std::to_string(kept) + " kept");
    }
}

}  // namespace
}  // namespace fulcrum
