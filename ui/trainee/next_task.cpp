// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/next_task.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString words(const char* source, int count = -1) {
    return QCoreApplication::translate("fulcrum::ui::next_task", source, nullptr, count);
}

}  // namespace

std::vector<TaskSummary> summarise(const std::vector<database::CohortRow>& rows,
                                   const std::vector<TaskDefinition>& tasks) {
    std::vector<TaskSummary> summaries;
    for (const TaskDefinition& task : tasks) {
        TaskSummary summary;
        summary.task_id = task.id;
        for (const database::CohortRow& row : rows) {
            if (row.task_id != task.id) continue;
            if (row.state == database::TaskState::passed) {
                summary.provisional = summary.state == database::TaskState::passed
                                          ? summary.provisional && row.provisional
                                          : row.provisional;
            }
            summary.state = std::max(summary.state, row.state);
            summary.attempts += row.attempts;
            summary.passes += row.passes;
            summary.not_counting += row.not_counting;
            summary.last_attempt = std::max(summary.last_attempt, row.last_attempt);
            if (row.best_points) {
                summary.best_points =
                    std::max(summary.best_points.value_or(*row.best_points), *row.best_points);
            }
        }
        summaries.push_back(std::move(summary));
    }
    return summaries;
}

NextTask next_task(const std::vector<TaskSummary>& summaries, const std::vector<TaskDefinition>& tasks,
                   std::int64_t now_ms) {
    std::string stage;
    bool all_passed = true;
    for (std::size_t i = 0; i < summaries.size() && i < tasks.size(); ++i) {
        if (summaries[i].state == database::TaskState::passed) continue;
        all_passed = false;
        if (stage.empty() || tasks[i].stage < stage) stage = tasks[i].stage;
    }
    const TaskSummary* chosen = nullptr;
    for (std::size_t i = 0; i < summaries.size() && i < tasks.size(); ++i) {
        const bool candidate =
            all_passed || (tasks[i].stage == stage && summaries[i].state != database::TaskState::passed);
        if (candidate && (chosen == nullptr || summaries[i].last_attempt < chosen->last_attempt)) {
            chosen = &summaries[i];
        }
    }
    if (chosen == nullptr) return {};
    const auto days = static_cast<int>((now_ms - chosen->last_attempt) / 86'400'000);
    const QString ago = days <= 0   ? words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task", "today"))
                        : days == 1 ? words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task", "yesterday"))
                                    : words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task", "%n days ago"), days);
    NextTask next;
    next.task_id = chosen->task_id;
    if (all_passed) {
        next.why = words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task",
                                           "You have passed every task; this is the one you did "
                                           "longest ago (%1)."))
                       .arg(ago);
    } else if (chosen->last_attempt == 0) {
        next.why =
            words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task",
                                    "You have not tried it yet, and it belongs to stage %1, the first that "
                                    "you have not passed."))
                .arg(text(stage));
    } else {
        next.why = words(QT_TRANSLATE_NOOP(
                             "fulcrum::ui::next_task",
                             "Not passed yet; of the tasks left in stage %1 it is the one you have not "
                             "practised for longest (%2)."))
                       .arg(text(stage), ago);
    }
    return next;
}

}  // namespace fulcrum::ui
