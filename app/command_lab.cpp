// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum lab: bench, cost, run. Every figure is measured when asked for.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <thread>

#include "app/allocation_counter.h"
#include "app/assets.h"
#include "app/attempt_workloads.h"
#include "app/commands.h"
#include "app/performance.h"
#include "assessment/operators/operator.h"
#include "sim_core/lab/bench.h"
#include "sim_core/lab/studies.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

nlohmann::json machine() {
    std::ifstream info("/proc/cpuinfo");
    std::string line, model = "unknown";
    while (std::getline(info, line)) {
        if (line.rfind("model name", 0) == 0) {
            model = line.substr(line.find(':') + 2);
            break;
        }
    }
    return {{"processor", model}, {"cores", std::thread::hardware_concurrency()}, {"built_for", cpu_features()}};
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

int bench(const Arguments& arguments) {
    const auto only = arguments.value("--only");
    nlohmann::json rows = nlohmann::json::array();
    std::vector<double> yardsticks;
    std::vector<lab::Workload> workloads = lab::reference_workloads();
    for (lab::Workload& workload : attempt_workloads()) workloads.push_back(std::move(workload));
    for (const lab::Workload& workload : workloads) {
        if (only && workload.name != *only) continue;
        const lab::WorkloadResult result = lab::run_workload(workload);
        yardsticks.push_back(result.yardstick_us);
        rows.push_back({{"name", result.name}, {"median_us", result.median_us}, {"p99_us", result.p99_us}, {"median_mg", result.median_mg()},
                        {"p99_mg", result.p99_mg()}, {"budget_mg", result.budget_mg > 0 ? nlohmann::json(result.budget_mg) : nlohmann::json()},
                        {"error", result.error ? nlohmann::json(*result.error) : nlohmann::json()},
                        {"error_unit", result.error_unit.empty() ? nlohmann::json() : nlohmann::json(result.error_unit)},
                        {"bytes", result.bytes}, {"allocations_per_step", result.allocations_per_step}});
        if (!arguments.has("--json")) {
            std::cout << result.name << ": median " << result.median_us << " us (" << result.median_mg() << " mG), p99 " << result.p99_us << " us ("
                      << result.p99_mg() << " mG), budget " << result.budget_mg << " mG, " << result.allocations_per_step << " allocations";
            if (result.error) std::cout << ", error " << *result.error << ' ' << result.error_unit;
            std::cout << std::endl;
        }
    }
    if (only && rows.empty()) {
        std::string names;
        for (const lab::Workload& workload : workloads) names += (names.empty() ? "" : ", ") + workload.name;
        throw UsageError("command line: --only: no workload '" + *only + "'; use one of " + names);
    }
    if (arguments.has("--json")) print_json({{"machine", machine()}, {"yardstick_us", median(yardsticks)}, {"workloads", rows}});
    return 0;
}

/// Sink that keeps nothing.
class NoSink : public AttemptSink {
  public:
    void on_event(const Event& /*event*/) noexcept override {}
    void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
    void on_step(const StepRecord& /*step*/) noexcept override {}
};

/// Each part's price in each scene, under an expert operator at work.
int cost(const Arguments& arguments) {
    nlohmann::json scenes = nlohmann::json::array();
    for (const std::string& id : task_ids()) {
        const LoadedTask loaded = load_task_and_scene(id);
        AttemptEngine engine(loaded.scene, loaded.task, 1);
        engine.world().measure(true);
        auto rig = make_operator("expert", loaded.task, loaded.scene, 1);
        NoSink sink;
        std::map<std::string, std::vector<double>> times;
        std::map<std::string, std::size_t> bytes;
        std::vector<double> steps;
        // One simulated second at a time until twelve have been seen: the operator has reached the tissue by then.
        const double seconds = 12;
        run_headless(engine, *rig, sink, [&](double simulated) { return simulated < seconds; }, [&] {
            double sum = 0;
            for (const PartCost& part : engine.world().costs()) {
                times[part.part].push_back(part.us_per_step);
                bytes[part.part] = part.bytes;
                sum += part.us_per_step;
            }
            steps.push_back(sum);
        });
        nlohmann::json parts = nlohmann::json::array();
        for (const auto& [part, values] : times) parts.push_back({{"part", part}, {"median_us_per_step", median(values)}, {"bytes", bytes[part]}});
        scenes.push_back({{"scene", loaded.scene.id}, {"task", id}, {"parts", parts}, {"step_us", median(steps)}});
        if (!arguments.has("--json")) {
            std::cout << loaded.scene.id << ": " << median(steps) << " us per step\n";
            for (const auto& part : parts) {
                std::cout << "  " << part["part"].get<std::string>() << ": " << part["median_us_per_step"] << " us, " << part["bytes"] << " bytes\n";
            }
        }
    }
    if (arguments.has("--json")) print_json({{"machine", machine()}, {"scenes", scenes}});
    return 0;
}

}  // namespace

int command_lab(const std::vector<std::string>& words) {
    OptionSpec spec;
    spec.usage = "usage: fulcrum lab bench [--only NAME] | cost | run STUDY.json [--json]";
    spec.with_value = {"--only"};
    spec.flags = {"--json"};
    spec.minimum_words = 1;
    spec.maximum_words = 2;
    const Arguments arguments(words, spec);
    const std::string& action = arguments.words()[0];
    if (action == "run") {
        if (arguments.words().size() != 2) throw UsageError("command line: lab run: name a study file; " + spec.usage);
        print_json(lab::run_study(arguments.words()[1]));
        return 0;
    }
    if (arguments.words().size() != 1) throw UsageError("command line: " + arguments.words()[1] + ": not expected; " + spec.usage);
    if (action == "bench") return bench(arguments);
    if (action == "cost") return cost(arguments);
    throw UsageError("command line: lab " + action + ": no such action; " + spec.usage);
}

}  // namespace fulcrum::app
