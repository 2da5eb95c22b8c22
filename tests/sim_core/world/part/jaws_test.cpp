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

/// Spring of 800 N/m, and 2 * 0.4 = 0.8 N for each newton of grip.
constexpr HeldTissue tissue{400, 0.4};
constexpr double jaw_length = 0.02;

JawAction step(Jaws& jaws, const ToolKinematics& tool, bool lost = false) {
    return jaws.step(tool, widest, lost);
}

/// One step with the tissue at a place.
void carry(Jaws& jaws, const ToolKinematics& tool, const Vector3& place) {
    jaws.carry(tool, tissue, &place, jaw_length, dt);
}

/// Closed on one point, `away` from the jaws.
Jaws holding(const ToolKinematics& tool, const Vector3& away = Vector3::Zero()) {
    Jaws jaws;
    EXPECT_EQ(step(jaws, tool), JawAction::close);
    jaws.clear_points();
    jaws.add_point(Vector3::Zero(), tool.tip, tool.tip + away);
    jaws.take(tool, tissue, 50e-6);
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

TEST(Jaws, ClosedOutsideTheBodyTakeNothingWhenTheyComeIn) {
    Jaws jaws;
    ToolKinematics outside = tool_with(0.1, 1);
    outside.inside = false;
    EXPECT_EQ(step(jaws, tool_with(0.5, 1)), JawAction::none);
    EXPECT_EQ(step(jaws, outside), JawAction::none);
    EXPECT_FALSE(jaws.closing(tool_with(0.1, 1), widest));
    EXPECT_EQ(step(jaws, tool_with(0.1, 1)), JawAction::none) << "they closed on nothing out there";
    step(jaws, tool_with(0.5, 1));
    EXPECT_EQ(step(jaws, tool_with(0.1, 1)), JawAction::close);
    // Opened again outside: they come in as open jaws do.
    Jaws reopened;
    step(reopened, outside);
    outside.jaw_angle = widest;
    step(reopened, outside);
    EXPECT_TRUE(reopened.closing(tool_with(0.1, 1), widest));
    EXPECT_EQ(step(reopened, tool_with(0.1, 1)), JawAction::close);
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

TEST(Jaws, HoldThroughThePinchedWall) {
    const ToolKinematics tool = tool_with(0.1, 3);
    Jaws jaws = holding(tool);
    EXPECT_DOUBLE_EQ(jaws.stiffness(), 800);
    EXPECT_DOUBLE_EQ(jaws.most(), 2.4);
    // Three points share both.
    Jaws three;
    step(three, tool);
    three.clear_points();
    for (int i = 0; i < 3; ++i) three.add_point(Vector3::Zero(), tool.tip, tool.tip);
    three.take(tool, tissue, 50e-6);
    EXPECT_DOUBLE_EQ(3 * three.stiffness(), 800);
    EXPECT_DOUBLE_EQ(3 * three.most(), 2.4);
    // A firmer grip holds more.
    carry(jaws, tool_with(0.1, 5), tool.tip);
    EXPECT_DOUBLE_EQ(jaws.most(), 4);
}

TEST(Jaws, TissueSlidesAtTheFrictionOfBothFacesAndIsLostWhenItIsOut) {
    const double stretch = 2.4 / 800;  // m, at which the spring pulls as much as the faces hold
    ToolKinematics tool = tool_with(0.1, 3);
    Jaws jaws = holding(tool);
    // Tissue that does not yield: the jaws are drawn away from it.
    tool.tip.x() = 0.999 * stretch;
    carry(jaws, tool, Vector3::Zero());
    EXPECT_TRUE(jaws.point(0).slid.isZero());
    EXPECT_NEAR(jaws.point(0).target.x(), tool.tip.x(), 1e-15);
    double lost_at = 0;
    for (int i = 1; i <= 200 && lost_at == 0; ++i) {
        tool.tip.x() = stretch + 1e-4 * i;
        if (step(jaws, tool) != JawAction::hold) {
            lost_at = tool.tip.x();
            break;
        }
        carry(jaws, tool, Vector3::Zero());
        EXPECT_NEAR(jaws.point(0).target.x(), stretch, 1e-12) << "never more than the faces hold";
        EXPECT_NEAR(jaws.point(0).slid.x(), -1e-4 * i, 1e-12);
        GraspModel model;
        jaws.fill(model);
        EXPECT_NEAR(model.hold_offset.x(), -1e-4 * i, 1e-12) << "where it is in the jaws now";
        EXPECT_EQ(model.area, 50e-6) << "the same throughout the hold";
    }
    EXPECT_NEAR(lost_at, stretch + 0.5 * jaw_length + Jaws::margin, 3e-4);
    EXPECT_TRUE(jaws.slipped());
    EXPECT_FALSE(jaws.held());
    // The next hold has not slipped.
    step(jaws, tool_with(0.5, 1));
    step(jaws, tool);
    jaws.clear_points();
    jaws.add_point(Vector3::Zero(), tool.tip, tool.tip);
    jaws.take(tool, tissue, 50e-6);
    EXPECT_FALSE(jaws.slipped());
    EXPECT_EQ(step(jaws, tool), JawAction::hold);
    EXPECT_TRUE(jaws.point(0).slid.isZero());
}

TEST(Jaws, TissueThatHasSlidStaysWhereItIsInTheJaws) {
    ToolKinematics tool = tool_with(0.1, 3);
    Jaws jaws = holding(tool);
    tool.tip.x() = 0.008;
    carry(jaws, tool, Vector3::Zero());
    const Vector3 slid = jaws.point(0).slid;
    EXPECT_NEAR(slid.x(), -0.005, 1e-12);
    tool.tip.x() = 0;  // back: no force until the spring is stretched the other way
    carry(jaws, tool, Vector3::Zero());
    EXPECT_NEAR(jaws.point(0).target.x(), -0.003, 1e-12);
    EXPECT_GT(jaws.point(0).slid.x(), slid.x());
}

TEST(Jaws, LoseTissueThatIsGone) {
    const ToolKinematics tool = tool_with(0.1, 3);
    Jaws jaws = holding(tool);
    EXPECT_EQ(step(jaws, tool, true), JawAction::let_go);
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
        carry(jaws, tool, before);  // it comes along
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
    jaws.take(tool, tissue, 50e-6);
    tool.rotation = Eigen::AngleAxisd(0.1, Vector3::UnitX()).toRotationMatrix();
    tool.tip = Vector3(0.001, 0.002, 0.003);
    const Vector3 places[] = {tool.tip, tool.tip};
    jaws.carry(tool, tissue, places, jaw_length, dt);
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
    carry(jaws, tool, Vector3(0, 2 * dt, 0));
    EXPECT_LT((jaws.point(0).target - Vector3(0, 2 * dt, 0)).norm(), 1e-15);
}

TEST(Jaws, StandStillWithWhatTheyHoldWhileTheirDeviceDoesNotAnswer) {
    ToolKinematics tool = tool_with(0.1, 3);
    Jaws jaws = holding(tool);
    tool.tip.x() = 0.001;
    carry(jaws, tool, Vector3::Zero());
    const Vector3 target = jaws.point(0).target;
    ASSERT_NE(jaws.point(0).last, target) << "they moved";
    tool.present = false;
    EXPECT_EQ(step(jaws, tool), JawAction::none);
    EXPECT_EQ(jaws.point(0).target, target);
    EXPECT_EQ(jaws.point(0).last, target) << "not the motion of the step before again";
    GraspModel model;
    jaws.fill(model);
    EXPECT_EQ(model.velocity.norm(), 0);
}

}  // namespace
}  // namespace fulcrum
