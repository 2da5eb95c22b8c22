// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/scope_picture.h"

#include <QRegion>
#include <algorithm>
#include <cmath>

namespace fulcrum::ui {
namespace {

/// Share of the light that passes at (x, y), in units of the image's radius, y upwards.
double passes(double x, double y, double pixel) {
    const double r2 = x * x + y * y;
    const double inside = std::clamp((0.985 * 0.985 - r2) / (2.0 * pixel), 0.0, 1.0);
    const double beyond = std::clamp((r2 - 0.36) / 0.64, 0.0, 1.0);
    const double notch = std::clamp((std::abs(x) + std::abs(y - 0.985) - 0.022) / pixel, 0.0, 1.0);
    return (1.0 - 0.5 * beyond * beyond) * inside * notch;
}

QImage make_frame(int side) {
    QImage frame(side, side, QImage::Format_ARGB32_Premultiplied);
    const double pixel = 2.0 / side;
    for (int row = 0; row < side; ++row) {
        auto* line = reinterpret_cast<QRgb*>(frame.scanLine(row));
        for (int column = 0; column < side; ++column) {
            const double light = passes((column + 0.5) * pixel - 1, 1 - (row + 0.5) * pixel, pixel);
            line[column] = qRgba(0, 0, 0, static_cast<int>(std::lround(255 * (1 - light))));
        }
    }
    return frame;
}

}  // namespace

void ScopePicture::paint(QPainter& painter, const QRect& area, const QImage& picture) {
    const int side = std::min(area.width(), area.height());
    const QRect square(area.left() + (area.width() - side) / 2, area.top() + (area.height() - side) / 2, side,
                       side);
    for (const QRect& beside : QRegion(area) - square) painter.fillRect(beside, Qt::black);
    if (side < 1) return;
    const double ratio = painter.device()->devicePixelRatioF();
    const int pixels = static_cast<int>(std::lround(side * ratio));
    if (frame_.width() != pixels) {
        frame_ = make_frame(pixels);
        frame_.setDevicePixelRatio(ratio);
    }
    const bool smooth = painter.testRenderHint(QPainter::SmoothPixmapTransform);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(square, picture);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, smooth);
    painter.drawImage(square.topLeft(), frame_);
}

}  // namespace fulcrum::ui
