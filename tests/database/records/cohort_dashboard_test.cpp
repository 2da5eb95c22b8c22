// SPDX-License-Identifier: GPL-3.0-or-later
// The values behind the pictures of a cohort, on people whose days, attempts and checks are written by hand.
#include "database/records/cohort_dashboard.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fulcrum::database {
namespace {

constexpr std::int64_t dashboard_day_ms = 86'400'000;
constexpr std::int64_t dashboard_today = 20'787;  // Monday, 30 November 2026

Curriculum two_stages() {
    Curriculum curriculum;
    curriculum.id = "small";
    curriculum.stages = {{"A", "First"}, {"B", "Second"}};
    for (const auto& [task, stage] :
         std::vector<std::pair<std::string, std::string>>{{"A1", "A"}, {"A2", "A"}, {"B1", "B"}}) {
        CurriculumTask one;
        one.task = task;
        one.stage = stage;
        curriculum.tasks.push_back(one);
    }
    return curriculum;
}

PersonStandings someone(const std::string& id) {
    PersonStandings person;
    person.person_id = id;
    person.name = "Name of " + id;
    for (const char* task : {"A1", "A2", "B1"}) {
        PersonTask one;
        one.standing.task = task;
        one.standing.standing = Standing::open;
        person.tasks.push_back(one);
    }
    return person;
}

void tried(PersonTask& task, std::int64_t first, std::int64_t pass, Standing standing) {
    task.first_attempt = first * dashboard_day_ms;
    task.first_pass = pass * dashboard_day_ms;
    task.standing.standing = standing;
    if (standing == Standing::proficient || standing == Standing::due)
        task.standing.declared_at = task.standing.first_declared_at = pass * dashboard_day_ms;
}

/// Ann is done with stage A and has a check overdue, Ben has begun, Cyd has never practised.
std::vector<PersonStandings> three_people() {
    PersonStandings ann = someone("ann"), ben = someone("ben"), cyd = someone("cyd");
    ann.days = {{dashboard_today - 70, 2}, {dashboard_today - 8, 3}, {dashboard_today - 2, 1}};
    ann.begun = dashboard_today - 70;
    tried(ann.tasks[0], dashboard_today - 70, dashboard_today - 60, Standing::due);
    ann.tasks[0].standing.overdue = true;
    ann.tasks[0].standing.next_check = (dashboard_today - 20) * dashboard_day_ms;
    tried(ann.tasks[1], dashboard_today - 70, dashboard_today - 50, Standing::proficient);
    ann.tasks[1].standing.next_check = (dashboard_today + 9) * dashboard_day_ms;
    ben.days = {{dashboard_today - 7, 4}, {dashboard_today, 1}};
    ben.begun = dashboard_today - 7;
    tried(ben.tasks[0], dashboard_today - 7, 0, Standing::attempted);
    return {ann, ben, cyd};
}

DashboardOptions noon() {
    return {dashboard_today * dashboard_day_ms + dashboard_day_ms / 2, 0, 10};
}

TEST(CohortDashboard, CountsPlanWeeksChecksAndStagesAsTheyAre) {
    const CohortDashboard dashboard = dashboard_of(three_people(), two_stages(), noon());
    EXPECT_EQ(dashboard.people, 3);
    ASSERT_EQ(dashboard.plan.size(), 2U);
    EXPECT_DOUBLE_EQ(dashboard.plan[0].weeks, 10);
    EXPECT_EQ(dashboard.plan[0].done, 2);
    EXPECT_DOUBLE_EQ(dashboard.plan[0].planned, 3) << "the plan ends after ten weeks";
    EXPECT_TRUE(dashboard.plan[0].behind());
    EXPECT_DOUBLE_EQ(dashboard.plan[1].planned, 0.3);
    EXPECT_FALSE(dashboard.plan[1].behind()) << "a part of a task is not yet a task";
    ASSERT_EQ(dashboard.not_begun.size(), 1U);
    EXPECT_EQ(dashboard.not_begun[0].person, 2U);

    ASSERT_EQ(dashboard.weeks.size(), 12U);
    EXPECT_EQ(dashboard.weeks.back().monday, dashboard_today);
    EXPECT_EQ(dashboard.weeks[11].attempts, 1);
    EXPECT_EQ(dashboard.weeks[10].attempts, 1 + 4) << "Saturday of Ann, Monday of Ben";
    EXPECT_EQ(dashboard.weeks[10].people.size(), 2U);
    EXPECT_EQ(dashboard.weeks[9].attempts, 3);
    EXPECT_EQ(dashboard.weeks[1].attempts, 2) << "ten weeks ago";
    EXPECT_EQ(dashboard.weeks[9].people[0].count, 3);

    ASSERT_EQ(dashboard.checks.size(), 2U + dashboard_weeks_ahead + 1U);
    ASSERT_EQ(dashboard.checks[0].checks.size(), 1U) << "overdue";
    EXPECT_EQ(dashboard.checks[0].checks[0].task, "A1");
    EXPECT_TRUE(dashboard.checks[1].checks.empty());
    ASSERT_EQ(dashboard.checks[3].checks.size(), 1U) << "in the second week ahead";
    EXPECT_EQ(dashboard.checks[3].checks[0].task, "A2");

    ASSERT_EQ(dashboard.stages.size(), 4U);
    EXPECT_EQ(dashboard.stages[0].people.size(), 2U) << "A begun";
    EXPECT_EQ(dashboard.stages[1].people.size(), 1U) << "A done";
    EXPECT_TRUE(dashboard.stages[2].people.empty()) << "B begun";
    EXPECT_EQ(dashboard.waiting_to_pass[0].size(), 1U);
    EXPECT_EQ(dashboard.waiting_for_proficiency[1].size(), 0U);
}

TEST(CohortDashboard, PassRatesAndCurvesAreThoseOfTheOverview) {
    const std::vector<PersonStandings> people = three_people();
    const CohortDashboard dashboard = dashboard_of(people, two_stages(), noon());
    const std::vector<TaskOverview> overview = overview_of(people, noon().at);
    ASSERT_EQ(dashboard.overview.size(), 3U);
    for (std::size_t t = 0; t < 3; ++t) {
        EXPECT_EQ(dashboard.overview[t].attempted, overview[t].attempted);
        EXPECT_EQ(dashboard.overview[t].passed, overview[t].passed);
    }
    // Ann passed A1 after 10 days with two at risk: half were there from then on.
    ASSERT_EQ(dashboard.overview[0].pass_curve.size(), 1U);
    EXPECT_DOUBLE_EQ(dashboard.overview[0].pass_curve[0].time, 10);
    EXPECT_DOUBLE_EQ(dashboard.overview[0].pass_curve[0].waiting, 0) << "Ben was observed for a week only";
    EXPECT_DOUBLE_EQ(dashboard.overview[0].longest_days, 10);
}

AttemptSummary counting_attempt(std::int64_t day, bool passed) {
    AttemptSummary one;
    one.meta.id = "attempt-" + std::to_string(day);
    one.meta.task_id = "A1";
    one.meta.started = day * dashboard_day_ms;
    one.meta.device_class = DeviceClass::haptic;
    one.recorded_state = one.state = AttemptState::completed;
    one.counting = true;
    one.passed = passed;
    return one;
}

TEST(CohortDashboard, TimeToProficiencyEndsWithTheFirstDeclarationWhateverRelapseFollows) {
    Curriculum curriculum = two_stages();
    for (CurriculumTask& task : curriculum.tasks) {
        task.rule = parse_pass_rule("row:2");
        task.device_classes = {DeviceClass::haptic};
    }
    const std::int64_t first = dashboard_today - 100;
    std::vector<AttemptSummary> attempts = {counting_attempt(first, true),
                                            counting_attempt(first + 10, true)};
    // Two failures on the day of a check, which is due 14 days after the declaration.
    for (int i = 0; i < 2; ++i) {
        attempts.push_back(counting_attempt(first + 30, false));
        attempts.back().meta.id += i == 0 ? "-a" : "-b";
        attempts.back().meta.started += i * 3'600'000;
    }
    const auto expect_ten_days = [&](Standing standing) {
        const std::vector<PersonStandings> people = {person_standings(attempts, {}, curriculum, noon().at)};
        ASSERT_EQ(people[0].tasks[0].standing.standing, standing);
        const CohortDashboard dashboard = dashboard_of(people, curriculum, noon());
        ASSERT_TRUE(dashboard.overview[0].days_to_proficiency.median);
        EXPECT_DOUBLE_EQ(*dashboard.overview[0].days_to_proficiency.median, 10);
        EXPECT_TRUE(dashboard.waiting_for_proficiency[0].empty());
    };
    expect_ten_days(Standing::relapsed);
    for (int i = 0; i < 3; ++i) attempts.push_back(counting_attempt(dashboard_today - 3 + i, true));
    expect_ten_days(Standing::proficient);
}

/// Two passes in a row on two days; B1 is unlocked by A1.
Curriculum with_b1_after_a1() {
    Curriculum curriculum = two_stages();
    for (CurriculumTask& task : curriculum.tasks) {
        task.rule = parse_pass_rule("row:2");
        task.device_classes = {DeviceClass::haptic};
    }
    curriculum.tasks[2].after = {"A1"};
    return curriculum;
}

AttemptSummary attempt_at_b1(std::int64_t day, bool passed, double points) {
    AttemptSummary one = counting_attempt(day, passed);
    one.meta.id += "-b1";
    one.meta.task_id = "B1";
    one.points = points;
    return one;
}

TEST(CohortDashboard, WhatWasPerformedWhileATaskWasLockedIsNotInItsTables) {
    const Curriculum curriculum = with_b1_after_a1();
    const std::int64_t first = dashboard_today - 10;
    // A1, which unlocked it, turned out to be another person's and was voided.
    std::vector<AttemptSummary> attempts = {attempt_at_b1(first + 2, true, 70)};
    const auto dashboard_with = [&](std::vector<PersonStandings>& people) {
        people = {person_standings(attempts, {}, curriculum, noon().at)};
        return dashboard_of(people, curriculum, noon());
    };
    std::vector<PersonStandings> people;
    CohortDashboard dashboard = dashboard_with(people);
    const PersonTask& locked = people[0].tasks[2];
    EXPECT_EQ(locked.standing.standing, Standing::locked);
    EXPECT_EQ(locked.first_attempt, 0);
    EXPECT_EQ(locked.first_pass, 0);
    EXPECT_FALSE(locked.device_class);
    EXPECT_TRUE(locked.recent.empty());
    EXPECT_EQ(dashboard.overview[2].attempted, 0);
    EXPECT_EQ(dashboard.overview[2].passed, 0);
    EXPECT_TRUE(dashboard.waiting_for_proficiency[2].empty());
    EXPECT_TRUE(dashboard.stages[2].people.empty()) << "stage B is not begun";

    attempts.push_back(counting_attempt(first, true));
    attempts.push_back(counting_attempt(first + 1, true));
    attempts.push_back(attempt_at_b1(first + 4, false, 70));
    dashboard = dashboard_with(people);
    const PersonTask& open = people[0].tasks[2];
    EXPECT_EQ(open.standing.attempts, 2);
    EXPECT_EQ(open.first_attempt, (first + 2) * dashboard_day_ms);
    EXPECT_EQ(open.first_pass, (first + 2) * dashboard_day_ms);
    EXPECT_EQ(open.recent.size(), 2U);
    EXPECT_EQ(dashboard.overview[2].attempted, 1);
    EXPECT_EQ(dashboard.overview[2].passed, 1);
    ASSERT_EQ(dashboard.waiting_for_proficiency[2].size(), 1U);
}

TEST(CohortDashboard, ATaskThatIsOpenAgainShowsWhatWasPerformedSince) {
    const Curriculum curriculum = with_b1_after_a1();
    const std::int64_t first = dashboard_today - 10;
    // While it was locked: a curve that levels off below the pass mark.
    std::vector<AttemptSummary> attempts;
    for (int i = 0; i < 16; ++i)
        attempts.push_back(
            attempt_at_b1(first - 20 + i, false, 48 - 28 * std::exp(-0.5 * i) + (i % 2 == 0 ? 0.8 : -0.8)));
    attempts.push_back(counting_attempt(first, true));
    attempts.push_back(counting_attempt(first + 1, true));
    EXPECT_TRUE(person_standings(attempts, {}, curriculum, noon().at).tasks[2].recent.empty());
    attempts.push_back(attempt_at_b1(first + 4, false, 48));
    PersonStandings person = person_standings(attempts, {}, curriculum, noon().at);
    EXPECT_EQ(person.tasks[2].standing.standing, Standing::attempted);
    EXPECT_EQ(person.tasks[2].standing.attempts, 1);
    EXPECT_EQ(person.tasks[2].first_attempt, (first + 4) * dashboard_day_ms);
    EXPECT_EQ(person.tasks[2].device_class, DeviceClass::haptic);
    ASSERT_EQ(person.tasks[2].recent.size(), 1U);
    EXPECT_EQ(person.tasks[2].recent[0].attempt_id, attempts.back().meta.id);
    EXPECT_TRUE(person.concerns.empty()) << "one attempt is no plateau";
    // The same attempts in a task that was never locked are one.
    Curriculum open = curriculum;
    open.tasks[2].after.clear();
    person = person_standings(attempts, {}, open, noon().at);
    EXPECT_EQ(person.tasks[2].standing.attempts, 17);
    EXPECT_EQ(person.tasks[2].recent.size(), most_recent);
    ASSERT_EQ(person.concerns.size(), 1U);
    EXPECT_EQ(person.concerns[0].kind, ConcernKind::plateau);
}

TEST(CohortDashboard, AMoveAheadOfTheClockIsNotYetFollowed) {
    Curriculum whole = two_stages();
    for (CurriculumTask& task : whole.tasks) task.device_classes = {DeviceClass::haptic};
    Curriculum less = whole;
    less.version = 2;
    less.tasks.erase(less.tasks.begin());  // A1
    const std::vector<AttemptSummary> attempts = {counting_attempt(dashboard_today - 1, true)};
    const std::vector<CurriculumAssignment> followed = {{0, &whole}, {noon().at + 3'600'000, &less}};
    const PersonStandings now = person_standings(attempts, {}, whole, noon().at, followed);
    EXPECT_EQ(now.curriculum, whole.name());
    ASSERT_EQ(now.tasks.size(), 3U);
    EXPECT_EQ(now.tasks[0].standing.standing, Standing::passed);
    EXPECT_EQ(now.tasks[0].recent.size(), 1U);
    const PersonStandings later =
        person_standings(attempts, {}, whole, noon().at + 2 * std::int64_t{3'600'000}, followed);
    EXPECT_EQ(later.curriculum, less.name());
    EXPECT_EQ(later.tasks[0].standing.standing, Standing::locked) << "the person's version lacks it";
}

TEST(CohortDashboard, AnImportedRecordingMovesNeitherThePlanNorTheConcerns) {
    Curriculum curriculum = two_stages();
    for (CurriculumTask& task : curriculum.tasks) task.device_classes = {DeviceClass::haptic};
    const auto imported = [](std::int64_t day) {
        AttemptSummary one = counting_attempt(day, false);
        one.meta.task_id = "external-peg-transfer";
        one.meta.device_class = DeviceClass::external;
        one.counting = false;
        one.passed.reset();
        return one;
    };
    const auto standings = [&](const std::vector<AttemptSummary>& attempts) {
        return person_standings(attempts, {}, curriculum, noon().at);
    };
    const std::int64_t long_ago = dashboard_today - 365, yesterday = dashboard_today - 1;
    const std::vector<PersonStandings> people = {
        standings({imported(long_ago), counting_attempt(yesterday, true)}), standings({imported(long_ago)}),
        standings({counting_attempt(dashboard_today - 30, true), imported(yesterday)})};
    const CohortDashboard dashboard = dashboard_of(people, curriculum, noon());
    ASSERT_EQ(dashboard.plan.size(), 2U);
    EXPECT_LT(dashboard.plan[0].weeks, 1);
    EXPECT_FALSE(dashboard.plan[0].behind());
    ASSERT_EQ(dashboard.not_begun.size(), 1U);
    EXPECT_EQ(dashboard.not_begun[0].person, 1U);
    EXPECT_TRUE(people[1].concerns.empty()) << "who never began has not stopped";
    EXPECT_EQ(people[1].days.size(), 1U) << "the calendar shows it";
    ASSERT_EQ(people[2].concerns.size(), 1U) << "a recording from elsewhere is no practice here";
    EXPECT_EQ(people[2].concerns[0].kind, ConcernKind::stopped);
}

TEST(CohortDashboard, HasTheChecksOfTasksThatOnlyThePersonsOwnVersionHas) {
    Curriculum older = two_stages();
    for (CurriculumTask& task : older.tasks) {
        task.rule = parse_pass_rule("row:2");
        task.device_classes = {DeviceClass::haptic};
    }
    Curriculum newest = older;
    newest.version = 2;
    newest.tasks.erase(newest.tasks.begin());  // A1
    const std::vector<AttemptSummary> attempts = {counting_attempt(dashboard_today - 100, true),
                                                  counting_attempt(dashboard_today - 99, true),
                                                  counting_attempt(dashboard_today - 1, true)};
    const std::vector<CurriculumAssignment> followed = {{0, &older}};
    const std::vector<PersonStandings> people = {person_standings(attempts, {}, newest, noon().at, followed)};
    EXPECT_EQ(people[0].tasks.size(), newest.tasks.size()) << "as everybody's";
    ASSERT_EQ(people[0].own_tasks.size(), 1U);
    EXPECT_EQ(people[0].own_tasks[0].standing.standing, Standing::due);
    EXPECT_EQ(people[0].own_tasks[0].recent.size(), 3U);
    const CohortDashboard dashboard = dashboard_of(people, newest, noon());
    EXPECT_EQ(dashboard.tasks, 2);
    ASSERT_EQ(people[0].concerns.size(), 1U);
    EXPECT_EQ(people[0].concerns[0].kind, ConcernKind::check_overdue);
    ASSERT_EQ(dashboard.checks[0].checks.size(), 1U) << "one for each such concern";
    EXPECT_EQ(dashboard.checks[0].checks[0].task, "A1");
}

TEST(CohortDashboard, BarsAreThoseThatTheVersionOfTheirTimeCountedWhateverMoveFollows) {
    Curriculum mouse_too = two_stages();
    for (CurriculumTask& task : mouse_too.tasks)
        task.device_classes = {DeviceClass::haptic, DeviceClass::mouse_keyboard};
    Curriculum haptic_only = mouse_too;
    haptic_only.version = 2;
    for (CurriculumTask& task : haptic_only.tasks) task.device_classes = {DeviceClass::haptic};
    std::vector<AttemptSummary> attempts;
    for (int i = 0; i < 4; ++i) {
        attempts.push_back(counting_attempt(dashboard_today - 10 + i, i == 3));
        if (i > 0) attempts.back().meta.device_class = DeviceClass::mouse_keyboard;
    }
    const std::int64_t moved = (dashboard_today - 2) * dashboard_day_ms;
    const std::vector<CurriculumAssignment> to_less = {{0, &mouse_too}, {moved, &haptic_only}};
    PersonStandings person = person_standings(attempts, {}, haptic_only, noon().at, to_less);
    EXPECT_EQ(person.tasks[0].standing.attempts, 4);
    EXPECT_EQ(person.tasks[0].device_class, DeviceClass::mouse_keyboard);
    EXPECT_EQ(person.tasks[0].recent.size(), 3U) << "of the class used last, as they counted then";
    EXPECT_TRUE(person.uncounted.empty());
    const std::vector<CurriculumAssignment> to_more = {{0, &haptic_only}, {moved, &mouse_too}};
    person = person_standings(attempts, {}, mouse_too, noon().at, to_more);
    EXPECT_EQ(person.tasks[0].standing.attempts, 1);
    EXPECT_EQ(person.tasks[0].device_class, DeviceClass::haptic);
    EXPECT_EQ(person.tasks[0].recent.size(), 1U);
    EXPECT_EQ(person.uncounted.size(), 3U);
}

TEST(CohortDashboard, LeavesDeactivatedPeopleOutOfAllThatAsksSomebodyToDoSomething) {
    std::vector<PersonStandings> people = three_people();
    people[0].active = people[2].active = false;  // ann, whose check is overdue, and cyd
    const CohortDashboard dashboard = dashboard_of(people, two_stages(), noon());
    EXPECT_EQ(dashboard.people, 1);
    ASSERT_EQ(dashboard.plan.size(), 1U);
    EXPECT_EQ(dashboard.plan[0].person, 1U);
    EXPECT_TRUE(dashboard.not_begun.empty());
    for (const CheckSlot& slot : dashboard.checks) EXPECT_TRUE(slot.checks.empty());
    EXPECT_EQ(dashboard.stages[0].people.size(), 1U) << "A begun";
    EXPECT_TRUE(dashboard.stages[1].people.empty()) << "A done";
    EXPECT_EQ(dashboard.overview[0].people.size(), 1U) << "only ben has a standing today";
    EXPECT_EQ(dashboard.overview[0].attempted, 2) << "what was performed stays";
    EXPECT_EQ(dashboard.weeks[10].attempts, 1 + 4);
}

TEST(CohortDashboard, IsEmptyWithoutPeopleAndTakesAnyPlan) {
    const CohortDashboard dashboard = dashboard_of({}, two_stages(), {0, 0, -5});
    EXPECT_EQ(dashboard.people, 0);
    EXPECT_EQ(dashboard.plan_weeks, 1);
    EXPECT_TRUE(dashboard.weeks.empty());
    // East of Greenwich it is Tuesday already.
    DashboardOptions late = noon();
    late.utc_offset_min = 14 * 60;
    EXPECT_EQ(dashboard_of(three_people(), two_stages(), late).weeks.back().monday, dashboard_today);
    late.utc_offset_min = -14 * 60;
    EXPECT_EQ(dashboard_of(three_people(), two_stages(), late).weeks.back().monday, dashboard_today - 7);
}

}  // namespace
}  // namespace fulcrum::database
