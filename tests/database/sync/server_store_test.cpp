// SPDX-License-Identifier: GPL-3.0-or-later
// The programme server opened as a store: the same answers as the station that sent everything, who is who
// there, and what ends it.
#include <functional>
#include <set>

#include "assessment/curriculum/curriculum.h"
#include "database/records/curricula.h"
#include "database/records/standings.h"
#include "database/rows/crypto.h"
#include "database/schedules/schedules.h"
#include "database/schema/server_version.h"
#include "database/store/accepted_assets.h"
#include "database/sync/server_rights.h"
#include "database/xapi/xapi_outbox.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class ServerStore : public Sync {
  protected:
    Store open_as(const std::string& login) const {
        return Store::open(grant_at_programme_server(server, login).address, a.clock.options());
    }
    static std::vector<std::string> ids(const std::vector<AttemptSummary>& attempts) {
        std::vector<std::string> result;
        for (const AttemptSummary& one : attempts) result.push_back(one.meta.id + " " + one.void_reason);
        return result;
    }
    void sql(const std::string& text) const { PostgresqlServer::of_this_process()->execute(server, text); }
};

TEST_F(ServerStore, GivesTheSameAnswersAsTheStation) {
    const std::string attempt = fill(a);
    a.open();
    Standings(*a.store).decide(a.session("educator"), a.id("ann"), "B1", StandingOverride::Kind::unlocked,
                               "moved here");
    a.attempts().request_correction(a.session("ann"), attempt, "this was not me");
    sync(a);
    for (const char* login : {"director", "educator", "ann"}) {
        const Store store = open_as(login);
        const Session there = People(store).account_session();
        const Session& here = a.session(login);
        EXPECT_EQ(there.person_id(), here.person_id());
        EXPECT_EQ(there.roles(), here.roles());
        EXPECT_EQ(store.programme_name(), a.store->programme_name());
        const auto people = People(store).list(there), people_here = a.people().list(here);
        ASSERT_EQ(people.size(), people_here.size()) << login;
        for (std::size_t i = 0; i < people.size(); ++i) EXPECT_EQ(people[i].login, people_here[i].login);
        const auto cohorts = People(store).cohorts(there), cohorts_here = a.people().cohorts(here);
        ASSERT_EQ(cohorts.size(), cohorts_here.size()) << login;
        for (std::size_t i = 0; i < cohorts.size(); ++i) {
            EXPECT_EQ(cohorts[i].members, cohorts_here[i].members);
            EXPECT_EQ(cohorts[i].educators, cohorts_here[i].educators);
        }
        EXPECT_EQ(ids(Attempts(store).list(there)), ids(a.attempts().list(here))) << login;
        EXPECT_EQ(ids(Attempts(store).list(there)).size(), std::string(login) == "ann" ? 2U : 3U);
        const auto comments = Reviews(store).comments(there, attempt);
        ASSERT_EQ(comments.size(), 1U) << login;
        EXPECT_EQ(comments[0].author_name, "Edu Cator");
        const AttemptRatings ratings = Ratings(store).of_attempt(there, attempt);
        ASSERT_EQ(ratings.rows.size(), 1U) << login;
        EXPECT_EQ(ratings.rows[0].rater_name, "Edu Cator");
        EXPECT_EQ(Standings(store).overrides(there, a.id("ann")).size(), 1U) << login;
        EXPECT_EQ(Attempts(store).correction_requests(there).size(), 1U) << login;
        EXPECT_EQ(Attempts(store).read_trace(there, attempt).samples.size(), 1000U) << login;
        EXPECT_TRUE(Attempts(store).cut_off_series(there, 1).size() ==
                    a.attempts().cut_off_series(here, 1).size());
    }
}

TEST_F(ServerStore, EveryTableHasItsPolicy) {
    Connection connection(server);
    EXPECT_TRUE(tables_without_policy(connection).empty())
        << "say in database/sync/server_rights.cpp who sees rows of "
        << tables_without_policy(connection).front();
}

TEST_F(ServerStore, ARoleOrAnAccountThatIsWithdrawnEndsAtOnceInTheProgramAndPastIt) {
    fill(a);
    sync(a);
    const Store store = open_as("director");
    const Session director = People(store).account_session();
    EXPECT_EQ(Attempts(store).list(director).size(), 2U);
    const auto rows = [&](const char* table) {
        Query count(store.connection(), QString("SELECT COUNT(*) FROM %1").arg(table));
        return count.next() ? count.integer(0) : -1;
    };
    EXPECT_EQ(rows("attempt"), 2);
    EXPECT_GT(rows("metric"), 0);
    sql("DELETE FROM person_role WHERE person_id = '" + a.id("director") + "'");
    EXPECT_THROW(Attempts(store).list(director), AccessDenied);
    EXPECT_THROW(People(store).account_session(), SignInRefused);
    EXPECT_EQ(rows("attempt"), 0);
    EXPECT_EQ(rows("metric"), 0);
    EXPECT_EQ(rows("person"), 1);
    sql("INSERT INTO person_role VALUES ('" + a.id("director") + "', 'director')");
    EXPECT_EQ(Attempts(store).list(director).size(), 2U);
    sql("UPDATE person SET active = 0, version = version + 1 WHERE id = '" + a.id("director") + "'");
    EXPECT_THROW(Attempts(store).list(director), AccessDenied);
    EXPECT_EQ(rows("attempt"), 0);
    // A role that the programme gave, but whose account was not brought up to date, is not one of the server.
    const Store of_ann = open_as("ann");
    sql("INSERT INTO person_role VALUES ('" + a.id("ann") + "', 'educator')");
    EXPECT_EQ(People(of_ann).account_session().roles(), std::vector<Role>{Role::trainee});
    EXPECT_THROW(People(of_ann).account_session(Role::educator), SignInRefused);
    EXPECT_EQ(grant_at_programme_server(server, "ANN").roles,
              (std::vector<Role>{Role::trainee, Role::educator}));
    EXPECT_EQ(People(of_ann).account_session().roles(), (std::vector<Role>{Role::trainee, Role::educator}));
    // An educator without a cohort sees nobody; a role that is gone is taken from the account.
    sql("DELETE FROM person_role WHERE person_id = '" + a.id("ann") + "' AND role = 'trainee'");
    const ServerAccount educator = grant_at_programme_server(server, "ann");
    EXPECT_EQ(educator.roles, std::vector<Role>{Role::educator});
    EXPECT_FALSE(educator.made);
    const Store taught = Store::open(educator.address);
    EXPECT_TRUE(Attempts(taught).list(People(taught).account_session()).empty());
}

TEST_F(ServerStore, OnlyAccountsOfPeopleSignIn) {
    sync(a);
    for (const std::string& user : {std::string("owner"), std::string("station")}) {
        if (user == "station") continue;  // has a password: below
        const Store store = Store::open(PostgresqlServer::as(server, user).text());
        EXPECT_THROW(People(store).account_session(), SignInRefused) << user;
    }
    EXPECT_EQ(error_kind([&] { grant_at_programme_server(server, "nobody"); }), StoreErrorKind::not_found);
    EXPECT_EQ(error_kind([&] { Store::open(PostgresqlServer::as(server, "nobody").text()); }),
              StoreErrorKind::unreachable);
    ServerAddress empty = PostgresqlServer::of_this_process()->new_database(false);
    EXPECT_EQ(error_kind([&] { Store::open(empty.text()); }), StoreErrorKind::missing);
    EXPECT_EQ(error_kind([&] { Store::create(server.text()); }), StoreErrorKind::bad_value);
    // The lock of the window asks for the password again: at a server that of the account.
    const Store store = open_as("director");
    EXPECT_EQ(People(store).sign_in("Director", "any: this server trusts its socket").login(), "director");
    EXPECT_THROW(People(store).sign_in("ann", "any"), SignInRefused);
}

TEST_F(ServerStore, ARaterWhoOpensAnAttemptThereIsNotBlindForItAtAStation) {
    const std::string attempt = fill(a);
    sync(a);
    {
        const Store store = open_as("director");
        const Session director = People(store).account_session();
        Ratings(store).note_seen(director, attempt);
        Ratings(store).note_seen(director, attempt);
    }
    const auto seen_here = [&] {
        Query row(a.store->connection(), "SELECT COUNT(*) FROM rating_seen WHERE person_id = ?");
        row.bind(a.id("director"));
        return row.next() ? row.integer(0) : -1;
    };
    EXPECT_EQ(seen_here(), 0);
    sync(a);
    EXPECT_EQ(seen_here(), 1);
    // Nobody says so of somebody else.
    const std::unique_ptr<Connection> past =
        std::make_unique<Connection>(PostgresqlServer::as(server, a.id("director")));
    EXPECT_EQ(error_kind([&] {
                  past->execute(QString::fromStdString("INSERT INTO rating_seen VALUES ('" + attempt +
                                                       "', '" + a.id("ann") + "', 1)"));
              }),
              StoreErrorKind::read_only);
}

TEST_F(ServerStore, ARaterWhoOpensAnAttemptThereIsNotBlindForItsCopies) {
    const std::string attempt = a.record("ann");
    const auto reassign = [&](const std::string& from, const std::string& to) {
        return a.attempts().reassign(a.session("educator"), from, a.id(to), "somebody else sat there");
    };
    const std::string first = reassign(attempt, "ben");
    sync(a);
    const auto seen_there = [&](const std::string& login) {
        Connection connection(server);
        std::set<std::string> ids;
        Query rows(connection, "SELECT attempt_id FROM rating_seen WHERE person_id = ?");
        rows.bind(a.id(login));
        while (rows.next()) ids.insert(rows.text(0));
        return ids;
    };
    const auto open_there = [&](const std::string& login) {
        const Store store = open_as(login);
        Ratings(store).note_seen(People(store).account_session(), attempt);
    };
    open_there("director");
    EXPECT_EQ(seen_there("director"), (std::set<std::string>{attempt, first}));
    const std::string second = reassign(first, "ann");
    sync(a);
    open_there("director");
    open_there("educator");
    for (const char* login : {"director", "educator"})
        EXPECT_EQ(seen_there(login), (std::set<std::string>{attempt, first, second})) << login;
    // Of an educator of some people: those that the account sees, and no failure.
    const Session& head = a.session("director");
    const std::string cohort = a.people().create_cohort(head, "Year 2");
    a.people().set_members(head, cohort, {a.id("eve")});
    a.people().set_educators(head, cohort, {a.id("educator")});
    const std::string hidden = reassign(second, "eve");
    a.people().set_educators(head, cohort, {});
    sync(a);
    open_there("educator");
    open_there("director");
    EXPECT_EQ(seen_there("educator").count(hidden), 0U);
    EXPECT_EQ(seen_there("director").count(hidden), 1U);
}

TEST_F(ServerStore, AcceptedFilesAreListedWhoeverAcceptedThem) {
    // Of an educator who teaches nobody whom the others see.
    const std::string text = "{}";
    AcceptedAssets(*a.store).accept(a.session("other_educator"), {"benchmarks/own.json", sha256_hex(text)},
                                    "our experts", text);
    sync(a);
    for (const char* login : {"ann", "educator", "director"}) {
        const std::vector<AcceptedAsset> listed = AcceptedAssets(open_as(login)).list();
        ASSERT_EQ(listed.size(), 1U) << login;
        EXPECT_EQ(listed[0].person_name, "Otto Cator") << login;
    }
    // On a server whose rights an older program made, the name is hidden and the file is not.
    sql("CREATE OR REPLACE FUNCTION named_people() RETURNS SETOF text LANGUAGE sql STABLE SECURITY DEFINER "
        "AS $$ SELECT id FROM person WHERE 1 = 0 $$");
    const std::vector<AcceptedAsset> listed = AcceptedAssets(open_as("ann")).list();
    ASSERT_EQ(listed.size(), 1U);
    EXPECT_EQ(listed[0].person_name, "");
}

TEST_F(ServerStore, WhatOnlyStationsKeepIsRefusedAndNotAnsweredAsIfThereWereNone) {
    ReportSchedule wish;
    wish.cohort_id = a.cohort;
    wish.format = "csv";
    wish.folder = "/srv/reports";
    Schedules(*a.store).add(a.session("director"), wish);
    sync(a);
    const Store store = open_as("director");
    const Session director = People(store).account_session();
    const std::vector<std::function<void()>> calls = {
        [&] { Schedules(store).list(director); },
        [&] { Schedules(store).add(director, wish); },
        [&] { Schedules(store).remove(director, "x"); },
        [&] { outbox_counts(store, director); },
        [&] { XapiOutbox(store, director, "https://lrs.example/").counts(); },
    };
    for (std::size_t i = 0; i < calls.size(); ++i) {
        try {
            calls[i]();
            ADD_FAILURE() << "call " << i << " was answered";
        } catch (const AccessDenied& error) {
            EXPECT_EQ(error.why(), DenialReason::server_only_read) << error.what();
        }
    }
}

TEST_F(ServerStore, ALostConnectionIsMadeAgain) {
    fill(a);
    sync(a);
    const Store store = open_as("director");
    const Session director = People(store).account_session();
    EXPECT_EQ(Attempts(store).list(director).size(), 2U);
    sql("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE usename = '" + a.id("director") + "'");
    EXPECT_EQ(Attempts(store).list(director).size(), 2U);
    EXPECT_THROW(store.connection().execute("DELETE FROM attempt"), StoreError) << "still read only";
}

TEST_F(ServerStore, ReportsPrintAHeadThatTheServersCheckPrintsToo) {
    fill(a);
    sync(a);
    const Store store = open_as("director");
    const std::string one = Audit(store).head();
    EXPECT_EQ(one, Audit(*a.store).head());
    EXPECT_EQ(Audit(store).signing_key(), Audit(*a.store).signing_key());
    EXPECT_EQ(check_programme_server(server).audit_head, one);
    const Station b;
    sync(b);
    const std::string two = Audit(store).head();
    EXPECT_NE(two, one);
    EXPECT_EQ(two.size(), 64U);
    EXPECT_EQ(check_programme_server(server).audit_head, two);
    EXPECT_EQ(Audit(store).signing_key(), "");
}

}  // namespace
}  // namespace fulcrum::database::test
