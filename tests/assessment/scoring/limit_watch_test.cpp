// SPDX-License-Identifier: Apache-2.0
// How soon what fails an attempt has to be in the store, and that nothing else asks for it.
#include "assessment/scoring/limit_watch.h"

#include <gtest/gtest.h>

#include "assessment/scoring/gate_rules.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr std::uint32_t just_written = 0, fifth_of_a_second = 200;

/// The watch of a delivered task, fed tick by tick.
class LimitWatched {
  public:
    explicit LimitWatched(const std::string& id)
        : task_(load_task(test::source_path("assets/tasks/" + id + ".json"))),
          scene_(load_scene(test::source_path("assets/scenes/" + task_.scene))),
          set_(load_benchmark(test::source_path("assets/benchmarks/" + id + ".json"))),
          watch(task_, scene_, judged_limits(task_, &set_)) {}
    void push(double newton, int ticks = 1) {
        for (int i = 0; i < ticks; ++i) watch.see(sample(newton, 0));
    }
    void grasp(double newton, int ticks = 1) {
        for (int i = 0; i < ticks; ++i) watch.see(sample(0, newton));
    }
    void happens(EventKind kind, double value = 0, int hand = 0) {
        Event event;
        event.tick = tick_;
        event.kind = kind;
        event.hand = static_cast<std::uint8_t>(hand);
        event.value = static_cast<float>(value);
        watch.see(event);
    }
    bool asks_at_once() const { return watch.due(just_written); }
    bool asks() const { return watch.due(fifth_of_a_second); }

  private:
    TickSample sample(double tip, double jaws) {
        TickSample sample;
        sample.tick = ++tick_;
        HandSample& hand = sample.hand[static_cast<int>(Hand::right)];
        hand.tissue = 0;
        hand.force[1] = static_cast<std::int32_t>(-tip / sample_force_unit);
        hand.jaw_force = static_cast<std::int32_t>(jaws / sample_force_unit);
        hand.jaw_area = 100'000;  // 1 cm2
        return sample;
    }
    TaskDefinition task_;
    Scene scene_;
    BenchmarkSet set_;
    std::uint32_t tick_ = 0;

  public:
    LimitWatch watch;
};

TEST(LimitWatch, AsksAtOnceWhenALimitIsExceededAndWhenItStaysBroken) {
    LimitWatched a2("A2");  // 4 N
    a2.push(3.9, 1000);
    EXPECT_FALSE(a2.asks());
    a2.push(5);
    EXPECT_TRUE(a2.asks_at_once());
    a2.watch.written();
    a2.push(5, 10);
    EXPECT_FALSE(a2.asks_at_once()) << "ten ticks more";
    EXPECT_TRUE(a2.asks());
    a2.push(5, 15);
    EXPECT_TRUE(a2.asks_at_once()) << "the low-pass of the metric has followed";
    a2.watch.written();
    a2.push(9, 1000);
    EXPECT_FALSE(a2.asks()) << "it is failed, and that is stored";
}

TEST(LimitWatch, BouncesAtALimitAskFiveTimesASecondAtMost) {
    LimitWatched a2("A2");
    int writes = 0;
    std::uint32_t since = 0;
    for (int bounce = 0; bounce < 500; ++bounce) {  // 10 s
        a2.push(4.5, 10);
        a2.push(3, 10);
        since += 20;
        if (!a2.watch.due(since)) continue;
        a2.watch.written();
        since = 0;
        ++writes;
    }
    EXPECT_GE(writes, 45);
    EXPECT_LE(writes, 51);
}

TEST(LimitWatch, KnowsTheLimitsOfJaws) {
    LimitWatched c4("C4");  // 10 N between the jaws of the left hand alone
    c4.grasp(50, 100);
    EXPECT_FALSE(c4.asks()) << "the other hand";
    LimitWatched b1("B1");  // 330 kPa, 300 N s
    b1.grasp(32.9, 8000);
    EXPECT_FALSE(b1.asks());
    b1.grasp(33.1);
    EXPECT_TRUE(b1.asks_at_once()) << "pressure";
    b1.watch.written();
    b1.grasp(0);
    b1.grasp(30, 9900);
    EXPECT_FALSE(b1.asks()) << "a grasp counts by itself: 297 N s";
    b1.grasp(30, 200);
    EXPECT_TRUE(b1.asks_at_once()) << "force over time";
}

TEST(LimitWatch, CriticalErrorsAndEventsThatCountAskAtOnce) {
    LimitWatched b1("B1");
    b1.happens(EventKind::perforation);
    EXPECT_TRUE(b1.asks_at_once());
    b1.watch.written();
    b1.happens(EventKind::drop);
    EXPECT_TRUE(b1.asks_at_once()) << "one is allowed, the next one fails";
    b1.watch.written();
    b1.happens(EventKind::drop);
    EXPECT_TRUE(b1.asks_at_once());
    b1.watch.written();
    b1.happens(EventKind::drop);
    EXPECT_FALSE(b1.asks_at_once()) << "failed already";
    b1.watch.written();
    b1.happens(EventKind::device_lost);
    EXPECT_TRUE(b1.asks_at_once());

    LimitWatched b3("B3");
    b3.happens(EventKind::heat_area, 0);
    EXPECT_FALSE(b3.asks());
    b3.happens(EventKind::heat_area, 0.5);
    EXPECT_TRUE(b3.asks_at_once()) << "no such tissue may be heated";
}

TEST(LimitWatch, WhatFailsNobodyByItselfWaits) {
    LimitWatched a2("A2");
    a2.happens(EventKind::over_force_begin, 1.6);
    EXPECT_FALSE(a2.asks_at_once());
    EXPECT_TRUE(a2.asks());
    a2.watch.written();
    a2.happens(EventKind::target_reached);
    a2.happens(EventKind::goal_progress);
    EXPECT_FALSE(a2.asks());
}

// Every gate of a delivered task that a part of an attempt can break for good is known, or named here.
TEST(LimitWatch, KnowsEveryGateThatStaysBroken) {
    for (const std::string& id : test::task_ids()) {
        const TaskDefinition task = load_task(test::source_path("assets/tasks/" + id + ".json"));
        const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
        for (const GateSpec& gate : task.gates) {
            JudgedLimit limit;
            limit.metric = gate.metric;
            limit.hand = gate.hand;
            limit.limit = 0;
            LimitWatch watch(TaskDefinition{}, scene, {limit});
            TickSample sample;
            for (HandSample& hand : sample.hand) {
                hand.tissue = 0;
                hand.force[0] = hand.jaw_force = hand.jaw_area = 1000;
            }
            for (int i = 0; i < 100; ++i) watch.see(sample);
            for (const char* name : {"perforation", "tear", "drop", "vessel_injury", "nerve_injury",
                                     "lens_contact", "tool_collision", "heat_area", "blood_loss"})
                for (int kind = 0; kind < 64; ++kind)
                    if (std::string(event_name(static_cast<EventKind>(kind))) == name) {
                        Event event;
                        event.kind = static_cast<EventKind>(kind);
                        event.hand = gate.hand == "right" ? 1 : 0;
                        event.value = 1;
                        watch.see(event);
                    }
            // Sums over the whole attempt and the specimen at its end: in the store with the next ordinary
            // write.
            const bool slow = gate.metric == "time" || gate.metric == "path_len" ||
                              gate.metric == "cut_dev" || gate.metric == "tip_lost" ||
                              gate.metric == "scope_path" || gate.metric == "crm_mm";
            const bool late = slow || !stays_broken(gate.metric);
            EXPECT_EQ(watch.due(just_written), !late) << id << ' ' << gate.metric;
        }
    }
}

}  // namespace
}  // namespace fulcrum
