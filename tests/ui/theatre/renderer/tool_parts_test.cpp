// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/tool_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fulcrum::ui {
namespace {

std::vector<ToolPart> parts_of(InstrumentKind end, double opening = 0.4) {
    DrawnTool tool;
    tool.kind = end;
    tool.pose.inside = true;
    tool.pose.trocar = Vector3(0.1, 0, 0);
    tool.pose.tip = Vector3::Zero();
    tool.pose.axis = -Vector3::UnitX();
    tool.pose.orientation = Quaternion::FromTwoVectors(Vector3::UnitZ(), tool.pose.axis);
    tool.pose.jaw_angle = opening;
    std::vector<ToolPart> parts;
    add_tool_parts(tool, parts);
    return parts;
}

int moved(InstrumentKind end) {
    const std::vector<ToolPart> narrow = parts_of(end, 0.1), wide = parts_of(end, 0.9);
    int count = 0;
    for (std::size_t k = 0; k < narrow.size(); ++k) count += narrow[k].pose == wide[k].pose ? 0 : 1;
    return count;
}

TEST(ToolParts, JawsOpenOnBothSidesShearsOnOne) {
    EXPECT_EQ(moved(InstrumentKind::grasper), 2);
    EXPECT_EQ(moved(InstrumentKind::scissors), 2);
    EXPECT_EQ(moved(InstrumentKind::clip_applier), 2);
    EXPECT_EQ(moved(InstrumentKind::harmonic), 2);  // an arm and its pad; the bar does not move
    for (const InstrumentKind end : {InstrumentKind::hook, InstrumentKind::suction, InstrumentKind::probe})
        EXPECT_EQ(moved(end), 0);
}

TEST(ToolParts, EachReachesItsTipAndHasAnInsulatedShaft) {
    for (const InstrumentType& type : instrument_types) {
        const std::vector<ToolPart> parts = parts_of(type.kind, 0);
        EXPECT_TRUE(
            std::any_of(parts.begin(), parts.end(), [](const ToolPart& part) { return part.insulated; }));
        double least = 1;  // m from any vertex to the tip
        for (const ToolPart& part : parts) {
            const RigidMesh mesh = make_shape(part.shape);
            for (std::size_t v = 0; v < mesh.vertices.size(); v += 8) {
                const QVector3D at =
                    part.pose.map(QVector3D(mesh.vertices[v], mesh.vertices[v + 1], mesh.vertices[v + 2]));
                least = std::min(least, static_cast<double>(at.length()));
            }
        }
        EXPECT_LT(least, 0.0025) << type.name;
    }
}

TEST(ToolParts, InstrumentOutsideTheBodyHasNone) {
    std::vector<ToolPart> parts;
    add_tool_parts(DrawnTool(), parts);
    EXPECT_TRUE(parts.empty());
}

}  // namespace
}  // namespace fulcrum::ui
