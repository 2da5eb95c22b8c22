// SPDX-License-Identifier: GPL-3.0-or-later
// What instruments take of the lamp's light: the figures that the shaders' shade() reads, and where it can
// matter at all.
#pragma once

#include <QMatrix4x4>
#include <QVector2D>
#include <QVector4D>

#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

struct ToolShadows {
    static constexpr int most = 2;  ///< a hand each; ghosts throw no shadow
    QVector4D from[most];           ///< camera space, m: behind the jaws; w: strength, 0 none
    QVector4D to[most] = {{0, 0, 1, 1}, {0, 0, 1, 1}};  ///< the tip; w: radius, m
    QVector2D strain;                                   ///< 0 .. 1, one a tool
    QVector3D heel[most], tip[most], lamp;              ///< patient frame, m: the same, and the shadows' lamp

    /// False where shade() is even over a ball (patient frame, m), so that one value a vertex does: nothing
    /// of the light is taken, or by a shadow so wide that a ball of a centimetre does not show its rim. False
    /// as well for balls above 3 cm: what is made of such triangles lies round about.
    bool may_vary_in(const QVector3D& centre, float radius) const;
};

ToolShadows tool_shadows(const SceneFrame& frame, const QMatrix4x4& to_camera);

}  // namespace fulcrum::ui
