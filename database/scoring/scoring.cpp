// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/scoring.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/version.h"

namespace fulcrum {

std::optional<BenchmarkSet> benchmark_in_force(const std::string& task_id) {
    const std::string path = asset_path("benchmarks/" + task_id + ".json");
    if (!std::filesystem::exists(path)) return std::nullopt;
    return load_benchmark(path);
}

Statement why_not_comparable(const BenchmarkSet& benchmark, const Scene& scene,
                             const std::string& scene_file) {
    const CuttingValues used = cutting_values(scene);
    if (used.empty() && benchmark.cutting.empty()) return {};
    const CuttingValues made_with = benchmark.cutting.empty()
                                        ? cutting_values(load_scene(asset_path("scenes/" + scene_file)))
                                        : benchmark.cutting;
    const std::string difference = cutting_difference(used, made_with);
    if (difference.empty()) return {};
    return {StatementId::cutting_differs, {{"difference", difference}}};
}

std::vector<std::string> tissue_labels(const Scene& scene) {
    std::vector<std::string> labels;
    for (const TissueSpec& tissue : scene.tissues) labels.push_back(tissue.label);
    return labels;
}

ScoredAttempt score_record(const Scene& scene, const TaskDefinition& task,
                           const std::vector<Vector3>& targets, const std::vector<TickSample>& samples,
                           const std::vector<Event>& events, const BenchmarkSet* benchmark) {
    const std::array<bool, hand_count> hands = {scene.instrument(Hand::left) != nullptr,
                                                scene.instrument(Hand::right) != nullptr};
    return score_trace(scene, task, targets,
                       trace_from_samples(samples, events, tissue_labels(scene), scene.tick_rate, hands),
                       events, benchmark);
}

ScoredAttempt score_trace(const Scene& scene, const TaskDefinition& task, const std::vector<Vector3>& targets,
                          const Trace& trace, const std::vector<Event>& events,
                          const BenchmarkSet* benchmark) {
    ScoredAttempt scored;
    const MetricContext context = make_metric_context(scene, task, targets);
    scored.metrics = compute_metrics(trace, events, context);
    if (context.specimen)
        scored.pathology = pathology_of_events(events, trace.tick_period, trace.end, *context.specimen);
    scored.state = attempt_state(events);
    scored.duration_s = trace.t.empty() ? 0 : trace.t.back();
    const Statement other =
        benchmark == nullptr ? Statement() : why_not_comparable(*benchmark, scene, task.scene);
    scored.score =
        score_attempt(task, trace, events, scored.metrics, other.empty() ? benchmark : nullptr, other);
    return scored;
}

namespace {

database::MetricRow to_row(const MetricResult& result) {
    database::MetricRow row;
    row.id = result.id;
    row.version = result.version;
    row.hand = result.hand;
    row.tissue = result.tissue;
    row.value = result.value;
    row.absent_because = result.absent_because;
    row.unit = result.unit;
    row.direction = result.direction;
    for (const TimeInterval& interval : result.evidence)
        row.evidence.emplace_back(interval.begin, interval.end);
    return row;
}

database::GateRow to_row(const GateResult& gate) {
    database::GateRow row;
    row.metric = gate.metric;
    row.hand = gate.hand;
    row.tissue = gate.tissue;
    row.kind = gate.kind;
    row.value = gate.value;
    row.unit = gate.unit;
    row.limit = gate.limit;
    row.limit_source = gate.limit_source;
    row.z = gate.z;
    row.points = gate.points;
    row.passed = gate.passed;
    row.provisional = gate.provisional;
    row.not_passed_because = gate.absent_because;
    return row;
}

}  // namespace

database::ScoreRow to_row(const ScoredAttempt& scored, const std::string& limits) {
    database::ScoreRow row;
    row.program_version = program_version;
    row.limits = limits;
    row.passed = scored.score.passed;
    row.not_scored_because = scored.score.not_scored_because;
    row.points = scored.score.points;
    row.advice = scored.score.advice;
    for (const GateResult& gate : scored.score.gates) row.gates.push_back(to_row(gate));
    for (const MetricResult& metric : scored.metrics) row.metrics.push_back(to_row(metric));
    if (scored.pathology) row.pathology = pathology_json(*scored.pathology);
    for (const CriticalError& error : scored.score.critical_errors) {
        row.critical_errors.push_back({error.time_s, error.event, error.hand, error.tissue, error.event});
    }
    return row;
}

std::string limits_name(const BenchmarkSet* benchmark) {
    if (benchmark == nullptr) return {};
    return benchmark->task + "-" + (benchmark->provisional ? "provisional" : "site") + "@" +
           std::to_string(benchmark->version);
}

}  // namespace fulcrum
