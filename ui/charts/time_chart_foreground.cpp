// SPDX-License-Identifier: GPL-3.0-or-later
// What a chart over time paints itself: its series, and in front of them the selection, values that held for
// a time, lanes, limits, marks, cursor, focus.
#include <QChart>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "ui/charts/time_chart.h"
#include "ui/language/language.h"

namespace fulcrum::ui {
namespace {

/// The first of them that ends after `time`.
template <typename Span>
auto first_after(const std::vector<Span>& spans, double time) {
    return std::lower_bound(spans.begin(), spans.end(), time,
                            [](const Span& span, double t) { return span.to < t; });
}

}  // namespace

double TimeChart::y_of(double value) const {
    const QRectF area = chart()->plotArea();
    const double span = std::max(y_axis_->max() - y_axis_->min(), 1e-9);
    return area.bottom() - area.height() * (value - y_axis_->min()) / span;
}

void TimeChart::draw_series(QPainter& painter, const QRectF& area) const {
    painter.save();
    painter.setClipRect(area, Qt::IntersectClip);
    // x_of() and y_of(), which ask chart and axes: once for all points.
    const double begin = x_axis_->min(), low = y_axis_->min(),
                 across = area.width() / std::max(x_axis_->max() - begin, 1e-9),
                 up = area.height() / std::max(y_axis_->max() - low, 1e-9);
    for (const Series& series : series_) {
        const QColor colour = colours().*series.colour;
        for (const ChartLine& line : series.lines) {
            QPolygonF shown;
            shown.reserve(static_cast<int>(line.points.size()));
            for (const ChartPoint& point : line.points)
                shown << QPointF(area.left() + across * (point.x - begin),
                                 area.bottom() - up * (point.y - low));
            if (shown.size() == 1) {  // between two gaps
                painter.setPen(QPen(colour, 2.4, Qt::SolidLine, Qt::RoundCap));
                painter.drawPoint(shown.front());
                continue;
            }
            painter.setPen(QPen(colour, 1.6, series.pen));
            painter.drawPolyline(shown);
        }
    }
    painter.restore();
}

void TimeChart::draw_selection(QPainter& painter, const QRectF& area) const {
    if (selected_to_ <= selected_from_) return;
    const double left = std::max(area.left(), x_of(selected_from_)),
                 right = std::min(area.right(), x_of(selected_to_));
    if (right <= left) return;
    QColor shade = colours().accent;
    painter.setPen(QPen(shade, 1));
    shade.setAlpha(36);
    painter.setBrush(shade);
    painter.drawRect(QRectF(left, area.top(), right - left, area.height()));
}

/// A column of pixels shows the highest of the values in it: an hour has more of them than a screen columns.
void TimeChart::draw_steps(QPainter& painter, const QRectF& area) const {
    const QColor line = colours().*steps_colour_;
    QColor fill = line;
    fill.setAlpha(70);
    const double zero = std::min(area.bottom(), y_of(0));
    QRectF open;
    const auto draw = [&] {
        if (open.isNull()) return;
        painter.fillRect(open, fill);
        painter.setPen(QPen(line, 1.6));
        painter.drawLine(open.topLeft(), open.topRight());
    };
    for (auto step = first_after(steps_, x_axis_->min()); step != steps_.end(); ++step) {
        if (step->from > x_axis_->max()) continue;  // they rise by their ends
        const double left = std::max(area.left(), x_of(step->from)),
                     right = std::min(area.right(), std::max(x_of(step->to), left + 1)),
                     y = y_of(step->value);
        if (!open.isNull() && right - open.left() <= 1) {
            open.setTop(std::min(open.top(), y));
            continue;
        }
        draw();
        open = QRectF(QPointF(left, y), QPointF(right, zero));
    }
    draw();
}

void TimeChart::draw_lanes(QPainter& painter, const QRectF& area) const {
    const double height = 0.6 * fontMetrics().height();
    double top = area.top() + 1;
    for (const Lane& lane : lanes_) {
        const QRectF row(area.left(), top, area.width(), height);
        top += height + 2;
        QColor ground = colours().line;
        ground.setAlpha(110);
        painter.fillRect(row, ground);
        for (auto span = first_after(lane.spans, x_axis_->min()); span != lane.spans.end(); ++span) {
            if (span->from > x_axis_->max()) break;
            const double left = std::max(row.left(), x_of(span->from)),
                         right = std::min(row.right(), std::max(x_of(span->to), left + 1.5));
            painter.fillRect(QRectF(left, row.top(), right - left, row.height()), colours().*lane.colour);
        }
    }
}

void TimeChart::draw_limits(QPainter& painter, const QRectF& area) const {
    for (const auto& [name, value] : limits_) {
        if (value > y_axis_->max()) continue;
        const double y = y_of(value);
        painter.setPen(QPen(colours().limit, 1.4, Qt::DashDotLine));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        // Above the line, or below it where there is no room; a long name in several lines.
        constexpr int flags = Qt::AlignLeft | Qt::TextWordWrap;
        QRectF words = painter.boundingRect(area.adjusted(6, 0, -6, 0), flags, name);
        words.moveTop(y - area.top() < words.height() + 4 ? y + 2 : y - words.height() - 2);
        painter.drawText(words, flags, name);
    }
}

/// Of a compact chart: Qt Charts hides the upper label of a low one and writes "..." in place of the others.
void TimeChart::draw_labels(QPainter& painter, const QRectF& area) const {
    if (compact_left_ == 0 || !y_axis_->isGridLineVisible()) return;
    const double line = fontMetrics().height();
    const int parts = std::max(1, y_axis_->tickCount() - 1);
    int each = 1;  // ticks from one label to the next: all, or as many as divide the axis evenly
    while (each < parts && (parts % each != 0 || area.height() * each / parts < line)) ++each;
    const double step = (y_axis_->max() - y_axis_->min()) / parts;
    painter.setPen(colours().muted);
    for (int tick = 0; tick <= parts; tick += each) {
        const double value = y_axis_->min() + tick * step;
        const QRectF place(0, std::max(0.0, y_of(value) - line / 2), area.left() - 8, line);
        painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter,
                         decimal(value, step * each < 0.1 ? 2
                                        : step * each < 1 ? 1
                                                          : 0));
    }
}

/// Of a compact chart, below its lanes, on a ground of its own.
void TimeChart::draw_name(QPainter& painter, const QRectF& area) const {
    const QString name = y_axis_->titleText();
    if (compact_left_ == 0 || name.isEmpty()) return;
    QRectF words(0, area.top() + lanes_height() + 1, fontMetrics().horizontalAdvance(name) + 6,
                 fontMetrics().height());
    words.moveRight(area.right() - 2);
    QColor ground = colours().card;
    ground.setAlpha(210);
    painter.fillRect(words, ground);
    painter.setPen(colours().muted);
    painter.drawText(words, Qt::AlignCenter, name);
}

double TimeChart::lanes_height() const {
    return static_cast<double>(lanes_.size()) * (0.6 * fontMetrics().height() + 2);
}

void TimeChart::draw_mark(QPainter& painter, const QRectF& area, const ChartMark& mark) const {
    const Palette& p = colours();
    const double x = x_of(mark.time);
    const bool struck = mark.review == MarkReview::struck;
    const QColor colour = struck ? p.muted : p.*mark.colour;
    painter.setPen(QPen(colour, mark.severe && !struck ? 1.6 : 1.0, struck ? Qt::DotLine : Qt::SolidLine));
    painter.drawLine(QPointF(x, area.top() - 8), QPointF(x, mark.severe ? area.bottom() : area.top() + 2));
    if (mark.severe) {
        painter.setPen(QPen(colour, 1.2));
        painter.setBrush(struck ? QBrush(p.card) : QBrush(colour));
        painter.drawPolygon(QPolygonF(
            {QPointF(x - 5, area.top() - 10), QPointF(x + 5, area.top() - 10), QPointF(x, area.top() - 1)}));
    }
    if (struck) {
        painter.setPen(QPen(p.muted, 1.6));
        painter.drawLine(QPointF(x - 7, area.top() - 2), QPointF(x + 7, area.top() - 11));
    }
    if (mark.review == MarkReview::confirmed) {
        painter.setPen(QPen(p.text, 1.4));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(QPointF(x, area.top() - 7), 7, 6.5);
    }
}

void TimeChart::drawForeground(QPainter* painter, const QRectF& rect) {
    QChartView::drawForeground(painter, rect);
    const Palette& p = colours();
    const QRectF area = chart()->plotArea();
    painter->save();
    draw_labels(*painter, area);
    painter->setClipRect(area.adjusted(-8, -14, 8, 2));
    painter->setRenderHint(QPainter::Antialiasing);
    draw_series(*painter, area);
    draw_selection(*painter, area);
    draw_steps(*painter, area);
    draw_lanes(*painter, area);
    draw_limits(*painter, area);
    if (peaks_shown_) draw_peaks(*painter, area);
    draw_name(*painter, area);
    for (const ChartMark& mark : marks_)
        if (mark.time >= x_axis_->min() && mark.time <= x_axis_->max()) draw_mark(*painter, area, mark);
    if (cursor_ >= x_axis_->min() && cursor_ <= x_axis_->max()) {
        const double x = x_of(cursor_);
        painter->setPen(QPen(p.text, 1.5));
        painter->drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
    if (hasFocus()) {
        painter->setClipping(false);
        painter->setPen(QPen(p.accent, 1));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(area);
    }
    painter->restore();
}

}  // namespace fulcrum::ui
