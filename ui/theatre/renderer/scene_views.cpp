// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/scene_views.h"

#include <cmath>

namespace fulcrum::ui {
namespace {

constexpr float near_plane = 0.003F, far_plane = 0.8F;                // m
constexpr float figure_near_plane = 0.01F, figure_far_plane = 20.0F;  // m

}  // namespace

QVector3D vector(const Vector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

QQuaternion quaternion(const Quaternion& q) {
    return {static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
            static_cast<float>(q.z())};
}

QMatrix4x4 camera_matrix(const CameraPose& camera) {
    QMatrix4x4 matrix;
    matrix.rotate(quaternion(camera.orientation).conjugated());
    matrix.translate(-vector(camera.position));
    return matrix;
}

QMatrix4x4 projection_matrix(const SceneFrame& frame, QSize size) {
    QMatrix4x4 matrix;
    const float aspect = static_cast<float>(size.width()) / static_cast<float>(size.height());
    matrix.perspective(static_cast<float>(frame.camera.field_of_view * 180 / 3.14159265358979), aspect,
                       frame.round ? near_plane : figure_near_plane,
                       frame.round ? far_plane : figure_far_plane);
    return matrix;
}

// Blue and orange of Okabe and Ito's palette: distinguished by every kind of colour vision.
TargetPaint paint_of(const DrawnTarget& target) {
    const QVector3D hue =
        target.hand == Hand::left ? QVector3D(0.00F, 0.45F, 0.80F) : QVector3D(0.95F, 0.58F, 0.05F);
    switch (target.look) {
        case TargetLook::current:
            return {hue, 1.0F, 1.0F};
        case TargetLook::touched:
            return {QVector3D(0.98F, 0.95F, 0.75F), 0.8F, 1.0F};
        case TargetLook::done:
            return {QVector3D(0.35F, 0.36F, 0.38F), 0.0F, 0.35F};
        case TargetLook::bleeding:
            return {QVector3D(0.62F, 0.02F, 0.02F), 0.25F, 1.0F};
        case TargetLook::clip:
            return {QVector3D(0.70F, 0.72F, 0.75F), 0.0F, 1.0F};
        case TargetLook::waiting:
            break;
    }
    return {0.62F * hue, 0.0F, 1.0F};
}

QVector3D SceneRenderer::project(const CameraPose& camera, const Vector3& point, QSize size) {
    const QVector3D local = camera_matrix(camera).map(vector(point));
    const float radius = 0.5F * static_cast<float>(std::min(size.width(), size.height()));
    const float depth = -local.z();
    const float scale =
        radius / (std::max(1e-6F, depth) * static_cast<float>(std::tan(0.5 * camera.field_of_view)));
    return {0.5F * static_cast<float>(size.width()) + scale * local.x(),
            0.5F * static_cast<float>(size.height()) - scale * local.y(), depth};
}

}  // namespace fulcrum::ui
