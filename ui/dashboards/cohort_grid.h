// SPDX-License-Identifier: GPL-3.0-or-later
// The cohort as a picture: people by tasks, each cell the standing as a shape with a colour and the latest
// attempts as bars. Filtered by name and standing, sorted by name, by what is done or by practice. Everything
// a cell shows is also its tool tip and its accessible text. UI thread.
#pragma once

#include <QWidget>

#include "database/records/report_data.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QSortFilterProxyModel;
class QTableView;

namespace fulcrum::ui {

class CohortGridModel;

class CohortGrid : public QWidget {
    Q_OBJECT
  public:
    explicit CohortGrid(QWidget* parent = nullptr);
    ~CohortGrid() override;
    /// `titles`: of the curriculum's tasks as the table has them, such as "A2 · Fulcrum targeting".
    void show_table(const database::CohortTable& table, const QStringList& titles);
    QTableView* view() const { return view_; }

  signals:
    /// `task`: empty where the person was chosen.
    void person_wanted(const QString& person, const QString& task);

  private:
    CohortGridModel* model_;
    QSortFilterProxyModel* shown_;
    QLineEdit* name_;
    QComboBox *standing_, *order_;
    QTableView* view_;
    QWidget* legend_;
    QLabel* bars_;
};

/// What a cell says: "Ann Other, A2 · Fulcrum targeting: passed (provisional). Latest attempts: failed 41,
/// passed 72."
QString grid_cell_text(const QString& name, const QString& title, const database::PersonTask& task);
/// Of a person whose version of the curriculum, `curriculum`, is not at this station: "Ann Other, A2 ·
/// Fulcrum targeting: not known here. The curriculum rectal@7 is not at this station."
QString unknown_cell_text(const QString& name, const QString& title, const QString& curriculum);

}  // namespace fulcrum::ui
