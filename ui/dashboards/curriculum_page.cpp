// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/curriculum_page.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QStandardPaths>
#include <QTabWidget>
#include <algorithm>

#include "assessment/task/task.h"
#include "database/scoring/limit_trial.h"
#include "ui/dashboards/curriculum_forms.h"
#include "ui/dashboards/pass_rule_designer.h"
#include "ui/dashboards/remedies_form.h"
#include "ui/language/language.h"
#include "ui/style/flow_row.h"
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
    layout->addWidget(make_problems());
    layout->addWidget(make_publishing());
    connect_parts();
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
}

QWidget* CurriculumPage::make_tasks() {
    auto* holder = new QWidget;
    auto* layout = new QVBoxLayout(holder);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    tasks_ = new QListWidget;
    tasks_->setObjectName(QStringLiteral("curriculum_tasks"));
    tasks_->setAccessibleName(tr("Tasks of the curriculum"));
    tasks_->setMinimumWidth(280);
    tasks_->setMinimumHeight(12 * fontMetrics().height());
    tasks_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(tasks_, 1);
    auto* row = new FlowRow;
    up_ = make_button(tr("▲ Up"), "task_up");
    down_ = make_button(tr("▼ Down"), "task_down");
    remove_ = make_button(tr("Remove"), "task_remove");
    for (QPushButton* button : {up_, down_, remove_}) row->add(button);
    layout->addLayout(row);
    auto* more = new FlowRow;
    new_task_ = make_narrow_choice("task_new", tr("Task to be added"), 8);
    add_ = make_button(tr("Add"), "task_add");
    more->add(new_task_, 1, with_text(180));  // on a line of its own in a narrow window
    more->add(add_);
    layout->addLayout(more);
    return holder;
}

QWidget* CurriculumPage::make_task_card() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(task_name_);
    card_layout(card)->addWidget(facts_);
    tabs_ = new QTabWidget;
    tabs_->setObjectName(QStringLiteral("curriculum_tabs"));
    auto* rule = new QWidget;
    auto* layout = new QVBoxLayout(rule);
    layout->addWidget(designer_, 1);
    restore_ = make_button(tr("Back to the rule in force"), "rule_restore");
    layout->addWidget(restore_, 0, Qt::AlignLeft);
    layout->addWidget(make_label(tr("Calculated for trainees who pass each attempt with the same "
                                    "probability. Learning, and the days, variants and ratings that a rule "
                                    "can also require, are not included; they make proficiency later."),
                                 "muted"));
    tabs_->addTab(rule, tr("Pass rule"));
    tabs_->addTab(needs_, tr("Prerequisites"));
    tabs_->addTab(ratings_, tr("Ratings"));
    tabs_->addTab(remedies_, tr("Remedies"));
    tabs_->addTab(stages_, tr("Stages"));
    card_layout(card)->addWidget(tabs_, 1);
    return card;
}

QWidget* CurriculumPage::make_problems() {
    QFrame* card = make_card(6);
    card_layout(card)->addWidget(make_label(tr("Problems of the draft"), "heading"));
    no_problems_ = make_label(tr("None."));
    no_problems_->setObjectName(QStringLiteral("curriculum_no_problems"));
    card_layout(card)->addWidget(no_problems_);
    problem_list_ = new QListWidget;
    problem_list_->setObjectName(QStringLiteral("curriculum_problems"));
    problem_list_->setAccessibleName(tr("Problems of the draft"));
    problem_list_->setWordWrap(true);
    problem_list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    problem_list_->setMinimumHeight(6 * fontMetrics().height());
    problem_list_->setItemDelegate(new TintDelegate(problem_list_));
    card_layout(card)->addWidget(problem_list_);
    return card;
}

QWidget* CurriculumPage::make_publishing() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("Publish"), "heading"));
    card_layout(card)->addWidget(
        make_label(tr("Trainees who have begun keep their version until an educator moves them. Trainees who "
                      "begin later follow the new version. Your name and reason are kept in the audit log."),
                   "muted"));
    auto* row = new FlowRow;
    reason_ = new QLineEdit;
    reason_->setObjectName(QStringLiteral("curriculum_reason"));
    reason_->setAccessibleName(tr("Reason for the new version"));
    reason_->setPlaceholderText(tr("Reason"));
    reason_->setMaxLength(1000);
    publish_ = make_button(tr("Publish"), "curriculum_publish", "primary");
    discard_ = make_button(tr("Discard the draft"), "curriculum_discard");
    row->add(reason_, 1, with_text(240));
    row->add(publish_);
    row->add(discard_);
    card_layout(card)->addLayout(row);
    why_not_ = make_label({}, "muted");
    why_not_->setObjectName(QStringLiteral("curriculum_why_not"));
    card_layout(card)->addWidget(why_not_);
    card_layout(card)->addLayout(make_draft_row());
    return card;
}

QLayout* CurriculumPage::make_draft_row() {
    auto* row = new FlowRow;
    QLabel* name = make_label(tr("Draft as a file"));
    name->setWordWrap(false);
    row->add(name);
    path_ = new QLineEdit;
    path_->setObjectName(QStringLiteral("curriculum_path"));
    path_->setAccessibleName(tr("File of the draft"));
    row->add(path_, 1, with_text(240));
    save_ = make_button(tr("Save"), "curriculum_save");
    QPushButton* open = make_button(tr("Open …"), "curriculum_open");
    row->add(save_);
    row->add(open);
    connect(open, &QPushButton::clicked, this, &CurriculumPage::open_draft);
    return row;
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
        if (CurriculumTask* task = chosen()) needs_->apply(*task);
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
    connect(path_, &QLineEdit::textChanged, this, &CurriculumPage::look);
    connect(save_, &QPushButton::clicked, this, &CurriculumPage::save);
    connect(reason_, &QLineEdit::textChanged, this, &CurriculumPage::look);
    connect(publish_, &QPushButton::clicked, this, &CurriculumPage::publish);
    connect(discard_, &QPushButton::clicked, this, [this] {
        start_over();
        fill(0);
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
    // A draft that somebody has begun stays, also where another version was published since.
    if (based_on_.empty() || (!is_changed() && based_on_ != in_force().name())) {
        read_installed();
        start_over();
        fill(0);
    }
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

void CurriculumPage::start_over() {
    draft_ = in_force();
    draft_.older.clear();
    draft_.version = in_force().next_own_version();
    based_on_ = in_force().name();
    title_->setText(tr("%1, version %2").arg(asset_text(in_force().title)).arg(in_force().version));
    reason_->clear();
    QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    if (!QFileInfo(folder).isDir()) folder = QDir::homePath();
    path_->setText(QDir::toNativeSeparators(
        QDir(folder).filePath(QStringLiteral("%1-%2.json").arg(text(draft_.id)).arg(draft_.version))));
}

bool CurriculumPage::is_changed() const {
    Curriculum same = in_force();
    same.version = draft_.version;
    return curriculum_text(same) != curriculum_text(draft_);
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
    const CurriculumStage* stage = draft_.find_stage(task->stage);
    task_name_->setText(context().task_title(task->task));
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
    const CurriculumTask* known = in_force().find(task->task);
    designer_->show_rule(known == nullptr ? task->rule : known->rule, task->rule);
    QStringList titles;
    for (const CurriculumTask& one : draft_.tasks) titles << context().task_title(one.task);
    const InstalledTask* installed = find_installed(installed_, task->task);
    needs_->show_task(draft_, index_of_chosen(), titles,
                      installed == nullptr ? 0 : static_cast<int>(installed->variants.size()));
    ratings_->show_task(*task);
    remedies_->show_task(*task);
    show_problems();
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
    problems_ = check_draft(draft_, installed_, forms_);
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
    const QString file = path_->text().trimmed();
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
    const CurriculumProblem one = problems_[static_cast<std::size_t>(row)];
    if (is_of_task(one.field)) tasks_->setCurrentRow(static_cast<int>(one.index));
    tabs_->setCurrentIndex(tab_of(one.field));
    tabs_->currentWidget()->setFocus();
}

}  // namespace fulcrum::ui

#include "moc_curriculum_page.cpp"
