// SPDX-License-Identifier: GPL-3.0-or-later
// Splitting of vertices: what the pipeline draws is still the same surface.
#include "ui/theatre/renderer/surface_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim_core/anatomy/anatomy.h"
#include "ui/theatre/renderer/tool_mesh.h"

namespace fulcrum::ui {
namespace {

std::uint32_t own(const SurfaceMesh& surface, std::uint32_t index) {
    return index < surface.base ? index : surface.source[index - surface.base];
}

TEST(SurfaceMesh, SeamIsClosedByCopiesAndNoTriangleRunsRoundTheTube) {
    const BowelShape bowel = make_bowel({}, PelvisParameters{});
    const SurfaceMesh surface = split_seam(bowel.surface);
    ASSERT_EQ(surface.indices.size(), 3 * bowel.surface.triangles.size());
    ASSERT_EQ(surface.coordinates.size(), 2 * surface.vertices());
    EXPECT_GT(surface.source.size(), 100U);
    for (std::size_t t = 0; t < bowel.surface.triangles.size(); ++t) {
        float low = 1e9F, high = -1e9F;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t index = surface.indices[3 * t + c];
            EXPECT_EQ(static_cast<std::int32_t>(own(surface, index)), bowel.surface.triangles[t][c]);
            low = std::min(low, surface.coordinates[2 * index]);
            high = std::max(high, surface.coordinates[2 * index]);
        }
        EXPECT_LE(high - low, 0.53F);  // the fans of the two caps reach half round
    }
}

TEST(SurfaceMesh, WallIsProjectedWhereItFacesAnAxisAndBlendedElsewhere) {
    const CavityShape cavity = make_cavity({});
    constexpr double tile = 0.12;
    const SurfaceMesh surface = split_by_plane(cavity.mesh, tile);
    ASSERT_EQ(surface.indices.size(), 3 * cavity.mesh.triangles.size());
    EXPECT_GT(surface.blended_from, surface.indices.size() / 3);
    EXPECT_LT(surface.blended_from, surface.indices.size());
    std::multiset<std::array<std::int32_t, 3>> before(cavity.mesh.triangles.begin(),
                                                      cavity.mesh.triangles.end()),
        after;
    for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
        std::array<std::int32_t, 3> triangle{};
        for (std::size_t c = 0; c < 3; ++c)
            triangle[c] = static_cast<std::int32_t>(own(surface, surface.indices[i + c]));
        after.insert(triangle);
        if (i >= surface.blended_from) continue;
        // One projection for all three corners: lengths in the tile match lengths on the wall to the angle
        // that it makes.
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t a = surface.indices[i + c], b = surface.indices[i + (c + 1) % 3];
            const double du = static_cast<double>(surface.coordinates[2 * a] - surface.coordinates[2 * b]);
            const double dv =
                static_cast<double>(surface.coordinates[2 * a + 1] - surface.coordinates[2 * b + 1]);
            const double drawn = tile * std::hypot(du, dv);
            const double real =
                (cavity.mesh.vertices[own(surface, a)] - cavity.mesh.vertices[own(surface, b)]).norm();
            EXPECT_LE(drawn, real * 1.001);
            EXPECT_GE(drawn, real * 0.4);
        }
    }
    EXPECT_EQ(before, after);
}

TEST(ToolMesh, NormalsAreUnitAndIndicesValid) {
    for (const RigidMesh& mesh :
         {make_shaft(), make_clevis(), make_jaw(), make_probe_end(), make_sphere(), make_box(1, 2, 3)}) {
        ASSERT_EQ(mesh.vertices.size() % 8, 0U);
        for (std::size_t v = 0; v < mesh.vertices.size(); v += 8) {
            const float n = std::hypot(mesh.vertices[v + 3], mesh.vertices[v + 4], mesh.vertices[v + 5]);
            EXPECT_NEAR(n, 1.0F, 1e-4F);
        }
        for (const std::uint32_t index : mesh.indices) EXPECT_LT(index, mesh.vertices.size() / 8);
    }
}

}  // namespace
}  // namespace fulcrum::ui
