// SPDX-License-Identifier: GPL-3.0-or-later
// Personal goals in words and as a ring.
#pragma once

#include <QDate>
#include <QWidget>

#include "database/records/goals.h"

namespace fulcrum::ui {

/// "3 attempts a week", "Path length at most 900 mm by 12 Dec 2026". `task`: its title, empty: any task.
QString goal_title(const database::GoalWish& wish, const QString& task);
/// "2 of 3 this week. 4 days left.", "Best so far 950 mm, before 1,020 mm. 8 days left.", "Reached: 880 mm."
QString goal_state(const database::GoalProgress& progress);

/// Days since 1970 on the calendar here.
std::int64_t day_of(const QDate& date);
QDate date_of(std::int64_t day);

/// A ring that is filled as far as the goal is; a tick where it is reached, a stroke where its day has
/// passed.
class GoalRing : public QWidget {
  public:
    explicit GoalRing(const database::GoalProgress& progress);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    double share_;
    bool reached_, missed_;
};

}  // namespace fulcrum::ui
