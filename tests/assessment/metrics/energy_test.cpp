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

TEST(EnergySafe, WeighsOnTimeAndCountsAPumpedPedalAsOneActivation) {
    const Trace trace = make_trace(20);
    const int safe = detail_of(Activation{true, true, true}),
              unsafe = detail_of(Activation{false, true, true});
    const auto activation = [&](std::vector<Event>& events, double begin, double end, int detail) {
        events.push_back(told(begin, EventKind::activation_begin, 0.02, detail, 1));
        events.push_back(told(end, EventKind::activation_end, 0.02, detail, 1));
    };
    // 6 s held out of view, 2 s held in view: a quarter was safe.
    std::vector<Event> held;
    activation(held, 1, 7, unsafe);
    activation(held, 9, 11, safe);
    EXPECT_NEAR(*measure(trace, "energy_safe", "", held).value, 25.0, 1e-9);

    // The same seconds pumped in 80 ms: out of view for one pulse in each.
    std::vector<Event> pumped;
    for (int pulse = 0; pulse < 38; ++pulse)
        activation(pumped, 1 + 0.16 * pulse, 1.08 + 0.16 * pulse, pulse % 12 == 5 ? unsafe : safe);
    activation(pumped, 9, 11, safe);
    const MetricResult result = measure(trace, "energy_safe", "", pumped);
    EXPECT_NEAR(*result.value, 100 * 2 / (2 + 38 * 0.08), 1e-6);
    EXPECT_EQ(result.count, 2);
    ASSERT_EQ(result.evidence.size(), 1U);
    EXPECT_NEAR(result.evidence[0].begin, 1, 1e-6);

    // Half a second apart they are two; the other hand's is never the same.
    std::vector<Event> apart;
    activation(apart, 1, 2, unsafe);
    activation(apart, 2.501, 3.501, safe);
    EXPECT_NEAR(*measure(trace, "energy_safe", "", apart).value, 50.0, 1e-6);
    apart[2].hand = apart[3].hand = 0;
    apart[2].tick = 2100;
    EXPECT_EQ(measure(trace, "energy_safe", "", apart).count, 2);
}

// The activation lasts through the pause, as its pedal does.
TEST(EnergySafe, APauseWithThePedalDownIsNotTimeWithEnergyOn) {
    Trace trace = make_trace(70, 100);
    const int safe = detail_of(Activation{true, true, true}),
              unsafe = detail_of(Activation{false, true, true});
    const std::vector<Event> events = {told(1, EventKind::activation_begin, 0.02, unsafe, 1),
                                       told(3, EventKind::activation_end, 0.02, unsafe, 1),
                                       told(5, EventKind::activation_begin, 0.02, safe, 1),
                                       make_event(6, EventKind::pause),
                                       make_event(64, EventKind::resume),
                                       told(65, EventKind::activation_end, 0.02, safe, 1)};
    split_blocks(trace, events);
    const MetricResult result = measure(trace, "energy_safe", "", events);
    ASSERT_TRUE(result.value);
    EXPECT_NEAR(*result.value, 50.0, 1e-9) << "2 s of each, and a pause of 58 s";
    EXPECT_EQ(result.count, 2);
}

// The pedal was up for 0.3 s of the attempt, whatever the clock on the wall says.
TEST(EnergySafe, APauseBetweenPulsesDoesNotMakeThemTwoActivations) {
    Trace trace = make_trace(70, 100);
    const int safe = detail_of(Activation{true, true, true}),
              unsafe = detail_of(Activation{false, true, true});
    const auto pulses = [&](double second) {
        return std::vector<Event>{told(1, EventKind::activation_begin, 0.02, unsafe, 1),
                                  told(3, EventKind::activation_end, 0.02, unsafe, 1),
                                  make_event(3.1, EventKind::pause),
                                  make_event(60, EventKind::resume),
                                  told(second, EventKind::activation_begin, 0.02, safe, 1),
                                  told(second + 2, EventKind::activation_end, 0.02, safe, 1)};
    };
    const std::vector<Event> pumped = pulses(60.2), released = pulses(61);
    split_blocks(trace, pumped);
    const MetricResult one = measure(trace, "energy_safe", "", pumped);
    ASSERT_TRUE(one.value);
    EXPECT_EQ(one.count, 1);
    EXPECT_NEAR(*one.value, 0, 1e-9) << "a part of it was out of view";
    const MetricResult two = measure(trace, "energy_safe", "", released);
    ASSERT_TRUE(two.value);
    EXPECT_EQ(two.count, 2) << "up for 1.1 s of the attempt";
    EXPECT_NEAR(*two.value, 50, 1e-9);
}

TEST(EnergyCut, APauseWithinAnElementOfTheCutIsNotTimeWithEnergyOn) {
    Trace trace = make_trace(70, 100);
    // 10 mm in 2 s of the attempt, in the first of which energy is on, and a pause with the pedal down.
    const std::vector<Event> events = {told(1, EventKind::cut_begin, 0, 0, 1),
                                       told(1, EventKind::activation_begin, 0.02, 7, 1),
                                       make_event(1.5, EventKind::pause),
                                       make_event(60.5, EventKind::resume),
                                       told(61, EventKind::activation_end, 0.02, 7, 1),
                                       told(62, EventKind::cut_advance, 0.010, 0, 1),
                                       told(62, EventKind::cut_end, 0.010, 0, 1)};
    split_blocks(trace, events);
    const MetricResult result = measure(trace, "energy_cut", "", events);
    ASSERT_TRUE(result.value);
    EXPECT_NEAR(*result.value, 50, 1e-4);
}

TEST(EnergyCut, IsTheShareOfTheLengthDividedWithEnergyOn) {
    const Trace trace = make_trace(20);
    const auto at = [&](double t, EventKind kind, double along) { return told(t, kind, along, 0, 1); };
    const std::vector<Event> events = {at(1, EventKind::cut_begin, 0),
                                       told(2, EventKind::activation_begin, 0.02, 7, 1),
                                       at(3, EventKind::cut_advance, 0.010),
                                       told(3, EventKind::activation_end, 0.02, 7, 1),
                                       at(4, EventKind::cut_advance, 0.020),
                                       at(4, EventKind::cut_end, 0.020),
                                       told(8, EventKind::fibres_parted, 0.020, 0),
                                       told(9, EventKind::cut_advance, 0.025, 0)};
    // Of 10 mm half under power, 10 mm cold, 5 mm torn.
    const MetricResult result = measure(trace, "energy_cut", "", events);
    EXPECT_NEAR(*result.value, 100 * 5.0 / 25.0, 1e-4);
    ASSERT_EQ(result.evidence.size(), 2U);
    EXPECT_NEAR(result.evidence[0].begin, 1, 1e-9);  // the longest cold stroke first
    EXPECT_EQ(measure(trace, "energy_cut", "").absence, Absence::not_done);
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

TEST(LateralHeat, IsTheAreaThatReceivedALethalDose) {
    const Trace trace = make_trace(20);
    EXPECT_EQ(*measure(trace, "lateral_heat", "").value, 0.0);
    const MetricResult result =
        measure(trace, "lateral_heat", "",
                {told(3, EventKind::heat_area, 0.5), told(8, EventKind::heat_area, 7.25),
                 told(9, EventKind::heat_area, 7.5)});
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
