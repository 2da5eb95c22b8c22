// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/size_sweep.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "sim_core/lab/chart.h"
#include "sim_core/lab/processor_time.h"

namespace fulcrum::lab {
namespace {

constexpr int rounds = 9;
constexpr double round_us = 60e3;  ///< a size's share of a round
constexpr int least_samples = 7, most_samples = 400;

template <class Value>
double exponent(const std::vector<SweepPoint>& points, Value&& value) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const auto n = static_cast<double>(points.size());
    for (const SweepPoint& point : points) {
        const double x = std::log(point.elements), y = std::log(value(point));
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::string plural(const std::string& element) {
    return element == "vertex" ? "vertices" : element + "s";
}

double once_us(const SweepRun& run) {
    if (run.between) run.between();
    const double begin = processor_time_us();
    run.step();
    return processor_time_us() - begin;
}

SizeSweep named(const SweepCase& sweep) {
    SizeSweep result;
    result.model = sweep.model;
    result.element = sweep.element;
    result.operation = sweep.operation;
    result.exponent_limit = sweep.exponent_limit;
    result.ratio_limit = sweep.ratio_limit;
    return result;
}

SweepPoint count(const SweepCase& sweep, const SweepRun& run) {
    SweepPoint point;
    point.elements = run.elements;
    for (int i = 0; i < sweep.warm_up; ++i) once_us(run);
    const double before = run.operations();
    for (int i = 0; i < sweep.counted; ++i) once_us(run);
    point.operations = (run.operations() - before) / sweep.counted;
    return point;
}

}  // namespace

double SizeSweep::operation_exponent() const {
    return exponent(points, [](const SweepPoint& p) { return p.operations; });
}
double SizeSweep::time_exponent() const {
    return exponent(points, [](const SweepPoint& p) { return p.time_us; });
}
double SizeSweep::time_ratio() const {
    const SweepPoint &small = points.front(), &large = points.back();
    return large.time_us / large.elements / (small.time_us / small.elements);
}
double SizeSweep::operation_ratio() const {
    const SweepPoint &small = points.front(), &large = points.back();
    return large.operations / large.elements / (small.operations / small.elements);
}

SizeSweep count_sweep(const SweepCase& sweep, int largest) {
    SizeSweep result = named(sweep);
    for (const int size : sweep.sizes) {
        if (size <= largest) result.points.push_back(count(sweep, sweep.prepare(size)));
    }
    return result;
}

SizeSweep time_sweep(const SweepCase& sweep) {
    SizeSweep result = named(sweep);
    std::vector<SweepRun> runs;
    for (const int size : sweep.sizes) {
        runs.push_back(sweep.prepare(size));
        result.points.push_back(count(sweep, runs.back()));
    }
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < runs.size(); ++i) {
            // Fills the caches with this size's data again.
            const double first = std::min(once_us(runs[i]), once_us(runs[i]));
            const int samples =
                std::clamp(static_cast<int>(round_us / std::max(first, 0.1)), least_samples, most_samples);
            std::vector<double> times(static_cast<std::size_t>(samples));
            for (double& time : times) time = once_us(runs[i]);
            const auto middle = times.begin() + samples / 2;
            std::nth_element(times.begin(), middle, times.end());
            double& best = result.points[i].time_us;
            best = round == 0 ? *middle : std::min(best, *middle);
        }
    }
    return result;
}

std::vector<SweepCase> size_sweeps() {
    std::vector<SweepCase> sweeps;
    for (const auto add :
         {add_rod_sweeps, add_collision_sweeps, add_skinning_sweeps, add_contact_sweeps, add_membrane_sweeps})
        add(sweeps);
    return sweeps;
}

nlohmann::json to_json(const std::vector<SizeSweep>& sweeps) {
    nlohmann::json list = nlohmann::json::array();
    for (const SizeSweep& sweep : sweeps) {
        nlohmann::json sizes = nlohmann::json::array();
        for (const SweepPoint& point : sweep.points) {
            sizes.push_back({{"elements", point.elements},
                             {"time_us", point.time_us},
                             {"time_per_element_ns", 1e3 * point.time_us / point.elements},
                             {"operations", point.operations},
                             {"operations_per_element", point.operations / point.elements}});
        }
        list.push_back({{"model", sweep.model},
                        {"element", sweep.element},
                        {"operation", sweep.operation},
                        {"sizes", sizes},
                        {"operation_exponent", sweep.operation_exponent()},
                        {"exponent_limit", sweep.exponent_limit},
                        {"time_exponent", sweep.time_exponent()},
                        {"time_per_element_ratio", sweep.time_ratio()},
                        {"ratio_limit", sweep.ratio_limit},
                        {"within", sweep.within()}});
    }
    return {{"sweeps", list}};
}

ResultPage size_sweep_page(const std::vector<SizeSweep>& sweeps) {
    ResultPage page("size_sweep", "How work grows with size",
                    "fulcrum lab bench --sweep --output docs/results");
    page.paragraph(
        "One step of each model on one core, at growing sizes. The model counts its own operations (mean "
        "over the counted steps); the counts are the same on every machine. Times are processor times of the "
        "thread: the least of " +
        std::to_string(rounds) +
        " medians, taken over all sizes in turn. Exponents are least-squares slopes over all sizes on "
        "logarithmic axes. Limits (docs/QUALITY.md): the exponent of the operations is at most 1.05, and the "
        "time per element grows by at most 2 between the smallest and the largest size (membranes: 4).");
    ResultTable summary;
    summary.columns = {"model",
                       "from",
                       "to",
                       "operations: exponent",
                       "limit",
                       "time: exponent",
                       "time per element, largest over smallest",
                       "limit",
                       "within"};
    Chart chart;
    chart.title = "Time per element, relative to the smallest size";
    chart.x_label = "size over the smallest size";
    chart.y_label = "time per element, relative to the smallest size";
    chart.x_logarithmic = chart.y_logarithmic = true;
    for (const SizeSweep& sweep : sweeps) {
        const SweepPoint &small = sweep.points.front(), &large = sweep.points.back();
        summary.rows.push_back({sweep.model, short_number(small.elements, 6), short_number(large.elements, 6),
                                short_number(sweep.operation_exponent()), short_number(sweep.exponent_limit),
                                short_number(sweep.time_exponent()), short_number(sweep.time_ratio()),
                                short_number(sweep.ratio_limit), sweep.within() ? "yes" : "**no**"});
        ChartSeries series;
        series.name = sweep.model;
        for (const SweepPoint& point : sweep.points) {
            series.x.push_back(point.elements / small.elements);
            series.y.push_back(point.time_us / point.elements / (small.time_us / small.elements));
        }
        chart.series.push_back(series);
    }
    page.table(summary);
    page.chart("size_sweep", "time per element against size", svg_chart(chart));
    for (std::size_t i = 0; i < sweeps.size(); ++i) {
        const SizeSweep& sweep = sweeps[i];
        page.heading(sweep.model);
        page.paragraph("Operations: " + sweep.operation + ".");
        ResultTable table;
        table.name = "size_sweep_" + std::to_string(i + 1);
        table.columns = {plural(sweep.element), "time, us", "time, ns a " + sweep.element, "operations",
                         "operations a " + sweep.element};
        for (const SweepPoint& point : sweep.points) {
            table.rows.push_back({short_number(point.elements, 6), short_number(point.time_us, 4),
                                  short_number(1e3 * point.time_us / point.elements, 4),
                                  short_number(point.operations, 5),
                                  short_number(point.operations / point.elements, 4)});
        }
        page.table(table);
    }
    page.document(to_json(sweeps));
    return page;
}

}  // namespace fulcrum::lab
