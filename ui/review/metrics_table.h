// SPDX-License-Identifier: GPL-3.0-or-later
// Every metric of the score in force. A row leads to the moment of its evidence, its last cell to the page
// that explains it.
#pragma once

#include <QWidget>
#include <string>

class QTableWidget;

namespace fulcrum::ui {

struct AttemptModel;

/// The cell that leads to the explanation of a metric; set_explain_cell() and explained_metric() agree.
void set_explain_cell(QTableWidget* table, int row, int column, const std::string& metric_id);
/// The id of the metric whose explanation a click on this cell asks for; "" for any other cell.
QString explained_metric(const QTableWidget* table, int row, int column);

class MetricsTable : public QWidget {
    Q_OBJECT
  public:
    explicit MetricsTable(QWidget* parent = nullptr);
    void open(const AttemptModel& model);

  signals:
    void time_chosen(double time);
    void metric_chosen(const QString& metric_id);

  private:
    QTableWidget* table_;
};

}  // namespace fulcrum::ui
