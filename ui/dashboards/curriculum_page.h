// SPDX-License-Identifier: GPL-3.0-or-later
// The curriculum: its tasks by stage with their pass rules, what another rule would do, and an editor for the
// next version. What is edited is a draft, whose problems are shown where they are; it is saved as a file, or
// published with a reason. The versions before it are not changed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "assessment/curriculum/curriculum_draft.h"
#include "ui/page/context.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTabWidget;

namespace fulcrum::ui {

class PassRuleDesigner;
class RemediesForm;
class StagesForm;
class TaskNeedsForm;
class TaskRatingsForm;

class CurriculumPage : public Page {
    Q_OBJECT
  public:
    explicit CurriculumPage(Context& context);
    void enter() override;
    const Curriculum& draft() const { return draft_; }
    const std::vector<CurriculumProblem>& problems() const { return problems_; }
    /// A file of a draft in place of the present one.
    void read_draft(const QString& path);
    /// What somebody has begun here, for the page that is made in place of this one.
    struct Begun {
        Curriculum draft;
        std::string based_on;
        QString reason, path;
        int row = 0;
    };
    /// Nothing where the draft is the same as the version in force.
    std::optional<Begun> begun() const;
    void take_up(const Begun& from);

  private:
    QWidget* make_tasks();
    QWidget* make_task_card();
    QWidget* make_problems();
    QWidget* make_publishing();
    QLayout* make_draft_row();
    void connect_parts();
    const Curriculum& in_force() const;
    CurriculumTask* chosen();
    std::size_t index_of_chosen() const;
    void read_installed();
    void start_over();
    void fill(int row);
    void write_line(int row);
    void show_task();
    void try_rule();
    void restore();
    void add_task();
    void remove_task();
    void move_task(int by);
    /// After every change: problems, lines of the list, what can be done.
    void look();
    void show_problems();
    void go_to_problem(int row);
    bool is_changed() const;
    void open_draft();
    void save();
    void publish();

    Curriculum draft_;
    std::vector<InstalledTask> installed_;
    std::vector<ObserverForm> forms_;
    std::vector<CurriculumProblem> problems_;
    std::string based_on_;  ///< name of the version that the draft began with
    QLabel *title_, *task_name_, *facts_, *no_problems_, *why_not_;
    QListWidget *tasks_, *problem_list_;
    QTabWidget* tabs_;
    PassRuleDesigner* designer_;
    TaskNeedsForm* needs_;
    TaskRatingsForm* ratings_;
    RemediesForm* remedies_;
    StagesForm* stages_;
    QComboBox* new_task_;
    QPushButton *restore_, *add_, *remove_, *up_, *down_, *save_, *publish_, *discard_;
    QLineEdit *path_, *reason_;
};

}  // namespace fulcrum::ui
