// SPDX-License-Identifier: GPL-3.0-or-later
// A station that was tampered with: who runs it knows ids of people that the server has not given to it, and
// sends statements of their own with the station's account.
#include "database/sync/enrolment.h"
#include "database/sync/enrolment_token.h"
#include "database/sync/server_enrolment.h"
#include "database/sync/server_link.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class StationClaims : public Sync {
  protected:
    const KeysOfOneTest keys;
    std::string year_2;  ///< eve is its only member
    std::string by_ann, by_eve;
    std::unique_ptr<Station> evil;  ///< of Year 1: the server gives ann and ben to it

    void SetUp() override {
        Sync::SetUp();
        if (IsSkipped()) return;
        const Session& director = a.session("director");
        year_2 = a.people().create_cohort(director, "Year 2");
        a.people().set_members(director, year_2, {a.id("eve")});
        by_ann = fill(a);
        by_eve = a.record("eve", true, 66);
        a.open();  // closes the attempt that was cut off
        enrol_station(*a.store, a.session("administrator"), server, token({}));
        sync_a();
        evil = std::make_unique<Station>("evil.db");
        enrol_station(*evil->store, evil->store->station_session(), server, token({"Year 1"}));
        sync_of(*evil);
    }
    std::string token(const std::vector<std::string>& cohorts) const {
        return make_enrolment_token(server, "lab", cohorts, usual_token_h).text;
    }
    void sync_a() const {
        EXPECT_TRUE(sync_with_server(*a.store, a.session("administrator"), server_of(*a.store)).complete);
    }
    static SyncResult sync_of(const Station& station) {
        return sync_with_server(*station.store,
                                station.store->has_administrator() ? station.sign_in("administrator")
                                                                   : station.store->station_session(),
                                server_of(*station.store));
    }
    /// As the account of the station, by hand.
    Connection as_evil() const {
        const ServerLink link = *ServerLink::of(evil->store->station_id());
        return Connection(link.address, false, link.password);
    }
    std::int64_t count(const std::string& sql) const {
        Connection connection(server);
        Query row(connection, QString::fromStdString(sql));
        return row.next() ? row.integer(0) : -1;
    }
    std::vector<std::string> names_in_log() const {
        Connection connection(server);
        std::vector<std::string> names;
        Query rows(connection, "SELECT object FROM server_log WHERE operation = 'claim.refuse' ORDER BY 1");
        while (rows.next()) names.push_back(rows.text(0));
        return names;
    }
    /// A copy of a row with some columns changed, in the words of PostgreSQL.
    static std::string copied(const std::string& table, const std::string& from, const std::string& changes) {
        return "INSERT INTO " + table + " SELECT (jsonb_populate_record(NULL::" + table +
               ", to_jsonb(x) || '" + changes + "'::jsonb)).* FROM " + table + " x WHERE " + from;
    }
    std::string eve() const { return a.id("eve"); }
};

TEST_F(StationClaims, AnAttemptForAPersonOfAnotherCohortIsLeftOutAndLogged) {
    const std::int64_t before = count("SELECT COUNT(*) FROM attempt");
    Connection account = as_evil();
    const auto forged = [&](const std::string& id, const std::string& person) {
        return copied("attempt", "id = '" + by_ann + "'",
                      R"({"id": ")" + id + R"(", "person_id": ")" + person + R"("})");
    };
    account.execute(QString::fromStdString(forged("forged-1", eve())));
    account.execute(QString::fromStdString(forged("forged-2", eve())));
    EXPECT_EQ(count("SELECT COUNT(*) FROM attempt"), before);
    EXPECT_EQ(names_in_log(), std::vector<std::string>{eve()}) << "once, however often it is tried";
    const ServerCheck check = check_programme_server(server);
    ASSERT_EQ(check.notes.size(), 1U);
    EXPECT_NE(check.notes[0].words().find(eve()), std::string::npos) << check.notes[0].words();
    EXPECT_NE(check.notes[0].words().find(evil->store->station_id()), std::string::npos);
    EXPECT_TRUE(check.problems.empty());
    // With rows that belong to it: they would have nothing to belong to.
    EXPECT_ANY_THROW({
        Transaction transaction(account);
        account.execute("SET CONSTRAINTS ALL DEFERRED");
        account.execute(QString::fromStdString(
            copied("trace_chunk", "attempt_id = '" + by_ann + "'", R"({"attempt_id": "forged-3"})")));
        account.execute(QString::fromStdString(forged("forged-3", eve())));
        account.execute("SET CONSTRAINTS ALL IMMEDIATE");
        transaction.commit();
    });
    EXPECT_EQ(count("SELECT COUNT(*) FROM attempt"), before);
    // For those that the server gave to it: who runs a station is trusted with its own people.
    Connection again = as_evil();
    again.execute(QString::fromStdString(forged("forged-4", a.id("ben"))));
    EXPECT_EQ(count("SELECT COUNT(*) FROM attempt"), before + 1);
}

TEST_F(StationClaims, AKnownIdOfAnotherCohortGivesNothing) {
    Connection account = as_evil();
    const auto sees = [&] {
        Query row(account,
                  "SELECT (SELECT COUNT(*) FROM person WHERE id = ?) + (SELECT COUNT(*) FROM credential "
                  "WHERE person_id = ?) + (SELECT COUNT(*) FROM attempt WHERE person_id = ?) + (SELECT "
                  "COUNT(*) FROM cohort WHERE id = ?)");
        row.bind(eve()).bind(eve()).bind(eve()).bind(year_2);
        return row.next() ? row.integer(0) : -1;
    };
    EXPECT_EQ(sees(), 0);
    const std::string list = "ARRAY['" + eve() + "', '" + year_2 + "']";
    account.execute(QString::fromStdString("SELECT station_holds(" + list + ", " + list + ")"));
    EXPECT_EQ(sees(), 0);
    std::vector<std::string> wanted = {eve(), year_2};
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(names_in_log(), wanted);
    const std::string own_cohort = a.cohort, ann = a.id("ann");
    const std::vector<std::string> statements = {
        // Into a cohort of its own, or one that it makes; roles and passwords.
        "INSERT INTO cohort_member (cohort_id, person_id) VALUES ('" + own_cohort + "', '" + eve() + "')",
        "INSERT INTO cohort_educator (cohort_id, person_id) VALUES ('" + own_cohort + "', '" + eve() + "')",
        "INSERT INTO cohort_member (cohort_id, person_id) VALUES ('" + year_2 + "', '" + ann + "')",
        "INSERT INTO person_role (person_id, role) VALUES ('" + eve() + "', 'administrator')",
        // A person of its own, or one of the station's, read as eve.
        "UPDATE person SET merged_into = '" + eve() + "' WHERE id = '" + ann + "'",
        copied("person", "id = '" + ann + "'",
               R"({"id": "own", "login": "own", "login_key": "own", "merged_into": ")" + eve() + R"("})"),
        // What belongs to attempts that it does not see, or that are complete.
        copied("score", "attempt_id = '" + by_ann + "'",
               R"({"id": "forged", "attempt_id": ")" + by_eve + R"("})"),
        copied("attempt_void", "true", R"({"attempt_id": ")" + by_eve + R"("})"),
        copied("comment", "true", R"({"id": "forged", "attempt_id": ")" + by_eve + R"("})"),
        copied("metric", "score_id IN (SELECT id FROM score WHERE attempt_id = '" + by_ann + "')",
               R"({"number": 9999})"),
        // In the name of somebody who is not known here.
        copied("comment", "true", R"({"id": "forged", "author_id": ")" + eve() + R"("})"),
        copied("personal_goal", "true", R"({"id": "forged", "person_id": ")" + eve() + R"("})"),
        copied("rating", "true", R"({"id": "forged", "rater_id": ")" + eve() + R"("})"),
        "INSERT INTO rating_seen (attempt_id, person_id, time) VALUES ('" + by_ann + "', '" + eve() + "', 1)",
        // Tables that no exchange writes.
        "INSERT INTO setting SELECT * FROM setting", "INSERT INTO station_shown VALUES ('x', 'y')",
        "DELETE FROM server_log", "SELECT log_claim('x')"};
    const std::vector<std::string> before = rows_on(server);
    for (const std::string& statement : statements) {
        Connection one = as_evil();
        const bool is_merge = statement.find("merged_into") != std::string::npos;
        EXPECT_EQ(error_kind([&] { one.execute(QString::fromStdString(statement)); }),
                  is_merge ? StoreErrorKind::conflict : StoreErrorKind::read_only)
            << statement;
    }
    EXPECT_EQ(rows_on(server), before);
    EXPECT_EQ(sees(), 0);
    expect_sound(server);
}

TEST_F(StationClaims, APersonThatIsYetToComeBelongsToTheStationThatBringsThem) {
    const std::string fay =
        a.people().create(a.session("administrator"), "fay", "Fay New", {Role::trainee}).person.id;
    Connection account = as_evil();
    const std::string list = "ARRAY['" + fay + "']";
    account.execute(QString::fromStdString("SELECT station_holds(" + list + ", " + list + ")"));
    EXPECT_TRUE(names_in_log().empty()) << "nobody has this id";
    sync_a();
    Query row(account, "SELECT COUNT(*) FROM person WHERE id = ?");
    row.bind(fay);
    EXPECT_TRUE(row.next() && row.integer(0) == 0);
}

TEST_F(StationClaims, AnHonestStationKeepsWorkingWithEverybodyItWasGiven) {
    // Who left its cohort, and whom it made itself.
    a.people().set_members(a.session("director"), a.cohort, {a.id("ben")});
    sync_a();
    People(*evil->store).create(evil->sign_in("administrator"), "gus", "Gus New", {Role::trainee});
    const std::string by_her = evil->record("ann", 71);
    const SyncResult result = sync_of(*evil);
    EXPECT_TRUE(result.complete);
    EXPECT_TRUE(result.conflicts.empty()) << result.conflicts.front().words();
    EXPECT_EQ(count("SELECT COUNT(*) FROM attempt WHERE id = '" + by_her + "'"), 1);
    EXPECT_EQ(count("SELECT COUNT(*) FROM person WHERE login = 'gus'"), 1);
    EXPECT_EQ(sync_of(*evil).transferred(), 0);
    EXPECT_TRUE(names_in_log().empty());
    expect_sound(server);
}

TEST_F(StationClaims, AStoreThatHasAStrangerExchangesTheRestAndSaysWho) {
    // Another station's file copied over by hand: eve and her attempt are in it.
    Connection& own = evil->store->connection();
    own.execute(QString::fromStdString(
        "INSERT INTO person (id, login, login_key, display_name, kind, active, created, version) VALUES ('" +
        eve() + "', 'eve', 'eve', 'Eve', 'real', 1, 1, 9)"));
    const std::string by_her = evil->record("ann", 71);
    const SyncResult result = sync_of(*evil);
    EXPECT_TRUE(result.complete);
    ASSERT_EQ(result.conflicts.size(), 1U);
    EXPECT_NE(result.conflicts[0].words().find(
                  "\"eve\" is on the server, but the server never gave it to this station"),
              std::string::npos)
        << result.conflicts[0].words();
    EXPECT_EQ(count("SELECT COUNT(*) FROM attempt WHERE id = '" + by_her + "'"), 1);
    EXPECT_EQ(count("SELECT COUNT(*) FROM person WHERE login = 'eve' AND version = 9"), 0);
    EXPECT_EQ(names_in_log(), std::vector<std::string>{eve()});
    // She comes to its cohort: from then on she is one of its people.
    a.people().set_members(a.session("director"), a.cohort, {a.id("ann"), a.id("ben"), eve()});
    sync_a();
    EXPECT_TRUE(sync_of(*evil).conflicts.empty());
}

TEST_F(StationClaims, AServerFromBeforeTakesWhatItsStationsHaveSaidSoFar) {
    PostgresqlServer::of_this_process()->execute(server, "DROP TABLE station_shown");
    EXPECT_EQ(error_kind([&] { sync_of(*evil); }), StoreErrorKind::older_schema);
    create_programme_server(server);
    evil->record("ann", 71);
    EXPECT_TRUE(sync_of(*evil).conflicts.empty());
    EXPECT_EQ(sync_of(*evil).transferred(), 0);
    expect_sound(server);
}

}  // namespace
}  // namespace fulcrum::database::test
