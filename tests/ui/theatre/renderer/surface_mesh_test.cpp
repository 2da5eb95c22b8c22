// SPDX-License-Identifier: GPL-3.0-or-later
// Splitting of vertices: the drawn surface is unchanged.
#include "ui/theatre/renderer/surface_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/anatomy/rectum.h"
#include "ui/theatre/renderer/tool_mesh.h"

namespace fulcrum::ui {
namespace {

std::uint32_t own(const SurfaceMesh& surface, std::uint32_t index) {
    return index < surface.base ? index : surface.source[index - surface.base];
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// How often each directed edge of the chosen triangles occurs, by the mesh's own vertices.
std::map<Edge, int> edges_of(const SurfaceMesh& surface, const std::vector<std::uint32_t>& chosen) {
    std::map<Edge, int> edges;
    for (std::size_t t = 0; t < chosen.size(); t += 3) {
        for (std::size_t c = 0; c < 3; ++c)
            ++edges[{own(surface, chosen[t + c]), own(surface, chosen[t + (c + 1) % 3])}];
    }
    return edges;
}

std::vector<std::size_t> all_bands(const SurfaceMesh& surface) {
    std::vector<std::size_t> order(surface.bands.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    return order;
}

TEST(SurfaceMesh, SeamIsClosedByCopiesAndNoTriangleRunsRoundTheTube) {
    const BowelShape bowel = make_bowel({}, PelvisParameters{});
    const SurfaceMesh surface = make_surface(bowel.surface);
    ASSERT_EQ(surface.coordinates.size(), 2 * surface.vertices());
    EXPECT_GT(surface.source.size(), 100U);
    for (std::size_t t = 0; t < bowel.surface.triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(static_cast<std::int32_t>(own(surface, surface.indices[3 * t + c])),
                      bowel.surface.triangles[t][c]);
    }
    // Including coarse ones: at most two columns of 48.
    for (std::size_t t = 0; t < surface.indices.size(); t += 3) {
        float low = 1e9F, high = -1e9F;
        for (std::size_t c = 0; c < 3; ++c) {
            low = std::min(low, surface.coordinates[2 * surface.indices[t + c]]);
            high = std::max(high, surface.coordinates[2 * surface.indices[t + c]]);
        }
        EXPECT_LE(high - low, 2.001F / 48);
    }
}

TEST(SurfaceMesh, FineBandsAreTheMeshItself) {
    const CavityShape cavity = make_cavity({});
    const SurfaceMesh surface = make_surface(cavity.mesh);
    std::vector<std::uint32_t> chosen;
    choose_triangles(surface, all_bands(surface), std::vector<char>(surface.bands.size(), 1), chosen);
    ASSERT_EQ(chosen.size(), 3 * cavity.mesh.triangles.size());
    for (std::size_t i = 0; i < chosen.size(); ++i)
        ASSERT_EQ(static_cast<std::int32_t>(own(surface, chosen[i])), cavity.mesh.triangles[i / 3][i % 3]);
}

TEST(SurfaceMesh, CoarseAndFineBandsMeetWithoutAGap) {
    for (const TriangleMesh& mesh : {make_bowel({}, PelvisParameters{}).surface, make_cavity({}).mesh}) {
        const SurfaceMesh surface = make_surface(mesh);
        ASSERT_GT(surface.bands.size(), 8U);
        ASSERT_GT(surface.coarse_edge, 0.0);
        const double fine_volume = std::abs(enclosed_volume(mesh.vertices, mesh.triangles));
        for (std::uint32_t pattern = 0; pattern < 12; ++pattern) {
            std::vector<char> fine(surface.bands.size());
            for (std::size_t b = 0; b < fine.size(); ++b)
                fine[b] = pattern == 0 ? 0 : static_cast<char>((b * 2654435761U * pattern >> 7) & 1U);
            std::vector<std::uint32_t> chosen;
            choose_triangles(surface, all_bands(surface), fine, chosen);
            if (pattern == 0) {
                EXPECT_LT(chosen.size(), mesh.triangles.size());  // a third of the indices at most
            }
            // Watertight and consistently oriented: each directed edge once, its reverse once.
            const std::map<Edge, int> edges = edges_of(surface, chosen);
            std::vector<Triangle> triangles;
            for (const auto& [edge, count] : edges) {
                ASSERT_EQ(count, 1);
                ASSERT_EQ(edges.count({edge.second, edge.first}), 1U) << "pattern " << pattern;
            }
            for (std::size_t t = 0; t < chosen.size(); t += 3) {
                triangles.push_back({});
                for (std::size_t c = 0; c < 3; ++c)
                    triangles.back()[c] = static_cast<std::int32_t>(own(surface, chosen[t + c]));
            }
            EXPECT_NEAR(std::abs(enclosed_volume(mesh.vertices, triangles)) / fine_volume, 1.0, 0.02);
        }
    }
}

TEST(SurfaceMesh, AMeshWithoutRowsOrCoordinatesIsDrawnAsItIs) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    const SurfaceMesh surface = make_surface(mesh);
    EXPECT_EQ(surface.vertices(), 4U);
    EXPECT_EQ(surface.coordinates.size(), 8U);
    ASSERT_EQ(surface.bands.size(), 1U);
    std::vector<std::uint32_t> chosen;
    choose_triangles(surface, {0}, {0}, chosen);
    EXPECT_EQ(chosen, surface.indices);
    EXPECT_EQ(chosen.size(), 12U);
}

TEST(ToolMesh, NormalsAreUnitAndIndicesValid) {
    for (const RigidMesh& mesh :
         {make_shaft(), make_clevis(), make_jaw(), make_blade(), make_rod(), make_tube_end(),
          make_probe_end(), make_hook(), make_sphere(), make_box(1, 2, 3)}) {
        ASSERT_EQ(mesh.vertices.size() % 8, 0U);
        for (std::size_t v = 0; v < mesh.vertices.size(); v += 8) {
            const float n = std::hypot(mesh.vertices[v + 3], mesh.vertices[v + 4], mesh.vertices[v + 5]);
            EXPECT_NEAR(n, 1.0F, 1e-4F);
        }
        for (const std::uint32_t index : mesh.indices) EXPECT_LT(index, mesh.vertices.size() / 8);
    }
}

// Rings around the pole of a dome would stretch the texture into a star.
TEST(SurfaceMesh, DomesDoNotStretchTheTexture) {
    RectumParameters rectum;
    rectum.curve.centre = Vector3(0, 0, 0.1);
    rectum.curve.curve_radius = 0.1;
    rectum.curve.rectum_radius = 0.016;
    rectum.curve.gap = 0.02;
    const BowelShape shape = make_rectum(rectum);
    // Widest against narrowest scale of the tile (one circumference by two) in a triangle near a pole.
    const auto drawn_out = [&shape](bool domes) {
        const SurfaceMesh surface = make_bowel_surface(shape.surface, domes);
        double worst = 1;
        for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
            Eigen::Matrix<double, 3, 2> place;
            Eigen::Matrix2d tile;
            bool near = true;
            Vector3 corner[3];
            Eigen::Vector2d at[3];
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t index = surface.indices[i + c];
                corner[c] = shape.surface.vertices[own(surface, index)];
                near = near && std::hypot(corner[c].y(), corner[c].z()) < 0.6 * 0.016;
                at[c] = {surface.coordinates[2 * index], 2.0 * surface.coordinates[2 * index + 1]};
            }
            if (!near) continue;
            for (int side = 0; side < 2; ++side) {
                place.col(side) = corner[side + 1] - corner[0];
                tile.col(side) = at[side + 1] - at[0];
            }
            const Eigen::Matrix<double, 3, 2> scale = place * tile.inverse();
            const Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>> parts(scale);
            worst = std::max(worst, parts.singularValues()[0] / std::max(1e-12, parts.singularValues()[1]));
        }
        return worst;
    };
    EXPECT_LT(drawn_out(true), 2.0);
    EXPECT_GT(drawn_out(false), 4.0);
}

}  // namespace
}  // namespace fulcrum::ui
