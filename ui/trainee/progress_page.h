// SPDX-License-Identifier: GPL-3.0-or-later
// The page of one task and one person: the task with its picture, the standing, the learning curve of points
// or any metric with its fit, the plateau's interval, the limit and the experts' range, and every attempt.
// Trainees see their own; educators and directors choose the person.
#pragma once

#include <map>
#include <optional>

#include "database/records/report_data.h"
#include "ui/page/context.h"
#include "ui/reports/report.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class AttemptChart;
class ChartFrame;
class CertificateCard;
struct AttemptChartData;
struct AttemptSeries;
class ExportRow;
class JobBar;
class CurriculumCard;
class GoalsCard;
class StandingCard;
class StoreReading;
class TaskHeader;

class ProgressPage : public Page {
    Q_OBJECT
  public:
    explicit ProgressPage(Context& context);
    void show_person(const std::string& person_id, const std::string& task_id);
    void enter() override;
    void leave() override;
    /// Writes the shown person's report on a worker thread; `exported` says when it is there.
    void export_to(const QString& path, ReportFormat format);

  signals:
    void exported(const QString& path);

  private:
    QLayout* make_choices();
    void fill_choices();
    /// Of the person's newest attempt; "": none, or the session may not read attempts.
    std::string newest_task() const;
    /// Reads the attempts in the background; what is shown of the same person and task stays until then.
    void load();
    void show_certificates();
    /// Metrics, chart and table of what was read.
    void show_progress();
    /// Id, hand and tissue; a version that is not the newest of those that occur follows them. Values of two
    /// versions are never in one curve.
    QString key_of(const database::MetricRow& metric) const;
    const database::MetricRow* find_row(const database::ProgressPoint& point, const QString& key) const;
    void draw();
    void fill_table();
    /// The experts' range of the shown metric, where the chart shows one device class.
    void add_experts(AttemptChartData& drawn, const QString& key);
    /// Adds the fitted curve of a series to the chart; returns what it says.
    QString add_curve(const database::ProgressSeries& series, AttemptSeries& shown, const QString& key,
                      std::optional<double>& limit) const;

    std::string person_id_, task_id_;
    std::optional<database::PersonProgress> progress_;
    StoreReading* reading_;
    QString wanted_metric_;          ///< chosen by a person, whether the shown task has it or not
    std::map<QString, int> newest_;  ///< version of each metric, by id, hand and tissue
    QLabel *title_, *summary_, *curve_;
    QComboBox *person_, *task_, *metric_;
    ExportRow* export_;
    JobBar* job_;
    CertificateCard* certificates_;
    TaskHeader* header_;
    QPushButton* explain_;
    StandingCard* standing_;
    GoalsCard* goals_;
    CurriculumCard* curriculum_;
    AttemptChart* chart_;
    ChartFrame* frame_;
    QTableWidget* table_;
};

}  // namespace fulcrum::ui
