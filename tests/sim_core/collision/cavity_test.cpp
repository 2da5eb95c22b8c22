// SPDX-License-Identifier: Apache-2.0
// The cavity's queries against brute force over all triangles and against FCL's own distance.
#include "sim_core/collision/cavity.h"

#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/random.h"
#include "tests/support/cavity.h"

namespace fulcrum {
namespace {

const Vector3 half_axes(0.06, 0.055, 0.05);

double brute_distance(const TriangleMesh& mesh, const Vector3& point, std::size_t triangle) {
    const Triangle& t = mesh.triangles[triangle];
    const auto at = [&](int k) {
        return mesh.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
    };
    return (point - closest_point_on_triangle(point, at(0), at(1), at(2)).position).norm();
}

TEST(Cavity, ListHasEveryTriangleWithinReach) {
    const TriangleMesh mesh = test::make_bowl(half_axes, 30, 40, 0.05);
    const CavityModel cavity(mesh, FreeSide::behind);
    Random random(3);
    std::vector<ListedCluster> found(1000);
    for (int trial = 0; trial < 60; ++trial) {
        const Vector3 point(random.uniform(-0.07, 0.07), random.uniform(-0.07, 0.07),
                            random.uniform(-0.07, 0.07));
        const double reach = random.uniform(0.001, 0.03);
        const int count = cavity.list(point, reach, found.data(), 1000);
        std::set<std::int32_t> listed;
        for (int c = 0; c < count; ++c) {
            const ListedCluster& entry = found[static_cast<std::size_t>(c)];
            EXPECT_LE(static_cast<double>(entry.distance), reach);
            const TriangleCluster& cluster = cavity.cluster(entry.cluster);
            for (int k = 0; k < cluster.count; ++k) {
                EXPECT_TRUE(listed.insert(cluster.triangle[k]).second);
                EXPECT_LE(static_cast<double>(entry.distance),
                          brute_distance(mesh, point, static_cast<std::size_t>(cluster.triangle[k])));
            }
        }
        EXPECT_LT(listed.size(), mesh.triangles.size());
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (brute_distance(mesh, point, t) <= reach) {
                EXPECT_EQ(listed.count(static_cast<std::int32_t>(t)), 1U) << t;
            }
        }
    }
}

// Rough: every vertex moved at random, so that ridges, valleys and saddles of all kinds meet.
TriangleMesh rough_bowl(std::uint64_t seed, double roughness) {
    TriangleMesh mesh = test::make_bowl(half_axes, 24, 32, 0.1);
    Random random(seed);
    for (Vector3& vertex : mesh.vertices) {
        for (int i = 0; i < 3; ++i) vertex[i] += random.uniform(-roughness, roughness);
    }
    return mesh;
}

TEST(Cavity, WhoeverIsNotConcernedIsNeverTheNearest) {
    std::vector<ListedCluster> found(1000);
    long left_out = 0, kept = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const CavityModel cavity(rough_bowl(seed, 0.0001 * static_cast<double>(seed)), FreeSide::behind);
        Random random(seed, 1);
        for (int trial = 0; trial < 300; ++trial) {
            const Vector3 point(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05),
                                random.uniform(-0.05, 0.05));
            const CavityPoint nearest = cavity.closest(point, 1.0);
            const double reach = std::abs(nearest.distance) + 0.002;
            bool concerned_nearest = false;
            const int count = cavity.list(point, reach, found.data(), 1000);
            for (int c = 0; c < count; ++c) {
                const TriangleCluster& cluster = cavity.cluster(found[static_cast<std::size_t>(c)].cluster);
                const float point4[4] = {static_cast<float>(point.x()), static_cast<float>(point.y()),
                                         static_cast<float>(point.z()), 0.0F};
                float concern[cluster_size];
                const bool any = CavityModel::concerns(cluster, point4, static_cast<float>(reach), concern);
                for (int k = 0; k < cluster.count; ++k) {
                    const bool concerned = any && concern[k] < 0 && cavity.confirms(cluster, k, point4);
                    (concerned ? kept : left_out) += 1;
                    if (!concerned) continue;
                    const double distance = std::abs(cavity.closest_on(cluster.triangle[k], point).distance);
                    concerned_nearest = concerned_nearest || distance <= std::abs(nearest.distance) + 1e-12;
                }
            }
            EXPECT_TRUE(concerned_nearest) << seed << " " << trial;
        }
    }
    EXPECT_GT(left_out, 3 * kept);
}

TEST(Cavity, ClosestPointAgreesWithBruteForceAndFcl) {
    const TriangleMesh mesh = test::make_bowl(half_axes, 24, 30, 0.08);
    const CavityModel cavity(mesh, FreeSide::behind);
    const auto tree = std::make_shared<fcl::BVHModel<fcl::OBBRSS<double>>>();
    std::vector<fcl::Triangle> triangles;
    for (const Triangle& t : mesh.triangles) {
        triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                               static_cast<std::size_t>(t[2]));
    }
    tree->beginModel();
    tree->addSubModel(mesh.vertices, triangles);
    tree->endModel();
    fcl::CollisionObject<double> wall(tree);
    Random random(5);
    for (int trial = 0; trial < 200; ++trial) {
        const Vector3 point(random.uniform(-0.08, 0.08), random.uniform(-0.08, 0.08),
                            random.uniform(-0.08, 0.08));
        const CavityPoint found = cavity.closest(point, 1.0);
        double brute = std::numeric_limits<double>::infinity();
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            brute = std::min(brute, brute_distance(mesh, point, t));
        ASSERT_GE(found.triangle, 0);
        EXPECT_NEAR(std::abs(found.distance), brute, 1e-12);
        EXPECT_NEAR(found.normal.norm(), 1.0, 1e-12);
        EXPECT_NEAR((found.position + found.distance * found.normal - point).norm(), 0.0, 1e-12);
        // Free inside the bowl: the sign is that of the side.
        const double radial = point.cwiseQuotient(half_axes).norm();
        if (radial < 0.85) {
            EXPECT_GT(found.distance, 0);
        }
        if (radial > 1.15) {
            EXPECT_LT(found.distance, 0);
        }
        if (trial < 40) {
            fcl::Transform3<double> pose = fcl::Transform3<double>::Identity();
            pose.translation() = point;
            fcl::CollisionObject<double> probe(std::make_shared<fcl::Sphere<double>>(1e-9), pose);
            fcl::DistanceRequest<double> request;
            fcl::DistanceResult<double> result;
            fcl::distance(&wall, &probe, request, result);
            EXPECT_NEAR(result.min_distance, brute, 1e-6);
        }
    }
    EXPECT_EQ(cavity.closest(Vector3::Zero(), 0.01).triangle, -1);
    EXPECT_EQ(cavity.closest(Vector3::Constant(std::numeric_limits<double>::quiet_NaN()), 1.0).triangle, -1);
}

TEST(Cavity, SliversAreLeftOutAndBadMeshesRefused) {
    TriangleMesh mesh = test::make_floor(0.1, 2);
    mesh.triangles.push_back({0, 0, 1});
    mesh.triangles.push_back({0, 1, 2});  // collinear
    const CavityModel cavity(mesh, FreeSide::front);
    std::vector<ListedCluster> found(32);
    const int count = cavity.list(Vector3(0, 0, 0.01), 1.0, found.data(), 32);
    int triangles = 0;
    for (int c = 0; c < count; ++c)
        triangles += cavity.cluster(found[static_cast<std::size_t>(c)].cluster).count;
    EXPECT_EQ(triangles, 8);
    EXPECT_THROW(CavityModel(TriangleMesh{}, FreeSide::front), InputError);
    mesh.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(CavityModel(mesh, FreeSide::front), InputError);
}

TEST(Cavity, TheFreeSideDecidesTheSign) {
    const TriangleMesh mesh = test::make_floor(0.2, 8);
    const Vector3 above(0.013, 0.021, 0.004);
    EXPECT_NEAR(CavityModel(mesh, FreeSide::front).closest(above, 1.0).distance, 0.004, 1e-15);
    EXPECT_NEAR(CavityModel(mesh, FreeSide::behind).closest(above, 1.0).distance, -0.004, 1e-15);
    EXPECT_NEAR(CavityModel(mesh, FreeSide::front).closest(above, 1.0).normal.z(), 1.0, 1e-15);
    EXPECT_NEAR(CavityModel(mesh, FreeSide::behind).closest(above, 1.0).normal.z(), -1.0, 1e-15);
}

}  // namespace
}  // namespace fulcrum
