// SPDX-License-Identifier: Apache-2.0
#include "assessment/metrics/metrics_json.h"

#include <nlohmann/json.hpp>

#include "assessment/metrics/metric_names.h"
#include "assessment/metrics/registry.h"
#include "assessment/metrics/statement_words.h"
#include "assessment/task/specimen_plan.h"
#include "assessment/trace/trace_csv.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {

namespace {

nlohmann::json text_or_null(const std::string& text) {
    return text.empty() ? nlohmann::json(nullptr) : nlohmann::json(text);
}

std::string text_of(const nlohmann::json& row, const char* key) {
    return row.at(key).is_null() ? std::string() : row.at(key).get<std::string>();
}

template <typename Row, std::size_t n>
auto named(const nlohmann::json& row, const char* key, const Row (&names)[n], const std::string& file,
           const std::string& place) {
    const auto word = row.at(key).get<std::string>();
    const Row* found = find_row(names, word);
    if (found == nullptr)
        throw InputError(file, place + "/" + key, {QT_TRANSLATE_NOOP("errors", "unknown name \"%1\""), word},
                         {QT_TRANSLATE_NOOP("errors", "give one of: %1"), names_of(names)});
    return found->kind;
}

MetricResult result_from_json(const nlohmann::json& row, const std::string& file, const std::string& place) {
    MetricResult result;
    result.id = row.at("id").get<std::string>();
    result.version = row.at("version").get<int>();
    result.hand = text_of(row, "hand");
    result.tissue = text_of(row, "tissue");
    if (!row.at("value").is_null()) result.value = row.at("value").get<double>();
    // Files from before reasons had ids hold the sentence alone.
    const auto code = row.find("absent_code");
    result.absent_because = code != row.end() && code->is_object()
                                ? statement_of(code->dump())
                                : Statement::plain(text_of(row, "absent_because"));
    result.unit = row.at("unit").get<std::string>();
    result.direction = named(row, "direction", metric_directions, file, place);
    // Files from before absences had kinds.
    if (!result.value)
        result.absence = row.contains("absence") ? named(row, "absence", metric_absences, file, place)
                                                 : Absence::not_measured;
    for (const auto& interval : row.at("evidence"))
        result.evidence.push_back({interval.at(0).get<double>(), interval.at(1).get<double>()});
    if (row.contains("count")) result.count = row.at("count").get<int>();
    return result;
}

}  // namespace

nlohmann::json metrics_to_json(const std::vector<MetricResult>& results) {
    nlohmann::json rows = nlohmann::json::array();
    for (const MetricResult& result : results) {
        nlohmann::json evidence = nlohmann::json::array();
        for (const TimeInterval& interval : result.evidence)
            evidence.push_back({interval.begin, interval.end});
        nlohmann::json row = {
            {"id", result.id},
            {"version", result.version},
            {"hand", text_or_null(result.hand)},
            {"tissue", text_or_null(result.tissue)},
            {"value", result.value ? nlohmann::json(*result.value) : nlohmann::json(nullptr)},
            {"absent_because", text_or_null(words_of(result.absent_because))},
            {"absent_code", statement_json(result.absent_because)},
            {"unit", result.unit},
            {"direction", row_of(metric_directions, result.direction).name},
            {"evidence", std::move(evidence)}};
        if (!result.value) row["absence"] = row_of(metric_absences, result.absence).name;
        if (result.count) row["count"] = *result.count;
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<MetricResult> metrics_from_json(const nlohmann::json& rows, const std::string& file) {
    std::vector<MetricResult> results;
    std::size_t index = 0;
    try {
        if (!rows.is_array())
            throw InputError(file, "/metrics", QT_TRANSLATE_NOOP("errors", "not a list"),
                             QT_TRANSLATE_NOOP("errors", "give the metrics array of an attempt"));
        for (; index < rows.size(); ++index)
            results.push_back(result_from_json(rows[index], file, "/metrics/" + std::to_string(index)));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file, "/metrics/" + std::to_string(index), error.what(),
                         QT_TRANSLATE_NOOP("errors", "give every key of a metric row"));
    }
    return results;
}

MetricContext make_metric_context(const Scene& scene, const TaskDefinition& task,
                                  const std::vector<TargetSphere>& targets) {
    MetricContext context;
    if (scene.camera_targets) context.framing_distance = scene.camera_targets->distance;
    for (const TissueSpec& tissue : scene.tissues) {
        TissueLimits limits;
        limits.label = tissue.label;
        if (tissue.force_limit > 0) limits.force = tissue.force_limit;
        context.tissues.push_back(std::move(limits));
    }
    context.targets = targets;
    context.described = task.context;
    context.specimen = make_specimen_plan(scene, task);
    for (const Goal& goal : task.goals) {
        context.phases.push_back(goal.id);
        if (goal.kind == GoalKind::divide_line && !context.cut)
            context.cut = CutPlan{goal.length_m, goal.tolerance_m, goal.corridor_m, goal.traction_low_n_m,
                                  goal.traction_high_n_m};
    }
    return context;
}

nlohmann::json metrics_of_trace(const Trace& trace, const std::string& file,
                                const std::optional<MetricContext>& context) {
    MetricContext known = context.value_or(MetricContext{});
    known.events_recorded = false;
    nlohmann::json ignored = nlohmann::json::array();
    for (const std::string& column : trace.ignored_columns) ignored.push_back(column);
    nlohmann::json gaps = nlohmann::json::array();
    for (const TimeInterval& gap : trace.gaps) gaps.push_back({gap.begin, gap.end});
    return {{"file", file},
            {"samples", trace.t.size()},
            {"duration_s", trace.t.back() - trace.t.front()},
            {"mean_rate_hz", trace.mean_rate()},
            {"ignored_columns", std::move(ignored)},
            {"gaps", std::move(gaps)},
            {"replaced_force_samples", replaced_force_samples(trace)},
            {"metrics", metrics_to_json(compute_metrics(trace, {}, known))}};
}

}  // namespace fulcrum
