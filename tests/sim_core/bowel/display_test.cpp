// SPDX-License-Identifier: Apache-2.0
// The drawn surface: fp32 error, normals, added dents, no allocation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_core/bowel/dent.h"
#include "sim_core/bowel/display_skin.h"
#include "tests/support/allocation_count.h"
#include "tests/support/tube.h"

namespace fulcrum {
namespace {

constexpr double length = 0.32, mean_radius = 0.016, spacing = 0.016;

struct Drawn {
    BowelSkin skin =
        test::make_skin(length, mean_radius, spacing, 160, 48, test::haustral_radius(mean_radius));
    DisplaySkin display{skin};
    std::vector<float> rings = std::vector<float>(12 * static_cast<std::size_t>(skin.rings()));
    std::vector<float> positions = std::vector<float>(3 * static_cast<std::size_t>(skin.vertices()));
    std::vector<float> normals = positions;

    void draw(const std::vector<RingFrame>& frames) {
        display.evaluate(frames.data(), rings.data(), positions.data(), normals.data());
    }
    Vector3 position(std::int32_t v) const { return at(positions, v); }
    Vector3 normal(std::int32_t v) const { return at(normals, v); }
    static Vector3 at(const std::vector<float>& values, std::int32_t v) {
        const auto n = 3 * static_cast<std::size_t>(v);
        return Vector3(values[n], values[n + 1], values[n + 2]);
    }
};

Drawn& drawn() {
    static Drawn instance;
    return instance;
}

TEST(Display, AgreesWithDoublePrecision) {
    Drawn& d = drawn();
    const auto frames = test::bent_frames(d.skin.cage(), 0.060);
    d.draw(frames);
    double worst = 0.0;
    for (int v = 0; v < d.skin.vertices(); ++v) {
        worst = std::max(
            worst, (d.position(v) - skin_vertex(d.skin.rows()[static_cast<std::size_t>(v)], frames)).norm());
    }
    std::printf("fp32 error %.3g m\n", worst);
    EXPECT_LE(worst, 1e-6);
    EXPECT_GT(worst, 0.0);
}

TEST(Display, NormalsAreTheRestNormalsAtRest) {
    Drawn& d = drawn();
    d.draw(test::rest_frames(d.skin.cage()));
    double worst = 0.0;
    for (int v = 0; v < d.skin.vertices(); ++v) {
        worst = std::max(worst, (d.normal(v) - d.skin.rest_normals()[static_cast<std::size_t>(v)]).norm());
    }
    EXPECT_LE(worst, 1e-3);
}

// Compared with the area-weighted normals of the deformed triangles, which do not use the weights.
TEST(Display, NormalsFollowTheDeformedSurface) {
    Drawn& d = drawn();
    const auto frames = test::bent_frames(d.skin.cage(), 0.048);
    d.draw(frames);
    TriangleMesh deformed = d.skin.rest();
    skin_all(d.skin, frames.data(), deformed.vertices.data());
    const auto expected = vertex_normals(deformed);
    double worst = 0.0, sum = 0.0;
    for (int v = 0; v < d.skin.vertices(); ++v) {
        const double angle =
            std::acos(std::clamp(d.normal(v).dot(expected[static_cast<std::size_t>(v)]), -1.0, 1.0));
        EXPECT_NEAR(d.normal(v).norm(), 1.0, 1e-5);
        worst = std::max(worst, angle);
        sum += angle;
    }
    std::printf("normals against area-weighted: worst %.2f degrees, mean %.2f degrees\n", worst * 57.29578,
                sum / d.skin.vertices() * 57.29578);
    EXPECT_LE(sum / d.skin.vertices(), 0.02);
    EXPECT_LE(worst, 0.35);
}

TEST(Display, AddsDents) {
    Drawn& d = drawn();
    const auto frames = test::bent_frames(d.skin.cage(), 0.100);
    d.draw(frames);
    const std::int32_t vertex = 48 * 80 + 7;
    const Vector3 before = d.position(vertex), normal = d.normal(vertex);
    const auto neighbour = d.skin.adjacency().neighbours_of(vertex)[0];
    const Vector3 neighbour_normal = d.normal(neighbour);
    DentVertex dent;
    dent.vertex = vertex;
    dent.displacement = -0.002 * normal;
    d.display.add_dents(&dent, 1, d.positions.data(), d.normals.data());
    EXPECT_LE((d.position(vertex) - before - dent.displacement).norm(), 1e-7);
    EXPECT_GT((d.normal(neighbour) - neighbour_normal).norm(), 0.1) << "the dent must show in the shading";
    EXPECT_NEAR(d.normal(neighbour).norm(), 1.0, 1e-5);
}

TEST(Display, AllocatesNothing) {
    Drawn& d = drawn();
    const auto frames = test::bent_frames(d.skin.cage(), 0.060);
    std::vector<Vector3> positions(static_cast<std::size_t>(d.skin.vertices()));
    std::vector<RingWrench> wrenches(frames.size());
    DentVertex dent;
    dent.vertex = 100;
    EXPECT_EQ(test::allocations_in([&] {
                  d.draw(frames);
                  d.display.add_dents(&dent, 1, d.positions.data(), d.normals.data());
                  skin_all(d.skin, frames.data(), positions.data());
                  add_ring_wrenches(d.skin.rows()[100], frames.data(), Vector3(1, 2, 3), wrenches.data());
              }),
              0u);
    EXPECT_GT(test::allocations_in([] {
                  std::vector<double> one(100);
                  EXPECT_EQ(one.size(), 100u);
              }),
              0u)
        << "the counter itself must count";
}

}  // namespace
}  // namespace fulcrum
