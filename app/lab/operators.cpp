// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/operators.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <thread>
#include <utility>

#include "app/lab/kept_pages.h"
#include "app/live/performance.h"
#include "assessment/learning/statistics.h"
#include "assessment/metrics/metric_names.h"
#include "assessment/metrics/registry.h"
#include "database/scoring/scoring.h"
#include "sim_core/lab/chart.h"

namespace fulcrum::app {
namespace {

using lab::short_number;

constexpr int groups = static_cast<int>(std::size(operator_levels));
constexpr int expert = static_cast<int>(OperatorLevel::expert),
              novice = static_cast<int>(OperatorLevel::novice);

/// A metric shown as quality separates experts from novices at least this well, with the interval above
/// chance.
constexpr double least_area = 0.6, chance = 0.5;

using RowName = std::pair<std::string, std::string>;  // metric, hand

struct Outcome {
    bool completed = false, passed = false, identical = false;
    double simulated_s = 0, wall_s = 0;
    std::map<RowName, double> values;
    std::map<RowName, bool> gates;  ///< judged gates: met or not
};

Outcome attempt(const LoadedTask& loaded, const Limits& limits, DeviceClass device_class, OperatorLevel level,
                std::uint64_t seed, bool replayed, std::uint64_t individual) {
    PerformRequest request;
    request.loaded = loaded;
    request.device_class = device_class;
    request.operator_level = level;
    request.seed = seed;
    request.individual = individual;
    const Performed performed = perform(request, nullptr, limits);
    const Score& score = performed.scored.score;
    Outcome outcome;
    outcome.wall_s = performed.wall_s;
    outcome.simulated_s = performed.outcome.ticks * loaded.scene.tick_period();
    outcome.completed = performed.outcome.end == EventKind::completed;
    outcome.passed = score.passed.value_or(false);
    for (const MetricResult& row : performed.scored.metrics)
        if (row.tissue.empty() && row.value) outcome.values[{row.id, row.hand}] = *row.value;
    for (const GateResult& gate : score.gates)
        if (gate.passed) outcome.gates[{gate.metric, gate.hand}] = *gate.passed;
    if (replayed) {
        AttemptEngine again(loaded.scene, loaded.task, seed);
        const ReplayOutcome replay = replay_record(again, performed.record);
        outcome.identical = replay.identical && replay.state_hash == performed.outcome.state_hash;
    }
    return outcome;
}

/// All groups' attempts; values and counts by group.
struct Summary {
    std::array<std::map<RowName, std::vector<double>>, groups> values;
    std::map<RowName, std::array<int, groups>> failed;  ///< by gate
    std::array<int, groups> completed{}, passed{};
    std::map<RowName, std::vector<std::pair<double, double>>> retests;  ///< two attempts of one individual
    int identical = 0;
    double simulated_s = 0, wall_s = 0;

    void add(std::size_t group, const Outcome& outcome) {
        completed[group] += outcome.completed ? 1 : 0;
        passed[group] += outcome.passed ? 1 : 0;
        identical += outcome.identical ? 1 : 0;
        simulated_s += outcome.simulated_s;
        wall_s += outcome.wall_s;
        for (const auto& [name, value] : outcome.values) values[group][name].push_back(value);
        for (const auto& [name, met] : outcome.gates) failed[name][group] += met ? 0 : 1;
    }
    void add_retest(const Outcome& first, const Outcome& second) {
        for (const auto& [name, value] : first.values)
            if (const auto again = second.values.find(name); again != second.values.end())
                retests[name].emplace_back(value, again->second);
    }
    const std::vector<double>& of(int group, const RowName& name) const {
        static const std::vector<double> none;
        const auto& all = values[static_cast<std::size_t>(group)];
        const auto found = all.find(name);
        return found == all.end() ? none : found->second;
    }
};

/// Attempt k of those of measure_operators(): first all groups' attempts, then the second ones of the first
/// `retests` individuals of each group.
struct Plan {
    int seeds = 0, replays = 0, retests = 0;
    DeviceClass device_class = DeviceClass::synthetic;
    int attempts() const { return groups * (seeds + retests); }
    bool again(int k) const { return k >= groups * seeds; }
    int group(int k) const { return again(k) ? (k - groups * seeds) / retests : k / seeds; }
    int number(int k) const { return again(k) ? (k - groups * seeds) % retests : k % seeds; }
};

Outcome perform_one(const LoadedTask& loaded, const Limits& limits, const Plan& plan, int k) {
    constexpr std::uint64_t apart = 500000;  // from the seeds of the first attempts
    const auto individual = static_cast<std::uint64_t>(operators_first_seed + plan.number(k));
    return attempt(loaded, limits, plan.device_class,
                   operator_levels[static_cast<std::size_t>(plan.group(k))].kind,
                   individual + (plan.again(k) ? apart : 0), !plan.again(k) && plan.number(k) < plan.replays,
                   individual);
}

Summary perform_all(const LoadedTask& loaded, const Limits& limits, const Plan& plan) {
    const int count = plan.attempts();
    std::vector<Outcome> outcomes(static_cast<std::size_t>(count));
    std::atomic<int> next{0}, done{0};
    const unsigned workers = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::exception_ptr> errors(workers);
    std::vector<std::thread> threads;
    for (unsigned worker = 0; worker < workers; ++worker) {
        threads.emplace_back([&, worker] {
            try {
                for (int k = next++; k < count; k = next++) {
                    outcomes[static_cast<std::size_t>(k)] = perform_one(loaded, limits, plan, k);
                    std::fprintf(stderr, "%s: %d of %d attempts\n", loaded.task.id.c_str(), ++done, count);
                }
            } catch (...) {
                errors[worker] = std::current_exception();
                next = count;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    Summary summary;
    for (int k = 0; k < count; ++k) {
        const Outcome& outcome = outcomes[static_cast<std::size_t>(k)];
        if (plan.again(k)) {
            const int first = plan.group(k) * plan.seeds + plan.number(k);
            summary.add_retest(outcomes[static_cast<std::size_t>(first)], outcome);
        } else {
            summary.add(static_cast<std::size_t>(plan.group(k)), outcome);
        }
    }
    return summary;
}

/// The values so that higher is better.
std::vector<double> by_quality(const MetricDescriptor& descriptor, std::vector<double> values) {
    for (double& value : values) {
        if (descriptor.absolute_value) value = std::abs(value);
        if (descriptor.direction != Direction::higher) value = -value;
    }
    return values;
}

std::string interval_text(const std::vector<double>& values) {
    if (values.empty()) return "absent";
    const auto interval = median_interval(values);
    if (!interval) return short_number(median_of(values), 4);
    return short_number(interval->median, 4) + " (" + short_number(interval->low, 4) + " to " +
           short_number(interval->high, 4) + ")";
}

std::string three(const std::array<int, groups>& counts) {
    return std::to_string(counts[0]) + ", " + std::to_string(counts[1]) + ", " + std::to_string(counts[2]);
}

/// How many attempts of each group have a value.
std::array<int, groups> counts_of(const Summary& summary, const RowName& name) {
    std::array<int, groups> counts{};
    for (int group = 0; group < groups; ++group)
        counts[static_cast<std::size_t>(group)] = static_cast<int>(summary.of(group, name).size());
    return counts;
}

/// One row a metric and hand; adds the same to `document`. Returns how many quality metrics do not separate.
int add_metric_row(const MetricDescriptor& descriptor, const RowName& name, bool describes,
                   const Summary& summary, lab::ResultTable& table, nlohmann::json& document) {
    const auto area = roc_area(by_quality(descriptor, summary.of(expert, name)),
                               by_quality(descriptor, summary.of(novice, name)));
    const bool quality = descriptor.direction != Direction::context && !describes;
    const auto pairs = summary.retests.find(name);
    const std::optional<double> retest =
        pairs == summary.retests.end() ? std::nullopt : retest_correlation(pairs->second);
    const bool separates = area && area->area >= least_area && area->low > chance;
    const std::array<int, groups> counts = counts_of(summary, name);
    const std::string direction = metric_directions[static_cast<std::size_t>(descriptor.direction)].name;
    table.rows.push_back({name.first, name.second, direction, area ? short_number(area->area, 3) : "absent",
                          area ? short_number(area->low, 3) + " to " + short_number(area->high, 3) : "",
                          !quality    ? cell_context
                          : separates ? cell_yes
                                      : "**no**",
                          retest ? short_number(*retest, 2) : "", interval_text(summary.of(expert, name)),
                          interval_text(summary.of(1, name)), interval_text(summary.of(novice, name)),
                          three(counts), std::to_string(descriptor.version)});
    nlohmann::json row = {{"metric", name.first},
                          {"hand", name.second.empty() ? nlohmann::json() : nlohmann::json(name.second)},
                          {"unit", descriptor.unit},
                          {"direction", direction},
                          {"auc", area ? nlohmann::json(area->area) : nlohmann::json()},
                          {"auc_low", area ? nlohmann::json(area->low) : nlohmann::json()},
                          {"auc_high", area ? nlohmann::json(area->high) : nlohmann::json()},
                          {"retest", retest ? nlohmann::json(*retest) : nlohmann::json()},
                          {"separates", quality ? nlohmann::json(separates) : nlohmann::json()},
                          {"values", counts},
                          {"version", descriptor.version}};
    for (int group = 0; group < groups; ++group)
        row[operator_levels[static_cast<std::size_t>(group)].name] = summary.of(group, name);
    document.push_back(std::move(row));
    return quality && !separates ? 1 : 0;
}

/// The metrics that the task shows, in the registry's order.
int add_metrics(const TaskDefinition& task, const Summary& summary, lab::ResultTable& table,
                nlohmann::json& document) {
    int failing = 0;
    for (const Metric& metric : metric_registry()) {
        const MetricDescriptor& descriptor = metric.descriptor;
        if (std::find(task.metrics.begin(), task.metrics.end(), descriptor.id) == task.metrics.end())
            continue;
        for (const char* hand : {"", "left", "right"}) {
            const RowName name{descriptor.id, hand};
            if (summary.of(expert, name).empty() && summary.of(novice, name).empty()) continue;
            failing += add_metric_row(descriptor, name, only_describes(task.context, name.first, name.second),
                                      summary, table, document);
        }
    }
    return failing;
}

/// What the gate is kept for if it seldom fails anyone; "": the task does not say.
std::string safety_of(const TaskDefinition& task, const RowName& name) {
    for (const GateSpec& gate : task.gates)
        if (gate.metric == name.first && (gate.hand.empty() || gate.hand == name.second)) return gate.safety;
    return {};
}

lab::ResultTable gate_table(const TaskDefinition& task, const Summary& summary, int seeds,
                            nlohmann::json& document) {
    lab::ResultTable table;
    table.name = "operators_" + task.id + "_gates";
    table.columns = {"gate",           "hand",
                     "experts failed", "intermediates failed",
                     "novices failed", "fails 1 novice in 10, or is kept because"};
    for (const auto& [name, failed] : summary.failed) {
        const bool used = 10 * failed[novice] >= seeds;
        const std::string safety = safety_of(task, name);
        table.rows.push_back({name.first, name.second, std::to_string(failed[0]), std::to_string(failed[1]),
                              std::to_string(failed[2]),
                              used             ? cell_yes
                              : safety.empty() ? cell_no_reason
                                               : safety});
        document.push_back({{"metric", name.first},
                            {"hand", name.second.empty() ? nlohmann::json() : nlohmann::json(name.second)},
                            {"failed", failed},
                            {"safety", safety}});
    }
    return table;
}

/// Who passes of each group is right: experts in 80 to 95 % of attempts, intermediates in 5 to 40 %, novices
/// in less than 3 %.
bool in_the_bands(const std::array<int, groups>& passed, int seeds) {
    const auto share = [&](int group) {
        return 100.0 * passed[static_cast<std::size_t>(group)] / std::max(1, seeds);
    };
    return share(expert) >= 80 && share(expert) <= 95 && share(1) >= 5 && share(1) <= 40 && share(novice) < 3;
}

/// One row a task and class of devices; adds the same to `document`.
std::vector<std::string> passes_row(const LoadedTask& loaded, DeviceClass device_class, int seeds,
                                    lab::ResultTable& gates, nlohmann::json& document) {
    const Limits limits = limits_for(loaded.task, loaded.scene, device_class);
    const std::string name = row_of(device_classes, device_class).name;
    std::vector<std::string> row = {loaded.task.id, name};
    if (limits.comparable() == nullptr) {
        row.insert(row.end(), {"no set", "", "", ""});
        return row;
    }
    const Summary summary = perform_all(loaded, limits, {seeds, 0, 0, device_class});
    for (const int passed : summary.passed)
        row.push_back(std::to_string(passed) + " (" + short_number(100.0 * passed / seeds, 3) + " %)");
    for (const auto& [gate, failed] : summary.failed) {
        std::vector<std::string> cells = {loaded.task.id, name, gate.first, gate.second};
        for (const int count : failed) cells.push_back(std::to_string(count));
        gates.rows.push_back(std::move(cells));
    }
    const bool right = in_the_bands(summary.passed, seeds);
    row.push_back(right ? "yes" : "**no**");
    document.push_back({{"task", loaded.task.id},
                        {"device_class", name},
                        {"seeds", seeds},
                        {"passed", summary.passed},
                        {"completed", summary.completed},
                        {"right", right}});
    return row;
}

}  // namespace

Measured measure_passes(const std::vector<std::string>& tasks, int seeds) {
    Measured measured{
        lab::ResultPage("passes_by_device",
                        "Who passes each task with each class of devices, " + std::to_string(seeds) +
                            " seeds from " + std::to_string(operators_first_seed),
                        "fulcrum lab passes --seeds " + std::to_string(seeds) + " --output docs/results"),
        nlohmann::json::object({{"passes", nlohmann::json::array()}})};
    lab::ResultTable table;
    table.name = "passes_by_device";
    table.columns = {"task", "device class", "experts", "intermediates", "novices", "within the ranges"};
    lab::ResultTable gates;
    gates.name = "passes_by_device_gates";
    gates.columns = {"task",           "device class",         "gate",          "hand",
                     "experts failed", "intermediates failed", "novices failed"};
    for (const std::string& task : tasks) {
        const LoadedTask loaded = load_task_and_scene(task);
        const std::vector<GateSpec>& judged = loaded.task.gates;
        if (std::none_of(judged.begin(), judged.end(),
                         [](const GateSpec& gate) { return gate.kind == GateKind::benchmark; }))
            continue;  // B0: the same for every class
        for (const DeviceClass device_class : loaded.task.device_classes)
            if (device_class != DeviceClass::haptic)
                table.rows.push_back(
                    passes_row(loaded, device_class, seeds, gates, measured.document["passes"]));
    }
    measured.page.paragraph(
        "Attempts that pass with the delivered benchmark set of the task and class. Operators work through a "
        "model of the device (DECISIONS.md). Devices with force have no such model: the pages of operators "
        "count those attempts. Expected: 80 to 95 % of experts, 5 to 40 % of intermediates, less than 3 % of "
        "novices.");
    measured.page.table(table);
    measured.page.paragraph("Whom each gate fails:");
    measured.page.table(gates);
    measured.page.document(measured.document);
    return measured;
}

Measured measure_variant_passes(const std::vector<std::string>& tasks, int seeds) {
    Measured measured{lab::ResultPage("passes_by_variant",
                                      "Who passes each variant of each task, " + std::to_string(seeds) +
                                          " seeds from " + std::to_string(operators_first_seed),
                                      "fulcrum lab passes --variants --seeds " + std::to_string(seeds) +
                                          " --output docs/results"),
                      nlohmann::json::object({{"passes", nlohmann::json::array()}})};
    lab::ResultTable table;
    table.name = "passes_by_variant";
    table.columns = {"task", "variant", "judged by the set of", "experts", "intermediates", "novices"};
    for (const std::string& task : tasks) {
        for (const TaskVariant& variant : load_task_and_scene(task).task.variants) {
            const LoadedTask loaded = load_task_and_scene(TaskRequest{task, variant.id, {}});
            const Limits limits = limits_for(loaded.task, loaded.scene, DeviceClass::synthetic);
            std::vector<std::string> row = {task, variant.id, variant.family};
            if (limits.comparable() == nullptr) {
                row.insert(row.end(), {"no set", "", ""});
                table.rows.push_back(std::move(row));
                continue;
            }
            const Summary summary = perform_all(loaded, limits, {seeds, 0, 0});
            for (const int passed : summary.passed)
                row.push_back(std::to_string(passed) + " (" + short_number(100.0 * passed / seeds, 3) +
                              " %)");
            table.rows.push_back(std::move(row));
            measured.document["passes"].push_back({{"task", task},
                                                   {"variant", variant.id},
                                                   {"family", variant.family},
                                                   {"seeds", seeds},
                                                   {"passed", summary.passed},
                                                   {"completed", summary.completed}});
        }
    }
    measured.page.paragraph(
        "Attempts of synthetic operators who move the handle freely, as with a device that renders force. A "
        "variant is judged by the benchmark set of its family (DECISIONS.md, *Variants in the task's file*): "
        "experts have to pass there as often as in the standard variant, and novices not.");
    measured.page.table(table);
    measured.page.document(measured.document);
    return measured;
}

Measured measure_operators(const std::string& task, int seeds, int replays, int retests) {
    const LoadedTask loaded = load_task_and_scene(task);
    const std::string& id = loaded.task.id;
    const Limits limits = limits_for(loaded.task, loaded.scene, DeviceClass::synthetic);
    replays = std::min(replays, seeds);
    retests = std::min(retests, seeds);
    const Summary summary = perform_all(loaded, limits, {seeds, replays, retests});
    Measured measured{lab::ResultPage("operators_" + id,
                                      id + ": experts, intermediates, novices, " + std::to_string(seeds) +
                                          " seeds from " + std::to_string(operators_first_seed),
                                      "fulcrum lab operators " + id + " --seeds " + std::to_string(seeds) +
                                          " --replays " + std::to_string(replays) + " --retests " +
                                          std::to_string(retests) + " --output docs/results"),
                      {}};
    lab::ResultPage& page = measured.page;
    nlohmann::json metrics = nlohmann::json::array(), gates = nlohmann::json::array();
    lab::ResultTable table;
    table.name = "operators_" + id;
    table.columns = {"metric", "hand",   "better",       "AUC",    "95 % interval", "separates",
                     "retest", "expert", "intermediate", "novice", "values",        "version"};
    const int failing = add_metrics(loaded.task, summary, table, metrics);
    page.paragraph(
        "AUC: chance that a random expert is better than a random novice in the metric's direction; 0.5 is "
        "chance (for context metrics: that the expert's value is lower). Separates: AUC at least " +
        short_number(least_area) +
        " and its interval (Newcombe, method 5) above 0.5. Medians of each group with 95 % intervals from "
        "order statistics. Retest: intraclass correlation ICC(1,1) of two attempts of the same individual, "
        "individuals "
        "of all groups. Values: how many attempts of experts, intermediates and novices have one; an AUC is "
        "computed from those of the first and the last. Version: of the metric. Quality metrics that do not "
        "separate: " +
        std::to_string(failing) + ".");
    page.table(table);
    page.heading("Gates");
    page.table(gate_table(loaded.task, summary, seeds, gates));
    page.paragraph(
        "Of " + std::to_string(seeds) +
        " experts, intermediates and novices, completed: " + three(summary.completed) + "; passed: " +
        (limits.comparable() != nullptr ? three(summary.passed) : "none, because there is no benchmark set") +
        ". Replayed bit for bit: " + std::to_string(summary.identical) + " of " +
        std::to_string(groups * replays) + ". " + short_number(summary.simulated_s / summary.wall_s) +
        " times real time on one core, with operator, record and score.");
    page.paragraph(
        "The groups are defined so that experts are steadier, faster and gentler. This page shows that "
        "the "
        "tasks and metrics distinguish the groups; it does not show that they distinguish people.");
    measured.document = {{"task", id},
                         {"seeds", seeds},
                         {"completed", summary.completed},
                         {"passed", summary.passed},
                         {"replayed", groups * replays},
                         {"identical", summary.identical},
                         {"real_time_factor", summary.simulated_s / summary.wall_s},
                         {"not_separating", failing},
                         {"metrics", metrics},
                         {"gates", gates}};
    page.document(measured.document);
    return measured;
}

}  // namespace fulcrum::app
