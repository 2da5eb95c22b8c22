// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/geometry/mesh.h"
#include "sim_core/lab/reference_tube.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

TriangleMesh tetrahedron() {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

TEST(Mesh, ComputesVolumeAndAreaOfATetrahedron) {
    const TriangleMesh mesh = tetrahedron();
    EXPECT_NEAR(enclosed_volume(mesh.vertices, mesh.triangles), 1.0 / 6.0, 1e-15);
    EXPECT_NEAR(surface_area(mesh), 1.5 + std::sqrt(3.0) / 2.0, 1e-15);
    const MeshReport report = check_mesh(mesh);
    EXPECT_TRUE(report.watertight()) << report.complaint();
    EXPECT_EQ(report.euler_characteristic, 2);
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.complaint(), "");
    const auto normals = vertex_normals(mesh);
    EXPECT_LE((normals[3] - Vector3(0.0, 0.0, 1.0).normalized()).norm(), 1.0);
    EXPECT_GT(normals[3].dot(Vector3(-1, -1, 3)), 0.0);
}

TEST(Mesh, FindsItsNeighbours) {
    const TriangleMesh mesh = lab::make_tube(0.1, 20, 16, lab::plain_radius(0.01));
    const MeshAdjacency adjacency = build_adjacency(mesh);
    const SurfaceView view = view_of(mesh, adjacency);
    const std::int32_t inner = 16 * 10 + 3;
    EXPECT_EQ(view.triangles_of(inner).count, 6);
    EXPECT_EQ(view.neighbours_of(inner).count, 6);
    EXPECT_EQ(view.neighbours_of(16 * 21).count, 16) << "cap centre";
    for (std::int32_t t = 0; t < view.triangle_count; ++t) {
        for (int e = 0; e < 3; ++e) {
            const std::int32_t other = view.neighbour(t, e);
            ASSERT_GE(other, 0);
            const auto a = mesh.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(e)];
            const auto b = mesh.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>((e + 1) % 3)];
            const auto& corners = mesh.triangles[static_cast<std::size_t>(other)];
            EXPECT_NE(std::find(corners.begin(), corners.end(), a), corners.end());
            EXPECT_NE(std::find(corners.begin(), corners.end(), b), corners.end());
        }
    }
    for (std::int32_t v = 0; v < view.vertex_count; ++v) {
        const auto ring = view.neighbours_of(v);
        EXPECT_TRUE(std::is_sorted(ring.begin(), ring.end()));
        const auto fan = view.triangles_of(v);
        EXPECT_TRUE(std::is_sorted(fan.begin(), fan.end()));
        // Normals of the tube's wall point away from its axis.
        if (v >= 16 * 21) continue;
        const Vector3& vertex = mesh.vertices[static_cast<std::size_t>(v)];
        EXPECT_GT(vertex_normal(view, v).dot(Vector3(0.0, vertex.y(), vertex.z())), 0.0);
    }
}

TEST(Mesh, VolumeOfATubeConvergesToTheCylinder) {
    double last = 1.0;
    for (const int around : {16, 32, 64}) {
        const TriangleMesh mesh = lab::make_tube(0.2, around, around, lab::plain_radius(0.01));
        const double error =
            std::abs(enclosed_volume(mesh.vertices, mesh.triangles) / (3.14159265358979323846 * 2e-5) - 1.0);
        EXPECT_LT(error, 0.3 * last);
        last = error;
    }
}

TEST(MeshCheck, ReportsTheDefect) {
    TriangleMesh hole = tetrahedron();
    hole.triangles.pop_back();
    EXPECT_FALSE(check_mesh(hole).closed);
    EXPECT_NE(check_mesh(hole).complaint().find("hole"), std::string::npos);

    TriangleMesh flipped = tetrahedron();
    std::swap(flipped.triangles[1][0], flipped.triangles[1][1]);
    EXPECT_FALSE(check_mesh(flipped).oriented);

    TriangleMesh inside_out = tetrahedron();
    for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
    EXPECT_TRUE(check_mesh(inside_out).watertight());
    EXPECT_LT(check_mesh(inside_out).volume, 0.0);

    TriangleMesh wing = tetrahedron();
    wing.vertices.emplace_back(1, 1, 1);
    wing.triangles.push_back({0, 1, 4});
    EXPECT_FALSE(check_mesh(wing).manifold_edges);

    TriangleMesh flat = tetrahedron();
    flat.vertices[3] = Vector3(0.5, 0.5, 0.0);
    EXPECT_FALSE(check_mesh(flat).no_zero_area);

    TriangleMesh lost = tetrahedron();
    lost.triangles[2][1] = 9;
    EXPECT_FALSE(check_mesh(lost).indices_valid);
    EXPECT_EQ(check_mesh(lost).first_bad_triangle, 2);
    EXPECT_THROW(build_adjacency(lost), InputError);

    TriangleMesh unknown = tetrahedron();
    unknown.vertices[2].x() = std::nan("");
    EXPECT_FALSE(check_mesh(unknown).finite);
    EXPECT_FALSE(check_mesh(unknown).watertight());

    // Two tetrahedra joined at one vertex: every edge is fine, the vertex is not.
    TriangleMesh joined = tetrahedron();
    for (const Vector3& v : {Vector3(-1, 0, 0), Vector3(0, -1, 0), Vector3(0, 0, -1)})
        joined.vertices.push_back(v);
    for (Triangle t : {Triangle{0, 5, 4}, Triangle{0, 4, 6}, Triangle{0, 6, 5}, Triangle{4, 5, 6}}) {
        std::swap(t[0], t[1]);
        joined.triangles.push_back(t);
    }
    EXPECT_TRUE(check_mesh(joined).closed);
    EXPECT_FALSE(check_mesh(joined).manifold_vertices);
    EXPECT_EQ(check_mesh(joined).first_bad_vertex, 0);

    TriangleMesh stray = tetrahedron();
    stray.vertices.emplace_back(3, 3, 3);
    EXPECT_FALSE(check_mesh(stray).no_stray_vertex);
    EXPECT_TRUE(check_mesh(stray).watertight());
    EXPECT_FALSE(check_mesh(TriangleMesh{}).watertight());
}

// Against a dense search over the triangle's own points.
TEST(ClosestPoint, IsNoFartherThanAnyOtherPoint) {
    Random random(3);
    const auto any = [&random] {
        return Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    int features[7] = {0, 0, 0, 0, 0, 0, 0};
    for (int round = 0; round < 400; ++round) {
        const Vector3 a = any(), b = any(), c = round % 10 == 0 ? Vector3(a + 0.5 * (b - a)) : any(),
                      p = 2.0 * any();
        const TrianglePoint closest = closest_point_on_triangle(p, a, b, c);
        ++features[static_cast<int>(closest.feature)];
        EXPECT_NEAR(closest.barycentric.sum(), 1.0, 1e-12);
        EXPECT_GE(closest.barycentric.minCoeff(), -1e-12);
        const Vector3 again =
            closest.barycentric[0] * a + closest.barycentric[1] * b + closest.barycentric[2] * c;
        EXPECT_LE((again - closest.position).norm(), 1e-9);
        const double distance = (closest.position - p).norm();
        for (int i = 0; i <= 20; ++i) {
            for (int j = 0; i + j <= 20; ++j) {
                const double u = i / 20.0, v = j / 20.0;
                ASSERT_LE(distance, (u * a + v * b + (1.0 - u - v) * c - p).norm() + 1e-9);
            }
        }
    }
    for (const int count : features) EXPECT_GT(count, 0);
}

TEST(ClosestPoint, HandlesDegenerateTriangles) {
    const Vector3 p(1, 2, 3), a(0, 0, 0), b(2, 0, 0);
    EXPECT_LE((closest_point_on_triangle(p, a, a, a).position - a).norm(), 0.0);
    EXPECT_LE((closest_point_on_triangle(p, a, b, b).position - Vector3(1, 0, 0)).norm(), 1e-15);
    EXPECT_LE((closest_point_on_triangle(p, a, b, Vector3(0.5, 1e-13, 0)).position - Vector3(1, 0, 0)).norm(),
              1e-12);
}

TEST(ClosestSegments, AreNoFartherThanAnyOtherPair) {
    Random random(5);
    const auto any = [&random] {
        return Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    for (int round = 0; round < 300; ++round) {
        const Vector3 p0 = any(), q0 = any(), q1 = any();
        const Vector3 p1 = round % 7 == 0 ? Vector3(p0 + 0.3 * (q1 - q0)) : (round % 11 == 0 ? p0 : any());
        const SegmentPair pair = closest_points_of_segments(p0, p1, q0, q1);
        const double distance = (pair.on_first - pair.on_second).norm();
        for (int i = 0; i <= 20; ++i) {
            for (int j = 0; j <= 20; ++j) {
                ASSERT_LE(distance, (p0 + i / 20.0 * (p1 - p0) - q0 - j / 20.0 * (q1 - q0)).norm() + 1e-9);
            }
        }
    }
}

}  // namespace
}  // namespace fulcrum
