// SPDX-License-Identifier: GPL-3.0-or-later
// What cutting costs on the clock: the same operator on task B2 in real time, with a blade that cuts and with
// one that does not.
#include <algorithm>
#include <memory>

#include "app/lab_measure.h"
#include "app/live_attempt.h"
#include "app/real_time.h"
#include "assessment/operators/operator.h"
#include "sim_core/lab/chart.h"
#include "sim_core/world/snapshot.h"

namespace fulcrum::app {
namespace {

constexpr std::uint64_t seed = 2100;  // outside the benchmarks' own
constexpr double most_seconds = 60;

struct Clocked {
    LoopStatistics loop;
    double removed_mm2 = 0;
    std::uint32_t topology = 0;
    std::string ended;
};

Clocked on_the_clock(bool cuts) {
    LiveRequest request;
    request.loaded = load_task_and_scene("B2");
    if (!cuts)
        for (TissueSpec& tissue : request.loaded.scene.tissues) tissue.cutting.reset();
    request.seed = seed;
    request.rig = make_operator("expert", request.loaded.task, request.loaded.scene, seed);
    request.assessed = false;
    LiveAttempt attempt(std::move(request));
    attempt.start();
    Signal pace;
    Clocked result;
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
        "Task B2 by a synthetic expert in real time, haptic and world threads as in the application, once "
        "with a blade that "
        "cuts, once with the same operator while the tissue cannot be cut; until the task ended, at most " +
        lab::short_number(most_seconds) +
        " s. A tick is missed by the program when the one before it took longer than its period, by the "
        "scheduler "
        "when its thread was woken late.");
    const Clocked with = on_the_clock(true), without = on_the_clock(false);
    const auto number = [](double value) { return lab::short_number(value, 4); };
    lab::ResultTable table;
    table.columns = {"what", "the blade cuts", "it does not"};
    nlohmann::json runs = nlohmann::json::array();
    for (const Clocked* run : {&with, &without}) {
        const LoopStatistics& s = run->loop;
        runs.push_back(
            {{"cuts", run == &with},
             {"ticks", s.ticks},
             {"missed_by_program", s.missed_by_program},
             {"missed_by_scheduler", s.missed_by_scheduler},
             {"late_steps", s.late_steps},
             {"tick_us", {{"p50", s.tick_p50_us}, {"p99", s.tick_p99_us}, {"worst", s.tick_worst_us}}},
             {"step_us", {{"p50", s.step_p50_us}, {"p99", s.step_p99_us}, {"worst", s.step_worst_us}}},
             {"topology", run->topology},
             {"removed_mm2", run->removed_mm2},
             {"real_time_priority", s.real_time_priority}});
    }
    const auto row = [&](const char* what, double a, double b) {
        table.rows.push_back({what, number(a), number(b)});
    };
    const LoopStatistics &a = with.loop, &b = without.loop;
    row("ticks", static_cast<double>(a.ticks), static_cast<double>(b.ticks));
    row("missed by the program", static_cast<double>(a.missed_by_program),
        static_cast<double>(b.missed_by_program));
    row("missed by the scheduler", static_cast<double>(a.missed_by_scheduler),
        static_cast<double>(b.missed_by_scheduler));
    row("late world steps", static_cast<double>(a.late_steps), static_cast<double>(b.late_steps));
    row("tick, us: p50", a.tick_p50_us, b.tick_p50_us);
    row("tick, us: p99", a.tick_p99_us, b.tick_p99_us);
    row("tick, us: worst", a.tick_worst_us, b.tick_worst_us);
    row("world step, us: p50", a.step_p50_us, b.step_p50_us);
    row("world step, us: p99", a.step_p99_us, b.step_p99_us);
    row("world step, us: worst", a.step_worst_us, b.step_worst_us);
    row("changes of topology", with.topology, without.topology);
    row("ground taken, mm2", with.removed_mm2, without.removed_mm2);
    page.table(table);
    page.paragraph(std::string("Real-time priority ") +
                   (a.real_time_priority && b.real_time_priority ? "was" : "was not") + " granted.");
    measured.document = {{"runs", runs}};
    page.document(measured.document);
    return measured;
}

}  // namespace fulcrum::app
