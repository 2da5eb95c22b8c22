// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/time_chart.h"

#include <QAreaSeries>
#include <QChart>
#include <QGraphicsLayout>
#include <QHelpEvent>
#include <QLegend>
#include <QLegendMarker>
#include <QLineSeries>
#include <QMouseEvent>
#include <QToolTip>
#include <QValueAxis>
#include <QWheelEvent>
#include <cmath>

#include "ui/language/language.h"
#include "ui/style/announce.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

using QtCharts::QAreaSeries;
using QtCharts::QChart;
using QtCharts::QLineSeries;
using QtCharts::QValueAxis;

TimeChart::TimeChart(const QString& y_title, QWidget* parent)
    : QChartView(parent), x_axis_(new QValueAxis), y_axis_(new QValueAxis) {
    setFocusPolicy(Qt::StrongFocus);
    setRenderHint(QPainter::Antialiasing);
    setMouseTracking(true);
    setAccessibleName(y_title);
    setToolTip(key_words());
    setFrameShape(QFrame::NoFrame);
    QChart* shown = chart();
    shown->setAnimationOptions(QChart::NoAnimation);
    shown->setMargins(QMargins(2, 2, 8, 2));
    shown->setBackgroundRoundness(0);
    shown->addAxis(x_axis_, Qt::AlignBottom);
    shown->addAxis(y_axis_, Qt::AlignLeft);
    shown->legend()->setAlignment(Qt::AlignTop);
    x_axis_->setTitleText(tr("time (s)"));
    y_axis_->setTitleText(y_title);
    y_axis_->setTickCount(4);
    x_axis_->setTickInterval(1000);  // before the type: the axis divides by it
    x_axis_->setTickType(QValueAxis::TicksDynamic);
    x_axis_->setTickAnchor(0);
    y_axis_->setLabelFormat(QStringLiteral("%g"));
    restyle();
}

void TimeChart::restyle() {
    QChart* shown = chart();
    const Palette& p = colours();
    shown->setBackgroundBrush(p.card);
    shown->setPlotAreaBackgroundVisible(false);
    shown->legend()->setLabelColor(p.text);
    for (QValueAxis* axis : {x_axis_, y_axis_}) {
        axis->setLabelsColor(p.muted);
        axis->setTitleBrush(p.muted);
        axis->setGridLineColor(p.line);
        axis->setLinePenColor(p.line);
    }
    for (Series& series : series_) series.line->setPen(QPen(p.*series.colour, 1.6, series.pen));
    for (const Band& band : bands_) {
        QColor faint = p.*band.colour;
        faint.setAlpha(70);
        for (const BandPart& part : band.parts) {
            part.area->setBrush(faint);
            part.area->setPen(Qt::NoPen);
            part.middle->setPen(QPen(p.*band.colour, 1.4, Qt::DotLine));
        }
    }
    setBackgroundBrush(p.card);
}

void TimeChart::changeEvent(QEvent* event) {
    QChartView::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange) restyle();
}

void TimeChart::clear() {
    for (Series& series : series_) {
        chart()->removeSeries(series.line);
        delete series.line;
    }
    series_.clear();
    for (const Band& band : bands_) {
        for (const BandPart& part : band.parts) {
            chart()->removeSeries(part.area);
            chart()->removeSeries(part.middle);
            delete part.area;
            delete part.middle;
        }
    }
    bands_.clear();
    selected_from_ = selected_to_ = 0;
    steps_.clear();
    lanes_.clear();
    limits_.clear();
    marks_.clear();
    cursor_ = -1;
    begin_ = end_ = 0;
}

void TimeChart::add_series(const QString& name, QColor Palette::*colour, Qt::PenStyle pen,
                           std::shared_ptr<const MinMaxPyramid> samples) {
    auto* line = new QLineSeries;
    line->setName(name);
    line->setPen(QPen(colours().*colour, 1.6, pen));
    chart()->addSeries(line);
    line->attachAxis(x_axis_);
    line->attachAxis(y_axis_);
    series_.push_back({line, colour, pen, std::move(samples), {}});
}

void TimeChart::add_band(const QString& name, QColor Palette::*colour, const std::vector<ChartBand>& band) {
    Band added;
    added.name = name;
    added.colour = colour;
    added.data = band;
    for (std::size_t i = 0; i < band.size(); ++i) {
        added.highest = std::max(added.highest, band[i].high);
        added.last = band[i].time;
        if (i == 0) continue;
        const double step = band[i].time - band[i - 1].time;
        added.step = i == 1 ? step : std::min(added.step, step);
    }
    for (std::size_t from = 0, to = 0; from < band.size(); from = to) {
        to = from + 1;
        while (to < band.size() && added.joins(band[to - 1], band[to])) ++to;
        added.parts.push_back(make_part(added, from, to));
    }
    bands_.push_back(std::move(added));
    restyle();
}

TimeChart::BandPart TimeChart::make_part(const Band& band, std::size_t from, std::size_t to) {
    auto* low = new QLineSeries;
    auto* high = new QLineSeries;
    const BandPart part{new QAreaSeries(high, low), new QLineSeries};
    low->setParent(part.area);
    high->setParent(part.area);
    const auto append = [&](double time, const ChartBand& at) {
        low->append(time, at.low);
        high->append(time, at.high);
        part.middle->append(time, at.middle);
    };
    for (std::size_t i = from; i < to; ++i) append(band.data[i].time, band.data[i]);
    if (to == from + 1) {  // a point alone has no width
        low->clear();
        high->clear();
        part.middle->clear();
        const ChartBand& alone = band.data[from];
        append(alone.time - 0.5 * band.step, alone);
        append(alone.time + 0.5 * band.step, alone);
    }
    part.area->setName(band.name);
    for (QtCharts::QAbstractSeries* one :
         std::initializer_list<QtCharts::QAbstractSeries*>{part.area, part.middle}) {
        chart()->addSeries(one);
        one->attachAxis(x_axis_);
        one->attachAxis(y_axis_);
        if (one == part.area && from == 0) continue;  // the legend names the band once
        for (QtCharts::QLegendMarker* marker : chart()->legend()->markers(one)) marker->setVisible(false);
    }
    return part;
}

void TimeChart::set_selection(double from, double to) {
    selected_from_ = from;
    selected_to_ = to;
    viewport()->update();
}

void TimeChart::add_limit(const QString& name, double value) {
    limits_.emplace_back(name, value);
}

void TimeChart::set_steps(const QString& name, QColor Palette::*colour, std::vector<ChartStep> steps) {
    steps_name_ = name;
    steps_colour_ = colour;
    steps_ = std::move(steps);
    viewport()->update();
}

void TimeChart::add_lane(const QString& name, QColor Palette::*colour, std::vector<ChartSpan> spans) {
    lanes_.push_back({name, colour, std::move(spans)});
    viewport()->update();
}

void TimeChart::set_marks(std::vector<ChartMark> marks) {
    marks_ = std::move(marks);
    viewport()->update();
}

void TimeChart::set_cursor(double time) {
    cursor_ = time;
    viewport()->update();
}

void TimeChart::show_all() {
    first_ = begin_;
    last_ = end_;
    double low = 0, high = 0;
    for (const Series& series : series_) {
        last_ = std::max(last_, series.data->last_x());
        low = std::min(low, series.data->lowest());
        high = std::max(high, series.data->highest());
    }
    for (const Band& band : bands_) {
        last_ = std::max(last_, band.last);
        high = std::max(high, band.highest);
    }
    for (const ChartStep& step : steps_) {
        last_ = std::max(last_, step.to);
        low = std::min(low, step.value);
        high = std::max(high, step.value);
    }
    for (const auto& [name, value] : limits_) {
        if (value < 4 * high) high = std::max(high, value);
    }
    if (last_ <= first_) last_ = first_ + 1;
    // Lanes alone have no values.
    const bool values = !series_.empty() || !bands_.empty() || !steps_.empty();
    y_axis_->setLabelsVisible(values && compact_left_ == 0);
    y_axis_->setGridLineVisible(values);
    if (high <= low) high = low + 1;
    // The lanes have the upper half.
    y_axis_->setRange(low, low + (high - low) * (lanes_.empty() ? 1.12 : 2.2));
    y_axis_->applyNiceNumbers();
    show_range(first_, last_);
}

double tick_interval(double span) {
    const double least = span / 8;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * power >= least * (1 - 1e-9)) return step * power;
    }
    return 10 * power;
}

void TimeChart::show_range(double from, double to) {
    const double span = std::clamp(to - from, 0.05, std::max(last_ - first_, 0.05));
    from = std::clamp(from, first_, std::max(first_, last_ - span));
    // The axis lays its ticks out after each change: never the short interval over the long range.
    const double interval = tick_interval(span);
    const bool longer = interval > x_axis_->tickInterval();
    if (longer) x_axis_->setTickInterval(interval);
    x_axis_->setRange(from, from + span);
    if (!longer) x_axis_->setTickInterval(interval);
    const QString format = interval < 0.1 ? QStringLiteral("%.2f")
                           : interval < 1 ? QStringLiteral("%.1f")
                                          : QStringLiteral("%.0f");
    // The axis lays the chart out again for each format that it is given, also for the one that it has.
    if (x_axis_->labelFormat() != format) x_axis_->setLabelFormat(format);
    refresh();
}

std::size_t TimeChart::points_wanted() const {
    // A bucket a pixel's column keeps its lowest, its highest and one more; before the first layout the width
    // is unknown.
    const double columns = chart()->plotArea().width() * devicePixelRatioF();
    if (columns < 100) return chart_point_limit;
    return std::min(chart_point_limit, static_cast<std::size_t>(3 * columns) + 2);
}

void TimeChart::resizeEvent(QResizeEvent* event) {
    const std::size_t before = points_wanted();
    QChartView::resizeEvent(event);
    place_plot();
    if (points_wanted() != before) refresh();
}

void TimeChart::refresh() {
    for (Series& series : series_)
        series.lines = series.data->lines(x_axis_->min(), x_axis_->max(), points_wanted());
    describe();
    viewport()->update();
    emit points_changed();
}

double TimeChart::time_at(const QPoint& position) const {
    // By the axis: QChart knows the values of series alone, and there may be none.
    const QRectF area = chart()->plotArea();
    return x_axis_->min() + (mapToScene(position).x() - area.left()) * (x_axis_->max() - x_axis_->min()) /
                                std::max(area.width(), 1.0);
}

double TimeChart::x_of(double time) const {
    const QRectF area = chart()->plotArea();
    return area.left() +
           area.width() * (time - x_axis_->min()) / std::max(x_axis_->max() - x_axis_->min(), 1e-9);
}

void TimeChart::zoom(double factor, double around) {
    const double from = x_axis_->min(), to = x_axis_->max();
    choose_range(around - (around - from) * factor, around + (to - around) * factor);
}

void TimeChart::choose_range(double from, double to) {
    show_range(from, to);
    emit range_changed(first_shown(), last_shown());
}

void TimeChart::choose_all() {
    show_all();
    emit range_changed(first_shown(), last_shown());
}

void TimeChart::set_y_title(const QString& title) {
    y_axis_->setTitleText(title);
}

void TimeChart::show_names(bool shown) {
    chart()->legend()->setVisible(shown);
}

void TimeChart::show_time_title(bool shown) {
    x_axis_->setTitleVisible(shown);
}

void TimeChart::show_time_axis(bool shown) {
    x_axis_->setTitleVisible(shown);
    x_axis_->setLabelsVisible(shown);
    place_plot();
}

void TimeChart::set_compact(int left) {
    compact_left_ = left;
    y_axis_->setTitleVisible(false);
    y_axis_->setLabelsVisible(false);
    place_plot();
}

void TimeChart::place_plot() {
    if (compact_left_ == 0) return;
    const double line = fontMetrics().height();
    const double top = 16, right = 14, bottom = x_axis_->labelsVisible() ? 3 * line : 0.6 * line;
    chart()->setPlotArea(QRectF(compact_left_, top, std::max(1.0, width() - compact_left_ - right),
                                std::max(1.0, height() - top - bottom)));
    // Qt Charts moves the series at once, axes and grid only when the chart is laid out the next time.
    chart()->layout()->invalidate();
}

double TimeChart::first_shown() const {
    return x_axis_->min();
}

double TimeChart::last_shown() const {
    return x_axis_->max();
}

void TimeChart::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    if (notches != 0) zoom(std::pow(0.8, notches), time_at(event->position().toPoint()));
    event->accept();
}

void TimeChart::mousePressEvent(QMouseEvent* event) {
    pressed_ = event->button() == Qt::LeftButton;
    dragged_ = false;
    selecting_ = pressed_ && selects_ && (event->modifiers() & Qt::ShiftModifier) != 0;
    pressed_at_ = event->pos();
    pressed_from_ = x_axis_->min();
    pressed_to_ = x_axis_->max();
    setFocus(Qt::MouseFocusReason);
}

void TimeChart::mouseMoveEvent(QMouseEvent* event) {
    if (pressed_ && std::abs(event->pos().x() - pressed_at_.x()) > 4) {
        dragged_ = true;
        if (selecting_) {
            const double here = std::clamp(time_at(event->pos()), first_, last_),
                         start = std::clamp(time_at(pressed_at_), first_, last_);
            set_selection(std::min(here, start), std::max(here, start));
            return;
        }
        const double per_pixel = (pressed_to_ - pressed_from_) / std::max(chart()->plotArea().width(), 1.0);
        const double shift = (pressed_at_.x() - event->pos().x()) * per_pixel;
        choose_range(pressed_from_ + shift, pressed_to_ + shift);
    }
}

const ChartMark* TimeChart::mark_near(const QPoint& position) const {
    const ChartMark* nearest = nullptr;
    double best = 6;
    for (const ChartMark& mark : marks_) {
        const double distance = std::abs(x_of(mark.time) - position.x()) - (mark.severe ? 2 : 0);
        if (distance < best) {
            best = distance;
            nearest = &mark;
        }
    }
    return nearest;
}

void TimeChart::mouseReleaseEvent(QMouseEvent* event) {
    if (pressed_ && !dragged_) {
        const ChartMark* mark =
            event->pos().y() < chart()->plotArea().top() + 6 ? mark_near(event->pos()) : nullptr;
        emit time_chosen(std::clamp(mark != nullptr ? mark->time : time_at(event->pos()), first_, last_));
    }
    if (pressed_ && dragged_ && selecting_ && selected_to_ > selected_from_)
        emit range_selected(selected_from_, selected_to_);
    pressed_ = false;
}

void TimeChart::mouseDoubleClickEvent(QMouseEvent* event) {
    choose_all();
    event->accept();
}

QString TimeChart::key_words() {
    return tr(
        "In a chart, ← and → move through time, Page Up and Page Down go from mark to mark, + and − "
        "zoom, and 0 shows everything.");
}

void TimeChart::choose_time(double time) {
    const double from = x_axis_->min(), to = x_axis_->max(), half = 0.5 * (to - from);
    if (time < from || time > to) choose_range(time - half, time + half);
    emit time_chosen(time);
}

bool TimeChart::go_to_mark(double now, bool ahead) {
    constexpr double same_moment = 1e-6;
    std::optional<double> time;
    for (const ChartMark& mark : marks_)
        if ((ahead ? mark.time > now + same_moment && mark.time < time.value_or(mark.time + 1)
                   : mark.time < now - same_moment && mark.time > time.value_or(mark.time - 1)))
            time = mark.time;
    if (!time) return false;
    QStringList words;
    for (const ChartMark& mark : marks_)
        if (std::abs(mark.time - *time) < same_moment) words << mark.text;
    const QString line = tr("%1 s: %2").arg(decimal(*time, 2)).arg(words.join(QStringLiteral("; ")));
    choose_time(*time);
    // As the tool tip under the mouse does.
    announce(this, line);
    QToolTip::showText(viewport()->mapToGlobal(mapFromScene(x_of(*time), chart()->plotArea().top())), line,
                       this);
    return true;
}

void TimeChart::keyPressEvent(QKeyEvent* event) {
    const double span = x_axis_->max() - x_axis_->min();
    const double now = cursor_ < 0 ? x_axis_->min() : cursor_;
    switch (event->key()) {
        case Qt::Key_Left:
            choose_time(std::max(first_, now - span / 100));
            break;
        case Qt::Key_Right:
            choose_time(std::min(last_, now + span / 100));
            break;
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
            if (!go_to_mark(now, event->key() == Qt::Key_PageDown)) QChartView::keyPressEvent(event);
            break;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            zoom(0.8, now);
            break;
        case Qt::Key_Minus:
            zoom(1.25, now);
            break;
        case Qt::Key_0:
            choose_all();
            break;
        default:
            QChartView::keyPressEvent(event);
    }
}

bool TimeChart::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const ChartMark* mark = mark_near(help->pos())) {
            QToolTip::showText(help->globalPos(), tr("%1 s: %2").arg(decimal(mark->time, 2)).arg(mark->text),
                               this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QChartView::viewportEvent(event);
}

}  // namespace fulcrum::ui

#include "moc_time_chart.cpp"
