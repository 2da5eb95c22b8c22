// SPDX-License-Identifier: GPL-3.0-or-later
// What was recorded, next to the replay: force and speed of both hands, traction while tissue was divided,
// energy and heat, each where the record has it, over one time axis, and the list of events. A click in any
// of them chooses a time, a drag with Shift a part; set_time() moves the cursors and marks the latest event.
#pragma once

#include <QWidget>
#include <array>
#include <memory>
#include <vector>

#include "database/records/error_reviews.h"

class QCheckBox;
class QListWidget;
class QListWidgetItem;

namespace fulcrum {
struct TaskDefinition;
}

namespace fulcrum::ui {

class ChartFrame;
struct AttemptModel;
class TimeChart;
class TimeCharts;

class TracePanel : public QWidget {
    Q_OBJECT
  public:
    explicit TracePanel(QWidget* parent = nullptr);
    /// `task`: null where this program does not have it.
    void open(std::shared_ptr<const AttemptModel> model, const TaskDefinition* task);
    void set_time(double time);
    /// What educators said of the errors: at most one of each.
    void show_reviews(std::vector<database::ErrorReview> reviews);
    /// Shades a part of the attempt in all charts; to <= from: none.
    void set_part(double from, double to);
    /// Shows this part of the time axis, s; to <= from: all of it.
    void zoom_to(double from, double to);
    /// Below the list of events.
    void set_foot(QWidget* foot);

  signals:
    void time_chosen(double time);
    /// By a person, not by the replay: index in the model's events.
    void event_chosen(int index);
    /// A part was selected in a chart, s.
    void part_selected(double from, double to);

  private:
    void build_charts();
    /// One time axis below the charts that are shown, their plots below each other.
    void align_charts();
    void fill_traction(const TaskDefinition* task);
    void fill_energy();
    void fill_marks();
    void connect_parts();
    void fill_events();
    void fill_charts(const TaskDefinition* task);
    void choose(QListWidgetItem* item);
    void add_note(const database::ErrorReview& review, QListWidgetItem* line);
    const database::ErrorReview* review_of(const Event& event) const;
    /// Without choosing a time.
    void mark_event(double time);

    std::shared_ptr<const AttemptModel> model_;
    std::vector<database::ErrorReview> reviews_;
    double time_ = 0;
    ChartFrame* charts_;
    TimeCharts* axis_;
    TimeChart *force_, *speed_, *traction_, *energy_;
    std::array<TimeChart*, 4> all_charts_;  ///< from the top
    QCheckBox* penalties_only_;
    QListWidget* events_;
    QWidget* foot_ = nullptr;
};

}  // namespace fulcrum::ui
