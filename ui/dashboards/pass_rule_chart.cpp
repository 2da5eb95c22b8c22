// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/pass_rule_chart.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/style/palette.h"

namespace fulcrum::ui {
namespace {

QString words(const char* source) {
    return QCoreApplication::translate("fulcrum::ui::PassRuleChart", source);
}

QColor colour_of(std::size_t trainee) {
    const Palette& p = colours();
    return trainee == 0 ? p.good : trainee == 1 ? p.accent : p.bad;
}

void paint_mark(QPainter& painter, const QPointF& at, std::size_t trainee, double half) {
    if (trainee == 0) {
        painter.drawEllipse(at, half, half);
    } else if (trainee == 1) {
        painter.drawRect(QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half));
    } else {
        const QPointF corners[] = {at + QPointF(-half, half), at + QPointF(half, half),
                                   at + QPointF(0, -half)};
        painter.drawPolygon(corners, 3);
    }
}

/// The plot inside of the chart, and where a point of a curve is in it.
struct Plot {
    QRectF area;
    QPointF point(double attempt, double chance) const {
        return {area.left() + area.width() * attempt / designer_attempts,
                area.bottom() - area.height() * chance};
    }
};

void paint_axes(QPainter& painter, const Plot& plot) {
    const Palette& p = colours();
    const double line = painter.fontMetrics().height();
    for (int share = 0; share <= 100; share += 25) {
        const double y = plot.point(0, share / 100.0).y();
        painter.setPen(QPen(p.line, 1));
        painter.drawLine(QPointF(plot.area.left(), y), QPointF(plot.area.right(), y));
        painter.setPen(p.muted);
        painter.drawText(QRectF(0, y - line / 2, plot.area.left() - 8, line),
                         Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("%1 %").arg(share));
    }
    for (int attempt = 0; attempt <= designer_attempts; attempt += 10) {
        const double x = plot.point(attempt, 0).x();
        painter.setPen(QPen(p.line, 1));
        painter.drawLine(QPointF(x, plot.area.bottom()), QPointF(x, plot.area.bottom() + 4));
        painter.setPen(p.muted);
        painter.drawText(QRectF(x - 30, plot.area.bottom() + 5, 60, line), Qt::AlignHCenter,
                         QString::number(attempt));
    }
    painter.drawText(QRectF(plot.area.left(), plot.area.bottom() + 5 + line, plot.area.width(), line),
                     Qt::AlignHCenter, words(QT_TRANSLATE_NOOP("fulcrum::ui::PassRuleChart", "attempts")));
}

void paint_curve(QPainter& painter, const Plot& plot, const std::vector<double>& curve, std::size_t trainee,
                 bool thin) {
    if (curve.empty()) return;
    QPainterPath path(plot.point(0, 0));
    for (std::size_t t = 0; t < curve.size(); ++t)
        path.lineTo(plot.point(static_cast<double>(t + 1), curve[t]));
    QPen pen(colour_of(trainee), thin ? 1.2 : 2.4);
    if (thin) pen.setDashPattern({4, 4});
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
    if (thin) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour_of(trainee));
    // Marks of different curves next to each other where the curves meet at 100 %.
    for (std::size_t t = 4 + 2 * trainee; t < curve.size(); t += 10)
        paint_mark(painter, plot.point(static_cast<double>(t + 1), curve[t]), trainee, 4.5);
}

/// The marks with what they stand for, in one line from the left; with large text, the shares alone.
void paint_legend(QPainter& painter, double left, double middle, double room) {
    const QString sentence = words(QT_TRANSLATE_NOOP("fulcrum::ui::PassRuleChart", "passes %1 %"));
    const bool fits = 3 * (painter.fontMetrics().horizontalAdvance(sentence) + 34) <= room;
    for (std::size_t k = 0; k < designer_trainees.size(); ++k) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour_of(k));
        paint_mark(painter, QPointF(left + 5, middle), k, 4.5);
        const QString name =
            (fits ? sentence : QStringLiteral("%1 %")).arg(qRound(100 * designer_trainees[k]));
        const double wide = painter.fontMetrics().horizontalAdvance(name),
                     line = painter.fontMetrics().height();
        painter.setPen(colours().text);
        painter.drawText(QRectF(left + 15, middle - line / 2, wide + 2, line), Qt::AlignVCenter, name);
        left += wide + 34;
    }
}

}  // namespace

PassRuleChart::PassRuleChart(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("pass_rule_chart"));
    setAccessibleName(words(QT_TRANSLATE_NOOP("fulcrum::ui::PassRuleChart",
                                              "Chance of being declared proficient, by number of attempts")));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PassRuleChart::show_curves(PassRuleCurves curves) {
    curves_ = std::move(curves);
    update();
    values_changed();
}

ChartTable PassRuleChart::table() const {
    ChartTable table;
    const QString percent = QStringLiteral("%");
    const QString tried = words(QT_TRANSLATE_NOOP("fulcrum::ui::PassRuleChart", "passes %1 %")),
                  in_force =
                      words(QT_TRANSLATE_NOOP("fulcrum::ui::PassRuleChart", "passes %1 %, rule in force"));
    table.columns.push_back({words(QT_TRANSLATE_NOOP("fulcrum::ui::PassRuleChart", "attempts"))});
    for (const double share : designer_trainees)
        table.columns.push_back({tried.arg(qRound(100 * share)), percent});
    for (const double share : designer_trainees)
        if (curves_.changed) table.columns.push_back({in_force.arg(qRound(100 * share)), percent});
    const auto add = [](ChartRow& row, const std::vector<double>& curve, std::size_t t) {
        row.cells.push_back(
            ChartCell::value(t < curve.size() ? std::optional<double>(100 * curve[t]) : std::nullopt));
    };
    for (std::size_t t = 0; t < static_cast<std::size_t>(designer_attempts); ++t) {
        ChartRow row{{ChartCell::count(static_cast<long long>(t) + 1)}};
        for (const auto& curve : curves_.tried) add(row, curve, t);
        for (const auto& curve : curves_.in_force)
            if (curves_.changed) add(row, curve, t);
        table.rows.push_back(std::move(row));
    }
    return table;
}

void PassRuleChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double line = painter.fontMetrics().height();
    const double left = painter.fontMetrics().horizontalAdvance(QStringLiteral("100 %")) + 12;
    const Plot plot{QRectF(left, 2 * line + 4, width() - left - 16, height() - 4 * line - 16)};
    paint_legend(painter, left, line / 2 + 2, plot.area.width());
    paint_axes(painter, plot);
    for (std::size_t k = 0; k < designer_trainees.size(); ++k) {
        if (curves_.changed) paint_curve(painter, plot, curves_.in_force[k], k, true);
    }
    for (std::size_t k = 0; k < designer_trainees.size(); ++k)
        paint_curve(painter, plot, curves_.tried[k], k, false);
}

}  // namespace fulcrum::ui
