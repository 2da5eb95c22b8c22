// SPDX-License-Identifier: GPL-3.0-or-later
// The trainee's first page: the next thing to do and why, unread comments, the curriculum as a path with a
// card for each task.
#pragma once

#include <QPointer>
#include <map>
#include <memory>

#include "assessment/curriculum/recommendation.h"
#include "assessment/curriculum/standing.h"
#include "database/records/reviews.h"
#include "ui/page/context.h"
#include "ui/trainee/next_task.h"

class QFrame;
class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class GoalsCard;
class Ladder;
class StoreReading;

/// What the page shows of a trainee's attempts.
struct HomeContent {
    std::shared_ptr<const Curriculum> newest;
    const Curriculum* followed = nullptr;  ///< version of it that the trainee follows
    /// A version that the trainee follows and that is not at this station; then there are no standings.
    std::string missing;
    std::vector<TaskStanding> standings;
    std::map<std::string, TaskSummary> summaries;  ///< by task
    Recommendation next;
    std::string latest_attempt;  ///< that counts, where the recommendation is a remedy
    std::vector<database::Comment> unread;
    std::int64_t at = 0;  ///< UTC ms, when it was read
};

class HomePage : public Page {
    Q_OBJECT
  public:
    explicit HomePage(Context& context);
    void enter() override;
    void leave() override;
    void take_keyboard(QWidget* used) override;
    /// Attempts were scored in the background: what somebody does on the page stays.
    void show_scored();

  private:
    /// Reads in the background; what is shown stays until then.
    void load();
    void show_content(HomeContent content);
    /// With why; tasks as they were read before would look current.
    void show_failure(const QString& why);
    void say(QLabel* words);
    void fill_next();
    QPushButton* remedy_button(const Recommendation& next, const std::string& latest_attempt);
    void fill_interrupted();
    void fill_comments();
    void fill_tasks();
    /// `standing`: null for a task that does not belong to the curriculum.
    QFrame* task_card(const std::string& task_id, const TaskStanding* standing, const TaskSummary& summary);

    QLabel* greeting_;
    QVBoxLayout *next_, *interrupted_, *comments_;
    QFrame *interrupted_card_, *comments_card_;
    GoalsCard* goals_;
    Ladder* ladder_;
    QLabel* others_heading_;
    QGridLayout* cards_;
    StoreReading* reading_;
    HomeContent content_;            ///< `followed` is null until it was read
    QPointer<QPushButton> go_;       ///< leads to what is recommended, or reads again what could not be read
    QPointer<QWidget> used_before_;  ///< had the keyboard when the reading began that has not ended
};

}  // namespace fulcrum::ui
