// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/figure.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>

#include "ui/charts/time_chart.h"

namespace fulcrum::ui {

namespace {

/// Where a figure is painted, and with what.
struct FigurePainter {
    FigurePainter(QPainter& on, const QRectF& in, const Palette& palette, double one);
    double wide(const QString& words) const;
    QString fitted(const QString& words, double width) const;
    void write(const QRectF& place, int flags, const QString& words, const QColor& colour) const;
    void draw_line(const QPointF& from, const QPointF& to, const QColor& colour, double width,
                   Qt::PenStyle style = Qt::SolidLine) const;

    QPainter& painter;
    QRectF area;
    const Palette& p;
    double unit, line = 0;
};

FigurePainter::FigurePainter(QPainter& on, const QRectF& in, const Palette& palette, double one)
    : painter(on), area(in), p(palette), unit(one) {
    line = QFontMetricsF(painter.font(), painter.device()).height();
}

double FigurePainter::wide(const QString& words) const {
    return QFontMetricsF(painter.font(), painter.device()).horizontalAdvance(words);
}

QString FigurePainter::fitted(const QString& words, double width) const {
    return QFontMetricsF(painter.font(), painter.device()).elidedText(words, Qt::ElideRight, width);
}

void FigurePainter::write(const QRectF& place, int flags, const QString& words, const QColor& colour) const {
    painter.setPen(colour);
    painter.drawText(place, flags, words);
}

void FigurePainter::draw_line(const QPointF& from, const QPointF& to, const QColor& colour, double width,
                              Qt::PenStyle style) const {
    painter.setPen(QPen(colour, width * unit, style));
    painter.drawLine(from, to);
}

double nice_high(double highest) {
    const double step = tick_interval(std::max(highest, 1e-9));
    return step * std::ceil(highest / step - 1e-9);
}

/// Grid lines with their numbers at the left, from 0 to `high`, and the title above.
void figure_levels(const FigurePainter& to, const QRectF& plot, double high, bool share) {
    const double step = share ? 0.25 : std::max(1.0, tick_interval(high * 2));
    for (double level = 0; level <= high * (1 + 1e-9); level += step) {
        const double y = plot.bottom() - plot.height() * level / high;
        to.draw_line({plot.left(), y}, {plot.right(), y}, to.p.line, 1);
        const QString words =
            share ? QStringLiteral("%1 %").arg(qRound(100 * level)) : QString::number(qRound(level));
        to.write(QRectF(to.area.left(), y - to.line / 2, plot.left() - to.area.left() - 6 * to.unit, to.line),
                 Qt::AlignRight | Qt::AlignVCenter, words, to.p.muted);
    }
}

/// Numbers below the plot, and the title below them.
void figure_feet(const FigurePainter& to, const QRectF& plot, double high, const QString& title) {
    double step = std::max(1.0, tick_interval(high));
    while (plot.width() * step / high < 1.6 * to.wide(QString::number(qRound(high)))) step *= 2;
    for (double x = 0; x <= high * (1 + 1e-9); x += step) {
        const double at = plot.left() + plot.width() * x / high;
        to.draw_line({at, plot.bottom()}, {at, plot.bottom() + 4 * to.unit}, to.p.line, 1);
        to.write(QRectF(at - 50 * to.unit, plot.bottom() + 4 * to.unit, 100 * to.unit, to.line),
                 Qt::AlignHCenter, QString::number(qRound(x)), to.p.muted);
    }
    to.write(QRectF(plot.left(), plot.bottom() + 4 * to.unit + to.line, plot.width(), to.line),
             Qt::AlignHCenter, to.fitted(title, plot.width()), to.p.muted);
}

std::vector<FigureSpot> paint(const FigurePainter& to, const IntervalFigure& figure) {
    double label = 0, words = 0;
    for (const IntervalRow& row : figure.rows) {
        label = std::max(label, to.wide(row.label));
        words = std::max(words, to.wide(row.words));
    }
    label = std::min(label, 0.3 * to.area.width());
    words = std::min(words, 0.6 * to.area.width() - label);
    const double rows_high = to.area.height() - 1.4 * to.line;
    const double high =
        std::min(rows_high / std::max(1.0, static_cast<double>(figure.rows.size())), 2.4 * to.line);
    const QRectF plot(to.area.left() + label + 14 * to.unit, to.area.top(),
                      to.area.width() - label - words - 28 * to.unit,
                      high * static_cast<double>(figure.rows.size()));
    for (int quarter = 0; quarter <= 4; ++quarter) {
        const double x = plot.left() + plot.width() * quarter / 4;
        to.draw_line({x, plot.top()}, {x, plot.bottom()}, to.p.line, 1);
        if (quarter % 2 == 0 || plot.width() > 6 * to.wide(QStringLiteral("100 %")))
            to.write(QRectF(x - 60 * to.unit, plot.bottom() + 2 * to.unit, 120 * to.unit, to.line),
                     Qt::AlignHCenter, QStringLiteral("%1 %").arg(25 * quarter), to.p.muted);
    }
    std::vector<FigureSpot> spots;
    double y = plot.top();
    for (const IntervalRow& row : figure.rows) {
        const double middle = y + high / 2;
        to.write(QRectF(to.area.left(), y, label, high), Qt::AlignVCenter, to.fitted(row.label, label),
                 to.p.text);
        to.write(QRectF(plot.right() + 14 * to.unit, y, words, high), Qt::AlignRight | Qt::AlignVCenter,
                 to.fitted(row.words, words), to.p.muted);
        if (row.value) {
            const auto at = [&](double share) { return plot.left() + plot.width() * share; };
            const double end = 4 * to.unit;
            to.draw_line({at(row.low), middle}, {at(row.high), middle}, to.p.accent, 2);
            for (const double x : {at(row.low), at(row.high)})
                to.draw_line({x, middle - end}, {x, middle + end}, to.p.accent, 2);
            to.painter.setPen(QPen(to.p.card, 1.5 * to.unit));
            to.painter.setBrush(to.p.accent);
            to.painter.drawEllipse(QPointF(at(*row.value), middle), 6 * to.unit, 6 * to.unit);
        }
        spots.push_back({QRectF(to.area.left(), y, to.area.width(), high), row.key,
                         row.label + QStringLiteral(": ") + row.words});
        y += high;
    }
    return spots;
}

void fill_column(const FigurePainter& to, const QRectF& box, ColumnFill fill) {
    const QColor colour = fill == ColumnFill::bad       ? to.p.bad
                          : fill == ColumnFill::warning ? to.p.warning
                                                        : to.p.accent;
    QColor ground = colour;
    if (fill == ColumnFill::faint) ground.setAlphaF(0.3);
    to.painter.setPen(QPen(colour, to.unit));
    to.painter.setBrush(ground);
    to.painter.drawRect(box);
    if (fill != ColumnFill::bad && fill != ColumnFill::warning) return;
    // Hatched, so that a column that asks for something differs without its colour.
    to.painter.save();
    to.painter.setClipRect(box);
    const double step = (fill == ColumnFill::bad ? 6 : 10) * to.unit;
    for (double x = box.left() - box.height(); x < box.right(); x += step)
        to.draw_line({x, box.bottom()}, {x + box.height(), box.top()}, to.p.card, 1.4);
    to.painter.restore();
}

std::vector<FigureSpot> paint(const FigurePainter& to, const ColumnFigure& figure) {
    int highest = 1;
    double label = 0;
    for (const FigureColumn& column : figure.columns) {
        highest = std::max(highest, column.count);
        for (const QString& part : column.label.split(QLatin1Char('\n')))
            label = std::max(label, to.wide(part));
    }
    const double high = nice_high(highest), left = to.wide(QString::number(qRound(high))) + 10 * to.unit;
    const QRectF plot(to.area.left() + left, to.area.top() + 2.3 * to.line, to.area.width() - left,
                      to.area.height() - 4.6 * to.line);
    to.write(QRectF(to.area.left(), to.area.top(), to.area.width(), to.line), Qt::AlignLeft,
             to.fitted(figure.y_title, to.area.width()), to.p.muted);
    figure_levels(to, plot, high, false);
    const double each = plot.width() / std::max(1.0, static_cast<double>(figure.columns.size()));
    const int every = std::max(1, static_cast<int>(std::ceil((label + 4 * to.unit) / each)));
    std::vector<FigureSpot> spots;
    for (std::size_t c = 0; c < figure.columns.size(); ++c) {
        const FigureColumn& column = figure.columns[c];
        const double x = plot.left() + each * static_cast<double>(c),
                     tall = plot.height() * column.count / high;
        const QRectF box(x + 0.14 * each, plot.bottom() - tall, 0.72 * each, tall);
        if (column.count > 0) fill_column(to, box, column.fill);
        const double room = std::max(each, to.wide(QString::number(column.count)) + 2 * to.unit);
        to.write(QRectF(x + each / 2 - room / 2, box.top() - to.line, room, to.line), Qt::AlignHCenter,
                 QString::number(column.count), to.p.text);
        // The last label is always there; those before it as they have room.
        if ((figure.columns.size() - 1 - c) % static_cast<std::size_t>(every) == 0) {
            const double wide = each * every;
            to.write(QRectF(x + each / 2 - wide / 2, plot.bottom() + 3 * to.unit, wide, 2 * to.line),
                     Qt::AlignHCenter | Qt::AlignTop, column.label, to.p.muted);
        }
        spots.push_back(
            {QRectF(x, plot.top() - to.line, each, plot.height() + 3 * to.line), column.key, column.words});
    }
    return spots;
}

std::vector<FigureSpot> paint(const FigurePainter& to, const FunnelFigure& figure) {
    double label = 0, words = 0;
    for (const FunnelStep& step : figure.steps) {
        label = std::max(label, to.wide(step.label));
        words = std::max(words, to.wide(step.words));
    }
    label = std::min(label, 0.36 * to.area.width());
    words = std::min(words, 0.6 * to.area.width() - label);
    const double high =
        std::min(to.area.height() / std::max(1.0, static_cast<double>(figure.steps.size())), 2.6 * to.line);
    const QRectF room(to.area.left() + label + 10 * to.unit, to.area.top(),
                      to.area.width() - label - words - 20 * to.unit, to.area.height());
    std::vector<FigureSpot> spots;
    double y = room.top();
    for (const FunnelStep& step : figure.steps) {
        const double share = figure.all > 0 ? static_cast<double>(step.count) / figure.all : 0;
        const double wide = room.width() * share;
        to.write(QRectF(to.area.left(), y, label, high), Qt::AlignVCenter, to.fitted(step.label, label),
                 to.p.text);
        to.write(QRectF(room.right() + 10 * to.unit, y, words, high), Qt::AlignRight | Qt::AlignVCenter,
                 to.fitted(step.words, words), to.p.muted);
        const QRectF box(room.center().x() - wide / 2, y + 0.1 * high, wide, 0.8 * high);
        QColor fill = step.done ? to.p.good : to.p.accent;
        to.painter.setPen(QPen(fill, 1.5 * to.unit, step.done ? Qt::SolidLine : Qt::DashLine));
        if (!step.done) fill.setAlphaF(0.25);
        to.painter.setBrush(fill);
        if (step.count > 0)
            to.painter.drawRect(box);
        else
            to.draw_line({room.center().x(), box.top()}, {room.center().x(), box.bottom()}, to.p.line, 2);
        spots.push_back({QRectF(to.area.left(), y, to.area.width(), high), step.key,
                         step.label + QStringLiteral(": ") + step.words});
        y += high;
    }
    return spots;
}

/// Names in a line from the left with the sign that is painted for each.
void figure_legend(const FigurePainter& to,
                   const std::vector<std::pair<QString, std::function<void(QPointF)>>>& signs) {
    double x = to.area.left();
    double y = to.area.top();
    for (const auto& [name, sign] : signs) {
        const double wide = to.wide(name) + 30 * to.unit;
        if (x > to.area.left() && x + wide > to.area.right()) {
            x = to.area.left();
            y += to.line;
        }
        sign(QPointF(x + 9 * to.unit, y + to.line / 2));
        to.write(QRectF(x + 22 * to.unit, y, to.area.right() - x - 22 * to.unit, to.line), Qt::AlignVCenter,
                 to.fitted(name, to.area.right() - x - 22 * to.unit), to.p.text);
        x += wide + 10 * to.unit;
    }
}

void paint_dot(const FigurePainter& to, const QPointF& at, bool marked) {
    const double r = 5 * to.unit;
    to.painter.setPen(QPen(to.p.card, to.unit));
    to.painter.setBrush(marked ? to.p.bad : to.p.good);
    if (!marked) {
        to.painter.drawEllipse(at, r, r);
        return;
    }
    const QPointF corners[] = {at + QPointF(-1.2 * r, -r), at + QPointF(1.2 * r, -r),
                               at + QPointF(0, 1.2 * r)};
    to.painter.drawPolygon(corners, 3);
}

/// The free place for a dot that is nearest to where it belongs, within the plot: dots that belong to the
/// same place are next to each other, and none hides another.
QPointF free_place(const QPointF& wanted, const QRectF& plot, const std::vector<QPointF>& taken, double r) {
    const double top = std::min(plot.top(), wanted.y()), bottom = std::max(plot.bottom(), wanted.y());
    const double left = std::min(plot.left(), wanted.x()), right = std::max(plot.right(), wanted.x());
    for (int step = 0; step < 600; ++step) {
        const double turn = 2.399963 * step, distance = 0.6 * r * std::sqrt(step);  // a sunflower's spiral
        const QPointF place = wanted + distance * QPointF(std::cos(turn), std::sin(turn));
        if (place.y() < top || place.y() > bottom || place.x() < left || place.x() > right) continue;
        const bool free = std::none_of(taken.begin(), taken.end(), [&](const QPointF& other) {
            return std::hypot(other.x() - place.x(), other.y() - place.y()) < 1.7 * r;
        });
        if (free) return place;
    }
    return wanted;
}

std::vector<FigureSpot> paint(const FigurePainter& to, const DotFigure& figure) {
    const double left =
        std::max(to.wide(QString::number(qRound(figure.y_high))), to.wide(QStringLiteral("00"))) +
        10 * to.unit;
    const QRectF plot(to.area.left() + left, to.area.top() + 3.2 * to.line,
                      to.area.width() - left - 8 * to.unit, to.area.height() - 5.4 * to.line);
    figure_legend(to, {{figure.dot_name, [&](QPointF at) { paint_dot(to, at, false); }},
                       {figure.marked_name, [&](QPointF at) { paint_dot(to, at, true); }},
                       {figure.line_name, [&](QPointF at) {
                            to.draw_line(at - QPointF(9 * to.unit, 0), at + QPointF(9 * to.unit, 0),
                                         to.p.limit, 1.6, Qt::DashLine);
                        }}});
    to.write(QRectF(to.area.left(), to.area.top() + 2 * to.line, to.area.width(), to.line), Qt::AlignLeft,
             to.fitted(figure.y_title, to.area.width()), to.p.muted);
    figure_levels(to, plot, figure.y_high, false);
    figure_feet(to, plot, figure.x_high, figure.x_title);
    const auto at = [&](double x, double y) {
        return QPointF(plot.left() + plot.width() * x / figure.x_high,
                       plot.bottom() - plot.height() * y / figure.y_high);
    };
    to.painter.save();
    to.painter.setClipRect(plot.adjusted(0, -2 * to.unit, 0, 2 * to.unit));
    to.draw_line(at(0, 0), at(figure.line_x, figure.line_y), to.p.limit, 1.6, Qt::DashLine);
    to.draw_line(at(figure.line_x, figure.line_y), at(figure.x_high + figure.line_x, figure.line_y),
                 to.p.limit, 1.6, Qt::DashLine);
    to.painter.restore();
    std::vector<FigureSpot> spots;
    std::vector<QPointF> taken;
    const double r = 6 * to.unit;
    for (const FigureDot& dot : figure.dots) {
        const QPointF place = free_place(at(dot.x, dot.y), plot, taken, r);
        taken.push_back(place);
        paint_dot(to, place, dot.marked);
        spots.push_back({QRectF(place.x() - r, place.y() - r, 2 * r, 2 * r), dot.key, dot.words});
    }
    return spots;
}

std::vector<FigureSpot> paint(const FigurePainter& to, const StepFigure& figure) {
    const double left = to.wide(QStringLiteral("100 %")) + 10 * to.unit;
    const QRectF plot(to.area.left() + left, to.area.top() + 2.4 * to.line,
                      to.area.width() - left - 8 * to.unit, to.area.height() - 4.7 * to.line);
    const QColor colours[] = {to.p.accent, to.p.good, to.p.limit};
    const Qt::PenStyle styles[] = {Qt::DashLine, Qt::SolidLine, Qt::DotLine};
    std::vector<std::pair<QString, std::function<void(QPointF)>>> signs;
    for (std::size_t c = 0; c < figure.curves.size(); ++c)
        signs.emplace_back(figure.curves[c].name, [&, c](QPointF at) {
            to.draw_line(at - QPointF(9 * to.unit, 0), at + QPointF(9 * to.unit, 0), colours[c % 3], 2.2,
                         styles[c % 3]);
        });
    figure_legend(to, signs);
    figure_levels(to, plot, 1, true);
    figure_feet(to, plot, figure.x_high, figure.x_title);
    const auto at = [&](double x, double share) {
        return QPointF(plot.left() + plot.width() * x / figure.x_high, plot.bottom() - plot.height() * share);
    };
    std::vector<FigureSpot> spots;
    for (std::size_t c = 0; c < figure.curves.size(); ++c) {
        const StepCurve& curve = figure.curves[c];
        QPolygonF line, low, high;
        for (QPolygonF* one : {&line, &low, &high}) *one << at(0, 0);
        const auto add = [&](QPolygonF& to_line, double x, double share, double before) {
            to_line << at(x, before) << at(x, share);
        };
        CurveStep before;
        before.high = 0;
        for (const CurveStep& step : curve.steps) {
            add(line, step.x, step.value, before.value);
            add(low, step.x, step.low, before.low);
            add(high, step.x, step.high, before.high);
            before = step;
        }
        line << at(figure.x_high, before.value);
        low << at(figure.x_high, before.low);
        high << at(figure.x_high, before.high);
        QPolygonF band = high;
        for (auto point = low.crbegin(); point != low.crend(); ++point) band << *point;
        QColor faint = colours[c % 3];
        faint.setAlphaF(0.16);
        to.painter.setPen(Qt::NoPen);
        to.painter.setBrush(faint);
        to.painter.drawPolygon(band);
        to.painter.setBrush(Qt::NoBrush);
        to.painter.setPen(QPen(colours[c % 3], 2.2 * to.unit, styles[c % 3]));
        to.painter.drawPolyline(line);
        // The end of each curve can be chosen: the people who are not there yet.
        const QPointF end = at(figure.x_high, before.value);
        const double r = 9 * to.unit;
        to.painter.setPen(QPen(colours[c % 3], 2 * to.unit));
        to.painter.setBrush(to.p.card);
        to.painter.drawEllipse(end - QPointF(r / 2, 0), r / 2, r / 2);
        spots.push_back({QRectF(end.x() - 2 * r, end.y() - r, 2.5 * r, 2 * r), curve.key, curve.words});
    }
    return spots;
}

}  // namespace

std::vector<FigureSpot> paint_figure(QPainter& painter, const QRectF& area, const Figure& figure,
                                     const Palette& palette, double unit) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const FigurePainter to(painter, area, palette, unit);
    std::vector<FigureSpot> spots = std::visit([&](const auto& one) { return paint(to, one); }, figure);
    painter.restore();
    return spots;
}

double figure_lines(const Figure& figure) {
    constexpr double usual = 13;
    if (is_empty(figure)) return usual;
    if (const auto* rows = std::get_if<IntervalFigure>(&figure))
        return 1.4 + 1.8 * static_cast<double>(rows->rows.size());
    if (const auto* steps = std::get_if<FunnelFigure>(&figure))
        return 1.9 * static_cast<double>(steps->steps.size());
    return usual;
}

bool is_empty(const Figure& figure) {
    if (const auto* rows = std::get_if<IntervalFigure>(&figure)) return rows->rows.empty();
    if (const auto* columns = std::get_if<ColumnFigure>(&figure)) return columns->columns.empty();
    if (const auto* steps = std::get_if<FunnelFigure>(&figure)) return steps->steps.empty();
    if (const auto* dots = std::get_if<DotFigure>(&figure)) return dots->dots.empty();
    return std::get<StepFigure>(figure).curves.empty();
}

}  // namespace fulcrum::ui
