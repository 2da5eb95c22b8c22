// SPDX-License-Identifier: Apache-2.0
// The data for the pathology report of a task: tissue dimensions from the scene, goals and tumour from the
// task.
#pragma once

#include <optional>

#include "assessment/pathology/pathology.h"
#include "assessment/task/task.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// Absent where the task asks for no report. Throws InputError where the scene has no septa, the task no line
/// to divide, or the tumour does not fit into the mesorectum.
std::optional<SpecimenPlan> make_specimen_plan(const Scene& scene, const TaskDefinition& task);

/// The marked line that a scene's sheet or septa have, m; 0 without.
double marked_line(const Scene& scene);

}  // namespace fulcrum
