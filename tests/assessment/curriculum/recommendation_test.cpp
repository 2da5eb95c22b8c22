// SPDX-License-Identifier: Apache-2.0
// What is recommended where a task cannot be completed: by provisional limits, or by anybody.
#include "assessment/curriculum/recommendation.h"

#include <gtest/gtest.h>

namespace fulcrum {
namespace {

constexpr std::int64_t next_day = 86'400'000, next_hour = 3'600'000;
constexpr std::int64_t next_begin = 20'000 * next_day + next_day / 2;

/// A, and B after it.
Curriculum two_steps(const std::string& rule = "row:2") {
    Curriculum curriculum{"test", 1, "Test", {{"1", "First"}, {"2", "Second"}}, {}};
    const std::vector<DeviceClass> classes = {DeviceClass::haptic, DeviceClass::tracked};
    curriculum.tasks.push_back({"A", "1", {}, parse_pass_rule(rule), classes});
    curriculum.tasks.push_back({"B", "2", {"A"}, parse_pass_rule("row:2"), classes});
    return curriculum;
}

class Recommended : public ::testing::Test {
  protected:
    explicit Recommended(const Curriculum& curriculum = two_steps()) : followed(curriculum) {
        record.assignments.push_back({0, &followed});
    }
    CountedAttempt& attempt(std::int64_t time, bool passed, DeviceClass device = DeviceClass::haptic) {
        CountedAttempt one;
        one.id = "attempt-" + std::to_string(record.attempts.size());
        one.task = "A";
        one.time = time;
        one.passed = passed;
        one.device_class = device;
        record.attempts.push_back(one);
        return record.attempts.back();
    }
    void decide(const char* task, std::int64_t time) {
        record.overrides.push_back({task, task, StandingOverride::Kind::proficient, time});
    }
    /// Of A.
    TaskStanding at(std::int64_t time) const { return standing_of(record, time).front(); }
    Recommendation next(std::int64_t time, DeviceClass device = DeviceClass::haptic) const {
        return recommend(followed, standing_of(record, time), {}, device);
    }
    Curriculum followed;
    PersonRecord record;
};

TEST_F(Recommended, ACheckThatProvisionalLimitsCannotCompleteHidesNothingElse) {
    attempt(next_begin, true);
    attempt(next_begin + next_day, true);
    const std::int64_t due = next_begin + 15 * next_day, later = due + 2 * next_hour;
    EXPECT_EQ(next(due).reason, RecommendationReason::check_due);
    attempt(due + next_hour, true).provisional = true;
    attempt(due + 2 * next_hour, true).provisional = true;
    EXPECT_EQ(at(later).standing, Standing::due) << "they do not complete it";
    EXPECT_TRUE(at(later).provisional) << "although firm limits judged a pass before";
    EXPECT_EQ(next(later).task, "B");
    EXPECT_EQ(next(later).reason, RecommendationReason::not_tried);
    EXPECT_EQ(next(later, DeviceClass::tracked).reason, RecommendationReason::check_due)
        << "whose limits may be firm";
    decide("B", later);
    EXPECT_EQ(next(later).reason, RecommendationReason::check_provisional) << "nothing else is left";
    EXPECT_EQ(next(later).task, "A");
    EXPECT_EQ(next(later).check, due);
    attempt(later + next_hour, true);
    EXPECT_FALSE(at(later + next_hour).provisional);
    EXPECT_EQ(next(later + next_hour).reason, RecommendationReason::check_due) << "firm limits judge it now";
    attempt(later + 2 * next_hour, true);
    EXPECT_EQ(at(later + 2 * next_hour).standing, Standing::maintained);
}

TEST_F(Recommended, TheLimitsOfTheDeviceInUseDecide) {
    attempt(next_begin, true);
    attempt(next_begin + next_day, true);
    const std::int64_t due = next_begin + 15 * next_day;
    for (int i = 0; i < 2; ++i) attempt(due + i * next_hour, true, DeviceClass::tracked).provisional = true;
    EXPECT_FALSE(at(due + next_hour).provisional) << "it can be completed";
    EXPECT_EQ(next(due + next_hour, DeviceClass::tracked).task, "B");
    EXPECT_EQ(next(due + next_hour).reason, RecommendationReason::check_due) << "by firm limits";
}

TEST_F(Recommended, TheClassWithFirmLimitsIsNamedToWhoeverHasTheOther) {
    attempt(next_begin, true);
    attempt(next_begin + next_day, true);
    decide("B", next_begin + 2 * next_day);
    const std::int64_t due = next_begin + 15 * next_day;
    attempt(due, true, DeviceClass::tracked).provisional = true;
    const std::vector<DeviceClass> haptic = {DeviceClass::haptic};
    EXPECT_EQ(at(due).firm_with, haptic);
    EXPECT_EQ(at(due).provisional_with, std::vector<DeviceClass>{DeviceClass::tracked});
    Recommendation check = next(due, DeviceClass::tracked);
    EXPECT_EQ(check.reason, RecommendationReason::check_elsewhere);
    EXPECT_EQ(check.task, "A");
    EXPECT_EQ(check.devices, haptic);
    EXPECT_TRUE(check.provisional_here);
    check = next(due, DeviceClass::mouse_keyboard);
    EXPECT_EQ(check.reason, RecommendationReason::check_elsewhere);
    EXPECT_EQ(check.devices, haptic) << "the others cannot complete it";
    EXPECT_FALSE(check.provisional_here) << "its attempts do not count at all";
    for (int i = 1; i <= 2; ++i) attempt(due + i * next_hour, false);
    const Recommendation lost = next(due + 2 * next_hour, DeviceClass::tracked);
    EXPECT_EQ(lost.reason, RecommendationReason::relapsed_elsewhere);
    EXPECT_EQ(lost.devices, haptic);
    EXPECT_FALSE(at(due + 2 * next_hour).provisional);
}

TEST_F(Recommended, ACheckCountsByTheLimitsThatAreInForceNow) {
    decide("A", next_begin);
    const std::int64_t due = next_begin + 14 * next_day, later = due + next_hour;
    attempt(due, true).provisional = true;
    EXPECT_EQ(next(due).task, "B");
    record.limits.push_back({"set", "A", DeviceClass::haptic, later, false});
    EXPECT_TRUE(at(later - 1).provisional) << "the past is not changed";
    EXPECT_FALSE(at(later).provisional);
    EXPECT_EQ(next(later).reason, RecommendationReason::check_due);
    attempt(later + next_hour, true);
    attempt(later + 2 * next_hour, true);
    EXPECT_EQ(at(later + 2 * next_hour).standing, Standing::maintained);
    // A variant with limits of its own says nothing about those of the standard variant.
    record.attempts.resize(1);
    attempt(later + next_hour, true).provisional = true;
    record.attempts.back().variant = "narrow";
    EXPECT_FALSE(at(later + next_hour).provisional);
    EXPECT_EQ(next(later + next_hour).reason, RecommendationReason::check_due);
    // What judges attempts since then says more: a limit that the set leaves provisional, for example.
    record.attempts.resize(1);
    attempt(later + next_hour, true).provisional = true;
    EXPECT_TRUE(at(later + next_hour).provisional);
}

TEST_F(Recommended, ProficiencyIsLeftToReachOnceFirmLimitsAreInForce) {
    attempt(next_begin, true).provisional = true;
    attempt(next_begin + next_day, true).provisional = true;
    const std::int64_t later = next_begin + 2 * next_day;
    EXPECT_TRUE(at(later).met_provisionally);
    EXPECT_EQ(next(later).task, "B");
    record.limits.push_back({"other", "A", DeviceClass::tracked, later, false});
    EXPECT_TRUE(at(later).met_provisionally) << "of another class than the one in use";
    record.limits.push_back({"set", "A", DeviceClass::haptic, later + 1, false});
    EXPECT_TRUE(at(later).met_provisionally) << "the past is not changed";
    EXPECT_FALSE(at(later + 1).met_provisionally);
    EXPECT_DOUBLE_EQ(at(later + 1).progress, 0);
    EXPECT_EQ(next(later + 1).task, "A");
    EXPECT_EQ(standing_of(record, later + 1).back().standing, Standing::open) << "what was unlocked stays";
    attempt(later + next_hour, true);
    attempt(later + next_day, true);
    EXPECT_EQ(at(later + next_day).standing, Standing::proficient);
}

TEST_F(Recommended, NoDeviceIsNamedWhoseLimitsAreProvisional) {
    decide("A", next_begin);
    decide("B", next_begin + next_day);
    const std::int64_t due = next_begin + 14 * next_day;
    attempt(due, true).provisional = true;
    attempt(due, true, DeviceClass::tracked).provisional = true;
    EXPECT_EQ(next(due, DeviceClass::mouse_keyboard).task, "A");
    EXPECT_EQ(next(due, DeviceClass::mouse_keyboard).reason, RecommendationReason::check_provisional);
    // Of a version that counts none of these classes nothing is known yet.
    Curriculum later = followed;
    later.version = 2;
    later.tasks[0].device_classes = {DeviceClass::mouse_keyboard};
    record.assignments.push_back({due + next_hour, &later});
    EXPECT_TRUE(at(due).provisional);
    EXPECT_FALSE(at(due + next_hour).provisional);
    EXPECT_EQ(recommend(later, standing_of(record, due + next_hour), {}, DeviceClass::mouse_keyboard).reason,
              RecommendationReason::check_due);
}

TEST_F(Recommended, ACheckOfADecisionThatProvisionalLimitsCannotCompleteHidesNothingElse) {
    decide("A", next_begin);
    const std::int64_t due = next_begin + 14 * next_day;
    EXPECT_EQ(next(due).reason, RecommendationReason::check_due) << "no limits have judged an attempt yet";
    attempt(due, true).provisional = true;
    EXPECT_EQ(next(due).task, "B");
}

TEST_F(Recommended, ARelapseThatProvisionalLimitsCannotEndHidesNothingElse) {
    attempt(next_begin, true);
    attempt(next_begin + next_day, true);
    for (int i = 1; i <= 3; ++i) attempt(next_begin + next_day + i * next_hour, false);
    const std::int64_t lost = next_begin + 2 * next_day;
    EXPECT_EQ(next(lost).reason, RecommendationReason::relapsed);
    EXPECT_FALSE(at(lost).provisional);
    for (int i = 0; i < 4; ++i) attempt(lost + i * next_hour, true).provisional = true;
    const std::int64_t later = lost + 3 * next_hour;
    EXPECT_EQ(at(later).standing, Standing::relapsed);
    EXPECT_TRUE(at(later).provisional);
    EXPECT_EQ(next(later).task, "B");
    decide("B", later);
    EXPECT_EQ(next(later).reason, RecommendationReason::check_provisional);
    EXPECT_EQ(next(later).check, 0);
    decide("A", later + next_hour);
    EXPECT_EQ(next(later + next_hour).reason, RecommendationReason::all_done);
}

TEST_F(Recommended, ACheckThatNeedsAnotherDeviceIsNamedBeforeEverythingIsDone) {
    attempt(next_begin, true);
    attempt(next_begin + next_day, true);
    decide("B", next_begin + 2 * next_day);
    const DeviceClass mouse = DeviceClass::mouse_keyboard;
    const std::int64_t due = next_begin + 15 * next_day;
    EXPECT_EQ(next(due - 1, mouse).reason, RecommendationReason::all_done);
    EXPECT_EQ(next(due, mouse).reason, RecommendationReason::check_elsewhere);
    EXPECT_EQ(next(due, mouse).task, "A");
    EXPECT_EQ(next(due, mouse).check, due);
    EXPECT_EQ(next(due, mouse).devices, followed.tasks[0].device_classes);
    for (int i = 0; i < 2; ++i) attempt(due + i * next_hour, false);
    const std::int64_t lost = due + next_hour;
    EXPECT_EQ(next(lost).reason, RecommendationReason::relapsed);
    EXPECT_EQ(next(lost, mouse).reason, RecommendationReason::relapsed_elsewhere);
    EXPECT_EQ(next(lost, mouse).task, "A");
}

class RecommendedNever : public Recommended {
  protected:
    RecommendedNever() : Recommended(two_steps("row:1")) {}
};

TEST_F(RecommendedNever, ATaskWhoseRuleNobodyCanMeetComesLast) {
    record.overrides.push_back({"1", "B", StandingOverride::Kind::unlocked, next_begin});
    for (int i = 0; i < 3; ++i) attempt(next_begin + i * next_day, true);
    const std::int64_t later = next_begin + 3 * next_day;
    EXPECT_TRUE(at(later).never_met);
    EXPECT_EQ(next(later).task, "B");
    decide("B", later);
    EXPECT_EQ(next(later).reason, RecommendationReason::rule_never_met);
    EXPECT_EQ(next(later).task, "A");
}

}  // namespace
}  // namespace fulcrum
