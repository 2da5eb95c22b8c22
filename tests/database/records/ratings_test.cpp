// SPDX-License-Identifier: GPL-3.0-or-later
// Observer forms in the store: who sees whose when, that what was handed in stays, that no score moves, and
// how far raters agree.
#include "database/records/ratings.h"

#include <rapidcheck.h>

#include <set>

#include "assessment/assets/assets.h"
#include "database/records/person_merge.h"
#include "database/rows/connection.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

const ObserverForm& form_named(const std::string& id) {
    static const std::vector<ObserverForm> forms = load_forms(asset_path("forms"));
    for (const ObserverForm& form : forms)
        if (form.id == id) return form;
    throw std::logic_error("no form " + id);
}

FormAnswers all_of(const ObserverForm& form, int value) {
    return FormAnswers(form.items.size(), value);
}

class RatingsOfAnAttempt : public ::testing::Test {
  protected:
    void SetUp() override {
        attempt = programme.record("ann");
        programme.people().set_educators(programme.session("director"), programme.cohort,
                                         {programme.id("educator"), programme.id("other_educator")});
    }
    Ratings ratings() const { return Ratings(*programme.store); }
    std::string rate(const std::string& login, const std::string& of, int value,
                     const std::string& form = "goals") const {
        const Session& rater = programme.session(login);
        const ObserverForm& used = form_named(form);
        const std::string id = ratings().begin(rater, of, used);
        ratings().answer(rater, id, all_of(used, value), std::vector<bool>(used.items.size(), true), "");
        ratings().hand_in(rater, id);
        return id;
    }
    std::size_t seen_by(const std::string& login) const {
        return ratings().of_attempt(programme.session(login), attempt).rows.size();
    }
    int hidden_from(const std::string& login) const {
        return ratings().of_attempt(programme.session(login), attempt).hidden;
    }
    Programme programme;
    std::string attempt;
};

TEST_F(RatingsOfAnAttempt, DraftIsItsRatersAloneAndKeepsWhatWasEntered) {
    const Session& educator = programme.session("educator");
    const std::string id = ratings().begin(educator, attempt, form_named("osats"));
    FormAnswers answers(7);
    std::vector<bool> answered(7, false);
    answers[0] = 4;
    answered[0] = true;
    answered[4] = true;  // not seen
    ratings().answer(educator, id, answers, answered, "Steady hands.");
    programme.open();
    const AttemptRatings own = ratings().of_attempt(educator, attempt);
    ASSERT_EQ(own.rows.size(), 1U);
    EXPECT_EQ(own.rows[0].form.name(), "osats@1");
    EXPECT_EQ(own.rows[0].answers, answers);
    EXPECT_EQ(own.rows[0].answered, answered);
    EXPECT_EQ(own.rows[0].remark, "Steady hands.");
    EXPECT_EQ(own.rows[0].handed_in, 0);
    EXPECT_EQ(seen_by("other_educator"), 0U);
    EXPECT_EQ(hidden_from("other_educator"), 0) << "a draft is not even counted";
    EXPECT_EQ(seen_by("ann"), 0U);
    EXPECT_THROW(ratings().answer(programme.session("other_educator"), id, answers, answered, ""),
                 AccessDenied);
    EXPECT_THROW(ratings().hand_in(programme.session("other_educator"), id), AccessDenied);
    EXPECT_THROW(ratings().discard(programme.session("director"), id), AccessDenied);
    ratings().discard(educator, id);
    EXPECT_EQ(seen_by("educator"), 0U);
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
}

TEST_F(RatingsOfAnAttempt, RatersSeeTheOthersOnlyAfterHandingInTheirOwn) {
    rate("educator", attempt, 4);
    EXPECT_EQ(seen_by("educator"), 1U);
    EXPECT_EQ(seen_by("other_educator"), 0U);
    EXPECT_EQ(hidden_from("other_educator"), 1);
    EXPECT_EQ(seen_by("director"), 0U);
    const std::string own =
        ratings().begin(programme.session("other_educator"), attempt, form_named("goals"));
    EXPECT_EQ(seen_by("other_educator"), 1U) << "the own draft";
    ratings().answer(programme.session("other_educator"), own, all_of(form_named("goals"), 2),
                     std::vector<bool>(5, true), "");
    ratings().hand_in(programme.session("other_educator"), own);
    EXPECT_EQ(seen_by("other_educator"), 2U);
    EXPECT_EQ(hidden_from("other_educator"), 0);
    EXPECT_EQ(hidden_from("director"), 2);
}

TEST_F(RatingsOfAnAttempt, TraineeSeesAFormOnceItIsReleased) {
    rate("educator", attempt, 4);
    EXPECT_EQ(seen_by("ann"), 0U);
    EXPECT_EQ(hidden_from("ann"), 1);
    EXPECT_EQ(ratings().release(programme.session("educator"), attempt), 1);
    EXPECT_EQ(ratings().release(programme.session("educator"), attempt), 0) << "already released";
    EXPECT_EQ(seen_by("ann"), 1U);
    EXPECT_EQ(seen_by("director"), 1U) << "what the trainee sees is no secret";
    const std::string draft =
        ratings().begin(programme.session("other_educator"), attempt, form_named("goals"));
    EXPECT_EQ(seen_by("other_educator"), 1U) << "only the own draft while rating blind";
    ratings().note_seen(programme.session("other_educator"), attempt);
    EXPECT_EQ(seen_by("other_educator"), 1U) << "nor after having seen name and score";
    ratings().answer(programme.session("other_educator"), draft, all_of(form_named("goals"), 2),
                     std::vector<bool>(5, true), "");
    ratings().hand_in(programme.session("other_educator"), draft);
    EXPECT_EQ(seen_by("ann"), 1U) << "handed in after the release";
    EXPECT_EQ(ratings().of_person(programme.session("ann"), programme.id("ann")).at(attempt).hidden, 1);
    EXPECT_TRUE(ratings().of_person(programme.session("ann"), programme.id("ann"), "B1").empty());
    EXPECT_THROW(ratings().of_attempt(programme.session("ben"), attempt), AccessDenied);
    EXPECT_THROW(ratings().release(programme.session("ann"), attempt), AccessDenied);
}

TEST_F(RatingsOfAnAttempt, FormsThatDoNotAskForBlindingAreSeenAtOnce) {
    ObserverForm open = form_named("goals");
    const auto at = open.text.find("\"blind\": true");
    ASSERT_NE(at, std::string::npos);
    open = parse_form(open.text.replace(at, 13, "\"blind\": false"), "open.json");
    const Session& educator = programme.session("educator");
    const std::string id = ratings().begin(educator, attempt, open);
    ratings().answer(educator, id, all_of(open, 3), std::vector<bool>(5, true), "");
    EXPECT_FALSE(ratings().is_blind(educator, attempt));
    ratings().hand_in(educator, id);
    ASSERT_EQ(seen_by("other_educator"), 1U);
    EXPECT_EQ(ratings().of_attempt(educator, attempt).rows[0].blinding, Blinding::not_asked);
}

TEST_F(RatingsOfAnAttempt, BlindingIsLiftedByOpeningTheAttemptWithNameAndScore) {
    const Session& educator = programme.session("educator");
    EXPECT_TRUE(ratings().to_rate(educator).at(0).blind);
    const std::string id = ratings().begin(educator, attempt, form_named("goals"));
    EXPECT_TRUE(ratings().is_blind(educator, attempt));
    ratings().note_seen(educator, attempt);
    EXPECT_FALSE(ratings().is_blind(educator, attempt));
    EXPECT_EQ(ratings().of_attempt(educator, attempt).rows.at(0).blinding, Blinding::lifted);
    EXPECT_FALSE(ratings().to_rate(educator).at(0).blind);
    ratings().discard(educator, id);
    ratings().begin(educator, attempt, form_named("goals"));
    EXPECT_EQ(ratings().of_attempt(educator, attempt).rows.at(0).blinding, Blinding::lifted)
        << "seen once is seen";
    ratings().note_seen(programme.session("ann"), attempt);  // a trainee rates nobody
    Query rows(programme.store->connection(), "SELECT COUNT(*) FROM rating_seen");
    ASSERT_TRUE(rows.next());
    EXPECT_EQ(rows.integer(0), 1);
}

TEST_F(RatingsOfAnAttempt, AFormIsHandedInAsNotBlindWhereTheRaterSawTheAttemptElsewhere) {
    const Session& educator = programme.session("educator");
    const ObserverForm& goals = form_named("goals");
    const std::string id = ratings().begin(educator, attempt, goals);
    // As an exchange brings it from another station.
    Query(programme.store->connection(),
          "INSERT INTO rating_seen (attempt_id, person_id, time) VALUES (?, ?, ?)")
        .bind(attempt)
        .bind(educator.person_id())
        .bind(noon)
        .run();
    ratings().answer(educator, id, all_of(goals, 4), std::vector<bool>(goals.items.size(), true), "");
    ratings().hand_in(educator, id);
    const AttemptRatings handed_in = ratings().of_attempt(educator, attempt);
    ASSERT_EQ(handed_in.rows.size(), 1U);
    EXPECT_GT(handed_in.rows[0].handed_in, 0);
    EXPECT_EQ(handed_in.rows[0].blinding, Blinding::lifted);
    const auto deed = Audit(*programme.store).entries(programme.session("administrator"), {}).front();
    EXPECT_EQ(deed.operation, "rating.hand_in");
    EXPECT_NE(deed.payload.find("lifted"), std::string::npos) << deed.payload;
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
    rate("other_educator", attempt, 3);
    for (const RatingRow& row : ratings().of_attempt(programme.session("other_educator"), attempt).rows)
        EXPECT_EQ(row.blinding, row.id == id ? Blinding::lifted : Blinding::kept);
}

TEST_F(RatingsOfAnAttempt, ACopyForAnotherPersonIsNotBlindForThoseWhoSawTheOriginal) {
    const Session &educator = programme.session("educator"), &other = programme.session("other_educator");
    const Attempts attempts = programme.attempts();
    ratings().note_seen(educator, attempt);
    const std::string copy = attempts.reassign(educator, attempt, programme.id("ben"), "Ben sat there");
    ASSERT_EQ(ratings().to_rate(educator).size(), 1U);
    EXPECT_EQ(ratings().to_rate(educator)[0].attempt_id, copy);
    EXPECT_FALSE(ratings().to_rate(educator)[0].blind);
    EXPECT_TRUE(ratings().to_rate(other).at(0).blind);
    // A copy of the copy too.
    const std::string second = attempts.reassign(educator, copy, programme.id("ann"), "it was Ann");
    EXPECT_FALSE(ratings().to_rate(educator).at(0).blind);
    ratings().begin(educator, second, form_named("goals"));
    EXPECT_EQ(ratings().of_attempt(educator, second).rows.at(0).blinding, Blinding::lifted);
    ratings().begin(other, second, form_named("goals"));
    EXPECT_EQ(ratings().of_attempt(other, second).rows.at(0).blinding, Blinding::kept);
}

TEST_F(RatingsOfAnAttempt, NothingChangesWhatWasHandedInAndNoScoreMoves) {
    const auto scores_before = programme.attempts().scores(programme.session("director"), attempt);
    const std::string id = rate("educator", attempt, 4);
    const Session& educator = programme.session("educator");
    const ObserverForm& goals = form_named("goals");
    EXPECT_EQ(
        error_kind([&] { ratings().answer(educator, id, all_of(goals, 5), std::vector<bool>(5, true), ""); }),
        StoreErrorKind::conflict);
    EXPECT_EQ(error_kind([&] { ratings().hand_in(educator, id); }), StoreErrorKind::conflict);
    EXPECT_EQ(error_kind([&] { ratings().discard(educator, id); }), StoreErrorKind::conflict);
    EXPECT_EQ(error_kind([&] { ratings().begin(educator, attempt, goals); }), StoreErrorKind::conflict);
    Connection& connection = programme.store->connection();
    for (const char* sql :
         {"UPDATE rating SET remark = 'x'", "DELETE FROM rating_item", "DELETE FROM rating",
          "UPDATE rating_item SET value = 5", "UPDATE form_text SET text = ''", "DELETE FROM form_text",
          "INSERT INTO rating_item SELECT id, 40, 'more', 1 FROM rating"})
        EXPECT_THROW(connection.execute(sql), StoreError) << sql;
    const auto scores_after = programme.attempts().scores(programme.session("director"), attempt);
    ASSERT_EQ(scores_after.size(), scores_before.size());
    EXPECT_EQ(scores_after[0].id, scores_before[0].id);
    EXPECT_EQ(scores_after[0].points, scores_before[0].points);
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
    const auto deed = Audit(*programme.store).entries(programme.session("administrator"), {}).front();
    EXPECT_EQ(deed.operation, "rating.hand_in");
    EXPECT_EQ(deed.person_name, "Ann Trainee");
    EXPECT_NE(deed.payload.find("goals@1"), std::string::npos);
}

TEST_F(RatingsOfAnAttempt, BadInputIsRefusedInPlainWords) {
    const Session& educator = programme.session("educator");
    const ObserverForm& goals = form_named("goals");
    const std::string id = ratings().begin(educator, attempt, goals);
    const std::vector<bool> all(5, true);
    FormAnswers answers = all_of(goals, 3);
    const auto refused = [&](const FormAnswers& given, const std::vector<bool>& answered,
                             const std::string& remark) {
        return error_kind([&] { ratings().answer(educator, id, given, answered, remark); });
    };
    answers[2] = 6;
    EXPECT_EQ(refused(answers, all, ""), StoreErrorKind::bad_value);
    answers[2] = 0;
    EXPECT_EQ(refused(answers, all, ""), StoreErrorKind::bad_value);
    answers[2] = std::nullopt;
    EXPECT_EQ(refused(answers, all, ""), StoreErrorKind::bad_value) << "no item of GOALS may be left out";
    EXPECT_EQ(refused(FormAnswers(4, 3), std::vector<bool>(4, true), ""), StoreErrorKind::bad_value);
    EXPECT_EQ(refused(all_of(goals, 3), all, std::string(4001, 'x')), StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] { ratings().hand_in(educator, id); }), StoreErrorKind::bad_value) << "empty";
    EXPECT_EQ(error_kind([&] { ratings().hand_in(educator, "none"); }), StoreErrorKind::not_found);
    EXPECT_EQ(error_kind([&] { ratings().begin(educator, "none", goals); }), StoreErrorKind::not_found);
    EXPECT_EQ(error_kind([&] { ratings().begin(educator, attempt, form_named("osats")); }),
              StoreErrorKind::conflict)
        << "one form at a time";
    const std::string voided = programme.record("ben");
    programme.attempts().void_attempt(educator, voided, "the wrong scene");
    EXPECT_EQ(error_kind([&] { ratings().begin(educator, voided, goals); }), StoreErrorKind::conflict);
    EXPECT_THROW(ratings().begin(programme.session("ann"), attempt, goals), AccessDenied);
}

TEST_F(RatingsOfAnAttempt, ListToRateNamesNobodyAndLeavesOutWhatCannotBeRated) {
    const std::string bens = programme.record("ben");
    const std::string voided = programme.record("ben");
    const std::string eves = programme.record("eve");
    programme.attempts().void_attempt(programme.session("educator"), voided, "the wrong scene");
    std::set<std::string> listed;
    for (const RatableAttempt& one : ratings().to_rate(programme.session("educator")))
        listed.insert(one.attempt_id);
    EXPECT_EQ(listed, (std::set<std::string>{attempt, bens})) << "Eve is of another cohort";
    EXPECT_EQ(ratings().to_rate(programme.session("director")).size(), 3U);
    EXPECT_THROW(ratings().to_rate(programme.session("ann")), AccessDenied);
    rate("educator", attempt, 4);
    rate("other_educator", attempt, 3);
    ratings().begin(programme.session("educator"), bens, form_named("goals"));
    for (const RatableAttempt& one : ratings().to_rate(programme.session("educator"))) {
        EXPECT_EQ(one.handed_in, one.attempt_id == attempt ? 2 : 0);
        EXPECT_EQ(one.own_handed_in, one.attempt_id == attempt ? 1 : 0);
        EXPECT_EQ(one.own_draft, one.attempt_id == bens);
        EXPECT_EQ(one.task_id, "A2");
    }
}

TEST_F(RatingsOfAnAttempt, AgreementIsOverTheAttemptsThatTheSameRatersRated) {
    std::vector<std::string> attempts = {attempt, programme.record("ben"), programme.record("ben"),
                                         programme.record("ann")};
    for (std::size_t i = 0; i < attempts.size(); ++i) {
        rate("educator", attempts[i], static_cast<int>(i) + 1);
        if (i < 3) rate("other_educator", attempts[i], static_cast<int>(i) + 2);
    }
    rate("director", attempts[0], 5, "osats");
    const std::vector<FormAgreement> found = ratings().agreement(programme.session("educator"));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].form, "goals@1");
    EXPECT_EQ(found[0].forms, 7);
    EXPECT_EQ(found[0].attempts, 3);
    EXPECT_EQ(found[0].raters, 2);
    ASSERT_TRUE(found[0].icc);
    // One rater is always a step above: MS between 2 steps^2, raters 1.5, residual 0.
    EXPECT_NEAR(found[0].icc->value, 2.0 / (2.0 + 2 * 1.5 / 3), 1e-6);
    EXPECT_EQ(found[1].form, "osats@1");
    EXPECT_FALSE(found[1].icc);
    EXPECT_EQ(found[1].attempts, 0);
    programme.attempts().void_attempt(programme.session("educator"), attempts[2], "the wrong scene");
    EXPECT_EQ(ratings().agreement(programme.session("educator"))[0].attempts, 2);
}

TEST_F(RatingsOfAnAttempt, TwoAccountsOfOneRaterAreNotTwoRatersWhoAgree) {
    const std::vector<std::string> attempts = {attempt, programme.record("ben"), programme.record("ben")};
    for (std::size_t i = 0; i < attempts.size(); ++i) {
        rate("educator", attempts[i], static_cast<int>(i) + 1);
        rate("other_educator", attempts[i], static_cast<int>(i) + 1);
    }
    ASSERT_EQ(ratings().agreement(programme.session("educator"))[0].raters, 2);
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("other_educator"), programme.id("educator"),
               "entered twice");
    FormAgreement alone = ratings().agreement(programme.session("educator"))[0];
    EXPECT_EQ(alone.forms, 6);
    EXPECT_EQ(alone.raters, 0);
    EXPECT_FALSE(alone.icc) << "nobody else has rated";
    // With a third person it is two raters, and of the two forms of the merged one the newer counts.
    for (std::size_t i = 0; i < attempts.size(); ++i) rate("director", attempts[i], static_cast<int>(i) + 2);
    alone = ratings().agreement(programme.session("educator"))[0];
    EXPECT_EQ(alone.raters, 2);
    EXPECT_EQ(alone.attempts, 3);
}

TEST_F(RatingsOfAnAttempt, WhateverIsEnteredIsReadBackAndOnlyWithinTheScale) {
    const Session& educator = programme.session("educator");
    const ObserverForm& gas = form_named("gas");
    const std::string id = ratings().begin(educator, attempt, gas);
    EXPECT_TRUE(rc::check([&] {
        const auto given = *rc::gen::container<std::vector<int>>(gas.items.size(), rc::gen::inRange(-1, 8));
        FormAnswers answers;
        std::vector<bool> answered;
        bool good = true;
        for (const int value : given) {
            // 0: not yet, 7: not seen.
            answered.push_back(value != 0);
            answers.push_back(value == 0 || value == 7 ? std::optional<int>() : value);
            good = good && value >= 0;
        }
        try {
            ratings().answer(educator, id, answers, answered, "");
            RC_ASSERT(good);
        } catch (const StoreError& error) {
            RC_ASSERT(!good);
            return;
        }
        const RatingRow row = ratings().of_attempt(educator, attempt).rows.at(0);
        RC_ASSERT(row.answers == answers);
        RC_ASSERT(row.answered == answered);
    }));
}

}  // namespace
}  // namespace fulcrum::database::test
