// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/scoring.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/version.h"
#include "database/rows/crypto.h"
#include "database/scoring/benchmark_files.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/scene/standard_names.h"

namespace fulcrum {

namespace {

std::string file_of(const BenchmarkKey& key) {
    return asset_path("benchmarks/" + benchmark_name(key) + ".json");
}
bool there_is(const BenchmarkKey& key) {
    return std::filesystem::exists(file_of(key));
}

/// Why a task with limits has none of this key; the nearest ones say what differs. Empty: it has none.
Statement why_none(const BenchmarkKey& key, DeviceClass used) {
    if (there_is({key.task, key.variant, key.device_class, standard_fidelity}))
        return {StatementId::fidelity_differs,
                {{"limits", std::string(standard_fidelity)}, {"used", key.fidelity}}};
    if (there_is({key.task, standard_variant, key.device_class, standard_fidelity}))
        return {StatementId::variant_differs,
                {{"limits", std::string(standard_variant)}, {"used", key.variant}}};
    if (there_is({key.task, standard_variant, DeviceClass::haptic, standard_fidelity}))
        return {StatementId::device_class_differs,
                {{"device", std::string(row_of(device_classes, used).name)}}};
    return {};
}

/// Why an attempt in this scene is not compared with the set: the cutting parameters differ from those of the
/// scene that the set was made in; a set without any means those of the scene file.
Statement why_other_tissue(const BenchmarkSet& set, const Scene& scene, const TaskDefinition& task) {
    const CuttingValues used = cutting_values(scene);
    if (used.empty() && set.cutting.empty()) return {};
    const CuttingValues made_with = set.cutting.empty() ? cutting_of_file(task, scene.variant) : set.cutting;
    const std::string difference = cutting_difference(used, made_with);
    if (difference.empty()) return {};
    return {StatementId::cutting_differs, {{"difference", difference}}};
}

}  // namespace

std::string Limits::name() const {
    if (!set) return {};
    return benchmark_name(set->key()) + "-" + (set->provisional ? "provisional" : "site") + "@" +
           std::to_string(set->version);
}

Limits benchmark_in_force(const BenchmarkKey& key) {
    const std::string path = file_of(key);
    if (!std::filesystem::exists(path)) return {};
    const std::string text = read_text_file(path, JsonLimits().bytes);
    BenchmarkSet set;
    try {
        set = parse_benchmark(text, path);
    } catch (const OutdatedSet& outdated) {
        Limits none;
        none.not_comparable = Statement(StatementId::limits_outdated, {{"metric", outdated.metric()}});
        return none;
    }
    if (benchmark_name(set.key()) != benchmark_name(key))
        throw InputError(
            path, "/",
            {QT_TRANSLATE_NOOP("errors", "holds the set %1, not %2"), benchmark_name(set.key()),
             benchmark_name(key)},
            QT_TRANSLATE_NOOP("errors", "name the file after its task, variant, device class and fidelity"));
    return Limits(std::move(set),
                  {"benchmarks/" + benchmark_name(key) + ".json", database::sha256_hex(text)});
}

CuttingValues cutting_of_file(const TaskDefinition& task, const std::string& variant) {
    std::string file = task.scene;
    for (const TaskVariant& one : task.variants)
        if (one.id == variant) file = one.scene;
    return cutting_values(load_scene(asset_path("scenes/" + file)));
}

Limits limits_for(const TaskDefinition& task, const Scene& scene, DeviceClass device_class) {
    const bool needed = std::any_of(task.gates.begin(), task.gates.end(),
                                    [](const GateSpec& gate) { return gate.kind == GateKind::benchmark; });
    if (!needed) return {};
    const BenchmarkKey key{task.id, variant_family(task, scene.variant), limits_class(device_class),
                           scene.fidelity.id};
    Limits limits = benchmark_in_force(key);
    if (limits.set) {
        limits.not_comparable = why_other_tissue(*limits.set, scene, task);
    } else if (limits.not_comparable.empty()) {
        limits.not_comparable = why_none(key, device_class);
    }
    return limits;
}

Limits limits_at_start(const TaskDefinition& task, const Scene& scene, DeviceClass device_class,
                       const std::string& name, const std::vector<database::AssetFile>& assets) {
    Limits limits = limits_for(task, scene, device_class);
    const auto then = std::find_if(assets.begin(), assets.end(), [&](const database::AssetFile& file) {
        return file.name == limits.file.name;
    });
    const bool same = assets.empty() || limits.file.name.empty() ||
                      (then != assets.end() && then->digest == limits.file.digest);
    const bool outdated = limits.not_comparable.id() == StatementId::limits_outdated;
    if (outdated || (limits.name() == name && same)) return limits;
    limits.set.reset();
    limits.file = {};
    limits.not_comparable = StatementId::limits_replaced;
    for (const database::AssetFile& file : assets)
        if (file.name.rfind("benchmarks/", 0) == 0)
            limits.replaced_provisional =
                superseded_is_provisional(asset_path(file.name), file.digest).value_or(false);
    return limits;
}

std::vector<std::string> tissue_labels(const Scene& scene) {
    std::vector<std::string> labels;
    for (const TissueSpec& tissue : scene.tissues) labels.push_back(tissue.label);
    return labels;
}

ScoredAttempt score_record(const Scene& scene, const TaskDefinition& task,
                           const std::vector<TargetSphere>& targets, const std::vector<TickSample>& samples,
                           const std::vector<Event>& events, const Limits& limits) {
    const std::array<bool, hand_count> hands = {scene.instrument(Hand::left) != nullptr,
                                                scene.instrument(Hand::right) != nullptr};
    return score_trace(scene, task, targets,
                       trace_from_samples(samples, events, tissue_labels(scene), scene.tick_rate, hands),
                       events, limits);
}

ScoredAttempt score_trace(const Scene& scene, const TaskDefinition& task,
                          const std::vector<TargetSphere>& targets, const Trace& trace,
                          const std::vector<Event>& events, const Limits& limits) {
    ScoredAttempt scored;
    const MetricContext context = make_metric_context(scene, task, targets);
    scored.metrics = compute_metrics(trace, events, context);
    if (context.specimen)
        scored.pathology = pathology_of_events(events, trace.tick_period, trace.end, *context.specimen);
    scored.state = attempt_state(events);
    scored.duration_s = trace.t.empty() ? 0 : trace.t.back();
    scored.score =
        score_attempt(task, trace, events, scored.metrics, limits.comparable(), limits.not_comparable);
    // A failure counts by the set that was in force at the start (attempt_query.cpp).
    for (GateResult& gate : scored.score.gates) {
        if (!limits.replaced_provisional || gate.absent_because.id() != StatementId::limits_replaced)
            continue;
        gate.provisional = scored.score.provisional = true;
    }
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

MetricResult from_row(const database::MetricRow& row) {
    MetricResult result;
    result.id = row.id;
    result.version = row.version;
    result.hand = row.hand;
    result.tissue = row.tissue;
    result.value = row.value;
    result.unit = row.unit;
    result.direction = row.direction;
    result.absence = row.value ? Absence::none : Absence::not_measured;
    result.absent_because = row.absent_because;
    for (const auto& [begin, end] : row.evidence) result.evidence.push_back({begin, end});
    return result;
}

GateResult from_row(const database::GateRow& row) {
    GateResult gate;
    gate.metric = row.metric;
    gate.hand = row.hand;
    gate.tissue = row.tissue;
    gate.kind = row.kind;
    gate.value = row.value;
    gate.unit = row.unit;
    gate.limit = row.limit;
    gate.limit_source = row.limit_source;
    gate.z = row.z;
    gate.points = row.points;
    gate.passed = row.passed;
    gate.provisional = row.provisional;
    gate.absent_because = row.not_passed_because;
    return gate;
}

CriticalError from_row(const database::CriticalErrorRow& row) {
    return {row.kind, row.hand, row.tissue, row.time_s};
}

}  // namespace fulcrum
