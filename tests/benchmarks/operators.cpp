// SPDX-License-Identifier: Apache-2.0
// Experts, intermediates and novices on a task over 20 seeds outside the benchmarks' own: medians with 95 %
// intervals by order statistics, points against the task's set, and whether every attempt replays bit for
// bit. Prints the page, or writes it into a folder.   usage: benchmark_operators
// A2|B1|B2|B3|C4 [seeds] [FOLDER] [seeds replayed]
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>
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

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: benchmark_operators A2|B1|B2|B3|C4 [seeds] [FOLDER]\n");
        return 2;
    }
    const TaskDefinition task =
        load_task(test::source_path(std::string("assets/tasks/") + argv[1] + ".json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    const int seeds = argc > 2 ? std::atoi(argv[2]) : 20;
    const int replays = argc > 4 ? std::min(seeds, std::atoi(argv[4])) : seeds;
    std::optional<BenchmarkSet> benchmark;
    const std::string set = test::source_path("assets/benchmarks/" + task.id + ".json");
    if (std::filesystem::exists(set)) benchmark = load_benchmark(set);
    const char* presets[] = {"expert", "intermediate", "novice"};
    constexpr int groups = 3;
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
    std::map<std::string, std::vector<double>> values[groups];
    int completed[groups] = {0, 0, 0}, passed[groups] = {0, 0, 0}, identical = 0;
    double simulated = 0, wall = 0;
    for (int k = 0; k < groups * seeds; ++k) {
        const Outcome& outcome = outcomes[static_cast<std::size_t>(k)];
        completed[k / seeds] += outcome.completed ? 1 : 0;
        passed[k / seeds] += outcome.passed ? 1 : 0;
        identical += outcome.identical ? 1 : 0;
        simulated += outcome.simulated_s;
        wall += outcome.wall_s;
        for (const auto& [name, value] : outcome.values) values[k / seeds][name].push_back(value);
    }
    using lab::short_number;
    lab::ResultPage page(
        "operators_" + task.id,
        task.id + ": expert, intermediate, novice, " + std::to_string(seeds) + " seeds from 2000",
        "benchmark_operators " + task.id + " " + std::to_string(seeds) + " docs/results" +
            (replays < seeds ? " " + std::to_string(replays) : std::string()));
    lab::ResultTable table;
    table.name = "operators_" + task.id;
    table.columns = {"metric",        "expert: median", "95 % interval", "spread", "intermediate: median",
                     "95 % interval", "novice: median", "95 % interval", "spread", "apart",
                     "ordered"};
    const auto percent = [](double value) { return short_number(100 * value, 2) + " %"; };
    nlohmann::json rows = nlohmann::json::array();
    for (const auto& [name, expert] : values[0]) {
        const auto a = median_interval(expert), m = median_interval(values[1][name]),
                   b = median_interval(values[2][name]);
        if (!a || !m || !b) continue;
        const bool ordered = (a->median - m->median) * (m->median - b->median) > 0;
        const bool apart = a->high < b->low || b->high < a->low;
        table.rows.push_back(
            {name, short_number(a->median, 4), short_number(a->low, 4) + " to " + short_number(a->high, 4),
             percent(relative_spread(expert)), short_number(m->median, 4),
             short_number(m->low, 4) + " to " + short_number(m->high, 4), short_number(b->median, 4),
             short_number(b->low, 4) + " to " + short_number(b->high, 4),
             percent(relative_spread(values[2][name])), apart ? "yes" : "no", ordered ? "yes" : "no"});
        rows.push_back({{"metric", name},
                        {"expert", {a->median, a->low, a->high}},
                        {"expert_spread", relative_spread(expert)},
                        {"intermediate", {m->median, m->low, m->high}},
                        {"novice", {b->median, b->low, b->high}},
                        {"novice_spread", relative_spread(values[2][name])},
                        {"apart", apart},
                        {"ordered", ordered}});
    }
    page.table(table);
    const auto of = [&](const int* counts) {
        return std::to_string(counts[0]) + ", " + std::to_string(counts[1]) + ", " +
               std::to_string(counts[2]);
    };
    page.paragraph(
        "Intervals are from order statistics. Spread: standard deviation over mean. Apart: the intervals of "
        "experts and novices do not overlap. Ordered: the median of the intermediates lies between the other "
        "two. Of " +
        std::to_string(seeds) + " experts, intermediates and novices, completed: " + of(completed) +
        "; passed " + (benchmark ? of(passed) : std::string("none, because there is no benchmark set")) +
        ". Replayed bit for bit: " + std::to_string(identical) + " of " + std::to_string(groups * replays) +
        ". " + short_number(simulated / wall) +
        " times real time on one core, including start, operator and record but not scoring and replay.");
    page.paragraph(
        "The presets are defined so that experts are steadier, faster and gentler. This page shows that the "
        "tasks and metrics distinguish the presets; it does not show that they distinguish people.");
    page.document({{"task", task.id},
                   {"seeds", seeds},
                   {"completed", {completed[0], completed[1], completed[2]}},
                   {"passed", {passed[0], passed[1], passed[2]}},
                   {"identical", identical},
                   {"real_time_factor", simulated / wall},
                   {"metrics", rows}});
    const lab::Machine machine = lab::this_machine(lab::build_info());
    if (argc > 3) {
        for (const std::string& path : page.write(argv[3], machine))
            std::fprintf(stderr, "wrote %s\n", path.c_str());
    } else {
        std::printf("%s", page.text(machine).c_str());
    }
    return identical == groups * replays ? 0 : 1;
}
