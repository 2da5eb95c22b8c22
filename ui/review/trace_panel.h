// SPDX-License-Identifier: GPL-3.0-or-later
// What was recorded, next to the replay: force and speed of both hands over the same time axis, and the list
// of events. A click in any of them chooses a time; set_time() moves the cursors and marks the latest event.
#pragma once

#include <QWidget>
#include <memory>

class QCheckBox;
class QListWidget;

namespace fulcrum::ui {

struct AttemptModel;
class TimeChart;

class TracePanel : public QWidget {
    Q_OBJECT
  public:
    explicit TracePanel(QWidget* parent = nullptr);
    void open(std::shared_ptr<const AttemptModel> model);
    void set_time(double time);

  signals:
    void time_chosen(double time);

  private:
    void connect_parts();
    void fill_events();
    void fill_charts();
    /// Without choosing a time.
    void mark_event(double time);

    std::shared_ptr<const AttemptModel> model_;
    double time_ = 0;
    QWidget* charts_;
    TimeChart *force_, *speed_;
    QCheckBox* penalties_only_;
    QListWidget* events_;
};

}  // namespace fulcrum::ui
