// SPDX-License-Identifier: GPL-3.0-or-later
// A cohort: as a grid of people by tasks, as days of practice, as a list of those who need an educator now,
// and as a table with state, attempts and best points by device class. All of one query; exported as PDF, CSV
// and JSON.
#pragma once

#include <optional>

#include "database/records/report_data.h"
#include "ui/page/context.h"
#include "ui/reports/report.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;
class QTabWidget;

namespace fulcrum::ui {

class CohortGrid;
class ExportRow;
class JobBar;
class OverviewView;
class PracticeView;
class StationNote;
class StoreReading;

class CohortPage : public Page {
    Q_OBJECT
  public:
    explicit CohortPage(Context& context);
    void enter() override;
    void leave() override;
    /// Gathers and writes on a worker thread, with progress and a way to stop.
    void export_to(const QString& path, ReportFormat format);

  signals:
    void exported(const QString& path);

  private:
    QWidget* make_views();
    /// Reads the chosen cohort in the background; what is shown of it stays until then.
    void load();
    void clear();
    void show_table(database::CohortTable table, const Curriculum& curriculum);
    void show_rows();
    void show_concerns();
    void mark_decisions();
    void mark_unknown();
    void fit();
    void show_foot();

    std::optional<database::CohortTable> data_;
    QComboBox* cohort_;
    QLabel *summary_, *foot_, *unknown_, *versions_;
    QPushButton* show_versions_;
    QTabWidget* views_;
    CohortGrid* grid_;
    OverviewView* overview_;
    PracticeView* practice_;
    QTableWidget *concerns_, *table_;
    ExportRow* export_;
    JobBar* job_;
    StationNote* note_;
    StoreReading* reading_;
};

/// What stands in a cell of the table, by device class: "passed (provisional) · 3 attempts · best 84".
QString cohort_cell_text(const database::CohortRow& row);
/// The same in a few signs: "✓ 85 · 12" is passed, best 85 points, 12 attempts.
QString cohort_cell_mark(const database::CohortRow& row);

}  // namespace fulcrum::ui
