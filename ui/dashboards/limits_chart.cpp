// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/limits_chart.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString limits_words(const char* source) {
    return QCoreApplication::translate("fulcrum::ui::LimitsChart", source);
}

QColor set_colour(std::size_t set) {
    const Palette& p = colours();
    const QColor by_set[] = {p.accent, p.warning, p.good, p.bad};
    return by_set[set % 4];
}

struct Span {
    double low = 0, high = 1;
};

/// From 0, or from where the values begin where that is far from 0, to a little beyond the limits and nearly
/// all values; what lies further is drawn at the end.
Span span_of(const GateLimits& gate) {
    std::vector<double> places;
    for (const auto& limit : gate.limits)
        if (limit) places.push_back(*limit);
    if (!gate.values.empty()) {
        std::vector<double> sorted = gate.values;
        std::sort(sorted.begin(), sorted.end());
        places.push_back(sorted[sorted.size() / 20]);
        places.push_back(sorted[(sorted.size() - 1) * 19 / 20]);
    }
    if (places.empty()) return {};
    const auto [least, most] = std::minmax_element(places.begin(), places.end());
    const double room = *most > *least ? 0.2 * (*most - *least) : std::max(0.2 * std::abs(*most), 0.5);
    Span span{*least - room, *most + room};
    if (*least >= 0 && *least < 0.4 * *most) span.low = 0;
    if (*least >= 0) span.low = std::max(span.low, 0.0);
    return span;
}

double density(const GroupSpread& group, double x) {
    const double z = (x - group.mean) / group.deviation;
    return std::exp(-0.5 * z * z) / group.deviation;
}

}  // namespace

QString set_letter(std::size_t set) {
    return QString(QChar('A' + static_cast<int>(set % 26)));
}

LimitsChart::LimitsChart(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("limits_chart"));
    setAccessibleName(
        limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Limits of each set, gate by gate")));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

double LimitsChart::row_height() const {
    return 3.4 * fontMetrics().height();
}

QSize LimitsChart::sizeHint() const {
    return {520, static_cast<int>(static_cast<double>(gates_.size()) * row_height()) + 4};
}

void LimitsChart::show_gates(std::vector<GateLimits> gates) {
    gates_ = std::move(gates);
    QStringList lines;
    for (const GateLimits& gate : gates_) {
        QStringList limits;
        for (std::size_t k = 0; k < gate.limits.size(); ++k)
            limits << set_letter(k) + QLatin1Char(' ') +
                          figure_with_unit(gate.limits[k], gate.unit.toStdString());
        lines << gate.name + QStringLiteral(": ") + limits.join(QStringLiteral(", "));
    }
    setAccessibleDescription(lines.join(QStringLiteral("; ")));
    setToolTip(lines.join(QLatin1Char('\n')));
    updateGeometry();
    update();
    values_changed();
}

ChartTable LimitsChart::table() const {
    ChartTable table;
    for (const char* title : {QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Gate"),
                              QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Limit of the set or attempt"),
                              QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Value"),
                              QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Unit")})
        table.columns.push_back({limits_words(title)});
    const QString limit = limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "limit of set %1")),
                  attempt = limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "attempt"));
    for (const GateLimits& gate : gates_) {
        const auto add = [&](const QString& of, const std::optional<double>& value) {
            table.rows.push_back({{ChartCell::words(gate.name), ChartCell::words(of), ChartCell::value(value),
                                   ChartCell::words(unit_text(plain(gate.unit)))},
                                  {}});
        };
        for (std::size_t k = 0; k < gate.limits.size(); ++k) add(limit.arg(set_letter(k)), gate.limits[k]);
        for (const double value : gate.values) add(attempt, value);
    }
    return table;
}

void LimitsChart::paint_gate(QPainter& painter, const GateLimits& gate, const QRectF& room) const {
    const Palette& p = colours();
    const double line = fontMetrics().height(), middle = room.top() + 2.35 * line;
    const Span span = span_of(gate);
    painter.setPen(p.text);
    painter.drawText(
        QRectF(room.left(), room.top(), 0.72 * room.width(), line), Qt::AlignVCenter,
        fontMetrics().elidedText(gate.name, Qt::ElideRight, static_cast<int>(0.72 * room.width())));
    painter.setPen(p.muted);
    painter.drawText(QRectF(room.left(), room.top(), room.width(), line), Qt::AlignRight | Qt::AlignVCenter,
                     (gate.higher_is_better
                          ? limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "at least; %1 to %2"))
                          : limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "at most; %1 to %2")))
                         .arg(figure(span.low), figure_with_unit(span.high, gate.unit.toStdString())));
    painter.setPen(QPen(p.line, 2));
    painter.drawLine(QPointF(room.left(), middle), QPointF(room.right(), middle));
    const auto x_of = [&](double value) {
        return room.left() + room.width() * std::clamp((value - span.low) / (span.high - span.low), 0.0, 1.0);
    };
    painter.setPen(Qt::NoPen);
    QColor dot = p.muted;
    dot.setAlphaF(0.45);
    painter.setBrush(dot);
    for (std::size_t i = 0; i < gate.values.size(); ++i) {
        // Spread over five heights in a fixed order, so that equal values do not cover each other.
        const double y = middle + (static_cast<double>(i * 3 % 5) - 2) * 0.14 * line;
        painter.drawEllipse(QPointF(x_of(gate.values[i]), y), 2.4, 2.4);
    }
    std::vector<std::pair<double, std::size_t>> lines;  // by place: letters stand in the order of their lines
    for (std::size_t k = 0; k < gate.limits.size(); ++k)
        if (gate.limits[k]) lines.emplace_back(x_of(*gate.limits[k]), k);
    std::sort(lines.begin(), lines.end());
    double next = room.left();
    for (const auto& [x, k] : lines) {
        painter.setPen(QPen(set_colour(k), 2.4));
        painter.drawLine(QPointF(x, middle - 0.5 * line), QPointF(x, middle + 0.5 * line));
        const double letter = std::max(x, next);
        painter.drawText(QRectF(letter - line, middle - 1.45 * line, 2 * line, line), Qt::AlignCenter,
                         set_letter(k));
        next = letter + 0.8 * line;
    }
}

void LimitsChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    double y = 2;
    for (const GateLimits& gate : gates_) {
        paint_gate(painter, gate, QRectF(6, y, width() - 12, row_height()));
        y += row_height();
    }
}

GroupsChart::GroupsChart(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("groups_chart"));
    setAccessibleName(limits_words(
        QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Experts and trainees, and the mark between them")));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void GroupsChart::show_groups(std::optional<GroupCurves> groups) {
    groups_ = std::move(groups);
    update();
    values_changed();
}

ChartTable GroupsChart::table() const {
    ChartTable table;
    if (!groups_) return table;
    const QString unit = unit_text(plain(groups_->unit));
    const bool logarithmic = groups_->logarithmic;
    table.columns = {
        {limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Group"))},
        {logarithmic ? limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Geometric mean, or mark"))
                     : limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Mean, or mark")),
         unit},
        {logarithmic
             ? limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Geometric standard deviation"))
             : limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "Standard deviation")),
         logarithmic ? QString() : unit}};
    const auto value_of = [&](double x) { return logarithmic ? std::exp(x) : x; };
    const auto add = [&](const QString& group, double place, std::optional<double> deviation) {
        table.rows.push_back(
            {{ChartCell::words(group), ChartCell::value(value_of(place)), ChartCell::value(deviation)}, {}});
    };
    add(limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "experts of the set")),
        groups_->experts.mean, value_of(groups_->experts.deviation));
    add(limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "attempts here")), groups_->others.mean,
        value_of(groups_->others.deviation));
    if (groups_->mark)
        add(limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "mark between them")),
            groups_->mark->value, std::nullopt);
    return table;
}

void GroupsChart::paintEvent(QPaintEvent*) {
    if (!groups_) return;
    const Palette& p = colours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const GroupSpread groups[] = {groups_->experts, groups_->others};
    double low = groups[0].mean, high = low, top = 0;
    for (const GroupSpread& group : groups) {
        low = std::min(low, group.mean - 3 * group.deviation);
        high = std::max(high, group.mean + 3 * group.deviation);
        top = std::max(top, density(group, group.mean));
    }
    const double line = fontMetrics().height();
    const QRectF plot(8, line + 6, width() - 16, height() - 2.4 * line - 10);
    const auto x_of = [&](double x) { return plot.left() + plot.width() * (x - low) / (high - low); };
    const auto value_of = [&](double x) { return groups_->logarithmic ? std::exp(x) : x; };
    const QColor colour[] = {p.good, p.accent};
    const QString names[] = {
        limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "experts of the set")),
        limits_words(QT_TRANSLATE_NOOP("fulcrum::ui::LimitsChart", "attempts here"))};
    painter.setPen(QPen(p.line, 1));
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    for (int g = 0; g < 2; ++g) {
        QPainterPath path;
        for (int i = 0; i <= 160; ++i) {
            const double x = low + (high - low) * i / 160;
            const QPointF at(x_of(x), plot.bottom() - plot.height() * density(groups[g], x) / top);
            i == 0 ? path.moveTo(at) : path.lineTo(at);
        }
        QPen pen(colour[g], 2.2);
        if (g == 1) pen.setDashPattern({5, 3});
        painter.setPen(pen);
        painter.drawPath(path);
        painter.drawText(QRectF(plot.left(), 0, plot.width(), line), g == 0 ? Qt::AlignLeft : Qt::AlignRight,
                         names[g]);
    }
    const auto mark = [&](double x, const QColor& ink, Qt::PenStyle style) {
        painter.setPen(QPen(ink, 1.6, style));
        painter.drawLine(QPointF(x_of(x), plot.top()), QPointF(x_of(x), plot.bottom()));
        painter.drawText(QRectF(x_of(x) - 70, plot.bottom() + 3, 140, line), Qt::AlignHCenter,
                         figure_with_unit(value_of(x), groups_->unit.toStdString()));
    };
    if (groups_->mark) mark(groups_->mark->value, p.text, Qt::SolidLine);
}

}  // namespace fulcrum::ui
