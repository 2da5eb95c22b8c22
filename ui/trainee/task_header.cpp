// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/task_header.h"

#include <map>

#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/theatre/scene_picture.h"

namespace fulcrum::ui {
namespace {

/// "standard (12 attempts), narrow (3)"; empty where only one was performed.
QString variants_of(const database::PersonProgress& progress) {
    std::map<std::string, int> counts;
    for (const database::ProgressSeries& series : progress.series)
        for (const database::ProgressPoint& point : series.points) ++counts[point.variant];
    if (counts.size() < 2) return {};
    QStringList parts;
    for (const auto& [variant, count] : counts)
        parts << TaskHeader::tr("%1 (%2 attempts)").arg(text(variant)).arg(count);
    return parts.join(QStringLiteral(", "));
}

}  // namespace

TaskHeader::TaskHeader(Context& context) : context_(context) {
    setProperty("role", "card");
    setObjectName(QStringLiteral("task_header"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(14, 14, 18, 14);
    row->setSpacing(18);
    picture_ = new ScenePicture(context);
    picture_->setFixedSize(280, 210);
    row->addWidget(picture_, 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    title_ = make_label({}, "heading");
    briefing_ = make_label({});
    product_ = make_label({}, "muted");
    variants_ = make_label({}, "muted");
    variants_->setObjectName(QStringLiteral("task_variants"));
    for (QLabel* label : {title_, briefing_, product_, variants_}) words->addWidget(label);
    perform_ = make_button(tr("Go to the briefing"), "task_briefing", "primary");
    words->addWidget(perform_, 0, Qt::AlignLeft);
    words->addStretch();
    row->addLayout(words, 1);
    connect(perform_, &QPushButton::clicked, this, [this] { emit context_.briefing_wanted(text(task_id_)); });
}

void TaskHeader::show_task(const std::string& person_id, const std::string& task_id,
                           const database::PersonProgress* progress) {
    task_id_ = task_id;
    const TaskDefinition* task = context_.task(task_id);
    setVisible(task != nullptr);
    if (task == nullptr) return;
    if (pictured_ != task_id) picture_->show_task(*task);
    pictured_ = task_id;
    title_->setText(context_.task_title(task_id));
    briefing_->setText(text(task->briefing));
    product_->setText(
        tr("Outcome: %1 · time limit %2").arg(text(task->product), clock_text(task->time_limit_s)));
    const QString variants = progress == nullptr ? QString() : variants_of(*progress);
    variants_->setText(tr("Variants performed: %1").arg(variants));
    variants_->setVisible(!variants.isEmpty());
    perform_->setVisible(
        person_id == context_.session().person_id() &&
        context_.allowed(database::Operation::perform_attempt, database::Subject::person(person_id)));
}

}  // namespace fulcrum::ui

#include "moc_task_header.cpp"
