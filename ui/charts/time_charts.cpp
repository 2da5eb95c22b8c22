// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/time_charts.h"

#include <QVBoxLayout>
#include <algorithm>

namespace fulcrum::ui {

TimeCharts::TimeCharts(const QString& accessible_name, QWidget* parent) : QWidget(parent) {
    setAccessibleName(accessible_name);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
}

void TimeCharts::add(TimeChart* chart, const QString& name) {
    for (const Part& other : parts_) {
        connect(other.chart, &TimeChart::range_changed, chart, &TimeChart::show_range);
        connect(chart, &TimeChart::range_changed, other.chart, &TimeChart::show_range);
    }
    connect(chart, &TimeChart::points_changed, this, [this] { values_changed(); });
    static_cast<QVBoxLayout*>(layout())->addWidget(chart, 1);
    parts_.push_back({chart, name});
}

void TimeCharts::set_name(const TimeChart* chart, const QString& name) {
    for (Part& part : parts_)
        if (part.chart == chart) part.name = name;
}

ChartTable TimeCharts::table() const {
    ChartTable table;
    table.columns.push_back({tr("Time"), QStringLiteral("s")});
    std::vector<double> times;
    for (const Part& part : parts_) {
        for (ChartColumn column : part.chart->columns()) {
            if (!part.name.isEmpty()) column.name = part.name + QStringLiteral(", ") + column.name;
            table.columns.push_back(std::move(column));
        }
        const std::vector<double> drawn = part.chart->times_drawn();
        std::vector<double> all;
        std::set_union(times.begin(), times.end(), drawn.begin(), drawn.end(), std::back_inserter(all));
        times = std::move(all);
    }
    for (const double time : times) {
        ChartRow row{{ChartCell::value(time)}};
        for (const Part& part : parts_) part.chart->add_values(time, row.cells);
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace fulcrum::ui

#include "moc_time_charts.cpp"
