// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "assessment/metrics/registry.h"
#include "assessment/metrics/statement_words.h"
#include "assessment/scoring/gate_rules.h"
#include "assessment/scoring/taken_over.h"
#include "assessment/task/limit_source.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {

namespace {

constexpr double least_novice_z = 0.5;
constexpr int benchmark_gate_limit = 6;

bool has_points(const BenchmarkLevel& level) {
    return level.z_novice && *level.z_novice > least_novice_z;
}

/// Holds a value against an absolute limit.
void judge_absolute(GateResult& gate, const MetricDescriptor& descriptor, double limit) {
    gate.kind = GateKind::absolute;
    gate.limit = limit;
    if (gate.value) gate.passed = keeps_limit(descriptor, gated_value(descriptor, *gate.value), limit);
}

std::string source_of(const BenchmarkLevel& level, const BenchmarkSet& set) {
    LimitSource source;
    source.kind = LimitSource::Kind::range;
    source.of = set.source;
    source.set = set.version;
    source.experts = level.experts;
    source.worst_counted = level.absolute_limit.has_value();
    return limit_source_line(source);
}

void judge_benchmark(GateResult& gate, const MetricDescriptor& descriptor, const BenchmarkLevel& level,
                     const BenchmarkSet& set) {
    gate.provisional = set.provisional;
    gate.limit_source = source_of(level, set);
    if (level.absolute_limit) {
        judge_absolute(gate, descriptor, *level.absolute_limit);
        return;
    }
    gate.limit = limit_of(descriptor, level, set.k_of(level));
    if (!gate.value) return;
    const std::optional<double> scaled = on_scale(descriptor, *gate.value);
    if (!scaled) {
        gate.passed = keeps_limit(descriptor, gated_value(descriptor, *gate.value), *gate.limit);
        return;
    }
    gate.z = z_of(descriptor, level, *scaled);
    gate.passed = *gate.z <= set.k_of(level);
    gate.points = points_of(level, *gate.z);
}

/// A set may narrow an absolute limit to its experts' range; it never widens one.
void narrow(GateResult& gate, const MetricDescriptor& descriptor, const BenchmarkLevel& level,
            const BenchmarkSet& set) {
    const double limit = limit_of(descriptor, level, set.k_of(level));
    if (!keeps_limit(descriptor, limit, *gate.limit)) return;
    gate.limit_source = source_of(level, set);
    gate.provisional = gate.provisional || set.provisional;
    judge_absolute(gate, descriptor, limit);
}

/// A gate whose metric is absent: failed, without points, where the trainee did not do it; not judged where
/// it was not measured.
void judge_absence(GateResult& gate, const BenchmarkLevel* level, const MetricResult* result) {
    if (result == nullptr) {
        gate.absent_because = StatementId::metric_not_computed;
        return;
    }
    gate.absent_because = result->absent_because;
    if (result->absence != Absence::not_done) return;
    gate.passed = false;
    if (level != nullptr && has_points(*level)) gate.points = 0.0;
}

}  // namespace

double gated_value(const MetricDescriptor& descriptor, double value) {
    return descriptor.absolute_value ? std::abs(value) : value;
}

std::optional<double> on_scale(const MetricDescriptor& descriptor, double value) {
    const double x = gated_value(descriptor, value);
    if (descriptor.scale == Scale::raw) return x;
    return x > 0 ? std::optional<double>(std::log(x)) : std::nullopt;
}

double z_of(const MetricDescriptor& descriptor, const BenchmarkLevel& level, double scaled) {
    const double sign = descriptor.direction == Direction::higher ? -1.0 : 1.0;
    return sign * (scaled - level.mean) / level.deviation;
}

double limit_of(const MetricDescriptor& descriptor, const BenchmarkLevel& level, double k) {
    const double sign = descriptor.direction == Direction::higher ? -1.0 : 1.0;
    const double x = level.mean + sign * k * level.deviation;
    return level.scale == Scale::ln ? std::exp(x) : x;
}

bool keeps_limit(const MetricDescriptor& descriptor, double value, double limit) {
    return descriptor.direction == Direction::higher ? value >= limit : value <= limit;
}

std::optional<double> points_of(const BenchmarkLevel& level, double z) {
    if (!has_points(level)) return std::nullopt;
    return 100.0 * std::clamp((*level.z_novice - z) / *level.z_novice, 0.0, 1.0);
}

std::optional<WrongRow> wrong_row(const MetricDescriptor& descriptor, const std::string& hand,
                                  const std::string& tissue) {
    const bool counted = descriptor.needs_events && descriptor.aggregation == Aggregation::count;
    if (descriptor.hands == Hands::each && hand.empty() && !counted)
        return WrongRow{"/hand",
                        {QT_TRANSLATE_NOOP("errors", "'%1' is measured for each hand"), descriptor.id},
                        QT_TRANSLATE_NOOP("errors", "give hand left or right")};
    if (descriptor.hands != Hands::each && !hand.empty())
        return WrongRow{"/hand",
                        {QT_TRANSLATE_NOOP("errors", "'%1' belongs to no single hand"), descriptor.id},
                        QT_TRANSLATE_NOOP("errors", "remove hand")};
    if (!descriptor.per_tissue && !tissue.empty())
        return WrongRow{"/tissue",
                        {QT_TRANSLATE_NOOP("errors", "'%1' has no rows by tissue"), descriptor.id},
                        QT_TRANSLATE_NOOP("errors", "remove tissue")};
    return std::nullopt;
}

GateResult judge_gate(const GateSpec& spec, const std::vector<MetricResult>& metrics,
                      const BenchmarkSet* benchmark) {
    GateResult gate;
    gate.metric = spec.metric;
    gate.hand = spec.hand;
    gate.tissue = spec.tissue;
    gate.kind = spec.kind;
    const MetricDescriptor* descriptor = find_metric(spec.metric);
    if (descriptor == nullptr) {
        gate.absent_because = StatementId::metric_unknown;
        return gate;
    }
    gate.unit = descriptor->unit;
    const MetricResult* result = find_result(metrics, spec.metric, spec.hand, spec.tissue);
    if (result != nullptr) {
        gate.value = result->value;
        gate.evidence = result->evidence;
    }
    const BenchmarkLevel* level = nullptr;
    if (spec.kind == GateKind::absolute) {
        const bool is_of_site = benchmark != nullptr && takes_over(*benchmark, spec);
        gate.limit_source = is_of_site ? taken_over_source(spec.limit_source, *benchmark) : spec.limit_source;
        gate.provisional = spec.provisional && !is_of_site;
        judge_absolute(gate, *descriptor, spec.limit);
        level = benchmark == nullptr ? nullptr : benchmark->find(spec.metric, spec.hand, spec.tissue);
        if (level != nullptr && !level->absolute_limit) narrow(gate, *descriptor, *level, *benchmark);
        level = nullptr;
        if (spec.exclusive && gate.value &&
            std::abs(gated_value(*descriptor, *gate.value) - spec.limit) <= 1e-3 * descriptor->precision)
            gate.passed = false;
    } else {
        level = benchmark == nullptr ? nullptr : benchmark->find(spec.metric, spec.hand, spec.tissue);
        if (level == nullptr) {
            gate.absent_because =
                benchmark == nullptr ? StatementId::no_benchmark : StatementId::no_benchmark_level;
            return gate;
        }
        judge_benchmark(gate, *descriptor, *level, *benchmark);
    }
    if (!gate.value) judge_absence(gate, level, result);
    return gate;
}

nlohmann::json gates_to_json(const std::vector<GateResult>& gates) {
    using nlohmann::json;
    const auto text = [](const std::string& value) { return value.empty() ? json(nullptr) : json(value); };
    const auto number = [](const std::optional<double>& value) {
        return value ? json(*value) : json(nullptr);
    };
    json rows = json::array();
    for (const GateResult& gate : gates)
        rows.push_back({{"metric", gate.metric},
                        {"hand", text(gate.hand)},
                        {"tissue", text(gate.tissue)},
                        {"kind", row_of(gate_kinds, gate.kind).name},
                        {"value", number(gate.value)},
                        {"unit", gate.unit},
                        {"limit", number(gate.limit)},
                        {"limit_source", gate.limit_source},
                        {"z", number(gate.z)},
                        {"points", number(gate.points)},
                        {"passed", gate.passed ? json(*gate.passed) : json(nullptr)},
                        {"provisional", gate.provisional},
                        {"absent_because", text(words_of(gate.absent_because))},
                        {"absent_code", statement_json(gate.absent_because)}});
    return rows;
}

void check_gates(const TaskDefinition& task, const std::string& file) {
    int benchmark_gates = 0;
    for (std::size_t i = 0; i < task.gates.size(); ++i) {
        const GateSpec& gate = task.gates[i];
        const std::string place = "/gates/" + std::to_string(i);
        const auto refuse = [&](const char* key, const Sentence& wrong, const Sentence& hint) {
            throw InputError(file, place + key, wrong, hint);
        };
        const MetricDescriptor* d = find_metric(gate.metric);
        if (d == nullptr)
            refuse("/metric", {QT_TRANSLATE_NOOP("errors", "unknown metric '%1'"), gate.metric},
                   QT_TRANSLATE_NOOP("errors", "give the id of a metric"));
        if (d->direction == Direction::context)
            refuse("/metric", {QT_TRANSLATE_NOOP("errors", "'%1' is context only"), gate.metric},
                   QT_TRANSLATE_NOOP("errors", "gate a metric that is better in one direction"));
        // A gate that stops harm may rest on a value that does not tell experts from novices.
        if (gate.safety.empty() && only_describes(task.context, gate.metric, gate.hand))
            refuse("/metric", {QT_TRANSLATE_NOOP("errors", "'%1' is context in this task"), gate.metric},
                   QT_TRANSLATE_NOOP("errors", "remove it from context, or remove the gate"));
        if (const std::optional<WrongRow> wrong = wrong_row(*d, gate.hand, gate.tissue))
            refuse(wrong->key, wrong->what, wrong->hint);
        if (gate.kind == GateKind::benchmark && ++benchmark_gates > benchmark_gate_limit)
            refuse("", {QT_TRANSLATE_NOOP("errors", "more than %1 benchmark gates"), benchmark_gate_limit},
                   QT_TRANSLATE_NOOP("errors", "show the others without a gate"));
    }
    for (std::size_t i = 0; i < task.metrics.size(); ++i)
        if (find_metric(task.metrics[i]) == nullptr)
            throw InputError(file, "/metrics/" + std::to_string(i),
                             {QT_TRANSLATE_NOOP("errors", "unknown metric '%1'"), task.metrics[i]},
                             QT_TRANSLATE_NOOP("errors", "give the id of a metric"));
}

}  // namespace fulcrum
