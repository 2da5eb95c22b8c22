// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/curriculum_page.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QStandardPaths>

#include "assessment/curriculum/curriculum.h"
#include "assessment/curriculum/next_version.h"
#include "sim_core/numerics/output_file.h"
#include "ui/dashboards/pass_rule_designer.h"
#include "ui/language/language.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

CurriculumPage::CurriculumPage(Context& context)
    : Page(context, "curriculum_page"),
      title_(make_label({}, "title")),
      task_name_(make_label({}, "heading")),
      facts_(make_label({}, "muted")),
      tasks_(new QListWidget),
      designer_(new PassRuleDesigner) {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    layout->addWidget(title_);
    layout->addWidget(
        make_label(tr("When a trainee is proficient in a task follows from its pass rule. Choose "
                      "a task, move the sliders, and see what another rule would do."),
                   "muted"));
    auto* row = new QHBoxLayout;
    row->setSpacing(12);
    tasks_->setObjectName(QStringLiteral("curriculum_tasks"));
    tasks_->setAccessibleName(tr("Tasks of the curriculum"));
    tasks_->setMinimumWidth(220);
    tasks_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    row->addWidget(tasks_, 1);
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(task_name_);
    card_layout(card)->addWidget(facts_);
    card_layout(card)->addWidget(designer_, 1);
    restore_ = make_button(tr("Back to the rule in force"), "rule_restore");
    card_layout(card)->addWidget(restore_, 0, Qt::AlignLeft);
    card_layout(card)->addWidget(make_label(
        tr("Exact for trainees who pass every attempt with the same chance. Learning, the two days "
           "and the variants and ratings that a rule may ask for are left out: they delay it further."),
        "muted"));
    row->addWidget(card, 3);
    layout->addLayout(row, 1);
    layout->addWidget(make_saving());
    connect(tasks_, &QListWidget::currentRowChanged, this, &CurriculumPage::show_task);
    connect(designer_, &PassRuleDesigner::changed, this, &CurriculumPage::try_rule);
    connect(restore_, &QPushButton::clicked, this, &CurriculumPage::restore);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1180));
}

QWidget* CurriculumPage::make_saving() {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    QLabel* name = make_label(tr("New version"));
    name->setWordWrap(false);
    row->addWidget(name);
    path_ = new QLineEdit;
    path_->setObjectName(QStringLiteral("curriculum_path"));
    path_->setAccessibleName(tr("File of the new version"));
    row->addWidget(path_, 1);
    save_ = make_button(tr("Save"), "curriculum_save", "primary");
    row->addWidget(save_);
    connect(path_, &QLineEdit::textChanged, this, &CurriculumPage::look);
    connect(path_, &QLineEdit::returnPressed, save_, &QPushButton::click);
    connect(save_, &QPushButton::clicked, this, &CurriculumPage::save);
    return holder;
}

const Curriculum& CurriculumPage::curriculum() const {
    return context().services().curriculum();
}

std::string CurriculumPage::chosen() const {
    const QListWidgetItem* item = tasks_->currentItem();
    return item == nullptr ? std::string() : item->data(Qt::UserRole).toString().toStdString();
}

void CurriculumPage::enter() {
    if (tasks_->count() == 0) fill();
    tasks_->setFocus();
}

void CurriculumPage::fill() {
    const Curriculum& shown = curriculum();
    title_->setText(tr("%1, version %2").arg(asset_text(shown.title)).arg(shown.version));
    for (const CurriculumTask& task : shown.tasks) {
        auto* item = new QListWidgetItem(tasks_);
        item->setData(Qt::UserRole, text(task.task));
        write_line(tasks_->count() - 1);
    }
    QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    if (!QFileInfo(folder).isDir()) folder = QDir::homePath();
    path_->setText(QDir::toNativeSeparators(
        QDir(folder).filePath(QStringLiteral("%1-%2.json").arg(text(shown.id)).arg(shown.version + 1))));
    tasks_->setCurrentRow(0);
    look();
}

// The title of the task and the rule below it, the one that is tried where there is one.
void CurriculumPage::write_line(int row) {
    QListWidgetItem* item = tasks_->item(row);
    const std::string id = item->data(Qt::UserRole).toString().toStdString();
    const auto tried = tried_.find(id);
    const QString rule = tried == tried_.end() ? pass_rule_words(curriculum().find(id)->rule)
                                               : tr("tried: %1").arg(pass_rule_words(tried->second));
    item->setText(context().task_title(id) + QLatin1Char('\n') + rule);
    item->setToolTip(item->text());
}

void CurriculumPage::show_task() {
    const CurriculumTask* task = curriculum().find(chosen());
    if (task == nullptr) return;
    const CurriculumStage* stage = curriculum().find_stage(task->stage);
    task_name_->setText(context().task_title(task->task));
    QStringList facts{tr("Stage %1: %2").arg(text(stage->id), asset_text(stage->title))};
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
    const auto tried = tried_.find(task->task);
    designer_->show_rule(task->rule, tried == tried_.end() ? task->rule : tried->second);
    restore_->setEnabled(tried != tried_.end());
}

void CurriculumPage::try_rule() {
    const CurriculumTask* task = curriculum().find(chosen());
    if (task == nullptr) return;
    tried_.erase(task->task);
    if (pass_rule_text(designer_->tried()) != pass_rule_text(task->rule))
        tried_.emplace(task->task, designer_->tried());
    restore_->setEnabled(tried_.count(task->task) != 0);
    write_line(tasks_->currentRow());
    look();
}

void CurriculumPage::restore() {
    tried_.erase(chosen());
    write_line(tasks_->currentRow());
    show_task();
    look();
}

void CurriculumPage::look() {
    const QString file = path_->text().trimmed();
    save_->setEnabled(!tried_.empty() && !file.isEmpty() && !QFileInfo(file).isDir());
    save_->setText(QFileInfo(file).isFile() ? tr("Replace") : tr("Save"));
    save_->setToolTip(tried_.empty() ? tr("Change the rule of a task first.") : QString());
}

void CurriculumPage::save() {
    const std::string file = QDir::fromNativeSeparators(path_->text().trimmed()).toStdString();
    const bool written = context().guarded([&] {
        const std::string content = next_version_text(curriculum(), tried_);
        std::vector<std::string> ids;
        for (const TaskDefinition& task : context().services().tasks()) ids.push_back(task.id);
        parse_curriculum(content, file, ids);  // what is written can be read
        write_output_file(file, content);
    });
    look();
    if (written)
        context().say(tr("Wrote %1. It takes effect once it is installed: the manual says how.")
                          .arg(path_->text().trimmed()));
}

}  // namespace fulcrum::ui

#include "moc_curriculum_page.cpp"
