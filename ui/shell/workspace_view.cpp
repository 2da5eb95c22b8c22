// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/workspace_view.h"

#include <QPainter>
#include <algorithm>

namespace fulcrum::ui {
namespace {

/// One view: which axis of the device goes to the right and which one down, and with which sign.
struct Projection {
    int right;
    double right_sign;
    int down;
    double down_sign;
};
// From above: right is right, towards the person is down. From the right side: away from the person is left.
constexpr Projection from_above{0, 1, 2, 1}, from_side{2, 1, 1, -1};

QPointF flat(const Vector3& place, const Projection& by) {
    return {by.right_sign * place[by.right], by.down_sign * place[by.down]};
}

QRectF flat(const WorkspaceBox& box, const Projection& by) {
    return QRectF(flat(box.least, by), flat(box.most, by)).normalized();
}

void draw_view(QPainter& painter, const QRectF& room, const WorkspacePicture& picture, const Projection& by,
               const QPalette& palette) {
    QRectF all = flat(picture.workspace, by);
    if (picture.scene) all |= flat(*picture.scene, by);
    const double edge = 0.06 * std::max(all.width(), all.height());
    all.adjust(-edge, -edge, edge, edge);
    const double scale = std::min(room.width() / all.width(), room.height() / all.height());
    const auto place = [&](const QPointF& at) { return room.center() + scale * (at - all.center()); };
    const auto boxed = [&](const QRectF& box) {
        return QRectF(place(box.topLeft()), place(box.bottomRight()));
    };
    QColor line = palette.color(QPalette::WindowText), faint = line;
    faint.setAlphaF(0.10);
    painter.setPen(QPen(line, 2));
    painter.setBrush(faint);
    painter.drawRect(boxed(flat(picture.workspace, by)));
    const QColor marked = palette.color(QPalette::Highlight);
    const double dot = 0.35 * painter.fontMetrics().height();
    if (picture.scene) {
        painter.setPen(QPen(marked, 2, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(boxed(flat(*picture.scene, by)));
        painter.setPen(QPen(marked, 2));
        painter.drawEllipse(place(flat(picture.begin, by)), 1.6 * dot, 1.6 * dot);
    }
    if (!picture.hand) return;
    QPointF at = place(flat(*picture.hand, by));
    at = {std::clamp(at.x(), room.left(), room.right()), std::clamp(at.y(), room.top(), room.bottom())};
    painter.setPen(QPen(line, 1));
    painter.setBrush(marked);
    painter.drawEllipse(at, dot, dot);
}

}  // namespace

WorkspaceView::WorkspaceView(QWidget* parent) : QWidget(parent) {}

QSize WorkspaceView::sizeHint() const {
    const int letter = fontMetrics().height();
    return {20 * letter, 11 * letter};
}

void WorkspaceView::show_picture(const QString& hand, const WorkspacePicture& picture) {
    hand_ = hand;
    picture_ = picture;
    setAccessibleName(tr("%1: workspace from above and from the side").arg(hand));
    update();
}

void WorkspaceView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double letter = fontMetrics().height();
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF whole = QRectF(rect()).adjusted(1, 1, -1, -1);
    painter.drawText(QRectF(whole.left(), whole.top(), whole.width(), 1.3 * letter), Qt::AlignLeft, hand_);
    const QRectF views(whole.left(), whole.top() + 1.4 * letter, whole.width(),
                       whole.height() - 2.9 * letter);
    const double half = views.width() / 2;
    const QString titles[] = {tr("from above"), tr("from the side")};
    const Projection* const ways[] = {&from_above, &from_side};
    for (int i = 0; i < 2; ++i) {
        const QRectF room(views.left() + i * half, views.top(), half - 0.5 * letter, views.height());
        draw_view(painter, room, picture_, *ways[i], palette());
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QRectF(room.left(), views.bottom() + 0.2 * letter, room.width(), 1.3 * letter),
                         Qt::AlignHCenter, titles[i]);
    }
}

}  // namespace fulcrum::ui

#include "moc_workspace_view.cpp"
