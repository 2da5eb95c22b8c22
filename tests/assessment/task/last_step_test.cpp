// SPDX-License-Identifier: Apache-2.0
// What the world did in the step in which an attempt ends belongs to the attempt.
#include <gtest/gtest.h>

#include "tests/assessment/task/monitor_bench.h"

namespace fulcrum {
namespace {

using monitor_bench::Bench;

/// The lift of B1 alone, with a hold of half a second and a time limit.
struct LiftBench : Bench {
    explicit LiftBench(double time_limit)
        : Bench("B1.json", [time_limit](Scene&, TaskDefinition& lift) {
              lift.goals.erase(lift.goals.begin());
              lift.goals[0].hold_s = 0.5;
              lift.time_limit_s = time_limit;
          }) {
        ticks(scene.ticks_per_step);
        for (Vector3& node : world.bowel.nodes) node.z() += task.goals[0].height_m + 0.005;
        grasp(Hand::right, 0.5 * (task.goals[0].from_m + task.goals[0].to_m));
        for (int step = 0; step < 200 && !monitor.display().ended; ++step) ticks(scene.ticks_per_step);
    }
};

TEST(LastStep, GoalThatItReachesCountsThoughTheTimeIsUpWithIt) {
    const LiftBench unlimited(60);
    ASSERT_EQ(unlimited.monitor.display().end, EventKind::completed);
    ASSERT_FALSE(unlimited.monitor.display().moving_seen) << "the clock counts from the beginning";
    const std::uint32_t tick = unlimited.events.first(EventKind::completed).tick;

    const LiftBench just((tick - 0.5) * 1e-3);
    EXPECT_EQ(just.monitor.display().end, EventKind::completed);
    EXPECT_EQ(just.events.count(EventKind::timed_out), 0);
    EXPECT_EQ(just.events.first(EventKind::completed).tick, tick);

    const LiftBench late((tick - 0.5 - just.scene.ticks_per_step) * 1e-3);
    EXPECT_EQ(late.monitor.display().end, EventKind::timed_out);
    EXPECT_EQ(late.events.count(EventKind::completed), 0);
    EXPECT_EQ(late.events.list.back().kind, EventKind::timed_out);
    EXPECT_EQ(late.events.list.back().tick, tick - static_cast<std::uint32_t>(late.scene.ticks_per_step));
}

TEST(LastStep, SlipInTheStepOfTheTimeLimitIsReported) {
    Bench bench("B1.json", [](Scene& scene, TaskDefinition& task) {
        task.time_limit_s = (100 * scene.ticks_per_step - 2.5) * 1e-3;
    });
    bench.grasp(Hand::right, 0.3, 12);
    bench.ticks(98 * bench.scene.ticks_per_step);
    ASSERT_FALSE(bench.monitor.display().ended);
    bench.let_go(Hand::right, true);
    EXPECT_EQ(bench.monitor.display().end, EventKind::timed_out);
    EXPECT_EQ(bench.events.count(EventKind::slip), 1);
    EXPECT_EQ(bench.events.list.back().kind, EventKind::timed_out);
    // Two ticks before the step's last.
    EXPECT_EQ(bench.events.list.back().tick,
              static_cast<std::uint32_t>(100 * bench.scene.ticks_per_step - 2));
}

TEST(LastStep, WhatItDidToTissueCountsThoughTheAttemptIsLeftInIt) {
    Bench bench("B1.json");
    bench.ticks(2 * bench.scene.ticks_per_step);
    bench.world.events.resize(1);
    bench.world.events[0].kind = EventKind::perforation;
    bench.world.event_count = 1;
    bench.sample.rig_flags = rig_abandon;
    bench.grasp(Hand::right, 0.3, 12);
    EXPECT_EQ(bench.monitor.display().end, EventKind::abandoned);
    EXPECT_EQ(bench.events.count(EventKind::perforation), 1);
    EXPECT_TRUE(bench.monitor.display().critical);
    EXPECT_EQ(bench.events.count(EventKind::grasp), 1);
    EXPECT_EQ(bench.events.list.back().kind, EventKind::abandoned);
}

TEST(LastStep, GoalThatItReachesDoesNotCountIfTheAttemptIsLeftInIt) {
    Bench bench("B1.json", [](Scene&, TaskDefinition& task) {
        task.goals.erase(task.goals.begin());
        task.goals[0].hold_s = 1e-3;
    });
    bench.ticks(bench.scene.ticks_per_step);
    for (Vector3& node : bench.world.bowel.nodes) node.z() += bench.task.goals[0].height_m + 0.005;
    GraspState& hold = bench.world.grasps[static_cast<int>(Hand::right)];
    hold.held = true;
    hold.arc_length = 0.5 * (bench.task.goals[0].from_m + bench.task.goals[0].to_m);
    bench.ticks(bench.scene.ticks_per_step - 1);  // would be enough for the hold
    bench.sample.rig_flags = rig_abandon;
    bench.tick();
    EXPECT_EQ(bench.monitor.display().end, EventKind::abandoned);
    EXPECT_EQ(bench.events.count(EventKind::completed), 0);
}

}  // namespace
}  // namespace fulcrum
