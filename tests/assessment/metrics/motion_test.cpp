// SPDX-License-Identifier: Apache-2.0
// Motion metrics through the whole pipeline: closed forms within 0.1 %, segment and absence rules.
#include <gtest/gtest.h>

#include <cmath>

#include "assessment/metrics/statement_words.h"
#include "tests/assessment/metrics/traces.h"

namespace fulcrum {
namespace {

using test::make_event;
using test::make_trace;
using test::measure;
using test::pi;
using test::reaches;
using test::set_axis;
using test::set_position;

Vector3 helix(double angle) {
    return {0.020 * std::cos(angle), 0.020 * std::sin(angle), 0.010 * angle / (2 * pi)};
}

TEST(PathLength, OfAHelixEvenWhenItStartsAndEndsInMotion) {
    Trace trace = make_trace(6.0);
    set_position(trace, Hand::left, [](double t) { return helix(t * pi); });
    const MetricResult result = measure(trace, "path_len", "left");
    ASSERT_TRUE(result.value) << words_of(result.absent_because);
    EXPECT_NEAR(*result.value, 378.1829, 0.378);
    EXPECT_EQ(result.unit, "mm");
    ASSERT_EQ(result.evidence.size(), 1U);
    EXPECT_NEAR(result.evidence[0].end - result.evidence[0].begin, 5.0, 0.02);
}

TEST(PathLength, IsTheSameAtEveryRateAndAbsentForTheHandThatIsMissing) {
    for (const double rate : {50.0, 100.0, 333.0, 1000.0, 1200.0}) {
        Trace trace = make_trace(12.0, rate);
        set_position(trace, Hand::right, [](double t) { return helix(t * pi / 2); });
        EXPECT_NEAR(measure(trace, "path_len", "right").value.value_or(0), 378.1829, 0.378) << rate;
        const MetricResult missing = measure(trace, "path_len", "left");
        EXPECT_FALSE(missing.value);
        EXPECT_EQ(missing.absence, Absence::not_measured);
        EXPECT_EQ(words_of(missing.absent_because), "not recorded: left.px, left.py, left.pz");
    }
}

TEST(PathLength, DoesNotRunAcrossAGap) {
    Trace whole = make_trace(4.0);
    Trace trace;
    for (const double t : whole.t)
        if (t <= 1.0 || t >= 3.0) trace.t.push_back(t);
    split_blocks(trace, {});
    ASSERT_EQ(trace.blocks.size(), 2U);
    set_position(trace, Hand::left, [](double t) { return Vector3(t < 2 ? 0.0 : 0.1, 0, 0); });
    EXPECT_NEAR(measure(trace, "path_len", "left").value.value_or(-1), 0.0, 1e-9);
}

TEST(SlowTraces, HaveNoMotionMetrics) {
    Trace trace = make_trace(10.0, 10.0);
    set_position(trace, Hand::left, [](double t) { return Vector3(0.01 * t, 0, 0); });
    const MetricResult slow = measure(trace, "path_len", "left");
    EXPECT_FALSE(slow.value);
    EXPECT_NE(words_of(slow.absent_because).find("10 Hz is below 20 Hz"), std::string::npos)
        << words_of(slow.absent_because);
    Trace medium = make_trace(10.0, 30.0);
    set_position(medium, Hand::left, [](double t) { return Vector3(0.01 * t, 0, 0); });
    EXPECT_TRUE(measure(medium, "path_len", "left").value);
    EXPECT_FALSE(measure(medium, "n_sub", "left").value);
    EXPECT_FALSE(measure(medium, "sparc", "left").value);
}

TEST(LostSamples, VoidWhatTheyTouch) {
    Trace trace = make_trace(4.0);
    set_position(trace, Hand::left, [](double t) { return Vector3(0.01 * t, 0, 0); });
    const std::vector<Event> some = {make_event(2.0, EventKind::samples_lost, 255, 50)};
    split_blocks(trace, some);
    EXPECT_TRUE(measure(trace, "path_len", "left", some).value);
    const std::vector<Event> many = {make_event(2.0, EventKind::samples_lost, 255, 150)};
    split_blocks(trace, many);
    EXPECT_EQ(words_of(measure(trace, "path_len", "left", many).absent_because), "150 samples were lost");
}

TEST(Rotation, AboutTheTipMovesNoTip) {
    Trace trace = make_trace(5.0);
    set_position(trace, Hand::left, [](double) { return Vector3(0.01, 0.02, 0.03); });
    set_axis(trace, Hand::left, [](double t) {
        const double angle = 10.0 * pi / 180.0 * test::minimum_jerk(t - 1, 3);
        return Vector3(std::sin(angle), 0, std::cos(angle));
    });
    EXPECT_NEAR(*measure(trace, "path_len", "left").value, 0.0, 1e-9);
    EXPECT_NEAR(*measure(trace, "ang_path", "left").value, 10.0, 0.01);
    EXPECT_NEAR(*measure(trace, "depth_axis", "left").value, 0.0, 1e-9);
}

TEST(Depth, SplitsThePathByDirection) {
    Trace trace = make_trace(10.0);
    set_axis(trace, Hand::left, [](double) { return Vector3(0, 0, -1); });
    // 50 mm in along the shaft, 30 mm back out, 40 mm aside.
    set_position(trace, Hand::left, [](double t) {
        const double in = 0.050 * test::minimum_jerk(t - 1, 1.5),
                     out = 0.030 * test::minimum_jerk(t - 4, 1.5);
        return Vector3(0.040 * test::minimum_jerk(t - 7, 1.5), 0, -in + out);
    });
    EXPECT_NEAR(*measure(trace, "seek_path", "left").value, 50.0, 0.1);
    EXPECT_NEAR(*measure(trace, "retract_path", "left").value, 30.0, 0.1);
    EXPECT_NEAR(*measure(trace, "depth_axis", "left").value, 80.0, 0.1);
    EXPECT_NEAR(*measure(trace, "path_len", "left").value, 120.0, 0.15);
}

TEST(Time, RunsFromTheFirstMovementToTheEndEventWithoutPauses) {
    Trace trace = make_trace(12.0);
    set_position(trace, Hand::right, reaches(1, 0.1, 2.0, 3.0));
    set_position(trace, Hand::left, [](double) { return Vector3::Zero(); });
    const std::vector<Event> events = {make_event(6.0, EventKind::pause), make_event(8.0, EventKind::resume),
                                       make_event(11.0, EventKind::completed)};
    split_blocks(trace, events);
    const MetricResult result = measure(trace, "time", "", events);
    ASSERT_TRUE(result.value);
    // A 100 mm minimum-jerk reach of 2 s exceeds 5 mm/s after 0.121 s.
    EXPECT_NEAR(*result.value, 11.0 - 3.12 - 2.0, 0.03);
    Trace still = make_trace(3.0);
    set_position(still, Hand::left, [](double) { return Vector3::Zero(); });
    EXPECT_EQ(measure(still, "time", "").absence, Absence::not_done);
}

TEST(Time, ItsEvidenceIsTheLongestStretchOfWorkNotOfPause) {
    Trace trace = make_trace(40.0);
    set_position(trace, Hand::right, reaches(1, 0.1, 2.0, 3.0));
    set_position(trace, Hand::left, [](double) { return Vector3::Zero(); });
    const std::vector<Event> events = {
        make_event(4.0, EventKind::goal_progress),  make_event(6.0, EventKind::pause),
        make_event(20.0, EventKind::resume),        make_event(21.0, EventKind::goal_progress),
        make_event(33.0, EventKind::goal_progress), make_event(34.0, EventKind::completed)};
    split_blocks(trace, events);
    const MetricResult result = measure(trace, "time", "", events);
    ASSERT_TRUE(result.value);
    EXPECT_NEAR(*result.value, 34.0 - 3.12 - 14.0, 0.03);
    ASSERT_EQ(result.evidence.size(), 1U);
    EXPECT_NEAR(result.evidence[0].begin, 21, 1e-9) << "from 4 to 21 s only 3 s are work";
    EXPECT_NEAR(result.evidence[0].end, 33, 1e-9);
}

// 40 mm in steps of a tenth of a second: something did move, only never for long enough to start the clock.
TEST(Time, WithoutALongEnoughMovementSaysWhatWasMissing) {
    Trace trace = make_trace(10.0);
    for (const Hand hand : {Hand::left, Hand::right})
        set_position(trace, hand, [](double t) {
            const double whole = std::floor(t), part = std::min(1.0, (t - whole) / 0.1);
            return Vector3(0.004 * (whole + part), 0, 0);
        });
    EXPECT_GT(measure(trace, "path_len", "left").value.value_or(0), 30);
    const MetricResult time = measure(trace, "time", "");
    ASSERT_FALSE(time.value);
    EXPECT_EQ(words_of(time.absent_because),
              "no instrument moved faster than 5 mm/s for 0.2 s inside the body");
}

TEST(Time, RunsFromWorkThatWasBegunHaltingly) {
    // Jerks of 20 mm/s for 0.1 s, twice a second, from the beginning; one smooth reach from 8 s on.
    Trace trace = make_trace(12.0);
    set_position(trace, Hand::right, [](double t) {
        const double jerks = std::min(std::floor(2 * t), 15.0), part = std::min(2 * t - jerks, 1.0);
        return Vector3(0.002 * (jerks + test::minimum_jerk(part, 0.2)) + 0.1 * test::minimum_jerk(t - 8, 2),
                       0, 0);
    });
    set_position(trace, Hand::left, [](double) { return Vector3::Zero(); });
    const MetricResult unseen = measure(trace, "time", "");
    ASSERT_TRUE(unseen.value);
    EXPECT_NEAR(*unseen.value, trace.end - 8.12, 0.03);
    const MetricResult seen = measure(trace, "time", "", {make_event(2.5, EventKind::first_movement)});
    ASSERT_TRUE(seen.value);
    EXPECT_NEAR(*seen.value, trace.end - 2.5, 1e-3);
    // The live monitor's begin and the filtered one differ a little: the filtered one stays.
    const MetricResult same = measure(trace, "time", "", {make_event(8.05, EventKind::first_movement)});
    EXPECT_EQ(same.value, unseen.value);
    Trace no_run = make_trace(4.0);
    set_position(no_run, Hand::left, [](double) { return Vector3::Zero(); });
    const MetricResult worked = measure(no_run, "time", "", {make_event(1, EventKind::first_movement)});
    ASSERT_TRUE(worked.value);
    EXPECT_NEAR(*worked.value, no_run.end - 1, 1e-3);
}

TEST(Economy, IsOneForStraightLegsAndLeavesHoldsOut) {
    Trace trace = make_trace(14.0);
    set_position(trace, Hand::left, reaches(4, 0.1, 1.5, 1.0));
    std::vector<Event> events;
    for (int i = 0; i < 4; ++i) events.push_back(make_event(2.9 + 2.5 * i, EventKind::target_reached, 0, i));
    const MetricResult straight = measure(trace, "econ", "left", events);
    ASSERT_TRUE(straight.value) << words_of(straight.absent_because);
    EXPECT_NEAR(*straight.value, 1.0, 1e-3);
    EXPECT_LE(*straight.value, 1.0);
    events.pop_back();
    events.pop_back();
    const MetricResult few = measure(trace, "econ", "left", events);
    EXPECT_EQ(few.absence, Absence::not_done);
    EXPECT_FALSE(few.value);
}

TEST(Economy, OfADetourIsTheRatioOfDistances) {
    // Each leg is half a circle: 2 / pi.
    Trace trace = make_trace(14.0);
    set_position(trace, Hand::left, [](double t) {
        double angle = 0;
        for (int i = 0; i < 4; ++i) angle += pi * test::minimum_jerk(t - 1.0 - 2.5 * i, 1.5);
        return Vector3(0.05 * std::cos(angle), 0.05 * std::sin(angle), 0);
    });
    std::vector<Event> events;
    for (int i = 0; i < 4; ++i) events.push_back(make_event(2.9 + 2.5 * i, EventKind::target_reached, 0, i));
    EXPECT_NEAR(measure(trace, "econ", "left", events).value.value_or(0), 2 / pi, 0.002);
    EXPECT_FALSE(measure(trace, "econ", "right", events).value);
}

TEST(Economy, OfABladeCountsTheWaysBetweenItsStrokes) {
    // Half circles between strokes of a quarter turn each way: the strokes do not count.
    Trace trace = make_trace(14.0);
    set_position(trace, Hand::left, [](double t) {
        double angle = 0;
        for (int i = 0; i < 4; ++i) angle += pi * test::minimum_jerk(t - 1.0 - 2.5 * i, 1.5);
        return Vector3(0.05 * std::cos(angle), 0.05 * std::sin(angle), 0);
    });
    std::vector<Event> events;
    for (int i = 0; i < 4; ++i) {
        events.push_back(make_event(2.6 + 2.5 * i, EventKind::cut_begin, 0));
        events.push_back(make_event(3.4 + 2.5 * i, EventKind::cut_end, 0));
    }
    EXPECT_NEAR(measure(trace, "econ", "left", events).value.value_or(0), 2 / pi, 0.002);
    // Strokes along the half circles: the ways between them are the rests, and nothing is left to count.
    events.clear();
    for (int i = 0; i < 4; ++i) {
        events.push_back(make_event(0.9 + 2.5 * i, EventKind::cut_begin, 0));
        events.push_back(make_event(2.6 + 2.5 * i, EventKind::cut_end, 0));
    }
    EXPECT_FALSE(measure(trace, "econ", "left", events).value);
}

TEST(DepthError, IsTheMeanDistanceFromTheSurfaceWhereTheFirstMovementEnded) {
    Trace trace = make_trace(9.0);
    set_axis(trace, Hand::left, [](double) { return Vector3(1, 0, 0); });
    set_position(trace, Hand::left, reaches(3, 0.1, 1.0, 1.0));  // ends at 100, 0 and 100 mm
    MetricContext context;
    // Their nearer sides are at 96, 2 and 97 mm.
    context.targets = {{{0.101, 0.01, 0}, 0.005, Hand::left},
                       {{0.005, 0, 0}, 0.003, Hand::left},
                       {{0.097, 0, 0.02}, 0, Hand::left}};
    std::vector<Event> events;
    for (int i = 0; i < 3; ++i) events.push_back(make_event(0.5 + 2.0 * i, EventKind::target_shown, 0, i));
    const MetricResult mean = measure(trace, "depth_err", "left", events, context);
    ASSERT_TRUE(mean.value) << words_of(mean.absent_because);
    EXPECT_EQ(mean.count, 3);
    EXPECT_NEAR(*mean.value, (4.0 + 2.0 + 3.0) / 3.0, 0.02);
    EXPECT_NEAR(*measure(trace, "depth_err_sd", "left", events, context).value, std::sqrt(62.0 / 6.0), 0.03);
    EXPECT_EQ(measure(trace, "depth_err", "left", events).absence, Absence::not_measured);
    EXPECT_EQ(measure(trace, "depth_err", "left", {}, context).absence, Absence::not_done);
}

TEST(Movements, AreFastRunsJoinedAcrossShortBreaks) {
    Trace trace = make_trace(20.0);
    // Constant 80 mm/s for 1 s, three times; the second pair is only 50 ms apart at zero speed.
    set_position(trace, Hand::left, [](double t) {
        const auto ramp = [](double s, double length) { return 0.080 * std::min(std::max(s, 0.0), length); };
        return Vector3(ramp(t - 2, 1) + ramp(t - 8, 1) + ramp(t - 9.05, 1) + ramp(t - 14, 0.1), 0, 0);
    });
    const MetricResult result = measure(trace, "n_moves", "left");
    EXPECT_EQ(result.value, 2.0);  // 2-3 s, 8-10 s; the last is too short
    EXPECT_EQ(result.evidence.size(), 2U);
}

TEST(SubMovements, AreSpeedPeaksWithinMovements) {
    Trace trace = make_trace(12.0);
    set_position(trace, Hand::left, [](double t) {
        // Two overlapping reaches make one movement with two peaks; then one plain reach.
        const double a =
            test::minimum_jerk(t - 1, 0.8) + test::minimum_jerk(t - 1.6, 0.8) + test::minimum_jerk(t - 6, 1);
        return Vector3(0.05 * a, 0, 0);
    });
    const MetricResult result = measure(trace, "n_sub", "left");
    EXPECT_EQ(result.value, 3.0);
    EXPECT_EQ(result.count, 2);
    EXPECT_EQ(measure(make_trace(1.0), "n_sub", "left").absence, Absence::not_measured);
}

TEST(Shares, CountActiveTimeOnly) {
    Trace trace = make_trace(9.999);
    set_position(trace, Hand::left, [](double t) { return Vector3(0.02 * std::max(0.0, t - 5.0), 0, 0); });
    test::set_tissue(trace, Hand::left, [](double) { return -1; });
    HandTrace& hand = trace.hand[0];
    for (const double t : trace.t) {
        hand.inside.push_back(t >= 2.5 ? 1 : 0);
        hand.in_view.push_back(t >= 4.0 ? 1 : 0);
    }
    EXPECT_NEAR(*measure(trace, "idle", "left").value, 100.0 * 2.5 / 7.5, 0.3);
    EXPECT_NEAR(*measure(trace, "off_screen", "left").value, 100.0 * 1.5 / 7.5, 0.2);
    EXPECT_NEAR(*measure(trace, "speed_mean", "left").value, 20.0 * 5.0 / 7.5, 0.1);
    for (auto& inside : hand.inside) inside = 0;
    EXPECT_EQ(measure(trace, "idle", "left").absence, Absence::not_done);
    hand.in_view.clear();
    EXPECT_EQ(words_of(measure(trace, "off_screen", "left").absent_because), "not recorded: left.in_view");
}

// A trainee who waits with both tips in the image, turns the camera away and then works; and one who first
// looks round.
TEST(Shares, CountFromTheFirstMovementOn) {
    Trace trace = make_trace(100.0, 100.0);
    set_position(trace, Hand::left, [](double t) { return Vector3(0.01 * std::max(0.0, t - 40.0), 0, 0); });
    test::set_tissue(trace, Hand::left, [](double) { return -1; });
    const std::vector<Event> moved = {make_event(40.0, EventKind::first_movement)};
    const auto seen_while = [&](auto in_view) {
        trace.hand[0].in_view.clear();
        for (const double t : trace.t) trace.hand[0].in_view.push_back(in_view(t) ? 1 : 0);
    };
    seen_while([](double t) { return t < 40.0; });
    const MetricResult away = measure(trace, "off_screen", "left", moved);
    ASSERT_TRUE(away.value);
    EXPECT_NEAR(*away.value, 100.0, 1e-9);
    ASSERT_EQ(away.evidence.size(), 1U);
    EXPECT_NEAR(away.evidence[0].begin, 40.0, 0.011);
    EXPECT_NEAR(measure(trace, "idle", "left", moved).value.value_or(-1), 0.0, 1.0);
    EXPECT_NEAR(measure(trace, "off_screen", "left").value.value_or(-1), 60.0, 0.1)
        << "a file without events";
    EXPECT_NEAR(measure(trace, "idle", "left").value.value_or(-1), 40.0, 1.0);
    seen_while([](double t) { return t >= 40.0; });
    const MetricResult looked = measure(trace, "off_screen", "left", moved);
    ASSERT_TRUE(looked.value);
    EXPECT_NEAR(*looked.value, 0.0, 1e-9);
    EXPECT_TRUE(looked.evidence.empty());
    // Nothing of it is left where the instrument was inside only before.
    for (const double t : trace.t) trace.hand[0].inside.push_back(t < 40.0 ? 1 : 0);
    EXPECT_EQ(measure(trace, "off_screen", "left", moved).absence, Absence::not_done);
}

TEST(Speed, PeakOfAReach) {
    Trace trace = make_trace(4.0);
    set_position(trace, Hand::left, reaches(1, 0.1, 2.0, 1.0));
    const MetricResult result = measure(trace, "speed_peak", "left");
    EXPECT_NEAR(*result.value, 1.875 * 100.0 / 2.0, 0.05);
    ASSERT_EQ(result.evidence.size(), 1U);
    EXPECT_NEAR(0.5 * (result.evidence[0].begin + result.evidence[0].end), 2.0, 0.02);
}

TEST(WorkingVolume, OfThreeIncommensurateSweeps) {
    Trace trace = make_trace(600.0, 100.0);
    const double root2 = std::sqrt(2.0);
    set_position(trace, Hand::left, [&](double t) {
        return Vector3(0.020 * root2 * std::sin(2 * pi * 0.5 * t),
                       0.015 * root2 * std::sin(2 * pi * 0.5 * 1.4142135623 * t),
                       0.010 * root2 * std::sin(2 * pi * 0.5 * 1.7320508075 * t));
    });
    EXPECT_NEAR(*measure(trace, "ws_volume", "left").value, 274.52, 0.27);
    set_position(trace, Hand::left, [](double t) { return Vector3(0.01 * std::sin(t), 0, 0); });
    EXPECT_FALSE(measure(trace, "ws_volume", "left").value);  // a line has no volume
}

TEST(BothHands, ShareAndCoordinate) {
    // Tip speeds v (1 + sin) along a line: positions are their integrals.
    const double omega = 2 * pi * 0.5, v = 0.020;
    const auto speed_course = [=](double phase) {
        return [=](double t) {
            return Vector3(v * (t - (std::cos(omega * t + phase) - std::cos(phase)) / omega), 0, 0);
        };
    };
    Trace trace = make_trace(60.0, 500.0);
    set_position(trace, Hand::left, speed_course(0));
    set_position(trace, Hand::right, speed_course(pi / 3));
    EXPECT_NEAR(*measure(trace, "bimanual_r", "").value, 0.5, 0.0005);
    EXPECT_NEAR(*measure(trace, "handed", "").value, 0.0, 0.1);
    EXPECT_EQ(measure(trace, "bimanual_r_ang", "").absence, Absence::not_measured);
    set_position(trace, Hand::right, [](double t) { return Vector3(0.005 * t, 0, 0); });
    EXPECT_NEAR(*measure(trace, "handed", "").value, 30.0, 0.1);  // 80 % against 20 %
    EXPECT_NEAR(*measure(trace, "simul", "").value, 0.0, 1e-9);   // the right hand stays below 10 mm/s
    trace.hand[1] = HandTrace{};
    EXPECT_EQ(words_of(measure(trace, "handed", "").absent_because),
              "not recorded: right.px, right.py, right.pz");
}

}  // namespace
}  // namespace fulcrum
