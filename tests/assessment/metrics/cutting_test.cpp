// SPDX-License-Identifier: Apache-2.0
// Metrics of a cut against closed forms, from made-up records of its events.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "assessment/metrics/statement_words.h"
#include "assessment/trace/cut_strokes.h"
#include "tests/assessment/metrics/traces.h"

namespace fulcrum {
namespace {

using test::make_trace;
using test::measure;
using test::pi;

const char* const cut_ids[] = {"traction_eff",  "traction_eff_len", "cut_dev",       "cut_dev_max",
                               "plane_dev",     "plane_dev_median", "plane_dev_p95", "plane_deep",
                               "plane_shallow", "area_developed"};

MetricContext plan_context() {
    MetricContext context;
    context.cut = CutPlan{0.1, 0.001, 0.01, 4.0, 8.0};
    return context;
}

Event cut_event(double t, EventKind kind, double value, std::int32_t detail, int hand = 1) {
    Event event;
    event.tick = static_cast<std::uint32_t>(std::lround(t * 1000));
    event.kind = kind;
    event.hand = static_cast<std::uint8_t>(hand);
    event.value = static_cast<float>(value);
    event.detail = detail;
    return event;
}

std::int32_t micrometres(double metres) {
    return static_cast<std::int32_t>(std::lround(metres * 1e6));
}

/// A stroke from `a` to `b` (m along the line) in `n` equal advances over [t0, t1]; distance and traction by
/// place.
template <typename Distance, typename Traction>
void stroke(std::vector<Event>& events, double t0, double t1, double a, double b, int n, Distance distance,
            Traction traction, int hand = 1) {
    events.push_back(cut_event(t0, EventKind::cut_begin, a, micrometres(distance(a)), hand));
    for (int i = 1; i <= n; ++i) {
        const double from = a + (b - a) * (i - 1) / n, to = a + (b - a) * i / n, t = t0 + (t1 - t0) * i / n;
        events.push_back(cut_event(t, EventKind::cut_advance, to, micrometres(distance(to)), hand));
        events.push_back(cut_event(t, EventKind::cut_traction, traction(to),
                                   micrometres(std::hypot(to - from, distance(to) - distance(from))), hand));
    }
    events.push_back(cut_event(t1, EventKind::cut_end, b, micrometres(distance(b)), hand));
}

double value_of(const std::vector<Event>& events, const std::string& id,
                const Trace& trace = make_trace(30.0)) {
    const MetricResult result = measure(trace, id, "", events, plan_context());
    EXPECT_TRUE(result.value.has_value()) << id << ": " << words_of(result.absent_because);
    return result.value.value_or(std::nan(""));
}

const auto taut = [](double) { return 6.0; };

/// `count` times half a millimetre of fibres that part one after the other from `begin` on, twenty a second.
void part_fibres(std::vector<Event>& events, double t0, double begin, int count) {
    for (int i = 0; i < count; ++i) {
        const double from = begin + 0.0005 * i, t = t0 + 0.05 * i;
        events.push_back(cut_event(t, EventKind::fibres_parted, from, 2000, 255));
        events.push_back(cut_event(t, EventKind::cut_advance, from + 0.0005, 2000, 255));
        events.push_back(cut_event(t, EventKind::cut_traction, 12, 500, 255));
    }
}

// Half is cut in the band on the line, half parts beyond the band and 2 mm next to it.
TEST(Cutting, WhereFibresPartedNothingIsDivided) {
    std::vector<Event> events;
    stroke(
        events, 1, 11, 0, 0.05, 100, [](double) { return 0.0; }, taut);
    part_fibres(events, 12, 0.05, 100);
    EXPECT_NEAR(value_of(events, "area_developed"), 50, 1e-4);
    EXPECT_NEAR(value_of(events, "traction_eff"), 100, 1e-9) << "time of a blade";
    EXPECT_NEAR(value_of(events, "traction_eff_len"), 50, 1e-4);
    EXPECT_NEAR(value_of(events, "plane_deep"), 50, 1e-4);
    EXPECT_NEAR(value_of(events, "cut_dev"), 100, 1e-3) << "mm2";
    EXPECT_NEAR(value_of(events, "cut_dev_max"), 2, 1e-6);
    const std::vector<CutStroke> strokes = cut_strokes(events, 1e-3, 30);
    ASSERT_EQ(strokes.size(), 101U);
    EXPECT_EQ(strokes[0].hand, 1);
    EXPECT_EQ(strokes[100].hand, -1);
    // Who only pulls has not cut under tension.
    const std::vector<Event> torn(events.end() - 300, events.end());
    EXPECT_NEAR(value_of(torn, "area_developed"), 0, 1e-9);
    EXPECT_NEAR(value_of(torn, "traction_eff_len"), 0, 1e-9);
    EXPECT_FALSE(measure(make_trace(30.0), "traction_eff", "", torn, plan_context()).value.has_value());
    // Of no hand an advance alone begins nowhere: it is left out.
    EXPECT_TRUE(cut_strokes({cut_event(1, EventKind::cut_advance, 0.01, 0, 255)}, 1e-3, 30).empty());
}

TEST(Cutting, WhatToreStaysTornWhereABladeTrimsIt) {
    const auto on_line = [](double) { return 0.0; };
    const auto off_line = [](double) { return 0.003; };
    std::vector<Event> trimmed;
    stroke(trimmed, 1, 11, 0, 0.05, 100, on_line, taut);
    part_fibres(trimmed, 12, 0.05, 100);
    stroke(trimmed, 20, 26, 0.05, 0.1, 50, off_line, taut);
    EXPECT_NEAR(value_of(trimmed, "area_developed"), 50, 1e-4);
    // Back over it by the other hand, and a blade that cuts where it is still whole.
    stroke(trimmed, 27, 28, 0.1, 0.04, 7, off_line, taut, 0);
    EXPECT_NEAR(value_of(trimmed, "area_developed"), 50, 1e-4);

    std::vector<Event> cut_first;
    stroke(cut_first, 1, 11, 0, 0.05, 100, on_line, taut);
    stroke(cut_first, 12, 18, 0.05, 0.1, 50, off_line, taut);
    part_fibres(cut_first, 20, 0.05, 100);
    EXPECT_NEAR(value_of(cut_first, "area_developed"), 100, 1e-4);

    // 10 mm ahead of a blade under way, which comes there later.
    std::vector<Event> ahead;
    stroke(ahead, 1, 11, 0, 0.1, 100, on_line, taut);
    part_fibres(ahead, 5, 0.06, 20);
    EXPECT_NEAR(value_of(ahead, "area_developed"), 90, 1e-4);
    // Behind the blade nothing is left to tear.
    std::vector<Event> behind;
    stroke(behind, 1, 11, 0, 0.1, 100, on_line, taut);
    part_fibres(behind, 8, 0.06, 20);
    EXPECT_NEAR(value_of(behind, "area_developed"), 100, 1e-4);
}

TEST(Cutting, OnTheLineUnderTensionIsFlawless) {
    std::vector<Event> events;
    stroke(
        events, 1, 11, 0, 0.1, 200, [](double) { return 0.0; }, taut);
    EXPECT_NEAR(value_of(events, "area_developed"), 100, 1e-5);
    EXPECT_NEAR(value_of(events, "traction_eff"), 100, 1e-9);
    EXPECT_NEAR(value_of(events, "traction_eff_len"), 100, 1e-9);
    for (const char* id : {"cut_dev", "cut_dev_max", "plane_dev", "plane_dev_median", "plane_dev_p95",
                           "plane_deep", "plane_shallow"})
        EXPECT_EQ(value_of(events, id), 0.0) << id;
    for (const char* id : {"traction_eff", "plane_deep"})
        EXPECT_TRUE(measure(make_trace(30), id, "", events, plan_context()).evidence.empty()) << id;
}

// d = 4 mm s / L: a triangle of 100 mm by 4 mm; the distance is spread evenly over 0 .. 4 mm.
TEST(Cutting, OfAWedge) {
    std::vector<Event> events;
    stroke(
        events, 1, 11, 0, 0.1, 400, [](double s) { return 0.04 * s; }, taut);
    EXPECT_NEAR(value_of(events, "cut_dev"), 200.0, 0.01);
    EXPECT_NEAR(value_of(events, "cut_dev_max"), 4.0, 1e-9);
    EXPECT_NEAR(value_of(events, "plane_dev"), 2.0, 2e-3);
    EXPECT_NEAR(value_of(events, "plane_dev_median"), 2.0, 2e-3);
    EXPECT_NEAR(value_of(events, "plane_dev_p95"), 3.8, 4e-3);
    EXPECT_NEAR(value_of(events, "plane_deep"), 75.0, 0.05);
    EXPECT_EQ(value_of(events, "plane_shallow"), 0.0);
    EXPECT_NEAR(value_of(events, "area_developed"), 100.0, 1e-5);
    for (Event& event : events)
        if (event.kind != EventKind::cut_traction) event.detail = -event.detail;
    EXPECT_NEAR(value_of(events, "plane_dev_median"), -2.0, 2e-3) << "the sign says the side";
    EXPECT_NEAR(value_of(events, "plane_dev"), 2.0, 2e-3);
    EXPECT_NEAR(value_of(events, "plane_shallow"), 75.0, 0.05);
    EXPECT_EQ(value_of(events, "plane_deep"), 0.0);
}

// d = 3 mm sin(2 pi s / L): two lobes of area 3 * 100 / pi mm2 each side; half the sine lies above sin(pi/4).
TEST(Cutting, OfASine) {
    std::vector<Event> events;
    stroke(
        events, 1, 11, 0, 0.1, 1000, [](double s) { return 0.003 * std::sin(20 * pi * s); }, taut);
    EXPECT_NEAR(value_of(events, "cut_dev"), 2 * 3.0 * 100 / pi, 0.1);
    EXPECT_NEAR(value_of(events, "cut_dev_max"), 3.0, 1e-3);
    EXPECT_NEAR(value_of(events, "plane_dev_median"), 0.0, 0.01);
    // Weighted by the length of the cut, which is hardly longer than the line: slope at most 0.19.
    EXPECT_NEAR(value_of(events, "plane_dev"), 3.0 * std::sqrt(0.5), 0.02);
    EXPECT_NEAR(value_of(events, "plane_deep"), value_of(events, "plane_shallow"), 0.1);
    const double beyond = 50.0 * (1 - 2 * std::asin(1.0 / 3) / pi);
    EXPECT_NEAR(value_of(events, "plane_deep"), beyond, 0.6);
}

TEST(Cutting, AnElementThatCrossesTheLineCountsBothItsTriangles) {
    std::vector<Event> events;
    stroke(
        events, 1, 2, 0.02, 0.06, 1, [](double s) { return s < 0.04 ? -0.003 : 0.001; }, taut);
    // 40 mm from -3 mm to 1 mm crosses after 30 mm: 45 + 5 mm2.
    EXPECT_NEAR(value_of(events, "cut_dev"), 50.0, 1e-4);
    EXPECT_NEAR(value_of(events, "plane_shallow"), 50.0, 1e-4) << "from -3 to -1 mm";
    EXPECT_NEAR(value_of(events, "area_developed"), 40.0, 1e-4);
}

TEST(Cutting, TractionByTimeAndByLength) {
    std::vector<Event> events;
    const auto on_line = [](double) { return 0.0; };
    stroke(events, 1, 4, 0.00, 0.02, 20, on_line, [](double) { return 2.0; });   // slack: 3 s, 20 mm
    stroke(events, 5, 6, 0.02, 0.08, 20, on_line, taut);                         // right: 1 s, 60 mm
    stroke(events, 8, 10, 0.08, 0.10, 20, on_line, [](double) { return 9.0; });  // too tight: 2 s, 20 mm
    EXPECT_NEAR(value_of(events, "traction_eff"), 100.0 / 6, 1e-6);
    EXPECT_NEAR(value_of(events, "traction_eff_len"), 60.0, 1e-9);
    const MetricResult result = measure(make_trace(30), "traction_eff", "", events, plan_context());
    ASSERT_EQ(result.evidence.size(), 2U);
    EXPECT_NEAR(result.evidence[0].begin, 1, 1e-9) << "2 N/m short is worse than 1 N/m over";
    EXPECT_NEAR(result.evidence[0].end, 4, 1e-9);
    EXPECT_NEAR(result.evidence[1].begin, 8, 1e-9);
}

TEST(Cutting, ABladeThatRestsInTissueKeepsTheLastTractionAndPausesDoNotCount) {
    std::vector<Event> events;
    const auto on_line = [](double) { return 0.0; };
    stroke(events, 1, 2, 0, 0.05, 10, on_line, taut);
    stroke(events, 3, 4, 0.05, 0.1, 10, on_line, [](double) { return 1.0; });
    events.back().tick += 2000;  // the blade stays in for 2 s more, slack
    EXPECT_NEAR(value_of(events, "traction_eff"), 25.0, 1e-6);
    events.insert(events.end() - 1, cut_event(4.2, EventKind::pause, 0, 0, 255));
    events.insert(events.end() - 1, cut_event(5.7, EventKind::resume, 0, 0, 255));
    Trace trace = make_trace(30);
    split_blocks(trace, events);
    EXPECT_NEAR(value_of(events, "traction_eff", trace), 100.0 / 2.5, 1e-6);
}

TEST(Cutting, TheLineIsDividedOnceHoweverOftenItIsCut) {
    std::vector<Event> events;
    const auto on_line = [](double) { return 0.0; };
    stroke(events, 1, 2, 0.01, 0.05, 7, on_line, taut);
    stroke(events, 3, 4, 0.06, 0.03, 7, on_line, taut, 0);  // backwards, over it, by the other hand
    stroke(events, 5, 6, 0.09, 0.12, 7, on_line, taut);     // beyond the end
    stroke(
        events, 7, 8, 0.06, 0.09, 7, [](double) { return 0.02; }, taut);  // far from the line
    EXPECT_NEAR(value_of(events, "area_developed"), 60.0, 1e-4);
}

TEST(Cutting, AStrokeLeavesTheCorridorWhereItCrossesItsBorder) {
    std::vector<Event> events;
    stroke(
        events, 1, 2, 0, 0.1, 1, [](double s) { return 0.2 * s; }, taut);  // 20 mm off at the end
    EXPECT_NEAR(value_of(events, "area_developed"), 50.0, 1e-4);
}

TEST(Cutting, AStrokeWithoutAnEndLastsToTheEndOfTheAttempt) {
    std::vector<Event> events;
    stroke(
        events, 1, 2, 0, 0.05, 10, [](double) { return 0.0; }, taut);
    events.pop_back();
    const std::vector<CutStroke> strokes = cut_strokes(events, 0.001, 7.0);
    ASSERT_EQ(strokes.size(), 1U);
    EXPECT_EQ(strokes[0].end, 7.0);
    EXPECT_EQ(strokes[0].elements.size(), 10U);
}

TEST(Cutting, AbsenceSaysWhy) {
    const Trace trace = make_trace(10);
    for (const char* id : cut_ids) {
        const MetricResult nothing = measure(trace, id, "", {}, plan_context());
        EXPECT_EQ(nothing.absence, Absence::not_done) << id;
        EXPECT_EQ(words_of(nothing.absent_because), "nothing was cut") << id;
        EXPECT_EQ(measure(trace, id, "", {}).absence, Absence::not_measured)
            << id << ": a task without a line";
        MetricContext csv = plan_context();
        csv.events_recorded = false;
        EXPECT_EQ(words_of(measure(trace, id, "", {}, csv).absent_because), "the record carries no events")
            << id;
    }
    // A blade that broke through and came out again without going on has cut nothing.
    const std::vector<Event> stab = {cut_event(1, EventKind::cut_begin, 0.02, 0),
                                     cut_event(2, EventKind::cut_end, 0.02, 0)};
    EXPECT_EQ(measure(trace, "cut_dev", "", stab, plan_context()).absence, Absence::not_done);
    std::vector<Event> silent;
    stroke(
        silent, 1, 2, 0, 0.05, 10, [](double) { return 0.0; }, taut);
    silent.erase(std::remove_if(silent.begin(), silent.end(),
                                [](const Event& e) { return e.kind == EventKind::cut_traction; }),
                 silent.end());
    EXPECT_EQ(measure(trace, "traction_eff", "", silent, plan_context()).absence, Absence::not_measured);
    EXPECT_NEAR(value_of(silent, "area_developed"), 50, 1e-4) << "needs no traction";
    MetricContext no_band = plan_context();
    no_band.cut->traction_low = no_band.cut->traction_high = 0;
    EXPECT_EQ(words_of(measure(trace, "traction_eff", "", silent, no_band).absent_because),
              "the task sets no range of traction");
}

/// Random strokes by both hands.
std::vector<Event> random_cut() {
    std::vector<Event> events;
    const int strokes = *rc::gen::inRange(1, 5);
    double t = 1;
    for (int i = 0; i < strokes; ++i) {
        const auto number = [](int low, int high) {
            return static_cast<double>(*rc::gen::inRange(low, high));
        };
        const double a = number(-20, 121) / 1000, b = a + number(1, 60) / 1000;
        const double offset = number(-8000, 8001) * 1e-6, slope = number(-200, 201) / 1000;
        const double traction = number(0, 15), duration = number(1, 20) / 10;
        stroke(
            events, t, t + duration, a, b, *rc::gen::inRange(1, 12),
            [=](double s) { return offset + slope * (s - a); }, [=](double) { return traction; },
            *rc::gen::inRange(0, 2));
        t += duration + 0.5;
    }
    return events;
}

RC_GTEST_PROP(CuttingProperty, SharesAreSharesAndQuantilesAreOrdered, ()) {
    const std::vector<Event> events = random_cut();
    const Trace trace = make_trace(20);
    const auto value = [&](const char* id) {
        const MetricResult result = measure(trace, id, "", events, plan_context());
        RC_ASSERT(result.value.has_value());
        RC_ASSERT(result.evidence.size() <= 20U);
        for (const TimeInterval& interval : result.evidence) RC_ASSERT(interval.begin <= interval.end);
        return *result.value;
    };
    for (const char* id :
         {"traction_eff", "traction_eff_len", "plane_deep", "plane_shallow", "area_developed"}) {
        RC_ASSERT(value(id) >= 0);
        RC_ASSERT(value(id) <= 100 + 1e-6);
    }
    RC_ASSERT(value("plane_deep") + value("plane_shallow") <= 100 + 1e-6);
    RC_ASSERT(std::abs(value("plane_dev_median")) <= value("cut_dev_max") + 1e-9);
    RC_ASSERT(value("plane_dev") <= value("plane_dev_p95") + 1e-9);
    RC_ASSERT(value("plane_dev_p95") <= value("cut_dev_max") + 1e-9);
    RC_ASSERT(value("cut_dev") >= 0);
}

RC_GTEST_PROP(CuttingProperty, MirroringSwapsDeepAndShallowAndNothingElse, ()) {
    std::vector<Event> events = random_cut();
    // In the plane, of a length that no sum of the others' whole millimetres has: no half of the cut ends
    // between two strokes, where every distance between theirs is a median.
    stroke(
        events, 15, 16, 0.05, 0.05037, 3, [](double) { return 0.0; }, taut);
    std::vector<Event> mirrored = events;
    for (Event& event : mirrored)
        if (event.kind != EventKind::cut_traction) event.detail = -event.detail;
    const Trace trace = make_trace(20);
    const auto value = [&](const std::vector<Event>& of, const char* id) {
        return *measure(trace, id, "", of, plan_context()).value;
    };
    const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * (1 + std::abs(a)); };
    RC_ASSERT(same(value(events, "plane_deep"), value(mirrored, "plane_shallow")));
    RC_ASSERT(same(value(events, "plane_dev_median"), -value(mirrored, "plane_dev_median")));
    for (const char* id :
         {"plane_dev", "plane_dev_p95", "cut_dev", "cut_dev_max", "area_developed", "traction_eff"})
        RC_ASSERT(same(value(events, id), value(mirrored, id)));
}

RC_GTEST_PROP(CuttingProperty, TheOrderOfTheHandsReportsWithinATickDoesNotMatter, ()) {
    // Two hands cut at the same time: what one reports never becomes the other's.
    std::vector<Event> left, right;
    const double offset = *rc::gen::inRange(-5000, 5001) * 1e-6;
    stroke(
        left, 1, 3, 0, 0.05, 10, [=](double) { return offset; }, taut, 0);
    stroke(
        right, 1, 3, 0.05, 0.1, 10, [=](double) { return -offset; }, taut, 1);
    const auto merged = [](std::vector<Event> a, const std::vector<Event>& b) {
        a.insert(a.end(), b.begin(), b.end());
        std::stable_sort(a.begin(), a.end(), [](const Event& x, const Event& y) { return x.tick < y.tick; });
        return a;
    };
    for (const char* id : cut_ids) {
        const Trace trace = make_trace(20);
        const double a = *measure(trace, id, "", merged(left, right), plan_context()).value;
        const double b = *measure(trace, id, "", merged(right, left), plan_context()).value;
        RC_ASSERT(std::abs(a - b) <= 1e-9 * (1 + std::abs(a)));
    }
}

}  // namespace
}  // namespace fulcrum
