// SPDX-License-Identifier: GPL-3.0-or-later
// Standings whose rule asks for ratings: which attempt waits, which ratings count, who is shown it first;
// also of merged accounts.
#include <gtest/gtest.h>

#include <algorithm>

#include "assessment/assets/assets.h"
#include "database/records/curricula.h"
#include "database/records/person_merge.h"
#include "database/records/ratings.h"
#include "database/records/standings.h"
#include "tests/database/programme_fixture.h"
#include "tests/database/records/standing_of_ann.h"

namespace fulcrum::database {
namespace {

using test::Programme;
using test::standing_of_ann;

/// A2 asks for two passes in a row and for two ratings.
Curriculum rated_a2() {
    Curriculum curriculum = load_curriculum(asset_path("curricula/rectal.json"), task_ids());
    for (CurriculumTask& task : curriculum.tasks)
        if (task.task == "A2") {
            task.rule = parse_pass_rule("row:2");
            task.ratings = RatingRule{"goals", 2, 4, {}, false, false};
        }
    return curriculum;
}

TEST(RatedStandings, ReleasedRatingsOfTheAttemptThatMeetsTheRuleCount) {
    const Programme programme;
    const Curriculum curriculum = rated_a2();
    programme.people().set_educators(programme.session("director"), programme.cohort,
                                     {programme.id("educator"), programme.id("other_educator")});
    const ObserverForm goals = load_form(asset_path("forms/goals.json"));
    const Ratings ratings(*programme.store);
    const auto rate = [&](const char* login, const std::string& attempt, int value) {
        const Session& rater = programme.session(login);
        const std::string id = ratings.begin(rater, attempt, goals);
        ratings.answer(rater, id, FormAnswers(goals.items.size(), value),
                       std::vector<bool>(goals.items.size(), true), "");
        ratings.hand_in(rater, id);
    };
    programme.record("ann");
    programme.clock.pass_s(86'400);
    const std::string rated = programme.record("ann");
    const std::int64_t waits = programme.store->now();
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", waits).standing, Standing::awaiting_rating);
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", waits).rated_attempt, rated);
    // Raters see it first, though others are newer; without the curriculum in the order of time.
    programme.clock.pass_s(60);
    programme.record("ben");
    for (const char* login : {"educator", "director"}) {
        const std::vector<RatableAttempt> listed = ratings.to_rate(programme.session(login), &curriculum);
        EXPECT_EQ(listed.at(0).attempt_id, rated) << login;
        EXPECT_EQ(std::count_if(listed.begin(), listed.end(),
                                [](const RatableAttempt& one) { return one.awaited; }),
                  1);
    }
    EXPECT_EQ(ratings.to_rate(programme.session("educator"), &curriculum, 1).at(0).attempt_id, rated);
    EXPECT_NE(ratings.to_rate(programme.session("educator")).at(0).attempt_id, rated);
    EXPECT_NE(ratings.to_rate(programme.session("educator"), &curriculum).at(1).attempt_id, rated);
    rate("educator", rated, 5);
    rate("other_educator", rated, 3);
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", programme.store->now()).raters, 0)
        << "not released";
    programme.clock.pass_s(60);
    ASSERT_EQ(ratings.release(programme.session("educator"), rated), 2);
    EXPECT_FALSE(ratings.to_rate(programme.session("educator"), &curriculum).at(0).awaited) << "met";
    const std::int64_t released = programme.store->now();
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", released - 1).standing, Standing::awaiting_rating);
    EXPECT_TRUE(standing_of_ann(programme, curriculum, "A2", released).met_provisionally) << "mean 4";
    EXPECT_EQ(standing_of_ann(programme, curriculum, "B1", released).standing, Standing::open);
    EXPECT_EQ(standing_of_ann(programme, curriculum, "B1", released - 1).standing, Standing::locked);
    // The cohort table, from which screens and exports are made, says the same.
    CohortTableOptions options;
    options.curriculum = &curriculum;
    const auto of_a2 = [&] {
        const CohortTable table =
            Reports(*programme.store).cohort_table(programme.session("director"), programme.cohort, options);
        for (const PersonStandings& person : table.standings)
            for (const PersonTask& task : person.tasks)
                if (person.login == "ann" && task.standing.task == "A2") return task.standing;
        return TaskStanding();
    };
    EXPECT_TRUE(of_a2().met_provisionally);
    programme.attempts().void_attempt(programme.session("educator"), rated, "wrong person");
    EXPECT_FALSE(of_a2().met_provisionally);
    const std::string again = programme.record("ann");
    EXPECT_EQ(of_a2().standing, Standing::awaiting_rating);
    EXPECT_EQ(of_a2().rated_attempt, again);
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
}

TEST(RatedStandings, ARaterWhoHasSeenTheAttemptReadsThatBlindRatingsAreAskedFor) {
    const Programme programme;
    Curriculum curriculum = rated_a2();
    programme.record("ann");
    programme.clock.pass_s(86'400);
    const std::string rated = programme.record("ann");
    const Session& educator = programme.session("educator");
    const Ratings ratings(*programme.store);
    EXPECT_FALSE(ratings.to_rate(educator, &curriculum).at(0).wants_blind);
    for (CurriculumTask& task : curriculum.tasks)
        if (task.ratings) task.ratings->blind = true;
    for (const bool seen : {false, true}) {
        if (seen) ratings.note_seen(educator, rated);
        const RatableAttempt first = ratings.to_rate(educator, &curriculum).at(0);
        EXPECT_EQ(first.attempt_id, rated);
        EXPECT_TRUE(first.awaited);
        EXPECT_TRUE(first.wants_blind);
        EXPECT_EQ(first.blind, !seen);
    }
    EXPECT_FALSE(ratings.to_rate(educator, &curriculum).at(1).wants_blind) << "nobody waits for it";
}

TEST(RatedStandings, NoRatingIsAwaitedOfSomebodyWhoseVersionIsNotAtTheStation) {
    const Programme programme;
    Curriculum curriculum = rated_a2();
    curriculum.version = 1;
    programme.record("ann");
    programme.clock.pass_s(86'400);
    programme.record("ann");
    programme.clock.pass_s(60);
    const Session& educator = programme.session("educator");
    const Ratings ratings(*programme.store);
    EXPECT_TRUE(ratings.to_rate(educator, &curriculum).at(0).awaited);
    Curriculum next = curriculum;
    next.version = 1001;
    next.older = {curriculum};
    ASSERT_EQ(
        Curricula(*programme.store).move(educator, {programme.id("ann")}, next, next.name(), "new rules"), 1);
    EXPECT_FALSE(ratings.to_rate(educator, &curriculum).at(0).awaited);
}

TEST(RatedStandings, WhatOneAccountDecidedAboutAnotherOfThePersonDoesNotCountAfterAMerge) {
    const Programme programme;
    const Curriculum curriculum = rated_a2();
    // The educator is a trainee too, and was entered twice: ann is the other account.
    const Session& administrator = programme.session("administrator");
    const Session& educator = programme.session("educator");
    programme.people().set_roles(administrator, programme.id("educator"), {Role::educator, Role::trainee});
    const Standings standings(*programme.store);
    standings.decide(educator, programme.id("ann"), "A1", StandingOverride::Kind::proficient, "as I saw");
    const std::string attempt = programme.record("ann");
    const ObserverForm goals = load_form(asset_path("forms/goals.json"));
    const Ratings ratings(*programme.store);
    const std::string form = ratings.begin(educator, attempt, goals);
    ratings.answer(educator, form, FormAnswers(goals.items.size(), 5),
                   std::vector<bool>(goals.items.size(), true), "");
    ratings.hand_in(educator, form);
    ASSERT_EQ(ratings.release(educator, attempt), 1);
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A1", programme.store->now()).standing,
              Standing::proficient);
    const Session& director = programme.session("director");
    ASSERT_EQ(standings.record(director, programme.id("ann"), curriculum).ratings.size(), 1U);

    const PersonMerge merge(*programme.store);
    const MergePlan plan = merge.plan(administrator, programme.id("ann"), programme.id("educator"));
    EXPECT_EQ(plan.counts.back().what.words(),
              "decisions and forms of one account about the other, which then do not count");
    EXPECT_EQ(plan.counts.back().count, 2);
    merge.merge(administrator, programme.id("ann"), programme.id("educator"), "the same person");
    const PersonRecord record = standings.record(director, programme.id("educator"), curriculum);
    EXPECT_EQ(record.attempts.size(), 1U);
    EXPECT_TRUE(record.overrides.empty());
    EXPECT_TRUE(record.ratings.empty());
    const std::vector<OverrideRow> listed = standings.overrides(director, programme.id("educator"));
    ASSERT_EQ(listed.size(), 1U) << "it is still shown";
    EXPECT_TRUE(listed[0].own);
    CohortTableOptions options;
    options.curriculum = &curriculum;
    const CohortTable table = Reports(*programme.store).cohort_table(director, programme.cohort, options);
    for (const PersonStandings& person : table.standings)
        for (const PersonTask& task : person.tasks)
            if (task.standing.task == "A1") {
                EXPECT_EQ(task.standing.declared_at, 0) << person.login;
            }
    merge.undo(administrator, programme.id("ann"), "two people after all");
    EXPECT_EQ(standings.record(director, programme.id("ann"), curriculum).overrides.size(), 1U);
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
}

TEST(RatedStandings, RatersSeeTheAwaitedAttemptOfAMergedAccountFirst) {
    const Programme programme;
    const Curriculum curriculum = rated_a2();
    programme.record("eve");
    programme.clock.pass_s(86'400);
    const std::string rated = programme.record("eve");
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("eve"), programme.id("ann"), "entered twice");
    programme.clock.pass_s(60);
    programme.record("ben");
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", programme.store->now()).rated_attempt, rated);
    for (const char* login : {"educator", "director"}) {
        const std::vector<RatableAttempt> listed =
            Ratings(*programme.store).to_rate(programme.session(login), &curriculum);
        ASSERT_EQ(listed.size(), 3U) << login;
        EXPECT_EQ(listed[0].attempt_id, rated) << login;
        EXPECT_TRUE(listed[0].awaited) << login;
    }
}

}  // namespace
}  // namespace fulcrum::database
