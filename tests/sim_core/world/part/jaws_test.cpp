// SPDX-License-Identifier: Apache-2.0
// The grasp law against what it states: thresholds of opening, force and time, and the motion of held points.
#include "sim_core/world/part/jaws.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double dt = 0.005, widest = 0.8;

ToolKinematics tool_with(double share, double grip) {
    ToolKinematics tool;
    tool.present = tool.inside = true;
    tool.jaw_angle = share * widest;
    tool.grip = grip;
    return tool;
}

JawAction step(Jaws& jaws, const ToolKinematics& tool, const JawLoad& load = {}, double seconds = dt) {
    return jaws.step(tool, widest, load, seconds);
}

/// Closed on one point, `away` from the jaws.
Jaws holding(const ToolKinematics& tool, const Vector3& away = Vector3::Zero()) {
    Jaws jaws;
    EXPECT_EQ(step(jaws, tool), JawAction::close);
    jaws.clear_points();
    jaws.add_point(Vector3::Zero(), tool.tip, tool.tip + away);
    jaws.take();
    return jaws;
}

TEST(Jaws, CloseBelowAThirdOfTheirOpeningWithForceInsideTheBody) {
    EXPECT_TRUE(Jaws().closing(tool_with(0.34, 1), widest));
    EXPECT_FALSE(Jaws().closing(tool_with(0.36, 1), widest)) << "too wide";
    EXPECT_FALSE(Jaws().closing(tool_with(0.34, 0.19), widest)) << "too weak";
    ToolKinematics tool = tool_with(0.34, 1);
    tool.inside = false;
    EXPECT_FALSE(Jaws().closing(tool, widest));
    tool = tool_with(0.34, 1);
    tool.present = false;
    EXPECT_FALSE(Jaws().closing(tool, widest));
}

TEST(Jaws, CloseOnceAndAgainOnlyAfterTheyWereOpen) {
    Jaws jaws;
    EXPECT_EQ(step(jaws, tool_with(0.1, 1)), JawAction::close) << "nothing is in reach, so nothing is taken";
    EXPECT_EQ(step(jaws, tool_with(0.1, 1)), JawAction::none);
    EXPECT_EQ(step(jaws, tool_with(0.44, 1)), JawAction::none);
    EXPECT_EQ(step(jaws, tool_with(0.1, 1)), JawAction::none) << "they were not open";
    EXPECT_EQ(step(jaws, tool_with(0.46, 1)), JawAction::none);
    EXPECT_EQ(step(jaws, tool_with(0.1, 1)), JawAction::close);
}

TEST(Jaws, OfAnExchangedInstrumentMustOpenFirst) {
    Jaws jaws;
    jaws.block();
    EXPECT_EQ(step(jaws, tool_with(0.1, 1)), JawAction::none);
    step(jaws, tool_with(0.5, 1));
    EXPECT_EQ(step(jaws, tool_with(0.1, 1)), JawAction::close);
}

TEST(Jaws, HoldUntilTheyOpenWeakenOrLeaveTheBody) {
    const ToolKinematics closed = tool_with(0.1, 1);
    for (const ToolKinematics& end : {tool_with(0.46, 1), tool_with(0.1, 0.1)}) {
        Jaws jaws = holding(closed);
        EXPECT_EQ(step(jaws, tool_with(0.44, 0.11)), JawAction::hold);
        EXPECT_EQ(step(jaws, end), JawAction::let_go);
        EXPECT_FALSE(jaws.held());
        EXPECT_FALSE(jaws.slipped()) << "released";
    }
    Jaws jaws = holding(closed);
    ToolKinematics outside = closed;
    outside.inside = false;
    EXPECT_EQ(step(jaws, outside), JawAction::let_go);
}

TEST(Jaws, KeepWhatTheyHoldWhileTheirDeviceDoesNotAnswer) {
    Jaws jaws = holding(tool_with(0.1, 1));
    ToolKinematics absent = tool_with(1, 0);
    absent.present = false;
    EXPECT_EQ(step(jaws, absent), JawAction::none);
    EXPECT_TRUE(jaws.held());
}

TEST(Jaws, SlipWhenTheReactionStaysAboveTheFrictionOfBothFaces) {
    const ToolKinematics tool = tool_with(0.1, 3);
    const double capacity = 2 * 0.4 * 3;
    const JawLoad below{0.999 * capacity, 0.4}, above{1.001 * capacity, 0.4};
    Jaws jaws = holding(tool);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(step(jaws, tool, below, 0.008), JawAction::hold);
    // Two steps of overload are 16 ms: within the delay of 20 ms. A step below the capacity starts it again.
    for (const JawLoad& load : {above, above, below, above, above})
        EXPECT_EQ(step(jaws, tool, load, 0.008), JawAction::hold);
    EXPECT_EQ(step(jaws, tool, above, 0.008), JawAction::let_go);
    EXPECT_TRUE(jaws.slipped());
    // The next hold has not slipped.
    step(jaws, tool_with(0.5, 1));
    step(jaws, tool);
    jaws.take();
    EXPECT_FALSE(jaws.slipped());
    EXPECT_EQ(step(jaws, tool, above, 0.008), JawAction::hold) << "the time of the last overload is over";
}

TEST(Jaws, LoseTissueThatIsGone) {
    const ToolKinematics tool = tool_with(0.1, 3);
    Jaws jaws = holding(tool);
    EXPECT_EQ(step(jaws, tool, {0, 0.4, true}), JawAction::let_go);
    EXPECT_TRUE(jaws.slipped());
    Jaws cut = holding(tool);
    cut.lose();
    EXPECT_FALSE(cut.held());
    EXPECT_TRUE(cut.slipped());
}

TEST(Jaws, DrawTheTissueInGeometrically) {
    const ToolKinematics tool = tool_with(0.1, 3);
    const Vector3 away(0.001, -0.002, 0.003);
    Jaws jaws = holding(tool, away);
    for (int n = 1; n <= 20; ++n) {
        const Vector3 before = jaws.point(0).target;
        jaws.carry(tool, dt);
        const Vector3 expected = tool.tip + std::pow(1 - dt / 0.06, n) * away;
        EXPECT_LT((jaws.point(0).target - expected).norm(), 1e-15) << n;
        EXPECT_EQ(jaws.point(0).last, before);
        GraspModel model;
        jaws.fill(model);
        EXPECT_LT((model.point - tool.tip).norm(), 1e-15) << "where the jaws are";
        EXPECT_LT((model.velocity - (expected - before) / dt).norm(), 1e-12);
    }
}

TEST(Jaws, CarryEachPointAsARigidPartOfTheTool) {
    ToolKinematics tool = tool_with(0.1, 3);
    Jaws jaws;
    step(jaws, tool);
    jaws.clear_points();
    for (const double z : {-0.005, -0.002}) jaws.add_point({0, 0, z}, {0, 0, z}, {0, 0, z});
    jaws.take();
    tool.rotation = Eigen::AngleAxisd(0.1, Vector3::UnitX()).toRotationMatrix();
    tool.tip = Vector3(0.001, 0.002, 0.003);
    jaws.carry(tool, dt);
    for (int i = 0; i < 2; ++i)
        EXPECT_LT((jaws.point(i).target - tool.tip - tool.rotation * jaws.point(i).offset).norm(), 1e-15);
    const Vector3 second = jaws.point(1).target;
    jaws.drop_point(0);
    ASSERT_EQ(jaws.count(), 1);
    EXPECT_EQ(jaws.point(0).target, second) << "moved up";
}

TEST(Jaws, FollowADeviceThatJumpsAtTwoMetresASecond) {
    ToolKinematics tool = tool_with(0.1, 3);
    Jaws jaws = holding(tool);
    tool.tip += Vector3(0, 1, 0);
    jaws.carry(tool, dt);
    EXPECT_LT((jaws.point(0).target - Vector3(0, 2 * dt, 0)).norm(), 1e-15);
}

}  // namespace
}  // namespace fulcrum
