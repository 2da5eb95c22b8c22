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

/// What an attempt is held against.
struct Limits {
    Limits() = default;
    explicit Limits(BenchmarkSet in_force, database::AssetFile from = {})
        : set(std::move(in_force)), file(std::move(from)) {}

    std::optional<BenchmarkSet> set;  ///< of the attempt's key
    database::AssetFile file;         ///< what `set` was read from; no name without a set
    /// Why gates based on the experts' range are not judged: the task has limits, but not for this device
    /// class, fidelity, variant or tissue, or they have to be built again. Without a set and without this the
    /// task has none at all.
    Statement not_comparable;
    /// Those of the start have been replaced (limits_at_start()), and are known to have been provisional.
    bool replaced_provisional = false;

    /// Name of the set with its version, as stored with an attempt; empty without a set.
    std::string name() const;
    /// The set where attempts are compared with it, else null.
    const BenchmarkSet* comparable() const { return set && not_comparable.empty() ? &*set : nullptr; }
};
/// The set of this key in assets/benchmarks (benchmark_name()); without a set where there is none, or where
/// it has to be built again (OutdatedSet), which `not_comparable` then says: attempts go without these limits
/// until then. Throws InputError where the file holds another one.
Limits benchmark_in_force(const BenchmarkKey& key);
/// Of the scene file of this variant; of the task's own where it no longer has the variant.
CuttingValues cutting_of_file(const TaskDefinition& task, const std::string& variant);
/// The limits in force for attempts at this task in this scene with this device. `scene`: with the fidelity
/// and the tissue values of the attempt.
Limits limits_for(const TaskDefinition& task, const Scene& scene, DeviceClass device_class);
/// Those that were in force when the attempt began, by the name and the files stored with it (none: an
/// attempt from before files were kept); once replaced, or changed under the same name, they are not
/// comparable.
Limits limits_at_start(const TaskDefinition& task, const Scene& scene, DeviceClass device_class,
                       const std::string& name, const std::vector<database::AssetFile>& assets = {});

/// Pure. `targets`: centres of the scene's targets for this seed.
ScoredAttempt score_record(const Scene& scene, const TaskDefinition& task,
                           const std::vector<TargetSphere>& targets, const std::vector<TickSample>& samples,
                           const std::vector<Event>& events, const Limits& limits);

/// The same from a trace that has been read from a file, with the scene's labels first in its table.
ScoredAttempt score_trace(const Scene& scene, const TaskDefinition& task,
                          const std::vector<TargetSphere>& targets, const Trace& trace,
                          const std::vector<Event>& events, const Limits& limits);

/// Tissue labels in the order of HandSample::tissue.
std::vector<std::string> tissue_labels(const Scene& scene);

/// As the store keeps it.
database::ScoreRow to_row(const ScoredAttempt& scored, const std::string& limits);
/// Back from the store, which has neither the kind of an absence (here `not_measured`) nor the count behind
/// a value, and of a gate no evidence.
MetricResult from_row(const database::MetricRow& row);
GateResult from_row(const database::GateRow& row);
CriticalError from_row(const database::CriticalErrorRow& row);

}  // namespace fulcrum
