// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/curriculum_page.h"

#include <QComboBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QTabWidget>
#include <algorithm>

#include "assessment/task/task.h"
#include "database/scoring/limit_trial.h"
#include "ui/dashboards/curriculum_forms.h"
#include "ui/dashboards/pass_rule_designer.h"
#include "ui/dashboards/remedies_form.h"
#include "ui/language/language.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

enum CurriculumTab { rule_tab, needs_tab, ratings_tab, remedies_tab, stages_tab };

CurriculumTab tab_of(CurriculumField field) {
    switch (field) {
        case CurriculumField::title:
        case CurriculumField::stages:
            return stages_tab;
        case CurriculumField::rule:
            return rule_tab;
        case CurriculumField::ratings:
            return ratings_tab;
        case CurriculumField::remedies:
            return remedies_tab;
        default:
            return needs_tab;
    }
}

bool is_of_task(CurriculumField field) {
    return tab_of(field) != stages_tab;
}

/// What the check of a draft can know of the installed tasks.
std::vector<InstalledTask> installed_tasks(const std::vector<TaskDefinition>& tasks) {
    std::vector<InstalledTask> installed;
    for (const TaskDefinition& task : tasks) {
        InstalledTask one = installed_task(task);
        if (one.needs_limits)
            for (const BenchmarkSet& set : sets_in_force(task.id))
                if (!set.experts.empty()) one.with_limits.push_back(set.device_class);
        installed.push_back(std::move(one));
    }
    return installed;
}

}  // namespace

CurriculumPage::CurriculumPage(Context& context)
    : Page(context, "curriculum_page"),
      title_(make_label({}, "title")),
      task_name_(make_label({}, "heading")),
      facts_(make_label({}, "muted")),
      designer_(new PassRuleDesigner),
      needs_(new TaskNeedsForm),
      ratings_(new TaskRatingsForm),
      remedies_(new RemediesForm),
      stages_(new StagesForm) {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    layout->addWidget(title_);
    layout->addWidget(
        make_label(tr("The pass rule of a task decides when a trainee is proficient in it. Choose a task, "
                      "change its rule, and see the effect. Nothing changes for trainees until you publish."),
                   "muted"));
    auto* row = new QBoxLayout(text_percent() > 150 ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    row->setSpacing(12);
    row->addWidget(make_tasks(), 1);
    row->addWidget(make_task_card(), 3);
    layout->addLayout(row, 1);
    merge_ = new DraftMergeCard;
    layout->addWidget(merge_);
    layout->addWidget(make_problems());
    layout->addWidget(make_publishing());
    connect_parts();
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
}

void CurriculumPage::connect_parts() {
    connect(tasks_, &QListWidget::currentRowChanged, this, [this] {
        show_task();
        look();
    });
    connect(designer_, &PassRuleDesigner::changed, this, &CurriculumPage::try_rule);
    connect(restore_, &QPushButton::clicked, this, &CurriculumPage::restore);
    connect(add_, &QPushButton::clicked, this, &CurriculumPage::add_task);
    connect(remove_, &QPushButton::clicked, this, &CurriculumPage::remove_task);
    connect(up_, &QPushButton::clicked, this, [this] { move_task(-1); });
    connect(down_, &QPushButton::clicked, this, [this] { move_task(1); });
    connect(needs_, &TaskNeedsForm::changed, this, [this] {
        if (CurriculumTask* task = chosen()) {
            needs_->apply(*task);
            show_rule(*task);  // how many attempts it has to look at depends on the variants
        }
        look();
    });
    connect(ratings_, &TaskRatingsForm::changed, this, [this] {
        if (CurriculumTask* task = chosen()) ratings_->apply(*task);
        look();
    });
    connect(remedies_, &RemediesForm::changed, this, [this] {
        if (CurriculumTask* task = chosen()) remedies_->apply(*task);
        look();
    });
    connect(stages_, &StagesForm::changed, this, [this] {
        stages_->apply(draft_);
        show_task();
        look();
    });
    connect(problem_list_, &QListWidget::itemActivated, this,
            [this] { go_to_problem(problem_list_->currentRow()); });
    connect(problem_list_, &QListWidget::itemClicked, this,
            [this] { go_to_problem(problem_list_->currentRow()); });
    connect(merge_, &DraftMergeCard::decided, this, &CurriculumPage::decide);
    connect(merge_, &DraftMergeCard::place_wanted, this, [this](int row) {
        if (meeting_ && row >= 0 && row < static_cast<int>(meeting_->collisions.size()))
            go_to(collision_problem(meeting_->collisions[static_cast<std::size_t>(row)]));
    });
    connect(path_, &QLineEdit::textChanged, this, &CurriculumPage::look);
    connect(save_, &QPushButton::clicked, this, &CurriculumPage::save);
    connect(reason_, &QLineEdit::textChanged, this, &CurriculumPage::look);
    connect(publish_, &QPushButton::clicked, this, &CurriculumPage::publish);
    ask_twice(discard_, discard_sure_, [this] { return is_unsaved(); });
    connect(discard_sure_, &QPushButton::clicked, this, [this] {
        start_over();
        fill(0);
        tasks_->setFocus();  // the button is disabled now
    });
}

const Curriculum& CurriculumPage::in_force() const {
    return context().services().curriculum();
}

std::size_t CurriculumPage::index_of_chosen() const {
    return static_cast<std::size_t>(std::max(0, tasks_->currentRow()));
}

CurriculumTask* CurriculumPage::chosen() {
    return index_of_chosen() < draft_.tasks.size() ? &draft_.tasks[index_of_chosen()] : nullptr;
}

void CurriculumPage::enter() {
    look_for_newer();
    // A draft that somebody has begun stays, also where another version was published since.
    if (author_.empty() || (!is_seen() && !is_changed())) {
        read_installed();
        start_over();
        fill(0);
    } else if (!meet_newer()) {
        look();  // the role may be another one by now
    }
    author_ = context().session().person_id();
    tasks_->setFocus();
}

void CurriculumPage::read_installed() {
    context().guarded([&] {
        installed_ = installed_tasks(context().services().tasks());
        forms_ = context().services().forms();
    });
    ratings_->set_forms(forms_);
    remedies_->set_tasks(context().services().tasks());
}

void CurriculumPage::set_quietly(QLineEdit* edit, const QString& shown) {
    const QSignalBlocker quiet(edit);
    edit->setText(shown);
}

void CurriculumPage::start_over() {
    base_.reset();
    meeting_.reset();
    draft_ = in_force();
    draft_.older.clear();
    draft_.based_on.reset();
    file_ = {};
    meet(&in_force(), DraftMeeting::Base::known, in_force().version);
    set_quietly(reason_, {});
    propose_path();
}

bool CurriculumPage::is_changed() const {
    return (meeting_ && !meeting_->collisions.empty()) || !base_ || !same_contents(*base_, draft_);
}

void CurriculumPage::fill(int row) {
    {
        const QSignalBlocker quiet(tasks_);
        tasks_->clear();
        for (const CurriculumTask& task : draft_.tasks) {
            auto* item = new QListWidgetItem(tasks_);
            item->setData(Qt::UserRole, text(task.task));
        }
        tasks_->setCurrentRow(std::min(row, tasks_->count() - 1));
    }
    new_task_->clear();
    for (const InstalledTask& one : installed_)
        if (draft_.find(one.id) == nullptr) new_task_->addItem(context().task_title(one.id), text(one.id));
    stages_->show_draft(draft_);
    show_task();
    look();
}

// The title of the task and the rule below it, the one that is tried where there is one; how many problems.
void CurriculumPage::write_line(int row) {
    QListWidgetItem* item = tasks_->item(row);
    const CurriculumTask& task = draft_.tasks[static_cast<std::size_t>(row)];
    const CurriculumTask* before = in_force().find(task.task);
    const bool same = before != nullptr && pass_rule_text(before->rule) == pass_rule_text(task.rule);
    QString line = context().task_title(task.task) + QLatin1Char('\n') +
                   (same ? pass_rule_words(task.rule) : tr("tried: %1").arg(pass_rule_words(task.rule)));
    const auto blocking =
        std::count_if(problems_.begin(), problems_.end(), [&](const CurriculumProblem& one) {
            return one.blocks && is_of_task(one.field) && one.index == static_cast<std::size_t>(row);
        });
    if (blocking > 0) line += QLatin1Char('\n') + tr("✕ %n problems", nullptr, static_cast<int>(blocking));
    if (item->text() == line) return;
    item->setText(line);
    item->setToolTip(line);
}

void CurriculumPage::show_task() {
    const CurriculumTask* task = chosen();
    for (const int tab : {rule_tab, needs_tab, ratings_tab, remedies_tab})
        tabs_->setTabEnabled(tab, task != nullptr);
    if (task == nullptr) {
        task_name_->clear();
        facts_->clear();
        return;
    }
    task_name_->setText(context().task_title(task->task));
    show_rule(*task);
    QStringList titles;
    for (const CurriculumTask& one : draft_.tasks) titles << context().task_title(one.task);
    const InstalledTask* installed = find_installed(installed_, task->task);
    needs_->show_task(draft_, index_of_chosen(), titles,
                      installed == nullptr ? 0 : static_cast<int>(installed->variants.size()));
    ratings_->show_task(*task);
    remedies_->show_task(*task);
    show_problems();
}

void CurriculumPage::show_rule(const CurriculumTask& task) {
    const CurriculumTask* known = in_force().find(task.task);
    designer_->show_rule(known == nullptr ? task.rule : known->rule, task.rule, task.variants);
}

void CurriculumPage::show_facts() {
    const CurriculumTask* task = chosen();
    if (task == nullptr) return;
    const CurriculumStage* stage = draft_.find_stage(task->stage);
    QStringList facts;
    if (stage != nullptr) facts << tr("Stage %1: %2").arg(text(stage->id), asset_text(stage->title));
    QStringList before;
    for (const std::string& one : task->after) before << text(one);
    facts << (before.isEmpty() ? tr("open from the start")
                               : tr("opens after %1").arg(before.join(QStringLiteral(", "))));
    if (task->variants > 1) facts << tr("passes on %n variants", nullptr, task->variants);
    if (task->ratings)
        facts << tr("%n ratings with the form %1, mean at least %2", nullptr, task->ratings->raters)
                     .arg(text(task->ratings->form), figure(task->ratings->lowest_mean));
    QStringList classes;
    for (const DeviceClass one : task->device_classes) classes << device_class_text(one);
    facts << tr("devices: %1").arg(classes.join(QStringLiteral(", ")));
    facts_->setText(facts.join(QStringLiteral(" · ")));
}

void CurriculumPage::try_rule() {
    if (CurriculumTask* task = chosen()) task->rule = designer_->tried();
    look();
}

void CurriculumPage::restore() {
    CurriculumTask* task = chosen();
    const CurriculumTask* before = task == nullptr ? nullptr : in_force().find(task->task);
    if (before == nullptr) return;
    task->rule = before->rule;
    show_task();
    tasks_->setFocus();  // the button is disabled now
    look();
}

void CurriculumPage::add_task() {
    CurriculumTask added;
    added.task = plain(new_task_->currentData().toString());
    if (added.task.empty()) return;
    const TaskDefinition* known = context().task(added.task);
    added.stage = known == nullptr ? std::string() : known->stage;
    if (draft_.find_stage(added.stage) == nullptr && !draft_.stages.empty())
        added.stage = draft_.stages.back().id;
    added.rule.kind = PassRuleKind::lc_cusum;
    added.device_classes = {DeviceClass::haptic};
    draft_.tasks.push_back(added);
    fill(static_cast<int>(draft_.tasks.size()) - 1);
    tabs_->setCurrentIndex(needs_tab);
}

void CurriculumPage::remove_task() {
    if (chosen() == nullptr) return;
    const int row = tasks_->currentRow();
    draft_.tasks.erase(draft_.tasks.begin() + row);
    fill(row);
    tasks_->setFocus();
}

void CurriculumPage::move_task(int by) {
    const int row = tasks_->currentRow(), to = row + by;
    if (row < 0 || to < 0 || to >= tasks_->count()) return;
    std::swap(draft_.tasks[static_cast<std::size_t>(row)], draft_.tasks[static_cast<std::size_t>(to)]);
    fill(to);
    // At the end of the list the other direction would get the keyboard, and take it back.
    if (!(by < 0 ? up_ : down_)->isEnabled()) tasks_->setFocus();
}

void CurriculumPage::look() {
    settle();
    problems_ = check_draft(draft_, installed_, forms_);
    if (meeting_)
        for (const DraftDifference& one : meeting_->collisions) problems_.push_back(collision_problem(one));
    merge_->show_meeting(meeting_ ? &*meeting_ : nullptr, draft_, in_force(), context().services().tasks());
    show_facts();
    for (int row = 0; row < tasks_->count(); ++row) write_line(row);
    show_problems();
    const bool changed = is_changed(),
               blocked = std::any_of(problems_.begin(), problems_.end(),
                                     [](const CurriculumProblem&one) { return one.blocks; });
    const CurriculumTask* task = chosen();
    const CurriculumTask* before = task == nullptr ? nullptr : in_force().find(task->task);
    restore_->setEnabled(before != nullptr && pass_rule_text(before->rule) != pass_rule_text(task->rule));
    remove_->setEnabled(task != nullptr);
    up_->setEnabled(tasks_->currentRow() > 0);
    down_->setEnabled(task != nullptr && tasks_->currentRow() + 1 < tasks_->count());
    add_->setEnabled(new_task_->count() > 0);
    discard_->setEnabled(changed);
    for (QPushButton* sure : {discard_sure_, open_sure_}) sure->hide();  // the draft is another one now
    const QString file = draft_path();
    save_->setEnabled(changed && !file.isEmpty() && !QFileInfo(file).isDir());
    save_->setText(QFileInfo(file).isFile() ? tr("Replace") : tr("Save"));
    const bool allowed = context().signed_in() && context().allowed(database::Operation::accept_assets) &&
                         !context().store().is_server();
    const bool reason = !reason_->text().trimmed().isEmpty();
    publish_->setText(tr("Publish version %1").arg(draft_.version));
    publish_->setEnabled(changed && !blocked && allowed && reason);
    const QString why_not = !allowed   ? tr("An educator publishes, at a station.")
                            : !changed ? tr("Change the draft first; it is the same as the version in force.")
                            : blocked  ? tr("Solve the problems marked with ✕ first.")
                            : !reason  ? tr("Give a reason.")
                                       : QString();
    publish_->setToolTip(why_not);
    // A button that is disabled has neither the focus nor, for some readers, a tool tip.
    why_not_->setText(why_not);
    why_not_->setVisible(!why_not.isEmpty());
}

void CurriculumPage::show_problems() {
    problem_list_->clear();
    for (const CurriculumProblem& one : problems_) {
        QString where = field_words(one.field);
        if (is_of_task(one.field) && one.index < draft_.tasks.size())
            where = text(draft_.tasks[one.index].task) + QStringLiteral(", ") + where;
        auto* item = new QListWidgetItem(tr("%1: %2").arg(where, problem_words(one)), problem_list_);
        if (one.blocks) set_tint(item, Tint::bad);
    }
    no_problems_->setVisible(problems_.empty());
    problem_list_->setVisible(!problems_.empty());
    needs_->show_problems(problems_, index_of_chosen());
    ratings_->show_problems(problems_, index_of_chosen());
    remedies_->show_problems(problems_, index_of_chosen());
    stages_->show_problems(problems_);
}

void CurriculumPage::go_to_problem(int row) {
    if (row < 0 || row >= static_cast<int>(problems_.size())) return;
    const CurriculumProblem one = problems_[static_cast<std::size_t>(row)];  // the list changes on the way
    go_to(one);
}

void CurriculumPage::go_to(const CurriculumProblem& one) {
    if (is_of_task(one.field)) tasks_->setCurrentRow(static_cast<int>(one.index));
    tabs_->setCurrentIndex(tab_of(one.field));
    tabs_->currentWidget()->setFocus();
}

}  // namespace fulcrum::ui

#include "moc_curriculum_page.cpp"
