// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/frame_check.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstring>

namespace fulcrum::ui {
namespace {

constexpr double shown_m = 0.08;  // from the middle to the border
constexpr double moved = 0.25;    // of that, counts as moved in this direction
constexpr unsigned left_shoulder = 1U << 9, right_shoulder = 1U << 10;  // buttons of SDL

}  // namespace

FrameCheck::FrameCheck(QWidget* parent) : QWidget(parent) {
    points_[0].name = tr("Left hand");
    points_[1].name = tr("Right hand");
    points_[2].name = tr("Scope");
    setAccessibleName(tr("Where the hands are"));
}

QSize FrameCheck::sizeHint() const {
    const int side = 11 * fontMetrics().height();
    return {side, side};
}

void FrameCheck::begin_again() {
    for (Point& one : points_) {
        const QString name = one.name;
        one = {};
        one.name = name;
    }
    update();
}

void FrameCheck::follow(Point& point, double right, double up, double away) {
    point.right = std::clamp(right, -1.0, 1.0);
    point.up = std::clamp(up, -1.0, 1.0);
    point.away = std::clamp(away, -1.0, 1.0);
    // One direction at a time: the largest movement says which.
    const double most = std::max({std::abs(right), std::abs(up), std::abs(away)});
    if (right > moved && right == most) point.seen[0] = true;
    if (up > moved && up == most) point.seen[1] = true;
    if (away > moved && away == most) point.seen[2] = true;
}

void FrameCheck::show_readings(const DeviceReadings& readings) {
    if (readings.controller) {
        const ControllerReadings& pad = *readings.controller;
        for (int h = 0; h < 2; ++h) {
            Point& point = points_[h];
            point.exists = pad.connected;
            const bool along = (pad.buttons & (h == 0 ? left_shoulder : right_shoulder)) != 0;
            if (point.exists && pad.begun[h])
                follow(point, along ? 0 : pad.stick[h][0], along ? 0 : pad.stick[h][1],
                       along ? pad.stick[h][1] : 0);
        }
    }
    for (const DeviceReadings::Slot& slot : readings.held) {
        Point& point = points_[std::strcmp(slot.name, "left") == 0    ? 0
                               : std::strcmp(slot.name, "right") == 0 ? 1
                                                                      : 2];
        point.exists = slot.present;
        if (!slot.present || !slot.position.allFinite()) continue;
        if (!point.known) point.middle = slot.position;
        point.known = true;
        const Vector3 step = (slot.position - point.middle) / shown_m;
        follow(point, step.x(), step.y(), -step.z());  // the device counts towards the person
    }
    update();
}

QStringList FrameCheck::lines() const {
    QStringList lines;
    const QString directions[] = {tr("right"), tr("up"), tr("away from you")};
    for (const Point& point : points_) {
        if (!point.exists) continue;
        QStringList marks;
        for (int i = 0; i < 3; ++i)
            marks << (point.seen[i] ? QStringLiteral("✓ ") : QStringLiteral("– ")) + directions[i];
        lines << tr("%1: %2").arg(point.name, marks.join(QStringLiteral(" · ")));
    }
    return lines;
}

void FrameCheck::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = std::min(width(), height()) - 2.0;
    const QRectF round((width() - side) / 2, (height() - side) / 2, side, side);
    QColor line = palette().color(QPalette::WindowText);
    QColor faint = line;
    faint.setAlphaF(0.25);
    painter.setPen(QPen(faint, 1.5));
    painter.drawEllipse(round);
    painter.drawLine(QPointF(round.left(), round.center().y()), QPointF(round.right(), round.center().y()));
    painter.drawLine(QPointF(round.center().x(), round.top()), QPointF(round.center().x(), round.bottom()));
    const double letter = fontMetrics().height();
    for (const Point& point : points_) {
        if (!point.exists) continue;
        const double reach = side / 2 - letter;
        const QPointF at = round.center() + QPointF(point.right * reach, -point.up * reach);
        const double size = letter * (0.6 - 0.3 * point.away);  // smaller further away
        painter.setPen(QPen(line, 2));
        painter.setBrush(palette().color(QPalette::Highlight));
        painter.drawEllipse(at, size, size);
        painter.setPen(palette().color(QPalette::HighlightedText));
        painter.drawText(QRectF(at.x() - letter, at.y() - letter, 2 * letter, 2 * letter), Qt::AlignCenter,
                         point.name.left(1));
    }
}

}  // namespace fulcrum::ui

#include "moc_frame_check.cpp"
