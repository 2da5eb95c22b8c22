// SPDX-License-Identifier: Apache-2.0
// A bowel lying across itself on a floor, stepped like in the world: the upper limb comes down on the lower
// one and rests on it without penetration, and floor and ends together carry the weight of both.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/world/parts/bowel/bowel_part.h"
#include "tests/support/allocation_count.h"
#include "tests/support/cavity.h"
#include "tests/support/support.h"
#include "tests/support/tube.h"

namespace fulcrum {
namespace {

constexpr double radius = 0.016;

// A limb on the floor, a wide turn that rises, and a limb back across the first, `lift` above it.
std::vector<Vector3> folded_line(double lift) {
    std::vector<Vector3> line;
    constexpr double half = 0.2, turn = 0.08;
    constexpr int points = 60;
    for (int i = 0; i <= points; ++i) line.emplace_back(-half + 2 * half * i / points, 0, radius + 1e-4);
    for (int i = 1; i <= points; ++i) {
        const double angle = 3.141592653589793 * i / points, rise = 0.5 - 0.5 * std::cos(angle);
        line.emplace_back(half + turn * std::sin(angle), turn - turn * std::cos(angle),
                          radius + 1e-4 + rise * (2 * radius + lift));
    }
    for (int i = 1; i <= points; ++i) {
        const double u = static_cast<double>(i) / points;
        line.emplace_back(half - 2 * half * u, 2 * turn - 4 * turn * u * u * (3 - 2 * u),
                          radius + 1e-4 + 2 * radius + lift);
    }
    return line;
}

double length_of(const std::vector<Vector3>& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
    return length;
}

TEST(FoldedBowel, RestsOnItselfWithoutPenetrationAndIsSupported) {
    Scene scene = load_scene(test::source_path("assets/scenes/b1_bowel.json"));
    scene.tethers.reset();
    scene.cavity.reset();
    const CavityModel floor(test::make_floor(1.2, 24), FreeSide::front);
    BowelAnatomy anatomy;
    anatomy.centre_line = folded_line(0.004);
    anatomy.root_line = anatomy.centre_line;
    anatomy.length = scene.bowel->length = length_of(anatomy.centre_line);
    anatomy.radius = [](double) { return radius; };
    anatomy.surface = test::make_tube(anatomy.length, 120, 16, test::plain_radius(radius));
    BowelPart bowel(scene, std::move(anatomy), &floor);

    const ToolAction nothing[hand_count];
    const auto step = [&] { return bowel.step(nothing, scene.step_period()); };
    const SphereChain& spheres = bowel.spheres();
    std::vector<Vector3> centres(spheres.arc_lengths.size());
    double deepest = 0;
    int touching = 0;
    const auto look = [&] {
        for (std::size_t i = 0; i < centres.size(); ++i)
            centres[i] = bowel.rod().frame_at(bowel.state(), spheres.arc_lengths[i]).frame.position;
        touching = 0;
        for (std::size_t i = 0; i < centres.size(); ++i) {
            for (std::size_t j = i + 1; j < centres.size(); ++j) {
                if (spheres.arc_lengths[j] - spheres.arc_lengths[i] < 3.141592653589793 * radius) continue;
                const double gap = (centres[i] - centres[j]).norm() - spheres.radii[i] - spheres.radii[j];
                deepest = std::max(deepest, -gap);
                touching += gap < 5e-4 ? 1 : 0;
            }
        }
    };
    for (int i = 0; i < 200; ++i) step();
    const std::uint64_t before = test::allocation_count();
    std::uint32_t worst = 0;
    for (int i = 0; i < 200; ++i) worst = std::max(worst, step());
    EXPECT_EQ(test::allocation_count() - before, 0U);
    look();
    double fastest = 0;
    for (const Vector3& velocity : bowel.state().velocities) fastest = std::max(fastest, velocity.norm());
    const RodReport& report = bowel.report();
    EXPECT_LT(worst, 2U);
    EXPECT_GT(touching, 0);
    EXPECT_LT(deepest, 3e-4);  // 2 % of the radius: the planes are those of the previous step
    EXPECT_LT(fastest, 2e-3);
    EXPECT_GT(report.contact_sum, 0.5 * bowel.weight());
    EXPECT_NEAR(report.contact_sum + report.end_force[0].z() + report.end_force[1].z(), bowel.weight(),
                1e-3 * bowel.weight());
}

}  // namespace
}  // namespace fulcrum
