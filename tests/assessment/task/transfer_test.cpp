// SPDX-License-Identifier: Apache-2.0
// Task A3: which rings count, in constructed steps.
#include <gtest/gtest.h>

#include <vector>

#include "assessment/task/monitor.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr int left = 0, right = 1;
constexpr double high = 0.03, on_tray = 0;  // m, of a ring above the tray

/// Rings and hands as the test puts them; only the monitor is real.
struct Table : EventSink {
    TaskDefinition task = load_task(test::source_path("assets/tasks/A3.json"));
    Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    TaskMonitor monitor{task, scene, 1};
    WorldSnapshot world;
    std::vector<Event> events;
    std::uint32_t tick = 0;

    Table() {
        world.objects.objects.resize(6);
        for (int i = 0; i < 12; ++i) {
            PegView peg;
            peg.side = i < 6 ? Hand::left : Hand::right;
            world.objects.pegs.push_back(peg);
        }
        for (int i = 0; i < 6; ++i) ring(i).peg = i;
        steps(1);
    }
    void on_event(const Event& event) noexcept override { events.push_back(event); }
    ObjectView& ring(int i) { return world.objects.objects[static_cast<std::size_t>(i)]; }
    void hold(int hand, int ring) {
        GraspState& grasp = world.grasps[hand];
        grasp.held = ring >= 0;
        if (ring < 0) return;
        grasp.body = HeldBody::object;
        grasp.patch = ring;
    }
    /// Steps of 5 ms.
    void steps(int count) {
        for (int i = 0; i < count; ++i) {
            std::vector<TickSample> ticks(5);
            for (TickSample& sample : ticks) {
                sample.tick = ++tick;
                for (HandSample& hand : sample.hand) hand.flags = hand_inside;
            }
            monitor.on_step(ticks.data(), ticks.size(), world, *this);
        }
    }
    void lift(int hand, int i) {
        hold(hand, i);
        ring(i).height = on_tray;
        steps(2);
        ring(i).height = high;
        ring(i).peg = -1;
        steps(2);
    }
    void put(int hand, int i, int peg) {
        ring(i).height = on_tray;
        ring(i).peg = peg;
        steps(2);
        hold(hand, -1);
        steps(100);
    }
    /// As the task asks: both hold it in the air for `both` steps.
    void transfer(int from, int to, int i, int peg, int both = 60) {
        lift(from, i);
        hold(to, i);
        steps(both);
        hold(from, -1);
        steps(2);
        put(to, i, peg);
    }
    unsigned counted() const { return monitor.display().rings_placed; }
    int goal() const { return monitor.display().goal; }
};

TEST(Transfer, CountsARingHandedOverInTheAirAndPutAroundAPeg) {
    Table table;
    table.transfer(left, right, 2, 8);
    EXPECT_EQ(table.counted(), 1U << 2);
    EXPECT_NEAR(table.monitor.display().goal_progress, 1.0 / 6, 1e-12);
}

TEST(Transfer, DoesNotCountWhatOneHandCarriedOver) {
    Table table;
    table.lift(left, 2);
    table.put(left, 2, 8);
    EXPECT_EQ(table.counted(), 0U);
    // Nor what the other hand lifted and placed by itself.
    table.lift(right, 3);
    table.put(right, 3, 9);
    EXPECT_EQ(table.counted(), 0U);
}

TEST(Transfer, DoesNotCountAHandoverOnTheTrayOrOneThatWasThrown) {
    Table table;
    table.hold(left, 0);
    table.hold(right, 0);
    table.steps(100);
    table.hold(left, -1);
    table.steps(2);
    table.ring(0).height = high;
    table.ring(0).peg = -1;
    table.steps(10);
    table.put(right, 0, 6);
    EXPECT_EQ(table.counted(), 0U);
    // Let go by one before the other has it.
    table.lift(left, 1);
    table.hold(left, -1);
    table.steps(1);
    table.hold(right, 1);
    table.steps(60);
    table.put(right, 1, 7);
    EXPECT_EQ(table.counted(), 0U);
}

TEST(Transfer, DoesNotCountAHandoverShorterThanTheTaskAsks) {
    Table table;
    table.transfer(left, right, 2, 8, 20);  // 0.1 s of 0.2 s
    EXPECT_EQ(table.counted(), 0U);
    // It is brought back and handed over again.
    table.transfer(left, right, 2, 8);
    EXPECT_EQ(table.counted(), 1U << 2);
}

TEST(Transfer, NeedsAPegOfTheOtherSideForEachRing) {
    Table table;
    table.transfer(left, right, 2, 2);
    EXPECT_EQ(table.counted(), 0U) << "put back on the side that it came from";
    table.transfer(left, right, 2, -1);
    EXPECT_EQ(table.counted(), 0U) << "around no peg";
    table.transfer(left, right, 2, 8);
    table.transfer(left, right, 3, 8);
    EXPECT_EQ(table.counted(), 1U << 2) << "two rings around one peg";
}

TEST(Transfer, TakesBackARingThatIsKnockedOffOrTakenAway) {
    Table table;
    table.transfer(left, right, 2, 8);
    table.transfer(left, right, 3, 9);
    ASSERT_EQ(table.counted(), 0b1100U);
    table.ring(2).peg = -1;  // knocked off; back around the peg it does not count
    table.steps(10);
    table.ring(2).peg = 8;
    table.steps(200);
    EXPECT_EQ(table.counted(), 0b1000U);
    table.lift(left, 3);
    EXPECT_EQ(table.counted(), 0U);
}

TEST(Transfer, ARingThatFallsAfterTheHandoverHasToBeHandedOverAgain) {
    Table table;
    table.lift(left, 2);
    table.hold(right, 2);
    table.steps(60);
    table.hold(left, -1);
    table.steps(10);
    table.hold(right, -1);
    table.ring(2).height = on_tray;
    table.steps(100);
    table.lift(right, 2);
    table.put(right, 2, 8);
    EXPECT_EQ(table.counted(), 0U);
}

TEST(Transfer, GoesBothWaysAndEndsTheAttempt) {
    Table table;
    for (int i = 0; i < 6; ++i) {
        EXPECT_EQ(table.goal(), 0);
        table.transfer(left, right, i, 6 + i);
    }
    EXPECT_EQ(table.goal(), 1);
    EXPECT_EQ(table.counted(), 0U) << "the way back starts at none";
    for (int i = 0; i < 6; ++i) {
        EXPECT_FALSE(table.monitor.display().ended);
        table.transfer(right, left, i, i);
    }
    EXPECT_TRUE(table.monitor.display().ended);
    EXPECT_EQ(table.monitor.display().end, EventKind::completed);
}

TEST(Transfer, AGoalThatTheSceneCannotMeetIsRefused) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A3.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    const auto refusal = [](const TaskDefinition& of, const Scene& in) {
        try {
            TaskMonitor(of, in, 1);
        } catch (const InputError& error) {
            EXPECT_FALSE(error.hint().empty());
            return error.place() + " " + error.problem();
        }
        return std::string();
    };
    EXPECT_EQ(refusal(task, scene), "");
    TaskDefinition more = task;
    more.goals[1].count = 7;
    EXPECT_EQ(refusal(more, scene), "/goals/1/count the goal asks for more rings than the scene has");
    Scene probe = scene;
    probe.instruments[1].kind = InstrumentKind::probe;
    EXPECT_NE(refusal(task, probe).find("the right hand cannot grasp a ring"), std::string::npos);
    Scene none = scene;
    none.objects.reset();
    EXPECT_NE(refusal(task, none).find("no objects to hand over"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum
