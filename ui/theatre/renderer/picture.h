// SPDX-License-Identifier: GPL-3.0-or-later
// Figures for reports and studies: meshes seen from a camera, several panels with their titles side by side,
// drawn by the theatre's own renderer without a window.
#pragma once

#include <QImage>
#include <QString>
#include <vector>

#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

struct PicturePanel {
    QString title;
    std::vector<DrawnMesh> meshes;
    Vector3 eye = Vector3(0, -0.3, 0.1), target = Vector3::Zero(), up = Vector3::UnitZ();  ///< m
    double field_of_view = 0.5;  ///< rad, full vertical angle
};

struct PictureOptions {
    int columns = 3;           ///< panels a row
    QSize panel = {420, 320};  ///< pixels
    QString caption;           ///< under the panels; wrapped
};

/// Camera at `eye` that looks at `target`; `up` need not be at right angles to it.
CameraPose camera_towards(const Vector3& eye, const Vector3& target, const Vector3& up, double field_of_view);

/// Needs a QGuiApplication whose platform offers OpenGL; throws std::runtime_error where there is none.
QImage draw_picture(const std::vector<PicturePanel>& panels, const PictureOptions& options);

}  // namespace fulcrum::ui
