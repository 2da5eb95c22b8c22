// SPDX-License-Identifier: GPL-3.0-or-later
// The time that cutting takes: the same operator in real time, with a blade that cuts and with one that
// does not, on every task whose surface is cut.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "app/lab/measure.h"
#include "app/live/live_attempt.h"
#include "app/live/real_time.h"
#include "assessment/operators/operator.h"
#include "sim_core/lab/chart.h"
#include "sim_core/world/part/snapshot.h"

namespace fulcrum::app {
namespace {

constexpr std::uint64_t clock_seed = 2100;  // outside the benchmarks' own
constexpr double most_seconds = 60;

struct Clocked {
    std::string task;
    bool cuts = true;
    LoopStatistics loop;
    double removed_mm2 = 0;
    std::uint32_t topology = 0;
};

Clocked on_the_clock(const std::string& task, bool cuts) {
    LiveRequest request;
    request.loaded = load_task_and_scene(task);
    if (!cuts) {
        Scene& scene = request.loaded.scene;
        for (TissueSpec& tissue : scene.tissues) tissue.cutting.reset();
        if (scene.sheet) scene.sheet->fibres.reset();
        if (scene.septa) scene.septa->fibres.reset();
    }
    request.seed = clock_seed;
    request.rig = make_operator(OperatorLevel::expert, request.loaded.task, request.loaded.scene, clock_seed);
    request.assessed = false;
    LiveAttempt attempt(std::move(request));
    attempt.start();
    Signal pace;
    Clocked result;
    result.task = task;
    result.cuts = cuts;
    const std::int64_t begin = now_ns();
    while (static_cast<double>(now_ns() - begin) * 1e-9 < most_seconds) {
        pace.wait_for_ms(50);
        attempt.update();
        const ui::AttemptPhase phase = attempt.phase();
        if (phase == ui::AttemptPhase::finished || phase == ui::AttemptPhase::failed) break;
    }
    result.loop = attempt.statistics();
    result.removed_mm2 = 1e6 * attempt.snapshot().sheet.removed_area;
    result.topology = attempt.snapshot().sheet.topology;
    return result;
}

}  // namespace

Measured measure_cut_clock() {
    Measured measured{
        lab::ResultPage("cut_realtime", "Cutting on the clock", "fulcrum lab clock --output docs/results"),
        {}};
    lab::ResultPage& page = measured.page;
    page.paragraph(
        "A synthetic expert performs B2 and C4 in real time, with the haptic and world threads of the "
        "application: once normally, once in tissue that cannot be cut. Each run lasts until the task ends, "
        "at most " +
        lab::short_number(most_seconds) +
        " s. A tick that starts a full period late counts as missed. It is charged to the program if the "
        "previous ticks' own processor time (or their wall-clock time, if the thread waited for something) "
        "filled the period, and to the scheduler if the thread was ready but had no processor, because "
        "another thread or the host of the virtual machine had it.");
    std::vector<Clocked> runs;
    for (const char* task : {"B2", "C4"})
        for (const bool cuts : {true, false}) runs.push_back(on_the_clock(task, cuts));
    lab::ResultTable table;
    table.columns = {"what"};
    nlohmann::json rows = nlohmann::json::array();
    bool real_time = true;
    for (const Clocked& run : runs) {
        const LoopStatistics& s = run.loop;
        table.columns.push_back(run.task + (run.cuts ? ", cutting" : ", tissue that cannot be cut"));
        real_time = real_time && s.real_time_priority;
        nlohmann::json one = statistics_json(s);
        one.update({{"task", run.task},
                    {"cuts", run.cuts},
                    {"topology", run.topology},
                    {"removed_mm2", run.removed_mm2}});
        rows.push_back(std::move(one));
    }
    const auto row = [&](const std::string& what, auto value) {
        std::vector<std::string> cells{what};
        for (const Clocked& run : runs)
            cells.push_back(lab::short_number(static_cast<double>(value(run)), 4));
        table.rows.push_back(std::move(cells));
    };
    row("ticks", [](const Clocked& run) { return run.loop.ticks; });
    row("missed by the program", [](const Clocked& run) { return run.loop.missed_by_program; });
    row("missed by the scheduler", [](const Clocked& run) { return run.loop.missed_by_scheduler; });
    row("waits within ticks", [](const Clocked& run) { return run.loop.waits_in_ticks; });
    row("preemptions within ticks", [](const Clocked& run) { return run.loop.preemptions_in_ticks; });
    row("page faults within ticks", [](const Clocked& run) { return run.loop.page_faults_in_ticks; });
    row("late world steps", [](const Clocked& run) { return run.loop.late_steps; });
    const auto durations_rows = [&](const std::string& what, Durations LoopStatistics::*which) {
        for (const auto& [name, value] :
             {std::pair("p50", &Durations::p50_us), std::pair("p99", &Durations::p99_us),
              std::pair("worst", &Durations::worst_us)})
            row(what + ", us: " + name, [&](const Clocked& run) { return run.loop.*which.*value; });
    };
    durations_rows("tick", &LoopStatistics::tick);
    durations_rows("tick, own processor time", &LoopStatistics::own);
    durations_rows("world step", &LoopStatistics::step);
    row("changes of topology", [](const Clocked& run) { return run.topology; });
    row("area cut away, mm2", [](const Clocked& run) { return run.removed_mm2; });
    page.table(table);
    page.paragraph(std::string("Real-time priority ") + (real_time ? "was" : "was not") + " granted.");
    measured.document = {{"runs", rows}};
    page.document(measured.document);
    return measured;
}

}  // namespace fulcrum::app
