// SPDX-License-Identifier: GPL-3.0-or-later
// Charts over the same time axis, one below the other: they zoom and move together, and have one table. UI
// thread.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "ui/charts/chart_table.h"
#include "ui/charts/time_chart.h"

namespace fulcrum::ui {

class TimeCharts : public QWidget, public TabledChart {
    Q_OBJECT
  public:
    explicit TimeCharts(const QString& accessible_name, QWidget* parent = nullptr);
    /// Takes it. `name`: of what it draws, before the names of its series in the table; empty: nothing.
    void add(TimeChart* chart, const QString& name);
    void set_name(const TimeChart* chart, const QString& name);
    /// Shows this part of the time axis in all of them, s; to <= from: all of it. The table changes once.
    void zoom_to(double from, double to);
    /// A row for each time of a point that one of the charts draws.
    ChartTable table() const override;

  private:
    struct Part {
        TimeChart* chart;
        QString name;
    };
    /// Changes several of them; the table changes once.
    void together(const std::function<void(TimeChart&)>& change, const TimeChart* but = nullptr);
    std::vector<Part> parts_;
    bool together_ = false;
};

}  // namespace fulcrum::ui
