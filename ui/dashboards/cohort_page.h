// SPDX-License-Identifier: GPL-3.0-or-later
// The cohort table: people by tasks, each with state, attempts and best points a device class; exported as
// PDF, CSV and JSON.
#pragma once

#include <optional>

#include "database/records/report_data.h"
#include "ui/page/context.h"
#include "ui/reports/report.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace fulcrum::ui {

class ExportRow;
class JobBar;

class CohortPage : public Page {
    Q_OBJECT
  public:
    explicit CohortPage(Context& context);
    void enter() override;
    /// Gathers and writes on a worker thread, with progress and a way to stop.
    void export_to(const QString& path, ReportFormat format);

  signals:
    void exported(const QString& path);

  private:
    void load();
    void fit();

    std::optional<database::CohortTable> data_;
    QComboBox* cohort_;
    QLabel *summary_, *foot_;
    QTableWidget* table_;
    ExportRow* export_;
    JobBar* job_;
};

/// What stands in a cell of the table, by device class: "passed (provisional) · 3 attempts · best 84".
QString cohort_cell_text(const database::CohortRow& row);

}  // namespace fulcrum::ui
