// SPDX-License-Identifier: Apache-2.0
// The pose in which an instrument is drawn.
#include "sim_core/instrument/proxy_pose.h"

#include <gtest/gtest.h>

#include <limits>

namespace fulcrum {
namespace {

ToolPose pose_at(const Vector3& tip) {
    ToolPose pose;
    pose.trocar = Vector3(0, 0, 0.2);
    pose.tip = tip;
    pose.axis = (tip - pose.trocar).normalized();
    pose.orientation = Quaternion::FromTwoVectors(Vector3::UnitZ(), pose.axis);
    pose.insertion = (tip - pose.trocar).norm();
    pose.inside = true;
    return pose;
}

TEST(ProxyPose, StopsAtTheSurface) {
    TouchList touches;
    touches.add(Vector3::UnitZ(), 0.04);
    EXPECT_NEAR((lift_out(touches) - Vector3(0, 0, 0.04)).norm(), 0, 1e-12);
    const ToolPose drawn = lifted(pose_at(Vector3(0.01, 0, -0.04)), lift_out(touches));
    EXPECT_NEAR((drawn.tip - Vector3(0.01, 0, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((drawn.trocar + drawn.insertion * drawn.axis - drawn.tip).norm(), 0, 1e-12)
        << "the shaft still goes through the trocar";
    EXPECT_NEAR((drawn.orientation * Vector3::UnitZ() - drawn.axis).norm(), 0, 1e-12);
}

TEST(ProxyPose, LeavesACornerAndTurnsAboutTheTrocarForTheShaft) {
    TouchList corner;
    corner.add(Vector3::UnitZ(), 0.005);
    corner.add(Vector3(0.6, 0, 0.8), 0.006);
    const Vector3 lift = lift_out(corner);
    for (const Touch& touch : {corner.touch[0], corner.touch[1]})
        EXPECT_GE(touch.normal.dot(lift), touch.depth - 2e-5);
    TouchList shaft;
    shaft.add(Vector3::UnitX(), 0.002, 0.5);
    EXPECT_NEAR((lift_out(shaft) - Vector3(0.004, 0, 0)).norm(), 0, 1e-12) << "the tip moves twice as far";
}

TEST(ProxyPose, StaysWhereNothingIsTouchedAndForValuesThatAreNotUsable) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    TouchList touches;
    touches.add(Vector3::UnitZ(), -0.01);
    touches.add(Vector3::UnitZ(), nan);
    touches.add(Vector3(nan, 0, 0), 0.01);
    touches.add(Vector3::Zero(), 0.01);
    EXPECT_EQ(touches.count, 0);
    const ToolPose pose = pose_at(Vector3(0, 0, 0.05));
    EXPECT_EQ(lifted(pose, Vector3::Zero()).tip, pose.tip);
    EXPECT_EQ(lifted(pose, Vector3(nan, 0, 0)).tip, pose.tip);
    EXPECT_EQ(lifted(pose, Vector3(0, 0, 0.2)).tip, pose.tip) << "never out through the trocar";
    // Two walls that face each other: as far as there is room, and finite.
    TouchList narrow;
    narrow.add(Vector3::UnitX(), 0.01);
    narrow.add(-Vector3::UnitX(), 0.01);
    EXPECT_LE(lift_out(narrow).norm(), 0.1);
    // More touches than there is room for: the deepest stay.
    TouchList many;
    for (int i = 1; i <= 20; ++i) many.add(Vector3::UnitZ(), 0.001 * i);
    EXPECT_NEAR(lift_out(many).z(), 0.02, 1e-12);
}

}  // namespace
}  // namespace fulcrum
