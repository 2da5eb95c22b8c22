// SPDX-License-Identifier: GPL-3.0-or-later
// The curriculum: its tasks by stage with their pass rules, what another rule would do, and an editor for the
// next version. What is edited is a draft, whose problems are shown where they are; it is saved as a file, or
// published with a reason. The versions before it are not changed. Where another version comes into force in
// between, the changes of both are put together first, and nothing that was published is taken back unasked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "assessment/curriculum/curriculum_draft.h"
#include "ui/dashboards/draft_merge_card.h"
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
    /// A draft's file as it was last read or written here.
    struct KnownFile {
        QString path;
        std::string text;
    };
    /// What somebody has begun here, for the page that is made in place of this one.
    struct Begun {
        Curriculum draft;
        std::optional<Curriculum> base;
        std::optional<DraftMeeting> meeting;
        std::string seen, author;
        QString reason, path;
        KnownFile file;
        int row = 0;
        bool saved = false;  ///< its file has it
    };
    /// Nothing where the draft is the same as the version in force.
    std::optional<Begun> begun() const;
    void take_up(const Begun& from);
    /// Kept for its author (begun()) but when the window ends.
    QStringList begun_input(Ending ending) const override;

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
    /// While the list of tasks is not yet that of the draft: looking at it, as after a change by a person,
    /// has to wait.
    static void set_quietly(QLineEdit* edit, const QString& shown);
    void start_over();
    void fill(int row);
    void write_line(int row);
    void show_task();
    void show_rule(const CurriculumTask& task);
    void show_facts();
    void try_rule();
    void restore();
    void add_task();
    void remove_task();
    void move_task(int by);
    /// After every change: problems, lines of the list, what can be done.
    void look();
    void show_problems();
    void go_to(const CurriculumProblem& one);
    void go_to_problem(int row);
    bool is_changed() const;
    /// Whether it would be lost: it is changed, and no file has it as it is.
    bool is_unsaved() const;
    std::string draft_text() const;

    /// False where that could not be found out, which was reported.
    bool look_for_newer();
    /// Whether the draft was put together with the version in force.
    bool is_seen() const;
    /// Puts the draft together with the version in force. `base` null: what it was begun from is not known.
    void meet(const Curriculum* base, DraftMeeting::Base how, int from);
    /// The same with what came into force while the page was open; false: nothing did.
    bool meet_newer();
    void say_meeting();
    /// Collisions that were solved by editing go; without any the draft follows the version in force.
    void settle();
    CurriculumProblem collision_problem(const DraftDifference& one);
    void decide(int row, bool as_in_force);
    /// The version that a saved draft names; null: this station does not have it.
    const Curriculum* version_of(const DraftOrigin& origin) const;

    void open_draft();
    /// What is typed, whole: in the folder of documents where none is named, and with the ending.
    QString draft_path() const;
    void propose_path();
    void save();
    void publish();

    Curriculum draft_;
    /// What the draft was begun from and, as soon as nothing collides, the version in force. None: not known.
    std::optional<Curriculum> base_;
    std::optional<DraftMeeting> meeting_;
    std::string seen_;    ///< name and text of the version in force that the draft was put together with
    std::string author_;  ///< id; empty: the page was not shown yet
    KnownFile file_;
    std::vector<InstalledTask> installed_;
    std::vector<ObserverForm> forms_;
    std::vector<CurriculumProblem> problems_;
    QLabel *title_, *task_name_, *facts_, *no_problems_, *why_not_;
    QListWidget *tasks_, *problem_list_;
    QTabWidget* tabs_;
    PassRuleDesigner* designer_;
    TaskNeedsForm* needs_;
    TaskRatingsForm* ratings_;
    RemediesForm* remedies_;
    StagesForm* stages_;
    QComboBox* new_task_;
    QPushButton *restore_, *add_, *remove_, *up_, *down_, *save_, *publish_, *discard_, *discard_sure_,
        *open_sure_;
    QLineEdit *path_, *reason_;
    DraftMergeCard* merge_;
};

}  // namespace fulcrum::ui
