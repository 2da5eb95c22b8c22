// SPDX-License-Identifier: GPL-3.0-or-later
// Next and why, from the rows of a person's table: the tasks of the lowest stage that is not
// passed, of these the one not practised longest. Pure.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "assessment/task/task.h"
#include "database/records/report_data.h"

namespace fulcrum::ui {

/// One task of one person over all device classes: best state, sums, latest.
struct TaskSummary {
    std::string task_id;
    database::TaskState state = database::TaskState::open;
    bool provisional = false;
    int attempts = 0, passes = 0, not_counting = 0;
    std::optional<double> best_points;
    std::int64_t last_attempt = 0;
};
/// In the order of `tasks`; a task without rows is open.
std::vector<TaskSummary> summarise(const std::vector<database::CohortRow>& rows,
                                   const std::vector<TaskDefinition>& tasks);

struct NextTask {
    std::string task_id;  ///< "" without tasks
    QString why;
};
NextTask next_task(const std::vector<TaskSummary>& summaries, const std::vector<TaskDefinition>& tasks,
                   std::int64_t now_ms);

}  // namespace fulcrum::ui
