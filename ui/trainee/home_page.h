// SPDX-License-Identifier: GPL-3.0-or-later
// The trainee's first page: the next thing to do and why, unread comments, the curriculum as a path with a
// card for each task.
#pragma once

#include <map>

#include "assessment/curriculum/recommendation.h"
#include "assessment/curriculum/standing.h"
#include "ui/page/context.h"

class QFrame;
class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class GoalsCard;
class Ladder;
struct TaskSummary;

class HomePage : public Page {
    Q_OBJECT
  public:
    explicit HomePage(Context& context);
    void enter() override;

  private:
    /// By task.
    using Summaries = std::map<std::string, TaskSummary>;
    void fill_next(const Summaries& summaries);
    /// What to do about a plateau, where the curriculum names it.
    Recommendation next_of(const Summaries& summaries, std::string& latest_attempt);
    QPushButton* remedy_button(const Recommendation& next, const std::string& latest_attempt);
    void fill_interrupted();
    void fill_comments();
    void fill_tasks(const Summaries& summaries);
    /// `standing`: null for a task that does not belong to the curriculum.
    QFrame* task_card(const std::string& task_id, const TaskStanding* standing, const TaskSummary& summary);

    QLabel* greeting_;
    QVBoxLayout *next_, *interrupted_, *comments_;
    QFrame *interrupted_card_, *comments_card_;
    GoalsCard* goals_;
    Ladder* ladder_;
    QLabel* others_heading_;
    QGridLayout* cards_;
    const Curriculum* followed_ = nullptr;  ///< version that who is signed in follows
    std::vector<TaskStanding> standings_;
};

}  // namespace fulcrum::ui
