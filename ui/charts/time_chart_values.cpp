// SPDX-License-Identifier: GPL-3.0-or-later
// What a TimeChart says of its values: peaks in view, and the columns of its table.
#include <QLineSeries>
#include <QPainter>
#include <QValueAxis>
#include <algorithm>

#include "ui/charts/time_chart.h"
#include "ui/language/language.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

void TimeChart::describe() {
    QStringList peaks;
    for (std::size_t s = 0; peaks_shown_ && s < series_.size(); ++s)
        if (const auto peak = peak_of(s))
            peaks << tr("%1: highest %2 at %3 s")
                         .arg(series_[s].line->name(), figure_with_unit(peak->y, plain(unit_)),
                              decimal(peak->x, 2));
    if (!peaks.isEmpty()) peaks << key_words();
    setAccessibleDescription(peaks.join(QStringLiteral("; ")));
}

/// A ring at the highest sample of each series, and its value where it hides no other.
void TimeChart::draw_peaks(QPainter& painter, const QRectF& area) const {
    const Palette& p = colours();
    std::vector<QRectF> taken;
    for (std::size_t s = 0; s < series_.size(); ++s) {
        const auto peak = peak_of(s);
        if (!peak) continue;
        const double share = (peak->y - y_axis_->min()) / std::max(y_axis_->max() - y_axis_->min(), 1e-9);
        const QPointF at(x_of(peak->x), area.bottom() - area.height() * share);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(p.*series_[s].colour, 2));
        painter.drawEllipse(at, 4, 4);
        const QString words = figure_with_unit(peak->y, plain(unit_));
        const QFontMetricsF metrics(painter.font());
        QRectF place(at.x() + 8, at.y() - metrics.height() / 2, metrics.horizontalAdvance(words) + 6,
                     metrics.height());
        if (place.right() > area.right()) place.moveRight(at.x() - 8);
        place.moveTop(
            std::clamp(place.top(), area.top(), std::max(area.top(), area.bottom() - place.height())));
        for (const QRectF& other : taken)
            if (place.intersects(other))
                place.moveTop(other.bottom() + 1 + place.height() < area.bottom()
                                  ? other.bottom() + 1
                                  : other.top() - 1 - place.height());
        taken.push_back(place);
        QColor ground = p.card;
        ground.setAlphaF(0.85);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ground);
        painter.drawRoundedRect(place, 3, 3);
        painter.setPen(p.text);
        painter.drawText(place, Qt::AlignCenter, words);
    }
}

std::optional<ChartPoint> TimeChart::peak_of(std::size_t series) const {
    std::optional<ChartPoint> peak;
    // Of the samples in view the highest one is always among the points that are drawn; one point beyond each
    // end is drawn too.
    for (const ChartLine& line : series_[series].lines)
        for (const ChartPoint& point : line.points)
            if (point.x >= x_axis_->min() && point.x <= x_axis_->max() && point.y > 0 &&
                (!peak || point.y > peak->y))
                peak = point;
    return peak;
}

std::vector<double> TimeChart::times_drawn() const {
    const auto in_view = [this](double time) { return time >= x_axis_->min() && time <= x_axis_->max(); };
    std::vector<double> times;
    for (const Series& series : series_) {
        for (const ChartLine& line : series.lines) {
            if (line.gap && in_view(*line.gap)) times.push_back(*line.gap);
            for (const ChartPoint& point : line.points)
                if (in_view(point.x)) times.push_back(point.x);
        }
    }
    const auto add_ends = [&](const auto& spans) {
        for (const auto& span : spans)
            for (const double end : {span.from, span.to})
                if (in_view(end)) times.push_back(end);
    };
    add_ends(steps_);
    for (const Lane& lane : lanes_) add_ends(lane.spans);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

std::vector<ChartColumn> TimeChart::columns() const {
    std::vector<ChartColumn> columns;
    for (const Series& series : series_) columns.push_back({series.line->name(), unit_});
    for (const Band& band : bands_)
        for (const QString& part : {tr("%1, lower quarter"), tr("%1, middle"), tr("%1, upper quarter")})
            columns.push_back({part.arg(band.name), unit_});
    if (!steps_.empty()) columns.push_back({steps_name_, unit_});
    for (const Lane& lane : lanes_) columns.push_back({lane.name});
    return columns;
}

void TimeChart::add_values(double time, std::vector<ChartCell>& cells) const {
    for (const Series& series : series_) cells.push_back(ChartCell::value(series.data->at(time)));
    for (const Band& band : bands_) {
        const auto next = std::upper_bound(band.data.begin(), band.data.end(), time,
                                           [](double at, const ChartBand& one) { return at < one.time; });
        const bool there =
            next != band.data.begin() && next != band.data.end() && band.joins(*(next - 1), *next);
        const auto between = [&](double ChartBand::*value) -> std::optional<double> {
            if (!there) return std::nullopt;
            const ChartBand &before = *(next - 1), &after = *next;
            const double share = (time - before.time) / std::max(after.time - before.time, 1e-12);
            return before.*value + share * (after.*value - before.*value);
        };
        for (double ChartBand::*value : {&ChartBand::low, &ChartBand::middle, &ChartBand::high})
            cells.push_back(ChartCell::value(between(value)));
    }
    const auto at_time = [time](const auto& spans) {
        const auto found = std::find_if(spans.begin(), spans.end(), [time](const auto& span) {
            return span.from <= time && time <= span.to;
        });
        return found == spans.end() ? nullptr : &*found;
    };
    if (!steps_.empty()) {
        const ChartStep* const step = at_time(steps_);
        cells.push_back(
            ChartCell::value(step == nullptr ? std::nullopt : std::optional<double>(step->value)));
    }
    for (const Lane& lane : lanes_) cells.push_back(ChartCell::count(at_time(lane.spans) == nullptr ? 0 : 1));
}

void TimeChart::set_unit(const QString& unit) {
    unit_ = unit;
}

}  // namespace fulcrum::ui
