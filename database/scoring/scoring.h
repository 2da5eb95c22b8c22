// SPDX-License-Identifier: GPL-3.0-or-later
// From an attempt's record to its score: the one path for window, command line, recomputation and tests.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assessment/metrics/metric.h"
#include "assessment/scoring/benchmark.h"
#include "assessment/scoring/score.h"
#include "assessment/task/task.h"
#include "database/rows/attempt_records.h"
#include "sim_core/scene/scene.h"
#include "sim_core/telemetry/event.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum {

struct ScoredAttempt {
    AttemptState state = AttemptState::interrupted;
    double duration_s = 0;  ///< last sample's time
    std::vector<MetricResult> metrics;
    Score score;
    std::optional<PathologyReport> pathology;  ///< where the task leaves a specimen
};

/// The benchmark set in force for a task and device class: assets/benchmarks/TASK.json (first sets serve
/// every class). Empty if none.
std::optional<BenchmarkSet> benchmark_in_force(const std::string& task_id);
/// Why an attempt in this scene is not compared with the set: its cutting parameters differ from those of the
/// scene that the set was made in. Empty if they are equal. `scene_file`: the task's, whose values a set
/// without any of its own means.
Statement why_not_comparable(const BenchmarkSet& benchmark, const Scene& scene,
                             const std::string& scene_file);

/// Pure but for its arguments and the scene file of the task (why_not_comparable). `targets`: centres of the
/// scene's targets for this seed.
ScoredAttempt score_record(const Scene& scene, const TaskDefinition& task,
                           const std::vector<Vector3>& targets, const std::vector<TickSample>& samples,
                           const std::vector<Event>& events, const BenchmarkSet* benchmark);

/// The same from a trace that has been read from a file, with the scene's labels first in its table.
ScoredAttempt score_trace(const Scene& scene, const TaskDefinition& task, const std::vector<Vector3>& targets,
                          const Trace& trace, const std::vector<Event>& events,
                          const BenchmarkSet* benchmark);

/// Tissue labels in the order of HandSample::tissue.
std::vector<std::string> tissue_labels(const Scene& scene);

/// As the store keeps it.
database::ScoreRow to_row(const ScoredAttempt& scored, const std::string& limits);
/// Name of a benchmark set with its version, as stored with an attempt; empty for null.
std::string limits_name(const BenchmarkSet* benchmark);

}  // namespace fulcrum
