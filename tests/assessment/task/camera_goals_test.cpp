// SPDX-License-Identifier: Apache-2.0
// Task A1: what counts as framed, in constructed steps.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "assessment/task/monitor.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/generated.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr double one_degree = 3.14159265358979323846 / 180;

/// A scope as the test holds it before cups in a row; only the monitor is real.
struct Booth : EventSink {
    TaskDefinition task = load_task(test::source_path("assets/tasks/A1.json"));
    Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    TaskMonitor monitor{task, scene, 1};
    WorldSnapshot world;
    std::vector<Event> events;
    std::uint32_t tick = 0;
    CameraPose camera;  // looks along -z of the camera, level: towards +y of the patient

    Booth() {
        camera.orientation = Quaternion(Eigen::AngleAxisd(90 * one_degree, Vector3::UnitX()));
        world.camera_targets.ball_radius = 0.004;
        world.camera_targets.cup_radius = 0.0065;
        world.camera_targets.cup_depth = 0.009;
        world.camera_targets.distance = 0.045;
        for (int i = 0; i < 12; ++i) {
            CameraTarget target;
            target.ball = Vector3(0.03 * i, 0.1, 0);
            target.axis = -Vector3::UnitY();
            target.mouth = target.ball + world.camera_targets.cup_depth * target.axis;
            world.camera_targets.targets.push_back(target);
        }
        world.camera_targets.tip = Vector3(-0.05, 0.1, 0.02);
    }
    void on_event(const Event& event) noexcept override { events.push_back(event); }
    /// Looks at a point from `distance`, turned aside, then about the line of sight.
    void look(const Vector3& point, double distance = 0.045, double aside = 0, double tilt = 0) {
        camera.position = point - distance * Vector3::UnitY();
        camera.orientation = Quaternion(Eigen::AngleAxisd(aside, Vector3::UnitZ()) *
                                        Eigen::AngleAxisd(90 * one_degree, Vector3::UnitX()) *
                                        Eigen::AngleAxisd(tilt, Vector3::UnitZ()));
    }
    void hold(double seconds) {
        const int steps = static_cast<int>(std::lround(seconds * 200));
        for (int i = 0; i < steps; ++i) {
            std::vector<TickSample> ticks(5);
            for (TickSample& sample : ticks) {
                sample.tick = ++tick;
                for (int k = 0; k < 3; ++k)
                    sample.camera.tip[k] = static_cast<std::int32_t>(std::lround(camera.position[k] * 1e7));
                const double parts[4] = {camera.orientation.w(), camera.orientation.x(),
                                         camera.orientation.y(), camera.orientation.z()};
                for (int k = 0; k < 4; ++k)
                    sample.camera.orientation[k] = static_cast<std::int32_t>(std::lround(parts[k] * 1e8));
            }
            monitor.on_step(ticks.data(), ticks.size(), world, *this);
        }
    }
    const Vector3& ball(std::size_t i) const { return world.camera_targets.targets[i].ball; }
    int count(EventKind kind) const {
        int found = 0;
        for (const Event& event : events) found += event.kind == kind ? 1 : 0;
        return found;
    }
    const Event& last(EventKind kind) const {
        for (std::size_t i = events.size(); i-- > 0;)
            if (events[i].kind == kind) return events[i];
        static const Event none;
        return none;
    }
    unsigned faults() const { return monitor.display().framing_faults; }
    void frame_all() {
        for (std::size_t i = 0; i < 12; ++i) {
            look(ball(i));
            hold(1.1);
        }
    }
};

TEST(CameraGoals, TargetIsReachedOnceFramedForItsTime) {
    Booth booth;
    booth.look(booth.ball(0));
    booth.hold(0.9);
    EXPECT_EQ(booth.count(EventKind::target_reached), 0);
    EXPECT_NEAR(booth.monitor.display().hold_progress, 0.9, 1e-9);
    booth.hold(0.2);
    EXPECT_EQ(booth.count(EventKind::target_reached), 1);
    EXPECT_EQ(booth.last(EventKind::target_shown).detail, 1);
    EXPECT_EQ(booth.monitor.display().active_target, 1);
    EXPECT_NEAR(booth.monitor.display().goal_progress, 1.0 / 12, 1e-12);
}

TEST(CameraGoals, WhateverIsWrongIsNamedAndNothingCounts) {
    Booth booth;
    const struct {
        double distance, aside, tilt;
        unsigned fault;
    } cases[] = {{0.045, 8.3 * one_degree, 0, framing_off_centre},
                 {0.045, 0, 10.3 * one_degree, framing_tilted},
                 {0.045, 0, -10.3 * one_degree, framing_tilted},
                 {0.0566, 0, 0, framing_too_far},
                 {0.0373, 0, 0, framing_too_near}};
    for (const auto& one : cases) {
        booth.look(booth.ball(0), one.distance, one.aside, one.tilt);
        booth.hold(1.5);
        EXPECT_EQ(booth.faults(), one.fault) << one.distance << ", " << one.aside << ", " << one.tilt;
        EXPECT_EQ(booth.monitor.display().hold_progress, 0);
    }
    EXPECT_EQ(booth.count(EventKind::target_reached), 0);
    // Just within each limit it counts.
    booth.look(booth.ball(0), 0.0560, 7.7 * one_degree, 9.7 * one_degree);
    booth.hold(1.1);
    EXPECT_EQ(booth.count(EventKind::target_reached), 1);
}

TEST(CameraGoals, BallBehindItsCupIsHidden) {
    Booth booth;
    for (CameraTarget& target : booth.world.camera_targets.targets) {
        target.axis = Vector3::UnitX();
        target.mouth = target.ball + booth.world.camera_targets.cup_depth * target.axis;
    }
    booth.look(booth.ball(0));
    booth.hold(1.5);
    EXPECT_EQ(booth.faults(), static_cast<unsigned>(framing_hidden));
    EXPECT_EQ(booth.count(EventKind::target_reached), 0);
}

TEST(CameraGoals, HoldThatIsBrokenBeginsAgain) {
    Booth booth;
    booth.look(booth.ball(0));
    booth.hold(0.9);
    booth.look(booth.ball(0), 0.045, 12 * one_degree);
    booth.hold(0.01);
    booth.look(booth.ball(0));
    booth.hold(0.9);
    EXPECT_EQ(booth.count(EventKind::target_reached), 0);
}

TEST(CameraGoals, TimeWithTheTipIsAddedUpAndEachLossIsReported) {
    Booth booth;
    booth.frame_all();
    EXPECT_EQ(booth.monitor.display().goal, 1);
    EXPECT_EQ(booth.last(EventKind::target_shown).detail, 12);
    const Vector3 tip = booth.world.camera_targets.tip;
    booth.look(tip, 0.045, 20 * one_degree);
    booth.hold(2);
    EXPECT_EQ(booth.count(EventKind::target_lost), 0);
    booth.look(tip);
    booth.hold(12);
    ASSERT_EQ(booth.count(EventKind::target_lost), 1);
    // 2 s of looking away, and what was left of the hold of the last ball.
    EXPECT_NEAR(booth.last(EventKind::target_lost).value, 2.1, 0.01);
    EXPECT_NEAR(booth.monitor.display().goal_progress, 12.0 / 20, 1e-3);
    booth.look(tip, 0.045, 20 * one_degree);
    booth.hold(3);
    EXPECT_NEAR(booth.monitor.display().goal_progress, 12.0 / 20, 1e-3);
    booth.look(tip);
    booth.hold(7.9);
    EXPECT_EQ(booth.count(EventKind::completed), 0);
    EXPECT_NEAR(booth.last(EventKind::target_lost).value, 3.0, 0.01);
    booth.hold(0.2);
    EXPECT_EQ(booth.count(EventKind::completed), 1);
    EXPECT_EQ(booth.last(EventKind::goal_progress).value, 20);
}

TEST(CameraGoals, ATipThatIsFramedAtOnceIsReportedAsLostForNoTime) {
    Booth booth;
    booth.world.camera_targets.tip = booth.ball(11);
    booth.frame_all();
    booth.hold(1);
    ASSERT_EQ(booth.count(EventKind::target_lost), 1);
    EXPECT_EQ(booth.last(EventKind::target_lost).value, 0);
}

TEST(CameraGoals, ClockStartsWithTheMovementOfTheScope) {
    Booth booth;
    booth.look(booth.ball(0), 0.08);
    booth.hold(2);
    EXPECT_FALSE(booth.monitor.display().moving_seen);
    for (int i = 0; i < 100; ++i) {  // 4 mm/s: too slow to be a movement
        booth.camera.position.y() += 0.02e-3;
        booth.hold(0.005);
    }
    EXPECT_FALSE(booth.monitor.display().moving_seen);
    for (int i = 0; i < 60; ++i) {
        booth.camera.position.y() += 0.05e-3;
        booth.hold(0.005);
    }
    ASSERT_TRUE(booth.monitor.display().moving_seen);
    EXPECT_EQ(booth.last(EventKind::first_movement).hand, 255);
    EXPECT_NEAR(booth.last(EventKind::first_movement).tick * 1e-3, 2.5, 0.03);
    EXPECT_NEAR(booth.monitor.display().elapsed_s, 0.3, 0.03);
}

TEST(CameraGoals, CreepingToATargetStartsTheTimerWhenItIsFramed) {
    Booth booth;
    booth.look(booth.ball(0));
    booth.hold(0.1);
    EXPECT_TRUE(booth.monitor.display().moving_seen);
}

TEST(CameraGoals, TasksThatCannotBeAreRefused) {
    const std::string whole = test::text_of("assets/tasks/A1.json");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = whole;
        text.replace(text.find(from), from.size(), to);
        return text;
    };
    EXPECT_THROW(parse_task(with("\"size_share\": 0.2", "\"size_share\": 1"), "A1.json"), InputError);
    EXPECT_THROW(parse_task(with("\"centre_deg\": 8,", ""), "A1.json"), InputError);
    const Scene scene = load_scene(test::source_path("assets/scenes/a1_camera.json"));
    TaskDefinition task = parse_task(with("\"count\": 12", "\"count\": 13"), "A1.json");
    EXPECT_THROW(TaskMonitor(task, scene, 1), InputError);
    task = load_task(test::source_path("assets/tasks/A1.json"));
    EXPECT_THROW(TaskMonitor(task, load_scene(test::source_path("assets/scenes/a2_targets.json")), 1),
                 InputError);
}

}  // namespace
}  // namespace fulcrum
