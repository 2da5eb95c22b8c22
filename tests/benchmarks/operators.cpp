// SPDX-License-Identifier: Apache-2.0
// Experts, intermediates and novices on a task over 20 seeds outside the benchmarks' own: medians with 95 %
// intervals by order statistics, points against the task's set, and whether every attempt replays bit for
// bit. Prints the page, or writes it into a folder.
// usage: benchmark_operators TASK [seeds] [FOLDER] [seeds replayed]
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "assessment/attempt/memory_sink.h"
#include "assessment/learning/statistics.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/operators/operator.h"
#include "assessment/scoring/score.h"
#include "sim_core/lab/chart.h"
#include "sim_core/lab/result_page.h"
#include "tests/support/support.h"

namespace {

using namespace fulcrum;

struct Outcome {
    bool completed = false, identical = false, passed = false;
    double simulated_s = 0, wall_s = 0;
    std::map<std::string, double> values;
};

Outcome attempt(const TaskDefinition& task, const Scene& scene, const BenchmarkSet* benchmark,
                const std::string& preset, std::uint64_t seed, bool replayed) {
    const auto begin = std::chrono::steady_clock::now();
    AttemptEngine engine(scene, task, seed);
    const auto rig = make_operator(preset, task, scene, seed);
    MemorySink sink;
    const RunOutcome run = run_headless(engine, *rig, sink);
    Outcome outcome;
    outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    outcome.simulated_s = run.ticks * scene.tick_period();
    outcome.completed = run.end == EventKind::completed;
    std::vector<std::string> tissues;
    for (const TissueSpec& tissue : scene.tissues) tissues.push_back(tissue.label);
    const Trace trace = trace_from_samples(sink.record.samples, sink.record.events, tissues, scene.tick_rate);
    MetricContext context = make_metric_context(scene, task, {});
    const std::vector<MetricResult> rows = compute_metrics(trace, sink.record.events, context);
    const Score score = score_attempt(task, trace, sink.record.events, rows, benchmark);
    if (score.points) outcome.values["points"] = *score.points;
    outcome.passed = score.passed.value_or(false);
    for (const MetricResult& row : rows) {
        const bool cut =
            context.cut && (row.id == "traction_eff" || row.id == "cut_dev" || row.id == "plane_dev" ||
                            row.id == "plane_dev_p95" || row.id == "area_developed");
        const bool field = scene.field() != nullptr &&
                           (row.id == "energy_safe" || row.id == "lateral_heat" || row.id == "bleed_ml" ||
                            (row.id == "energy_time" && row.value && *row.value > 0));
        if (!cut && !field && row.id != "time" && row.id != "path_len" && row.id != "f_max" &&
            row.id != "sparc")
            continue;
        if (row.tissue.empty() && row.value)
            outcome.values[row.id + (row.hand.empty() ? "" : " " + row.hand)] = *row.value;
    }
    if (!replayed) return outcome;
    AttemptEngine again(scene, task, seed);
    const ReplayOutcome replay = replay_record(again, sink.record);
    outcome.identical = replay.identical && replay.state_hash == run.state_hash;
    return outcome;
}

/// Standard deviation over the magnitude of the mean: variation between individuals.
double relative_spread(const std::vector<double>& values) {
    const double deviation = sample_deviation(values);
    return deviation > 0 ? deviation / std::abs(mean_of(values)) : 0;
}

constexpr int groups = 3;
constexpr const char* presets[groups] = {"expert", "intermediate", "novice"};

/// What the attempts of all groups add up to; counts and values by group.
struct Summary {
    std::map<std::string, std::vector<double>> values[groups];
    int completed[groups] = {0, 0, 0}, passed[groups] = {0, 0, 0}, identical = 0;
    double simulated = 0, wall = 0;

    void add(int group, const Outcome& outcome) {
        completed[group] += outcome.completed ? 1 : 0;
        passed[group] += outcome.passed ? 1 : 0;
        identical += outcome.identical ? 1 : 0;
        simulated += outcome.simulated_s;
        wall += outcome.wall_s;
        for (const auto& [name, value] : outcome.values) values[group][name].push_back(value);
    }
};

/// Every group's attempts on the task, on all cores; the first `replays` seeds of a group are replayed too.
Summary perform_all(const TaskDefinition& task, const std::optional<BenchmarkSet>& benchmark, int seeds,
                    int replays) {
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    std::vector<Outcome> outcomes(static_cast<std::size_t>(groups * seeds));
    std::atomic<int> next{0};
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
        threads.emplace_back([&] {
            for (int k = next++; k < groups * seeds; k = next++) {
                outcomes[static_cast<std::size_t>(k)] =
                    attempt(task, scene, benchmark ? &*benchmark : nullptr, presets[k / seeds],
                            2000 + static_cast<std::uint64_t>(k % seeds), k % seeds < replays);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    Summary summary;
    for (int k = 0; k < groups * seeds; ++k) summary.add(k / seeds, outcomes[static_cast<std::size_t>(k)]);
    return summary;
}

/// One row a metric: medians with intervals of the three groups. `document` gets the same as JSON.
lab::ResultTable metric_table(const std::string& name, const Summary& summary, nlohmann::json& document) {
    using lab::short_number;
    lab::ResultTable table;
    table.name = name;
    table.columns = {"metric",        "expert: median", "95 % interval", "spread", "intermediate: median",
                     "95 % interval", "novice: median", "95 % interval", "spread", "apart",
                     "ordered"};
    const auto percent = [](double value) { return short_number(100 * value, 2) + " %"; };
    document = nlohmann::json::array();
    for (const auto& [metric, expert] : summary.values[0]) {
        const auto of_group = [&, key = metric](int group) -> const std::vector<double>& {
            static const std::vector<double> none;
            const auto found = summary.values[group].find(key);
            return found == summary.values[group].end() ? none : found->second;
        };
        const auto a = median_interval(expert), m = median_interval(of_group(1)),
                   b = median_interval(of_group(2));
        if (!a || !m || !b) continue;
        const bool ordered = (a->median - m->median) * (m->median - b->median) > 0;
        const bool apart = a->high < b->low || b->high < a->low;
        table.rows.push_back(
            {metric, short_number(a->median, 4), short_number(a->low, 4) + " to " + short_number(a->high, 4),
             percent(relative_spread(expert)), short_number(m->median, 4),
             short_number(m->low, 4) + " to " + short_number(m->high, 4), short_number(b->median, 4),
             short_number(b->low, 4) + " to " + short_number(b->high, 4),
             percent(relative_spread(of_group(2))), apart ? "yes" : "no", ordered ? "yes" : "no"});
        document.push_back({{"metric", metric},
                            {"expert", {a->median, a->low, a->high}},
                            {"expert_spread", relative_spread(expert)},
                            {"intermediate", {m->median, m->low, m->high}},
                            {"novice", {b->median, b->low, b->high}},
                            {"novice_spread", relative_spread(of_group(2))},
                            {"apart", apart},
                            {"ordered", ordered}});
    }
    return table;
}

lab::ResultPage page_of(const std::string& task, const Summary& summary, int seeds, int replays,
                        bool has_benchmark) {
    lab::ResultPage page(
        "operators_" + task,
        task + ": expert, intermediate, novice, " + std::to_string(seeds) + " seeds from 2000",
        "benchmark_operators " + task + " " + std::to_string(seeds) + " docs/results" +
            (replays < seeds ? " " + std::to_string(replays) : std::string()));
    nlohmann::json rows;
    page.table(metric_table("operators_" + task, summary, rows));
    const auto of = [&](const int* counts) {
        return std::to_string(counts[0]) + ", " + std::to_string(counts[1]) + ", " +
               std::to_string(counts[2]);
    };
    page.paragraph(
        "Intervals are from order statistics. Spread: standard deviation over mean. Apart: the intervals of "
        "experts and novices do not overlap. Ordered: the median of the intermediates lies between the other "
        "two. Of " +
        std::to_string(seeds) + " experts, intermediates and novices, completed: " + of(summary.completed) +
        "; passed " + (has_benchmark ? of(summary.passed) : "none, because there is no benchmark set") +
        ". Replayed bit for bit: " + std::to_string(summary.identical) + " of " +
        std::to_string(groups * replays) + ". " + lab::short_number(summary.simulated / summary.wall) +
        " times real time on one core, including start, operator and record but not scoring and replay.");
    page.paragraph(
        "The presets are defined so that experts are steadier, faster and gentler. This page shows that the "
        "tasks and metrics distinguish the presets; it does not show that they distinguish people.");
    page.document({{"task", task},
                   {"seeds", seeds},
                   {"completed", {summary.completed[0], summary.completed[1], summary.completed[2]}},
                   {"passed", {summary.passed[0], summary.passed[1], summary.passed[2]}},
                   {"identical", summary.identical},
                   {"real_time_factor", summary.simulated / summary.wall},
                   {"metrics", rows}});
    return page;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: benchmark_operators TASK [seeds] [FOLDER] [seeds replayed]\n");
        return 2;
    }
    const TaskDefinition task =
        load_task(test::source_path(std::string("assets/tasks/") + argv[1] + ".json"));
    const int seeds = argc > 2 ? std::atoi(argv[2]) : 20;
    const int replays = argc > 4 ? std::min(seeds, std::atoi(argv[4])) : seeds;
    std::optional<BenchmarkSet> benchmark;
    const std::string set = test::source_path("assets/benchmarks/" + task.id + ".json");
    if (std::filesystem::exists(set)) benchmark = load_benchmark(set);
    const Summary summary = perform_all(task, benchmark, seeds, replays);
    const lab::ResultPage page = page_of(task.id, summary, seeds, replays, benchmark.has_value());
    const lab::Machine machine = lab::this_machine(lab::build_info());
    if (argc > 3) {
        for (const std::string& path : page.write(argv[3], machine))
            std::fprintf(stderr, "wrote %s\n", path.c_str());
    } else {
        std::printf("%s", page.text(machine).c_str());
    }
    return summary.identical == groups * replays ? 0 : 1;
}
