// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/attempt_chart.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/style/announce.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

/// Maps attempt number and value to the plot.
struct Frame {
    QRectF plot;
    double x_low = 0.5, x_high = 1.5, y_low = 0, y_high = 1, y_step = 1;
    QPointF at(double number, double value) const {
        return {plot.left() + plot.width() * (number - x_low) / (x_high - x_low),
                plot.bottom() - plot.height() * (value - y_low) / (y_high - y_low)};
    }
};

double nice_step(double span) {
    const double raw = span / 4, power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0}) {
        if (raw <= factor * power * 1.0001) return factor * power;
    }
    return 10 * power;
}

Frame frame_of(const QRectF& area, const AttemptChartData& data, double unit) {
    Frame frame;
    frame.plot = area.adjusted(64 * unit, 30 * unit, -14 * unit, -44 * unit);
    int last = 1;
    double high = std::max(data.limit.value_or(0), data.band_high.value_or(0));
    double low = std::min({0.0, data.limit.value_or(0), data.band_low.value_or(0)});
    for (const AttemptSeries& series : data.series) {
        for (const AttemptPoint& point : series.points) {
            last = std::max(last, point.number);
            if (point.value) high = std::max(high, *point.value);
            if (point.value) low = std::min(low, *point.value);
        }
    }
    frame.x_high = last + 0.5;
    if (data.y_maximum) {
        frame.y_high = *data.y_maximum;
        frame.y_step = *data.y_maximum / 4;
    } else {
        if (high <= 0 && low >= 0) high = 1;
        frame.y_step = nice_step((high - low) * 1.08);
        frame.y_high = std::ceil(high * 1.08 / frame.y_step) * frame.y_step;
        frame.y_low = std::floor(low * 1.08 / frame.y_step) * frame.y_step;
    }
    return frame;
}

/// The experts' range across the plot, between dotted lines.
void paint_band(QPainter& painter, const Frame& frame, const AttemptChartData& data, const Palette& p,
                double unit) {
    if (!data.band_low || !data.band_high) return;
    const double low = std::clamp(*data.band_low, frame.y_low, frame.y_high);
    const double high = std::clamp(*data.band_high, frame.y_low, frame.y_high);
    const QRectF band(frame.at(frame.x_low, high), frame.at(frame.x_high, low));
    QColor fill = p.good;
    fill.setAlpha(36);
    painter.fillRect(band, fill);
    painter.setPen(QPen(p.good, unit, Qt::DotLine));
    painter.drawLine(band.topLeft(), band.topRight());
    painter.drawLine(band.bottomLeft(), band.bottomRight());
    painter.setPen(p.good);
    const double line = QFontMetricsF(painter.font(), painter.device()).height();
    painter.drawText(QRectF(band.left(), band.bottom() + 2 * unit, band.width() - 6 * unit, line),
                     Qt::AlignRight, data.band_name);
}

/// The interval of the plateau as a band, the fitted curve as a thick line over it.
void paint_curve(QPainter& painter, const Frame& frame, const AttemptSeries& series, QColor colour,
                 double unit) {
    if (series.plateau_low && series.plateau_high) {
        QColor band = colour;
        band.setAlpha(40);
        const double low = std::clamp(*series.plateau_low, frame.y_low, frame.y_high);
        const double high = std::clamp(*series.plateau_high, frame.y_low, frame.y_high);
        painter.fillRect(QRectF(frame.at(frame.x_low, high), frame.at(frame.x_high, low)), band);
    }
    QPolygonF curve;
    for (const auto& [number, value] : series.curve)
        curve << frame.at(number, std::clamp(value, frame.y_low, frame.y_high));
    colour.setAlpha(150);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, 4 * unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(curve);
}

/// A disc where it passed, a cross where it failed, a ring where it was not scored; larger where it counts.
void paint_point(QPainter& painter, const QPointF& at, const AttemptPoint& point, const QColor& colour,
                 const Palette& p, double unit, bool selected) {
    const double r = (point.counting ? 5.5 : 3.5) * unit;
    painter.setPen(QPen(colour, 2 * unit));
    if (!point.passed) {
        painter.setBrush(p.card);
        painter.drawEllipse(at, r, r);
    } else if (*point.passed) {
        painter.setBrush(colour);
        painter.drawEllipse(at, r, r);
    } else {
        painter.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
        painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
    }
    if (!selected) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(p.text, 1.5 * unit));
    painter.drawEllipse(at, r + 5 * unit, r + 5 * unit);
}

}  // namespace

void paint_attempt_chart(QPainter& painter, const QRectF& area, const AttemptChartData& data,
                         const Palette& p, double unit, const std::string& selected) {
    const Frame frame = frame_of(area, data, unit);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double line_height = QFontMetricsF(painter.font(), painter.device()).height();
    painter.setPen(p.muted);
    painter.drawText(QRectF(area.left(), area.top(), area.width() / 2, line_height), Qt::AlignLeft,
                     data.y_title);
    const int lines = static_cast<int>(std::lround((frame.y_high - frame.y_low) / frame.y_step));
    for (int i = 0; i <= lines; ++i) {
        const double y = frame.y_low + i * frame.y_step;
        const QPointF left = frame.at(frame.x_low, y), right = frame.at(frame.x_high, y);
        painter.setPen(QPen(p.line, unit));
        painter.drawLine(left, right);
        painter.setPen(p.muted);
        painter.drawText(QRectF(area.left(), left.y() - line_height / 2, 56 * unit, line_height),
                         Qt::AlignRight | Qt::AlignVCenter, figure(y));
    }
    const int last = static_cast<int>(frame.x_high - 0.5);
    // So many numbers as have room next to each other.
    const double wide =
        QFontMetricsF(painter.font(), painter.device()).horizontalAdvance(QStringLiteral("000"));
    const int most = std::clamp(static_cast<int>(frame.plot.width() / wide), 1, 12);
    const int step = std::max(1, (last + most - 1) / most);
    for (int number = 1; number <= last; number += step) {
        const QPointF foot = frame.at(number, frame.y_low);
        painter.drawText(QRectF(foot.x() - 30 * unit, foot.y() + 4 * unit, 60 * unit, line_height),
                         Qt::AlignCenter, QString::number(number));
    }
    painter.drawText(QRectF(frame.plot.left(), area.bottom() - line_height, frame.plot.width(), line_height),
                     Qt::AlignCenter, QCoreApplication::translate("fulcrum::ui::AttemptChart", "attempt"));
    if (data.limit && *data.limit <= frame.y_high) {
        painter.setPen(QPen(p.limit, 1.5 * unit, Qt::DashDotLine));
        painter.drawLine(frame.at(frame.x_low, *data.limit), frame.at(frame.x_high, *data.limit));
        painter.drawText(frame.at(frame.x_low, *data.limit) + QPointF(6 * unit, -4 * unit), data.limit_name);
    }
    paint_band(painter, frame, data, p, unit);
    const QColor colours[] = {p.left_hand, p.right_hand, p.good, p.limit, p.neutral, p.text};
    const Qt::PenStyle styles[] = {Qt::SolidLine,   Qt::DashLine,       Qt::DotLine,
                                   Qt::DashDotLine, Qt::DashDotDotLine, Qt::SolidLine};
    double legend_x = area.right();
    for (std::size_t s = 0; s < data.series.size(); ++s) {
        const AttemptSeries& series = data.series[s];
        const QColor colour = colours[s % 6];
        QPolygonF line;
        for (const AttemptPoint& point : series.points) {
            if (point.value) line << frame.at(point.number, std::min(*point.value, frame.y_high));
        }
        paint_curve(painter, frame, series, colour, unit);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, (series.curve.empty() ? 1.6 : 0.8) * unit, styles[s % 6]));
        painter.drawPolyline(line);
        for (const AttemptPoint& point : series.points) {
            if (!point.value) continue;
            const QPointF at = frame.at(point.number, std::min(*point.value, frame.y_high));
            paint_point(painter, at, point, colour, p, unit,
                        !selected.empty() && point.attempt_id == selected);
        }
        const double width = QFontMetricsF(painter.font(), painter.device()).horizontalAdvance(series.name);
        legend_x -= width + 34 * unit;
        painter.setPen(QPen(colour, 2 * unit, styles[s % 6]));
        painter.drawLine(QPointF(legend_x, area.top() + line_height / 2),
                         QPointF(legend_x + 20 * unit, area.top() + line_height / 2));
        painter.setPen(p.text);
        painter.drawText(QRectF(legend_x + 26 * unit, area.top(), width + 4 * unit, line_height),
                         Qt::AlignLeft, series.name);
    }
    painter.restore();
}

AttemptChart::AttemptChart(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setObjectName(QStringLiteral("attempt_chart"));
    setToolTip(tr("Arrow keys choose an attempt, Enter opens it."));
}

void AttemptChart::set_data(AttemptChartData shown) {
    data_ = std::move(shown);
    selected_.clear();
    setAccessibleName(data_.y_title);
    setAccessibleDescription(toolTip());
    update();
    values_changed();
}

ChartTable AttemptChart::table() const {
    ChartTable table;
    table.columns = {{tr("Device")}, {tr("Attempt")}, {tr("Value"), data_.unit},
                     {tr("Result")}, {tr("Counts")},  {tr("Fitted curve"), data_.unit}};
    if (data_.limit) table.columns.push_back({data_.limit_name, data_.unit});
    for (const AttemptSeries& series : data_.series) {
        for (const AttemptPoint& point : series.points) {
            std::optional<double> fitted;
            for (const auto& [number, value] : series.curve)
                if (number == point.number) fitted = value;
            ChartRow row{{ChartCell::words(series.name), ChartCell::count(point.number),
                          ChartCell::value(point.value), ChartCell::words(verdict(point.passed, false)),
                          ChartCell::words(point.counting ? tr("yes") : tr("no")), ChartCell::value(fitted)},
                         text(point.attempt_id)};
            if (data_.limit) row.cells.push_back(ChartCell::value(data_.limit));
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

void AttemptChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& p = colours();
    painter.fillRect(rect(), p.card);
    if (data_.series.empty()) {
        painter.setPen(p.muted);
        painter.drawText(rect(), Qt::AlignCenter, tr("No attempts yet"));
        return;
    }
    paint_attempt_chart(painter, QRectF(rect()).adjusted(8, 8, -8, -4), data_, p, 1, selected_);
    if (hasFocus()) {
        painter.setPen(QPen(p.accent, 1, Qt::DotLine));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

const AttemptPoint* AttemptChart::point_near(const QPointF& position) const {
    const AttemptPoint* nearest = nullptr;
    double best = 12;
    for (const AttemptSeries& series : data_.series) {
        for (const AttemptPoint& point : series.points) {
            if (!point.value) continue;
            const QPointF off = place_of(point) - position;
            const double distance = std::hypot(off.x(), off.y());
            if (distance < best) {
                best = distance;
                nearest = &point;
            }
        }
    }
    return nearest;
}

void AttemptChart::mousePressEvent(QMouseEvent* event) {
    if (const AttemptPoint* point = point_near(event->localPos())) {
        selected_ = point->attempt_id;
        update();
        emit attempt_chosen(text(point->attempt_id));
    }
}

void AttemptChart::keyPressEvent(QKeyEvent* event) {
    std::vector<const AttemptPoint*> points;
    for (const AttemptSeries& series : data_.series) {
        for (const AttemptPoint& point : series.points) {
            if (point.value) points.push_back(&point);
        }
    }
    std::size_t index = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i]->attempt_id == selected_) index = i;
    }
    if (event->key() == Qt::Key_Right && !points.empty()) {
        selected_ = points[index >= points.size() ? 0 : std::min(index + 1, points.size() - 1)]->attempt_id;
    } else if (event->key() == Qt::Key_Left && !points.empty()) {
        selected_ =
            points[index >= points.size() ? points.size() - 1 : index - std::min<std::size_t>(index, 1)]
                ->attempt_id;
    } else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && index < points.size()) {
        if (event->isAutoRepeat()) return;  // held since the page before
        emit attempt_chosen(text(selected_));
        return;  // what it leads to may replace the chart
    } else {
        QWidget::keyPressEvent(event);
        return;
    }
    update();
    for (const AttemptPoint* point : points)
        if (point->attempt_id == selected_) say(*point);
}

/// As the tool tip under the mouse does.
void AttemptChart::say(const AttemptPoint& point) {
    setAccessibleDescription(point.tip);
    announce(this, point.tip);
    QToolTip::showText(mapToGlobal(place_of(point).toPoint()), point.tip, this);
}

QPointF AttemptChart::place_of(const AttemptPoint& point) const {
    const Frame frame = frame_of(QRectF(rect()).adjusted(8, 8, -8, -4), data_, 1);
    return frame.at(point.number, std::min(point.value.value_or(0), frame.y_high));
}

bool AttemptChart::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const AttemptPoint* point = point_near(help->pos())) {
            QToolTip::showText(help->globalPos(), point->tip, this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QWidget::event(event);
}

}  // namespace fulcrum::ui

#include "moc_attempt_chart.cpp"
