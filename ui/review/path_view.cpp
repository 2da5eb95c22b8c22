// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/path_view.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/language/language.h"
#include "ui/style/palette.h"

namespace fulcrum::ui {

PathView::PathView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(280, 240);
    setObjectName(QStringLiteral("path_view"));
    setAccessibleName(tr("Paths of both instrument tips"));
    setToolTip(tr("Drag or use the arrow keys to turn it; scroll, or + and −, to zoom."));
}

void PathView::set_attempt(const AttemptModel& model) {
    path_ = model.path;
    marks_.clear();
    Vector3 low = Vector3::Constant(1e9), high = Vector3::Constant(-1e9);
    bool any = false;
    for (const auto& path : path_) {
        for (const PathPoint& point : path) {
            low = low.cwiseMin(point.position);
            high = high.cwiseMax(point.position);
            any = true;
        }
    }
    centre_ = any ? Vector3(0.5 * (low + high)) : Vector3::Zero();
    radius_ = any ? std::max(0.01, 0.5 * (high - low).norm()) : 0.1;
    for (const EventLine& line : model.events) {
        if (!line.severe || line.event.hand > 1) continue;
        marks_.push_back({line.time, position_at(line.event.hand, line.time), line.words, line.critical});
    }
    update();
}

void PathView::set_cursor(double time) {
    cursor_ = time;
    update();
}

Vector3 PathView::position_at(std::size_t hand, double time) const {
    const std::vector<PathPoint>& path = path_[hand];
    if (path.empty()) return centre_;
    const auto after = std::upper_bound(path.begin(), path.end(), time,
                                        [](double t, const PathPoint& point) { return t < point.time; });
    return after == path.begin() ? path.front().position : std::prev(after)->position;
}

QPointF PathView::project(const Vector3& point, double* depth) const {
    // Seen from the patient's left and front at yaw and pitch 0: x to the right, z (anterior) up, y into the
    // screen.
    const Vector3 p = point - centre_;
    const double x = std::cos(yaw_) * p.x() - std::sin(yaw_) * p.y();
    const double y = std::sin(yaw_) * p.x() + std::cos(yaw_) * p.y();
    const double up = std::cos(pitch_) * p.z() + std::sin(pitch_) * y;
    if (depth != nullptr) *depth = std::cos(pitch_) * y - std::sin(pitch_) * p.z();
    const double scale = zoom_ * 0.44 * std::min(width(), height()) / radius_;
    return {0.5 * width() + x * scale, 0.5 * height() - up * scale};
}

void PathView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& p = colours();
    painter.fillRect(rect(), p.card);
    const QColor hand_colours[] = {p.left_hand, p.right_hand};
    bool any = false;
    for (std::size_t h = 0; h < hand_count; ++h) {
        const std::vector<PathPoint>& path = path_[h];
        // Far parts are fainter: six shades are enough to read depth and keep the number of pens small.
        constexpr int shades = 6;
        std::array<QVector<QLineF>, shades> lines;
        for (std::size_t i = 1; i < path.size(); ++i) {
            if (path[i].time - path[i - 1].time > 1.0 &&
                (path[i].position - path[i - 1].position).norm() > 0.02) {
                continue;
            }
            double depth = 0;
            const QPointF from = project(path[i - 1].position), to = project(path[i].position, &depth);
            const double near = std::clamp(0.5 - 0.5 * depth / radius_, 0.0, 0.999);
            lines[static_cast<std::size_t>(near * shades)].push_back({from, to});
            any = true;
        }
        for (int shade = 0; shade < shades; ++shade) {
            QColor colour = hand_colours[h];
            colour.setAlpha(70 + 30 * shade);
            QPen pen(colour, 1.3);
            if (h == 1) pen.setDashPattern({6, 2});
            painter.setPen(pen);
            painter.drawLines(lines[static_cast<std::size_t>(shade)]);
        }
    }
    if (!any) {
        painter.setPen(p.muted);
        painter.drawText(rect(), Qt::AlignCenter, tr("No path was recorded"));
        paint_keyboard(painter);
        return;
    }
    for (const Mark& mark : marks_) {
        const QPointF at = project(mark.position);
        painter.setPen(QPen(p.card, 1));
        painter.setBrush(mark.critical ? p.bad : p.warning);
        painter.drawPolygon(QPolygonF({at + QPointF(0, -7), at + QPointF(6, 4), at + QPointF(-6, 4)}));
    }
    if (cursor_ >= 0) {
        for (std::size_t h = 0; h < hand_count; ++h) {
            if (path_[h].empty()) continue;
            painter.setPen(QPen(p.text, 2));
            painter.setBrush(hand_colours[h]);
            painter.drawEllipse(project(position_at(h, cursor_)), 5.5, 5.5);
        }
    }
    // The patient's directions, in the lower left corner.
    const QPointF corner(46, height() - 46);
    const std::pair<Vector3, QString> axes[] = {
        {Vector3(1, 0, 0), tr("left")}, {Vector3(0, 1, 0), tr("head")}, {Vector3(0, 0, 1), tr("front")}};
    for (const auto& [axis, name] : axes) {
        const QPointF end = corner + (project(centre_ + axis * radius_) - project(centre_)) *
                                         (28.0 / (zoom_ * 0.44 * std::min(width(), height())));
        painter.setPen(QPen(p.muted, 1.2));
        painter.drawLine(corner, end);
        painter.drawText(end + QPointF(3, -2), name);
    }
    paint_words(painter);
    paint_keyboard(painter);
}

void PathView::paint_keyboard(QPainter& painter) const {
    if (!hasFocus()) return;
    painter.setPen(QPen(colours().accent, 1, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

/// The lines of both hands at the top, and what the keys do at the bottom, next to the directions.
void PathView::paint_words(QPainter& painter) const {
    const Palette& p = colours();
    const int line = fontMetrics().height();
    const QString left = tr("— left hand");
    painter.setPen(p.left_hand);
    painter.drawText(QPointF(12, 6 + line), left);
    painter.setPen(p.right_hand);
    painter.drawText(QPointF(12 + 1.5 * line + fontMetrics().horizontalAdvance(left), 6 + line),
                     tr("- - right hand"));
    const int after_directions = 92 + fontMetrics().horizontalAdvance(tr("front"));
    painter.setPen(p.muted);
    painter.drawText(
        QRect(after_directions, height() - 4 * line, width() - after_directions - 12, 4 * line - 6),
        Qt::AlignRight | Qt::AlignBottom | Qt::TextWordWrap, toolTip());
}

const PathView::Mark* PathView::mark_near(const QPointF& place) const {
    const Mark* nearest = nullptr;
    double best = 11;
    for (const Mark& mark : marks_) {
        const QPointF off = project(mark.position) - place;
        const double distance = std::hypot(off.x(), off.y());
        if (distance < best) {
            best = distance;
            nearest = &mark;
        }
    }
    return nearest;
}

void PathView::mousePressEvent(QMouseEvent* event) {
    last_ = event->pos();
    dragged_ = false;
}

void PathView::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) == 0) return;
    const QPoint moved = event->pos() - last_;
    if (!dragged_ && moved.manhattanLength() < 4) return;
    dragged_ = true;
    yaw_ += moved.x() * 0.008;
    pitch_ = std::clamp(pitch_ + moved.y() * 0.008, -1.55, 1.55);
    last_ = event->pos();
    update();
}

void PathView::mouseReleaseEvent(QMouseEvent* event) {
    if (dragged_) return;
    if (const Mark* mark = mark_near(event->localPos())) emit time_chosen(mark->time);
}

void PathView::wheelEvent(QWheelEvent* event) {
    zoom_ = std::clamp(zoom_ * std::pow(1.15, event->angleDelta().y() / 120.0), 0.4, 20.0);
    update();
    event->accept();
}

void PathView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left:
            yaw_ -= 0.1;
            break;
        case Qt::Key_Right:
            yaw_ += 0.1;
            break;
        case Qt::Key_Up:
            pitch_ = std::min(pitch_ + 0.1, 1.55);
            break;
        case Qt::Key_Down:
            pitch_ = std::max(pitch_ - 0.1, -1.55);
            break;
        case Qt::Key_Plus:
            zoom_ = std::min(zoom_ * 1.2, 20.0);
            break;
        case Qt::Key_Minus:
            zoom_ = std::max(zoom_ / 1.2, 0.4);
            break;
        default:
            QWidget::keyPressEvent(event);
            return;
    }
    update();
}

bool PathView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const Mark* mark = mark_near(help->pos())) {
            QToolTip::showText(help->globalPos(), tr("%1 s: %2").arg(decimal(mark->time, 2)).arg(mark->words),
                               this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QWidget::event(event);
}

}  // namespace fulcrum::ui

#include "moc_path_view.cpp"
