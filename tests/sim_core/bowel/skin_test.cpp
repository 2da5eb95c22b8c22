// SPDX-License-Identifier: Apache-2.0
// The bowel's surface on its cage (docs/THEORY.md, section 1.3, 1.4). Its accuracy rows are cases of
// sim_core/lab, asserted in tests/sim_core/lab.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_core/bowel/display_skin.h"
#include "tests/support/allocation_count.h"
#include "tests/support/tube.h"

namespace fulcrum {
namespace {

using test::bent_frames;
using test::make_skin;
using test::rest_frames;

constexpr double length = 0.32, mean_radius = 0.016, spacing = 0.016;

const BowelSkin& haustral_skin() {
    static const BowelSkin skin =
        make_skin(length, mean_radius, spacing, 160, 48, test::haustral_radius(mean_radius));
    return skin;
}

TEST(Cage, EnclosesTheSurfaceAndIsAClosedTube) {
    const BowelSkin& skin = haustral_skin();
    const auto frames = rest_frames(skin.cage());
    TriangleMesh cage;
    cage.vertices = cage_vertices(skin.cage(), frames.data());
    cage.triangles = cage_triangles(skin.rings());
    const MeshReport report = check_mesh(cage);
    EXPECT_TRUE(report.watertight()) << report.complaint();
    EXPECT_EQ(report.euler_characteristic, 2);
    EXPECT_GT(report.volume, enclosed_volume(skin.rest().vertices, skin.rest().triangles));
    EXPECT_GE(skin.cage().clearance, 0.0003);
    RecordProperty("clearance_m", std::to_string(skin.cage().clearance));
    std::printf("clearance %.6f cage volume / surface volume %.3f\n", skin.cage().clearance,
                report.volume / enclosed_volume(skin.rest().vertices, skin.rest().triangles));
}

TEST(Skin, FollowsARigidMotionExactly) {
    const BowelSkin& skin = haustral_skin();
    auto frames = rest_frames(skin.cage());
    const Matrix3 turn = (Eigen::AngleAxisd(2.1, Vector3(1, 2, -1).normalized())).toRotationMatrix();
    const Vector3 shift(0.3, -0.2, 0.5);
    for (auto& frame : frames) {
        frame.position = turn * frame.position + shift;
        frame.rotation = turn * frame.rotation;
    }
    double worst = 0.0;
    for (int v = 0; v < skin.vertices(); ++v) {
        const auto n = static_cast<std::size_t>(v);
        worst = std::max(
            worst, (skin_vertex(skin.rows()[n], frames) - (turn * skin.rest().vertices[n] + shift)).norm());
    }
    EXPECT_LE(worst, 1e-14);
}

// The row of 16 numbers is an exact factorisation of the 32 weights over the cage's points.
TEST(Skin, RowEqualsThirtyTwoWeights) {
    const BowelSkin& skin = haustral_skin();
    const Cage& cage = skin.cage();
    const auto at_rest = rest_frames(cage);
    auto rings = cage_vertices(cage, at_rest.data());
    rings.resize(rings.size() - 2);
    RingWindows windows(rings, ring_size, 1);
    const auto frames = bent_frames(cage, 0.030);
    const auto deformed = cage_vertices(cage, frames.data());
    WindowWeights weights;
    double worst = 0.0;
    for (int v = 0; v < skin.vertices(); v += 7) {
        const auto n = static_cast<std::size_t>(v);
        const Vector3& point = skin.rest().vertices[n];
        windows.weights(windows.gap_of(point), point, weights);
        EXPECT_LE(weights.weight.size(), 32u);
        Vector3 position = Vector3::Zero();
        for (std::size_t i = 0; i < weights.weight.size(); ++i) {
            position += weights.weight[i] * deformed[static_cast<std::size_t>(weights.first) * ring_size + i];
        }
        worst = std::max(worst, (position - skin_vertex(skin.rows()[n], frames)).norm());
    }
    EXPECT_LE(worst, 1e-15);
}

TEST(Skin, VelocityIsTheDerivativeOfPosition) {
    const BowelSkin& skin = haustral_skin();
    const auto frames = bent_frames(skin.cage(), 0.060);
    std::vector<RingMotion> motions(frames.size());
    const double dt = 1e-6;
    auto later = frames, earlier = frames;
    for (std::size_t r = 0; r < frames.size(); ++r) {
        motions[r].frame = frames[r];
        motions[r].velocity = Vector3(0.1, 0.01 * static_cast<double>(r), -0.2);
        motions[r].angular_velocity = Vector3(1.0, -0.1 * static_cast<double>(r), 2.0);
        const double rate = motions[r].angular_velocity.norm();
        const Vector3 axis = motions[r].angular_velocity / rate;
        later[r].position += dt * motions[r].velocity;
        later[r].rotation = Eigen::AngleAxisd(dt * rate, axis) * frames[r].rotation;
        earlier[r].position -= dt * motions[r].velocity;
        earlier[r].rotation = Eigen::AngleAxisd(-dt * rate, axis) * frames[r].rotation;
    }
    for (int v = 0; v < skin.vertices(); v += 501) {
        const SkinRow& row = skin.rows()[static_cast<std::size_t>(v)];
        const Vector3 difference = (skin_vertex(row, later) - skin_vertex(row, earlier)) / (2.0 * dt);
        EXPECT_LE((difference - skin_velocity(row, motions.data())).norm(), 1e-8);
    }
}

}  // namespace
}  // namespace fulcrum
