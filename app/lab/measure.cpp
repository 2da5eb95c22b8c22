// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/measure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/lab/attempt_workloads.h"
#include "app/live/performance.h"
#include "assessment/assets/assets.h"
#include "assessment/operators/operator.h"
#include "sim_core/lab/bench.h"
#include "sim_core/lab/chart.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

using lab::short_number;

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

/// Sink that keeps nothing.
class NoSink : public AttemptSink {
  public:
    void on_event(const Event& /*event*/) noexcept override {}
    void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
    void on_step(const StepRecord& /*step*/) noexcept override {}
};

}  // namespace

Measured measure_workloads(const std::optional<std::string>& only) {
    nlohmann::json rows = nlohmann::json::array();
    std::vector<double> yardsticks;
    std::vector<lab::Workload> workloads = lab::reference_workloads();
    for (lab::Workload& workload : attempt_workloads()) workloads.push_back(std::move(workload));
    lab::ResultTable table;
    table.name = "lab_bench";
    table.columns = {"workload",
                     "median, us",
                     "p99, us",
                     "median, mG",
                     "p99, mG",
                     "worst, mG",
                     "budget (median), mG",
                     "budget (worst), mG",
                     "within",
                     "error",
                     "error is",
                     "bytes",
                     "allocations a step"};
    lab::BarChart chart;
    chart.title = "Median time of each reference workload";
    chart.label = "mG (thousandths of a 512 x 512 x 512 double matrix product in the same process)";
    chart.limit_name = "budget";
    for (const lab::Workload& workload : workloads) {
        if (only && workload.name != *only) continue;
        const lab::WorkloadResult result = lab::run_workload(workload);
        yardsticks.push_back(result.yardstick_us);
        rows.push_back(
            {{"name", result.name},
             {"median_us", result.median_us},
             {"p99_us", result.p99_us},
             {"median_mg", result.median_mg()},
             {"p99_mg", result.p99_mg()},
             {"worst_mg", result.worst_mg()},
             {"worst_budget_mg",
              result.worst_budget_mg > 0 ? nlohmann::json(result.worst_budget_mg) : nlohmann::json()},
             {"budget_mg", result.budget_mg > 0 ? nlohmann::json(result.budget_mg) : nlohmann::json()},
             {"error", result.error ? nlohmann::json(*result.error) : nlohmann::json()},
             {"error_unit", result.error_unit.empty() ? nlohmann::json() : nlohmann::json(result.error_unit)},
             {"bytes", result.bytes},
             {"allocations_per_step", result.allocations_per_step}});
        const bool judged = result.budget_mg > 0 || result.worst_budget_mg > 0;
        table.rows.push_back({result.name, short_number(result.median_us, 4), short_number(result.p99_us, 4),
                              short_number(result.median_mg()), short_number(result.p99_mg()),
                              short_number(result.worst_mg()),
                              result.budget_mg > 0 ? short_number(result.budget_mg) : "",
                              result.worst_budget_mg > 0 ? short_number(result.worst_budget_mg) : "",
                              !judged           ? ""
                              : result.within() ? "yes"
                                                : "**no**",
                              result.error ? short_number(*result.error) : "", result.error_unit,
                              std::to_string(result.bytes), short_number(result.allocations_per_step)});
        chart.rows.push_back({result.name, result.median_mg(), result.budget_mg});
    }
    if (only && rows.empty()) {
        std::string names;
        for (const lab::Workload& workload : workloads) names += (names.empty() ? "" : ", ") + workload.name;
        throw InputError("--only", "", "no workload '" + *only + "'", "use one of " + names);
    }
    Measured measured{
        lab::ResultPage("lab_bench", "Reference workloads", "fulcrum lab bench --output docs/results"), {}};
    measured.document = {{"yardstick_us", median(yardsticks)}, {"workloads", rows}};
    lab::ResultPage& page = measured.page;
    page.paragraph(
        "The product's own code on one core. G is the time of one 512 x 512 x 512 double matrix product, "
        "measured between the samples in the same process; 1 mG is a thousandth of it. Here G = " +
        short_number(median(yardsticks) / 1000) +
        " ms. One run; medians of 100 to 4000 samples. A row without a budget is for information.");
    page.table(table);
    page.chart("lab_bench", "median time of each workload and its budget", lab::svg_bars(chart));
    page.document(measured.document);
    return measured;
}

Measured measure_costs() {
    Measured measured{lab::ResultPage("lab_cost", "What each part of each scene costs",
                                      "fulcrum lab cost --output docs/results"),
                      {}};
    lab::ResultPage& page = measured.page;
    page.paragraph(
        "Medians over twelve simulated seconds of a synthetic expert, without a window. A part that a scene "
        "does not list is not built: it has no row, takes no time and no memory.");
    nlohmann::json scenes = nlohmann::json::array();
    for (const std::string& id : task_ids()) {
        const LoadedTask loaded = load_task_and_scene(id);
        AttemptEngine engine(loaded.scene, loaded.task, 1);
        engine.world().measure(true);
        auto rig = make_operator(OperatorLevel::expert, loaded.task, loaded.scene, 1);
        NoSink sink;
        std::map<std::string, std::vector<double>> times;
        std::map<std::string, std::size_t> bytes;
        std::vector<double> steps;
        // Twelve simulated seconds: the operator has reached the tissue by then.
        const double seconds = 12;
        run_headless(
            engine, *rig, sink, [&](double simulated) { return simulated < seconds; },
            [&] {
                double sum = 0;
                for (const PartCost& part : engine.world().costs()) {
                    times[part.part].push_back(part.us_per_step);
                    bytes[part.part] = part.bytes;
                    sum += part.us_per_step;
                }
                steps.push_back(sum);
            });
        nlohmann::json parts = nlohmann::json::array();
        lab::ResultTable table;
        table.name = "lab_cost_" + id;
        table.columns = {"part", "median, us a step", "bytes"};
        std::size_t all_bytes = 0;
        for (const auto& [part, values] : times) {
            parts.push_back({{"part", part}, {"median_us_per_step", median(values)}, {"bytes", bytes[part]}});
            table.rows.push_back({part, short_number(median(values)), std::to_string(bytes[part])});
            all_bytes += bytes[part];
        }
        table.rows.push_back({"total", short_number(median(steps)), std::to_string(all_bytes)});
        scenes.push_back(
            {{"scene", loaded.scene.id}, {"task", id}, {"parts", parts}, {"step_us", median(steps)}});
        page.heading(id + ": scene " + loaded.scene.id);
        page.table(table);
    }
    measured.document = {{"scenes", scenes}};
    page.document(measured.document);
    return measured;
}

}  // namespace fulcrum::app
