// SPDX-License-Identifier: Apache-2.0
// The wrench on the tissue about the trocar: force and torque compared with lever arms and with virtual work.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/contact/rigid_contact.h"
#include "sim_core/instrument/lever.h"
#include "sim_core/numerics/random.h"
#include "tests/sim_core/contact/contact_rig.h"
#include "tests/support/cavity.h"

namespace fulcrum {
namespace {

TEST(Wrench, EqualsForceTimesLeverArm) {
    test::ContactRig rig;
    Random random(21);
    int touched = 0;
    for (int trial = 0; trial < 100; ++trial) {
        rig.state = ToolContactState{};
        rig.result = ToolContactResult{};
        const Vector3 tip(0.2 + random.uniform(-0.05, 0.05), random.uniform(-0.008, 0.008),
                          random.uniform(0.011, 0.018));
        const ToolKinematics tool =
            rig.tool_at(tip, Vector3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0));
        rig.publish(tool);
        const ToolContactResult& result = rig.touch(tool);
        if (!result.touching_surface) continue;
        ++touched;
        const Vector3 arm = result.point - tool.trocar;
        EXPECT_LT((result.torque - arm.cross(result.force)).norm(), 1e-12);
        const SplitLoad& load = result.tissue_load;
        EXPECT_LT((load.spring.force + load.damper.force - result.force).norm(), 1e-12);
        EXPECT_LT((load.spring.moment + load.damper.moment - result.torque).norm(), 1e-12);
        EXPECT_GT(
            result.torque.norm() + arm.normalized().dot(result.force.normalized()) * result.force.norm(), 0);
    }
    EXPECT_GT(touched, 30);

    // Held tissue: the hold point is the lever's end.
    rig.local->mode = LocalMode::grasp;
    rig.local->grasp.hold_offset = Vector3(0, 0, -0.01);
    const ToolKinematics tool = rig.tool_at(Vector3(0.21, 0.004, 0.02));
    rig.local->grasp.point = tool.tip + tool.rotation * rig.local->grasp.hold_offset;
    rig.local->grasp.reaction = Vector3(1, -2, 0.5);
    rig.local->grasp.friction = 100;
    ToolKinematics gripping = tool;
    gripping.grip = 16;
    rig.touch(gripping);
    EXPECT_LT((rig.result.torque - (rig.local->grasp.point - tool.trocar).cross(Vector3(1, -2, 0.5))).norm(),
              1e-12);
}

// A rigid sphere into which the tip is pressed stores E = K d^2 / 2: the change under a small rotation about
// the trocar and a small translation equals the work of torque and force.
TEST(Wrench, DoesTheWorkStoredInTheContact) {
    test::ContactRig rig;
    rig.local->mode = LocalMode::none;
    rig.local->target_count = 1;
    TargetModel& target = rig.local->targets[0];
    target.centre = Vector3(0.22, 0.01, 0.05);
    target.radius = 0.006;
    target.stiffness = 600;
    target.damping = 0;
    Random random(22);
    for (int trial = 0; trial < 50; ++trial) {
        const Vector3 direction =
            Vector3(random.normal(), random.normal(), std::abs(random.normal()) + 0.2).normalized();
        const Vector3 tip = target.centre + (0.006 + 0.0025 - 0.002) * direction;
        const auto at = [&](const Vector3& place) {
            ToolKinematics tool = rig.tool_at(Vector3(0.2, 0, 0.03));
            // Exact poses: the device's resolution would drown the differences.
            tool.tip = place;
            tool.axis = (place - tool.trocar).normalized();
            rig.state = ToolContactState{};
            return tool;
        };
        const ToolKinematics tool = at(tip);
        rig.touch(tool);
        ASSERT_TRUE(rig.result.touching_target);
        const Vector3 force = rig.result.force, torque = rig.result.torque;
        const auto energy = [&](const Vector3& place) {
            const double depth = 0.0085 - (place - target.centre).norm();
            return 0.5 * 600 * depth * depth;
        };
        constexpr double step = 1e-6;
        for (int k = 0; k < 3; ++k) {
            const Vector3 turn = step * Vector3::Unit(k);
            const Vector3 arm = tip - tool.trocar;
            const double change = energy(tip + turn.cross(arm)) - energy(tip - turn.cross(arm));
            EXPECT_NEAR(change / (2 * step), torque.dot(Vector3::Unit(k)), 1e-5);
        }
        const double slide = energy(tip + step * tool.axis) - energy(tip - step * tool.axis);
        EXPECT_NEAR(slide / (2 * step), force.dot(tool.axis), 1e-5);
    }
}

// ---- the shaft on the wall ----

constexpr double facet = 0.5;  // rad, of a ridge's facets about its axis

/// A ridge along y: five flat facets between edges 3 cm from its axis, one of them on top.
TriangleMesh make_ridge() {
    TriangleMesh mesh;
    constexpr int facets = 5, rows = 4;
    for (int i = 0; i <= facets; ++i) {
        const double angle = (i - 0.5 * facets) * facet;
        for (int j = 0; j < rows; ++j)
            mesh.vertices.emplace_back(0.03 * std::sin(angle), 0.02 * j - 0.03, 0.03 * std::cos(angle));
    }
    for (int i = 0; i < facets; ++i) {
        for (int j = 0; j + 1 < rows; ++j) {
            const int a = rows * i + j, b = a + rows;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    }
    return mesh;
}

/// A shaft along +x is on the ridge's top, 1 mm deep, at 5/6 of its length from the trocar; its tip is 2 cm
/// beyond the top in the air.
struct OnRidge : test::ContactRig {
    CavityModel ridge{make_ridge(), FreeSide::front};
    double top = 0.03 * std::cos(0.5 * facet);
    Vector3 trocar = Vector3(-0.10, 0.002, top + 0.0015);
    static constexpr double length = 0.34;  // m, handle to tip

    OnRidge() {
        local->mode = LocalMode::none;
        model.cavity = &ridge;
        model.wall.most_stiffness = 700;
        model.wall.damping = model.wall.friction = 0;
    }
    /// The instrument of a handle (m, from the trocar), to the last bit: a device's counts would drown
    /// differences.
    ToolKinematics held_at(const Vector3& handle) const {
        ToolKinematics tool;
        tool.inside = tool.present = true;
        tool.trocar = trocar;
        tool.axis = -handle.normalized();
        tool.insertion = length - handle.norm();
        tool.tip = trocar + tool.insertion * tool.axis;
        return tool;
    }
    const ToolContactResult& first_touch(const ToolKinematics& tool) {
        state = ToolContactState{};
        seed_wall(&ridge, tool, 0.02, *local);
        return touch(tool);
    }
};

TEST(Wrench, OfAShaftOnTheWallHasTheArmTheVelocityAndTheLiftOfThePlaceThere) {
    OnRidge rig;
    ToolKinematics tool = rig.held_at(Vector3(-0.22, 0, 0));
    const ToolContactResult& still = rig.first_touch(tool);
    ASSERT_TRUE(still.touching_wall);
    EXPECT_NEAR(still.wall_force.z(), -0.7, 0.007);
    EXPECT_NEAR(still.torque.y(), 0.10 * 0.7, 0.03 * 0.07) << "of the tip it would be 0.084 N m";
    ASSERT_EQ(still.touches.count, 1);
    EXPECT_NEAR(still.touches.touch[0].shaft, 5.0 / 6, 0.01);

    // The drawn shaft ends on the wall.
    ToolPose pose;
    pose.inside = true;
    pose.trocar = tool.trocar;
    pose.tip = tool.tip;
    pose.axis = tool.axis;
    pose.insertion = tool.insertion;
    const ToolPose drawn = lifted(pose, lift_out(still.touches));
    const Vector3 above = drawn.trocar + 0.10 * drawn.axis / drawn.axis.x();
    EXPECT_NEAR(above.z() - rig.top, rig.model.instrument.tip_radius, 5e-5);

    // The damper acts on the velocity there: the shaft turns about the trocar.
    rig.model.wall.damping = 2;
    tool.tip_velocity = Vector3(0.05, 0, -0.1);
    const double undamped = still.wall_force.norm();
    EXPECT_NEAR(rig.first_touch(tool).wall_force.norm() - undamped, 2 * 0.1 * 5 / 6, 0.006);
}

// The contact stores E = K d^2 / 2: its change with the handle is the work of the force at the hand.
TEST(Wrench, OfAShaftOnTheWallDoesTheWorkStoredThereAtTheHand) {
    OnRidge rig;
    for (const Vector3& handle : {Vector3(-0.22, 0, 0), Vector3(-0.22, 0.01, 0), Vector3(-0.225, 0, 0.001)}) {
        const ToolContactResult& result = rig.first_touch(rig.held_at(handle));
        ASSERT_TRUE(result.touching_wall);
        const Vector3 felt = load_at_hand(handle, result.tissue_load.spring).force;
        const auto energy = [&](const Vector3& at) {
            return 0.5 * rig.first_touch(rig.held_at(at)).wall_force.squaredNorm() / 700;
        };
        constexpr double step = 1e-5;
        for (int k = 0; k < 3; ++k) {
            const Vector3 by = step * Vector3::Unit(k);
            const double slope = (energy(handle + by) - energy(handle - by)) / (2 * step);
            EXPECT_NEAR(felt[k], slope, 0.03 * felt.norm()) << k << ": of the tip it would be a fifth more";
        }
    }
}

// Where the walk fails, at triangles without area, the closest point of the tip takes its place: the load is
// the tip's, not that of the place at which the walk failed.
TEST(Wrench, OfTheClosestPointWhereTheWalkIsLostIsThatOfTheTip) {
    TriangleMesh mesh;
    constexpr int columns = 6, rows = 4;
    for (const double x : {-0.06, -0.03, 0.0, 0.0, 0.03, 0.06}) {
        for (int j = 0; j < rows; ++j) mesh.vertices.emplace_back(x, 0.02 * j - 0.03, 0);
    }
    for (int i = 0; i + 1 < columns; ++i) {
        for (int j = 0; j + 1 < rows; ++j) {
            const int a = rows * i + j, b = a + rows;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    }
    const CavityModel plate(mesh, FreeSide::front);
    test::ContactRig rig;
    rig.local->mode = LocalMode::none;
    rig.model.cavity = &plate;
    rig.model.wall.most_stiffness = 700;
    rig.model.wall.damping = rig.model.wall.friction = 0;
    ToolKinematics tool;
    tool.inside = tool.present = true;
    tool.tip = Vector3(0.005, 0.002, 0.0015);
    tool.axis = Vector3(1, 0, 0.1).normalized();  // deeper behind the tip
    tool.insertion = 0.12;
    tool.trocar = tool.tip - tool.insertion * tool.axis;
    rig.state.touching_wall = true;
    rig.state.wall_triangle = plate.closest(tool.tip, 0.02).triangle;
    const ToolContactResult& result = rig.touch(tool);
    ASSERT_TRUE(result.touching_wall);
    EXPECT_NEAR(result.wall_force.z(), -0.7, 1e-6);
    ASSERT_EQ(result.touches.count, 1);
    EXPECT_EQ(result.touches.touch[0].shaft, 1);
    const Vector3 arm = Vector3(0.005, 0.002, 0) - tool.trocar;
    EXPECT_LT((result.torque - arm.cross(result.wall_force)).norm(), 1e-9);
}

// On a fine mesh the walk crosses more triangles than one tick allows: it continues from where it was.
TEST(Wrench, OfAShaftOnAFineWallStaysFromTickToTick) {
    test::ContactRig rig;
    const CavityModel ball(test::make_bowl(Vector3(0.02, 0.02, 0.02), 60, 80, 0.0), FreeSide::front);
    rig.local->mode = LocalMode::none;
    rig.model.cavity = &ball;
    rig.model.wall.most_stiffness = 700;
    rig.model.wall.damping = rig.model.wall.friction = 0;
    ToolKinematics tool;
    tool.inside = tool.present = true;
    tool.axis = Vector3::UnitY();
    tool.trocar = Vector3(0.0215, -0.10, 0.0003);
    tool.insertion = 0.12;
    tool.tip = Vector3(0.0215, 0.02, 0.0003);  // 2 cm beyond the place where the shaft is 1 mm deep
    seed_wall(&ball, tool, 0.02, *rig.local);
    for (int tick = 0; tick < 20; ++tick) rig.touch(tool);
    for (int tick = 0; tick < 100; ++tick) {
        const ToolContactResult& result = rig.touch(tool);
        ASSERT_TRUE(result.touching_wall) << "tick " << tick;
        ASSERT_NEAR(result.wall_force.x(), -0.7, 0.02) << "tick " << tick;
        ASSERT_NEAR(result.touches.touch[0].shaft, 5.0 / 6, 0.01) << "tick " << tick;
    }
}

// A shaft between lips: its place there moves less than the tip when it turns, and has the shorter lever.
TEST(Wrench, OfAShaftInASheetDoesTheWorkStoredThereAtTheHand) {
    OnRidge rig;
    rig.model.cavity = nullptr;
    const Vector3 handle(-0.22, 0.004, 0.003);
    const ToolKinematics before = rig.held_at(handle);
    SheetContactModel& lips = rig.local->sheet;
    lips.tissue = 0;
    lips.normal = before.axis;
    lips.back = 0.03;
    lips.place = before.tip - lips.back * before.axis;
    lips.drag = Vector3(0, 0.3, -0.4);
    lips.drag -= lips.drag.dot(lips.normal) * lips.normal;
    lips.drag_stiffness = 300;
    lips.grip = 1e6;
    const ToolContactResult& result = rig.touch(before);
    EXPECT_LT((result.sheet_force - lips.drag).norm(), 1e-9);
    EXPECT_LT((result.torque - (lips.place - before.trocar).cross(lips.drag)).norm(), 1e-9);
    const Vector3 felt = load_at_hand(handle, result.tissue_load.spring).force;
    const auto energy = [&](const Vector3& at) {
        return 0.5 * rig.touch(rig.held_at(at)).sheet_force.squaredNorm() / 300;
    };
    constexpr double step = 1e-6;
    for (int k = 0; k < 3; ++k) {
        const Vector3 by = step * Vector3::Unit(k);
        EXPECT_NEAR(felt[k], (energy(handle + by) - energy(handle - by)) / (2 * step), 1e-6) << k;
    }
}

}  // namespace
}  // namespace fulcrum
