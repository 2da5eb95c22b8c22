// SPDX-License-Identifier: Apache-2.0
// Experts against novices on a task over 20 seeds outside the benchmarks' own: medians with 95 % intervals by
// order statistics, and whether every attempt replays bit for bit. Prints the page, or writes it into a
// folder.   usage: benchmark_operators A2|B1 [seeds] [FOLDER]
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <thread>

#include "assessment/attempt/engine.h"
#include "assessment/learning/statistics.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/operators/operator.h"
#include "sim_core/lab/chart.h"
#include "sim_core/lab/result_page.h"
#include "tests/support/support.h"

namespace {

using namespace fulcrum;

class Memory : public AttemptSink {
  public:
    void on_event(const Event& event) noexcept override { record.events.push_back(event); }
    void on_tick(const RigSample& input, const TickSample& sample) noexcept override {
        record.inputs.push_back(input);
        record.samples.push_back(sample);
    }
    void on_step(const StepRecord& step) noexcept override { record.steps.push_back(step); }
    AttemptRecord record;
};

struct Outcome {
    bool completed = false, identical = false;
    double simulated_s = 0, wall_s = 0;
    std::map<std::string, double> values;
};

Outcome attempt(const TaskDefinition& task, const Scene& scene, const std::string& preset,
                std::uint64_t seed) {
    const auto begin = std::chrono::steady_clock::now();
    AttemptEngine engine(scene, task, seed);
    const auto rig = make_operator(preset, task, scene, seed);
    Memory sink;
    const RunOutcome run = run_headless(engine, *rig, sink);
    Outcome outcome;
    outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    outcome.simulated_s = run.ticks * scene.tick_period();
    outcome.completed = run.end == EventKind::completed;
    std::vector<std::string> tissues;
    for (const TissueSpec& tissue : scene.tissues) tissues.push_back(tissue.label);
    const Trace trace = trace_from_samples(sink.record.samples, sink.record.events, tissues, scene.tick_rate);
    MetricContext context = make_metric_context(scene, task, {});
    context.metrics = {"time", "path_len", "f_max", "sparc"};
    for (const MetricResult& row : compute_metrics(trace, sink.record.events, context)) {
        if (row.tissue.empty() && row.value)
            outcome.values[row.id + (row.hand.empty() ? "" : " " + row.hand)] = *row.value;
    }
    AttemptEngine again(scene, task, seed);
    const ReplayOutcome replay = replay_record(again, sink.record);
    outcome.identical = replay.identical && replay.state_hash == run.state_hash;
    return outcome;
}

/// Standard deviation over the magnitude of the mean: how different the individuals are.
double relative_spread(const std::vector<double>& values) {
    return sample_deviation(values) / std::abs(mean_of(values));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: benchmark_operators A2|B1 [seeds] [FOLDER]\n");
        return 2;
    }
    const TaskDefinition task =
        load_task(test::source_path(std::string("assets/tasks/") + argv[1] + ".json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    const int seeds = argc > 2 ? std::atoi(argv[2]) : 20;
    const char* presets[] = {"expert", "novice"};
    std::vector<Outcome> outcomes(static_cast<std::size_t>(2 * seeds));
    std::atomic<int> next{0};
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
        threads.emplace_back([&] {
            for (int k = next++; k < 2 * seeds; k = next++) {
                outcomes[static_cast<std::size_t>(k)] =
                    attempt(task, scene, presets[k / seeds], 2000 + static_cast<std::uint64_t>(k % seeds));
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    std::map<std::string, std::vector<double>> values[2];
    int completed[2] = {0, 0}, identical = 0;
    double simulated = 0, wall = 0;
    for (int k = 0; k < 2 * seeds; ++k) {
        const Outcome& outcome = outcomes[static_cast<std::size_t>(k)];
        completed[k / seeds] += outcome.completed ? 1 : 0;
        identical += outcome.identical ? 1 : 0;
        simulated += outcome.simulated_s;
        wall += outcome.wall_s;
        for (const auto& [name, value] : outcome.values) values[k / seeds][name].push_back(value);
    }
    using lab::short_number;
    lab::ResultPage page("operators_" + task.id,
                         task.id + ": expert against novice, " + std::to_string(seeds) + " seeds from 2000",
                         "benchmark_operators " + task.id + " " + std::to_string(seeds) + " docs/results");
    lab::ResultTable table;
    table.name = "operators_" + task.id;
    table.columns = {"metric",         "expert: median", "95 % interval", "spread",
                     "novice: median", "95 % interval",  "spread",        "apart"};
    const auto percent = [](double value) { return short_number(100 * value, 2) + " %"; };
    nlohmann::json rows = nlohmann::json::array();
    for (const auto& [name, expert] : values[0]) {
        const auto a = median_interval(expert), b = median_interval(values[1][name]);
        if (!a || !b) continue;
        const bool apart = a->high < b->low || b->high < a->low;
        table.rows.push_back({name, short_number(a->median, 4),
                              short_number(a->low, 4) + " to " + short_number(a->high, 4),
                              percent(relative_spread(expert)), short_number(b->median, 4),
                              short_number(b->low, 4) + " to " + short_number(b->high, 4),
                              percent(relative_spread(values[1][name])), apart ? "yes" : "no"});
        rows.push_back({{"metric", name},
                        {"expert", {a->median, a->low, a->high}},
                        {"expert_spread", relative_spread(expert)},
                        {"novice", {b->median, b->low, b->high}},
                        {"novice_spread", relative_spread(values[1][name])},
                        {"apart", apart}});
    }
    page.table(table);
    page.paragraph("Intervals by order statistics; spread: standard deviation over mean. Completed: " +
                   std::to_string(completed[0]) + " of " + std::to_string(seeds) + " experts, " +
                   std::to_string(completed[1]) + " of " + std::to_string(seeds) +
                   " novices. Replayed bit for bit: " + std::to_string(identical) + " of " +
                   std::to_string(2 * seeds) + ". " + short_number(simulated / wall) +
                   " times real time a core, start, operators and record included, scoring and the replay "
                   "that follows left out.");
    page.paragraph(
        "The presets were written so that experts are steadier, faster and gentler: this shows that tasks "
        "and metrics tell them apart, not "
        "that they tell people apart.");
    page.document({{"task", task.id},
                   {"seeds", seeds},
                   {"completed", {completed[0], completed[1]}},
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
    return identical == 2 * seeds ? 0 : 1;
}
