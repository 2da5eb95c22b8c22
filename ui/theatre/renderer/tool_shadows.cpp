// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/tool_shadows.h"

#include <algorithm>
#include <cmath>

#include "ui/theatre/renderer/scene_views.h"

namespace fulcrum::ui {
namespace {

// Bounds of the terms of shade() in shaders.cpp: a thirtieth is left of each.
constexpr float contact = 2;        // radii of the tip about the jaws
constexpr float pale = 0.0135F;     // m about strained jaws
constexpr float thrown = 1.7F;      // widths of the shadow
constexpr float widest = 0.03F;     // m, of a ball: larger triangles lie round about, not where one works
constexpr float soft_from = 0.05F;  // m behind the tip: there it is so wide that values at vertices do

float segment_distance(const QVector3D& p, const QVector3D& a, const QVector3D& b) {
    const QVector3D along = b - a, to_p = p - a;
    const float squared = along.lengthSquared();
    const float part =
        squared > 0 ? std::clamp(QVector3D::dotProduct(to_p, along) / squared, 0.0F, 1.0F) : 0.0F;
    return (to_p - part * along).length();
}

}  // namespace

bool ToolShadows::may_vary_in(const QVector3D& centre, float radius) const {
    if (radius > widest) return false;
    const QVector3D way = centre - lamp;
    const float far = way.length();
    for (int tool = 0; tool < most; ++tool) {
        if (from[tool].w() <= 0) continue;
        const float own = to[tool].w();
        const float about = std::max(strain[tool] > 0 ? pale : 0.0F, contact * own);
        if (segment_distance(centre, heel[tool], tip[tool]) < about + radius) return true;
        if (far <= 0) return true;
        const QVector3D to_tip = tip[tool] - lamp;
        const float along = QVector3D::dotProduct(to_tip, way) / far;
        const float gap = std::max(far - along, 0.0F);
        const float off = (to_tip - along / far * way).length();
        if (gap < soft_from + radius && off < thrown * (0.8F * own + 0.12F * gap) + radius) return true;
    }
    return false;
}

ToolShadows tool_shadows(const SceneFrame& frame, const QMatrix4x4& to_camera) {
    ToolShadows shadows;
    // As in shade(): a little above the lamp that lights.
    shadows.lamp = to_camera.inverted().map(vector(frame.lamp) + QVector3D(0, 0.016F, 0));
    int count = 0;
    for (const DrawnTool& tool : frame.tools) {
        if (tool.ghost || !tool.pose.inside || count == ToolShadows::most) continue;
        const double length = tool.jaws() ? tool.jaw_length : 4 * tool.shaft_radius;
        shadows.tip[count] = vector(tool.pose.tip);
        shadows.heel[count] = vector(tool.pose.tip - 1.6 * length * tool.pose.axis);
        // Open jaws shade less of what lies between them.
        shadows.from[count] = QVector4D(to_camera.map(shadows.heel[count]), 1.0F);
        shadows.to[count] = QVector4D(
            to_camera.map(shadows.tip[count]),
            static_cast<float>(2.1 * tool.shaft_radius + 0.15 * tool.jaw_length * tool.pose.jaw_angle));
        shadows.strain[count] = static_cast<float>(std::clamp(tool.strain, 0.0, 1.0));
        ++count;
    }
    return shadows;
}

}  // namespace fulcrum::ui
