// SPDX-License-Identifier: Apache-2.0
// The wrench on the tissue about the trocar: force and torque compared with lever arms and with virtual work.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/contact/rigid_contact.h"
#include "sim_core/numerics/random.h"
#include "tests/sim_core/contact/contact_rig.h"

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

}  // namespace
}  // namespace fulcrum
