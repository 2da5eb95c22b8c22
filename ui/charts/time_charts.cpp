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
    connect(chart, &TimeChart::range_changed, this, [this, chart](double from, double to) {
        together([from, to](TimeChart& other) { other.show_range(from, to); }, chart);
    });
    connect(chart, &TimeChart::points_changed, this, [this] {
        if (!together_) values_changed();
    });
    static_cast<QVBoxLayout*>(layout())->addWidget(chart, 1);
    parts_.push_back({chart, name});
}

void TimeCharts::together(const std::function<void(TimeChart&)>& change, const TimeChart* but) {
    together_ = true;
    for (const Part& part : parts_)
        if (part.chart != but) change(*part.chart);
    together_ = false;
    values_changed();
}

void TimeCharts::zoom_to(double from, double to) {
    together([from, to](TimeChart& chart) { to > from ? chart.show_range(from, to) : chart.show_all(); });
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
