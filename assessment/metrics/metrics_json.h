// SPDX-License-Identifier: Apache-2.0
// Metric results as JSON, and the body of `fulcrum metrics`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "assessment/metrics/metric.h"
#include "assessment/task/task.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// The `metrics` array: id, version, hand, tissue, value, absent_because, absent_code, unit, direction,
/// evidence, and count where there is one.
nlohmann::json metrics_to_json(const std::vector<MetricResult>& results);
/// The reverse; throws InputError naming `file` and the JSON pointer.
std::vector<MetricResult> metrics_from_json(const nlohmann::json& rows, const std::string& file);

/// What compute_metrics must know of a task: limits of the scene's tissues, phases, targets (by index,
/// may be empty).
MetricContext make_metric_context(const Scene& scene, const TaskDefinition& task,
                                  const std::vector<TargetSphere>& targets);

/// `{"file", "samples", "duration_s", "mean_rate_hz", "ignored_columns", "gaps": [[begin, end], …],
/// "replaced_force_samples", "metrics": […]}`; `file` is where the trace came from.
nlohmann::json metrics_of_trace(const Trace& trace, const std::string& file,
                                const std::optional<MetricContext>& context = std::nullopt);

}  // namespace fulcrum
