// SPDX-License-Identifier: GPL-3.0-or-later
// What was recorded, next to the replay: force and speed of both hands over the same time axis, and the list
// of events. A click in any of them chooses a time; set_time() moves the cursors and marks the latest event.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "database/records/error_reviews.h"

class QCheckBox;
class QListWidget;
class QListWidgetItem;

namespace fulcrum::ui {

struct AttemptModel;
class TimeChart;

class TracePanel : public QWidget {
    Q_OBJECT
  public:
    explicit TracePanel(QWidget* parent = nullptr);
    void open(std::shared_ptr<const AttemptModel> model);
    void set_time(double time);
    /// What educators said of the errors: at most one of each.
    void show_reviews(std::vector<database::ErrorReview> reviews);
    /// Below the list of events.
    void set_foot(QWidget* foot);

  signals:
    void time_chosen(double time);
    /// By a person, not by the replay: index in the model's events.
    void event_chosen(int index);

  private:
    void connect_parts();
    void fill_events();
    void fill_charts();
    void choose(QListWidgetItem* item);
    void add_note(const database::ErrorReview& review, QListWidgetItem* line);
    const database::ErrorReview* review_of(const Event& event) const;
    /// Without choosing a time.
    void mark_event(double time);

    std::shared_ptr<const AttemptModel> model_;
    std::vector<database::ErrorReview> reviews_;
    double time_ = 0;
    QWidget* charts_;
    TimeChart *force_, *speed_;
    QCheckBox* penalties_only_;
    QListWidget* events_;
    QWidget* foot_ = nullptr;
};

}  // namespace fulcrum::ui
