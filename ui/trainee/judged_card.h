// SPDX-License-Identifier: GPL-3.0-or-later
// What is assessed in a task: each gate as a bar with its limit, the experts' range and the trainee's own
// last value; the same as a list one click away.
#pragma once

#include <QFrame>
#include <vector>

#include "assessment/scoring/judged_limits.h"
#include "assessment/task/task.h"
#include "database/records/report_data.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class JudgedCard : public QFrame {
    Q_OBJECT
  public:
    explicit JudgedCard(QWidget* parent = nullptr);
    /// `own`: the metrics of the trainee's last scored attempt with this device; may be empty.
    void open(const TaskDefinition& task, const std::vector<JudgedLimit>& limits,
              const std::vector<database::MetricRow>& own);
    /// The same limits with these values; bars or list stay shown.
    void show_own(const std::vector<JudgedLimit>& limits, const std::vector<database::MetricRow>& own) {
        fill_bars(limits, own);
    }

  signals:
    void metric_chosen(const QString& metric_id);

  private:
    void fill_bars(const std::vector<JudgedLimit>& limits, const std::vector<database::MetricRow>& own);
    void fill_list(const TaskDefinition& task, const std::vector<JudgedLimit>& limits);
    void show_list(bool shown);

    QWidget *bars_, *list_;
    QGridLayout* bar_grid_;
    QVBoxLayout* lines_;
    QLabel *legend_, *errors_;
    QPushButton* toggle_;
};

/// The metrics of the newest scored attempt with this device class, as they are defined now: those that an
/// older version measured are left out. Empty without one.
std::vector<database::MetricRow> last_values(const database::PersonProgress& progress,
                                             DeviceClass device_class);

}  // namespace fulcrum::ui
