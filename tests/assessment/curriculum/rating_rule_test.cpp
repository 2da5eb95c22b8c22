// SPDX-License-Identifier: Apache-2.0
// Ratings as a condition of proficiency: which ones count, when an attempt is the one to be rated, and that
// the standing depends on nothing but what was released up to the moment.
#include "assessment/curriculum/rating_rule.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "assessment/curriculum/concern.h"
#include "assessment/curriculum/recommendation.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {
namespace {

constexpr std::int64_t rating_day = 86'400'000, rating_begin = 20'000 * rating_day + 43'200'000;

RatingRule gas_of_two() {
    RatingRule rule;
    rule.form = "gas";
    rule.raters = 2;
    rule.lowest_mean = 5;
    return rule;
}

ReleasedRating released(const std::string& attempt, const std::string& rater, std::int64_t time,
                        std::map<std::string, int> answers) {
    return {attempt + rater, attempt, rater, "gas", time, true, std::move(answers)};
}

/// "A" asks for two passes in a row and two ratings, "B" follows it.
Curriculum with_ratings(const std::optional<RatingRule>& rule = gas_of_two()) {
    Curriculum curriculum{"test", 1, "Test", {{"1", "First"}, {"2", "Second"}}, {}};
    curriculum.tasks.push_back({"A", "1", {}, parse_pass_rule("row:2"), {DeviceClass::haptic}, 1, rule});
    curriculum.tasks.push_back({"B", "2", {"A"}, parse_pass_rule("row:2"), {DeviceClass::haptic}});
    return curriculum;
}

struct RatedTrainee {
    explicit RatedTrainee(const Curriculum& curriculum) { record.assignments.push_back({0, &curriculum}); }
    std::string attempt(int day, bool passed, bool provisional = false) {
        CountedAttempt one;
        one.id = "attempt-" + std::to_string(record.attempts.size());
        one.task = "A";
        one.time = rating_begin + day * rating_day;
        one.passed = passed;
        one.provisional = provisional;
        record.attempts.push_back(one);
        return one.id;
    }
    void rate(const std::string& attempt, const std::string& rater, int day, int value) {
        record.ratings.push_back(
            released(attempt, rater, rating_begin + day * rating_day, {{"exposure", value}}));
    }
    TaskStanding on(int day, const std::string& task = "A") const {
        for (const TaskStanding& one : standing_of(record, rating_begin + day * rating_day))
            if (one.task == task) return one;
        ADD_FAILURE() << task;
        return {};
    }
    PersonRecord record;
};

TEST(RatingRule, CountsRatersOfTheFormAndTheMeanOfTheirMeans) {
    const RatingRule rule = gas_of_two();
    std::vector<ReleasedRating> ratings = {released("x", "ed", 10, {{"exposure", 6}, {"resection", 5}})};
    EXPECT_EQ(judge_ratings(rule, {}, 100).raters, 0);
    EXPECT_FALSE(judge_ratings(rule, {}, 100).mean);
    EXPECT_EQ(judge_ratings(rule, ratings, 9).raters, 0) << "released later";
    EXPECT_FALSE(judge_ratings(rule, ratings, 10).enough);
    ratings.push_back(released("x", "ida", 20, {{"exposure", 4}}));
    const RatingVerdict low = judge_ratings(rule, ratings, 20);
    EXPECT_TRUE(low.enough);
    EXPECT_FALSE(low.met);
    EXPECT_NEAR(*low.mean, (5.5 + 4) / 2, 1e-12) << "each rater weighs the same";
    ratings.push_back(released("x", "uma", 30, {{"exposure", 6}}));
    EXPECT_TRUE(judge_ratings(rule, ratings, 30).met);
    EXPECT_FALSE(judge_ratings(rule, ratings, 29).met);
    ratings[0].form = "goals";
    EXPECT_EQ(judge_ratings(rule, ratings, 30).raters, 2) << "another form";
    ReleasedRating again = released("x", "uma", 25, {{"exposure", 1}});
    again.id = "older";
    ratings.push_back(again);
    EXPECT_NEAR(*judge_ratings(rule, ratings, 30).mean, 5, 1e-12) << "the newest of each rater";
    EXPECT_TRUE(judge_ratings(rule, ratings, 30).met) << "5 is at least 5";
}

TEST(RatingRule, CanAskForItemsForEachOfThemAndForBlindRaters) {
    RatingRule rule = gas_of_two();
    rule.raters = 1;
    rule.items = {"exposure", "resection"};
    std::vector<ReleasedRating> ratings = {
        released("x", "ed", 10, {{"exposure", 6}, {"resection", 4}, {"anastomosis", 1}})};
    EXPECT_TRUE(judge_ratings(rule, ratings, 10).met) << "the third item does not count";
    rule.every_item = true;
    EXPECT_FALSE(judge_ratings(rule, ratings, 10).met);
    ratings.push_back(released("x", "ida", 10, {{"resection", 6}}));
    EXPECT_TRUE(judge_ratings(rule, ratings, 10).met) << "(4 + 6) / 2";
    ratings.push_back(released("x", "uma", 10, {{"anastomosis", 6}}));
    EXPECT_EQ(judge_ratings(rule, ratings, 10).raters, 2) << "saw none of the items";
    rule.blind = true;
    ratings[1].blind = false;
    EXPECT_EQ(judge_ratings(rule, ratings, 10).raters, 1);
    EXPECT_FALSE(judge_ratings(rule, ratings, 10).met);
}

TEST(StandingRatings, TheAttemptThatCompletesTheRuleAwaitsItsRatings) {
    const Curriculum curriculum = with_ratings();
    RatedTrainee ann(curriculum);
    const std::string first = ann.attempt(0, true);
    ann.rate(first, "ed", 1, 6);
    ann.rate(first, "ida", 1, 6);
    EXPECT_EQ(ann.on(1).standing, Standing::passed) << "ratings alone do not meet the rule";
    const std::string rated = ann.attempt(2, true);
    EXPECT_EQ(ann.on(2).standing, Standing::awaiting_rating);
    EXPECT_EQ(ann.on(2).rated_attempt, rated);
    EXPECT_EQ(ann.on(2).rated_time, rating_begin + 2 * rating_day);
    EXPECT_EQ(ann.on(2).raters, 0);
    EXPECT_EQ(ann.on(2).raters_needed, 2);
    EXPECT_FALSE(ann.on(2).stalled);
    EXPECT_EQ(ann.on(2, "B").standing, Standing::locked);
    ann.attempt(3, false);
    EXPECT_EQ(ann.on(3).rated_attempt, rated) << "practice goes on, the rated attempt stays";
    ann.rate(rated, "ed", 4, 5);
    EXPECT_EQ(ann.on(4).raters, 1);
    ann.rate(rated, "ida", 5, 6);
    EXPECT_EQ(ann.on(4).standing, Standing::awaiting_rating);
    EXPECT_EQ(ann.on(5).standing, Standing::proficient);
    EXPECT_EQ(ann.on(5).declared_at, rating_begin + 5 * rating_day) << "from the last rating";
    EXPECT_TRUE(ann.on(5).rated_attempt.empty());
    EXPECT_EQ(ann.on(5, "B").standing, Standing::open);
    ann.rate(rated, "uma", 6, 1);
    EXPECT_EQ(ann.on(6).standing, Standing::proficient) << "a declaration stays";
}

TEST(StandingRatings, LowRatingsAskForAnotherAttemptAndLaterOnesCanStillRaiseThem) {
    const Curriculum curriculum = with_ratings();
    RatedTrainee ann(curriculum);
    ann.attempt(0, true);
    const std::string rated = ann.attempt(1, true);
    ann.rate(rated, "ed", 2, 4);
    ann.rate(rated, "ida", 2, 5);
    EXPECT_EQ(ann.on(2).standing, Standing::passed);
    EXPECT_TRUE(ann.on(2).rated_low);
    EXPECT_EQ(ann.on(2).rated_attempt, rated);
    RatedTrainee raised = ann;
    raised.rate(rated, "uma", 3, 6);
    EXPECT_EQ(raised.on(3).standing, Standing::proficient) << "mean of three is 5";
    ann.attempt(3, false);
    ann.attempt(4, true);
    EXPECT_TRUE(ann.on(4).rated_low) << "one pass in a row is not two";
    const std::string next = ann.attempt(5, true);
    EXPECT_EQ(ann.on(5).standing, Standing::awaiting_rating);
    EXPECT_EQ(ann.on(5).rated_attempt, next);
    ann.record.attempts.back().voided_at = rating_begin + 6 * rating_day;
    EXPECT_TRUE(ann.on(6).rated_low);
    EXPECT_EQ(ann.on(6).rated_attempt, rated) << "as if it had never been";
    ann.record.attempts.back().voided_at = 0;
    ann.rate(next, "ed", 7, 5);
    ann.rate(next, "ida", 7, 5);
    EXPECT_EQ(ann.on(7).standing, Standing::proficient);
}

TEST(StandingRatings, RatingsThatAreReleasedTogetherAreJudgedTogether) {
    const Curriculum curriculum = with_ratings();
    RatedTrainee ann(curriculum);
    ann.attempt(0, true);
    const std::string rated = ann.attempt(1, true);
    for (const auto& [rater, value] : std::map<std::string, int>{{"a", 6}, {"b", 5}, {"c", 1}})
        ann.rate(rated, rater, 2, value);
    EXPECT_TRUE(ann.on(2).rated_low) << "the first two alone would have been enough";
}

TEST(StandingRatings, ProvisionalLimitsUnlockOnceTheRatingsAreThere) {
    const Curriculum curriculum = with_ratings();
    RatedTrainee ann(curriculum);
    ann.attempt(0, true, true);
    const std::string rated = ann.attempt(1, true, true);
    EXPECT_EQ(ann.on(1).standing, Standing::awaiting_rating);
    EXPECT_FALSE(ann.on(1).met_provisionally);
    EXPECT_EQ(ann.on(1, "B").standing, Standing::locked);
    ann.rate(rated, "ed", 2, 6);
    ann.rate(rated, "ida", 2, 6);
    EXPECT_EQ(ann.on(2).standing, Standing::passed);
    EXPECT_TRUE(ann.on(2).met_provisionally);
    EXPECT_EQ(ann.on(2, "B").standing, Standing::open);
}

TEST(StandingRatings, AVersionThatAsksForNoneEndsTheWaiting) {
    const Curriculum with = with_ratings(), without = with_ratings(std::nullopt);
    RatedTrainee ann(with);
    ann.attempt(0, true);
    ann.attempt(1, true);
    ann.record.assignments.push_back({rating_begin + 3 * rating_day, &without});
    EXPECT_EQ(ann.on(2).standing, Standing::awaiting_rating);
    EXPECT_EQ(ann.on(3).standing, Standing::proficient);
    EXPECT_EQ(ann.on(3).declared_at, rating_begin + 3 * rating_day);
    RatedTrainee ben(without);
    ben.attempt(0, true);
    ben.attempt(1, true);
    ben.record.assignments.push_back({rating_begin + 3 * rating_day, &with});
    EXPECT_EQ(ben.on(4).standing, Standing::proficient) << "declared before the rule asked for ratings";
}

TEST(StandingRatings, AVersionThatAsksForMorePassesInPlaceOfRatingsWaitsForThem) {
    const Curriculum with = with_ratings();
    Curriculum strict = with_ratings(std::nullopt);
    strict.tasks[0].rule = parse_pass_rule("row:5");
    for (const bool provisional : {false, true}) {
        RatedTrainee ann(with);
        ann.attempt(0, true, provisional);
        ann.attempt(1, true, provisional);
        ann.record.assignments.push_back({rating_begin + 3 * rating_day, &strict});
        EXPECT_EQ(ann.on(2).standing, Standing::awaiting_rating);
        EXPECT_EQ(ann.on(3).standing, Standing::passed);
        EXPECT_EQ(ann.on(3).declared_at, 0);
        EXPECT_FALSE(ann.on(3).met_provisionally);
        EXPECT_DOUBLE_EQ(ann.on(3).progress, 0.4);
        EXPECT_EQ(ann.on(3, "B").standing, Standing::locked);
        for (int day = 4; day <= 6; ++day) ann.attempt(day, true, provisional);
        EXPECT_EQ(ann.on(5).standing, Standing::passed);
        EXPECT_FALSE(ann.on(5).met_provisionally);
        EXPECT_EQ(ann.on(6).standing, provisional ? Standing::passed : Standing::proficient);
        EXPECT_EQ(ann.on(6).met_provisionally, provisional);
        EXPECT_EQ(ann.on(6, "B").standing, Standing::open);
    }
    // The same rule for passes: failures while it waited lose the attempt as little as without a move.
    Curriculum one_rater = with_ratings();
    one_rater.tasks[0].ratings->raters = 1;
    RatedTrainee ben(with);
    ben.attempt(0, true);
    const std::string rated = ben.attempt(1, true);
    ben.attempt(2, false);
    ben.record.assignments.push_back({rating_begin + 3 * rating_day, &one_rater});
    EXPECT_EQ(ben.on(3).standing, Standing::awaiting_rating);
    EXPECT_EQ(ben.on(3).rated_attempt, rated);
    ben.rate(rated, "ed", 4, 6);
    EXPECT_EQ(ben.on(4).standing, Standing::proficient);
}

TEST(StandingRatings, AfterAMoveTheStandingIsThatOfTheNewRule) {
    Curriculum two = with_ratings(std::nullopt);
    two.tasks[0].variants = 2;
    const Curriculum one = with_ratings(std::nullopt);
    RatedTrainee ann(two);
    ann.attempt(0, true);
    ann.attempt(1, true);
    ann.record.assignments.push_back({rating_begin + 3 * rating_day, &one});
    EXPECT_EQ(ann.on(2).more_variants, 1);
    EXPECT_EQ(ann.on(3).more_variants, 0);
    EXPECT_FALSE(ann.on(2).one_more_pass);
    EXPECT_EQ(ann.on(3).standing, Standing::passed) << "the rule applies to what comes";
    EXPECT_TRUE(ann.on(3).one_more_pass);
    EXPECT_DOUBLE_EQ(ann.on(3).progress, 2.0 / 3);
    RatedTrainee failed = ann;
    failed.attempt(4, false);
    EXPECT_FALSE(failed.on(4).one_more_pass) << "no pass in a row";
    EXPECT_DOUBLE_EQ(failed.on(4).progress, 0);
    ann.attempt(4, true);
    EXPECT_EQ(ann.on(4).standing, Standing::proficient);
}

TEST(StandingRatings, AfterAMoveToAnEasierRuleOneMorePassIsAskedFor) {
    Curriculum strict = with_ratings(std::nullopt), held = strict;
    strict.tasks[0].rule = parse_pass_rule("row:5");
    held.tasks[0].rule = parse_pass_rule("lc-cusum:0.1,0.3,0.4");
    const Curriculum easy = with_ratings(std::nullopt);
    for (const bool provisional : {false, true})
        for (const Curriculum* next : {&easy, static_cast<const Curriculum*>(&held)}) {
            RatedTrainee ann(strict);
            ann.attempt(0, true, provisional);
            ann.attempt(1, true, provisional);
            ann.record.assignments.push_back({rating_begin + 3 * rating_day, next});
            EXPECT_DOUBLE_EQ(ann.on(2).progress, 0.4);
            EXPECT_EQ(ann.on(3).standing, Standing::passed);
            EXPECT_TRUE(ann.on(3).one_more_pass);
            EXPECT_GT(ann.on(3).progress, 0.5);
            EXPECT_LT(ann.on(3).progress, 0.99);
            ann.attempt(4, true, provisional);
            EXPECT_FALSE(ann.on(4).one_more_pass);
            EXPECT_EQ(ann.on(4).standing, provisional ? Standing::passed : Standing::proficient);
            EXPECT_EQ(ann.on(4).met_provisionally, provisional);
        }
    // Moved by mistake and back: the attempt that awaited its ratings was given up at the first move.
    const Curriculum rated = with_ratings();
    RatedTrainee ben(rated);
    ben.attempt(0, true);
    ben.attempt(1, true);
    ben.record.assignments.push_back({rating_begin + 3 * rating_day, &strict});
    ben.record.assignments.push_back({rating_begin + 4 * rating_day, &rated});
    EXPECT_EQ(ben.on(2).standing, Standing::awaiting_rating);
    EXPECT_FALSE(ben.on(3).one_more_pass) << "2 of 5";
    EXPECT_EQ(ben.on(4).standing, Standing::passed);
    EXPECT_TRUE(ben.on(4).one_more_pass);
    const std::string next = ben.attempt(5, true);
    EXPECT_EQ(ben.on(5).standing, Standing::awaiting_rating);
    EXPECT_EQ(ben.on(5).rated_attempt, next);
    EXPECT_FALSE(ben.on(5).one_more_pass);
}

TEST(StandingRatings, TheNextThingToDoIsWhatDoesNotWait) {
    Curriculum curriculum = with_ratings();
    curriculum.tasks[1].after.clear();
    RatedTrainee ann(curriculum);
    ann.attempt(0, true);
    ann.attempt(1, true);
    const auto next = [&] {
        return recommend(curriculum, standing_of(ann.record, rating_begin + 2 * rating_day), {},
                         DeviceClass::haptic);
    };
    EXPECT_EQ(next().task, "B");
    ann.record.overrides.push_back({"o", "B", StandingOverride::Kind::proficient, rating_begin + rating_day});
    EXPECT_EQ(next().task, "A");
    EXPECT_EQ(next().reason, RecommendationReason::awaits_rating);
}

TEST(StandingRatings, AnAttemptThatNobodyIsLeftToRateIsReplacedAfterFourWeeks) {
    const Curriculum curriculum = with_ratings();
    RatedTrainee ann(curriculum);
    ann.attempt(0, true);
    const std::string rated = ann.attempt(1, true);
    ann.rate(rated, "ed", 2, 6);
    ann.attempt(20, true);
    EXPECT_EQ(ann.on(28).rated_attempt, rated) << "it stays while it waits";
    EXPECT_FALSE(ann.on(28).rating_late);
    const auto standings = standing_of(ann.record, rating_begin + 29 * rating_day);
    EXPECT_TRUE(standings[0].rating_late);
    const Recommendation now = recommend(curriculum, standings, {}, DeviceClass::haptic);
    EXPECT_EQ(now.task, "A");
    EXPECT_EQ(now.reason, RecommendationReason::longest_ago) << "not awaits_rating: an attempt helps";
    const auto concerns = concerns_of(standings, {}, 0, 60, rating_begin + 29 * rating_day);
    ASSERT_EQ(concerns.size(), 1U);
    EXPECT_EQ(concerns[0].kind, ConcernKind::rating_late);
    EXPECT_EQ(concerns[0].since, rating_begin + rating_day);
    RatedTrainee in_time = ann;
    in_time.rate(rated, "ida", 29, 6);
    EXPECT_EQ(in_time.on(29).standing, Standing::proficient) << "no later one took its place";
    const std::string next = ann.attempt(30, true);
    EXPECT_EQ(ann.on(30).rated_attempt, next);
    EXPECT_EQ(ann.on(30).raters, 0);
    EXPECT_FALSE(ann.on(30).rating_late);
    for (const char* rater : {"uma", "ida"}) ann.rate(next, rater, 31, 6);
    EXPECT_EQ(ann.on(31).standing, Standing::proficient);
}

TEST(StandingRatings, RatingsOfAnAttemptThatWasReplacedCountWhenTheyCome) {
    const Curriculum curriculum = with_ratings();
    RatedTrainee ann(curriculum);
    ann.attempt(0, true);
    const std::string rated = ann.attempt(1, true);
    ann.rate(rated, "ed", 20, 6);
    RatedTrainee failed = ann;
    failed.attempt(30, false);
    EXPECT_EQ(failed.on(30).rated_attempt, rated) << "only a pass takes its place";
    ann.attempt(30, true);
    EXPECT_NE(ann.on(30).rated_attempt, rated);
    ann.rate(rated, "ida", 35, 6);
    EXPECT_EQ(ann.on(34).standing, Standing::awaiting_rating);
    EXPECT_EQ(ann.on(36).standing, Standing::proficient);
    EXPECT_EQ(ann.on(36).declared_at, ann.record.ratings.back().time);
}

/// Attempts in "A" and ratings of them by up to four people, over thirty days.
PersonRecord rated_history(const Curriculum& curriculum) {
    RatedTrainee trainee(curriculum);
    const int attempts = *rc::gen::inRange(0, 20);
    for (int i = 0; i < attempts; ++i) {
        trainee.attempt(*rc::gen::inRange(0, 30), *rc::gen::inRange(0, 10) < 8, *rc::gen::inRange(0, 6) == 0);
        const int ratings = *rc::gen::inRange(0, 4);
        for (int j = 0; j < ratings; ++j) {
            trainee.rate(trainee.record.attempts.back().id,
                         std::string(1, static_cast<char>('a' + *rc::gen::inRange(0, 4))),
                         *rc::gen::inRange(0, 40), *rc::gen::inRange(3, 7));
            trainee.record.ratings.back().id += std::to_string(j);
        }
    }
    return trainee.record;
}

auto rated_key(const TaskStanding& one) {
    return std::make_tuple(one.task, one.standing, one.attempts, one.passes, one.progress, one.declared_at,
                           one.next_check, one.met_provisionally, one.rated_low, one.rated_attempt,
                           one.rated_time, one.raters, one.waits_for, one.one_more_day, one.one_more_pass,
                           one.stalled);
}
bool same_standings(const std::vector<TaskStanding>& a, const std::vector<TaskStanding>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(),
        [](const TaskStanding& x, const TaskStanding& y) { return rated_key(x) == rated_key(y); });
}

RC_GTEST_PROP(StandingRatingsProperty, TheOrderOfInsertionChangesNothing, ()) {
    const Curriculum curriculum = with_ratings();
    const PersonRecord record = rated_history(curriculum);
    PersonRecord other = record;
    std::reverse(other.ratings.begin(), other.ratings.end());
    std::reverse(other.attempts.begin(), other.attempts.end());
    for (int day = 0; day < 42; day += 3)
        RC_ASSERT(same_standings(standing_of(record, rating_begin + day * rating_day),
                                 standing_of(other, rating_begin + day * rating_day)));
}

RC_GTEST_PROP(StandingRatingsProperty, WhatIsReleasedLaterChangesNoEarlierState, ()) {
    const Curriculum curriculum = with_ratings();
    const PersonRecord record = rated_history(curriculum);
    const std::int64_t at = rating_begin + *rc::gen::inRange(0, 42) * rating_day;
    PersonRecord until = record;
    const auto later = [at](const auto& one) { return one.time > at; };
    until.ratings.erase(std::remove_if(until.ratings.begin(), until.ratings.end(), later),
                        until.ratings.end());
    until.attempts.erase(std::remove_if(until.attempts.begin(), until.attempts.end(), later),
                         until.attempts.end());
    RC_ASSERT(same_standings(standing_of(record, at), standing_of(until, at)));
}

RC_GTEST_PROP(StandingRatingsProperty, AVoidedAttemptTakesItsRatingsWithIt, ()) {
    const Curriculum curriculum = with_ratings();
    PersonRecord record = rated_history(curriculum);
    if (record.attempts.empty()) return;
    const std::int64_t at = rating_begin + 41 * rating_day;
    CountedAttempt& voided = record.attempts[static_cast<std::size_t>(
        *rc::gen::inRange<int>(0, static_cast<int>(record.attempts.size())))];
    voided.voided_at = at;
    PersonRecord without = record;
    const std::string id = voided.id;
    without.attempts.erase(std::remove_if(without.attempts.begin(), without.attempts.end(),
                                          [&](const CountedAttempt& one) { return one.id == id; }),
                           without.attempts.end());
    without.ratings.erase(std::remove_if(without.ratings.begin(), without.ratings.end(),
                                         [&](const ReleasedRating& one) { return one.attempt == id; }),
                          without.ratings.end());
    RC_ASSERT(same_standings(standing_of(record, at), standing_of(without, at)));
}

std::string refusal_of_ratings(const nlohmann::json& ratings) {
    auto document = nlohmann::json::parse(read_text_file(asset_path("curricula/rectal.json"), 1U << 20U));
    document["tasks"][6]["ratings"] = ratings;
    try {
        Curriculum curriculum = parse_curriculum(document.dump(1), "test.json", task_ids());
        curriculum.file = "test.json";
        check_ratings(curriculum, load_forms(asset_path("forms")));
        return {};
    } catch (const InputError& error) {
        EXPECT_FALSE(error.hint().empty());
        EXPECT_EQ(error.file(), "test.json");
        return error.place() + ": " + error.problem();
    }
}

TEST(CurriculumRatings, AreReadAndWrongOnesAreRefusedWithTheirPlace) {
    nlohmann::json ratings = {{"form", "gas"},      {"raters", 2},
                              {"lowest_mean", 5},   {"items", {"rectal_dissection", "exposure"}},
                              {"every_item", true}, {"blind", true}};
    EXPECT_EQ(refusal_of_ratings(ratings), "");
    const auto broken = [&](const char* key, const nlohmann::json& value) {
        nlohmann::json changed = ratings;
        changed[key] = value;
        return refusal_of_ratings(changed);
    };
    const auto says = [](const std::string& refused, const std::string& place, const std::string& problem) {
        return refused.find("/tasks/6/ratings/" + place) != std::string::npos &&
               refused.find(problem) != std::string::npos;
    };
    EXPECT_TRUE(says(broken("form", "guess"), "form", "no observer form guess is installed"));
    EXPECT_TRUE(says(broken("items", {"exposure", "courage"}), "items", "courage is not an item"));
    EXPECT_TRUE(says(broken("items", {"exposure", "exposure"}), "items", "listed twice"));
    EXPECT_TRUE(says(broken("lowest_mean", 6.5), "lowest_mean", "outside the scale"));
    EXPECT_TRUE(says(broken("lowest_mean", 0), "lowest_mean", "outside the scale"));
    EXPECT_NE(broken("raters", 0), "");
    EXPECT_NE(broken("raters", 1.5), "");
    EXPECT_NE(broken("raters", "two"), "");
    EXPECT_NE(broken("items", nlohmann::json::array()), "");
    EXPECT_NE(broken("mean", 3), "") << "an unknown key";
    ratings.erase("form");
    EXPECT_NE(refusal_of_ratings(ratings), "");
}

TEST(CurriculumRatings, TheDeliveredCurriculaAskForNone) {
    const Curriculum newest = load_versions(asset_path("curricula"), "rectal", task_ids());
    EXPECT_FALSE(asks_for_ratings(newest)) << "docs/DECISIONS.md says why";
    check_ratings(newest, {});
    Curriculum other = newest;
    other.older[0].tasks[0].ratings = gas_of_two();
    EXPECT_TRUE(asks_for_ratings(other)) << "people may follow an earlier version";
    EXPECT_THROW(check_ratings(other, {}), InputError);
}

}  // namespace
}  // namespace fulcrum
