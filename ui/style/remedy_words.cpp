// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/remedy_words.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

struct RemedyWords {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::remedies)
};

const TaskDefinition* task_named(const std::vector<TaskDefinition>& tasks, const std::string& id) {
    const auto found =
        std::find_if(tasks.begin(), tasks.end(), [&](const TaskDefinition& one) { return one.id == id; });
    return found == tasks.end() ? nullptr : &*found;
}

QString task_words(const std::vector<TaskDefinition>& tasks, const std::string& id) {
    const TaskDefinition* task = task_named(tasks, id);
    return task == nullptr ? text(id) : text(id) + QLatin1Char(' ') + asset_text(task->title);
}

QString goal_words(const TaskDefinition* task, const std::string& id) {
    if (task != nullptr)
        for (const Goal& goal : task->goals)
            if (goal.id == id) return asset_text(goal.text);
    return text(id);
}

QString variant_words(const TaskDefinition* task, const std::string& id) {
    if (task != nullptr)
        for (const TaskVariant& variant : task->variants)
            if (variant.id == id) return asset_text(variant.title);
    return text(id);
}

}  // namespace

QString remedy_bound_words(const Remedy& remedy) {
    const QString bound = figure_with_unit(remedy.bound, remedy.unit);
    return remedy.above ? RemedyWords::tr("above %1").arg(bound) : RemedyWords::tr("below %1").arg(bound);
}

QString remedy_action_words(const Remedy& remedy, const std::string& task,
                            const std::vector<TaskDefinition>& tasks) {
    const TaskDefinition* own = task_named(tasks, task);
    switch (remedy.kind) {
        case RemedyKind::practise_from:
            return RemedyWords::tr("practise it from the goal “%1” on").arg(goal_words(own, remedy.goal));
        case RemedyKind::other_task:
            if (remedy.variant.empty())
                return RemedyWords::tr("practise %1").arg(task_words(tasks, remedy.task));
            return RemedyWords::tr("practise %1 in the variant “%2”")
                .arg(task_words(tasks, remedy.task),
                     variant_words(task_named(tasks, remedy.task), remedy.variant));
        case RemedyKind::other_variant:
            return RemedyWords::tr("practise it in the variant “%1”").arg(variant_words(own, remedy.variant));
        case RemedyKind::ghost:
            return RemedyWords::tr("practise it with the ghost of an expert");
        case RemedyKind::demonstration:
            return RemedyWords::tr("watch an expert do it");
        case RemedyKind::replay:
            return RemedyWords::tr("look at the replay of the latest attempt");
    }
    return {};
}

QString remedy_words(const Remedy& remedy, const std::string& task,
                     const std::vector<TaskDefinition>& tasks) {
    return RemedyWords::tr("%1 %2: %3")
        .arg(metric_text(remedy.metric), remedy_bound_words(remedy),
             remedy_action_words(remedy, task, tasks));
}

}  // namespace fulcrum::ui
