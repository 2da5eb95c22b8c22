// SPDX-License-Identifier: Apache-2.0
// The cavity's queries against brute force over all triangles and against FCL's own distance.
#include "sim_core/collision/cavity.h"

#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

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

// Rough: every vertex moved at random, so that ridges, valleys and saddles of all kinds occur.
TriangleMesh rough_bowl(std::uint64_t seed, double roughness) {
    TriangleMesh mesh = test::make_bowl(half_axes, 24, 32, 0.1);
    Random random(seed);
    for (Vector3& vertex : mesh.vertices) {
        for (int i = 0; i < 3; ++i) vertex[i] += random.uniform(-roughness, roughness);
    }
    return mesh;
}

// Triangles that are skipped are never the nearest; triangles not listed are relevant nowhere within the
// margin.
TEST(Cavity, SkippedTrianglesAreNeverTheNearestWithinTheMargin) {
    std::vector<ListedPacket> found(1000);
    long left_out = 0, kept = 0, asleep = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const CavityModel cavity(rough_bowl(seed, 0.0001 * static_cast<double>(seed)), FreeSide::behind);
        Random random(seed, 1);
        for (int trial = 0; trial < 300; ++trial) {
            const Vector3 listed_at(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05),
                                    random.uniform(-0.05, 0.05));
            const double margin = trial % 3 == 0 ? 0.0 : random.uniform(0.0, 0.004);
            Vector3 motion(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            motion *= random.uniform(0.0, margin) / motion.norm();
            const Vector3 point = listed_at + motion;
            const CavityPoint nearest = cavity.closest(point, 1.0);
            if (nearest.distance < 0) continue;
            const double reach = nearest.distance + random.uniform(0.0, 0.002);
            int boxes = 0;
            const int count = cavity.list(listed_at, reach, margin, found.data(), 1000, boxes);
            ASSERT_LE(count, 1000);
            EXPECT_LE(count, boxes);
            bool concerned_nearest = false;
            for (int c = 0; c < count; ++c) {
                const ListedPacket& entry = found[static_cast<std::size_t>(c)];
                const TrianglePacket& packet = cavity.packet(entry.packet);
                const FloatPoint at(point);
                float concern[packet_size];
                const unsigned lanes = packet.concern(at, static_cast<float>(reach), 0.0F, concern);
                if (static_cast<double>(entry.sleep) > motion.norm()) ++asleep;
                for (int lane = 0; lane < packet_size; ++lane) {
                    if (packet.triangle[lane] < 0) continue;
                    const bool concerned =
                        (lanes >> static_cast<unsigned>(lane) & 1U) != 0 && cavity.confirms(packet, lane, at);
                    (concerned ? kept : left_out) += 1;
                    if (!concerned) continue;
                    const double distance =
                        std::abs(cavity.closest_on(packet.triangle[lane], point).distance);
                    // A sleeping packet may be relevant by a plane only, never by a foot within reach.
                    if (static_cast<double>(entry.sleep) > motion.norm()) {
                        EXPECT_GT(distance, reach);
                        continue;
                    }
                    concerned_nearest = concerned_nearest || distance <= nearest.distance + 1e-12;
                }
            }
            EXPECT_TRUE(concerned_nearest) << seed << " " << trial;
        }
    }
    EXPECT_GT(left_out, 3 * kept);
    EXPECT_GT(asleep, 1000);
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

TEST(Cavity, SliversAreSkippedAndBadMeshesRefused) {
    TriangleMesh mesh = test::make_floor(0.1, 2);
    mesh.triangles.push_back({0, 0, 1});
    mesh.triangles.push_back({0, 1, 2});  // collinear
    const CavityModel cavity(mesh, FreeSide::front);
    std::vector<ListedPacket> found(32);
    int boxes = 0;
    const int count = cavity.list(Vector3(0, 0, 0.01), 1.0, 1.0, found.data(), 32, boxes);
    int triangles = 0;
    for (int c = 0; c < count; ++c) {
        for (const std::int32_t t : cavity.packet(found[static_cast<std::size_t>(c)].packet).triangle)
            triangles += t >= 0 ? 1 : 0;
    }
    EXPECT_EQ(triangles, 8);
    EXPECT_THROW(CavityModel(TriangleMesh{}, FreeSide::front), InputError);
    mesh.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(CavityModel(mesh, FreeSide::front), InputError);
}

TEST(Cavity, FreeSideDeterminesTheSign) {
    const TriangleMesh mesh = test::make_floor(0.2, 8);
    const Vector3 above(0.013, 0.021, 0.004);
    EXPECT_NEAR(CavityModel(mesh, FreeSide::front).closest(above, 1.0).distance, 0.004, 1e-15);
    EXPECT_NEAR(CavityModel(mesh, FreeSide::behind).closest(above, 1.0).distance, -0.004, 1e-15);
    EXPECT_NEAR(CavityModel(mesh, FreeSide::front).closest(above, 1.0).normal.z(), 1.0, 1e-15);
    EXPECT_NEAR(CavityModel(mesh, FreeSide::behind).closest(above, 1.0).normal.z(), -1.0, 1e-15);
}

}  // namespace
}  // namespace fulcrum
