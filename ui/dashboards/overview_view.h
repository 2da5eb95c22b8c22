// SPDX-License-Identifier: GPL-3.0-or-later
// A cohort task by task: how many people are in each standing as a bar, the share that has passed with its
// interval, and the days that it took. The same as a table below it. UI thread.
#pragma once

#include <QWidget>

#include "database/records/report_data.h"

class QTableWidget;

namespace fulcrum::ui {

class OverviewChart;

class OverviewView : public QWidget {
    Q_OBJECT
  public:
    explicit OverviewView(QWidget* parent = nullptr);
    /// `titles`: of the curriculum's tasks, in its order.
    void show_table(const database::CohortTable& table, const QStringList& titles);

  private:
    OverviewChart* chart_;
    QTableWidget* table_;
};

/// "12 of 18 (67 %, 44 to 84 %)"; "–" for nobody.
QString share_text(const database::TaskOverview& task);
/// "23 days (15 to 40)", "23 days (15 or more)", "fewer than half so far"; "–" for nobody.
QString days_text(const SurvivalMedian& days, int people);

}  // namespace fulcrum::ui
