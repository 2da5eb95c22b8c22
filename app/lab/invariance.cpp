// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/invariance.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/live/performance.h"
#include "assessment/assets/assets.h"
#include "assessment/metrics/invariance.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/registry.h"
#include "database/scoring/scoring.h"
#include "sim_core/lab/chart.h"

namespace fulcrum::app {
namespace {

constexpr std::uint64_t expert_seed = 2001;
/// A change up to this share is rounding.
constexpr double rounding = 1e-9;

RecordedAttempt record(const std::string& task) {
    PerformRequest request;
    request.loaded = load_task_and_scene(task);
    request.operator_level = OperatorLevel::expert;
    request.seed = expert_seed;
    const Performed performed = perform(request, nullptr, Limits());
    const Scene& scene = request.loaded.scene;
    RecordedAttempt attempt;
    attempt.trace = trace_from_samples(
        performed.record.samples, performed.record.events, tissue_labels(scene), scene.tick_rate,
        {scene.instrument(Hand::left) != nullptr, scene.instrument(Hand::right) != nullptr});
    attempt.events = performed.record.events;
    attempt.context = make_metric_context(scene, request.loaded.task, performed.targets);
    return attempt;
}

std::string words(double relative) {
    if (!std::isfinite(relative)) return "absent";
    if (relative <= rounding) return "–";
    return lab::short_number(100 * relative, 2) + " %";
}

/// "f_max, f_sd", or that these are all others.
std::string metrics_text(const AllowedChange& allowed) {
    std::string text;
    for (const std::string& metric : allowed.metrics) text += (text.empty() ? "" : ", ") + metric;
    return text.empty() ? "all others" : text;
}

lab::ResultTable allowed_table() {
    lab::ResultTable table;
    table.name = "lab_invariance_allowed";
    table.columns = {"change", "metrics", "at most", "why"};
    for (const AllowedChange& allowed : allowed_changes())
        table.rows.push_back(
            {row_of(trace_changes, allowed.change).title, metrics_text(allowed),
             std::isfinite(allowed.most) ? lab::short_number(100 * allowed.most, 2) + " %" : "not comparable",
             allowed.why});
    return table;
}

}  // namespace

Measured measure_invariance() {
    std::map<std::string, std::vector<double>> worst;  // by metric
    std::string tasks;
    for (const std::string& task : task_ids()) {
        tasks += (tasks.empty() ? "" : ", ") + task;
        for (const MetricChange& change : compare_changes(record(task))) {
            std::vector<double>& most = worst[change.id];
            most.resize(change.relative.size());
            for (std::size_t k = 0; k < most.size(); ++k) most[k] = std::max(most[k], change.relative[k]);
        }
    }
    Measured measured{lab::ResultPage("lab_invariance", "The same attempts, recorded otherwise",
                                      "fulcrum lab invariance --output docs/results"),
                      {}};
    lab::ResultTable table;
    table.name = "lab_invariance";
    table.columns = {"metric"};
    for (const NameRow<TraceChange>& change : trace_changes) table.columns.emplace_back(change.title);
    table.columns.emplace_back("version");
    nlohmann::json document = nlohmann::json::object();
    for (const Metric& metric : metric_registry()) {
        const auto found = worst.find(metric.descriptor.id);
        if (found == worst.end()) continue;
        std::vector<std::string> row = {found->first};
        for (std::size_t k = 0; k < found->second.size(); ++k) {
            row.push_back(words(found->second[k]));
            document[found->first][trace_changes[k].name] =
                std::isfinite(found->second[k]) ? nlohmann::json(found->second[k]) : nlohmann::json();
        }
        row.push_back(std::to_string(metric.descriptor.version));
        document[found->first]["version"] = metric.descriptor.version;
        table.rows.push_back(std::move(row));
    }
    measured.page.paragraph(
        "An expert's attempt (seed 2001) at each task (" + tasks +
        ") was measured again after each of these changes to its trace. The table gives the largest change "
        "of a metric over tasks, hands and tissues, as a share of "
        "its value "
        "(of its precision where the value is smaller); \"–\": none but rounding; \"absent\": a row was no "
        "longer "
        "measurable. The spike is replaced by the filter of the force metrics, so that it moves none of "
        "them. Version: of the metric.");
    measured.page.table(table);
    measured.page.heading("What a change may do");
    measured.page.paragraph(
        "The tests hold every metric of every task to this table (`Tasks/Invariance.*`). A share is as "
        "above.");
    measured.page.table(allowed_table());
    measured.document = {{"metrics", document}};
    measured.page.document(measured.document);
    return measured;
}

}  // namespace fulcrum::app
