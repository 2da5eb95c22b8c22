// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what fidelities cost in score was measured with what judges attempts now.
#pragma once

#include <map>
#include <string>

#include "assessment/assets/fidelity_cost.h"
#include "assessment/task/task.h"

namespace fulcrum {

/// The version of each metric that the task gates.
std::map<std::string, int> gated_metric_versions(const TaskDefinition& task);
/// Simulation and metrics are those of this program. Reads no file.
bool measured_with_this_program(const TaskFidelityCost& cost);
/// The task's gates and its benchmark set are those in force as well. Throws InputError as
/// load_task_and_scene().
bool measured_as_now(const TaskFidelityCost& cost, const std::string& task);

}  // namespace fulcrum
