// SPDX-License-Identifier: GPL-3.0-or-later
// Who practised when: people by weeks, one square for each day, darker with more attempts. UI thread.
#pragma once

#include <QWidget>

#include "database/records/report_data.h"

class QTableView;

namespace fulcrum::ui {

class PracticeModel;

class PracticeView : public QWidget {
    Q_OBJECT
  public:
    explicit PracticeView(QWidget* parent = nullptr);
    void show_table(const database::CohortTable& table);
    QTableView* view() const { return view_; }

  signals:
    void person_wanted(const QString& person, const QString& task);

  private:
    PracticeModel* model_;
    QTableView* view_;
};

/// Weeks shown, the last one with the day of the table.
inline constexpr int practice_weeks = 12;

}  // namespace fulcrum::ui
