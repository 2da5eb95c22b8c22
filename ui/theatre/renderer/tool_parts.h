// SPDX-License-Identifier: GPL-3.0-or-later
// What an instrument is put together from. Pure: the renderer draws what this lists.
#pragma once

#include <QMatrix4x4>
#include <QVector3D>
#include <vector>

#include "ui/theatre/renderer/scene_renderer.h"
#include "ui/theatre/renderer/tool_mesh.h"

namespace fulcrum::ui {

/// Shapes of tool_mesh.h.
enum class ToolShape { shaft, clevis, jaw, blade, rod, probe_end, hook, tube_end, ball, count };
RigidMesh make_shape(ToolShape shape);

struct ToolPart {
    ToolShape shape;
    QMatrix4x4 pose;  ///< to the patient frame, m
    bool insulated = false;
    QVector3D hue = {1, 1, 1};  ///< linear, of steel's coating
};

/// Adds the parts of an instrument whose tip, as contact has it, is the end of its jaws, of the hook's bow or
/// of the tube.
void add_tool_parts(const DrawnTool& tool, std::vector<ToolPart>& parts);

}  // namespace fulcrum::ui
