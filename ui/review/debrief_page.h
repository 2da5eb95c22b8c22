// SPDX-License-Identifier: GPL-3.0-or-later
// After an attempt, for the trainee, the educator and the director alike: four numbers, the verdict and one
// sentence first; then gates, replay, what happened, force, path, comments; every penalty leads to its
// moment.
#pragma once

#include <memory>
#include <string>

#include "ui/page/context.h"
#include "ui/review/attempt_model.h"

class QCheckBox;
class QLabel;
class QLayout;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class ActionsCard;
class BackgroundJob;
class CommentsCard;
class GatesCard;
class JobBar;
class PathView;
class PathologyCard;
class ReplayPanel;
class TimeChart;

class DebriefPage : public Page {
    Q_OBJECT
  public:
    explicit DebriefPage(Context& context);
    /// Reads the attempt off the UI thread; `time_s` < 0: from the start.
    void open(const std::string& attempt_id, double time_s);
    void enter() override;
    void leave() override;
    /// The charts stand; the replay may still be waiting for the rest of the record.
    bool has_charts() const { return model_ != nullptr; }
    /// Everything is there, the replay too.
    bool is_ready() const { return model_ != nullptr && model_->trace != nullptr; }
    double moment() const;
    const AttemptModel* model() const { return model_.get(); }

  signals:
    void ready();

  private:
    QWidget* build_head();
    QLayout* build_replay();  ///< next to what happened
    QLayout* build_charts();
    void connect_parts();
    void show_model();
    void read_record();
    void show_record(std::shared_ptr<const database::Trace> trace);
    void fill_head();
    void show_pathology();
    void save_report(const QString& path);
    void fill_events();
    void fill_metrics();
    void fill_charts();
    void go_to(double time);
    void time_changed(double time);

    std::shared_ptr<const AttemptModel> model_;
    std::string attempt_id_;
    double wanted_time_ = -1;
    BackgroundJob* job_ = nullptr;
    JobBar* job_bar_;
    QWidget* content_;
    QLabel *title_, *verdict_, *about_, *notes_, *advice_;
    QLabel *number_[4], *number_title_[4], *number_why_[4];
    QPushButton* back_;
    GatesCard* gates_;
    PathologyCard* pathology_;
    QTableWidget* metrics_;
    ReplayPanel* replay_;
    QListWidget* events_;
    QCheckBox* penalties_only_;
    TimeChart* force_;
    PathView* path_;
    CommentsCard* comments_;
    QPushButton* all_metrics_;
    ActionsCard* actions_;
};

}  // namespace fulcrum::ui
