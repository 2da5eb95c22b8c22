// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/monitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim_core/instrument/device.h"
#include "sim_core/numerics/input_error.h"
#include "tests/assessment/task/monitor_bench.h"
#include "tests/support/allocation_count.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

using monitor_bench::Bench;
using monitor_bench::Events;

void one_target(Scene&, TaskDefinition& task) {
    task.goals.resize(1);
    task.goals[0].count = 2;
    task.goals[0].hold_s = 0.5;
}

struct TargetBench : Bench {
    TargetBench() : Bench("A2.json", one_target) {
        world.targets = {{Vector3(0, 0, -0.02), 0.006, Hand::right},
                         {Vector3(0.02, 0, -0.02), 0.006, Hand::left},
                         {Vector3(-0.02, 0, -0.02), 0.006, Hand::left}};
    }
};

TEST(Monitor, ClockStartsWhereTheFirstMovementBegan) {
    Bench bench("A2.json");
    bench.ticks(500);
    EXPECT_FALSE(bench.monitor.display().moving_seen);
    bench.move(Hand::left, Vector3(0, 0, 0), Vector3(0.0009, 0, 0),
               300);  // 3 mm/s: too slow to be a movement
    EXPECT_FALSE(bench.monitor.display().moving_seen);
    bench.move(Hand::left, Vector3(0.0009, 0, 0), Vector3(0.0029, 0, 0), 100);  // 20 mm/s, too short
    bench.ticks(300);
    EXPECT_FALSE(bench.monitor.display().moving_seen);
    const std::uint32_t begin = bench.sample.tick;
    bench.move(Hand::left, Vector3(0.0029, 0, 0), Vector3(0.0129, 0, 0), 500);
    ASSERT_TRUE(bench.monitor.display().moving_seen);
    const Event& event = bench.events.first(EventKind::first_movement);
    EXPECT_EQ(event.hand, 0);
    EXPECT_NEAR(event.tick, begin, 20);
    EXPECT_NEAR(bench.monitor.display().elapsed_s, 0.5, 0.02);
    EXPECT_NEAR(bench.monitor.display().remaining_s, bench.task.time_limit_s - 0.5, 0.02);
}

TEST(Monitor, ClockStartsWithWorkOnTissueEvenIfMovementsAreShort) {
    for (const unsigned flag : {hand_grasping, hand_cutting, hand_energy}) {
        Bench bench("A2.json");
        // Jerks of 20 mm/s for 0.1 s between rests of 0.1 s: no movement by its definition.
        for (int jerk = 0; jerk < 20; ++jerk) {
            const Vector3 from(0, 0, 0.002 * (jerk % 2)), to(0, 0, 0.002 * (1 - jerk % 2));
            bench.move(Hand::right, from, to, 100);
            bench.ticks(100);
        }
        ASSERT_FALSE(bench.monitor.display().moving_seen);
        const std::uint32_t begin = bench.sample.tick;
        bench.sample.hand[1].flags = static_cast<decltype(bench.sample.hand[1].flags)>(flag);
        bench.ticks(10);
        EXPECT_FALSE(bench.monitor.display().moving_seen) << "outside the body";
        bench.sample.hand[1].flags =
            static_cast<decltype(bench.sample.hand[1].flags)>(hand_inside | hand_in_view | flag);
        bench.ticks(1000);
        ASSERT_TRUE(bench.monitor.display().moving_seen) << flag;
        EXPECT_NEAR(bench.monitor.display().elapsed_s, 1.0, 0.02);
        EXPECT_NEAR(bench.events.first(EventKind::first_movement).tick, begin + 10, 2);
    }
}

TEST(Monitor, ClockStartsWithContactOfTheLitTargetEvenIfMovementsAreShort) {
    TargetBench bench;
    // By jerks of 20 mm/s for 0.1 s between rests of 0.1 s to the left hand's first target.
    const Vector3 target = bench.world.targets[1].centre, x = Vector3::UnitX();
    for (double away = 0.028; away > 0.008; away -= 0.002) {
        ASSERT_FALSE(bench.monitor.display().moving_seen);
        bench.move(Hand::left, target + away * x, target + (away - 0.002) * x, 100);
        bench.ticks(100);
    }
    bench.ticks(1000);
    ASSERT_TRUE(bench.monitor.display().moving_seen);
    const Event& begin = bench.events.first(EventKind::first_movement);
    const Event& reached = bench.events.first(EventKind::target_reached);
    EXPECT_EQ(begin.hand, 0);
    // Where the hold began, or the jerk that led to it.
    const double before = (reached.tick - begin.tick) * 1e-3;
    EXPECT_GE(before, bench.task.goals[0].hold_s - 2e-3);
    EXPECT_LE(before, bench.task.goals[0].hold_s + 0.1);
}

TEST(Monitor, ClockDoesNotStartWithContactOfAnUnlitTarget) {
    TargetBench bench;
    bench.move(Hand::left, bench.world.targets[2].centre, bench.world.targets[2].centre, 1000);
    bench.move(Hand::right, bench.world.targets[0].centre, bench.world.targets[0].centre, 1000);
    EXPECT_FALSE(bench.monitor.display().moving_seen);
}

TEST(Monitor, MovementOutsideTheBodyDoesNotStartTheClock) {
    Bench bench("A2.json");
    bench.sample.hand[1].flags = 0;
    bench.move(Hand::right, Vector3(0, 0, 0), Vector3(0.05, 0, 0), 1000);
    EXPECT_FALSE(bench.monitor.display().moving_seen);
}

TEST(Monitor, TargetCountsOnlyAfterAnUnbrokenHold) {
    TargetBench bench;
    bench.ticks(5);
    EXPECT_EQ(bench.monitor.display().active_target, 1) << "the first of the goal's own hand";
    EXPECT_EQ(bench.events.first(EventKind::target_shown).detail, 1);
    bench.put(Hand::right, bench.world.targets[1].centre);
    bench.ticks(1000);
    EXPECT_EQ(bench.events.count(EventKind::target_reached), 0) << "the other hand does not count";
    bench.put(Hand::left, bench.world.targets[1].centre);
    bench.ticks(400);
    EXPECT_NEAR(bench.monitor.display().hold_progress, 0.8, 1e-9);
    bench.put(Hand::left, Vector3(0.03, 0, -0.02));
    bench.tick();
    bench.put(Hand::left, bench.world.targets[1].centre);
    bench.ticks(400);
    EXPECT_EQ(bench.events.count(EventKind::target_reached), 0) << "leaving starts the hold again";
    bench.ticks(104);
    ASSERT_EQ(bench.events.count(EventKind::target_reached), 1);
    EXPECT_EQ(bench.monitor.display().active_target, 2);
    EXPECT_NEAR(bench.monitor.display().goal_progress, 0.5, 1e-12);
    bench.put(Hand::left, bench.world.targets[2].centre);
    bench.ticks(505);
    EXPECT_TRUE(bench.monitor.display().ended);
    EXPECT_EQ(bench.monitor.display().end, EventKind::completed);
    EXPECT_EQ(bench.events.count(EventKind::phase_end), 1);
    EXPECT_EQ(bench.events.list.back().kind, EventKind::completed);
    const std::size_t before = bench.events.list.size();
    bench.ticks(100);
    EXPECT_EQ(bench.events.list.size(), before) << "nothing follows the end";
}

TEST(Monitor, TouchIsContactWithinOneMillimetre) {
    TargetBench bench;
    const double reach = 0.006 + bench.scene.instrument(Hand::left)->tip_radius + 0.001;
    bench.put(Hand::left, bench.world.targets[1].centre + Vector3(0, 0, reach + 1e-5));
    bench.ticks(600);
    EXPECT_EQ(bench.events.count(EventKind::target_reached), 0);
    bench.put(Hand::left, bench.world.targets[1].centre + Vector3(0, 0, reach - 1e-5));
    bench.ticks(600);
    EXPECT_EQ(bench.events.count(EventKind::target_reached), 1);
}

TEST(Monitor, OverForceBeginsAtTheLimitAndEndsOnce) {
    Bench bench("B1.json");
    const int bowel = bench.scene.tissue_index("bowel");
    const double limit = bench.scene.tissues[static_cast<std::size_t>(bowel)].force_limit;
    bench.force(Hand::right, limit - 0.01, bowel);
    bench.ticks(10);
    EXPECT_EQ(bench.events.count(EventKind::over_force_begin), 0);
    bench.force(Hand::right, limit + 0.01, bowel);
    bench.ticks(10);
    EXPECT_FALSE(bench.monitor.display().warning[1]) << "stage B warns 10 % above the limit";
    bench.force(Hand::right, limit + 1, bowel);
    bench.ticks(10);
    EXPECT_TRUE(bench.monitor.display().warning[1]);
    EXPECT_NEAR(bench.monitor.display().force[1], limit + 1, 1e-3);
    EXPECT_NEAR(bench.monitor.display().force_limit[1], limit, 1e-6);
    bench.force(Hand::right, limit - 0.01, bowel);  // inside the hysteresis
    bench.ticks(10);
    EXPECT_EQ(bench.events.count(EventKind::over_force_end), 0);
    bench.force(Hand::right, 0, -1);
    bench.ticks(10);
    ASSERT_EQ(bench.events.count(EventKind::over_force_begin), 1);
    ASSERT_EQ(bench.events.count(EventKind::over_force_end), 1);
    EXPECT_NEAR(bench.events.first(EventKind::over_force_end).value, limit + 1, 1e-3);
    EXPECT_EQ(bench.events.first(EventKind::over_force_begin).detail, std::lround(limit * 1000));
}

// Finds the force at which an attempt's bowel perforates by pushing with increasing force.
double perforation_force(std::uint64_t seed) {
    Bench bench("B1.json", {}, seed);
    const int bowel = bench.scene.tissue_index("bowel");
    for (double force = 2; force < 30; force += 0.1) {
        bench.force(Hand::left, force, bowel);
        bench.ticks(5);
        if (bench.events.count(EventKind::perforation) > 0) {
            EXPECT_TRUE(bench.monitor.display().critical);
            EXPECT_EQ(bench.events.count(EventKind::perforation), 1);
            return force;
        }
    }
    return 30;
}

TEST(Monitor, PerforationForceIsDrawnFromTheSeed) {
    EXPECT_EQ(perforation_force(5), perforation_force(5));
    double sum = 0, squares = 0;
    constexpr int n = 60;
    for (int seed = 1; seed <= n; ++seed) {
        const double force = perforation_force(static_cast<std::uint64_t>(seed));
        sum += force;
        squares += force * force;
    }
    const double mean = sum / n, deviation = std::sqrt(squares / n - mean * mean);
    EXPECT_NEAR(mean, 10.3, 4 * 2.9 / std::sqrt(n));
    EXPECT_NEAR(deviation, 2.9, 4 * 2.9 / std::sqrt(2.0 * n));
}

TEST(Monitor, GraspedTissueIsNotPerforatedByPulling) {
    Bench bench("B1.json");
    const int bowel = bench.scene.tissue_index("bowel");
    bench.sample.hand[0].flags |= hand_grasping;
    bench.force(Hand::left, 29, bowel);
    bench.ticks(20);
    EXPECT_EQ(bench.events.count(EventKind::perforation), 0);
    EXPECT_EQ(bench.events.count(EventKind::over_force_begin), 1);
}

// 10.3 +- 2.9 N between hemispheres of 1.5 mm diameter, which press on 1.77 mm2 of each side.
TEST(Monitor, PinchingPerforatesByThePressureOfThePublishedMeasurement) {
    const double limit = perforation_force(5);
    const auto pinched = [&](double jaw_force, double area_mm2) {
        Bench bench("B1.json", {}, 5);
        HandSample& hand = bench.sample.hand[0];
        hand.flags |= hand_grasping;
        hand.tissue = static_cast<std::int16_t>(bench.scene.tissue_index("bowel"));
        hand.jaw_force = static_cast<std::int32_t>(1e3 * jaw_force);
        hand.jaw_area = static_cast<std::int32_t>(1e3 * area_mm2);
        bench.ticks(50);
        return bench.events.count(EventKind::perforation);
    };
    EXPECT_EQ(pinched(limit - 0.1, 3.535), 0) << "as the hemispheres";
    EXPECT_EQ(pinched(limit + 0.1, 3.53), 1) << "one hole, one event";
    EXPECT_EQ(pinched(limit + 0.1, 1), 1) << "a smaller bite is not known to need less";
    EXPECT_EQ(pinched(limit - 0.1, 1), 0);
    EXPECT_EQ(pinched(2 * limit - 0.2, 7.07), 0) << "twice the area takes twice the force";
    EXPECT_EQ(pinched(2 * limit + 0.2, 7.06), 1);
    EXPECT_EQ(pinched(16, 200), 0) << "whole jaws";
    EXPECT_EQ(pinched(16, 0), 0) << "an area that is not known says nothing";
}

TEST(Monitor, JawPressureAboveTheLimitIsOneEvent) {
    Bench bench("B1.json");
    bench.sample.hand[0].flags |= hand_grasping;
    bench.sample.hand[0].tissue = 0;
    bench.sample.hand[0].jaw_area = 20000;  // 20 mm2
    bench.sample.hand[0].jaw_force = 6000;
    bench.ticks(10);
    EXPECT_EQ(bench.events.count(EventKind::jaw_pressure), 0) << "300 kPa";
    bench.sample.hand[0].jaw_force = 8000;
    bench.ticks(50);
    ASSERT_EQ(bench.events.count(EventKind::jaw_pressure), 1);
    EXPECT_NEAR(bench.events.first(EventKind::jaw_pressure).value, 400, 0.1);
}

TEST(Monitor, PauseStopsTheClockAndALostDeviceInterrupts) {
    Bench bench("A2.json");
    bench.move(Hand::left, Vector3(0, 0, 0), Vector3(0.02, 0, 0), 1000);
    const double elapsed = bench.monitor.display().elapsed_s;
    bench.sample.rig_flags = rig_paused;
    bench.ticks(2000);
    EXPECT_EQ(bench.monitor.display().elapsed_s, elapsed);
    bench.sample.rig_flags = 0;
    bench.ticks(1000);
    EXPECT_NEAR(bench.monitor.display().elapsed_s, elapsed + 1, 1e-9);
    EXPECT_EQ(bench.events.count(EventKind::pause), 1);
    EXPECT_EQ(bench.events.count(EventKind::resume), 1);
    bench.sample.rig_flags = rig_device_lost;
    bench.ticks(30000);
    bench.sample.rig_flags = 0;
    bench.ticks(100);
    EXPECT_EQ(bench.events.count(EventKind::device_back), 1);
    EXPECT_FALSE(bench.monitor.display().ended) << "back within 60 s";
    bench.sample.rig_flags = rig_device_lost;
    bench.ticks(61000);
    ASSERT_TRUE(bench.monitor.display().ended);
    EXPECT_EQ(bench.monitor.display().end, EventKind::interrupted);
}

TEST(Monitor, TimeLimitCountsFromTheFirstMovement) {
    Bench bench("A2.json", [](Scene&, TaskDefinition& task) { task.time_limit_s = 2; });
    bench.ticks(1000);
    bench.move(Hand::left, Vector3(0, 0, 0), Vector3(0.01, 0, 0), 500);
    bench.ticks(1400);
    EXPECT_FALSE(bench.monitor.display().ended);
    bench.ticks(150);
    ASSERT_TRUE(bench.monitor.display().ended);
    EXPECT_EQ(bench.monitor.display().end, EventKind::timed_out);
    Bench idle("A2.json", [](Scene&, TaskDefinition& task) { task.time_limit_s = 2; });
    idle.ticks(2100);
    EXPECT_EQ(idle.monitor.display().end, EventKind::timed_out) << "hands that never move do not run forever";
    EXPECT_FALSE(idle.monitor.display().moving_seen);
}

TEST(Monitor, AbandonAndSimulatorFaultEndTheAttempt) {
    Bench abandoned("A2.json");
    abandoned.ticks(10);
    abandoned.sample.rig_flags = rig_abandon;
    abandoned.ticks(5);
    EXPECT_EQ(abandoned.monitor.display().end, EventKind::abandoned);
    Bench fault("A2.json");
    fault.world.outcome = 4;
    fault.ticks(5);
    EXPECT_EQ(fault.events.count(EventKind::simulator_fault), 1);
    EXPECT_TRUE(fault.monitor.display().ended);
}

TEST(Monitor, BowelRunCountsHandOverHandStepsOnly) {
    Bench bench("B1.json");
    const Goal goal = bench.task.goals[0];
    bench.ticks(5);
    EXPECT_NEAR(bench.monitor.display().run_next_m, goal.from_m, 1e-12);
    bench.grasp(Hand::right, goal.from_m);
    EXPECT_NEAR(bench.monitor.display().run_next_m, goal.from_m + 0.05, 1e-9);
    bench.grasp(Hand::left, goal.from_m + 0.2);
    EXPECT_NEAR(bench.monitor.display().run_covered_m, 0, 1e-12) << "too far at once";
    bench.let_go(Hand::left);
    bench.grasp(Hand::left, goal.from_m + 0.05);
    EXPECT_NEAR(bench.monitor.display().run_covered_m, 0.05, 1e-9);
    bench.let_go(Hand::right);
    bench.let_go(Hand::left);
    bench.grasp(Hand::right, goal.from_m + 0.10);
    EXPECT_NEAR(bench.monitor.display().run_covered_m, 0.05, 1e-9) << "nobody held: not hand over hand";
    bench.let_go(Hand::right);
    bench.grasp(Hand::left, goal.from_m + 0.05);
    double place = 0.05;
    Hand hand = Hand::right;
    while (place < goal.length_m - 1e-9 && !bench.monitor.display().ended) {
        place += 0.06;  // the last step may lead beyond the end
        bench.grasp(hand, goal.from_m + place);
        hand = hand == Hand::left ? Hand::right : Hand::left;
        bench.let_go(hand);
    }
    EXPECT_EQ(bench.monitor.display().goal, 1) << "the lift follows";
    EXPECT_EQ(bench.events.count(EventKind::phase_end), 1);
}

TEST(Monitor, LiftMustStayUpForTheWholeHold) {
    Bench bench("B1.json", [](Scene&, TaskDefinition& task) { task.goals.erase(task.goals.begin()); });
    const Goal goal = bench.task.goals[0];
    bench.ticks(10);
    const double middle = 0.5 * (goal.from_m + goal.to_m);
    bench.grasp(Hand::right, middle);
    const auto raise = [&](double height) {
        for (Vector3& node : bench.world.bowel.nodes) node.z() = -0.05 + height;
    };
    raise(goal.height_m - 0.001);
    bench.ticks(1000);
    EXPECT_NEAR(bench.monitor.display().lift_height_m, goal.height_m - 0.001, 1e-9);
    EXPECT_EQ(bench.monitor.display().hold_progress, 0);
    raise(goal.height_m + 0.005);
    bench.ticks(20000);
    EXPECT_NEAR(bench.monitor.display().hold_progress, 20 / goal.hold_s, 0.01);
    bench.let_go(Hand::right, true);
    EXPECT_EQ(bench.events.count(EventKind::slip), 1);
    EXPECT_EQ(bench.events.count(EventKind::drop), 1) << "it was up and nobody else held it";
    EXPECT_EQ(bench.monitor.display().hold_progress, 0);
    bench.grasp(Hand::right, middle);
    bench.ticks(30005);
    EXPECT_EQ(bench.monitor.display().end, EventKind::completed);
}

TEST(Monitor, BowelThatIsLetGoOfAtTheHeightOfTheLiftIsDropped) {
    Bench bench("B1.json");
    const Goal lift = bench.task.goals[1];
    bench.ticks(10);
    const auto raise = [&](double height) {
        for (Vector3& node : bench.world.bowel.nodes) node.z() = -0.05 + height;
        bench.ticks(10);
    };
    bench.grasp(Hand::right, 0.3, 12);
    raise(lift.height_m - 0.001);
    bench.let_go(Hand::right);
    EXPECT_EQ(bench.events.count(EventKind::drop), 0) << "it was put down";
    bench.grasp(Hand::right, 0.3, 12);
    raise(lift.height_m + 0.005);
    bench.let_go(Hand::right);
    ASSERT_EQ(bench.events.count(EventKind::drop), 1);
    EXPECT_EQ(bench.events.first(EventKind::drop).hand, 1);
    EXPECT_EQ(bench.events.first(EventKind::drop).detail, 12);
    EXPECT_EQ(bench.events.count(EventKind::slip), 0);
    bench.grasp(Hand::left, 0.3, 12);
    bench.grasp(Hand::right, 0.34, 13);
    bench.let_go(Hand::left);
    EXPECT_EQ(bench.events.count(EventKind::drop), 1) << "the other hand holds it";
    bench.grasp(Hand::left, 0.3, 12);
    for (GraspState& grasp : bench.world.grasps) grasp.held = false;
    bench.ticks(bench.scene.ticks_per_step);
    EXPECT_EQ(bench.events.count(EventKind::drop), 2) << "both hands at once: it falls once";
    int drops = 2;
    for (const Hand slipping : {Hand::right, Hand::left}) {
        bench.grasp(Hand::left, 0.3, 12);
        bench.grasp(Hand::right, 0.34, 13);
        for (GraspState& grasp : bench.world.grasps) grasp.held = false;
        bench.world.grasps[static_cast<int>(slipping)].slipped = true;
        bench.ticks(bench.scene.ticks_per_step);
        EXPECT_EQ(bench.events.count(EventKind::drop), ++drops)
            << "one opens, it slips out of the other: whichever hand that is, it falls once";
    }
}

TEST(Monitor, JawsThatOpenDropNothingWhereNoGoalLifts) {
    Bench bench("B1.json", [](Scene&, TaskDefinition& task) { task.goals.pop_back(); });
    bench.ticks(10);
    bench.grasp(Hand::right, 0.3, 12);
    for (Vector3& node : bench.world.bowel.nodes) node.z() = 0.05;
    bench.let_go(Hand::right);
    EXPECT_EQ(bench.events.count(EventKind::release), 1);
    EXPECT_EQ(bench.events.count(EventKind::drop), 0);
}

TEST(Monitor, SlipWhileTheOtherHandHoldsIsNotADropAndRegraspCountsWithinTwoSeconds) {
    Bench bench("B1.json");
    bench.ticks(5);
    bench.grasp(Hand::right, 0.3, 12);
    bench.grasp(Hand::left, 0.34, 13);
    for (Vector3& node : bench.world.bowel.nodes) node.z() = 0;
    bench.let_go(Hand::left, true);
    EXPECT_EQ(bench.events.count(EventKind::slip), 1);
    EXPECT_EQ(bench.events.count(EventKind::drop), 0);
    bench.let_go(Hand::right);
    EXPECT_EQ(bench.events.count(EventKind::release), 1);
    bench.ticks(1000);
    bench.grasp(Hand::right, 0.3, 12);
    EXPECT_EQ(bench.events.count(EventKind::regrasp), 1);
    bench.let_go(Hand::right);
    bench.ticks(2500);
    bench.grasp(Hand::right, 0.3, 12);
    EXPECT_EQ(bench.events.count(EventKind::regrasp), 1) << "2.5 s later is a new grasp";
}

TEST(Monitor, CrossedShaftsCollideOnce) {
    Bench bench("B1.json");
    for (int h = 0; h < hand_count; ++h) {
        ToolPose& tool = bench.world.tools[h];
        tool.inside = true;
        tool.trocar = bench.scene.instruments[static_cast<std::size_t>(h)].trocar.position;
        tool.tip = tool.trocar + 0.15 * bench.scene.instruments[static_cast<std::size_t>(h)].trocar.direction;
    }
    bench.ticks(20);
    EXPECT_EQ(bench.events.count(EventKind::tool_collision), 0) << "tips are apart";
    bench.world.tools[0].tip.x() = -0.03;
    bench.world.tools[1].tip.x() = 0.03;
    bench.ticks(50);
    EXPECT_EQ(bench.events.count(EventKind::tool_collision), 1);
}

TEST(Monitor, DoesNotAllocateAndRepeatsItself) {
    const auto run = [](Bench& bench) {
        bench.move(Hand::left, Vector3(0, 0, 0), Vector3(0.02, 0, 0), 500);
        for (int i = 0; i < 20; ++i) {
            bench.grasp(i % 2 == 0 ? Hand::left : Hand::right, 0.15 + 0.05 * i, i);
            bench.force(Hand::left, 0.3 * i, 0);
            bench.ticks(50);
            bench.let_go(i % 2 == 0 ? Hand::right : Hand::left, i % 3 == 0);
        }
    };
    Bench a("B1.json"), b("B1.json");
    EXPECT_EQ(test::allocations_in([&] { run(a); }), 0U);
    run(b);
    ASSERT_EQ(a.events.list.size(), b.events.list.size());
    EXPECT_GT(a.events.list.size(), 40U);
    for (std::size_t i = 0; i < a.events.list.size(); ++i) {
        EXPECT_EQ(a.events.list[i].tick, b.events.list[i].tick);
        EXPECT_EQ(a.events.list[i].kind, b.events.list[i].kind);
        EXPECT_EQ(a.events.list[i].value, b.events.list[i].value);
    }
}

TEST(Monitor, TaskThatDoesNotFitItsSceneIsRefused) {
    Scene scene = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    TaskDefinition task = load_task(test::source_path("assets/tasks/B1.json"));
    EXPECT_THROW(TaskMonitor(task, scene, 1), InputError);
    task = load_task(test::source_path("assets/tasks/A2.json"));
    task.goals[0].count = 11;
    EXPECT_THROW(TaskMonitor(task, scene, 1), InputError);
}

}  // namespace
}  // namespace fulcrum
