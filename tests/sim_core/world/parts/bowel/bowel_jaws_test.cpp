// SPDX-License-Identifier: Apache-2.0
// Jaws as boxes against the bowel (fidelity level "jaws"): the force of a jaw resting on the bowel compared
// with its closed form, and a world at that level.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "sim_core/world/parts/bowel/bowel_part.h"
#include "tests/support/allocation_count.h"
#include "tests/support/cavity.h"
#include "tests/support/support.h"
#include "tests/support/tube.h"

namespace fulcrum {
namespace {

constexpr double radius = 0.016;

Scene scene_at(ToolContactLevel level) {
    Scene scene = load_scene(test::source_path("assets/scenes/b1_bowel.json"));
    scene.fidelity.tool_contact = level;
    scene.tethers.reset();
    scene.cavity.reset();
    scene.bowel->length = 0.32;
    return scene;
}

/// A straight bowel along x on a floor, and open jaws next to the shaft.
struct Bench {
    Scene scene;
    CavityModel floor{test::make_floor(1.2, 24), FreeSide::front};
    std::unique_ptr<BowelPart> bowel;
    ToolAction actions[hand_count];

    explicit Bench(ToolContactLevel level) : scene(scene_at(level)) {
        BowelAnatomy anatomy;
        for (int i = 0; i <= 64; ++i)
            anatomy.centre_line.emplace_back(scene.bowel->length * i / 64, 0, radius);
        anatomy.root_line = anatomy.centre_line;
        anatomy.length = scene.bowel->length;
        anatomy.radius = [](double) { return radius; };
        anatomy.surface = test::make_tube(anatomy.length, 60, 16, test::plain_radius(radius));
        bowel = std::make_unique<BowelPart>(scene, std::move(anatomy), &floor);
    }
    std::uint32_t step() { return bowel->step(actions, scene.step_period()); }
};

// A shaft across the bowel, level with the tube's back, whose jaws open downwards into it.
ToolAction open_jaws(const InstrumentSpec& spec, double height) {
    ToolAction action;
    action.instrument = &spec;
    action.tool.trocar = Vector3(0.16, -0.2, height);
    action.tool.tip = Vector3(0.16, 0.5 * spec.jaw_length, height);
    action.tool.axis = Vector3::UnitY();
    action.tool.rotation.col(0) = Vector3::UnitX();
    action.tool.rotation.col(1) = -Vector3::UnitZ();
    action.tool.rotation.col(2) = Vector3::UnitY();
    action.tool.jaw_angle = spec.jaw_opening;
    action.tool.insertion = 0.2;
    action.tool.inside = action.tool.present = true;
    return action;
}

TEST(BowelJaws, BoxInASphereHasTheDepthOfItsFace) {
    ToolShape tool;
    tool.trocar = Vector3(0, -1, 1);
    tool.tip = Vector3(0, 0, 1);
    tool.radius = 0.0025;
    tool.jaws = 2;
    for (OrientedBox& jaw : tool.jaw) {
        jaw.axes = Matrix3::Identity();
        jaw.half = Vector3(0.010, 0.010, 0.001);
    }
    tool.jaw[1].centre = Vector3(0, 0, 5);
    for (const double depth : {-0.004, 0.001, 0.003, 0.012}) {
        tool.jaw[0].centre = Vector3(0.001, 0.002, radius + 0.001 - depth);
        const SolidContact contact = jaws_in_sphere(tool, Vector3::Zero(), radius);
        EXPECT_TRUE(contact.by_jaw);
        EXPECT_NEAR(contact.depth, depth, 1e-15);
        EXPECT_LT((contact.normal - Vector3::UnitZ()).norm(), 1e-12);
    }
    // The depth of the shaft itself is found by the dynamic point.
    tool.jaw[0].centre = Vector3(0, 0, radius + 0.001 - 0.003);
    tool.trocar.z() = tool.tip.z() = radius + tool.radius - 0.001;
    EXPECT_NEAR(jaws_in_sphere(tool, Vector3::Zero(), radius).depth, 0.002, 1e-15);
}

TEST(BowelJaws, PressTheBowelWithTheStiffnessOfTheWallAndFloorReacts) {
    Bench bench(ToolContactLevel::jaws);
    const auto support = [&] {
        const RodReport& report = bench.bowel->report();
        return report.contact_sum + report.end_force[0].z() + report.end_force[1].z();
    };
    for (int i = 0; i < 40; ++i) bench.step();
    const double weight = support();
    EXPECT_NEAR(weight, bench.bowel->weight(), 1e-3 * weight);
    const InstrumentSpec& spec = *bench.scene.instrument(Hand::left);
    bench.actions[static_cast<int>(Hand::left)] = open_jaws(spec, 2 * radius + 0.006);
    for (int i = 0; i < 400; ++i) EXPECT_LT(bench.step(), 2U);
    const Vector3 force = bench.bowel->jaw_force(Hand::left);
    // Spring over depth, summed over the spheres, at rest.
    const ToolShape shape =
        tool_shape(make_instrument(spec, bench.scene.step_period()), bench.actions[0].tool);
    const double stiffness =
        bench.scene.tissues[static_cast<std::size_t>(bench.scene.tissue_index(bench.scene.bowel->tissue))]
            .stiffness;
    Vector3 expected = Vector3::Zero();
    const SphereChain& spheres = bench.bowel->spheres();
    for (std::size_t i = 0; i < spheres.radii.size(); ++i) {
        const Vector3 centre =
            bench.bowel->rod().frame_at(bench.bowel->state(), spheres.arc_lengths[i]).frame.position;
        const SolidContact contact = jaws_in_sphere(shape, centre, spheres.radii[i]);
        if (contact.by_jaw && contact.depth > 0) expected -= stiffness * contact.depth * contact.normal;
    }
    EXPECT_LT(force.z(), -0.05);
    EXPECT_LT((force - expected).norm(), 0.01 * expected.norm());
    EXPECT_NEAR(support(), weight - force.z(), 0.01 * weight);
}

TEST(BowelJaws, AreAbsentAtOtherLevels) {
    Bench bench(ToolContactLevel::dynamic_point);
    bench.actions[static_cast<int>(Hand::left)] =
        open_jaws(*bench.scene.instrument(Hand::left), 2 * radius + 0.006);
    for (int i = 0; i < 40; ++i) bench.step();
    EXPECT_TRUE(bench.bowel->jaw_force(Hand::left).isZero());
}

TEST(BowelJaws, OfAnExchangedInstrumentTakeNothingBeforeTheyWereOpen) {
    Bench bench(ToolContactLevel::dynamic_point);
    const InstrumentSpec grasper = *bench.scene.instrument(Hand::left);
    InstrumentSpec hook = grasper;
    hook.kind = InstrumentKind::hook;
    ToolAction& action = bench.actions[static_cast<int>(Hand::left)];
    action = open_jaws(grasper, 2 * radius);
    const auto holds_with = [&](const InstrumentSpec& spec, bool closed) {
        action.instrument = &spec;
        action.tool.jaw_angle = closed ? 0.02 : spec.jaw_opening;
        action.tool.grip = closed ? 4 : 0;
        bench.step();
        return bench.bowel->holds(static_cast<int>(Hand::left));
    };
    EXPECT_FALSE(holds_with(hook, true));
    EXPECT_FALSE(holds_with(grasper, true)) << "closed since before the exchange";
    EXPECT_FALSE(holds_with(grasper, false));
    EXPECT_TRUE(holds_with(grasper, true));
}

TEST(BowelJaws, AllocateNothing) {
    Bench bench(ToolContactLevel::jaws);
    bench.actions[static_cast<int>(Hand::left)] =
        open_jaws(*bench.scene.instrument(Hand::left), 2 * radius + 0.006);
    for (int i = 0; i < 20; ++i) bench.step();
    const std::uint64_t before = test::allocation_count();
    for (int i = 0; i < 40; ++i) bench.step();
    EXPECT_EQ(test::allocation_count() - before, 0U);
    EXPECT_LT(bench.bowel->jaw_force(Hand::left).z(), 0);
}

TEST(BowelJaws, PressAsBeforeWhileTheirDeviceDoesNotAnswer) {
    Bench bench(ToolContactLevel::jaws);
    ToolAction& action = bench.actions[static_cast<int>(Hand::left)];
    action = open_jaws(*bench.scene.instrument(Hand::left), 2 * radius + 0.006);
    for (int i = 0; i < 400; ++i) bench.step();
    const Vector3 before = bench.bowel->jaw_force(Hand::left);
    ASSERT_LT(before.z(), -0.05);
    action.tool.present = false;
    for (int i = 0; i < 3; ++i) {
        bench.step();
        EXPECT_LT((bench.bowel->jaw_force(Hand::left) - before).norm(), 0.05 * before.norm()) << i;
    }
}

}  // namespace
}  // namespace fulcrum
