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

}  // namespace
}  // namespace fulcrum
