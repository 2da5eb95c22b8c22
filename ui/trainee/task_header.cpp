// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/task_header.h"

#include <map>

#include "database/records/attempts.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/theatre/scene_picture.h"

namespace fulcrum::ui {
namespace {

/// "Narrow pelvis: 3 attempts, 1 passed".
QString words_of(const TaskVariant& variant, const database::VariantPractice& practice) {
    if (practice.attempts == 0) return TaskHeader::tr("%1: not practised yet").arg(asset_text(variant.title));
    return TaskHeader::tr("%1: %3 of %2 attempts passed")
        .arg(asset_text(variant.title))
        .arg(practice.attempts)
        .arg(practice.passes);
}

}  // namespace

TaskHeader::TaskHeader(Context& context) : context_(context) {
    setProperty("role", "card");
    setObjectName(QStringLiteral("task_header"));
    // With large text the words are below the picture.
    auto* row =
        new QBoxLayout(text_percent() > 150 ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight, this);
    row->setContentsMargins(14, 14, 18, 14);
    row->setSpacing(18);
    picture_ = new ScenePicture(context);
    picture_->setFixedSize(280, 210);
    row->addWidget(picture_, 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    title_ = make_label({}, "heading");
    briefing_ = make_label({});
    product_ = make_label({}, "muted");
    for (QLabel* label : {title_, briefing_, product_}) words->addWidget(label);
    variants_ = new QVBoxLayout;
    variants_->setSpacing(2);
    words->addLayout(variants_);
    perform_ = make_button(tr("Open the briefing"), "task_briefing", "primary");
    watch_ = make_button(tr("Watch an expert do it"), "task_demonstration");
    watch_->setToolTip(tr("A simulated expert performs the task. Nothing is stored. Press Esc to stop."));
    auto* buttons = new FlowRow;
    for (QPushButton* button : {perform_, watch_}) buttons->add(button);
    words->addLayout(buttons);
    words->addStretch();
    row->addLayout(words, 1);
    connect(perform_, &QPushButton::clicked, this, [this] { emit context_.briefing_wanted(text(task_id_)); });
    connect(watch_, &QPushButton::clicked, this,
            [this] { emit context_.demonstration_wanted(text(task_id_)); });
}

/// What was practised of each variant; for oneself a link to the briefing with this variant.
void TaskHeader::fill_variants(const std::string& person_id, const TaskDefinition& task, bool may_perform) {
    clear_layout(variants_);
    if (task.variants.size() < 2) return;
    std::map<std::string, database::VariantPractice> practised;
    if (context_.allowed(database::Operation::read_attempt, database::Subject::person(person_id)))
        context_.guarded([&] {
            practised =
                database::Attempts(context_.store()).practised(context_.session(), person_id, task.id);
        });
    for (const TaskVariant& variant : task.variants) {
        const QString words = words_of(variant, practised[variant.id]);
        if (!may_perform) {
            variants_->addWidget(make_label(words, "muted"));
            continue;
        }
        QPushButton* button = make_button(words, "task_variant", "link");
        button->setToolTip(tr("Open the briefing with this variant"));
        connect(button, &QPushButton::clicked, this,
                [this, id = variant.id] { emit context_.briefing_wanted(text(task_id_), text(id)); });
        variants_->addWidget(button, 0, Qt::AlignLeft);
    }
}

void TaskHeader::show_task(const std::string& person_id, const std::string& task_id) {
    task_id_ = task_id;
    const TaskDefinition* task = context_.task(task_id);
    setVisible(task != nullptr);
    if (task == nullptr) return;
    if (pictured_ != task_id) picture_->show_task(*task);
    pictured_ = task_id;
    title_->setText(context_.task_title(task_id));
    briefing_->setText(asset_text(task->briefing));
    product_->setText(
        tr("Outcome: %1 · Time limit %2").arg(asset_text(task->product), minutes_text(task->time_limit_s)));
    const bool may_perform =
        person_id == context_.session().person_id() &&
        context_.allowed(database::Operation::perform_attempt, database::Subject::person(person_id));
    fill_variants(person_id, *task, may_perform);
    perform_->setVisible(may_perform);
    watch_->setVisible(may_perform);
}

}  // namespace fulcrum::ui

#include "moc_task_header.cpp"
