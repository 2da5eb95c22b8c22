// SPDX-License-Identifier: Apache-2.0
// Task goals of a dissection, from constructed steps: tension, division, release, warnings.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "assessment/metrics/metrics_json.h"
#include "assessment/task/cut_monitor.h"
#include "assessment/task/monitor.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/allocation_count.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

const char* const task_text = R"({
  "id": "cut", "version": 1, "title": "Cut", "stage": "B", "briefing": "b", "product": "p", "steps": ["s"],
  "scene": "b2_areolar.json", "time_limit_s": 20, "warning_margin": 0.1,
  "goals": [
    {"id": "pull", "kind": "take_tension", "text": "Pull", "hold_s": 0.5, "traction_low_n_m": 4, "traction_high_n_m": 8},
    {"id": "divide", "kind": "divide_line", "text": "Divide", "length_m": 0.1, "tolerance_m": 0.002, "corridor_m": 0.01,
     "traction_low_n_m": 4, "traction_high_n_m": 8},
    {"id": "free", "kind": "let_go", "text": "Let go", "hold_s": 0.2}],
  "metrics": ["time", "traction_eff"], "gates": [{"metric": "time", "kind": "benchmark"}], "device_classes": ["haptic"]
})";

class Events : public EventSink {
  public:
    Events() { list.reserve(8192); }
    void on_event(const Event& event) noexcept override { list.push_back(event); }
    int count(EventKind kind) const {
        return static_cast<int>(
            std::count_if(list.begin(), list.end(), [&](const Event& e) { return e.kind == kind; }));
    }
    std::vector<Event> list;
};

/// A monitor of a sheet whose line is along x, with steps set by the test.
struct Dissection {
    Scene scene;
    TaskDefinition task;
    TaskMonitor monitor;
    Events events;
    WorldSnapshot world;
    std::vector<TickSample> ticks;
    std::uint32_t tick = 0;

    explicit Dissection(TaskDefinition definition = parse_task(task_text, "cut.json"))
        : scene(blades()), task(std::move(definition)), monitor(task, scene, 1) {
        for (int i = 0; i <= 100; ++i) {
            world.sheet.line.emplace_back(0.001 * i, 0, 0);
            world.sheet.line_positions.push_back(0.001 * i);
            world.sheet.line_traction.push_back(0);
            world.sheet.line_divided.push_back(0);
        }
        world.events.resize(64);
        ticks.resize(5);
        // A movement, so that the timer runs.
        for (int i = 0; i < 100; ++i) {
            for (TickSample& sample : ticks) {
                sample.hand[1].flags = hand_inside;
                sample.hand[1].tip[0] += 100 * (i * 5 + static_cast<int>(&sample - ticks.data()));
            }
            step();
        }
    }
    static Scene blades() { return load_scene(test::source_path("assets/scenes/b2_areolar.json")); }
    void happen(EventKind kind, double value, int detail, int hand = 1) {
        Event& event = world.events[static_cast<std::size_t>(world.event_count++)];
        event = Event{};
        event.tick = tick + 5;
        event.kind = kind;
        event.hand = static_cast<std::uint8_t>(hand);
        event.value = static_cast<float>(value);
        event.detail = detail;
    }
    void step(int n = 1) {
        for (int i = 0; i < n; ++i) {
            for (TickSample& sample : ticks) sample.tick = ++tick;
            monitor.on_step(ticks.data(), ticks.size(), world, events);
            world.event_count = 0;
        }
    }
    void traction(double value) {
        for (std::size_t i = 0; i < world.sheet.line.size(); ++i)
            world.sheet.line_traction[i] = world.sheet.line_divided[i] != 0 ? 0 : value;
    }
    void hold(bool held) { world.grasps[0].held = held; }
    void pulled() {
        hold(true);
        traction(6);
        step(101);
    }
    /// A stroke in advances of 1 mm at a distance (um) from the line.
    void cut(int from_mm, int to_mm, int distance = 0) {
        happen(EventKind::cut_begin, from_mm * 1e-3, distance);
        for (int mm = from_mm + 1; mm <= to_mm; ++mm) {
            happen(EventKind::cut_advance, mm * 1e-3, distance);
            happen(EventKind::cut_traction, world.sheet.line_traction[0], 1000);
            step();
        }
        happen(EventKind::cut_end, to_mm * 1e-3, distance);
        step();
    }
    const TaskDisplay& display() const { return monitor.display(); }
};

// Traction has opened the plane: nothing is left to cut there, and nothing was divided.
TEST(CutMonitor, TornFibresLeaveNothingToDivideAndDivideNothing) {
    CutMonitor cut(parse_task(task_text, "cut.json"), Dissection::blades());
    const auto happen = [&](EventKind kind, double place, int distance, int hand) {
        Event event;
        event.kind = kind;
        event.hand = static_cast<std::uint8_t>(hand);
        event.value = static_cast<float>(place);
        event.detail = distance;
        cut.event(event);
    };
    happen(EventKind::cut_begin, 0, 0, 1);
    happen(EventKind::cut_advance, 0.02, 500, 1);
    happen(EventKind::cut_end, 0.02, 500, 1);
    EXPECT_NEAR(cut.divided(), 0.02, 1e-9);
    for (int mm = 20; mm < 60; ++mm) {
        happen(EventKind::fibres_parted, mm * 1e-3, 900, 255);
        happen(EventKind::cut_advance, (mm + 1) * 1e-3, 900, 255);
        happen(EventKind::cut_traction, 12, 1000, 255);
        EXPECT_FALSE(cut.cutting());
        EXPECT_NEAR(cut.distance(), 0.0005, 1e-9) << "of the blade";
    }
    EXPECT_NEAR(cut.divided(), 0.02, 1e-9);
    EXPECT_NEAR(cut.torn(), 0.04, 1e-9);
    EXPECT_NEAR(cut.next(), 0.06, 1e-9);
    // Each has its own beginning: the line between two of them is whole.
    happen(EventKind::fibres_parted, 0.09, 0, 255);
    happen(EventKind::cut_advance, 0.092, 0, 255);
    EXPECT_NEAR(cut.torn(), 0.042, 1e-9);
    // Fibres that tear far from the line do not part it.
    happen(EventKind::fibres_parted, 0.07, 12000, 255);
    happen(EventKind::cut_advance, 0.08, 12000, 255);
    EXPECT_NEAR(cut.torn(), 0.042, 1e-9);
    // A blade through what is torn already divides nothing.
    happen(EventKind::cut_begin, 0.03, 0, 1);
    happen(EventKind::cut_advance, 0.05, 0, 1);
    EXPECT_NEAR(cut.divided(), 0.02, 1e-9);
}

TEST(CutMonitor, TensionCountsOnlyInTheBandWithAHoldAndUnbroken) {
    Dissection cut;
    cut.traction(6);
    cut.step(200);
    EXPECT_EQ(cut.display().goal, 0) << "nobody holds it";
    cut.hold(true);
    cut.traction(3.9);
    cut.step(200);
    cut.traction(8.1);
    cut.step(200);
    EXPECT_EQ(cut.display().goal, 0);
    cut.traction(8);
    cut.step(60);
    EXPECT_NEAR(cut.display().hold_progress, 0.6, 1e-9);
    cut.traction(3);
    cut.step();
    EXPECT_EQ(cut.display().hold_progress, 0);
    cut.traction(4);
    cut.step(100);
    EXPECT_EQ(cut.display().goal, 1);
}

TEST(CutMonitor, TheWholeTask) {
    Dissection cut;
    cut.pulled();
    ASSERT_EQ(cut.display().goal, 1);
    cut.cut(0, 40);
    EXPECT_NEAR(cut.display().goal_progress, 0.4, 1e-9);
    EXPECT_NEAR(cut.display().cut_next_m, 0.04, 1e-9);
    cut.cut(60, 100);
    EXPECT_NEAR(cut.display().goal_progress, 0.8, 1e-9);
    EXPECT_NEAR(cut.display().cut_next_m, 0.04, 1e-9);
    cut.cut(40, 58);
    EXPECT_EQ(cut.display().goal, 2) << "2 mm may stay";
    cut.step(100);
    EXPECT_FALSE(cut.display().ended) << "the flap is still held";
    cut.hold(false);
    cut.step(41);
    EXPECT_TRUE(cut.display().ended);
    EXPECT_EQ(cut.display().end, EventKind::completed);
    EXPECT_EQ(cut.events.count(EventKind::cut_advance), 98) << "what the world reports is passed on";
    EXPECT_EQ(cut.events.count(EventKind::cut_traction), 98);
    EXPECT_GE(cut.events.count(EventKind::goal_progress), 90);
    std::uint32_t last = 0;
    for (const Event& event : cut.events.list) {
        if (event.kind == EventKind::first_movement) continue;  // it began before it was known
        EXPECT_GE(event.tick, last) << event_name(event.kind);
        last = event.tick;
    }
    // The values of the monitor agree with the metrics.
    Trace trace;
    for (std::uint32_t i = 0; i <= cut.tick; ++i) trace.t.push_back(i * 1e-3);
    split_blocks(trace, cut.events.list);
    MetricContext context = make_metric_context(cut.scene, cut.task, {});
    context.metrics = {"area_developed", "traction_eff", "cut_dev_max"};
    const std::vector<MetricResult> rows = compute_metrics(trace, cut.events.list, context);
    EXPECT_NEAR(*find_result(rows, "area_developed", "", "")->value, 98, 1e-4);
    EXPECT_NEAR(*find_result(rows, "traction_eff", "", "")->value, 100, 1e-9);
    EXPECT_EQ(*find_result(rows, "cut_dev_max", "", "")->value, 0);
}

TEST(CutMonitor, ACutOutsideTheCorridorDividesNothing) {
    Dissection cut;
    cut.pulled();
    cut.cut(0, 100, 10001);
    EXPECT_EQ(cut.display().goal_progress, 0);
    cut.cut(0, 100, -9999);
    EXPECT_EQ(cut.display().goal, 2);
}

TEST(CutMonitor, SkipsABridgeTooNarrowForABladeAndNotAWiderOne) {
    for (const int bridge : {2, 4}) {
        Dissection cut;
        cut.pulled();
        cut.cut(0, 40);
        cut.cut(40 + bridge, 100);
        EXPECT_NEAR(cut.display().cut_divided_m, 0.1 - 1e-3 * bridge, 6e-4) << "what is told is what was cut";
        EXPECT_EQ(cut.display().goal, bridge < 3 ? 2 : 1) << bridge;
        if (bridge < 3) continue;
        EXPECT_NEAR(cut.display().cut_next_m, 0.04, 6e-4);
        cut.cut(41, 44);
        EXPECT_EQ(cut.display().goal, 2);
    }
}

TEST(CutMonitor, WarnsBeyondTheMarginOnly) {
    Dissection cut;
    cut.pulled();
    cut.traction(3.5);
    cut.step();
    EXPECT_EQ(cut.display().traction_warning, 0) << "slack between strokes is nobody's fault";
    cut.happen(EventKind::cut_begin, 0.01, 0);
    cut.step();
    EXPECT_TRUE(cut.display().cutting);
    EXPECT_EQ(cut.display().traction_warning, -1);
    cut.traction(3.7);
    cut.step();
    EXPECT_EQ(cut.display().traction_warning, 0) << "within a tenth of the limit";
    cut.traction(8.9);
    cut.step();
    EXPECT_EQ(cut.display().traction_warning, 1);
    EXPECT_FALSE(cut.display().distance_warning);
    cut.happen(EventKind::cut_advance, 0.012, -2300);
    cut.step();
    EXPECT_TRUE(cut.display().distance_warning);
    EXPECT_NEAR(cut.display().cut_distance_m, -0.0023, 1e-9);
    cut.happen(EventKind::cut_end, 0.012, -2300);
    cut.step();
    EXPECT_FALSE(cut.display().distance_warning);
    EXPECT_EQ(cut.display().traction_warning, 1) << "too much tears without a blade, too";
    TaskDefinition silent = parse_task(task_text, "cut.json");
    silent.warning_margin = -1;
    Dissection stage_d(silent);
    stage_d.pulled();
    stage_d.traction(20);
    stage_d.happen(EventKind::cut_begin, 0.01, 5000);
    stage_d.step();
    EXPECT_EQ(stage_d.display().traction_warning, 0);
    EXPECT_FALSE(stage_d.display().distance_warning);
}

TEST(CutMonitor, LooksAtTheTractionWhereTheBladeIs) {
    Dissection cut;
    cut.hold(true);
    for (std::size_t i = 0; i < cut.world.sheet.line.size(); ++i)
        cut.world.sheet.line_traction[i] = static_cast<double>(i);
    cut.step();
    EXPECT_EQ(cut.display().traction_n_m, 0) << "where the line begins";
    cut.world.tools[1].inside = true;
    cut.world.tools[1].tip = Vector3(0.0302, 0.004, 0.003);
    cut.step();
    EXPECT_EQ(cut.display().traction_n_m, 30);
    cut.world.sheet.line_divided[30] = 1;
    cut.step();
    EXPECT_EQ(cut.display().traction_n_m, 31);
    cut.world.tools[1].tip = Vector3(0.03, 0.03, 0.003);
    cut.step();
    EXPECT_EQ(cut.display().traction_n_m, 0) << "too far away to be about to cut";
}

TEST(CutMonitor, TaskCanEndAfterEverythingWasDividedWithoutTraction) {
    Dissection cut;
    cut.hold(true);
    cut.cut(0, 100);
    cut.step(2);
    EXPECT_EQ(cut.display().goal, 2);
}

TEST(CutMonitor, ABladeInTheTissueIsNotReleased) {
    Dissection cut;
    cut.pulled();
    cut.cut(0, 100);
    cut.hold(false);
    cut.happen(EventKind::cut_begin, 0.05, 0, 0);
    cut.step(100);
    EXPECT_FALSE(cut.display().ended);
    cut.happen(EventKind::cut_end, 0.05, 0, 0);
    cut.step(41);
    EXPECT_EQ(cut.display().end, EventKind::completed);
}

TEST(CutMonitor, TimesOutAndAllocatesNothing) {
    Dissection cut;
    cut.pulled();
    const std::uint64_t allocations = test::allocations_in([&] {
        cut.cut(0, 90);
        cut.step(5000);
    });
    EXPECT_EQ(allocations, 0U);
    EXPECT_EQ(cut.display().end, EventKind::timed_out);
}

RC_GTEST_PROP(CutMonitorProperty, WhatIsDividedOnlyGrowsAndIsTheUnionOfTheStrokes, ()) {
    Dissection cut;
    cut.pulled();
    std::vector<bool> millimetres(100, false);
    double before = 0;
    const int strokes = *rc::gen::inRange(1, 8);
    for (int i = 0; i < strokes && cut.display().goal == 1; ++i) {
        const int from = *rc::gen::inRange(0, 99);
        const int to = *rc::gen::inRange(from + 1, 100);
        cut.cut(from, to, *rc::gen::inRange(-2000, 2001));
        for (int mm = from; mm < to; ++mm) millimetres[static_cast<std::size_t>(mm)] = true;
        RC_ASSERT(cut.display().cut_divided_m >= before);
        before = cut.display().cut_divided_m;
        const auto count = std::count(millimetres.begin(), millimetres.end(), true);
        RC_ASSERT(std::abs(before - 1e-3 * static_cast<double>(count)) < 1e-9);
    }
}

TEST(CutTask, NeedsASheetWithALongEnoughLine) {
    const TaskDefinition task = parse_task(task_text, "cut.json");
    EXPECT_THROW(TaskMonitor(task, load_scene(test::source_path("assets/scenes/a2_targets.json")), 1),
                 InputError);
    Scene shorter = Dissection::blades();
    shorter.sheet->line_length = 0.09;
    EXPECT_THROW(TaskMonitor(task, shorter, 1), InputError);
}

TEST(CutTask, RefusesInconsistentValues) {
    const auto broken = [](const char* what, const char* with) {
        std::string text = task_text;
        const std::size_t at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        text.replace(at, std::string(what).size(), with);
        try {
            parse_task(text, "cut.json");
            return std::string("accepted");
        } catch (const InputError& error) {
            EXPECT_GT(std::atoi(error.place().c_str()), 0) << error.what();
            return error.problem();
        }
    };
    EXPECT_NE(broken("\"tolerance_m\": 0.002", "\"tolerance_m\": 0.02").find("above corridor_m"),
              std::string::npos);
    EXPECT_NE(broken("\"traction_low_n_m\": 4, \"traction_high_n_m\": 8}",
                     "\"traction_low_n_m\": 9, \"traction_high_n_m\": 8}")
                  .find("not below"),
              std::string::npos);
    EXPECT_NE(broken("\"length_m\": 0.1, ", "").find("needs \"length_m\""), std::string::npos);
    EXPECT_NE(broken("\"hold_s\": 0.2", "\"height_m\": 0.2").find("needs \"hold_s\""), std::string::npos);
}

}  // namespace
}  // namespace fulcrum
