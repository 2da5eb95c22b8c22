// SPDX-License-Identifier: Apache-2.0
// Accuracy of the bowel's surface on its cage (quality.md, Accuracy; theory 1.3, 1.4).
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
using test::twisted_frames;

constexpr double pi = 3.14159265358979323846;
constexpr double length = 0.32, mean_radius = 0.016, spacing = 0.016;

const BowelSkin& haustral_skin() {
    static const BowelSkin skin =
        make_skin(length, mean_radius, spacing, 160, 48, test::haustral_radius(mean_radius));
    return skin;
}

double volume_under(const BowelSkin& skin, const std::vector<RingFrame>& frames) {
    std::vector<Vector3> positions(static_cast<std::size_t>(skin.vertices()));
    skin_all(skin, frames.data(), positions.data());
    return enclosed_volume(positions, skin.rest().triangles);
}

TEST(Cage, LiesOutsideTheSurfaceAndIsAClosedTube) {
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

TEST(Skin, ReturnsTheRestPose) {
    const BowelSkin& skin = haustral_skin();
    const auto frames = rest_frames(skin.cage());
    double worst = 0.0, worst_sum = 0.0;
    for (int v = 0; v < skin.vertices(); ++v) {
        const SkinRow& row = skin.rows()[static_cast<std::size_t>(v)];
        worst = std::max(
            worst, (skin_vertex(row, frames) - skin.rest().vertices[static_cast<std::size_t>(v)]).norm());
        worst_sum = std::max(worst_sum,
                             std::abs(row.weight[0] + row.weight[1] + row.weight[2] + row.weight[3] - 1.0));
    }
    std::printf("rest pose error %.3g m, partition of unity %.3g\n", worst, worst_sum);
    EXPECT_LE(worst, 1e-10);
    EXPECT_LE(worst_sum, 1e-12);
}

TEST(Skin, KeepsItsVolumeInABend) {
    const BowelSkin& skin = haustral_skin();
    const double rest = enclosed_volume(skin.rest().vertices, skin.rest().triangles);
    for (const double turns : {3.0, 4.0, 6.0}) {
        const double radius = turns * mean_radius;
        // A quarter circle in the middle, straight ends.
        std::vector<RingFrame> frames(static_cast<std::size_t>(skin.rings()));
        const double begin = 0.5 * (length - 0.5 * pi * radius), end = begin + 0.5 * pi * radius;
        ring_frames(
            skin.cage(),
            [&](double s) {
                const double along = std::clamp(s, begin, end) - begin, angle = along / radius;
                const Vector3 tangent(std::cos(angle), std::sin(angle), 0.0);
                RingFrame frame;
                frame.position =
                    Vector3(begin + radius * std::sin(angle), radius * (1.0 - std::cos(angle)), 0.0);
                if (s < begin) frame.position = Vector3(s, 0.0, 0.0);
                if (s > end) frame.position += (s - end) * tangent;
                frame.rotation.col(0) = Vector3(-std::sin(angle), std::cos(angle), 0.0);
                frame.rotation.col(1) = Vector3::UnitZ();
                frame.rotation.col(2) = tangent;
                return frame;
            },
            frames.data());
        const double change = volume_under(skin, frames) / rest - 1.0;
        std::printf("bend of %.0f radii: volume change %.4f %%\n", turns, 100.0 * change);
        EXPECT_LE(std::abs(change), 0.02) << turns;
    }
}

TEST(Skin, KeepsItsVolumeInATwist) {
    const BowelSkin& skin = haustral_skin();
    const double rest = enclosed_volume(skin.rest().vertices, skin.rest().triangles);
    const double gap = skin.cage().arc_lengths[1] - skin.cage().arc_lengths[0];
    const double change =
        volume_under(skin, twisted_frames(skin.cage(), 10.0 * pi / 180.0 / gap)) / rest - 1.0;
    std::printf("10 degrees a ring gap: volume change %.4f %%\n", 100.0 * change);
    EXPECT_LE(std::abs(change), 0.01);
}

// A line along the tube, sampled finely across a ring: the surface must neither tear nor crease there.
TEST(Skin, NeitherTearsNorCreasesAcrossRings) {
    const BowelSkin skin = make_skin(length, mean_radius, spacing, 80, 32, test::plain_radius(mean_radius));
    const Cage& cage = skin.cage();
    const auto frames = bent_frames(cage, 0.030);
    SkinBinder binder(cage);
    double worst_jump = 0.0, worst_kink = 0.0, most_curved = 0.0;
    for (int ring = 2; ring + 2 < cage.rings(); ++ring) {
        for (int line = 0; line < 64; ++line) {
            const double angle = 2.0 * pi * (line + 0.3) / 64;
            const double start = cage.arc_lengths[static_cast<std::size_t>(ring)];
            const auto at = [&](int gap, double offset) {
                const Vector3 rest(start + offset, mean_radius * std::cos(angle),
                                   mean_radius * std::sin(angle));
                return skin_vertex(binder.bind(gap, rest), frames);
            };
            // The ring's own plane seen from the gap before it and from the gap after it.
            worst_jump = std::max(worst_jump, (at(ring, 0.0) - at(ring - 1, 0.0)).norm());
            const double step = 1e-5;
            const auto turn = [&](double centre) {
                const auto place = [&](double x) { return at(x < 0.0 ? ring - 1 : ring, x); };
                const Vector3 a = place(centre) - place(centre - step),
                              b = place(centre + step) - place(centre);
                return std::atan2(a.cross(b).norm(), a.dot(b));
            };
            const double smooth = std::max(turn(-2.0 * step), turn(2.0 * step));
            worst_kink = std::max(worst_kink, turn(0.0) / smooth);
            most_curved = std::max(most_curved, turn(0.0) / (step / 0.030));
        }
    }
    std::printf(
        "jump %.3g m, kink %.3f of the smooth turn beside it, curvature at a ring up to %.2f of the line's\n",
        worst_jump, worst_kink, most_curved);
    EXPECT_LE(worst_jump, 1e-9);
    EXPECT_LE(worst_kink, 1.2);
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

TEST(Skin, LocalScopeStaysCloseToGlobal) {
    const BowelSkin& skin = haustral_skin();
    const Cage& cage = skin.cage();
    const auto at_rest = rest_frames(cage);
    auto rings = cage_vertices(cage, at_rest.data());
    rings.resize(rings.size() - 2);
    RingWindows windows(rings, ring_size, 1);
    for (const double bend : {0.100, 0.048, 0.030}) {
        const auto frames = bent_frames(cage, bend);
        const auto deformed = cage_vertices(cage, frames.data());
        WindowWeights weights;
        double worst = 0.0, sum = 0.0;
        int count = 0;
        for (int v = 0; v < skin.vertices(); v += 37, ++count) {
            const auto n = static_cast<std::size_t>(v);
            windows.global_weights(skin.rest().vertices[n], weights);
            Vector3 position = Vector3::Zero();
            for (std::size_t i = 0; i < weights.weight.size(); ++i)
                position += weights.weight[i] * deformed[i];
            const double distance = (position - skin_vertex(skin.rows()[n], frames)).norm();
            worst = std::max(worst, distance);
            sum += distance * distance;
        }
        std::printf("bend of %.0f mm: local against global: worst %.3f mm, root mean square %.3f mm\n",
                    1e3 * bend, 1e3 * worst, 1e3 * std::sqrt(sum / count));
        EXPECT_LE(worst, 0.1 * mean_radius);
        EXPECT_GT(worst, 0.0);
    }
}

TEST(Skin, ForcesDoTheSameWorkOnSurfaceAndRings) {
    const BowelSkin& skin = haustral_skin();
    const auto frames = twisted_frames(skin.cage(), 15.0);
    std::vector<RingMotion> motions(frames.size());
    for (std::size_t r = 0; r < frames.size(); ++r) {
        const double s = static_cast<double>(r);
        motions[r].frame = frames[r];
        motions[r].velocity = Vector3(std::sin(s), std::cos(1.7 * s), std::sin(0.3 * s));
        motions[r].angular_velocity = Vector3(3.0 * std::cos(s), 4.0, -5.0 * std::sin(2.0 * s));
    }
    std::vector<RingWrench> wrenches(frames.size());
    double surface_power = 0.0, size = 0.0;
    for (int v = 1000; v < 1400; v += 3) {
        const SkinRow& row = skin.rows()[static_cast<std::size_t>(v)];
        const Vector3 force(std::sin(0.1 * v), 1.0, std::cos(0.2 * v));
        const double power = force.dot(skin_velocity(row, motions.data()));
        surface_power += power;
        size += std::abs(power);
        add_ring_wrenches(row, frames.data(), force, wrenches.data());
    }
    double ring_power = 0.0;
    for (std::size_t r = 0; r < frames.size(); ++r) {
        ring_power +=
            wrenches[r].force.dot(motions[r].velocity) + wrenches[r].moment.dot(motions[r].angular_velocity);
    }
    EXPECT_NEAR(ring_power, surface_power, 1e-12 * size);
    EXPECT_GT(std::abs(surface_power), 1e-3 * size);
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
