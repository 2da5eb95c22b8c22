// SPDX-License-Identifier: GPL-3.0-or-later
// Where shadows of instruments matter: close to their jaws and on surfaces behind them, as seen from the
// lamp.
#include "ui/theatre/renderer/tool_shadows.h"

#include <gtest/gtest.h>

namespace fulcrum::ui {
namespace {

constexpr float ball = 0.006F;  // m

/// Jaws of 20 mm straight ahead, 10 cm in front of the lens.
SceneFrame one_tool() {
    SceneFrame frame;
    DrawnTool tool;
    tool.pose.inside = true;
    tool.pose.tip = Vector3(0, 0, -0.10);
    tool.pose.axis = Vector3(1, 0, 0);
    frame.tools = {tool};
    return frame;
}

TEST(ToolShadows, MatterAroundTheJawsAndBehindThem) {
    const ToolShadows shadows = tool_shadows(one_tool(), QMatrix4x4());
    EXPECT_TRUE(shadows.may_vary_in({0, 0, -0.10F}, ball));
    EXPECT_TRUE(shadows.may_vary_in({-0.03F, 0, -0.10F}, ball)) << "along the jaws";
    EXPECT_FALSE(shadows.may_vary_in({0.03F, 0, -0.10F}, ball)) << "beyond the tip, to the side";
    EXPECT_FALSE(shadows.may_vary_in({0, -0.03F, -0.10F}, ball));
    // The lamp that casts the shadows is above the lens: a shadow is lower than the tip.
    const QVector3D ray = (QVector3D(0, 0, -0.10F) - shadows.lamp).normalized();
    EXPECT_LT(ray.y(), 0);
    EXPECT_TRUE(shadows.may_vary_in(QVector3D(0, 0, -0.10F) + 0.03F * ray, ball));
    EXPECT_FALSE(shadows.may_vary_in(QVector3D(0, 0, -0.10F) + 0.12F * ray, ball)) << "too soft to show";
    EXPECT_FALSE(shadows.may_vary_in(QVector3D(0, 0, -0.10F) + 0.03F * ray + QVector3D(0.03F, 0, 0), ball));
    EXPECT_FALSE(shadows.may_vary_in({0, 0, -0.10F}, 0.10F)) << "the surroundings";
}

TEST(ToolShadows, DoNotDependOnTheCamera) {
    QMatrix4x4 to_camera;
    to_camera.rotate(70, 1, 2, 3);
    to_camera.translate(0.1F, -0.2F, 0.3F);
    const ToolShadows shadows = tool_shadows(one_tool(), to_camera);
    EXPECT_TRUE(shadows.may_vary_in({0, 0, -0.10F}, ball));
    EXPECT_FALSE(shadows.may_vary_in(to_camera.map(QVector3D(0, 0, -0.10F)), ball));
    // The values for the shaders are in camera space.
    EXPECT_LT(shadows.to[0].toVector3D().distanceToPoint(to_camera.map(QVector3D(0, 0, -0.10F))), 1e-6F);
    EXPECT_LT(to_camera.map(shadows.lamp).distanceToPoint({0, 0.0035F + 0.016F, 0.001F}), 1e-6F);
}

TEST(ToolShadows, AStrainedTipReachesFarther) {
    SceneFrame frame = one_tool();
    frame.tools[0].shaft_radius = 0.001;
    const QVector3D beside(0.017F, 0, -0.10F);
    EXPECT_FALSE(tool_shadows(frame, QMatrix4x4()).may_vary_in(beside, ball));
    frame.tools[0].strain = 3;
    const ToolShadows strained = tool_shadows(frame, QMatrix4x4());
    EXPECT_EQ(strained.strain.x(), 1);
    EXPECT_TRUE(strained.may_vary_in(beside, ball));
}

TEST(ToolShadows, AreCastOnlyByInstrumentsInsideTheBodyAndNotByGhosts) {
    SceneFrame frame = one_tool();
    frame.tools[0].ghost = true;
    EXPECT_FALSE(tool_shadows(frame, QMatrix4x4()).may_vary_in({0, 0, -0.10F}, ball));
    frame.tools[0].ghost = false;
    frame.tools[0].pose.inside = false;
    EXPECT_FALSE(tool_shadows(frame, QMatrix4x4()).may_vary_in({0, 0, -0.10F}, ball));
    frame.tools[0].pose.inside = true;
    frame.tools.resize(4, frame.tools[0]);
    EXPECT_GT(tool_shadows(frame, QMatrix4x4()).from[1].w(), 0);
}

}  // namespace
}  // namespace fulcrum::ui
