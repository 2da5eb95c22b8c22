// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt compared with another one (own best or last, an expert's, any other of the person) or with a
// cohort: both replays side by side under one slider, forces or speeds of both in one chart, the differences
// of the metrics, all of the whole attempt, of a step, or of a range. The time shown is that of the own
// attempt.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/page/context.h"
#include "ui/review/comparison.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QTabWidget;

namespace fulcrum::ui {

class BackgroundJob;
class ChartFrame;
class ComparisonTable;
class JobBar;
class PartChoice;
class PartMeasure;
class ReplayPanel;
class TimeChart;

class ComparePage : public Page {
    Q_OBJECT
  public:
    explicit ComparePage(Context& context);
    /// Reads the attempt off the UI thread.
    void open(const std::string& attempt_id);
    void enter() override;
    void leave() override;
    /// What was chosen is shown, or said to be absent.
    bool is_ready() const;
    const std::vector<ComparisonChoice>& choices() const { return choices_; }
    const ComparedPair* pair() const { return pair_ ? &*pair_ : nullptr; }
    const CohortSide* cohort() const { return cohort_ ? &*cohort_ : nullptr; }
    double moment() const;

  private:
    QWidget* build_sides();
    QLayout* build_steering();
    QWidget* build_tabs();
    void connect_parts();
    /// Stops what runs in the background; its answer is dropped.
    void stop();
    /// Runs `work` in the background, where nothing else runs; `done` on this thread.
    void run(std::function<void(const database::Store&, const Progress&)> work, std::function<void()> done,
             const QString& line);
    void own_loaded();
    void choose(int index);
    void load_attempt(const std::string& id);
    void load_expert();
    void load_cohort(const std::string& id);
    void other_loaded();
    std::unique_ptr<ReplaySource> picture_of(const ComparedSide& side, QString& why);
    void show_charts();
    void show_part();
    void show_metrics();
    void measure_part();
    void seek(double time);
    void time_changed(double time);

    std::string attempt_id_;
    std::vector<ComparisonChoice> choices_;
    std::shared_ptr<const ComparedSide> own_, other_;
    std::shared_ptr<const ExpertAttempt> expert_;  ///< what `other_` was made of, where it is one
    std::optional<ComparedPair> pair_;
    std::optional<CohortSide> cohort_;
    BackgroundJob* job_ = nullptr;
    bool begins_next_ = false;  ///< what is compared with is loaded as soon as the bar is free
    JobBar* job_bar_;
    QPushButton* back_;
    QWidget* content_;
    QLabel *title_, *notes_, *own_words_, *other_words_, *clock_;
    QComboBox *with_, *speed_, *quantity_;
    QWidget *sides_, *other_side_, *steering_;
    ReplayPanel *own_replay_, *other_replay_;
    QSlider* slider_;
    QPushButton* play_;
    PartChoice* part_;
    PartMeasure* measure_;
    QTabWidget* tabs_;
    TimeChart* charts_[hand_count];
    ChartFrame* frame_;
    ComparisonTable* table_;
};

}  // namespace fulcrum::ui
