// SPDX-License-Identifier: Apache-2.0
// The standing of a trainee: every state, the two-day rule, checks, relapse, decisions; and that it depends
// on nothing but what was recorded up to the moment.
#include "assessment/curriculum/standing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

#include "assessment/curriculum/concern.h"
#include "assessment/curriculum/recommendation.h"

namespace fulcrum {
namespace {

constexpr std::int64_t day = 86'400'000, noon = 43'200'000, hour = 3'600'000;
constexpr std::int64_t begin = 20'000 * day + noon;

/// A is in stage 1; B and C follow it in stage 2.
Curriculum example(const std::string& rule = "row:2") {
    Curriculum curriculum{"test", 1, "Test", {{"1", "First"}, {"2", "Second"}}, {}};
    const std::vector<DeviceClass> classes = {DeviceClass::haptic};
    curriculum.tasks.push_back({"A", "1", {}, parse_pass_rule(rule), classes});
    curriculum.tasks.push_back({"B", "2", {"A"}, parse_pass_rule("of:2,3"), classes});
    curriculum.tasks.push_back({"C", "2", {"A"}, parse_pass_rule("row:2"), classes});
    return curriculum;
}

class Trainee {
  public:
    explicit Trainee(const Curriculum& curriculum) { record.assignments.push_back({0, &curriculum}); }
    CountedAttempt& attempt(const std::string& task, std::int64_t time, bool passed) {
        CountedAttempt one;
        one.id = "attempt-" + std::to_string(record.attempts.size());
        one.task = task;
        one.time = time;
        one.passed = passed;
        record.attempts.push_back(one);
        return record.attempts.back();
    }
    TaskStanding at(const std::string& task, std::int64_t time) const {
        for (const TaskStanding& one : standing_of(record, time))
            if (one.task == task) return one;
        ADD_FAILURE() << task;
        return {};
    }
    /// Proficient in A since begin + 1 day.
    void become_proficient() {
        attempt("A", begin, true);
        attempt("A", begin + day, true);
    }
    PersonRecord record;
};

TEST(Standing, GoesFromLockedToProficientAndUnlocksWhatFollows) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    EXPECT_EQ(ann.at("A", begin).standing, Standing::open);
    EXPECT_EQ(ann.at("B", begin).standing, Standing::locked);
    EXPECT_EQ(ann.at("B", begin).waits_for, std::vector<std::string>{"A"});
    ann.attempt("B", begin, true);  // practised while locked: it never counts
    ann.attempt("A", begin + hour, false);
    EXPECT_EQ(ann.at("A", begin + hour - 1).standing, Standing::open);
    EXPECT_EQ(ann.at("A", begin + hour).standing, Standing::attempted);
    ann.attempt("A", begin + 2 * hour, true);
    EXPECT_EQ(ann.at("A", begin + 2 * hour).standing, Standing::passed);
    EXPECT_DOUBLE_EQ(ann.at("A", begin + 2 * hour).progress, 0.5);
    ann.attempt("A", begin + 3 * hour, true);
    EXPECT_EQ(ann.at("A", begin + 3 * hour).standing, Standing::passed) << "two passes on one day";
    EXPECT_TRUE(ann.at("A", begin + 3 * hour).one_more_day);
    ann.attempt("A", begin + day, true);
    EXPECT_EQ(ann.at("A", begin + day).standing, Standing::proficient);
    EXPECT_EQ(ann.at("A", begin + day).declared_at, begin + day);
    EXPECT_EQ(ann.at("B", begin + day).standing, Standing::open);
    EXPECT_EQ(ann.at("B", begin + day).attempts, 0);
}

TEST(Standing, LocalDatesCountNotUtc) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    // 23:30 and 00:30 UTC are 18:30 and 19:30 of one day in New York.
    ann.attempt("A", begin - noon + 23 * hour + hour / 2, true).utc_offset_minutes = -300;
    ann.attempt("A", begin - noon + 24 * hour + hour / 2, true).utc_offset_minutes = -300;
    EXPECT_EQ(ann.at("A", begin + 2 * day).standing, Standing::passed);
    for (CountedAttempt& one : ann.record.attempts) one.utc_offset_minutes = 0;
    EXPECT_EQ(ann.at("A", begin + 2 * day).standing, Standing::proficient);
}

TEST(Standing, LcCusumIsHeldAtItsLimitUntilASecondDay) {
    const Curriculum curriculum = example("lc-cusum:0.1,0.3,2.5");
    Trainee ann(curriculum);
    for (int i = 0; i < 9; ++i) ann.attempt("A", begin + i * 60'000, true);
    EXPECT_EQ(ann.at("A", begin + hour).standing, Standing::passed);
    EXPECT_NEAR(ann.at("A", begin + hour).progress, 9 * 0.251314 / 2.5, 1e-5);
    for (int i = 9; i < 40; ++i) ann.attempt("A", begin + i * 60'000, true);
    EXPECT_TRUE(ann.at("A", begin + hour).one_more_day);
    // A failure the next day costs as much as it does at the limit, however many passes went before.
    ann.attempt("A", begin + day, false);
    EXPECT_NEAR(ann.at("A", begin + day).progress, (2.5 - 1.098612) / 2.5, 1e-5);
    for (int i = 1; i <= 4; ++i) ann.attempt("A", begin + day + i * hour, true);
    EXPECT_EQ(ann.at("A", begin + day + 4 * hour).standing, Standing::passed);
    ann.attempt("A", begin + day + 5 * hour, true);
    EXPECT_EQ(ann.at("A", begin + day + 5 * hour).standing, Standing::proficient);
}

TEST(Standing, ARuleCanAskForPassesOnSeveralVariants) {
    Curriculum curriculum = example("of:2,3");
    curriculum.tasks[0].variants = 2;
    Trainee ann(curriculum);
    const auto pass = [&](std::int64_t time, const char* variant) {
        ann.attempt("A", time, true).variant = variant;
    };
    pass(begin, "standard");
    EXPECT_EQ(ann.at("A", begin).more_variants, 0) << "the rule itself is not met yet";
    pass(begin + day, "standard");
    EXPECT_EQ(ann.at("A", begin + day).standing, Standing::passed);
    EXPECT_EQ(ann.at("A", begin + day).more_variants, 1);
    EXPECT_FALSE(ann.at("A", begin + day).one_more_day);
    ann.attempt("A", begin + day + hour, false).variant = "narrow";
    EXPECT_EQ(ann.at("A", begin + day + hour).standing, Standing::passed) << "a failure shows nothing";
    pass(begin + 2 * day, "narrow");
    EXPECT_EQ(ann.at("A", begin + 2 * day).standing, Standing::proficient);
    EXPECT_EQ(ann.at("A", begin + 2 * day).declared_at, begin + 2 * day);

    Curriculum held = example("lc-cusum:0.1,0.3,2.5");
    held.tasks[0].variants = 2;
    Trainee ben(held);
    for (int i = 0; i < 20; ++i) ben.attempt("A", begin + i * day, true).variant = "standard";
    EXPECT_EQ(ben.at("A", begin + 20 * day).more_variants, 1) << "held at its limit";
    ben.attempt("A", begin + 20 * day, true).variant = "wide";
    EXPECT_EQ(ben.at("A", begin + 20 * day).standing, Standing::proficient);
}

TEST(Standing, ProvisionalLimitsUnlockButNeverDeclare) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    ann.attempt("A", begin, true).provisional = true;
    ann.attempt("A", begin + day, true).provisional = true;
    const TaskStanding a = ann.at("A", begin + day);
    EXPECT_EQ(a.standing, Standing::passed);
    EXPECT_TRUE(a.provisional);
    EXPECT_TRUE(a.met_provisionally);
    EXPECT_EQ(a.declared_at, 0);
    EXPECT_EQ(ann.at("B", begin + day).standing, Standing::open);
    ann.attempt("A", begin + 2 * day, true);
    ann.attempt("A", begin + 3 * day, true);
    EXPECT_EQ(ann.at("A", begin + 3 * day).standing, Standing::proficient);
}

TEST(Standing, OnceFirmLimitsJudgeATaskMetProvisionallyIsLeftToDo) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    ann.attempt("A", begin, true).provisional = true;
    ann.attempt("A", begin + day, true).provisional = true;
    const auto next = [&](std::int64_t at) {
        return recommend(curriculum, standing_of(ann.record, at), {}, DeviceClass::haptic);
    };
    EXPECT_EQ(next(begin + day).task, "B");
    ann.attempt("A", begin + 2 * day, false);
    TaskStanding a = ann.at("A", begin + 2 * day);
    EXPECT_EQ(a.standing, Standing::passed);
    EXPECT_TRUE(a.provisional) << "every pass so far";
    EXPECT_FALSE(a.met_provisionally);
    EXPECT_DOUBLE_EQ(a.progress, 0);
    EXPECT_EQ(ann.at("B", begin + 2 * day).standing, Standing::open) << "what is unlocked stays unlocked";
    EXPECT_EQ(next(begin + 2 * day).task, "A");
    EXPECT_EQ(next(begin + 2 * day).reason, RecommendationReason::longest_ago);
    Trainee ben = ann;
    ben.attempt("A", begin + 3 * day, true).provisional = true;
    EXPECT_TRUE(ben.at("A", begin + 3 * day).met_provisionally) << "provisional limits are in force again";
    ann.attempt("A", begin + 3 * day, true);
    a = ann.at("A", begin + 3 * day);
    EXPECT_FALSE(a.provisional);
    EXPECT_DOUBLE_EQ(a.progress, 0.5);
    ann.attempt("A", begin + 4 * day, true);
    EXPECT_EQ(ann.at("A", begin + 4 * day).standing, Standing::proficient);
}

TEST(Standing, ATaskMetProvisionallyCanStallOnFirmLimits) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    ann.attempt("A", begin, true).provisional = true;
    ann.attempt("A", begin + day, true).provisional = true;
    for (int i = 2; i < most_attempts; ++i) ann.attempt("A", begin + 2 * day + i * hour, false);
    const std::int64_t last = ann.record.attempts.back().time;
    EXPECT_TRUE(ann.at("A", last).stalled);
    const std::vector<Concern> concerns = concerns_of(standing_of(ann.record, last), {}, last, 60, last);
    ASSERT_EQ(concerns.size(), 1U);
    EXPECT_EQ(concerns[0].kind, ConcernKind::stalled);
    EXPECT_EQ(concerns[0].task, "A");
}

TEST(Standing, ACheckIsProvisionalWhereEveryPassWas) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    ann.attempt("A", begin, true).provisional = true;
    ann.record.overrides.push_back({"1", "A", StandingOverride::Kind::proficient, begin + day});
    EXPECT_EQ(ann.at("A", begin + 2 * day).standing, Standing::proficient);
    EXPECT_FALSE(ann.at("A", begin + 2 * day).provisional);
    ann.attempt("A", begin + 20 * day, true).provisional = true;
    ann.attempt("A", begin + 20 * day + hour, true).provisional = true;
    EXPECT_EQ(ann.at("A", begin + 21 * day).standing, Standing::due) << "they do not complete it";
    EXPECT_TRUE(ann.at("A", begin + 21 * day).provisional);
    Trainee ben = ann;
    ben.attempt("A", begin + 21 * day, false);
    EXPECT_EQ(ben.at("A", begin + 21 * day).standing, Standing::due);
    EXPECT_FALSE(ben.at("A", begin + 21 * day).provisional)
        << "firm limits judge it now: it can be completed";
    ann.attempt("A", begin + 21 * day, true);
    EXPECT_FALSE(ann.at("A", begin + 21 * day).provisional);
}

TEST(Standing, AFailureWhereNoLimitsApplyIsNeitherFirmNorProvisional) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    ann.attempt("A", begin, true).provisional = true;
    ann.attempt("A", begin + hour, false).without_limits = true;
    ann.attempt("A", begin + day, true).provisional = true;
    ann.attempt("A", begin + 2 * day, false).without_limits = true;
    EXPECT_TRUE(ann.at("A", begin + 2 * day).met_provisionally) << "the limits in use are still provisional";
    EXPECT_EQ(ann.at("A", begin + 2 * day).attempts, 4);
    Trainee ben(curriculum);
    ben.become_proficient();
    for (int i = 0; i < 3; ++i) ben.attempt("A", begin + 2 * day + i * hour, false).without_limits = true;
    EXPECT_EQ(ben.at("A", begin + 3 * day).standing, Standing::proficient);
}

TEST(Standing, ChecksComeDueAndAreMaintainedOrOverdue) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    ann.become_proficient();
    const std::int64_t declared = begin + day, first = declared + 14 * day;
    EXPECT_EQ(ann.at("A", first - 1).standing, Standing::proficient);
    EXPECT_EQ(ann.at("A", first).standing, Standing::due);
    EXPECT_FALSE(ann.at("A", first + 14 * day - 1).overdue);
    EXPECT_TRUE(ann.at("A", first + 14 * day).overdue);
    ann.attempt("A", first + hour, true);
    EXPECT_EQ(ann.at("A", first + hour).standing, Standing::due);
    ann.attempt("A", first + 2 * hour, false);
    ann.attempt("A", first + 3 * hour, true);
    EXPECT_EQ(ann.at("A", first + 3 * hour).standing, Standing::maintained);
    EXPECT_EQ(ann.at("A", first + 3 * hour).next_check, declared + 30 * day);
    EXPECT_EQ(ann.at("A", declared + 30 * day).standing, Standing::due);
    // Passes on two days do not complete a check.
    ann.attempt("A", declared + 30 * day + hour, true);
    ann.attempt("A", declared + 31 * day, true);
    EXPECT_EQ(ann.at("A", declared + 32 * day).standing, Standing::due);
    ann.attempt("A", declared + 31 * day + hour, true);
    EXPECT_EQ(ann.at("A", declared + 32 * day).next_check, declared + 91 * day);
    // After the last date of the schedule, every 182 days.
    ann.attempt("A", declared + 400 * day, true);
    ann.attempt("A", declared + 400 * day + hour, true);
    EXPECT_EQ(ann.at("A", declared + 401 * day).next_check, declared + (182 + 2 * 182) * day);
}

TEST(Standing, AFailedCheckIsARelapseAndThreeOfFourRegainIt) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    ann.become_proficient();
    const std::int64_t check = begin + 15 * day;
    ann.attempt("A", check, false);
    ann.attempt("A", check + hour, false);
    EXPECT_EQ(ann.at("A", check + hour).standing, Standing::relapsed);
    EXPECT_EQ(ann.at("B", check + hour).standing, Standing::open) << "what is unlocked stays unlocked";
    ann.attempt("A", check + 2 * hour, true);
    ann.attempt("A", check + 3 * hour, false);
    ann.attempt("A", check + 4 * hour, true);
    EXPECT_EQ(ann.at("A", check + 4 * hour).standing, Standing::relapsed);
    ann.attempt("A", check + 5 * hour, true);
    EXPECT_EQ(ann.at("A", check + 5 * hour).standing, Standing::proficient);
    EXPECT_EQ(ann.at("A", check + 5 * hour).next_check, check + 5 * hour + 14 * day);
}

TEST(Standing, ThreeFailuresBetweenChecksAreARelapse) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    ann.become_proficient();
    for (int i = 0; i < 2; ++i) ann.attempt("A", begin + 2 * day + i * hour, false);
    EXPECT_EQ(ann.at("A", begin + 3 * day).standing, Standing::proficient);
    ann.attempt("A", begin + 3 * day, false);
    EXPECT_EQ(ann.at("A", begin + 3 * day).standing, Standing::relapsed);
}

TEST(Standing, EducatorsUnlockAndDeclare) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    ann.record.overrides.push_back({"1", "B", StandingOverride::Kind::unlocked, begin});
    ann.record.overrides.push_back({"2", "A", StandingOverride::Kind::proficient, begin + day});
    EXPECT_EQ(ann.at("B", begin - 1).standing, Standing::locked);
    EXPECT_EQ(ann.at("B", begin).standing, Standing::open);
    EXPECT_TRUE(ann.at("B", begin).by_override);
    EXPECT_EQ(ann.at("C", begin).standing, Standing::locked);
    EXPECT_EQ(ann.at("A", begin + day).standing, Standing::proficient);
    EXPECT_TRUE(ann.at("A", begin + day).by_override);
    EXPECT_EQ(ann.at("C", begin + day).standing, Standing::open);
}

TEST(Standing, DeclarationsOutliveAChangeOfTheCurriculum) {
    const Curriculum easy = example("row:2"), strict = example("lc-cusum:0.05,0.2,6");
    Trainee ann(easy);
    ann.become_proficient();
    ann.record.assignments.push_back({begin + 2 * day, &strict});
    EXPECT_EQ(ann.at("A", begin + 3 * day).standing, Standing::proficient);
    Trainee ben(strict);
    ben.become_proficient();
    EXPECT_EQ(ben.at("A", begin + 3 * day).standing, Standing::passed);
}

TEST(Standing, AMoveComesIntoForceAtItsTime) {
    const Curriculum whole = example();
    Curriculum less = example();
    less.version = 2;
    less.tasks.pop_back();
    Trainee ann(whole);
    EXPECT_EQ(curriculum_at({}, begin), nullptr);
    // Recorded at a station whose clock is ahead.
    ann.record.assignments.push_back({begin + day, &less});
    EXPECT_EQ(curriculum_at(ann.record.assignments, begin), &whole);
    EXPECT_EQ(standing_of(ann.record, begin).size(), whole.tasks.size());
    EXPECT_EQ(curriculum_at(ann.record.assignments, begin + day), &less);
    EXPECT_EQ(standing_of(ann.record, begin + day).size(), less.tasks.size());
    EXPECT_EQ(curriculum_at(ann.record.assignments, -1), &whole) << "before the first one";
}

TEST(Standing, OtherDevicesDoNotCount) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    ann.attempt("A", begin, true).device_class = DeviceClass::mouse_keyboard;
    EXPECT_EQ(ann.at("A", begin).standing, Standing::open);
    ann.attempt("A", begin, true).device_class = DeviceClass::synthetic;
    EXPECT_EQ(ann.at("A", begin).standing, Standing::passed);
}

/// A random history of up to 60 records over a year, and a moment in it.
struct History {
    PersonRecord record;
    std::int64_t at = 0;
};
History random_history(const Curriculum& curriculum) {
    History history;
    history.record.assignments.push_back({0, &curriculum});
    const int attempts = *rc::gen::inRange(0, 60);
    for (int i = 0; i < attempts; ++i) {
        CountedAttempt one;
        one.id = "attempt-" + std::to_string(i);
        one.task = std::string(1, static_cast<char>('A' + *rc::gen::inRange(0, 3)));
        one.time = begin + *rc::gen::inRange(0, 365) * day + *rc::gen::inRange(0, 24) * hour;
        one.passed = *rc::gen::inRange(0, 10) < 8;
        one.provisional = *rc::gen::inRange(0, 10) == 0;
        one.without_limits = !one.passed && *rc::gen::inRange(0, 4) == 0;
        one.variant = *rc::gen::element<std::string>("standard", "narrow", "wide");
        one.voided_at = *rc::gen::inRange(0, 8) == 0 ? one.time + *rc::gen::inRange(0, 30) * day : 0;
        history.record.attempts.push_back(one);
    }
    const int overrides = *rc::gen::inRange(0, 4);
    for (int i = 0; i < overrides; ++i)
        history.record.overrides.push_back(
            {"override-" + std::to_string(i),
             std::string(1, static_cast<char>('A' + *rc::gen::inRange(0, 3))),
             *rc::gen::element(StandingOverride::Kind::proficient, StandingOverride::Kind::unlocked),
             begin + *rc::gen::inRange(0, 365) * day});
    history.at = begin + *rc::gen::inRange(0, 400) * day;
    return history;
}

bool same(const std::vector<TaskStanding>& a, const std::vector<TaskStanding>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(), [](const TaskStanding& x, const TaskStanding& y) {
            return x.task == y.task && x.standing == y.standing && x.attempts == y.attempts &&
                   x.passes == y.passes && x.progress == y.progress && x.declared_at == y.declared_at &&
                   x.next_check == y.next_check && x.met_provisionally == y.met_provisionally &&
                   x.one_more_day == y.one_more_day && x.one_more_pass == y.one_more_pass &&
                   x.more_variants == y.more_variants && x.first_declared_at == y.first_declared_at &&
                   x.last_attempt == y.last_attempt && x.first_attempt == y.first_attempt &&
                   x.first_pass == y.first_pass && x.waits_for == y.waits_for && x.overdue == y.overdue &&
                   x.provisional == y.provisional;
        });
}

RC_GTEST_PROP(StandingProperty, TheOrderOfInsertionChangesNothing, ()) {
    const Curriculum curriculum =
        example(*rc::gen::element<std::string>("row:2", "of:3,4", "lc-cusum:0.1,0.3,2.5"));
    const Curriculum next = example("row:3");
    History history = random_history(curriculum);
    history.record.assignments.push_back({begin + *rc::gen::inRange(0, 365) * day, &next});
    PersonRecord other = history.record;
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::shuffle(other.attempts.begin(), other.attempts.end(), random);
    std::shuffle(other.overrides.begin(), other.overrides.end(), random);
    std::shuffle(other.assignments.begin(), other.assignments.end(), random);
    RC_ASSERT(same(standing_of(history.record, history.at), standing_of(other, history.at)));
}

RC_GTEST_PROP(StandingProperty, WhatHappensLaterChangesNoEarlierState, ()) {
    const Curriculum curriculum = example();
    const History history = random_history(curriculum);
    PersonRecord until = history.record;
    until.attempts.erase(std::remove_if(until.attempts.begin(), until.attempts.end(),
                                        [&](const CountedAttempt& one) { return one.time > history.at; }),
                         until.attempts.end());
    for (CountedAttempt& one : until.attempts)
        if (one.voided_at > history.at) one.voided_at = 0;
    until.overrides.erase(std::remove_if(until.overrides.begin(), until.overrides.end(),
                                         [&](const StandingOverride& one) { return one.time > history.at; }),
                          until.overrides.end());
    RC_ASSERT(same(standing_of(history.record, history.at), standing_of(until, history.at)));
}

RC_GTEST_PROP(StandingProperty, AVoidedAttemptIsAsIfItHadNeverBeen, ()) {
    const Curriculum curriculum = example();
    History history = random_history(curriculum);
    if (history.record.attempts.empty()) return;
    const auto index =
        static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(history.record.attempts.size())));
    PersonRecord without = history.record;
    without.attempts.erase(without.attempts.begin() + static_cast<std::ptrdiff_t>(index));
    history.record.attempts[index].voided_at = history.at;
    RC_ASSERT(same(standing_of(history.record, history.at), standing_of(without, history.at)));
}

/// Whatever curriculum somebody is given later, and whether or not later attempts meet other limits.
RC_GTEST_PROP(StandingProperty, ADeclaredProficiencyIsNeverTakenBackByALaterCurriculumOrLimit, ()) {
    const Curriculum curriculum = example();
    History history = random_history(curriculum);
    for (CountedAttempt& one : history.record.attempts) one.voided_at = 0;
    const auto before = standing_of(history.record, history.at);
    const Curriculum strict =
        example(*rc::gen::element<std::string>("row:9", "of:8,9", "lc-cusum:0.05,0.2,6"));
    history.record.assignments.push_back({history.at + 1, &strict});
    for (CountedAttempt& one : history.record.attempts) {
        if (one.time <= history.at) continue;
        one.passed = false;
        one.provisional = *rc::gen::arbitrary<bool>();
    }
    const std::int64_t later = history.at + *rc::gen::inRange(1, 500) * day;
    const auto after = standing_of(history.record, later);
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i].declared_at == 0) continue;
        // Failed attempts alone lead to a relapse; one that was regained is declared later.
        if (after[i].standing != Standing::relapsed) RC_ASSERT(after[i].declared_at >= before[i].declared_at);
        RC_ASSERT(after[i].standing == Standing::proficient || after[i].standing == Standing::maintained ||
                  after[i].standing == Standing::due || after[i].standing == Standing::relapsed);
    }
}

RC_GTEST_PROP(StandingProperty, OnceUnlockedNeverLockedAgain, ()) {
    const Curriculum curriculum = example();
    History history = random_history(curriculum);
    for (CountedAttempt& one : history.record.attempts) one.voided_at = 0;
    const std::int64_t later = history.at + *rc::gen::inRange(0, 500) * day;
    const auto now = standing_of(history.record, history.at), then = standing_of(history.record, later);
    for (std::size_t i = 0; i < now.size(); ++i)
        RC_ASSERT(now[i].standing == Standing::locked || then[i].standing != Standing::locked);
}

TEST(Recommendation, NamesTheCheckThenTheRelapseThenTheLowestStage) {
    const Curriculum curriculum = example();
    Trainee ann(curriculum);
    std::map<std::string, std::int64_t> last;
    const auto next = [&](std::int64_t at, DeviceClass device = DeviceClass::haptic) {
        return recommend(curriculum, standing_of(ann.record, at), last, device);
    };
    EXPECT_EQ(next(begin).task, "A");
    EXPECT_EQ(next(begin).reason, RecommendationReason::not_tried);
    EXPECT_EQ(next(begin, DeviceClass::mouse_keyboard).reason, RecommendationReason::practice_only);
    ann.become_proficient();
    EXPECT_EQ(next(begin + day).task, "B");
    last["B"] = begin + day;  // practised
    EXPECT_EQ(next(begin + day).task, "C");
    last["C"] = begin + day + hour;
    EXPECT_EQ(next(begin + day + hour).task, "B");
    EXPECT_EQ(next(begin + day + hour).reason, RecommendationReason::longest_ago);
    EXPECT_EQ(next(begin + 16 * day).task, "A");
    EXPECT_EQ(next(begin + 16 * day).reason, RecommendationReason::check_due);
    for (int i = 0; i < 3; ++i) ann.attempt("A", begin + 2 * day + i * hour, false);
    EXPECT_EQ(next(begin + 3 * day).reason, RecommendationReason::relapsed);
    EXPECT_EQ(recommend(curriculum, {}, last, DeviceClass::haptic).reason, RecommendationReason::nothing);
    Trainee done(curriculum);
    done.become_proficient();
    for (const char* task : {"B", "C"})
        done.record.overrides.push_back({task, task, StandingOverride::Kind::proficient, begin + day});
    const auto all =
        recommend(curriculum, standing_of(done.record, begin + 2 * day), last, DeviceClass::haptic);
    EXPECT_EQ(all.reason, RecommendationReason::all_done);
    EXPECT_EQ(all.task, "A") << "performed when B was practised, and before C was";
}

}  // namespace
}  // namespace fulcrum
