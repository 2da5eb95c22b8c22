// SPDX-License-Identifier: GPL-3.0-or-later
// The remedies of a task as a form: a list, and the fields of the one that is chosen.
#pragma once

#include <QWidget>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "assessment/curriculum/curriculum_draft.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QPushButton;

namespace fulcrum::ui {

class ExactBox;

class RemediesForm : public QWidget {
    Q_OBJECT
  public:
    explicit RemediesForm(QWidget* parent = nullptr);
    /// The installed ones; they must outlive the form.
    void set_tasks(const std::vector<TaskDefinition>& tasks);
    void show_task(const CurriculumTask& task);
    void show_problems(const std::vector<CurriculumProblem>& problems, std::size_t index);
    void apply(CurriculumTask& task) const;

  signals:
    void changed();  ///< by the person

  private:
    QLayout* make_buttons();
    void connect_parts();
    const TaskDefinition* find_task(const std::string& id) const;
    /// Null: none is chosen.
    Remedy* chosen();
    void fill_list(int row);
    /// The fields of the chosen one.
    void show_remedy();
    void show_target(const Remedy& remedy);
    /// The fields into the chosen one.
    void read_remedy();
    void add();
    void move(int by);
    void look();

    bool setting_ = false;
    const std::vector<TaskDefinition>* tasks_ = nullptr;
    std::string task_;  ///< that is shown
    std::vector<Remedy> remedies_;
    QListWidget* list_;
    QWidget* fields_;
    QComboBox *metric_, *side_, *kind_, *target_, *variant_;
    ExactBox* bound_;
    QPushButton *add_, *remove_, *up_, *down_;
    QLabel* problems_;
};

}  // namespace fulcrum::ui
