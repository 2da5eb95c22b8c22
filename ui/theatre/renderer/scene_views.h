// SPDX-License-Identifier: GPL-3.0-or-later
// How a scene's poses, views and target colours reach the graphics pipeline. Pure; any thread.
#pragma once

#include <QMatrix4x4>
#include <QQuaternion>
#include <QSize>
#include <QVector3D>

#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

QVector3D vector(const Vector3& v);
QQuaternion quaternion(const Quaternion& q);
/// Patient frame to camera frame.
QMatrix4x4 camera_matrix(const CameraPose& camera);
/// Camera frame to the picture: a scope's near planes for a round image, a figure's otherwise.
QMatrix4x4 projection_matrix(const SceneFrame& frame, QSize size);

struct TargetPaint {
    QVector3D hue;
    float glow, opacity;  ///< 0 .. 1
};
TargetPaint paint_of(const DrawnTarget& target);

}  // namespace fulcrum::ui
