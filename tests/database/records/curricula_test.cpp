// SPDX-License-Identifier: GPL-3.0-or-later
// Who follows which version of the curriculum: the one of the first attempt until an educator moves the
// person; what was passed or declared stays; an edited version is refused, one that is not here stops nobody
// else.
#include "database/records/curricula.h"

#include <gtest/gtest.h>

#include "assessment/assets/assets.h"
#include "database/records/certificates.h"
#include "database/records/person_merge.h"
#include "database/records/recorder.h"
#include "database/records/report_data.h"
#include "database/records/standings.h"
#include "database/rows/crypto.h"
#include "sim_core/numerics/input_error.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database {
namespace {

using test::error_kind;
using test::Programme;

/// Version 2 asks more of A2 and no longer has B3; version 1 is the one that was delivered first.
Curriculum installed() {
    const Curriculum all = load_versions(asset_path("curricula"), "rectal", task_ids());
    Curriculum newest = *all.version_named("rectal@2");
    newest.older = {*all.version_named("rectal@1")};
    for (CurriculumTask& task : newest.tasks)
        if (task.task == "A2") task.rule = parse_pass_rule("row:9");
    for (CurriculumTask& task : newest.tasks)
        if (task.task == "C4") task.after = {"B1", "B2"};
    newest.tasks.erase(std::remove_if(newest.tasks.begin(), newest.tasks.end(),
                                      [](const CurriculumTask& task) { return task.task == "B3"; }),
                       newest.tasks.end());
    return newest;
}

struct Followers {
    Programme programme;
    Curriculum newest = installed();
    Curricula curricula{*programme.store};
    const Session& educator = programme.session("educator");

    /// The table of a cohort finds it among the attempts that it has read, and says the same.
    std::string of(const std::string& login) const {
        const std::string name = curricula.followed(educator, programme.id(login), newest).back().name;
        CohortTableOptions options;
        options.curriculum = &newest;
        const CohortTable table = Reports(*programme.store).cohort_table(educator, programme.cohort, options);
        const auto row = std::find_if(table.standings.begin(), table.standings.end(),
                                      [&](const PersonStandings& one) { return one.login == login; });
        if (row == table.standings.end())
            ADD_FAILURE() << login << " is not in the cohort";
        else
            EXPECT_EQ(row->curriculum, name) << login;
        return name;
    }
    /// An attempt that names the curriculum and its file, as the program stores it.
    std::string record(const std::string& login, const Curriculum& curriculum) const {
        AttemptMeta meta = test::example_meta(programme.id(login));
        meta.curriculum = curriculum.name();
        meta.assets.push_back({"curricula/" + curriculum.file, sha256_hex(curriculum.text)});
        Recorder recorder(programme.path, programme.session(login), meta, programme.clock.options());
        Programme::append_second(recorder);
        recorder.finish(test::example_result(true, 70));
        return recorder.attempt_id();
    }
};

TEST(Curricula, APersonStaysOnTheVersionOfTheFirstAttempt) {
    const Followers one;
    EXPECT_EQ(one.of("ann"), "rectal@2") << "has not begun";
    one.programme.record("ann");  // from before attempts named it
    EXPECT_EQ(one.of("ann"), "rectal@1");
    one.programme.clock.pass_s(10);
    one.record("ann", one.newest);
    EXPECT_EQ(one.of("ann"), "rectal@1") << "only the first attempt decides";
    one.record("ben", one.newest);
    EXPECT_EQ(one.of("ben"), "rectal@2");
    EXPECT_EQ(&one.curricula.in_force(one.educator, one.programme.id("ann"), one.newest),
              &one.newest.older[0]);
}

TEST(Curricula, NeitherAReassignedNorAVoidedAttemptDecides) {
    const Followers one;
    using Counts = std::map<std::string, int>;
    const std::string of_ben = one.record("ann", *one.newest.version_named("rectal@1"));
    one.programme.clock.pass_s(10);
    one.record("ben", one.newest);
    EXPECT_EQ(one.of("ann"), "rectal@1");
    one.programme.attempts().reassign(one.educator, of_ben, one.programme.id("ben"), "Ben sat there");
    EXPECT_EQ(one.of("ben"), "rectal@2") << "the copy is older and names what ann followed";
    EXPECT_EQ(one.of("ann"), "rectal@2") << "as if she had not begun";
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@2", 1}}));
    EXPECT_NO_THROW(one.curricula.check(one.newest));

    one.programme.clock.pass_s(10);
    const std::string by_mistake = one.record("ann", *one.newest.version_named("rectal@1"));
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@1", 1}, {"rectal@2", 1}}));
    one.programme.attempts().void_attempt(one.educator, by_mistake, "started by mistake");
    one.programme.clock.pass_s(10);
    one.record("ann", one.newest);
    EXPECT_EQ(one.of("ann"), "rectal@2");
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@2", 2}}));
}

TEST(Curricula, AnAttemptThatIsReassignedBackDecidesAgain) {
    const Followers one;
    const Attempts attempts = one.programme.attempts();
    const std::string first = one.record("ann", *one.newest.version_named("rectal@1"));
    one.programme.clock.pass_s(10);
    const std::string of_ben = attempts.reassign(one.educator, first, one.programme.id("ben"), "Ben's");
    EXPECT_EQ(one.of("ann"), "rectal@2");
    one.programme.clock.pass_s(10);
    attempts.reassign(one.educator, of_ben, one.programme.id("ann"), "Ann's after all");
    EXPECT_EQ(one.of("ann"), "rectal@1") << "she began with it";
    EXPECT_EQ(one.of("ben"), "rectal@2");
    EXPECT_EQ(one.curricula.people(one.newest), (std::map<std::string, int>{{"rectal@1", 1}}));
}

TEST(Curricula, AMergePutsTheAccountThatStaysOnNoOtherVersion) {
    const Followers one;
    const PersonMerge merge(*one.programme.store);
    const Session& administrator = one.programme.session("administrator");
    using Counts = std::map<std::string, int>;
    one.record("eve", *one.newest.version_named("rectal@1"));
    one.programme.clock.pass_s(3600);
    one.record("ann", one.newest);
    merge.merge(administrator, one.programme.id("eve"), one.programme.id("ann"), "entered twice");
    EXPECT_EQ(one.of("ann"), "rectal@2");
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@2", 1}}));
    const auto followed = one.curricula.assignments(one.educator, one.programme.id("ann"), one.newest);
    ASSERT_EQ(followed.size(), 2U);
    EXPECT_EQ(curriculum_at(followed, followed[1].time - 1)->name(), "rectal@1")
        << "what was done under the other one";
    // Where the account that stays has not begun, it follows what the other one did, also once it begins.
    merge.undo(administrator, one.programme.id("eve"), "for a look");
    merge.merge(administrator, one.programme.id("eve"), one.programme.id("ben"), "entered twice");
    EXPECT_EQ(one.of("ben"), "rectal@1");
    one.programme.clock.pass_s(10);
    one.record("ben", *one.newest.version_named("rectal@1"));
    EXPECT_EQ(one.of("ben"), "rectal@1");
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@1", 1}, {"rectal@2", 1}}));
}

TEST(Curricula, ADecisionMovesNobodyWhoHadBegunBefore) {
    const Followers one;
    const PersonMerge merge(*one.programme.store);
    const Session& administrator = one.programme.session("administrator");
    using Counts = std::map<std::string, int>;
    const auto decide = [&](const char* login) {
        one.programme.clock.pass_s(10);
        Standings(*one.programme.store)
            .decide(one.educator, one.programme.id(login), "A1", StandingOverride::Kind::proficient,
                    "examined in theatre", &one.newest);
    };
    const auto arrives_later = [&](const char* login, const Curriculum& curriculum) {
        one.programme.clock.set_forward_s(-7200);
        const std::string attempt = one.record(login, curriculum);
        one.programme.clock.set_forward_s(7200);
        return attempt;
    };
    const Curriculum& older = *one.newest.version_named("rectal@1");
    // By a merge.
    one.record("eve", older);
    one.programme.clock.pass_s(3600);
    decide("ann");
    EXPECT_EQ(one.of("ann"), "rectal@2");
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@1", 1}, {"rectal@2", 1}}));
    merge.merge(administrator, one.programme.id("eve"), one.programme.id("ann"), "entered twice");
    EXPECT_EQ(one.of("ann"), "rectal@1") << "begun before the decision";
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@1", 1}}));
    merge.undo(administrator, one.programme.id("eve"), "another person after all");
    EXPECT_EQ(one.of("ann"), "rectal@2");
    // By an exchange.
    const std::string attempt = arrives_later("ann", older);
    EXPECT_EQ(one.of("ann"), "rectal@1");
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@1", 2}}));
    one.programme.attempts().void_attempt(one.educator, attempt, "started by mistake");
    EXPECT_EQ(one.of("ann"), "rectal@2") << "as if she had not begun";
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@1", 1}, {"rectal@2", 1}}));
    one.programme.clock.pass_s(10);
    one.record("ann", older);
    EXPECT_EQ(one.of("ann"), "rectal@2") << "begun after the decision";
    EXPECT_EQ(one.curricula.followed(one.educator, one.programme.id("ann"), one.newest)[0].name, "rectal@2")
        << "so it moved nobody";
    // A move on purpose counts, whatever comes later.
    one.programme.clock.pass_s(10);
    one.curricula.move(one.educator, {one.programme.id("ben")}, one.newest, "rectal@1", "course of spring");
    arrives_later("ben", one.newest);
    decide("ben");
    EXPECT_EQ(one.of("ben"), "rectal@1");
    EXPECT_TRUE(one.programme.store->check(administrator).ok);
}

TEST(Curricula, ADecisionKeepsTheVersionAlsoWhereTheAttemptsAreVoidedLater) {
    const Followers one;
    const auto decide = [&](const char* task) {
        one.programme.clock.pass_s(10);
        Standings(*one.programme.store)
            .decide(one.educator, one.programme.id("ann"), task, StandingOverride::Kind::proficient,
                    "examined in theatre", &one.newest);
    };
    const std::string attempt = one.record("ann", *one.newest.version_named("rectal@1"));
    decide("A1");
    decide("A2");
    EXPECT_EQ(one.curricula.followed(one.educator, one.programme.id("ann"), one.newest).size(), 1U);
    one.programme.attempts().void_attempt(one.educator, attempt, "the camera was off");
    EXPECT_EQ(one.of("ann"), "rectal@1") << "what was decided was decided under it";
    EXPECT_EQ(one.curricula.people(one.newest), (std::map<std::string, int>{{"rectal@1", 1}}));
}

TEST(Curricula, MovesOfAMergedAccountDoNotMoveWhoeverHasBegunUnderTheOneThatStays) {
    const Followers one;
    const PersonMerge merge(*one.programme.store);
    const Session& administrator = one.programme.session("administrator");
    using Counts = std::map<std::string, int>;
    const std::string &ann = one.programme.id("ann"), &ben = one.programme.id("ben"),
                      &eve = one.programme.id("eve");
    one.programme.people().set_members(one.programme.session("director"), one.programme.cohort,
                                       {ann, ben, eve});
    one.record("eve", *one.newest.version_named("rectal@1"));
    one.programme.clock.pass_s(3600);
    one.record("ann", *one.newest.version_named("rectal@1"));
    one.programme.clock.pass_s(3600);
    ASSERT_EQ(one.curricula.move(one.educator, {eve}, one.newest, "rectal@2", "another course"), 1);
    merge.merge(administrator, eve, ann, "entered twice");
    EXPECT_EQ(one.of("ann"), "rectal@1") << "it was the other account that was moved";
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@1", 1}}));
    one.programme.clock.pass_s(10);
    EXPECT_EQ(one.curricula.move(one.educator, {ann}, one.newest, "rectal@2", "new rules"), 1);
    EXPECT_EQ(one.of("ann"), "rectal@2");
    merge.undo(administrator, eve, "another person after all");
    merge.merge(administrator, eve, ben, "entered twice");
    EXPECT_EQ(one.of("ben"), "rectal@2") << "has begun nothing: all that the other account did counts";
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@2", 2}}));
}

TEST(Curricula, AMoveThatAnotherAccountOfThePersonMadeDoesNotCountAfterAMerge) {
    const Followers one;
    const Session& administrator = one.programme.session("administrator");
    one.programme.people().set_roles(administrator, one.programme.id("educator"),
                                     {Role::educator, Role::trainee});
    one.record("ann", one.newest);
    one.programme.clock.pass_s(10);
    one.curricula.move(one.educator, {one.programme.id("ann")}, one.newest, "rectal@1", "easier");
    EXPECT_EQ(one.of("ann"), "rectal@1");
    PersonMerge(*one.programme.store)
        .merge(administrator, one.programme.id("ann"), one.programme.id("educator"), "one person");
    const Session& director = one.programme.session("director");
    EXPECT_EQ(one.curricula.in_force(director, one.programme.id("educator"), one.newest).name(), "rectal@2");
    EXPECT_EQ(one.curricula.people(one.newest), (std::map<std::string, int>{{"rectal@2", 1}}));
}

TEST(Curricula, AMoveKeepsWhatWasDeclaredAndIsAudited) {
    const Followers one;
    const Standings standings(*one.programme.store);
    one.programme.record("ann");
    one.programme.clock.pass_s(10);
    standings.decide(one.educator, one.programme.id("ann"), "A2", StandingOverride::Kind::proficient, "seen");
    one.programme.clock.pass_s(10);
    const std::int64_t before_move = one.programme.store->now();
    const auto changes = one.curricula.preview(one.educator, one.programme.id("ann"), one.newest, "rectal@2");
    ASSERT_EQ(changes.size(), 2U) << "B3 is gone, C4 waits for less";
    EXPECT_EQ(changes[0].task, "B3");
    EXPECT_TRUE(changes[0].only_before);
    EXPECT_EQ(changes[1].task, "C4");
    EXPECT_EQ(one.of("ann"), "rectal@1") << "a preview moves nobody";

    one.programme.clock.pass_s(10);
    EXPECT_EQ(one.curricula.move(one.educator, {one.programme.id("ann"), one.programme.id("ben")}, one.newest,
                                 "rectal@1", "course of spring"),
              1)
        << "ann follows it already";
    EXPECT_EQ(one.of("ben"), "rectal@1");
    EXPECT_EQ(
        one.curricula.move(one.educator, {one.programme.id("ann")}, one.newest, "rectal@2", "new rules"), 1);
    const PersonRecord record = standings.record(one.educator, one.programme.id("ann"), one.newest);
    const auto of = [](const std::vector<TaskStanding>& all, const std::string& task) {
        for (const TaskStanding& row : all)
            if (row.task == task) return row.standing;
        return Standing::locked;
    };
    EXPECT_EQ(of(standing_of(record, one.programme.store->now()), "A2"), Standing::proficient)
        << "declared stays declared under the harder rule";
    EXPECT_EQ(standing_of(record, before_move).size(), 7U) << "the past is not changed";
    EXPECT_EQ(standing_of(record, one.programme.store->now()).size(), 6U);
    const auto followed =
        one.curricula.followed(one.programme.session("ann"), one.programme.id("ann"), one.newest);
    ASSERT_EQ(followed.size(), 2U);
    EXPECT_EQ(followed[1].moved_by, "Edu Cator");
    EXPECT_EQ(followed[1].reason, "new rules");
    const auto entries = Audit(*one.programme.store).entries(one.programme.session("administrator"));
    EXPECT_EQ(std::count_if(entries.begin(), entries.end(),
                            [](const auto& entry) { return entry.operation == "curriculum.move"; }),
              2);
    EXPECT_TRUE(one.programme.store->check(one.programme.session("administrator")).ok);
}

TEST(Curricula, AMoveAheadOfTheClockIsFollowedFromItsTimeOn) {
    const Followers one;
    one.programme.record("ann");
    one.programme.clock.set_forward_s(3600);
    ASSERT_EQ(one.curricula.move(one.educator, {one.programme.id("ann")}, one.newest, "rectal@2", "new"), 1);
    one.programme.clock.set_forward_s(-3000);
    const auto in_force = [&] {
        return one.curricula.in_force(one.educator, one.programme.id("ann"), one.newest).name();
    };
    EXPECT_EQ(in_force(), "rectal@1");
    // B3, which the later version lacks, has a standing still.
    EXPECT_TRUE(
        certificates(*one.programme.store, one.programme.session("ann"), one.programme.id("ann"), one.newest)
            .empty());
    one.programme.clock.set_forward_s(3000);
    EXPECT_EQ(in_force(), "rectal@2");
}

TEST(Curricula, AMoveAfterOneThatIsAheadOfTheClockIsTheLast) {
    const Followers one;
    one.programme.record("ann");
    const std::vector<std::string> ann = {one.programme.id("ann")};
    one.programme.clock.set_forward_s(3600);
    ASSERT_EQ(one.curricula.move(one.educator, ann, one.newest, "rectal@2", "new"), 1);
    one.programme.clock.set_forward_s(-3000);
    EXPECT_EQ(one.curricula.move(one.educator, ann, one.newest, "rectal@1", "she stays"), 1);
    one.programme.clock.set_forward_s(3001);
    EXPECT_EQ(one.curricula.in_force(one.educator, ann[0], one.newest).name(), "rectal@1");
}

TEST(Curricula, AVoidAheadOfTheClockCountsFromItsArrival) {
    const Followers one;
    const std::string voided = one.programme.record("ann");
    one.programme.clock.set_forward_s(3600);
    one.programme.attempts().void_attempt(one.educator, voided, "the wrong person");
    one.programme.clock.set_forward_s(-3000);
    const PersonRecord record =
        Standings(*one.programme.store).record(one.educator, one.programme.id("ann"), one.newest);
    for (const TaskStanding& task : standing_of(record, one.programme.store->now()))
        EXPECT_EQ(task.attempts, 0) << task.task;
}

TEST(Curricula, AnybodyEnteredTwiceIsCountedOnce) {
    const Followers one;
    const PersonMerge merge(*one.programme.store);
    const Session& administrator = one.programme.session("administrator");
    using Counts = std::map<std::string, int>;
    one.record("ann", *one.newest.version_named("rectal@1"));
    one.programme.clock.pass_s(10);
    one.record("eve", one.newest);
    one.record("ben", one.newest);
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@1", 1}, {"rectal@2", 2}}));
    merge.merge(administrator, one.programme.id("eve"), one.programme.id("ann"), "the same person");
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@1", 1}, {"rectal@2", 1}}))
        << "the first attempt of both";
    EXPECT_EQ(one.of("ann"), "rectal@1");
    merge.undo(administrator, one.programme.id("eve"), "another person after all");
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@1", 1}, {"rectal@2", 2}}));

    // A move under one of the two ids is one of the person.
    one.programme.clock.pass_s(10);
    one.curricula.move(one.educator, {one.programme.id("ann")}, one.newest, "rectal@2", "new rules");
    one.programme.clock.pass_s(10);
    merge.merge(administrator, one.programme.id("ann"), one.programme.id("ben"), "the same person");
    EXPECT_EQ(one.of("ben"), "rectal@2");
    EXPECT_EQ(one.curricula.people(one.newest), (Counts{{"rectal@2", 2}}));
}

TEST(Curricula, CohortTablesShowEachPersonUnderTheirOwnVersion) {
    const Followers one;
    one.programme.record("ann");
    one.record("ben", one.newest);
    CohortTableOptions options;
    options.curriculum = &one.newest;
    const CohortTable table =
        Reports(*one.programme.store).cohort_table(one.educator, one.programme.cohort, options);
    ASSERT_GE(table.standings.size(), 2U);
    for (const PersonStandings& person : table.standings) {
        EXPECT_EQ(person.tasks.size(), one.newest.tasks.size()) << person.login;
        EXPECT_EQ(person.curriculum, person.login == "ann" ? "rectal@1" : "rectal@2") << person.login;
    }
}

TEST(Curricula, MovesThatCannotBeAreRefusedAsAWhole) {
    const Followers one;
    const std::vector<std::string> both = {one.programme.id("ann"), one.programme.id("ben")};
    EXPECT_EQ(error_kind([&] { one.curricula.move(one.educator, both, one.newest, "rectal@9", "x"); }),
              StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] { one.curricula.move(one.educator, both, one.newest, "rectal@1", " \n"); }),
              StoreErrorKind::bad_value);
    EXPECT_THROW(one.curricula.move(one.programme.session("ann"), {one.programme.id("ann")}, one.newest,
                                    "rectal@1", "mine"),
                 AccessDenied);
    EXPECT_THROW(
        one.curricula.move(one.programme.session("other_educator"), both, one.newest, "rectal@1", "x"),
        AccessDenied);
    EXPECT_EQ(one.of("ann"), "rectal@2");
    EXPECT_EQ(one.of("ben"), "rectal@2");
}

TEST(Curricula, AnEditedVersionThatPeopleFollowIsRefused) {
    const Followers one;
    EXPECT_NO_THROW(one.curricula.check(one.newest));
    one.record("ann", one.newest);
    EXPECT_NO_THROW(one.curricula.check(one.newest));
    Curriculum edited = one.newest;
    edited.text += " ";
    try {
        one.curricula.check(edited);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(),
                  "this file says it is rectal@2, but the rectal@2 that people follow (how many: 1) has "
                  "different content");
        EXPECT_NE(error.hint().find("/version raised"), std::string::npos);
    }
    // With the version raised and the followed one next to it, the change is a new version.
    edited.version = 3;
    edited.older.insert(edited.older.begin(), one.newest);
    EXPECT_NO_THROW(one.curricula.check(edited));
    EXPECT_EQ(one.curricula.followed(one.educator, one.programme.id("ann"), edited).back().name, "rectal@2");
}

TEST(Curricula, AVersionThatIsNotInstalledStopsNobodyElse) {
    const Followers one;
    one.programme.record("ben");  // from before attempts named a version: rectal@1
    one.record("ann", one.newest);
    const std::string ann = one.programme.id("ann"), ben = one.programme.id("ben");
    Curriculum here = *one.newest.version_named("rectal@1");
    const auto missing = one.curricula.check(here);
    ASSERT_EQ(missing.size(), 1U);
    EXPECT_EQ(missing[0].words().words(),
              "the curriculum rectal@2 is not installed, but people follow it (how many: 1)");
    EXPECT_EQ(one.curricula.missing(one.educator, ann, here), "rectal@2");
    EXPECT_EQ(one.curricula.missing(one.educator, ben, here), "");
    // Nothing is said of the standing of Ann, and she gets no certificate of another version.
    const Session& director = one.programme.session("director");
    EXPECT_EQ(error_kind([&] { certificates(*one.programme.store, director, ann, here); }),
              StoreErrorKind::bad_value);
    EXPECT_NO_THROW(certificates(*one.programme.store, director, ben, here));
    EXPECT_EQ(error_kind([&] { find_certificate(*one.programme.store, director, "0000", here); }),
              StoreErrorKind::bad_value)
        << "it may be one of hers";
    EXPECT_EQ(error_kind([&] { one.curricula.move(one.educator, {ann}, here, "rectal@1", "x"); }),
              StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] { one.curricula.preview(one.educator, ann, here, "rectal@1"); }),
              StoreErrorKind::bad_value);
    CohortTableOptions options;
    options.curriculum = &here;
    const CohortTable table =
        Reports(*one.programme.store).cohort_table(one.educator, one.programme.cohort, options);
    for (const PersonStandings& person : table.standings) {
        EXPECT_EQ(person.not_here, person.login == "ann") << person.login;
        EXPECT_EQ(person.curriculum == "rectal@2", person.not_here) << person.login;
    }
}

TEST(Curricula, AttemptsThatNameNoVersionAreCountedAndCheckedAsTheFirst) {
    const Followers one;
    one.programme.record("ann");
    EXPECT_EQ(one.curricula.people(one.newest), (std::map<std::string, int>{{"rectal@1", 1}}));
    EXPECT_TRUE(one.curricula.check(one.newest).empty());
}

TEST(Curricula, CheckFindsAMoveThatNobodyMade) {
    const Followers one;
    one.curricula.move(one.educator, {one.programme.id("ann")}, one.newest, "rectal@1", "x");
    Connection& connection = one.programme.store->connection();
    EXPECT_THROW(connection.execute("UPDATE curriculum_move SET curriculum = 'rectal@2'"), StoreError);
    EXPECT_THROW(connection.execute("DELETE FROM curriculum_move"), StoreError);
    const Session& administrator = one.programme.session("administrator");
    EXPECT_TRUE(one.programme.store->check(administrator).ok);
    QString trigger;
    {
        Query made(connection, "SELECT sql FROM sqlite_master WHERE name = 'curriculum_move_is_fixed'");
        ASSERT_TRUE(made.next());
        trigger = QString::fromStdString(made.text(0));
    }
    connection.execute("DROP TRIGGER curriculum_move_is_fixed");
    EXPECT_FALSE(one.programme.store->check(administrator).ok) << "a trigger is missing";
    connection.execute("UPDATE curriculum_move SET curriculum = 'rectal@2'");
    connection.execute(trigger);
    EXPECT_FALSE(one.programme.store->check(administrator).ok);
    connection.execute("DROP TRIGGER curriculum_move_is_fixed");
    connection.execute("UPDATE curriculum_move SET curriculum = 'rectal@1'");
    connection.execute(trigger);
    EXPECT_TRUE(one.programme.store->check(administrator).ok);
    connection.execute(
        "INSERT INTO curriculum_move SELECT 'forged', person_id, curriculum, author_id, time, reason FROM "
        "curriculum_move");
    EXPECT_FALSE(one.programme.store->check(administrator).ok);
}

}  // namespace
}  // namespace fulcrum::database
