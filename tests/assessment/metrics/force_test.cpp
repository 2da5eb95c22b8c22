// SPDX-License-Identifier: Apache-2.0
// Force, grasp and event metrics through the whole pipeline.
#include <gtest/gtest.h>

#include <cmath>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/statement_words.h"
#include "tests/assessment/metrics/traces.h"

namespace fulcrum {
namespace {

using test::make_event;
using test::make_trace;
using test::measure;
using test::pi;
using test::set_force;
using test::set_tissue;

MetricContext bowel_limit(double force) {
    MetricContext context;
    context.tissues = {{"bowel", force}};
    return context;
}

/// 3 N half-sine of 2 s from t = 1 s, on bowel while it lasts.
Trace half_sine() {
    Trace trace = make_trace(4.0);
    trace.tissues = {"bowel"};
    set_force(trace, Hand::left, [](double t) {
        return Vector3(t > 1 && t < 3 ? 3.0 * std::sin(pi * (t - 1) / 2) : 0.0, 0, 0);
    });
    set_tissue(trace, Hand::left, [](double t) { return t > 1 && t < 3 ? 0 : -1; });
    return trace;
}

TEST(Force, OfAHalfSine) {
    const Trace trace = half_sine();
    EXPECT_NEAR(*measure(trace, "f_max", "left").value, 3.0, 0.003);
    EXPECT_NEAR(*measure(trace, "impulse", "left").value, 3.81972, 0.0038);
    EXPECT_NEAR(*measure(trace, "impulse", "left", {}, {}, "bowel").value, 3.81972, 0.0038);
    // Above 0.1 N from 1 + asin(1/30) * 2/pi on.
    const double cut = std::asin(1.0 / 30.0) * 2 / pi;
    const double mean = 3.0 * (4 / pi) * std::cos(pi * cut / 2) / (2 - 2 * cut);
    EXPECT_NEAR(*measure(trace, "f_mean_nz", "left").value, mean, 0.002 * mean);
    EXPECT_NEAR(*measure(trace, "f_sd", "left").value, 3.0 * std::sqrt(0.5 - 4 / (pi * pi)), 0.003);
}

TEST(Force, SteepestChangeOfARaisedCosine) {
    Trace trace = make_trace(4.0);
    set_force(trace, Hand::left, [](double t) { return Vector3(0, 0, 2.0 - 1.5 * std::cos(2 * pi * t)); });
    EXPECT_NEAR(*measure(trace, "dfdt_max", "left").value, 3.0 * pi, 0.01);
}

TEST(Force, ASpikeOfOneSampleChangesNothing) {
    Trace trace = half_sine();
    const double most = *measure(trace, "f_max", "left").value;
    const double steepest = *measure(trace, "dfdt_max", "left").value;
    trace.hand[0].fx[2000] += 20.0;
    EXPECT_EQ(replaced_force_samples(trace), 1U);
    EXPECT_NEAR(*measure(trace, "f_max", "left").value, most, 1e-3);
    EXPECT_NEAR(*measure(trace, "dfdt_max", "left").value, steepest, 0.05);
    // 20 N for 20 ms are a force, not a spike.
    for (std::size_t i = 2010; i < 2030; ++i) trace.hand[0].fx[i] += 20.0;
    EXPECT_EQ(replaced_force_samples(trace), 1U);
    EXPECT_GT(*measure(trace, "f_max", "left").value, 15.0);
}

TEST(Force, SteepestChangeNeedsFiveHundredSamplesASecond) {
    for (const double rate : {500.0, 400.0}) {
        Trace trace = make_trace(4.0, rate);
        set_force(trace, Hand::left,
                  [](double t) { return Vector3(0, 0, 2.0 - 1.5 * std::cos(2 * pi * t)); });
        const MetricResult result = measure(trace, "dfdt_max", "left");
        EXPECT_EQ(result.value.has_value(), rate >= 500.0);
        if (!result.value) {
            EXPECT_EQ(result.absent_because.id(), StatementId::low_rate);
        }
    }
}

TEST(Force, OfTheJawsIsNotCarriedFromOneTissueToTheNext) {
    // At 100 Hz: 8 N on the vessel's label, 0.2 N on the bowel's from the next sample on.
    Trace trace = make_trace(4.0, 100.0);
    trace.tissues = {"vessel", "bowel"};
    for (const double t : trace.t) {
        trace.hand[0].jaw_force.push_back(t < 2 ? 8.0 : 0.2);
        trace.hand[0].tissue.push_back(t < 2 ? 0 : 1);
    }
    const UniformGrid grid(trace.t, trace.blocks.at(0));
    const std::vector<double> within = grid.interpolate_within(trace.hand[0].jaw_force, trace.hand[0].tissue);
    EXPECT_EQ(within[1999], 8.0);
    EXPECT_EQ(within[2000], 0.2);
    EXPECT_NEAR(grid.interpolate(trace.hand[0].jaw_force)[1995], 4.1, 1e-9);
}

TEST(Force, EvidencePointsAtTheMoment) {
    const MetricResult result = measure(half_sine(), "f_max", "left");
    ASSERT_EQ(result.evidence.size(), 1U);
    EXPECT_NEAR(0.5 * (result.evidence[0].begin + result.evidence[0].end), 2.0, 0.01);
    EXPECT_NEAR(result.evidence[0].end - result.evidence[0].begin, 0.5, 0.01);
}

TEST(Force, TimeAndImpulseAboveTheLimitOfTheTissue) {
    const Trace trace = half_sine();
    const MetricContext context = bowel_limit(1.5);
    // Above half of the peak for two thirds of the half-sine.
    const MetricResult time = measure(trace, "over_time", "left", {}, context, "bowel");
    ASSERT_TRUE(time.value);
    EXPECT_NEAR(*time.value, 4.0 / 3.0, 0.0025);
    ASSERT_EQ(time.evidence.size(), 1U);
    EXPECT_NEAR(time.evidence[0].begin, 1 + 1.0 / 3.0, 0.003);
    const double above = 3.0 * (4 / pi) * std::cos(pi / 6) - 1.5 * 4.0 / 3.0;
    EXPECT_NEAR(*measure(trace, "over_impulse", "left", {}, context, "bowel").value, above, 0.002);
    EXPECT_NEAR(*measure(trace, "over_impulse", "left", {}, context).value, above, 0.002);
    EXPECT_EQ(words_of(measure(trace, "over_time", "left").absent_because),
              "no force limit is known for any tissue");
    EXPECT_EQ(*measure(trace, "over_time", "left", {}, bowel_limit(5.0)).value, 0.0);  // zero is a value
}

TEST(Force, PeaksCountAboveTheLimitOnly) {
    Trace trace = make_trace(10.0);
    trace.tissues = {"bowel", "wall"};
    // One push a second, 1 to 9 N; on the wall in the second half, which has no limit.
    set_force(trace, Hand::right, [](double t) {
        const double s = t - std::floor(t);
        return Vector3(0, (std::floor(t) + 1) * 0.5 * (1 - std::cos(2 * pi * s)), 0);
    });
    set_tissue(trace, Hand::right, [](double t) { return t < 7 ? 0 : 1; });
    EXPECT_EQ(measure(trace, "f_peaks", "right", {}, bowel_limit(4.5)).value, 3.0);  // 5, 6, 7 N
    EXPECT_EQ(measure(trace, "f_peaks", "right", {}, bowel_limit(4.5), "bowel").value, 3.0);
    EXPECT_EQ(measure(trace, "f_peaks", "right", {}, bowel_limit(4.5), "wall").absence,
              Absence::not_measured);
    EXPECT_NEAR(*measure(trace, "f_max", "right", {}, {}, "bowel").value, 7.0, 0.01);
    EXPECT_NEAR(*measure(trace, "f_max", "right", {}, {}, "wall").value, 10.0, 0.01);
}

TEST(Force, VolumeOfOneDeviation) {
    Trace trace = make_trace(600.0, 100.0);
    set_force(trace, Hand::left, [](double t) {
        return Vector3(2 * std::sin(3 * t), std::sin(3 * 1.4142135623 * t),
                       0.5 * std::sin(3 * 1.7320508075 * t));
    });
    // The samples below 0.1 N are few; without them the volume grows by less than 0.1 %.
    EXPECT_NEAR(*measure(trace, "f_volume", "left").value, 1.48096, 0.0025);
    Trace brief = make_trace(0.5);
    set_force(brief, Hand::left, [](double) { return Vector3(1, 0, 0); });
    EXPECT_EQ(measure(brief, "f_volume", "left").absence, Absence::not_done);
}

TEST(Force, WithoutContactIsAbsentBecauseItWasNotDone) {
    Trace trace = make_trace(2.0);
    trace.tissues = {"bowel"};
    set_force(trace, Hand::left, [](double) { return Vector3::Zero(); });
    set_tissue(trace, Hand::left, [](double) { return -1; });
    for (const char* id : {"f_max", "f_sd", "f_mean_nz", "impulse", "dfdt_max", "f_volume"})
        EXPECT_EQ(measure(trace, id, "left").absence, Absence::not_done) << id;
    EXPECT_EQ(measure(trace, "f_max", "right").absence, Absence::not_measured);
}

Trace two_grasps() {
    Trace trace = make_trace(20.0);
    trace.tissues = {"bowel"};
    HandTrace& hand = trace.hand[0];
    for (const double t : trace.t) {
        const bool first = t >= 1 && t < 5, second = t >= 10 && t < 13;
        hand.jaw_force.push_back(first ? 5.0 : second ? 8.0 : 0.0);
        hand.jaw_area.push_back(first || second ? 50e-6 : 0.0);
        hand.tissue.push_back(first || second ? 0 : -1);
        hand.patch.push_back(first ? (t < 3 ? 1 : 2) : second ? 2 : -1);
    }
    return trace;
}

TEST(Grasp, ForceTimeProductsAndPressure) {
    const Trace trace = two_grasps();
    EXPECT_NEAR(*measure(trace, "grasp_max", "left").value, 8.0, 8.0 * 0.05);  // the filter overshoots a step
    const MetricResult product = measure(trace, "grasp_ftp", "left");
    EXPECT_NEAR(*product.value, 24.0, 0.1);
    EXPECT_EQ(product.count, 2);
    ASSERT_EQ(product.evidence.size(), 2U);
    EXPECT_NEAR(product.evidence[0].begin, 10.0, 0.01);  // the worst first
    EXPECT_NEAR(*measure(trace, "grasp_ftp_patch", "left").value, 5 * 2 + 24.0, 0.15);
    EXPECT_NEAR(*measure(trace, "grasp_kpa", "left").value, 160.0, 160 * 0.05);
    EXPECT_NEAR(*measure(trace, "grasp_ftp", "left", {}, {}, "bowel").value, 24.0, 0.1);
    EXPECT_EQ(words_of(measure(trace, "grasp_max", "right").absent_because), "not recorded: right.jaw");
}

TEST(Grasp, APauseDoesNotEndIt) {
    // 14 N on the bowel from 2 to 36 s, with a pause from 15 to 20 s.
    const std::vector<Event> paused = {make_event(15, EventKind::pause), make_event(20, EventKind::resume)};
    const auto held = [](const std::vector<Event>& events) {
        Trace trace = make_trace(40.0);
        trace.tissues = {"bowel"};
        trace.hand[0].jaw_force.assign(trace.t.size(), 14.0);
        set_tissue(trace, Hand::left, [](double t) { return t >= 2 && t < 36 ? 0 : -1; });
        split_blocks(trace, events);
        return trace;
    };
    Trace trace = held(paused);
    ASSERT_EQ(trace.blocks.size(), 2U);
    for (const char* tissue : {"", "bowel"}) {
        const MetricResult one = measure(trace, "grasp_ftp", "left", paused, {}, tissue);
        ASSERT_TRUE(one.value) << tissue;
        EXPECT_NEAR(*one.value, 14.0 * 29, 0.1) << tissue;
        EXPECT_EQ(one.count, 1);
        ASSERT_EQ(one.evidence.size(), 1U);
        EXPECT_NEAR(one.evidence[0].begin, 2.0, 0.002);
        EXPECT_NEAR(one.evidence[0].end, 36.0, 0.002);
    }
    // A second pause directly after the first, and one while a device is gone.
    const std::vector<Event> twice = {
        make_event(15, EventKind::pause),       make_event(20, EventKind::resume),
        make_event(20.001, EventKind::pause),   make_event(22, EventKind::resume),
        make_event(30, EventKind::device_lost), make_event(31, EventKind::device_back)};
    const MetricResult still_one = measure(held(twice), "grasp_ftp", "left", twice);
    EXPECT_NEAR(still_one.value.value_or(0), 14.0 * 26, 0.1);
    EXPECT_EQ(still_one.count, 1);
    // Jaws that opened before the pause took hold again after it.
    for (std::size_t i = 14990; i <= 15000; ++i) trace.hand[0].jaw_force[i] = 0;
    const MetricResult two = measure(trace, "grasp_ftp", "left", paused);
    EXPECT_NEAR(two.value.value_or(0), 14.0 * 16, 0.2);
    EXPECT_EQ(two.count, 2);
    // What was between lost samples nobody knows.
    const std::vector<Event> lost = {make_event(15, EventKind::samples_lost, 255, 1)};
    EXPECT_EQ(measure(held(lost), "grasp_ftp", "left", lost).count, 2);
}

TEST(Grasp, JawsClosedOnNothingAreNoGrasp) {
    Trace trace = two_grasps();
    for (auto& tissue : trace.hand[0].tissue) tissue = -1;
    EXPECT_EQ(measure(trace, "grasp_max", "left").absence, Absence::not_done);
    EXPECT_EQ(measure(trace, "grasp_ftp_patch", "left").absence, Absence::not_done);
}

TEST(Counts, OfEventsByHandAndTissue) {
    Trace trace = make_trace(10.0);
    trace.tissues = {"bowel"};
    set_tissue(trace, Hand::left, [](double) { return 0; });
    const std::vector<Event> events = {
        make_event(2, EventKind::slip, 0, 0, 0), make_event(3, EventKind::slip, 1, 0, 0),
        make_event(4, EventKind::slip, 0, 0, -1), make_event(5, EventKind::drop, 1)};
    EXPECT_EQ(measure(trace, "slip", "left", events).value, 2.0);
    EXPECT_EQ(measure(trace, "slip", "left", events, {}, "bowel").value, 1.0);
    EXPECT_EQ(measure(trace, "slip", "", events).value, 3.0);
    EXPECT_EQ(measure(trace, "drop", "left", events).value, 0.0);
    EXPECT_EQ(measure(trace, "drop", "", events).value, 1.0);
    EXPECT_EQ(measure(trace, "perforation", "", events).value, 0.0);
    MetricContext file;
    file.events_recorded = false;
    EXPECT_EQ(words_of(measure(trace, "slip", "left", {}, file).absent_because),
              "the record carries no events");
}

}  // namespace
}  // namespace fulcrum
