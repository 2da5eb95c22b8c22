// SPDX-License-Identifier: GPL-3.0-or-later
// The recommendation of the curriculum in words, and a person's attempts summed up by task. Pure.
#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "assessment/curriculum/recommendation.h"
#include "assessment/task/task.h"
#include "database/records/report_data.h"

namespace fulcrum::ui {

/// One task of one person over all device classes.
struct TaskSummary {
    int attempts = 0, passes = 0, not_counting = 0;
    std::optional<double> best_points;
    std::int64_t last_attempt = 0;  ///< UTC ms, practice included; 0: none
};
/// By task; a task without rows is left out.
std::map<std::string, TaskSummary> summarise(const std::vector<database::CohortRow>& rows);

/// What the curriculum's remedies go by: of what counts, the series of the device class whose latest attempt
/// is the newest. `progress`: read with the curriculum.
TaskHistory history_of(const database::PersonProgress& progress);
/// The latest attempt of such a history; empty without one.
std::string latest_counting(const database::PersonProgress& progress);
/// Why a remedy is recommended, and what to do: one sentence.
QString remedy_reason_text(const Recommendation& next, const QString& task_title,
                           const std::vector<TaskDefinition>& tasks);

/// Why this is the next thing to do: one sentence. `stage`: the title of the task's stage. `device`: what the
/// trainee would use now. Of a remedy: remedy_reason_text().
QString reason_text(const Recommendation& next, const QString& stage, DeviceClass device,
                    std::int64_t now_ms);

}  // namespace fulcrum::ui
