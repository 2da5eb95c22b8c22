// SPDX-License-Identifier: Apache-2.0
// Smoothness through the whole pipeline: segments, medians, absence.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/statement_words.h"
#include "tests/assessment/metrics/traces.h"

namespace fulcrum {
namespace {

using test::make_trace;
using test::measure;
using test::pi;
using test::reaches;
using test::set_force;
using test::set_position;

TEST(Segments, LieBetweenPausesAndReachOutToTheRestOfTheMovement) {
    std::vector<double> speed(100, 0.0);
    for (int i = 0; i <= 100; ++i) {
        const double s = i / 100.0;
        speed.push_back(0.1 * 30 * s * s * (1 - s) * (1 - s));
    }
    speed.resize(301, 0.0);
    const std::vector<Segment> segments = find_segments(speed, find_pauses(speed));
    ASSERT_EQ(segments.size(), 1U);
    EXPECT_GT(segments[0].core.first, segments[0].whole.first);
    EXPECT_EQ(segments[0].whole.first, 100U);  // down to the last sample at rest
    EXPECT_EQ(segments[0].whole.last, 201U);
}

TEST(Segments, ShortSlowAndLongOnesAreDropped) {
    const auto segments_of = [](double peak, double duration) {
        std::vector<double> speed(50, 0.0);
        const int n = static_cast<int>(duration * 100);
        for (int i = 0; i < n; ++i) speed.push_back(peak * std::sin(pi * (i + 0.5) / n));
        speed.resize(speed.size() + 50, 0.0);
        return find_segments(speed, find_pauses(speed)).size();
    };
    EXPECT_EQ(segments_of(0.1, 1.0), 1U);
    EXPECT_EQ(segments_of(0.1, 0.25), 0U);
    EXPECT_EQ(segments_of(0.019, 1.0), 0U);
    EXPECT_EQ(segments_of(0.1, 9.9), 1U);
    EXPECT_EQ(segments_of(0.1, 10.5), 0U);
}

TEST(Segments, CutOffByTheBlockAreNone) {
    std::vector<double> speed(100, 0.1);
    speed.resize(200, 0.0);
    EXPECT_TRUE(find_segments(speed, find_pauses(speed)).empty());
}

std::vector<double> bells(int count, double peak, int samples, int rest, double floor = 0.0) {
    std::vector<double> speed(static_cast<std::size_t>(rest), 0.0);
    for (int n = 0; n < count; ++n) {
        for (int i = 0; i <= samples; ++i) {
            const double s = static_cast<double>(i) / samples;
            speed.push_back(floor + (peak - floor) * 16 * s * s * (1 - s) * (1 - s));
        }
        speed.insert(speed.end(), static_cast<std::size_t>(rest), 0.0);
    }
    return speed;
}

TEST(FreeMovements, AreDividedAtDeepMinimaOfSpeedOnly) {
    const auto count = [](double floor) {
        std::vector<double> speed(50, 0.0);
        const std::vector<double> four = bells(4, 0.1, 100, 0, floor);
        speed.insert(speed.end(), four.begin(), four.end());
        speed.resize(speed.size() + 50, 0.0);
        return find_free_movements(speed, find_pauses(speed), {}).segments.size();
    };
    EXPECT_EQ(count(0.001), 4U);  // never rests for 0.2 s
    EXPECT_EQ(count(0.049), 4U);
    EXPECT_EQ(count(0.051), 1U);  // a correction inside a movement
}

TEST(FreeMovements, LeaveContactOutAndBridgeShortBreaks) {
    const std::vector<double> speed = bells(3, 0.1, 100, 50);
    const std::vector<std::uint8_t> pause = find_pauses(speed);
    std::vector<std::uint8_t> contact(speed.size(), 0);
    EXPECT_EQ(find_free_movements(speed, pause, contact).segments.size(), 3U);
    std::fill(contact.begin() + 210, contact.begin() + 230, std::uint8_t{1});  // in the second
    std::fill(contact.begin() + 245, contact.begin() + 300, std::uint8_t{1});
    const FreeMovement found = find_free_movements(speed, pause, contact);
    ASSERT_EQ(found.segments.size(), 2U);
    EXPECT_LT(found.segments[0].whole.last, 201U);
    EXPECT_GE(found.segments[1].whole.first, 352U);
    std::size_t in_segments = 0;
    for (const Segment& segment : found.segments) in_segments += segment.core.size();
    EXPECT_EQ(found.samples, in_segments);
}

TEST(Sparc, LeavesOutTheTimeWithABladeInTissueOrTissueInTheJaws) {
    // Two kinds of reaches by turns: smooth ones, and ones that shake.
    const auto course = reaches(16, 0.1, 1.0, 1.5);
    const auto shaking = [](double t) { return static_cast<int>((t - 0.75) / 2.5) % 2 == 1; };
    Trace trace = make_trace(41.0);
    set_position(trace, Hand::left, [&](double t) {
        const double moving = shaking(t) ? (course(t + 0.001) - course(t - 0.001)).norm() : 0.0;
        return Vector3(course(t) + Vector3(0, moving * 30 * std::sin(2 * pi * 3 * t), 0));
    });
    const double mixed = *measure(trace, "sparc", "left").value;
    EXPECT_LT(mixed, -1.45);
    for (const double t : trace.t) trace.hand[0].cutting.push_back(shaking(t) ? 1 : 0);
    EXPECT_NEAR(*measure(trace, "sparc", "left").value, -1.40583, 0.003);
    trace.hand[0].cutting.clear();
    for (const double t : trace.t) trace.hand[0].jaw_force.push_back(shaking(t) ? 2.0 : 0.0);
    EXPECT_NEAR(*measure(trace, "sparc", "left").value, -1.40583, 0.003);
    EXPECT_EQ(measure(trace, "sparc", "left").count, 8);
}

TEST(Sparc, StoppingBeforeTheGoalGainsNothing) {
    // 16 reaches of 100 mm, and the same each made as 80 mm, a stop, 20 mm.
    const auto reaches_with = [](double rest) {
        return [rest](double t) {
            double x = 0;
            for (int i = 0; i < 16; ++i) {
                const double start = 1.5 + i * 3.5, sign = i % 2 == 0 ? 1 : -1;
                x += sign * (0.08 * test::minimum_jerk(t - start, 0.9) +
                             0.02 * test::minimum_jerk(t - start - 0.9 - rest, 0.7));
            }
            return Vector3(x, 0, 0);
        };
    };
    Trace stops = make_trace(60.0), slows = make_trace(60.0);
    set_position(stops, Hand::left, reaches_with(0.4));
    set_position(slows, Hand::left, reaches_with(0.0));
    EXPECT_NEAR(*measure(stops, "ldlj", "left").value, *measure(slows, "ldlj", "left").value, 0.1);
    EXPECT_NEAR(*measure(stops, "sparc", "left").value, *measure(slows, "sparc", "left").value, 0.02);
}

TEST(Sparc, OfReachesIsThatOfOneReach) {
    Trace trace = make_trace(21.0);
    set_position(trace, Hand::left, reaches(8, 0.1, 1.0, 1.5));
    const MetricResult result = measure(trace, "sparc", "left");
    ASSERT_TRUE(result.value) << words_of(result.absent_because);
    EXPECT_EQ(result.count, 8);
    EXPECT_NEAR(*result.value, -1.40583, 0.0014);
    const MetricResult jerk = measure(trace, "ldlj", "left");
    ASSERT_TRUE(jerk.value) << words_of(jerk.absent_because);
    EXPECT_NEAR(*jerk.value, -5.234837, 2e-6);  // accuracy_test.cpp says where it comes from
}

TEST(Sparc, FewerThanFiveMovementsOrTooLittleOfTheTimeGiveNone) {
    Trace few = make_trace(12.0);
    set_position(few, Hand::left, reaches(4, 0.1, 1.0, 1.5));
    EXPECT_EQ(words_of(measure(few, "sparc", "left").absent_because), "4 movements, fewer than 5");
    // Five reaches of 1 s, then 20 s of steady motion that is no segment.
    Trace trace = make_trace(40.0);
    const auto five = reaches(5, 0.05, 1.0, 1.0);
    set_position(trace, Hand::left,
                 [&](double t) { return Vector3(five(t) + Vector3(0, 0.02 * std::max(0.0, t - 15.0), 0)); });
    const MetricResult result = measure(trace, "sparc", "left");
    EXPECT_FALSE(result.value);
    EXPECT_NE(words_of(result.absent_because).find("half of the moving time"), std::string::npos);
}

TEST(Sparc, IsWorseForAMovementWithCorrections) {
    Trace smooth = make_trace(21.0), rough = make_trace(21.0);
    const auto course = reaches(8, 0.1, 1.0, 1.5);
    set_position(smooth, Hand::left, course);
    set_position(rough, Hand::left, [&](double t) {
        const double moving = (course(t + 0.001) - course(t - 0.001)).norm();
        return Vector3(course(t) + Vector3(0, moving * 30 * std::sin(2 * pi * 3 * t), 0));
    });
    EXPECT_LT(*measure(rough, "sparc", "left").value, *measure(smooth, "sparc", "left").value - 0.1);
}

TEST(LogJerk, IsAbsentWhereTheDeviceIsTooNoisy) {
    Trace trace = make_trace(21.0);
    set_position(trace, Hand::left, reaches(8, 0.1, 1.0, 1.5));
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 8e-6);
    for (double& x : trace.hand[0].py) x += noise(random);
    const MetricResult result = measure(trace, "ldlj", "left");
    EXPECT_EQ(result.absence, Absence::not_measured);
    EXPECT_EQ(result.absent_because.id(), StatementId::device_noise);
    EXPECT_NEAR(*result.absent_because.number("noise_um"), 7, 0.5);
    EXPECT_TRUE(measure(trace, "sparc", "left").value);
}

TEST(LogJerk, IsThereForAHandWithTremor) {
    Trace trace = make_trace(21.0);
    const auto course = reaches(8, 0.1, 1.0, 1.5);
    // 50 µm root mean square an axis at 9 Hz, a strong physiological tremor, and 2 µm of the device's noise.
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 2e-6);
    set_position(trace, Hand::left, [&](double t) {
        const double tremor = 50e-6 * std::sqrt(2.0) * std::sin(2 * pi * 9 * t);
        return Vector3(course(t) + Vector3(noise(random), tremor + noise(random), noise(random)));
    });
    const MetricResult result = measure(trace, "ldlj", "left");
    ASSERT_TRUE(result.value) << words_of(result.absent_because);
    EXPECT_NEAR(*result.value, -5.2, 0.1);
}

TEST(Tremor, IsTheShareOfItsBand) {
    Trace trace = make_trace(20.0);
    // Accelerations of equal amplitude at 3 Hz and 9 Hz: half of the power lies in the band.
    const double slow = 1.0 / std::pow(2 * pi * 3, 2), fast = 1.0 / std::pow(2 * pi * 9, 2);
    set_position(trace, Hand::left, [=](double t) {
        return Vector3(slow * std::sin(2 * pi * 3 * t), fast * std::sin(2 * pi * 9 * t), 0);
    });
    const MetricResult result = measure(trace, "tremor", "left");
    ASSERT_TRUE(result.value) << words_of(result.absent_because);
    EXPECT_NEAR(*result.value, 0.5, 0.0005);
    EXPECT_EQ(result.count, 18);
    Trace brief = make_trace(3.5);
    set_position(brief, Hand::left, [](double t) { return Vector3(t, 0, 0); });
    EXPECT_EQ(measure(brief, "tremor", "left").absence, Absence::not_done);
    Trace slow_rate = make_trace(20.0, 60.0);
    set_position(slow_rate, Hand::left, [](double t) { return Vector3(std::sin(t), 0, 0); });
    EXPECT_EQ(measure(slow_rate, "tremor", "left").absence, Absence::not_measured);
}

TEST(ForceSmoothness, NeedsForceInTheMovements) {
    Trace trace = make_trace(21.0);
    set_position(trace, Hand::left, reaches(8, 0.1, 1.0, 1.5));
    set_force(trace, Hand::left, [](double) { return Vector3::Zero(); });
    EXPECT_EQ(words_of(measure(trace, "f_sparc", "left").absent_because),
              "0 movements with force on tissue, fewer than 5");
    // A force that follows the position: its rate of change is a minimum-jerk speed profile too.
    const auto course = reaches(8, 0.1, 1.0, 1.5);
    set_force(trace, Hand::left, [&](double t) { return Vector3(30.0 * course(t)); });
    const MetricResult result = measure(trace, "f_sparc", "left");
    ASSERT_TRUE(result.value) << words_of(result.absent_because);
    EXPECT_NEAR(*result.value, -1.40243, 0.0014);  // sparc of 1001 samples at 1 kHz
}

}  // namespace
}  // namespace fulcrum
