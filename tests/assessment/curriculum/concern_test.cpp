// SPDX-License-Identifier: Apache-2.0
// Why an educator should look at a trainee: each reason, and that a trainee who is on track gives none.
#include "assessment/curriculum/concern.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fulcrum {
namespace {

constexpr std::int64_t a_day = 86'400'000, today = 20'000 * a_day;
constexpr double mark = 60;

TaskStanding stands(const std::string& task, Standing standing, int attempts = 0) {
    TaskStanding one;
    one.task = task;
    one.standing = standing;
    one.attempts = attempts;
    one.last_attempt = attempts > 0 ? today - a_day : 0;
    return one;
}

/// Points that rise from 20 to `plateau` with a rate of 0.5 and a small alternating error.
std::vector<double> rising_to(double plateau, int attempts) {
    std::vector<double> points;
    for (int i = 0; i < attempts; ++i)
        points.push_back(plateau + (20 - plateau) * std::exp(-0.5 * i) + (i % 2 == 0 ? 0.8 : -0.8));
    return points;
}

TEST(Concern, ATraineeOnTrackGivesNone) {
    const std::vector<TaskStanding> standings = {stands("A2", Standing::proficient, 20),
                                                 stands("B1", Standing::attempted, 9),
                                                 stands("C4", Standing::locked)};
    EXPECT_TRUE(concerns_of(standings, {{"B1", rising_to(90, 9)}}, today - a_day, mark, today).empty());
    EXPECT_TRUE(concerns_of({}, {}, 0, mark, today).empty());
}

TEST(Concern, ACurveThatLevelsOffBelowThePassMarkIsOneWithItsInterval) {
    const std::vector<TaskStanding> standings = {stands("B1", Standing::attempted, 16)};
    const std::vector<Concern> found =
        concerns_of(standings, {{"B1", rising_to(48, 16)}}, today - a_day, mark, today);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, ConcernKind::plateau);
    EXPECT_EQ(found[0].task, "B1");
    EXPECT_EQ(found[0].attempts, 16);
    EXPECT_NEAR(found[0].plateau, 48, 1);
    EXPECT_LT(found[0].low, found[0].plateau);
    EXPECT_GT(found[0].high, found[0].plateau);
    EXPECT_LT(found[0].high, mark);
    // The curve is through those with one class of devices that have points.
    const std::vector<Concern> of_two =
        concerns_of({stands("B1", Standing::attempted, 30)}, {{"B1", rising_to(48, 16)}}, today, mark, today);
    ASSERT_EQ(of_two.size(), 1U);
    EXPECT_EQ(of_two[0].attempts, 16);
    // Above the mark, too few attempts to tell, or proficient already: none.
    EXPECT_TRUE(concerns_of(standings, {{"B1", rising_to(75, 16)}}, today, mark, today).empty());
    EXPECT_TRUE(concerns_of(standings, {{"B1", rising_to(48, 7)}}, today, mark, today).empty());
    EXPECT_TRUE(
        concerns_of({stands("B1", Standing::proficient, 16)}, {{"B1", rising_to(48, 16)}}, today, mark, today)
            .empty());
}

TEST(Concern, PracticeThatStoppedIsOneWhileTasksAreLeft) {
    const std::vector<TaskStanding> left = {stands("A2", Standing::passed, 3)};
    EXPECT_TRUE(concerns_of(left, {}, today - stopped_days * a_day, mark, today).empty());
    const std::vector<Concern> found = concerns_of(left, {}, today - stopped_days * a_day - 1, mark, today);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, ConcernKind::stopped);
    EXPECT_EQ(found[0].task, "");
    EXPECT_EQ(found[0].since, today - stopped_days * a_day - 1);
    EXPECT_TRUE(concerns_of(left, {}, 0, mark, today).empty()) << "never began";
    EXPECT_TRUE(concerns_of({stands("A2", Standing::maintained, 30)}, {}, a_day, mark, today).empty())
        << "nothing is left to do";
}

TEST(Concern, RelapseOverdueChecksAndManyAttemptsComeInTheirOrder) {
    TaskStanding overdue = stands("A2", Standing::due, 12), stalled = stands("B1", Standing::attempted, 60);
    overdue.overdue = true;
    overdue.next_check = today - 20 * a_day;
    stalled.stalled = true;
    const std::vector<Concern> found = concerns_of({stalled, overdue, stands("B2", Standing::relapsed, 15)},
                                                   {}, today - 40 * a_day, mark, today);
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0].kind, ConcernKind::relapsed);
    EXPECT_EQ(found[0].task, "B2");
    EXPECT_EQ(found[1].kind, ConcernKind::check_overdue);
    EXPECT_EQ(found[1].since, overdue.next_check);
    EXPECT_EQ(found[2].kind, ConcernKind::stalled);
    EXPECT_EQ(found[2].attempts, 60);
    EXPECT_EQ(found[3].kind, ConcernKind::stopped);
    EXPECT_FALSE(found[1].provisional);
    overdue.provisional = true;
    const std::vector<Concern> provisional = concerns_of({overdue}, {}, today, mark, today);
    ASSERT_EQ(provisional.size(), 1U);
    EXPECT_TRUE(provisional[0].provisional);
    overdue.overdue = false;
    EXPECT_TRUE(concerns_of({overdue}, {}, today, mark, today).empty()) << "due, but not late yet";
}

}  // namespace
}  // namespace fulcrum
