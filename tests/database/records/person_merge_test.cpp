// SPDX-License-Identifier: GPL-3.0-or-later
// A person who was entered twice: what was done under both ids is one person's, nothing signed is changed,
// the doubled login ends, and nobody but an administrator, who is neither of the two, can do it.
#include "database/records/person_merge.h"

#include <gtest/gtest.h>

#include "database/records/goals.h"
#include "database/records/ratings.h"
#include "database/records/standings.h"
#include "database/roster/roster_import.h"
#include "database/rows/connection.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database {
namespace {

using test::error_kind;
using test::Programme;

/// Eve, who is in no cohort, is Ann entered again.
class Merge : public ::testing::Test {
  protected:
    Merge() : merge(*programme.store) {
        of_ann = programme.record("ann");
        of_eve = programme.record("eve", true, 81);
    }
    MergePlan done() const {
        return merge.merge(administrator, programme.id("eve"), programme.id("ann"), "the same person");
    }
    std::vector<std::string> attempts_of(const Session& session, const std::string& person) const {
        AttemptFilter filter;
        filter.person_id = person;
        std::vector<std::string> ids;
        for (const AttemptSummary& attempt : programme.attempts().list(session, filter)) {
            EXPECT_EQ(attempt.meta.person_id, person);
            ids.push_back(attempt.meta.id);
        }
        std::sort(ids.begin(), ids.end());
        return ids;
    }
    void expect_sound() const {
        for (const CheckItem& item : programme.store->check(programme.store->station_session()).items)
            EXPECT_TRUE(item.ok) << item.name << ": " << item.problems.front().words();
    }
    static std::vector<std::string> sorted(std::vector<std::string> ids) {
        std::sort(ids.begin(), ids.end());
        return ids;
    }

    Programme programme;
    const Session& administrator = programme.session("administrator");
    const Session& educator = programme.session("educator");
    const Session& ann = programme.session("ann");
    PersonMerge merge;
    std::string of_ann, of_eve;
};

TEST_F(Merge, AttemptsScoresCommentsGoalsAndDecisionsFollowAndNothingSignedIsChanged) {
    GoalWish wish;
    wish.target = 3;
    Goals(*programme.store).set(programme.session("eve"), wish, 20000);
    EXPECT_THROW(programme.attempts().read(educator, of_eve), AccessDenied) << "eve is in no cohort";
    const MergePlan plan = merge.plan(administrator, programme.id("eve"), programme.id("ann"));
    ASSERT_EQ(plan.counts.size(), 2U);
    EXPECT_EQ(plan.counts[0].what.words(), "attempts");
    EXPECT_EQ(plan.counts[0].count, 1);
    EXPECT_EQ(attempts_of(ann, programme.id("ann")), std::vector<std::string>{of_ann})
        << "a plan changes nothing";

    done();
    EXPECT_EQ(attempts_of(ann, programme.id("ann")), sorted({of_ann, of_eve}));
    EXPECT_TRUE(programme.attempts().score(ann, of_eve).has_value());
    EXPECT_EQ(programme.attempts().read_trace(ann, of_eve).samples.size(), 1000U);
    EXPECT_EQ(Goals(*programme.store).of_person(ann, programme.id("ann")).size(), 1U);
    EXPECT_EQ(attempts_of(educator, programme.id("ann")), sorted({of_ann, of_eve}))
        << "of the cohort's educator";
    const Reviews reviews(*programme.store);
    const std::string comment = reviews.write(educator, of_eve, 0.5, "Steadier", true);
    EXPECT_EQ(reviews.unread(ann).size(), 1U);
    reviews.mark_read(ann, comment);
    programme.attempts().void_attempt(educator, of_eve, "a trial");
    const CohortTable table =
        Reports(*programme.store).cohort_table(programme.session("director"), programme.cohort);
    int counted = 0;
    for (const CohortRow& row : table.rows)
        if (row.person_id == programme.id("ann")) counted += row.attempts;
    EXPECT_EQ(counted, 1) << "one of two is voided";
    Query signed_row(programme.store->connection(), "SELECT person_id FROM attempt WHERE id = ?");
    signed_row.bind(of_eve);
    ASSERT_TRUE(signed_row.next());
    EXPECT_EQ(signed_row.text(0), programme.id("eve")) << "as it was signed";
    expect_sound();
}

TEST_F(Merge, TheDoubledLoginEndsAndIsNobodyElses) {
    done();
    const People people = programme.people();
    EXPECT_THROW(people.sign_in("eve", test::password), SignInRefused);
    EXPECT_THROW(programme.attempts().list(programme.session("eve")), AccessDenied) << "her open session";
    people.sign_in("ann", test::password);
    EXPECT_EQ(error_kind([&] { people.create(administrator, "EVE", "Eve Other", {Role::trainee}); }),
              StoreErrorKind::conflict);
    for (const auto& change : std::vector<std::function<void()>>{
             [&] { people.set_active(administrator, programme.id("eve"), true); },
             [&] { people.set_roles(administrator, programme.id("eve"), {Role::trainee}); },
             [&] { people.issue_one_time_password(administrator, programme.id("eve")); }})
        EXPECT_EQ(error_kind(change), StoreErrorKind::conflict);
    EXPECT_EQ(people.find_login(programme.session("director"), "eve")->id, programme.id("ann"));
    for (const RecentSignIn& recent : people.recent_sign_ins(administrator)) EXPECT_NE(recent.login, "eve");
    Roster roster;
    roster.people.push_back({});
    roster.people.back().login = "eve";
    roster.people.back().roles = {Role::trainee};
    const auto steps = RosterImport(*programme.store, administrator).plan_people(roster);
    EXPECT_EQ(steps.at(0).what, PersonImport::What::nothing) << "the next list from the other system";
    people.set_members(programme.session("director"), programme.cohort, {programme.id("eve")});
    EXPECT_EQ(people.find_cohort(programme.session("director"), "Year 1")->members,
              std::vector<std::string>{programme.id("ann")});
}

TEST_F(Merge, IsTheAdministratorsAndNeverForAnAccountOfTheirOwn) {
    for (const char* login : {"ann", "ben", "eve", "educator", "director"}) {
        const Session& session = programme.session(login);
        EXPECT_THROW(merge.plan(session, programme.id("eve"), programme.id("ann")), AccessDenied) << login;
        EXPECT_THROW(merge.merge(session, programme.id("eve"), programme.id("ann"), "x"), AccessDenied)
            << login;
        EXPECT_THROW(merge.undo(session, programme.id("eve"), "x"), AccessDenied) << login;
    }
    programme.people().set_roles(administrator, administrator.person_id(),
                                 {Role::administrator, Role::trainee});
    EXPECT_THROW(merge.merge(administrator, programme.id("eve"), administrator.person_id(), "mine"),
                 AccessDenied);
    const auto kind = [&](const char* from, const char* into, const std::string& reason = "x") {
        return error_kind(
            [&] { merge.merge(administrator, programme.id(from), programme.id(into), reason); });
    };
    EXPECT_EQ(kind("eve", "eve"), StoreErrorKind::bad_value);
    EXPECT_EQ(kind("eve", "ann", " \n"), StoreErrorKind::bad_value);
    EXPECT_EQ(kind("educator", "ann"), StoreErrorKind::conflict) << "ann would become an educator";
    EXPECT_EQ(error_kind([&] { merge.merge(administrator, "nobody", programme.id("ann"), "x"); }),
              StoreErrorKind::not_found);
    done();
    EXPECT_EQ(kind("eve", "ben"), StoreErrorKind::conflict);
    EXPECT_EQ(kind("ben", "eve"), StoreErrorKind::conflict);
    EXPECT_EQ(attempts_of(programme.session("ben"), programme.id("ben")).size(), 0U);
}

TEST_F(Merge, OfAnEducatorMovesCohortsAndDraftsAndCountsOneRater) {
    const Reviews reviews(*programme.store);
    reviews.write(educator, of_ann, 0.5, "A draft", false);
    merge.merge(administrator, programme.id("educator"), programme.id("other_educator"), "married name");
    const Session& other = programme.session("other_educator");
    EXPECT_EQ(reviews.drafts(other).size(), 1U);
    EXPECT_EQ(attempts_of(other, programme.id("ann")).size(), 1U);
    EXPECT_THROW(programme.attempts().list(educator), AccessDenied);
    expect_sound();
}

TEST_F(Merge, IsAuditedOneStepDeepAndCanBeUndone) {
    done();
    programme.record("ben");
    merge.merge(administrator, programme.id("ann"), programme.id("ben"), "all three are one");
    EXPECT_EQ(attempts_of(programme.session("ben"), programme.id("ben")).size(), 3U);
    EXPECT_EQ(Audit(*programme.store).entries(administrator).front().operation, "person.merge");
    expect_sound();
    merge.undo(administrator, programme.id("eve"), "another person after all");
    EXPECT_EQ(attempts_of(programme.session("ben"), programme.id("ben")).size(), 2U);
    EXPECT_EQ(attempts_of(programme.session("director"), programme.id("eve")),
              std::vector<std::string>{of_eve});
    EXPECT_EQ(error_kind([&] { merge.undo(administrator, programme.id("eve"), "again"); }),
              StoreErrorKind::conflict);
    programme.people().set_active(administrator, programme.id("eve"), true);
    expect_sound();
    // By hand, without the deed.
    programme.store->connection().execute(
        "UPDATE person SET merged_into = (SELECT id FROM person WHERE login = 'ben') "
        "WHERE login = 'eve'");
    EXPECT_FALSE(programme.store->check(programme.store->station_session()).ok);
}

TEST_F(Merge, CrosswiseMergesOfTwoStationsHideNobodysAttempts) {
    done();
    programme.store->connection().execute(
        "UPDATE person SET merged_into = (SELECT id FROM person WHERE login = 'eve') "
        "WHERE login = 'ann'");
    const Session& director = programme.session("director");
    EXPECT_EQ(attempts_of(director, programme.id("ann")), std::vector<std::string>{of_ann});
    EXPECT_EQ(attempts_of(director, programme.id("eve")), std::vector<std::string>{of_eve});
}

TEST_F(Merge, WaitsForAnAttemptThatRunsAndTakesWhatComesLater) {
    {
        Recorder recorder(programme.path, programme.session("eve"), test::example_meta(programme.id("eve")),
                          programme.clock.options());
        Programme::append_second(recorder);
        EXPECT_EQ(error_kind([&] { done(); }), StoreErrorKind::locked);
        recorder.finish(test::example_result(true, 70));
    }
    done();
    EXPECT_EQ(attempts_of(ann, programme.id("ann")).size(), 3U);
    EXPECT_THROW(Recorder(programme.path, programme.session("eve"), test::example_meta(programme.id("eve")),
                          programme.clock.options()),
                 AccessDenied);
    done();  // repeated, as after a sync that brought the doubled account's cohort
    expect_sound();
}

TEST_F(Merge, CutOffItIsDoneOrNot) {
    if (!test::can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    programme.store.reset();
    const auto deed = [this] {
        const Store store = Store::open(programme.path, programme.clock.options());
        PersonMerge(store).merge(administrator, programme.id("eve"), programme.id("ann"), "the same person");
    };
    for (int point = 1;; point += 4) {
        const test::CutOff cut = test::cut_off(point, deed);
        programme.open();
        const std::size_t theirs = attempts_of(ann, programme.id("ann")).size();
        EXPECT_TRUE(theirs == 1 || theirs == 2) << cut.call;
        EXPECT_EQ(programme.people().find(administrator, programme.id("eve"))->merged_into.empty(),
                  theirs == 1);
        expect_sound();
        programme.store.reset();
        if (!cut.killed || theirs == 2) break;
    }
}

}  // namespace
}  // namespace fulcrum::database
