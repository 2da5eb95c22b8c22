// SPDX-License-Identifier: GPL-3.0-or-later
// Waiting times of a reviewer (docs/QUALITY.md): a cohort report of 200 trainees as PDF (5 s), the first
// chart of an hour's trace (1 s), a pan or zoom of it (16 ms); the same of the whole debrief, whose four
// charts of five quantities share one time axis; the memory of that page, of comparing two attempts and of
// the metrics of a part of one. Runs without a display. Prints the figures, or writes their page into a
// folder as well.   usage: benchmark_review [FOLDER]
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "assessment/attempt/engine.h"
#include "database/records/recorder.h"
#include "database/scoring/range_metrics.h"
#include "sim_core/lab/result_page.h"
#include "tests/benchmarks/shown_debrief.h"
#include "tests/database/large_programme.h"
#include "tests/support/support.h"
#include "ui/charts/time_chart.h"
#include "ui/reports/report.h"
#include "ui/review/attempt_model.h"
#include "ui/review/comparison.h"

namespace fulcrum::ui {
namespace {

void cohort_report(benchmark::State& state) {
    const QTemporaryDir folder;
    const database::Store store = database::Store::create(folder.filePath("report.db").toStdString());
    const auto large = database::test::make_large_programme(store, 200, 12, 40, 1);
    std::vector<TaskDefinition> tasks;
    for (const char* id : {"A2", "B1"})
        tasks.push_back(load_task(test::source_path(std::string("assets/tasks/") + id + ".json")));
    ReportRequest request;
    request.cohort_id = large.cohort;
    request.path = folder.filePath("report.pdf").toStdString();
    for (auto _ : state) {
        const auto files = write_report(store, large.director, request, tasks, "0.1.0");
        if (files.size() != 1) state.SkipWithError("no report");
    }
}
BENCHMARK(cohort_report)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(3);

/// A store with one attempt of an hour, created once per process.
struct Hour {
    QTemporaryDir folder;
    std::string path = folder.filePath("hour.db").toStdString(), attempt;
    Hour() {
        const database::Store store = database::Store::create(path);
        const database::Session station = store.station_session();
        database::AttemptMeta meta;
        meta.person_id = database::People(store).ensure_synthetic(station, "hour", "Hour").id;
        meta.task_id = "B1";
        meta.device_class = DeviceClass::synthetic;
        database::Recorder recorder(path, station, meta);
        const Minute pattern = minute();
        for (std::uint32_t tick = 0; tick < 3'600'000; ++tick) {
            TickSample sample = pattern.samples[tick % 60000];
            RigSample input = pattern.inputs[tick % 60000];
            sample.tick = input.tick = tick;
            recorder.append(input);
            recorder.append(sample);
        }
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = 3600;
        recorder.finish(result);
        attempt = recorder.attempt_id();
    }
};
const Hour& hour() {
    static const Hour made;
    return made;
}

std::optional<AttemptModel> load(const Hour& record) {
    database::StoreOptions options;
    options.read_only = true;
    const database::Store store = database::Store::open(record.path, options);
    return load_attempt(store, store.station_session(), record.attempt, std::nullopt, {});
}

void fill(TimeChart& chart, const AttemptModel& model) {
    chart.clear();
    for (std::size_t h = 0; h < hand_count; ++h)
        chart.add_series(h == 0 ? "left" : "right", &Palette::left_hand, Qt::SolidLine, model.force[h]);
    chart.show_all();
}

void first_chart_of_an_hour(benchmark::State& state) {
    const Hour& record = hour();
    TimeChart chart("force (N)");
    chart.resize(800, 300);
    for (auto _ : state) {
        const std::optional<AttemptModel> model = load(record);
        fill(chart, *model);
        benchmark::DoNotOptimize(chart.grab());
        state.counters["samples"] = static_cast<double>(model->samples);
    }
}
BENCHMARK(first_chart_of_an_hour)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(5);

void pan_and_zoom_of_an_hour(benchmark::State& state) {
    const std::optional<AttemptModel> model = load(hour());
    TimeChart chart("force (N)");
    chart.resize(800, 300);
    fill(chart, *model);
    int i = 0;
    for (auto _ : state) {
        const double span = 3600 * std::pow(0.8, i % 30), from = (3600 - span) * 0.01 * (i % 97);
        chart.show_range(from, from + span);
        benchmark::DoNotOptimize(chart.grab());
        ++i;
    }
}
BENCHMARK(pan_and_zoom_of_an_hour)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(200);

/// MB that the process holds at most from now on (`peak` false: that it holds now).
double memory_mb(bool peak) {
    std::ifstream status("/proc/self/status");
    const std::string wanted = peak ? "VmHWM:" : "VmRSS:";
    for (std::string line; std::getline(status, line);)
        if (line.rfind(wanted, 0) == 0) return std::strtod(line.c_str() + wanted.size(), nullptr) / 1e3;
    return 0;
}

void debrief_of_an_hour(benchmark::State& state) {
    ShownDebrief debrief;
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak begins here
    const double before = memory_mb(false);
    for (auto _ : state) {
        if (!debrief.open()) {
            state.SkipWithError("not four charts");
            break;
        }
        state.PauseTiming();
        if (!debrief.complete()) {
            state.SkipWithError("no record");
            break;
        }
        state.counters["peak_MB"] = memory_mb(true) - before;
        state.counters["held_MB"] = memory_mb(false) - before;
        debrief.close();
        state.ResumeTiming();
    }
}
BENCHMARK(debrief_of_an_hour)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(5);

double share(std::vector<double> values, double quantile) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1,
                           static_cast<std::size_t>(quantile * static_cast<double>(values.size())))];
}

/// Steps at all four charts of the debrief, from the event until all of them are drawn again.
void steps_of_the_debrief(benchmark::State& state, void (*make)(TimeChart&, int)) {
    ShownDebrief debrief;
    if (!debrief.open() || !debrief.complete()) {
        state.SkipWithError("not four charts");
        return;
    }
    TimeChart& first = *debrief.chart("force_chart");
    for (int i = 0; make == drag && i < 6; ++i) turn_wheel(first, i);  // the whole cannot be moved
    debrief.draw();
    std::vector<double> taken;
    int step = 0;
    for (auto _ : state) {
        QElapsedTimer timer;
        timer.start();
        make(first, step++);
        debrief.draw();
        taken.push_back(1e-6 * static_cast<double>(timer.nsecsElapsed()));
    }
    state.counters["p50_ms"] = share(taken, 0.5);
    state.counters["p99_ms"] = share(taken, 0.99);
    state.counters["worst_ms"] = share(taken, 1);
}
BENCHMARK_CAPTURE(steps_of_the_debrief, pan, drag)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(480);
BENCHMARK_CAPTURE(steps_of_the_debrief, zoom, turn_wheel)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(480);

/// What the page of a comparison holds: both attempts with their records, charts and alignment.
void comparing_two_attempts_of_an_hour(benchmark::State& state) {
    const Hour& record = hour();
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak begins here
    const double before = memory_mb(false);
    TimeChart chart("force (N)");
    chart.resize(800, 300);
    for (auto _ : state) {
        const database::Store store = database::Store::open(record.path, {});
        const auto side = [&] {
            return load_side(store, store.station_session(), record.attempt, std::nullopt, {});
        };
        const std::optional<ComparedSide> own = side(), other = side();
        const ComparedPair pair = align(*own, *other);
        fill(chart, own->model);
        for (std::size_t h = 0; h < hand_count; ++h)
            chart.add_series("other", &Palette::right_hand, Qt::DashLine, pair.force[h]);
        benchmark::DoNotOptimize(chart.grab());
        if (!own->has_trace() || own->model.trace->tick_count() != 3'600'000) state.SkipWithError("no trace");
        state.counters["peak_MB"] = memory_mb(true) - before;
        state.counters["held_MB"] = memory_mb(false) - before;
    }
}
BENCHMARK(comparing_two_attempts_of_an_hour)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(1);

/// The metrics of the whole hour but its last minute, with the record packed as the pages hold it: one
/// attempt of B2, whose task shows most metrics.
void metrics_of_an_hours_part(benchmark::State& state, RangePasses passes) {
    const Hour& record = hour();
    const TaskDefinition task = load_task(test::source_path("assets/tasks/B2.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/b2_plane.json"));
    const database::Store store = database::Store::open(record.path, {});
    const database::Trace trace =
        database::Attempts(store).read_packed_trace(store.station_session(), record.attempt);
    for (auto _ : state) {
        malloc_trim(0);
        std::ofstream("/proc/self/clear_refs") << "5";  // the peak begins here
        const double before = memory_mb(false);
        const auto rows = metrics_of_range(scene, task, 1, trace, 0, 3540, {passes});
        state.counters["peak_MB"] = memory_mb(true) - before;
        if (rows.empty()) state.SkipWithError("no metrics");
    }
}
BENCHMARK_CAPTURE(metrics_of_an_hours_part, hand_by_hand, RangePasses::hand_by_hand)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(1);
BENCHMARK_CAPTURE(metrics_of_an_hours_part, at_once, RangePasses::at_once)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(1);

/// Prints as usual and keeps the values for the page.
class Keeper : public benchmark::ConsoleReporter {
  public:
    Keeper() : ConsoleReporter(OO_None) {
        table.name = "review";
        table.columns = {"what",      "wall, ms",      "median, ms", "p99, ms",
                         "worst, ms", "processor, ms", "budget, ms", "memory at most, MB"};
    }
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            const auto counted = [&run](const char* name, const char* format) {
                const auto found = run.counters.find(name);
                return found == run.counters.end() ? std::string() : figure(found->second, format);
            };
            for (const auto& [name, title, budget] : lines) {
                if (run.benchmark_name().rfind(name, 0) != 0 || run.error_occurred) continue;
                table.rows.push_back({title, figure(run.GetAdjustedRealTime()), counted("p50_ms", "%.1f"),
                                      counted("p99_ms", "%.1f"), counted("worst_ms", "%.1f"),
                                      figure(run.GetAdjustedCPUTime()), budget, counted("peak_MB", "%.0f")});
            }
        }
    }
    lab::ResultTable table;

  private:
    struct Line {
        const char *name, *title, *budget;
    };
    static constexpr Line lines[] = {
        {"cohort_report", "cohort report of 200 trainees as PDF", "5000"},
        {"first_chart_of_an_hour", "an hour's trace, from the store to its first chart", "1000"},
        {"pan_and_zoom_of_an_hour", "a pan or zoom of that chart", "16"},
        {"debrief_of_an_hour", "an hour's debrief, from the choice until its four charts are drawn", "1000"},
        {"steps_of_the_debrief/pan", "a pan of its four charts", "16"},
        {"steps_of_the_debrief/zoom", "a zoom of its four charts", "16"},
        {"comparing_two_attempts_of_an_hour",
         "two attempts of an hour, from the store to the comparison's first chart", ""},
        {"metrics_of_an_hours_part/hand_by_hand", "metrics of 59 of these minutes (B2), hand by hand", ""},
        {"metrics_of_an_hours_part/at_once", "the same with all in memory at once, for comparison", ""},
    };
    static std::string figure(double value, const char* format = "%.1f") {
        char text[32];
        std::snprintf(text, sizeof text, format, value);
        return text;
    }
};

void write_page(const std::string& folder, const lab::ResultTable& table, double load) {
    lab::ResultPage page("review", "Waiting times of a reviewer", "benchmark_review " + folder);
    char beside[256];
    std::snprintf(beside, sizeof beside,
                  "Means. Processor time is the sum over all threads. Load average of the machine over the "
                  "minute before the run: %.1f.",
                  load);
    page.paragraph(beside);
    page.table(table);
    page.paragraph(
        "The debrief is the program's page at 1280 x 800 with a record of two hands that has force, speed, "
        "traction, energy and heat; the picture of its replay is not included. A pan is one movement of the "
        "mouse, a zoom one notch of the wheel, each until all four charts are drawn again.");
    page.paragraph(
        "Memory: the most that the process held above what it held before. Of the debrief with the packed "
        "record that its replay needs. Of the comparison with both "
        "records as their replays need them and all charts (budget: 1000 MB); key frames and pictures of the "
        "replays are not included. Of the metrics above the packed record, which the page holds anyway. Up "
        "to "
        "a quarter of an hour is computed at once.");
    page.write(folder, lab::this_machine(lab::build_info()));
}

}  // namespace
}  // namespace fulcrum::ui

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    double load = 0;
    if (getloadavg(&load, 1) != 1) load = 0;
    fulcrum::ui::Keeper keeper;
    benchmark::RunSpecifiedBenchmarks(&keeper);
    fulcrum::ui::kept_hour_on_page().reset();
    if (argc > 1) fulcrum::ui::write_page(argv[1], keeper.table, load);
}
