// SPDX-License-Identifier: GPL-3.0-or-later
// The trainee's first page: the next thing to do and why, unread comments, a card a task.
#pragma once

#include "ui/page/context.h"

class QFrame;
class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace fulcrum::ui {

struct TaskSummary;

class HomePage : public Page {
    Q_OBJECT
  public:
    explicit HomePage(Context& context);
    void enter() override;

  private:
    void fill_next(const std::vector<TaskSummary>& summaries);
    void fill_interrupted();
    void fill_comments();
    void fill_tasks(const std::vector<TaskSummary>& summaries);
    QFrame* task_card(const TaskSummary& summary);

    QLabel* greeting_;
    QVBoxLayout *next_, *interrupted_, *comments_;
    QFrame *interrupted_card_, *comments_card_;
    QGridLayout* cards_;
};

}  // namespace fulcrum::ui
