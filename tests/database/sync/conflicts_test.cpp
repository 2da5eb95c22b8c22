// SPDX-License-Identifier: GPL-3.0-or-later
// What happens where both sides changed, where an attempt is reassigned elsewhere, and where somebody was
// erased.
#include <set>

#include "database/records/person_merge.h"
#include "database/sync/enrolment.h"
#include "database/sync/server_enrolment.h"
#include "database/sync/trace_fetch.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class SyncConflict : public Sync {
  protected:
    void SetUp() override {
        Sync::SetUp();
        if (IsSkipped()) return;
        sync(a);
        sync(b);
        sync(a);
    }
    static std::string name_of(const Store& store, const std::string& id) {
        Query row(store.connection(), "SELECT display_name FROM person WHERE id = ?");
        row.bind(id);
        return row.next() ? row.text(0) : "";
    }
    Station b;
};

TEST_F(SyncConflict, TheHigherVersionOfAPersonCounts) {
    const std::string ben = a.id("ben");
    a.people().rename(a.session("administrator"), ben, "Ben A");
    const Session at_b = b.sign_in("administrator");
    People(*b.store).rename(at_b, ben, "Ben B");
    People(*b.store).rename(at_b, ben, "Benjamin B");
    sync(a);
    EXPECT_TRUE(sync(b).conflicts.empty()) << "the station that wins has nothing to decide";
    const SyncResult back = sync(a);
    EXPECT_EQ(name_of(*a.store, ben), "Benjamin B");
    EXPECT_EQ(name_of(*b.store, ben), "Benjamin B");
    EXPECT_EQ(back.transferred(), 1);
    expect_sound(*a.store);
    expect_sound(*b.store);
}

TEST_F(SyncConflict, OfEqualVersionsTheServersIsKeptAndTheConflictNamed) {
    const std::string ben = a.id("ben");
    a.people().rename(a.session("administrator"), ben, "Ben A");
    People(*b.store).rename(b.sign_in("administrator"), ben, "Ben B");
    sync(a);
    const SyncResult second = sync(b);
    ASSERT_EQ(second.conflicts.size(), 1U);
    EXPECT_NE(second.conflicts[0].words().find("\"ben\" was changed here and on the server"),
              std::string::npos);
    EXPECT_EQ(name_of(*b.store, ben), "Ben A");
    EXPECT_TRUE(sync(b).conflicts.empty());
    expect_sound(*b.store);
    expect_sound(server);
}

TEST_F(SyncConflict, AChangedPasswordAndCohortReachTheOtherStation) {
    const Session ann = b.sign_in("ann");
    People(*b.store).change_password(ann, password, "another long password");
    a.people().set_members(a.session("director"), a.cohort, {a.id("eve")});
    sync(a);
    sync(b);
    sync(a);
    EXPECT_THROW(a.people().sign_in("ann", password), SignInRefused);
    a.clock.pass_s(600);
    EXPECT_EQ(a.people().sign_in("ann", "another long password").person_id(), a.id("ann"));
    Query members(b.store->connection(), "SELECT person_id FROM cohort_member");
    ASSERT_TRUE(members.next());
    EXPECT_EQ(members.text(0), a.id("eve"));
    EXPECT_FALSE(members.next());
    expect_sound(*a.store);
    expect_sound(*b.store);
}

TEST_F(SyncConflict, AOneTimePasswordOfAnotherStationEndsAfterADayHoweverLongThisMachineHasRun) {
    constexpr double over_a_day_s = 25 * 3600;
    *b.clock.since_boot = {"another machine", 25LL * 3600 * 1000};
    const auto created = a.people().create(a.session("administrator"), "dora", "Dora of A", {Role::trainee});
    sync(a);
    sync(b);
    const auto sign_in = [&] { People(*b.store).sign_in("dora", created.one_time_password); };
    EXPECT_NO_THROW(sign_in());
    b.clock.set_forward_s(over_a_day_s);
    EXPECT_THROW(sign_in(), SignInRefused);
    b.clock.set_forward_s(-over_a_day_s);
    EXPECT_NO_THROW(sign_in()) << "the clock was ahead, and the log has not seen it";
    b.clock.set_forward_s(over_a_day_s);
    b.sign_in("administrator");
    b.clock.set_forward_s(-over_a_day_s);
    EXPECT_THROW(sign_in(), SignInRefused) << "the log has seen the end";
    // Issued here, the time since the start of this machine counts again.
    const std::string here =
        People(*b.store).issue_one_time_password(b.sign_in("administrator"), created.person.id);
    EXPECT_NO_THROW(People(*b.store).sign_in("dora", here));
    b.clock.pass_s(over_a_day_s);
    b.clock.set_forward_s(-over_a_day_s);
    EXPECT_THROW(People(*b.store).sign_in("dora", here), SignInRefused);
}

// Before, the account that came back counted as one whose password another station had issued.
TEST_F(SyncConflict, AOneTimePasswordOfThisStationEndsByItsMachineAlsoAfterAChangeElsewhere) {
    constexpr double over_a_day_s = 25 * 3600;
    *b.clock.since_boot = {"another machine", 0};
    const auto created = a.people().create(a.session("administrator"), "dora", "Dora of A", {Role::trainee});
    sync(a);
    sync(b);
    People(*b.store).rename(b.sign_in("administrator"), created.person.id, "Dora B");
    sync(b);
    sync(a);
    ASSERT_EQ(name_of(*a.store, created.person.id), "Dora B");
    const auto sign_in = [&] { a.people().sign_in("dora", created.one_time_password); };
    EXPECT_NO_THROW(sign_in());
    const auto run_for_a_day_with_the_clock_set_back = [&] {
        a.clock.pass_s(over_a_day_s);
        a.clock.set_forward_s(-over_a_day_s);
    };
    run_for_a_day_with_the_clock_set_back();
    EXPECT_THROW(sign_in(), SignInRefused);
    a.clock.restart();
    run_for_a_day_with_the_clock_set_back();
    EXPECT_THROW(sign_in(), SignInRefused) << "since another start of this machine";
}

TEST_F(SyncConflict, WhatTheLogSawSinceAOneTimePasswordWasIssuedHereCountsAlsoAfterAChangeElsewhere) {
    constexpr double over_a_day_s = 25 * 3600;
    *b.clock.since_boot = {"another machine", 0};
    const auto created = a.people().create(a.session("administrator"), "dora", "Dora of A", {Role::trainee});
    sync(a);
    sync(b);
    People(*b.store).rename(b.sign_in("administrator"), created.person.id, "Dora B");
    sync(b);
    const auto sign_in = [&] { a.people().sign_in("dora", created.one_time_password); };
    EXPECT_NO_THROW(sign_in());
    a.clock.set_forward_s(over_a_day_s);
    a.people().sign_in("administrator", password);
    a.clock.set_forward_s(-over_a_day_s);
    EXPECT_THROW(sign_in(), SignInRefused) << "the log has seen the end";
    sync(a);
    ASSERT_EQ(name_of(*a.store, created.person.id), "Dora B");
    EXPECT_THROW(sign_in(), SignInRefused);
    // Issued at the other station, at the same moment as the first one here: the clock and the log since it
    // came count.
    const std::string next =
        People(*b.store).issue_one_time_password(b.sign_in("administrator"), created.person.id);
    sync(b);
    sync(a);
    EXPECT_NO_THROW(a.people().sign_in("dora", next));
}

TEST_F(SyncConflict, ALoginThatTwoPeopleHaveWaitsAndEverythingElseIsTransferred) {
    const Session at_a = a.session("administrator"), at_b = b.sign_in("administrator");
    a.people().create(at_a, "carl", "Carl of A", {Role::trainee});
    const auto other = People(*b.store).create(at_b, "carl", "Carl of B", {Role::trainee});
    const Session first = People(*b.store).sign_in("carl", other.one_time_password);
    const Session carl = People(*b.store).change_password(first, other.one_time_password, password);
    Recorder recorder(b.path, carl, example_meta(carl.person_id()), b.clock.options());
    Programme::append_second(recorder);
    recorder.finish(example_result(true, 50));
    const std::string ann = b.record("ann", 66);
    sync(a);
    const SyncResult result = sync(b);
    ASSERT_EQ(result.conflicts.size(), 3U);  // the login; the attempt and the score that wait
    EXPECT_NE(result.conflicts[0].words().find("\"carl\""), std::string::npos);
    sync(a);
    EXPECT_EQ(Attempts(*a.store).score(a.session("ann"), ann)->points, 66);
    EXPECT_EQ(name_of(*b.store, carl.person_id()), "Carl of B");
    EXPECT_EQ(sync(b).transferred(), 0);
    expect_sound(*b.store);
    expect_sound(server);
}

TEST_F(SyncConflict, TwoPeopleWithOneLoginAreTransferredOnceOneOfThemHasAnother) {
    a.people().create(a.session("administrator"), "carl", "Carl of A", {Role::trainee});
    const auto carl =
        People(*b.store).create(b.sign_in("administrator"), "carl", "Carl of B", {Role::trainee});
    sync(a);
    const SyncResult refused = sync(b);
    ASSERT_FALSE(refused.conflicts.empty());
    EXPECT_NE(refused.conflicts[0].words().find("people login"), std::string::npos);
    People(*b.store).set_login(b.sign_in("administrator"), carl.person.id, "carl.b");
    EXPECT_TRUE(sync(b).conflicts.empty());
    EXPECT_TRUE(sync(a).conflicts.empty());
    EXPECT_EQ(name_of(*a.store, carl.person.id), "Carl of B");
    for (const Store* store : {a.store.get(), b.store.get()}) {
        Query both(store->connection(),
                   "SELECT COUNT(*) FROM person WHERE (login = 'carl' AND display_name = 'Carl of A') OR "
                   "(login = 'carl.b' AND display_name = 'Carl of B')");
        EXPECT_TRUE(both.next() && both.integer(0) == 2);
        expect_sound(*store);
    }
    expect_sound(server);
}

TEST_F(SyncConflict, WhatTheServersOwnerChangesByHandIsFound) {
    const std::string attempt = fill(a);
    a.open();
    sync(a);
    expect_sound(server);
    Connection connection(server);
    const auto finds = [&](const std::string& sql, const std::string& words) {
        connection.execute("SET session_replication_role = replica");  // no trigger stops the owner
        connection.execute(QString::fromStdString(sql));
        bool found = false;
        for (const Sentence& problem : check_programme_server(server).problems)
            found = found || problem.words().find(words) != std::string::npos;
        EXPECT_TRUE(found) << sql;
    };
    finds("UPDATE score SET points = 99 WHERE attempt_id = '" + attempt + "'", "not as the station");
    finds("DELETE FROM trace_chunk WHERE attempt_id = '" + attempt + "' AND stream = 0", "trace " + attempt);
    finds("UPDATE attempt SET seed = 1 WHERE id = '" + attempt + "'", "attempt " + attempt);
    finds("UPDATE audit_entry SET time = time + 1 WHERE sequence = 3", "changed after it was written");
    finds("UPDATE audit_signature SET signature = 'x' WHERE sequence = 4", "its signature does not fit");
    finds("INSERT INTO attempt_void SELECT id, person_id, 1, 'x' FROM attempt WHERE id = '" + attempt + "'",
          "void of attempt " + attempt + ": there without");
}

// The copy comes back without its trace, which is where the copy was made.
TEST_F(SyncConflict, AnAttemptReassignedAtAnotherStationIsWholeWhereItWasRecorded) {
    const KeysOfOneTest keys;
    enrol_station(*a.store, a.session("administrator"), server,
                  make_enrolment_token(server, "lab", {}, usual_token_h).text);
    const std::string attempt = a.record("ann");
    sync(a);
    sync(b);
    const Session& here = a.session("educator");
    const Session there = b.sign_in("educator");
    const auto reassign = [&] {
        return Attempts(*b.store).reassign(there, attempt, a.id("ben"), "he was the one");
    };
    EXPECT_EQ(error_kind(reassign), StoreErrorKind::not_found) << "his attempt would have no trace anywhere";
    EXPECT_EQ(Attempts(*b.store).read(there, attempt).voided_at, 0);
    fetch_trace(*b.store, there, server, attempt);
    const std::string copy = reassign();
    sync(b);
    sync(a);
    expect_sound(*a.store);
    const auto expect_elsewhere = [&] {
        EXPECT_TRUE(can_fetch_trace(*a.store, here, copy));
        EXPECT_EQ(error_kind([&] { a.attempts().read_trace(here, copy); }), StoreErrorKind::not_found);
        for (const CheckItem& item : a.store->check(a.store->station_session()).items)
            EXPECT_TRUE(item.ok || item.id != CheckId::trace_checksums) << item.problems.front().words();
    };
    expect_elsewhere();
    {
        // As older programs wrote a copy: with the station of the original.
        Connection& connection = a.store->connection();
        const Transaction undone(connection);
        connection.execute("DROP TRIGGER attempt_is_fixed");
        Query(connection, "UPDATE attempt SET station_id = ? WHERE id = ?")
            .bind(a.store->station_id())
            .bind(copy)
            .run();
        expect_elsewhere();
    }
    EXPECT_GT(fetch_trace(*a.store, here, server, copy).chunks, 0);
    EXPECT_EQ(a.attempts().read_trace(here, copy).samples.size(), 1000U);
    expect_sound(*a.store);
    expect_sound(*b.store);
    expect_sound(server);
}

TEST_F(SyncConflict, ARaterWhoOpenedTheOriginalElsewhereHasSeenTheCopyInWhicheverOrderTheyArrive) {
    for (const bool note_first : {true, false}) {
        const std::string attempt = b.record("ann", 70);
        sync(b);
        sync(a);
        Ratings(*a.store).note_seen(a.session("educator"), attempt);
        const std::string copy =
            Attempts(*b.store).reassign(b.sign_in("educator"), attempt, a.id("ben"), "he was the one");
        if (note_first) sync(a);
        sync(b);
        sync(a);
        sync(b);
        for (const Store* store : {a.store.get(), b.store.get()}) {
            Query seen(store->connection(),
                       "SELECT COUNT(*) FROM rating_seen WHERE attempt_id = ? AND person_id = ?");
            seen.bind(copy).bind(a.id("educator"));
            EXPECT_TRUE(seen.next() && seen.integer(0) == 1) << note_first;
        }
    }
    expect_sound(*a.store);
    expect_sound(server);
}

TEST_F(SyncConflict, AnAttemptThatTwoStationsScoredKeepsTheScoreOfEachAndAllElseIsTransferred) {
    const std::string attempt = a.record_broken("ann");
    a.open();  // closes it as cut off
    sync(a);
    sync(b);
    const Session at_b = b.sign_in("ann");
    EXPECT_GT(fetch_trace(*b.store, at_b, server, attempt).chunks, 0);
    EXPECT_TRUE(Attempts(*b.store).interrupted_without_score(at_b).empty()) << "a station scores its own";
    ASSERT_EQ(a.attempts().interrupted_without_score(a.session("ann")).size(), 1U);
    Attempts(*b.store).add_score(at_b, attempt, example_score(true, 70));  // as `Recompute` does there
    a.attempts().add_score(a.session("ann"), attempt, example_score(true, 60));
    const std::string other = a.record("ben", true, 55);
    sync(b);
    const SyncResult second = sync(a);
    EXPECT_EQ(second.transferred(), 2) << "the other attempt and its score";
    EXPECT_TRUE(second.conflicts.empty());
    EXPECT_EQ(sync(a).transferred(), 0);
    EXPECT_EQ(sync(b).transferred(), 2);
    EXPECT_EQ(sync(b).transferred(), 0);
    const Station c;
    sync(c);
    EXPECT_EQ(a.attempts().score(a.session("ann"), attempt)->points, 60);
    EXPECT_EQ(Attempts(*b.store).score(at_b, attempt)->points, 70);
    EXPECT_EQ(Attempts(*c.store).score(c.sign_in("ann"), attempt)->points, 70);
    EXPECT_EQ(Attempts(*b.store).score(b.sign_in("ben"), other)->points, 55);
    for (const Store* store : {a.store.get(), b.store.get(), c.store.get()}) expect_sound(*store);
    expect_sound(server);
}

class SyncErasure : public SyncConflict {};

TEST_F(SyncErasure, ErasedOnTheServerStaysErasedAfterAnOfflineStationsPush) {
    fill(a);
    a.open();
    sync(a);
    sync(b);
    const std::string ann = a.id("ann"), offline = b.record("ann", 77);  // b is offline from here
    b.record("ben", 55);
    const auto before = rows_on(server);
    const auto dry = erase_at_programme_server(server, ann, true);
    EXPECT_FALSE(dry.empty());
    EXPECT_EQ(rows_on(server), before) << "a dry run changes nothing";
    EXPECT_EQ(erase_at_programme_server(server, ann, false).size(), dry.size());
    expect_sound(server);
    const SyncResult at_b = sync(b);
    EXPECT_EQ(at_b.erased, 1);
    EXPECT_EQ(sync(a).erased, 1);
    sync(b);
    for (const auto& rows : {rows_on(server), rows_at(*a.store), rows_at(*b.store)})
        for (const std::string& row : rows) {
            EXPECT_EQ(row.find("Ann"), std::string::npos) << row;
            EXPECT_EQ(row.find(offline), std::string::npos) << row;
            EXPECT_TRUE(row.find(ann) == std::string::npos || row.rfind("person|", 0) == 0) << row;
        }
    EXPECT_EQ(rows_at(*a.store), rows_at(*b.store));
    EXPECT_EQ(rows_at(*a.store), rows_on(server, false));
    for (const Store* store : {a.store.get(), b.store.get()}) {
        EXPECT_EQ(name_of(*store, ann), "Erased person");
        expect_sound(*store);
        Query left(store->connection(),
                   "SELECT COUNT(*) FROM audit_payload p JOIN audit_entry e ON e.station_id = "
                   "p.station_id AND e.sequence = p.sequence WHERE e.object_id = ?");
        left.bind(ann);
        EXPECT_TRUE(left.next() && left.integer(0) == 0);
    }
    EXPECT_THROW(People(*b.store).sign_in("ann", password), SignInRefused);
    EXPECT_EQ(sync(a).transferred(), 0);
    expect_sound(server);
}

// The server erases her after the station has read the list of erasures and before it reads people.
TEST_F(SyncErasure, APersonWhoArrivesErasedIsErasedByTheNextExchange) {
    const std::string ann = a.id("ann"), attempt = b.record("ann", 77);
    erase_at_programme_server(server, ann, false);
    Connection& connection = b.store->connection();
    for (const char* table : {"person_role", "credential"})
        Query(connection, QString("DELETE FROM %1 WHERE person_id = ?").arg(table)).bind(ann).run();
    Query(connection,
          "UPDATE person SET login = ?, login_key = ?, display_name = 'Erased person', active = 0, version = "
          "1000000000 WHERE id = ?")
        .bind("erased-" + ann)
        .bind("erased-" + ann)
        .bind(ann)
        .run();
    EXPECT_EQ(sync(b).erased, 1);
    for (const std::string& row : rows_at(*b.store)) {
        EXPECT_EQ(row.find(attempt), std::string::npos) << row;
        EXPECT_TRUE(row.find(ann) == std::string::npos || row.rfind("person|", 0) == 0) << row;
    }
    Query said(connection,
               "SELECT COUNT(*) FROM audit_payload p JOIN audit_entry e ON e.station_id = p.station_id AND "
               "e.sequence = p.sequence WHERE e.object_id IN (?, ?)");
    said.bind(ann).bind(attempt);
    EXPECT_TRUE(said.next() && said.integer(0) == 0);
    EXPECT_EQ(sync(b).erased, 0) << "once";
    expect_sound(*b.store);
    expect_sound(server);
}

TEST_F(SyncErasure, TheServerItselfRefusesRowsOfAnErasedPerson) {
    const std::string ann = a.id("ann"), attempt = a.record("ann");
    erase_at_programme_server(server, ann, false);
    Connection connection(server);
    for (const std::string& sql :
         {"INSERT INTO person_role VALUES ('" + ann + "', 'trainee')",
          "UPDATE person SET display_name = 'Ann', login = 'ann' WHERE id = '" + ann + "'",
          "INSERT INTO cohort_member VALUES ('" + a.cohort + "', '" + ann + "')"})
        EXPECT_EQ(error_kind([&] { connection.execute(QString::fromStdString(sql)); }),
                  StoreErrorKind::conflict)
            << sql;
    EXPECT_EQ(error_kind([&] { erase_at_programme_server(server, "nobody", false); }),
              StoreErrorKind::not_found);
}

TEST_F(SyncConflict, AMergeReachesTheOtherStationAndTakesWhatTheDoubledAccountDidThere) {
    // While the stations are apart: eve is merged at one, and renamed and performing at the other.
    const std::string of_ann = a.record("ann");
    PersonMerge(*a.store).merge(a.session("administrator"), a.id("eve"), a.id("ann"), "entered twice");
    const std::string of_eve = b.record("eve", 80);
    for (const char* name : {"Eve B", "Eve C", "Eve D"})
        People(*b.store).rename(b.sign_in("administrator"), a.id("eve"), name);
    for (int round = 0; round < 2; ++round) sync(a), sync(b);
    const auto attempts = [&](const Store& store, const Session& session) {
        AttemptFilter filter;
        filter.person_id = a.id("ann");
        std::set<std::string> ids;
        for (const AttemptSummary& one : Attempts(store).list(session, filter)) ids.insert(one.meta.id);
        return ids;
    };
    const std::set<std::string> both = {of_ann, of_eve};
    EXPECT_EQ(attempts(*a.store, a.session("ann")), both);
    EXPECT_EQ(attempts(*b.store, b.sign_in("ann")), both);
    EXPECT_THROW(b.sign_in("eve"), SignInRefused);
    for (const char* login : {"ann", "educator", "director"}) {
        const Store store = Store::open(grant_at_programme_server(server, login).address, a.clock.options());
        EXPECT_EQ(attempts(store, People(store).account_session()), both) << login << " at the server";
    }
    const Store of_ben = Store::open(grant_at_programme_server(server, "ben").address, a.clock.options());
    EXPECT_TRUE(Attempts(of_ben).list(People(of_ben).account_session()).empty());
    try {
        EXPECT_TRUE(grant_at_programme_server(server, "eve").roles.empty());
    } catch (const StoreError& error) {
        EXPECT_EQ(error.kind(), StoreErrorKind::bad_value) << "she had no account there";
    }
    expect_sound(*a.store);
    expect_sound(*b.store);
    expect_sound(server);
    erase_at_programme_server(server, a.id("ann"), false);
    for (int round = 0; round < 2; ++round) sync(a), sync(b);
    for (const Store* store : {a.store.get(), b.store.get()}) {
        Query left(store->connection(), "SELECT COUNT(*) FROM attempt");
        ASSERT_TRUE(left.next());
        EXPECT_EQ(left.integer(0), 0) << "erasing a person erases both rows";
        EXPECT_EQ(name_of(*store, a.id("eve")), "Erased person");
        expect_sound(*store);
    }
}

TEST_F(SyncConflict, AMergeThatTheServerDidNotKnowWhenItErasedIsNamedUntilItIsResolved) {
    const std::string of_eve = a.record("eve", true, 80);
    a.record("ann");
    sync(a);
    sync(b);
    PersonMerge(*a.store).merge(a.session("administrator"), a.id("eve"), a.id("ann"), "entered twice");
    erase_at_programme_server(server, a.id("ann"), false);
    const auto attempts = [](const Store& store) {
        Query rows(store.connection(), "SELECT COUNT(*) FROM attempt");
        return rows.next() ? rows.integer(0) : -1;
    };
    for (int round = 0; round < 2; ++round) {
        const SyncResult at_a = sync(a), at_b = sync(b);
        for (const SyncResult* one : {&at_a, &at_b}) {
            ASSERT_EQ(one->conflicts.size(), 1U);
            EXPECT_NE(one->conflicts[0].words().find("\"eve\" was merged into a person who was erased"),
                      std::string::npos)
                << one->conflicts[0].words();
        }
        for (const Store* store : {a.store.get(), b.store.get()}) {
            EXPECT_EQ(name_of(*store, a.id("ann")), "Erased person");
            EXPECT_EQ(attempts(*store), 1) << "hers alone, which nobody has asked to erase";
            expect_sound(*store);
        }
    }
    const ServerCheck check = check_programme_server(server);
    ASSERT_EQ(check.problems.size(), 1U);
    EXPECT_NE(check.problems[0].words().find(a.id("eve")), std::string::npos);
    erase_at_programme_server(server, a.id("eve"), false);
    EXPECT_TRUE(sync(a).conflicts.empty());
    EXPECT_TRUE(sync(b).conflicts.empty());
    for (const Store* store : {a.store.get(), b.store.get()}) {
        EXPECT_EQ(attempts(*store), 0);
        EXPECT_EQ(name_of(*store, a.id("eve")), "Erased person");
        expect_sound(*store);
    }
    expect_sound(server);
}

}  // namespace
}  // namespace fulcrum::database::test
