// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/phase_alignment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fulcrum {
namespace {

Event happened(EventKind kind, double seconds, int detail = 0) {
    Event event;
    event.kind = kind;
    event.tick = static_cast<std::uint32_t>(std::lround(seconds * 1000));
    event.detail = detail;
    return event;
}

/// First movement, then goals 0, 1, … met at these times.
PhaseMoments attempt_of(double begin, const std::vector<double>& goals, double end, bool completed) {
    std::vector<Event> events{happened(EventKind::attempt_begin, 0),
                              happened(EventKind::first_movement, begin)};
    for (std::size_t i = 0; i < goals.size(); ++i)
        events.push_back(happened(EventKind::phase_end, goals[i], static_cast<int>(i)));
    events.push_back(happened(completed ? EventKind::completed : EventKind::abandoned, end));
    return phase_moments(events, 1e-3, end);
}

TEST(PhaseAlignment, GoalsMetInBothLieOnEachOtherAndTimeRunsEvenlyBetween) {
    const PhaseMap map(attempt_of(1, {3, 5}, 6, true), attempt_of(2, {4, 12}, 20, true));
    EXPECT_DOUBLE_EQ(map.to_second(1), 2);
    EXPECT_DOUBLE_EQ(map.to_second(2), 3);
    EXPECT_DOUBLE_EQ(map.to_second(3), 4);
    EXPECT_DOUBLE_EQ(map.to_second(4), 8);
    EXPECT_DOUBLE_EQ(map.to_second(5), 12);
    EXPECT_DOUBLE_EQ(map.to_second(6), 20);
    EXPECT_EQ(map.common_goals(), (std::vector<int>{0, 1}));
    for (const double t : {1.0, 1.7, 3.2, 5.9}) EXPECT_NEAR(map.to_first(map.to_second(t)), t, 1e-12) << t;
    EXPECT_DOUBLE_EQ(map.to_second(0.5), 1.5) << "before the first movement as fast in both";
}

TEST(PhaseAlignment, AnAttemptThatStoppedEarlierRunsOnAsFastFromTheLastGoalThatBothMet) {
    const PhaseMap map(attempt_of(0, {4}, 10, false), attempt_of(0, {2, 3}, 5, true));
    EXPECT_EQ(map.common_goals(), std::vector<int>{0});
    EXPECT_DOUBLE_EQ(map.to_second(4), 2);
    EXPECT_DOUBLE_EQ(map.to_second(6), 4);
    EXPECT_DOUBLE_EQ(map.to_second(9), 5) << "not beyond the record";
    EXPECT_DOUBLE_EQ(map.to_first(5), 7);
}

TEST(PhaseAlignment, PracticeFromALaterGoalBeginsWhereTheOtherAttemptBeganThatGoal) {
    PhaseMoments own = attempt_of(301, {}, 320, true);
    own.met[2] = 320;
    own.first_goal = 2;
    const PhaseMoments other = attempt_of(1, {100, 200, 330}, 331, true);
    const PhaseMap map(own, other);
    EXPECT_EQ(map.first_goal(), 2);
    EXPECT_EQ(map.common_goals(), std::vector<int>{2});
    EXPECT_DOUBLE_EQ(map.to_second(301), 200);
    EXPECT_DOUBLE_EQ(map.to_second(310.5), 265);
    EXPECT_DOUBLE_EQ(map.to_second(320), 330);
    EXPECT_DOUBLE_EQ(PhaseMap(other, own).to_first(310.5), 265) << "whichever of them is the first";
    EXPECT_DOUBLE_EQ(PhaseMap(other, own).to_second(265), 310.5);

    // One that never came to that goal has no such moment: the first movements are at the same moment.
    const PhaseMap apart(own, attempt_of(1, {100}, 150, false));
    EXPECT_EQ(apart.first_goal(), 0);
    EXPECT_TRUE(apart.common_goals().empty());
    EXPECT_DOUBLE_EQ(apart.to_second(301), 1);
    // Neither did both complete a goal here, but both began the third one.
    const PhaseMap begun(own, attempt_of(1, {100, 200}, 250, false));
    EXPECT_EQ(begun.first_goal(), 2);
    EXPECT_TRUE(begun.common_goals().empty());
    EXPECT_DOUBLE_EQ(begun.to_second(311), 210);
}

TEST(PhaseAlignment, NeverFallsWhateverTheOrderOfGoals) {
    PhaseMoments own = attempt_of(0, {2, 4, 6}, 8, true), other = own;
    other.met = {{0, 5}, {1, 3}, {2, 5}, {7, 1}};  // another order, a moment twice, an unknown goal
    const PhaseMap map(own, other);
    EXPECT_EQ(map.common_goals(), std::vector<int>{0});
    for (double t = 0; t < 8; t += 0.1) EXPECT_LE(map.to_second(t), map.to_second(t + 0.1)) << t;
    const PhaseMap nothing(PhaseMoments{}, PhaseMoments{});
    EXPECT_DOUBLE_EQ(nothing.to_second(3), 0);
}

TEST(PhaseAlignment, MeansOfAnotherAttemptOverThisOnesTime) {
    // The other one took twice as long for its only step: value = its time.
    const PhaseMoments own = attempt_of(0, {5}, 5, false), other = attempt_of(0, {10}, 10, false);
    std::vector<double> time;
    std::vector<float> value;
    for (int i = 0; i < 10000; ++i) {
        time.push_back(i * 1e-3);
        value.push_back(static_cast<float>(i * 1e-3));
    }
    const std::vector<float> means = aligned_means(PhaseMap(own, other), 5, 5, time, value);
    ASSERT_EQ(means.size(), 5U);
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(means[static_cast<std::size_t>(i)], 2 * i + 1, 1e-2) << i;
    // One that ended earlier has no value there; parts shorter than a sample have the latest one.
    const PhaseMoments brief = attempt_of(0, {}, 2, false);
    const std::vector<float> some = aligned_means(PhaseMap(own, brief), 5, 5, {0, 1.5}, {3, 4});
    EXPECT_FLOAT_EQ(some[0], 3);
    EXPECT_FLOAT_EQ(some[1], 4);
    EXPECT_TRUE(std::isnan(some[3]));
    const PhaseMap same(brief, brief);
    const std::vector<float> parts = aligned_means(same, 2, 200, {0, 0.05, 0.5}, {3, 4, 5});
    EXPECT_FLOAT_EQ(parts[3], 3);
    EXPECT_FLOAT_EQ(parts[12], 4);
    EXPECT_TRUE(std::isnan(parts[30])) << "the latest sample is older than 0.1 s";
    EXPECT_FLOAT_EQ(parts[50], 5);
}

TEST(PhaseAlignment, MeansHaveNoValueWhereTheOtherAttemptHasNone) {
    const PhaseMoments one = attempt_of(0, {10}, 10, false);
    std::vector<double> time;
    for (int i = 0; i <= 200; ++i) time.push_back(i * 0.01);
    for (int i = 800; i <= 900; ++i) time.push_back(i * 0.01);
    const std::vector<float> value(time.size(), 1.0F);
    const std::vector<float> means = aligned_means(PhaseMap(one, one), 10, 100, time, value);
    EXPECT_FLOAT_EQ(means[15], 1);
    EXPECT_TRUE(std::isnan(means[50])) << "between 2 and 8 s nothing was measured";
    EXPECT_FLOAT_EQ(means[85], 1);
    EXPECT_TRUE(std::isnan(means[95])) << "and nothing after 9 s";
}

TEST(PhaseAlignment, BandIsMedianAndMiddleHalfWhereEnoughHaveAValue) {
    const float none = std::nanf("");
    const std::vector<BandPoint> band = band_of({{1, 1}, {2, none}, {3, 3}, {4, none}, {5, 5}}, 10, 5);
    ASSERT_EQ(band.size(), 1U);
    EXPECT_DOUBLE_EQ(band[0].time, 2.5);
    EXPECT_DOUBLE_EQ(band[0].spread.low, 2);
    EXPECT_DOUBLE_EQ(band[0].spread.middle, 3);
    EXPECT_DOUBLE_EQ(band[0].spread.high, 4);
    EXPECT_DOUBLE_EQ(spread_of({1, 2}).middle, 1.5);
    EXPECT_EQ(spread_of({}).count, 0U);
    EXPECT_TRUE(band_of({}, 10, 5).empty());
}

}  // namespace
}  // namespace fulcrum
