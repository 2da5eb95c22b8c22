// SPDX-License-Identifier: Apache-2.0
// Task C4: its file, the data of its pathology report, and its goals in constructed steps over septa.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "assessment/scoring/score.h"
#include "assessment/task/monitor.h"
#include "assessment/task/specimen_plan.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

std::string task_text() {
    return read_text_file(test::source_path("assets/tasks/C4.json"), 1U << 20U);
}
Scene scene_of(const TaskDefinition& task) {
    return load_scene(test::source_path("assets/scenes/" + task.scene));
}
TaskDefinition changed(const std::string& what, const std::string& with) {
    std::string text = task_text();
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << "the asset no longer holds " << what;
    text.replace(at, what.size(), with);
    return parse_task(text, "changed.json");
}

TEST(Posterior, TaskAndSceneAreConsistent) {
    const TaskDefinition task = parse_task(task_text(), "C4.json");
    EXPECT_NO_THROW(check_gates(task, "C4.json"));
    const Scene scene = scene_of(task);
    ASSERT_TRUE(scene.septa.has_value());
    ASSERT_EQ(task.goals.size(), 3U);
    EXPECT_EQ(task.goals[1].kind, GoalKind::divide_line);
    EXPECT_NEAR(task.goals[1].length_m, marked_line(scene), 1e-9) << "down to the levator";
    for (const char* metric : {"traction_eff", "plane_dev", "tme_grade", "crm_mm", "drm_mm"})
        EXPECT_TRUE(std::any_of(task.metrics.begin(), task.metrics.end(), [&](const std::string& id) {
            return id == metric;
        })) << metric;
    for (const char* error : {"perforation", "vessel_injury", "nerve_injury"})
        EXPECT_TRUE(std::any_of(task.critical_errors.begin(), task.critical_errors.end(),
                                [&](const std::string& id) { return id == error; }))
            << error;
    const SpecimenPlan plan = make_specimen_plan(scene, task).value();
    EXPECT_EQ(plan.levels, scene.septa->count);
    EXPECT_EQ(plan.line, scene.septa->width);
    EXPECT_EQ(plan.asked, task.goals[1].length_m);
    EXPECT_EQ(plan.fat, scene.septa->fat_height);
    EXPECT_EQ(plan.tolerance, task.goals[1].tolerance_m);
    ASSERT_TRUE(plan.tumour.has_value());
    EXPECT_LT(plan.tumour->level, plan.levels - 1) << "there is something to reach below it";
    EXPECT_FALSE(make_specimen_plan(scene, load_task(test::source_path("assets/tasks/B2.json"))).has_value());
}

// All that the goal asks for but a bridge of 2 mm, which it ignores.
TEST(Posterior, WhatTheGoalAsksForIsGradedInEveryVariant) {
    const TaskDefinition task = parse_task(task_text(), "C4.json");
    const Goal& goal = task.goals[1];
    ASSERT_GE(task.variants.size(), 3U);
    for (const TaskVariant& variant : task.variants) {
        const Scene scene = load_scene(test::source_path("assets/scenes/" + variant.scene));
        EXPECT_GE(marked_line(scene), goal.length_m - 1e-9) << variant.id;
        std::vector<Event> events;
        const auto add = [&](EventKind kind, double place) {
            Event event;
            event.tick = static_cast<std::uint32_t>(events.size() + 1);
            event.kind = kind;
            event.hand = 1;
            event.value = static_cast<float>(place);
            events.push_back(event);
        };
        const double width = scene.septa->width;
        for (int level = 0; level < scene.septa->count; ++level) {
            const double from = level == 0 ? 0.002 : level * width;
            const double to = std::min((level + 1) * width, goal.length_m);
            add(EventKind::cut_begin, from);
            for (int i = 1; i <= 50; ++i) add(EventKind::cut_advance, from + (to - from) * i / 50);
            add(EventKind::cut_end, to);
        }
        const SpecimenPlan plan = make_specimen_plan(scene, task).value();
        const PathologyReport report = pathology_of_events(events, 1e-3, 10, plan);
        EXPECT_EQ(report.grade, 3) << variant.id << ": " << grade_reason_name(report.reasons.at(0));
        EXPECT_EQ(report.lowest_level, scene.septa->count - 1) << variant.id;
        const double share =
            divided_length(cut_strokes(events, 1e-3, 10), goal.length_m, goal.corridor_m) / goal.length_m;
        EXPECT_NEAR(share, 0.222 / 0.224, 1e-6) << variant.id;
        EXPECT_NEAR(report.divided, share, 0.005) << variant.id << ": the gate and the grade agree";
    }
}

TEST(Posterior, RefusesAnImpossibleReport) {
    const auto refused = [](const TaskDefinition& task, const Scene& scene, const std::string& wrong) {
        try {
            TaskMonitor(task, scene, 1);
            ADD_FAILURE() << "accepted: " << wrong;
        } catch (const InputError& error) {
            EXPECT_NE(error.problem().find(wrong), std::string::npos) << error.what();
            EXPECT_FALSE(error.hint().empty());
        }
    };
    const TaskDefinition task = parse_task(task_text(), "C4.json");
    const Scene scene = scene_of(task);
    refused(changed("\"level\": 1", "\"level\": 4"), scene, "only 4 septa");
    refused(changed("\"depth_m\": 0.006", "\"depth_m\": 0.012"), scene, "whole mesorectum");
    refused(changed("\"length_m\": 0.224", "\"length_m\": 0.3"), scene, "marked line");
    TaskDefinition sheet = load_task(test::source_path("assets/tasks/B2.json"));
    sheet.pathology = true;
    refused(sheet, scene_of(sheet), "no septa");
    for (const auto& [what, with] : std::initializer_list<std::pair<const char*, const char*>>{
             {"\"sector\": \"mid\"", "\"sector\": \"top\""},
             {"\"depth_m\": 0.006", "\"depth_m\": 0"},
             {"\"length_m\": 0.016", "\"size_m\": 0.016"},
             {"\"level\": 1, ", ""}})
        EXPECT_THROW(changed(what, with), InputError) << with;
}

class Events : public EventSink {
  public:
    void on_event(const Event& event) noexcept override { list.push_back(event); }
    int count(EventKind kind) const {
        return static_cast<int>(
            std::count_if(list.begin(), list.end(), [&](const Event& e) { return e.kind == kind; }));
    }
    std::vector<Event> list;
};

/// A monitor of septa, with steps set by the test.
struct Steps {
    TaskDefinition task = parse_task(task_text(), "C4.json");
    Scene scene = scene_of(task);
    TaskMonitor monitor{task, scene, 1};
    Events events;
    WorldSnapshot world;
    std::uint32_t tick = 0;

    Steps() {
        for (int i = 0; i < 224; ++i) {
            world.sheet.line.emplace_back(0.001 * i, 0, 0);
            world.sheet.line_positions.push_back(0.001 * i + 0.0005);
            world.sheet.line_traction.push_back(12);
            world.sheet.line_divided.push_back(0);
        }
        world.events.resize(8);
        world.grasps[0].held = true;
        world.bowel.nodes.assign(static_cast<std::size_t>(scene.bowel->segments) + 1, Vector3::Zero());
        world.bowel.node_arc_lengths.assign(world.bowel.nodes.size(), 0.0);
    }
    void step() {
        std::vector<TickSample> ticks(5);
        for (TickSample& sample : ticks) {
            sample.tick = ++tick;
            sample.hand[1].flags = hand_inside;
            sample.hand[1].tip[0] =
                static_cast<std::int32_t>(tick) * 100;  // a movement, so that the timer runs
        }
        monitor.on_step(ticks.data(), ticks.size(), world, events);
        world.event_count = 0;
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i) step();
    }
    void cut(double from, double to) {
        const auto add = [&](EventKind kind, double place) {
            Event event;
            event.tick = tick;
            event.kind = kind;
            event.hand = 1;
            event.value = static_cast<float>(place);
            world.events[static_cast<std::size_t>(world.event_count++)] = event;
        };
        add(EventKind::cut_begin, from);
        add(EventKind::cut_advance, to);
        add(EventKind::cut_end, to);
        step();
    }
};

TEST(Posterior, IsDoneWhenEveryLevelIsDivided) {
    Steps s;
    s.steps(220);  // taut for a second, the rectum held
    EXPECT_EQ(s.monitor.display().goal, 1);
    EXPECT_NEAR(s.monitor.display().traction_n_m, 12, 1e-9);
    const double septum = s.scene.septa->width;
    for (int level = 0; level < 4; ++level) {
        EXPECT_NEAR(s.monitor.display().cut_next_m, level * septum, 0.0006) << level;
        // A millimetre remains at the right rim: too narrow to be cut, and not required.
        s.cut(level * septum + 0.001, (level + 1) * septum - (level == 2 ? 0.004 : 0));
        if (level == 2) {
            EXPECT_NEAR(s.monitor.display().cut_next_m, 3 * septum - 0.004, 0.0006) << "a bridge of 4 mm";
            EXPECT_EQ(s.monitor.display().goal, 1);
            s.cut(3 * septum - 0.0045, 3 * septum);
        }
    }
    EXPECT_EQ(s.monitor.display().goal, 2);
    s.world.grasps[0].held = false;
    s.steps(110);
    EXPECT_EQ(s.monitor.display().end, EventKind::completed);
    EXPECT_EQ(s.events.count(EventKind::phase_end), 3);
}

// The undivided rest at the left rim of a level is not added to that of the level below.
TEST(Posterior, ContinuesAtTheNextLevelAfterABridgeAtTheRim) {
    Steps s;
    s.steps(220);
    const double septum = s.scene.septa->width;
    s.cut(0, septum - 0.0006);
    EXPECT_NEAR(s.monitor.display().cut_next_m, septum, 0.0006);
    EXPECT_GE(s.monitor.display().cut_next_m, septum - 1e-9);
}

TEST(Posterior, ASkippedLevelIsNotDone) {
    Steps s;
    s.steps(220);
    const double septum = s.scene.septa->width;
    for (const int level : {0, 2, 3}) s.cut(level * septum, (level + 1) * septum);
    EXPECT_EQ(s.monitor.display().goal, 1);
    EXPECT_NEAR(s.monitor.display().cut_next_m, septum, 0.0006);
    s.cut(septum, 2 * septum);
    EXPECT_EQ(s.monitor.display().goal, 2);
}

}  // namespace
}  // namespace fulcrum
