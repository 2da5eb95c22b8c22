// SPDX-License-Identifier: GPL-3.0-or-later
// Personal goals: how far a goal is, what is refused, that a change keeps what was set before, and that the
// administrator learns nothing of them.
#include "database/records/goals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "database/store/audit.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database {
namespace {

using test::error_kind;
using test::Programme;

constexpr std::int64_t goal_monday = 20'003;  // 2024-10-07, a Monday

GoalWish three_a_week(const std::string& task = "") {
    return {GoalOf::attempts, task, "", 3, 0};
}
GoalWish path_below(double target, std::int64_t due) {
    return {GoalOf::metric, "A2", "path_len", target, due};
}
GoalAttempt attempt_on(std::int64_t day, std::optional<double> value = {}) {
    return {day * 86'400'000, day, value};
}

TEST(GoalProgress, CountsTheAttemptsFromMondayToSunday) {
    const PersonalGoal goal{"g", "p", three_a_week(), 0};
    const std::vector<GoalAttempt> attempts = {attempt_on(goal_monday - 1), attempt_on(goal_monday),
                                               attempt_on(goal_monday + 6), attempt_on(goal_monday + 7)};
    const GoalProgress tuesday = goal_progress(goal, attempts, goal_monday + 1, false);
    EXPECT_EQ(tuesday.done, 2);
    EXPECT_EQ(tuesday.days_left, 6);
    EXPECT_NEAR(tuesday.share, 2.0 / 3, 1e-12);
    EXPECT_FALSE(tuesday.reached);
    EXPECT_EQ(goal_progress(goal, attempts, goal_monday + 6, false).days_left, 1) << "Sunday is the last day";
    EXPECT_EQ(goal_progress(goal, attempts, goal_monday + 7, false).done, 1) << "the next week";
    EXPECT_EQ(goal_progress(goal, attempts, goal_monday - 1, false).done, 1) << "the week before";
    std::vector<GoalAttempt> many(5, attempt_on(goal_monday));
    EXPECT_TRUE(goal_progress(goal, many, goal_monday, false).reached);
    EXPECT_EQ(goal_progress(goal, many, goal_monday, false).share, 1);
}

TEST(GoalProgress, OfAMetricIsThePartOfTheWayFromWhereTheTraineeWas) {
    const PersonalGoal goal{"g", "p", path_below(800, 110), 100 * std::int64_t{86'400'000}};
    std::vector<GoalAttempt> attempts = {attempt_on(90, 700), attempt_on(99, 1000)};
    const GoalProgress none = goal_progress(goal, attempts, 105, false);
    EXPECT_EQ(none.start, 1000) << "the latest before, not the best";
    EXPECT_FALSE(none.best);
    EXPECT_EQ(none.share, 0);
    EXPECT_EQ(none.days_left, 6);
    attempts.push_back(attempt_on(102, 900));
    attempts.push_back(attempt_on(103, 950));
    attempts.push_back(attempt_on(104));  // not completed
    EXPECT_EQ(goal_progress(goal, attempts, 105, false).best, 900);
    EXPECT_NEAR(goal_progress(goal, attempts, 105, false).share, 0.5, 1e-12);
    attempts.push_back(attempt_on(111, 790));
    EXPECT_FALSE(goal_progress(goal, attempts, 111, false).reached) << "after the day";
    EXPECT_TRUE(goal_progress(goal, attempts, 111, false).missed);
    EXPECT_FALSE(goal_progress(goal, attempts, 110, false).missed) << "the day itself counts";
    attempts.push_back(attempt_on(110, 800));
    EXPECT_TRUE(goal_progress(goal, attempts, 200, false).reached) << "stays reached, and at most is enough";
    EXPECT_EQ(goal_progress(goal, attempts, 200, false).share, 1);
}

TEST(GoalProgress, GrowsUpwardsWhereHigherIsBetter) {
    PersonalGoal goal{"g", "p", path_below(80, 110), 100 * std::int64_t{86'400'000}};
    const std::vector<GoalAttempt> attempts = {attempt_on(99, 40), attempt_on(101, 70), attempt_on(102, 60)};
    EXPECT_EQ(goal_progress(goal, attempts, 105, true).best, 70);
    EXPECT_NEAR(goal_progress(goal, attempts, 105, true).share, 0.75, 1e-12);
    goal.wish.target = 65;
    EXPECT_TRUE(goal_progress(goal, attempts, 105, true).reached);
    // Worse than before: nothing of the way, never less.
    goal.wish.target = 100;
    EXPECT_EQ(goal_progress(goal, {attempt_on(99, 40), attempt_on(101, 30)}, 105, true).share, 0);
}

TEST(PersonalGoals, AreSetChangedAndDroppedByTheirOwnerAndReadByEducators) {
    const Programme programme;
    const Goals goals(*programme.store);
    const Session& ann = programme.session("ann");
    const std::int64_t today = day_at(programme.store->now(), 0);
    const std::string weekly = goals.set(ann, three_a_week("A2"), today);
    programme.record("ann");
    programme.record("ann", false, 10);
    programme.record("ann", true, 70, "B1");
    programme.attempts().void_attempt(programme.session("educator"), programme.record("ann"), "by mistake");
    std::vector<GoalProgress> seen =
        goals.progress(programme.session("educator"), programme.id("ann"), today);
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_EQ(seen[0].done, 2) << "of the task, without the voided one";
    EXPECT_EQ(goals.latest_value(ann, programme.id("ann"), "A2", "path_len"), 812.5);
    programme.clock.pass_s(1);
    const std::string changed = goals.change(ann, weekly, path_below(800, today + 5), today);
    EXPECT_EQ(goals.of_person(ann, programme.id("ann")).size(), 1U);
    seen = goals.progress(ann, programme.id("ann"), today);
    EXPECT_EQ(seen[0].goal.id, changed);
    EXPECT_EQ(seen[0].start, 812.5);
    EXPECT_FALSE(seen[0].best) << "nothing since it was set";
    programme.clock.pass_s(1);
    programme.record("ann");
    EXPECT_EQ(goals.progress(ann, programme.id("ann"), today)[0].best, 812.5);
    EXPECT_EQ(error_kind([&] { goals.drop(ann, weekly); }), StoreErrorKind::not_found) << "changed already";
    EXPECT_THROW(goals.drop(programme.session("ben"), changed), AccessDenied);
    EXPECT_THROW(goals.change(programme.session("ben"), changed, three_a_week(), today), AccessDenied);
    EXPECT_THROW(goals.of_person(programme.session("ben"), programme.id("ann")), AccessDenied);
    for (const char* outside : {"other_educator", "director", "administrator"})
        EXPECT_THROW(goals.progress(programme.session(outside), programme.id("ann"), today), AccessDenied)
            << outside;
    EXPECT_THROW(goals.set(programme.session("educator"), three_a_week(), today), AccessDenied);
    goals.drop(ann, changed);
    EXPECT_TRUE(goals.of_person(ann, programme.id("ann")).empty());
    EXPECT_EQ(goals.of_person(ann, programme.id("ann")).size(), 0U);
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
}

TEST(PersonalGoals, OfAMetricWithASignAreReachedByItsSize) {
    const Programme programme;
    const Goals goals(*programme.store);
    const Session& ann = programme.session("ann");
    const std::int64_t today = day_at(programme.store->now(), 0);
    goals.set(ann, {GoalOf::metric, "A2", "plane_dev_median", 1.0, today + 5}, today);
    const auto perform = [&](double side) {
        programme.clock.pass_s(60);
        AttemptResult result = test::example_result(true, 70);
        ScoreRow score = test::example_score(true, 70);
        score.metrics.push_back({"plane_dev_median", 1, "", "", side, {}, "mm", Direction::lower, {}});
        result.score = score;
        Recorder recorder(programme.path, ann, test::example_meta(programme.id("ann")),
                          programme.clock.options());
        Programme::append_second(recorder);
        recorder.finish(result);
        return goals.progress(ann, programme.id("ann"), today).at(0);
    };
    const GoalProgress shallow = perform(-3.2);
    EXPECT_EQ(shallow.best, 3.2);
    EXPECT_FALSE(shallow.reached) << "far on the other side";
    EXPECT_TRUE(perform(0.5).reached);
    const GoalProgress later = perform(-0.9);
    EXPECT_EQ(later.best, 0.5);
    EXPECT_EQ(goals.latest_value(ann, programme.id("ann"), "A2", "plane_dev_median"), 0.9);
}

TEST(PersonalGoals, OfAMetricCountItsNewestVersionByTheDay) {
    const Programme programme;
    const Goals goals(*programme.store);
    const Session& ann = programme.session("ann");
    const std::int64_t today = day_at(programme.store->now(), 0);
    const auto perform = [&](int version, double value) {
        programme.clock.pass_s(60);
        AttemptResult result = test::example_result(true, 70);
        ScoreRow score = test::example_score(true, 70);
        for (MetricRow& row : score.metrics)
            if (row.id == "path_len") {
                row.version = version;
                row.value = value;
            }
        result.score = score;
        Recorder recorder(programme.path, ann, test::example_meta(programme.id("ann")),
                          programme.clock.options());
        Programme::append_second(recorder);
        recorder.finish(result);
        return goals.progress(ann, programme.id("ann"), today).at(0);
    };
    goals.set(ann, path_below(800, today + 1), today);
    const GoalProgress older = perform(1, 700);
    EXPECT_EQ(older.best, 700);
    EXPECT_TRUE(older.reached);
    const GoalProgress newer = perform(2, 900);
    EXPECT_EQ(newer.best, 900) << "700 was not the same measure";
    EXPECT_FALSE(newer.reached);
    EXPECT_EQ(perform(1, 650).best, 900) << "of a station whose program is older";
    EXPECT_EQ(goals.latest_value(ann, programme.id("ann"), "A2", "path_len"), 900);
    EXPECT_TRUE(perform(2, 790).reached);
    // What a still newer version measures after the day of the goal changes nothing.
    programme.clock.pass_s(5 * 86'400);
    const GoalProgress later = perform(3, 2000);
    EXPECT_EQ(later.best, 790);
    EXPECT_TRUE(later.reached);
    EXPECT_EQ(goals.latest_value(ann, programme.id("ann"), "A2", "path_len"), 2000);
}

TEST(PersonalGoals, AreAuditedWithoutWhatTheySay) {
    const Programme programme;
    const Goals goals(*programme.store);
    const Session& ann = programme.session("ann");
    const std::string id = goals.set(ann, path_below(123.25, 20'010), 20'000);
    goals.drop(ann, id);
    int deeds = 0;
    for (const AuditEntry& entry : Audit(*programme.store).entries(programme.session("administrator"))) {
        if (entry.object_id != id) continue;
        ++deeds;
        EXPECT_TRUE(entry.operation == "goal.set" || entry.operation == "goal.drop") << entry.operation;
        EXPECT_EQ(entry.payload.find("123.25"), std::string::npos);
        EXPECT_EQ(entry.payload.find("path_len"), std::string::npos);
    }
    EXPECT_EQ(deeds, 2);
}

TEST(PersonalGoals, RefuseWhatCannotBeReachedAndMoreThanAFew) {
    const Programme programme;
    const Goals goals(*programme.store);
    const Session& ann = programme.session("ann");
    const auto refused = [&](const GoalWish& wish) {
        return error_kind([&] { goals.set(ann, wish, 20'000); }) == StoreErrorKind::bad_value;
    };
    for (const double number : {0.0, -1.0, 2.5, 101.0, std::nan(""), 1e300})
        EXPECT_TRUE(refused({GoalOf::attempts, "", "", number, 0})) << number;
    EXPECT_TRUE(refused({GoalOf::attempts, "", "path_len", 3, 0}));
    EXPECT_TRUE(refused({GoalOf::attempts, "", "", 3, 20'001}));
    EXPECT_TRUE(refused(path_below(800, 19'999))) << "yesterday";
    EXPECT_TRUE(refused(path_below(800, 20'367))) << "in more than a year";
    EXPECT_TRUE(refused(path_below(std::numeric_limits<double>::infinity(), 20'010)));
    EXPECT_TRUE(refused({GoalOf::metric, "", "path_len", 800, 20'010}));
    EXPECT_TRUE(refused({GoalOf::metric, "A2", "beauty", 800, 20'010}));
    EXPECT_TRUE(refused({GoalOf::attempts, std::string(33, 'A'), "", 3, 0}));
    for (std::size_t i = 0; i < most_goals; ++i) goals.set(ann, three_a_week(), 20'000);
    EXPECT_EQ(error_kind([&] { goals.set(ann, three_a_week(), 20'000); }), StoreErrorKind::conflict);
    const std::string last = goals.of_person(ann, programme.id("ann")).back().id;
    goals.change(ann, last, path_below(800, 20'000), 20'000);  // today is still possible
    EXPECT_EQ(goals.of_person(ann, programme.id("ann")).size(), most_goals);
    EXPECT_EQ(error_kind([&] { goals.change(ann, last, three_a_week(), 20'000); }),
              StoreErrorKind::not_found);
}

}  // namespace
}  // namespace fulcrum::database
