// SPDX-License-Identifier: GPL-3.0-or-later
// The personal goals of a trainee: on the home page to set, change and drop them, on the page of progress for
// educators to read.
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include "database/records/goals.h"
#include "ui/page/context.h"

class QComboBox;
class QDateEdit;
class QDoubleSpinBox;
class QFrame;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class GoalsCard : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::GoalsCard)
  public:
    /// `own`: those of the person who is signed in, who may change them; else another person's, to read.
    GoalsCard(Context& context, bool own);
    /// Hidden where the session may not read them, and where there is nothing to read or to set.
    void show_person(const std::string& person_id);
    /// Somebody sets or changes a goal.
    bool is_edited() const { return editor_ != nullptr && !editor_->isHidden(); }

  private:
    QWidget* make_editor();
    QWidget* line_of(const database::GoalProgress& progress);
    /// An empty id: a new goal.
    void edit(const std::string& goal_id, const database::GoalWish& wish);
    void close_editor();
    void kind_changed();
    void task_changed();
    void metric_changed();
    void set_ranges();
    database::GoalWish wish() const;
    void save();
    void drop(const std::string& goal_id);
    std::int64_t today() const;
    bool may_set() const;

    Context& context_;
    bool own_;
    std::string person_id_, edited_;
    QLabel* heading_;
    QVBoxLayout* lines_;
    QPushButton* add_ = nullptr;
    QWidget* editor_ = nullptr;
    QComboBox *kind_ = nullptr, *task_ = nullptr, *metric_ = nullptr;
    QDoubleSpinBox* target_ = nullptr;
    QDateEdit* due_ = nullptr;
    QLabel *due_label_ = nullptr, *latest_ = nullptr;
};

}  // namespace fulcrum::ui
