// SPDX-License-Identifier: GPL-3.0-or-later
// After an attempt, for the trainee, the educator and the director alike: verdict, one sentence of advice,
// four numbers and the product first; then, on one screen, the replay next to force, speed and events, which
// move together; ratings; comments; everything else in tabs. Every penalty leads to its moment. Whoever rates
// the attempt blind sees the replay and their form until it is handed in.
#pragma once

#include <QStringList>
#include <memory>
#include <string>

#include "ui/page/context.h"
#include "ui/review/attempt_model.h"
#include "ui/review/remote_trace.h"

class QFrame;
class QLabel;
class QPushButton;
class QTabWidget;

namespace fulcrum::ui {

class ActionsCard;
class BackgroundJob;
class CommentsCard;
class ErrorReviewBar;
class GatesCard;
class JobBar;
class MetricsTable;
class PartCard;
class PathView;
class PathologyCard;
class RatingsCard;
class ReplayPanel;
class TracePanel;

class DebriefPage : public Page {
    Q_OBJECT
  public:
    explicit DebriefPage(Context& context);
    /// Reads the attempt off the UI thread; `time_s` < 0: from the start.
    void open(const std::string& attempt_id, double time_s);
    /// Without name and score, for somebody who has not seen them yet.
    void open_to_rate(const std::string& attempt_id);
    void enter() override;
    void leave() override;
    /// A comment that was not sent, a reason that was not given, the notes of a rating: before the session or
    /// the window ends, or the screen is locked.
    void keep_comment();
    /// The charts stand; the replay may still be waiting for the rest of the record.
    bool has_charts() const { return model_ != nullptr; }
    /// Everything is there, the replay too.
    bool is_ready() const { return model_ != nullptr && model_->trace != nullptr; }
    double moment() const;
    const AttemptModel* model() const { return model_.get(); }

  signals:
    void ready();

  private:
    void load();
    QWidget* build_blind_head();
    /// Shows name and score from now on; a rating that is begun later is not blind.
    void lift_blinding();
    void show_parts();
    QWidget* build_head();
    QLayout* build_numbers();
    QWidget* build_replay();  ///< next to the traces
    QWidget* build_tabs();
    void resizeEvent(QResizeEvent* event) override;
    /// The replay and the traces fill the page's height, so that they are seen together.
    void fit_replay();
    /// Scrolls to the replay, for a choice that was made further down.
    void show_moment(double time);
    void explain(const QString& metric_id);
    void fill_numbers();
    QStringList notes() const;
    void show_notes();
    void read_reviews();
    void connect_parts();
    void show_model();
    void read_record();
    void show_record(std::shared_ptr<const database::Trace> trace);
    void fill_head();
    void show_pathology();
    void save_report(const QString& path);
    void go_to(double time);
    void time_changed(double time);

    std::shared_ptr<const AttemptModel> model_;
    std::string attempt_id_;
    double wanted_time_ = -1;
    bool blind_ = false;          ///< name and score stay hidden
    std::optional<Scene> scene_;  ///< of the attempt; none where the program lacks the task
    BackgroundJob* job_ = nullptr;
    JobBar* job_bar_;
    QWidget *content_, *head_, *blind_head_;
    QLabel *blind_title_, *title_, *verdict_, *about_, *notes_, *advice_, *product_;
    QLabel *number_[4], *number_title_[4], *number_why_[4];
    QPushButton* number_explain_[4];
    QPushButton *back_, *compare_;
    QWidget* replay_block_;
    QLabel* no_trace_words_;
    QPushButton* fetch_again_;  ///< where it is at another station
    QFrame* no_trace_;          ///< in its place where the trace was not kept, or is not here
    TraceElsewhere elsewhere_;
    QTabWidget* tabs_;
    GatesCard* gates_;
    PathologyCard* pathology_;
    MetricsTable* metrics_;
    ReplayPanel* replay_;
    TracePanel* traces_;
    PartCard* part_;
    PathView* path_;
    CommentsCard* comments_;
    ErrorReviewBar* error_bar_;
    int struck_ = 0;                               ///< errors that an educator struck
    std::vector<database::AssetFile> unaccepted_;  ///< its files that no assessed attempt may use
    RatingsCard* ratings_;
    ActionsCard* actions_;
};

}  // namespace fulcrum::ui
