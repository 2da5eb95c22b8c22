// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/picture.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/theatre/renderer/offscreen.h"

namespace fulcrum::ui {
namespace {

constexpr int gap = 12, title_height = 30;  // pixels

QFont figure_font(int pixels, bool bold) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(pixels);
    font.setBold(bold);
    return font;
}

}  // namespace

CameraPose camera_towards(const Vector3& eye, const Vector3& target, const Vector3& up,
                          double field_of_view) {
    const Vector3 back = (eye - target).normalized();
    Vector3 right = up.cross(back);
    if (right.norm() < 1e-6) right = back.unitOrthogonal();
    right.normalize();
    Matrix3 axes;
    axes.col(0) = right;
    axes.col(1) = back.cross(right);
    axes.col(2) = back;
    CameraPose camera;
    camera.position = eye;
    camera.orientation = Quaternion(axes);
    camera.field_of_view = field_of_view;
    return camera;
}

QImage draw_picture(const std::vector<PicturePanel>& panels, const PictureOptions& options) {
    const int columns = std::max(1, std::min(options.columns, static_cast<int>(panels.size())));
    const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
    const int wide = options.panel.width(), high = options.panel.height();
    const int width = columns * (wide + gap) + gap;
    const QFont words = figure_font(15, false);
    const QRect room(gap, 0, width - 2 * gap, 1000);
    const int caption_height =
        options.caption.isEmpty()
            ? 0
            : QFontMetrics(words)
                      .boundingRect(room, Qt::AlignLeft | Qt::TextWordWrap, options.caption)
                      .height() +
                  gap;
    QImage picture(width, rows * (high + title_height + gap) + gap + caption_height, QImage::Format_RGB32);
    picture.fill(Qt::white);

    OffscreenStage stage;
    RendererOptions quality;
    quality.texture_size = 128;
    quality.resolution = 1;
    quality.multisample = true;
    SceneRenderer renderer(quality);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::TextAntialiasing);
    for (std::size_t p = 0; p < panels.size(); ++p) {
        const PicturePanel& panel = panels[p];
        SceneFrame frame;
        frame.round = false;
        frame.camera = camera_towards(panel.eye, panel.target, panel.up, panel.field_of_view);
        const double distance = (panel.eye - panel.target).norm();
        // From above left, as figures are lit; as bright at the target whatever the distance.
        frame.lamp = distance * Vector3(-0.35, 0.45, 0.0);
        const double squared = 1.33 * distance * distance;
        frame.brightness = 0.25 * (0.40 + 70.0 * squared + 1500.0 * squared * squared);
        stage.make_current();
        renderer.clear_scene();
        renderer.set_meshes(panel.meshes);
        const QImage drawn = stage.picture(renderer, frame, options.panel);
        const int x = gap + static_cast<int>(p) % columns * (wide + gap);
        const int y = gap + static_cast<int>(p) / columns * (high + title_height + gap);
        painter.drawImage(x, y, drawn);
        painter.setPen(QColor(0x20, 0x24, 0x28));
        painter.setFont(figure_font(16, true));
        painter.drawText(QRect(x, y + high, wide, title_height), Qt::AlignCenter, panel.title);
    }
    painter.setPen(QColor(0x20, 0x24, 0x28));
    painter.setFont(words);
    painter.drawText(QRect(gap, picture.height() - caption_height, width - 2 * gap, caption_height),
                     Qt::AlignLeft | Qt::TextWordWrap, options.caption);
    painter.end();
    stage.make_current();
    renderer.release();
    return picture;
}

}  // namespace fulcrum::ui
