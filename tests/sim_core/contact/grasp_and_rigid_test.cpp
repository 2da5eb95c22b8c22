// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim_core/contact/rigid_contact.h"
#include "sim_core/contact/series_stiffness.h"
#include "sim_core/numerics/random.h"
#include "sim_core/rigid/targets.h"
#include "sim_core/scene/perforation.h"
#include "tests/sim_core/contact/contact_rig.h"
#include "tests/support/cavity.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.141592653589793;

// ---- jaws ----

TEST(Jaws, SlipRatioIsTheForceOverTheFrictionOfBothFaces) {
    // Two faces of 5 N at mu 0.5 hold 5 N.
    EXPECT_NEAR(jaw_capacity(5, 0.5), 5, 1e-12);
    EXPECT_NEAR(slip_ratio({5, 0, 0}, 5, 0.5), 1.0, 1e-12);
    EXPECT_NEAR(slip_ratio({0, 2.5, 0}, 5, 0.5), 0.5, 1e-12);
    EXPECT_EQ(slip_ratio(Vector3::Zero(), 0, 0.5), 0.0);
    EXPECT_GT(slip_ratio({1, 0, 0}, 0, 0.5), 1e6);
    EXPECT_TRUE(std::isfinite(slip_ratio({1e300, 0, 0}, 0, 0.5)));
}

TEST(Jaws, FindTissueBetweenThemOnly) {
    // Jaws of 20 mm by 5 mm, closing along y; 3 mm around them are drawn in.
    ToolKinematics tool;
    tool.tip = Vector3(0.1, 0.2, 0.3);
    const JawBox box(tool, 0.9, 0.020, 0.005);
    const auto holds = [&](double x, double y, double z) {
        return box.contains(tool.tip + Vector3(x, y, z));
    };
    EXPECT_TRUE(holds(0, 0, -0.010));
    EXPECT_TRUE(holds(0.0054, 0, -0.010));
    EXPECT_FALSE(holds(0.0056, 0, -0.010));
    EXPECT_TRUE(holds(0, 0, 0.0029));
    EXPECT_FALSE(holds(0, 0, 0.0031)) << "before the tip";
    EXPECT_FALSE(holds(0, 0, -0.0201)) << "behind the hinge";
    const double half = 0.010 * std::tan(0.45) + 0.003;
    EXPECT_TRUE(holds(0, half - 1e-6, -0.010));
    EXPECT_FALSE(holds(0, half + 1e-6, -0.010));
    EXPECT_FALSE(JawBox(tool, 0, 0.020, 0.005).contains(tool.tip + Vector3(0, half - 1e-6, -0.010)));
    EXPECT_DOUBLE_EQ(box.contact_area(60e-6), 60e-6);
    EXPECT_DOUBLE_EQ(box.contact_area(1), 200e-6) << "both faces";
    EXPECT_DOUBLE_EQ(box.contact_area(0), pinched_area) << "an edge bite";
}

// Jaws that held tissue and opened are deep in it; that is no push. Tissue in a fold has another nearest
// place a moment later, deeper by centimetres.
TEST(Jaws, ThatLetGoDoNotPushWithADepthThatAppearsWithoutAMotion) {
    test::ContactRig rig;
    const ToolKinematics tool = rig.tool_at(Vector3(0.2, 0, 0.012));
    rig.publish(tool);
    rig.state.held = true;
    rig.touch(tool);
    EXPECT_GT(-rig.result.distance, 0.004);
    EXPECT_LT(rig.result.surface_force.norm(), 0.05) << "what was drawn in is let out slowly";
    for (RingMotion& ring : rig.rings) ring.frame.position.z() += 0.010;
    ++rig.tick;
    rig.publish(tool);
    rig.touch(tool);
    EXPECT_GT(-rig.result.distance, 0.013);
    EXPECT_LT(rig.result.surface_force.norm(), 0.1) << "10 mm within a tick is not a push";
    // Without a hold before it the same depth is a contact.
    test::ContactRig pressed;
    for (RingMotion& ring : pressed.rings) ring.frame.position.z() += 0.010;
    pressed.publish(tool);
    EXPECT_GT(pressed.touch(tool).surface_force.norm(), 1.0);
    // In the end all of it is let out.
    for (int i = 0; i < 2000; ++i) {
        ++rig.tick;
        rig.touch(tool);
    }
    EXPECT_EQ(rig.state.left_in, 0);
}

// ---- jaws as boxes ----

TEST(JawPush, IsLinearAboutTheTipAndNeverAttracts) {
    test::ContactRig rig;
    const Vector3 tip(0.2, 0, 0.060);  // far above the bowel: nothing else touches
    rig.publish(rig.tool_at(tip));
    EXPECT_EQ(rig.touch(rig.tool_at(tip)).force.norm(), 0);
    JawPushModel& jaws = rig.local->jaws;
    jaws.place = tip;
    jaws.point = tip + Vector3(0.002, 0, -0.003);
    jaws.force = Vector3(0, 0, -0.5);
    jaws.stiffness = 300 * Vector3::UnitZ() * Vector3::UnitZ().transpose();
    jaws.tissue = 0;
    const auto pressed = [&](double deeper) {
        const ToolKinematics tool = rig.tool_at(tip - Vector3(0, 0, deeper));
        const ToolContactResult& result = rig.touch(tool);
        const Vector3 expected = deeper > -0.5 / 300 ? Vector3(0, 0, -0.5 - 300 * deeper) : Vector3::Zero();
        EXPECT_NEAR((result.jaw_force - expected).norm(), 0, 1e-4)
            << deeper;  // readings are whole micrometres
        EXPECT_EQ(result.force, result.jaw_force) << deeper;
        EXPECT_NEAR((result.torque - (jaws.point - tool.trocar).cross(result.jaw_force)).norm(), 0, 1e-12);
        EXPECT_EQ(result.tissue, expected.norm() > 0 ? 0 : -1);
        EXPECT_EQ(result.surface_force.norm(), 0) << "the world presses the jaws itself";
    };
    for (const double deeper : {0.0, 0.001, -0.001, -0.0017, -0.01}) pressed(deeper);
    jaws.force = Vector3::Zero();
    EXPECT_EQ(rig.touch(rig.tool_at(tip)).force.norm(), 0);
    jaws.force.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(rig.touch(rig.tool_at(tip)).force.norm(), 0);
}

// A place of the shaft behind the tip: K follows its displacement, and the force has its lever.
TEST(JawPush, BehindTheTipFollowsThatPlaceOfTheShaft) {
    test::ContactRig rig;
    const ToolKinematics before = rig.tool_at({0.2, 0, 0.060});
    rig.publish(before);
    JawPushModel& push = rig.local->jaws;
    push.back = 0.030;
    push.place = push.point = before.tip - push.back * before.axis;
    push.force = Vector3(0.5, 0, 0);
    push.stiffness = 300 * Vector3::UnitX() * Vector3::UnitX().transpose();
    push.tissue = 0;
    const ToolKinematics turned = rig.tool_at({0.202, 0, 0.060});
    const ToolContactResult& result = rig.touch(turned);
    const double share = 1 - push.back / before.insertion;
    EXPECT_NEAR(result.jaw_force.x(), 0.5 + 300 * 0.002 * share, 1e-3) << "by the tip it would be 1.1 N";
    EXPECT_LT((result.torque - (push.point - turned.trocar).cross(result.jaw_force)).norm(), 1e-12);
    EXPECT_LT((result.tissue_load.spring.moment - result.torque).norm(), 1e-12);
}

// ---- grasp ----

struct GraspRig : test::ContactRig {
    GraspRig() {
        publish(tool_at({0.2, 0, 0.0165}));
        local->mode = LocalMode::grasp;
        local->grasp.point = Vector3(0.2, 0, 0.0165);
        local->grasp.reaction = Vector3(0, 0, 1.0);
        local->grasp.stiffness = 150 * Matrix3::Identity();
        local->grasp.friction = 0.5;
        local->grasp.area = 4e-5;
        local->grasp.tissue = 0;
        local->grasp.tissue_patch = 7;
        local->grasp.vertex = local->patch.vertex_id[local->patch.vertex_count > 100 ? 100 : 0];
    }
    ToolKinematics gripping(const Vector3& tip, double grip) const {
        ToolKinematics tool = tool_at(tip);
        tool.grip = grip;
        return tool;
    }
};

TEST(Grasp, ForceIsTheReactionPlusStiffnessTerm) {
    GraspRig rig;
    const ToolContactResult& held = rig.touch(rig.gripping({0.2, 0, 0.0165}, 8));
    EXPECT_NEAR((held.grasp_force - Vector3(0, 0, 1)).norm(), 0, 1e-4);
    EXPECT_TRUE(held.grasping);
    EXPECT_FALSE(held.slipping);
    EXPECT_FALSE(held.touching_surface);
    EXPECT_EQ(held.tissue_patch, 7);
    EXPECT_EQ(held.jaw_area, 4e-5);
    const ToolContactResult& pulled = rig.touch(rig.gripping({0.2, 0, 0.0265}, 8));
    EXPECT_NEAR(pulled.grasp_force.z(), 1 + 150 * 0.01, 1e-3);
    EXPECT_EQ(pulled.tissue, 0);
}

TEST(Grasp, SlipsAtTheFrictionCone) {
    GraspRig rig;
    const ToolContactResult& result =
        rig.touch(rig.gripping({0.2, 0, 0.0465}, 2));  // 5.5 N required, 2 N available
    EXPECT_TRUE(result.slipping);
    EXPECT_NEAR(result.slip_ratio, 5.5 / 2.0, 0.01);
    EXPECT_NEAR(result.grasp_force.norm(), 2.0, 0.01);
}

TEST(Grasp, ForceIsFilteredAtTheHeldVertex) {
    GraspRig rig;
    const ToolContactResult& result = rig.touch(rig.gripping({0.2, 0, 0.0165}, 8));
    ASSERT_GT(result.filtered.count, 0);
    EXPECT_EQ(result.filtered.vertex[0], rig.local->grasp.vertex);
    EXPECT_EQ(result.vertex, rig.local->grasp.vertex);
    EXPECT_EQ(result.grade, 2);
}

TEST(Grasp, WorksWithoutAPatch) {
    GraspRig rig;
    rig.local->patch.triangle_count = 0;
    const ToolContactResult& result = rig.touch(rig.gripping({0.2, 0, 0.0265}, 8));
    EXPECT_NEAR(result.grasp_force.z(), 2.5, 1e-3);
    EXPECT_EQ(result.filtered.count, 0);
}

// ---- targets ----

TEST(Targets, ForceIsThatOfTheSpringAndTheNearestTargetIsReported) {
    test::ContactRig rig;
    rig.local->mode = LocalMode::none;
    rig.local->target_count = 2;
    rig.local->targets[0].centre = Vector3(0.2, 0, 0.05);
    rig.local->targets[0].radius = 0.006;
    rig.local->targets[0].id = 4;
    rig.local->targets[0].tissue = 1;
    rig.local->targets[1] = rig.local->targets[0];
    rig.local->targets[1].centre.x() = 0.25;
    rig.local->targets[1].id = 5;
    const ToolContactResult& touching = rig.touch(rig.tool_at({0.2, 0, 0.0575}));
    EXPECT_TRUE(touching.touching_target);
    EXPECT_EQ(touching.target, 4);
    EXPECT_EQ(touching.tissue, 1);
    EXPECT_NEAR(touching.target_force.z(), -600 * 0.001, 1e-3);
    EXPECT_NEAR(touching.target_distance, -0.001, 1e-6);
    const ToolContactResult& apart = rig.touch(rig.tool_at({0.2, 0, 0.07}));
    EXPECT_FALSE(apart.touching_target);
    EXPECT_EQ(apart.target, -1);
    EXPECT_EQ(apart.force, Vector3::Zero());
    rig.local->targets[0].solid = false;
    EXPECT_EQ(rig.touch(rig.tool_at({0.2, 0, 0.0575})).force, Vector3::Zero());
    EXPECT_TRUE(rig.result.touching_target);
}

TEST(Targets, AreSeededSeparatedAndAtAllDepths) {
    TargetFieldSpec field;
    const auto targets = place_targets(field, 42), again = place_targets(field, 42),
               other = place_targets(field, 43);
    ASSERT_EQ(targets.size(), 20U);
    double difference = 0;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        EXPECT_EQ(targets[i].centre, again[i].centre);
        difference += (targets[i].centre - other[i].centre).norm();
        EXPECT_EQ(targets[i].hand, i % 2 == 0 ? Hand::left : Hand::right);
        EXPECT_LE(((targets[i].centre - field.centre).cwiseAbs() - field.half_extent).maxCoeff(), 0);
        for (std::size_t j = 0; j < i; ++j) {
            if (targets[i].hand == targets[j].hand) {
                EXPECT_GE((targets[i].centre - targets[j].centre).norm(), field.minimum_distance);
            }
        }
    }
    EXPECT_GT(difference, 0.1);
    for (int hand = 0; hand < 2; ++hand) {  // one per tenth of the depth
        int layers = 0;
        for (std::size_t i = 0; i < targets.size(); ++i) {
            if (static_cast<int>(targets[i].hand) != hand) continue;
            layers |= 1 << static_cast<int>((targets[i].centre.z() / field.half_extent.z() + 1) * 5);
        }
        EXPECT_EQ(layers, 0x3FF);
    }
    field.half_extent = Vector3::Zero();  // no room: placement must still end
    EXPECT_EQ(place_targets(field, 1).size(), 20U);
}

// ---- wall ----

struct WallRig : test::ContactRig {
    CavityModel cavity;
    WallRig() : cavity(test::make_bowl(Vector3(0.06, 0.055, 0.05), 60, 80, 0.0), FreeSide::behind) {
        model.cavity = &cavity;
        model.wall.tissue = 2;
        model.wall.most_stiffness = 700;
        InstrumentSpec spec;
        spec.trocar.position = Vector3(0, 0.02, 0.09);
        spec.trocar.direction = Vector3(0, 0, -1);
        spec.trocar.up = Vector3(0, 1, 0);
        model.instrument = make_instrument(spec, 1e-3);
    }
};

TEST(Wall, TipPressesOnTheWallAndShaftNearTheTrocarDoesNot) {
    WallRig rig;
    for (int k = 0; k <= 120; ++k) {
        const double z =
            -0.040 - 0.0001 * k;  // the bowl's bottom is at -0.05; above, the shaft pierces the bowl
        rig.tick = static_cast<std::uint32_t>(k);
        const ToolKinematics tool = rig.tool_at({0, 0, z});
        if (k % 5 == 0) seed_wall(&rig.cavity, tool, 0.02, *rig.local);
        const ToolContactResult& result = rig.touch(tool);
        const double depth = 0.0025 - (0.05 + z);
        if (depth > 1e-4) {
            ASSERT_TRUE(result.touching_wall) << k;
            EXPECT_NEAR(result.wall_force.z(), -700 * depth, 0.05 + 0.02 * 700 * depth) << k;
            EXPECT_EQ(result.tissue, 2);
        }
        if (depth < -1e-4) {
            EXPECT_FALSE(result.touching_wall) << k;
        }
    }
}

TEST(Wall, DepthsAgreeWithTheClosestPointOfTheCavity) {
    WallRig rig;
    Random random(30);
    int touched = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const double polar = pi - random.uniform(0, 1.0), around = random.uniform(0, 2 * pi);
        const double scale = random.uniform(0.93, 1.04);
        const Vector3 tip =
            scale * Vector3(0.06 * std::sin(polar) * std::cos(around),
                            0.055 * std::sin(polar) * std::sin(around), 0.05 * std::cos(polar));
        const ToolKinematics tool = rig.tool_at(tip);
        rig.state = ToolContactState{};
        seed_wall(&rig.cavity, tool, 0.02, *rig.local);
        const ToolContactResult& result = rig.touch(tool);
        const double exact = rig.cavity.closest(tool.tip, 0.1).distance - 0.0025;
        if (exact < -1e-4) {
            ++touched;
            ASSERT_TRUE(result.touching_wall) << trial;
            EXPECT_NEAR(result.wall_force.norm(), -700 * exact, 0.12 + 0.1 * 700 * -exact) << trial;
        }
        if (exact > 2e-4) {
            EXPECT_FALSE(result.touching_wall) << trial;
        }
    }
    EXPECT_GT(touched, 50);
}

// ---- tool against tool ----

/// The left tool's shaft is along x at z = 0, the right one's along y at the height set by the test.
struct Crossing {
    ToolContactModel model;
    ToolKinematics left, right;
    Crossing() {
        left.inside = right.inside = true;
        left.trocar = Vector3(-0.1, 0, 0);
        left.tip = Vector3(0.1, 0, 0);
        left.axis = Vector3::UnitX();
        right.axis = Vector3::UnitY();
        raise(0);
    }
    /// z of the right one.
    void raise(double z) {
        right.trocar = Vector3(0, -0.1, z);
        right.tip = Vector3(0, 0.1, z);
    }
};

TEST(Tools, CrossingShaftsPushEachOtherApart) {
    Crossing tools;
    auto& [model, left, right] = tools;
    tools.raise(0.004);
    ToolPairState pair;
    ToolContactResult a, b;
    EXPECT_NEAR(collide_tools(model, left, model, right, pair, a, b), 0.001, 1e-12);
    EXPECT_TRUE(a.touching_tool);
    EXPECT_NEAR((a.tool_force + b.tool_force).norm(), 0, 1e-15);
    EXPECT_NEAR(a.tool_force.z(), 0.8, 1e-9);  // on the right tool, upwards
    tools.raise(0.006);
    a = b = ToolContactResult{};
    EXPECT_LT(collide_tools(model, left, model, right, pair, a, b), 0);
    EXPECT_EQ(a.force, Vector3::Zero());
    right = left;  // one on the other
    EXPECT_TRUE(std::isfinite(collide_tools(model, left, model, right, pair, a, b)));
    EXPECT_TRUE(a.force.allFinite());
    left.tip.x() = std::numeric_limits<double>::quiet_NaN();
    a = b = ToolContactResult{};
    collide_tools(model, left, model, right, pair, a, b);
    EXPECT_TRUE(a.force.allFinite());
}

// A hand without force feedback moves through the other shaft: the shaft stays on the side from which it
// came.
TEST(Tools, ShaftPushedThroughAnotherIsPushedBackUntilItIsThrough) {
    Crossing tools;
    auto& [model, left, right] = tools;
    ToolPairState pair;
    const double step = 2e-5;  // m in a tick
    double last = 0, deepest = 0;
    for (int i = 0; i < 600; ++i) {
        const double z = 0.006 - i * step;
        tools.raise(z);
        right.tip_velocity = Vector3(0, 0, -2 * step / model.instrument.tick_period);
        ToolContactResult a, b;
        const double depth = collide_tools(model, left, model, right, pair, a, b);
        EXPECT_EQ(a.tool_force, -b.tool_force);
        const double push = b.tool_force.z();  // of the right on the left: down while it is above
        if (std::abs(z) < 0.005 - step) {
            EXPECT_NEAR(depth, 0.005 - z, 3 * step) << z;
            EXPECT_LT(push, 0) << z;
        }
        if (push != 0) {
            EXPECT_LE(std::abs(push - last), 3 * step * shaft_stiffness) << z;
        }
        if (z < -0.005) {
            EXPECT_EQ(push, 0) << z;
        }
        deepest = std::max(deepest, depth);
        last = push;
    }
    EXPECT_GT(deepest, 0.009);
}

// The border of an open wall releases a tip gradually.
TEST(Wall, TipSlidingOverAnOpenBorderIsReleasedGradually) {
    TriangleMesh mesh;
    const double edge = 0.004;
    for (int r = 0; r <= 6; ++r) {
        for (int c = 0; c <= 6; ++c) mesh.vertices.emplace_back(edge * c, edge * r, 0);
    }
    for (int r = 0; r < 6; ++r) {
        for (int c = 0; c < 6; ++c) {
            const int a = 7 * r + c;
            mesh.triangles.push_back({a, a + 1, a + 8});
            mesh.triangles.push_back({a, a + 8, a + 7});
        }
    }
    const CavityModel wall(mesh, FreeSide::front);
    ToolContactModel model;
    model.cavity = &wall;
    model.wall.most_stiffness = 500;
    model.instrument.tip_radius = 0.002;
    ToolKinematics tool;
    tool.inside = tool.present = true;
    tool.axis = -Vector3::UnitZ();
    tool.insertion = 0.1;
    LocalModel local;
    ToolContactState state;
    ToolContactScratch scratch;
    ToolContactResult result;
    double last = 0;
    for (int i = 0; i <= 1600; ++i) {
        tool.tip = Vector3(0.012 + 1e-5 * i, 0.011, 0.001);  // 1 mm deep
        tool.trocar = tool.tip + Vector3(0, 0, 0.1);
        seed_wall(&wall, tool, 0.02, local);
        step_tool_contact(model, local, tool, static_cast<std::uint32_t>(i + 1), state, scratch, result);
        const double push = -result.wall_force.z(), x = tool.tip.x();
        if (x < 5 * edge - 1e-6) {
            EXPECT_NEAR(push, 0.5, 1e-9) << x;
        }
        if (i > 0) {
            EXPECT_LE(std::abs(push - last), 0.01) << x;
        }
        if (x > 6 * edge) {
            EXPECT_EQ(push, 0) << x;
        }
        last = push;
    }
}

TEST(SeriesStiffness, IsBoundedByTheWallForAnyTissue) {
    const double wall = 800;
    const Matrix3 tissue = Vector3(200, 0, 1e6).asDiagonal();
    const Matrix3 series = stiffness_in_series(tissue, wall);
    EXPECT_NEAR(series(0, 0), 160, 1e-9);
    EXPECT_NEAR(series(1, 1), 0, 1e-9);
    EXPECT_NEAR(series(2, 2), 800e6 / 1000800, 1e-6);
    Random random(4);
    for (int trial = 0; trial < 300; ++trial) {
        Matrix3 any;
        const double size = std::pow(10.0, random.uniform(-12, 40));
        for (double& value : any.reshaped()) value = size * random.uniform(-1, 1);
        if (trial % 50 == 0) any(1, 2) = std::numeric_limits<double>::quiet_NaN();
        const Matrix3 result = stiffness_in_series(any, wall);
        ASSERT_TRUE(result.allFinite());
        EXPECT_EQ(result, result.transpose());
        const Vector3 direction =
            Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
        EXPECT_GE(direction.dot(result * direction), -1e-9);
        EXPECT_LE(direction.dot(result * direction), wall + 1e-6);
    }
}

}  // namespace
}  // namespace fulcrum
