// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a curriculum as forms: what a task needs, the ratings that it asks for, the stages. Each shows
// the problems of its own fields.
#pragma once

#include <QWidget>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "assessment/curriculum/curriculum_draft.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace fulcrum::ui {

class ExactBox;

/// Where a problem is, in words: "Prerequisites".
QString field_words(CurriculumField field);
/// "✕ … " where it blocks, "▲ …" where it does not.
QString problem_words(const CurriculumProblem& problem);

/// Stage, prerequisites, variants and devices of a task.
class TaskNeedsForm : public QWidget {
    Q_OBJECT
  public:
    explicit TaskNeedsForm(QWidget* parent = nullptr);
    /// `titles`: of the draft's tasks, in their order.
    void show_task(const Curriculum& draft, std::size_t index, const QStringList& titles, int most_variants);
    void show_problems(const std::vector<CurriculumProblem>& problems, std::size_t index);
    void apply(CurriculumTask& task) const;

  signals:
    void changed();  ///< by the person

  private:
    bool setting_ = false;
    QComboBox* stage_;
    QListWidget* after_;  ///< checkable; user data: id of the task
    QSpinBox* variants_;
    std::vector<QCheckBox*> devices_;  ///< as curriculum_devices
    QLabel* problems_;
};

/// Ratings by observers on top of the passes.
class TaskRatingsForm : public QWidget {
    Q_OBJECT
  public:
    explicit TaskRatingsForm(QWidget* parent = nullptr);
    void set_forms(const std::vector<ObserverForm>& forms);
    void show_task(const CurriculumTask& task);
    void show_problems(const std::vector<CurriculumProblem>& problems, std::size_t index);
    void apply(CurriculumTask& task) const;

  signals:
    void changed();

  private:
    void look();
    bool setting_ = false;
    std::vector<std::string> items_;  ///< of the rule that is shown: those that count
    std::string items_form_;          ///< whose items they are
    QCheckBox *wanted_, *every_item_, *blind_;
    QComboBox* form_;
    QSpinBox* raters_;
    ExactBox* lowest_;
    QLabel* problems_;
};

/// Title and stages of the curriculum.
class StagesForm : public QWidget {
    Q_OBJECT
  public:
    explicit StagesForm(QWidget* parent = nullptr);
    void show_draft(const Curriculum& draft);
    void show_problems(const std::vector<CurriculumProblem>& problems);
    /// A stage whose short name was changed keeps its tasks.
    void apply(Curriculum& draft);

  signals:
    void changed();

  private:
    void fill();
    void look();
    void read_table();
    void move(int by);
    struct Row {
        CurriculumStage stage;
        std::string before;  ///< its id in the draft; empty: it is new
    };
    std::vector<Row> rows_;
    bool setting_ = false;
    QLineEdit* title_;
    QTableWidget* table_;
    QPushButton *add_, *remove_, *up_, *down_;
    QLabel* problems_;
};

}  // namespace fulcrum::ui
