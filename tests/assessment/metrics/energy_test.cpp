// SPDX-License-Identifier: Apache-2.0
// Energy, heat and blood: closed forms, absence, evidence.
#include <gtest/gtest.h>

#include "assessment/metrics/statement_words.h"
#include "tests/assessment/metrics/traces.h"

namespace fulcrum {
namespace {

using test::make_event;
using test::make_trace;
using test::measure;

Event told(double t, EventKind kind, double value, int detail = 0, int hand = 255) {
    Event event = make_event(t, kind, hand, detail);
    event.value = static_cast<float>(value);
    return event;
}

void set_energy(Trace& trace, Hand hand, const std::function<bool(double)>& on) {
    HandTrace& h = trace.hand[static_cast<std::size_t>(hand)];
    h.energy.clear();
    for (const double t : trace.t) h.energy.push_back(on(t) ? 1 : 0);
}

const int all = detail_of(Activation{true, true, true});

TEST(EnergyTime, IsTheSumOfActivationsAtAnyRate) {
    for (const double rate : {1000.0, 200.0, 60.0}) {
        Trace trace = make_trace(12, rate);
        set_energy(trace, Hand::right, [](double t) {
            return (t >= 2 - 1e-9 && t < 4.5 - 1e-9) || (t >= 7 - 1e-9 && t < 8 - 1e-9);
        });
        const MetricResult result = measure(trace, "energy_time", "right");
        EXPECT_NEAR(*result.value, 3.5, 3.5e-9) << rate;
        EXPECT_EQ(result.count, 2);
        ASSERT_EQ(result.evidence.size(), 2U);
        EXPECT_NEAR(result.evidence[0].begin, 2.0, 1e-9);  // the longest first
        EXPECT_NEAR(result.evidence[0].end, 4.5, 1e-9);
    }
}

TEST(EnergyTime, LeavesPausesOutAndIsZeroWithoutAPedal) {
    Trace trace = make_trace(10);
    set_energy(trace, Hand::right, [](double t) { return t >= 2 && t < 6; });
    const std::vector<Event> events = {make_event(3, EventKind::pause), make_event(5, EventKind::resume)};
    split_blocks(trace, events);
    EXPECT_NEAR(*measure(trace, "energy_time", "right", events).value, 2.0, 0.003);
    set_energy(trace, Hand::right, [](double) { return false; });
    EXPECT_EQ(*measure(trace, "energy_time", "right", events).value, 0.0);
    const MetricResult missing = measure(trace, "energy_time", "left", events);
    EXPECT_FALSE(missing.value);
    EXPECT_EQ(missing.absence, Absence::not_measured);
    EXPECT_NE(words_of(missing.absent_because).find("left.energy"), std::string::npos);
}

TEST(EnergySafe, IsTheShareOfActivationsThatWereSafeThroughout) {
    const Trace trace = make_trace(30);
    std::vector<Event> events;
    const auto activation = [&](double t, int begin, int end, double distance) {
        events.push_back(told(t, EventKind::activation_begin, distance, begin, 1));
        events.push_back(told(t + 2, EventKind::activation_end, distance, end, 1));
    };
    activation(1, all, all, 0.02);
    activation(5, all, detail_of(Activation{true, true, false}),
               0.001);  // safe at first, near the nerve later
    activation(10, all, all, 0.003);
    activation(15, all, detail_of(Activation{false, true, true}), 0.02);
    const MetricResult result = measure(trace, "energy_safe", "", events);
    EXPECT_NEAR(*result.value, 50.0, 1e-12);
    EXPECT_EQ(result.count, 4);
    ASSERT_EQ(result.evidence.size(), 2U);
    EXPECT_NEAR(result.evidence[0].begin, 5.0, 1e-9);  // the nearest to the nerve first
    EXPECT_NEAR(result.evidence[0].end, 7.0, 1e-9);
}

TEST(EnergySafe, IsAbsentWithoutAnActivationAndWithoutEvents) {
    const Trace trace = make_trace(5);
    const MetricResult none = measure(trace, "energy_safe", "");
    EXPECT_FALSE(none.value);
    EXPECT_EQ(none.absence, Absence::not_done);
    MetricContext file;
    file.events_recorded = false;
    for (const char* id :
         {"energy_safe", "lateral_heat", "bleed_ml", "vessel_injury", "nerve_injury", "tear"}) {
        const MetricResult result = measure(trace, id, "", {}, file);
        EXPECT_FALSE(result.value) << id;
        EXPECT_EQ(result.absence, Absence::not_measured) << id;
    }
}

TEST(LateralHeat, IsTheLargestDoseTold) {
    const Trace trace = make_trace(20);
    EXPECT_EQ(*measure(trace, "lateral_heat", "").value, 0.0);
    const MetricResult result =
        measure(trace, "lateral_heat", "",
                {told(3, EventKind::heat_dose, 0.5), told(8, EventKind::heat_dose, 7.25),
                 told(9, EventKind::heat_dose, 7.5)});
    EXPECT_NEAR(*result.value, 7.5, 1e-6);
    ASSERT_EQ(result.evidence.size(), 3U);
    EXPECT_NEAR(result.evidence[0].end, 8.0, 1e-9);  // where it rose most
}

TEST(BleedMl, IsTheLastSumAndPointsAtTheWorstBleeding) {
    const Trace trace = make_trace(40);
    EXPECT_EQ(*measure(trace, "bleed_ml", "").value, 0.0);
    const std::vector<Event> events = {
        told(2, EventKind::bleed_begin, 12, 1), told(4, EventKind::blood_loss, 0.25),
        told(5, EventKind::bleed_end, 0.4, 1),  told(10, EventKind::bleed_begin, 20, 3),
        told(20, EventKind::blood_loss, 3.5),   told(21, EventKind::bleed_end, 3.75, 3),
        told(30, EventKind::bleed_begin, 5, 1), told(31, EventKind::bleed_end, 0.5, 1),
        told(32, EventKind::blood_loss, 4.25)};
    const MetricResult result = measure(trace, "bleed_ml", "", events);
    EXPECT_NEAR(*result.value, 4.25, 1e-6);
    ASSERT_EQ(result.evidence.size(), 3U);
    EXPECT_NEAR(result.evidence[0].begin, 10.0, 1e-9);
    EXPECT_NEAR(result.evidence[1].begin, 2.0, 1e-9);
    EXPECT_NEAR(result.evidence[2].begin, 30.0, 1e-9);
}

TEST(Injuries, AreCounted) {
    const Trace trace = make_trace(10);
    const std::vector<Event> events = {
        make_event(2, EventKind::vessel_injury, 255, 0), make_event(3, EventKind::vessel_injury, 255, 2),
        make_event(4, EventKind::nerve_injury), make_event(5, EventKind::tear)};
    EXPECT_EQ(*measure(trace, "vessel_injury", "", events).value, 2.0);
    EXPECT_EQ(*measure(trace, "nerve_injury", "", events).value, 1.0);
    EXPECT_EQ(*measure(trace, "tear", "", events).value, 1.0);
    EXPECT_EQ(*measure(trace, "vessel_injury", "").value, 0.0);
    EXPECT_EQ(measure(trace, "vessel_injury", "", events).evidence.size(), 2U);
}

}  // namespace
}  // namespace fulcrum
