// SPDX-License-Identifier: GPL-3.0-or-later
// Stations that join a programme server by a token: what they may, what they get, and which tokens are
// refused.
#include <thread>

#include "database/rows/crypto.h"
#include "database/store/station_key.h"
#include "database/sync/enrolment.h"
#include "database/sync/enrolment_token.h"
#include "database/sync/server_enrolment.h"
#include "database/sync/server_link.h"
#include "database/sync/trace_fetch.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

TEST(EnrolmentTokens, AreReadAsPeopleTypeThemAndFindEveryMistake) {
    const EnrolmentToken made = EnrolmentToken::make(random_uuid(), noon);
    const std::string text = made.text();
    EXPECT_EQ(text.size(), 47U) << "eight groups of five";
    std::string small = text;
    std::transform(small.begin(), small.end(), small.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    std::string apart;
    for (const char c : text) apart += c == '-' ? std::string("  ") : std::string(1, c == '0' ? 'o' : c);
    for (const std::string& typed : {text, small, apart}) {
        const EnrolmentToken read = EnrolmentToken::parse(typed);
        EXPECT_EQ(read.server, made.server);
        EXPECT_EQ(read.id, made.id);
        EXPECT_EQ(read.until, noon);
        EXPECT_EQ(read.secret, made.secret);
        EXPECT_EQ(read.password(), made.password());
        EXPECT_NE(read.password(), read.proof());
    }
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '-') continue;
        std::string wrong = text;
        wrong[at] = text[at] == 'A' ? 'B' : 'A';
        EXPECT_EQ(error_kind([&] { EnrolmentToken::parse(wrong); }), StoreErrorKind::bad_value) << wrong;
    }
    for (const std::string& wrong : {std::string(), text.substr(1), text + "A", std::string("ü") + text})
        EXPECT_EQ(error_kind([&] { EnrolmentToken::parse(wrong); }), StoreErrorKind::bad_value) << wrong;
}

class Enrolments : public Sync {
  protected:
    const KeysOfOneTest keys;
    std::string token(const std::vector<std::string>& cohorts = {}) const {
        return make_enrolment_token(server, "lab", cohorts, usual_token_h).text;
    }
    SyncResult enrol_and_sync(const Station& station, const std::string& with) const {
        enrol_station(*station.store, station.store->station_session(), server, with);
        return sync_linked(station);
    }
    static SyncResult sync_linked(const Station& station) {
        return sync_with_server(*station.store,
                                station.store->has_administrator() ? station.sign_in("administrator")
                                                                   : station.store->station_session(),
                                server_of(*station.store));
    }
    Enrolment enrol_a(const std::string& with) const {
        return enrol_station(*a.store, a.session("administrator"), server, with);
    }
    SyncResult sync_a() const {
        return sync_with_server(*a.store, a.session("administrator"), server_of(*a.store));
    }
    std::string refusal(const Station& station, const std::string& with, const ServerAddress& at) const {
        try {
            enrol_station(*station.store, station.store->station_session(), at, with);
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), StoreErrorKind::conflict) << error.what();
            EXPECT_FALSE(error.hint().empty());
            return error.what();
        }
        ADD_FAILURE() << "not refused";
        return {};
    }
    std::int64_t count(const char* sql) const {
        Connection connection(server);
        Query row(connection, sql);
        return row.next() ? row.integer(0) : -1;
    }
    void sql(const std::string& text) const { PostgresqlServer::of_this_process()->execute(server, text); }
    static std::set<std::string> attempts_of(const Store& store) {
        std::set<std::string> ids;
        Query rows(store.connection(), "SELECT id FROM attempt");
        while (rows.next()) ids.insert(rows.text(0));
        return ids;
    }
    static std::set<std::string> logins_of(const Store& store) {
        std::set<std::string> logins;
        Query rows(store.connection(), "SELECT login FROM person");
        while (rows.next()) logins.insert(rows.text(0));
        return logins;
    }
};

TEST_F(Enrolments, AStationGetsAnAccountOfItsOwnThatAddsAndNeverChanges) {
    fill(a);
    a.open();
    const std::string with = token();
    const Enrolment enrolment = enrol_a(with);
    EXPECT_TRUE(enrolment.cohorts.empty());
    EXPECT_GT(sync_a().transferred(), 0);
    EXPECT_EQ(rows_at(*a.store), rows_on(server, false));
    const auto link = ServerLink::of(a.store->station_id());
    ASSERT_TRUE(link);
    const QFileInfo key(QString::fromStdString(StationKey::path_of(a.store->station_id())));
    const QFileInfo file(key.path() + "/" + key.completeBaseName() + ".server");
    EXPECT_EQ(file.permissions() & (QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup), 0);
    {
        ServerAddress wrong = link->address;
        EXPECT_EQ(error_kind([&] { Connection(wrong, false, "not the password"); }),
                  StoreErrorKind::unreachable);
        Connection account(link->address, false, link->password);
        for (const char* statement :
             {"UPDATE attempt SET seed = 1", "DELETE FROM attempt", "DELETE FROM audit_entry",
              "UPDATE score SET points = 100", "SELECT * FROM enrolment", "SELECT * FROM server_log",
              "INSERT INTO enrolment (id, name, made, made_by, expires, proof) VALUES ('x', '', 1, '', 1, "
              "'')",
              "SELECT enrol_station('', '', '', '', '')", "SELECT ed25519_holds('', '', '')"})
            EXPECT_EQ(error_kind([&] { account.execute(statement); }), StoreErrorKind::read_only)
                << statement;
        // Nor does it write into the log of another station.
        EXPECT_EQ(error_kind([&] {
                      account.execute(
                          "INSERT INTO station_key (station_id, public_half) VALUES ('another', 'key')");
                  }),
                  StoreErrorKind::read_only);
    }
    const std::vector<EnrolledStation> stations = enrolled_stations(server);
    ASSERT_EQ(stations.size(), 1U);
    EXPECT_EQ(stations[0].state, EnrolledStation::State::enrolled);
    EXPECT_EQ(stations[0].station_id, a.store->station_id());
    EXPECT_EQ(stations[0].key, Audit(*a.store).signing_key());
    EXPECT_GT(stations[0].last_row, 0);
    EXPECT_EQ(count("SELECT COUNT(*) FROM server_log WHERE operation IN ('enrolment.make', 'enrolment.use')"),
              2);
    EXPECT_EQ(count("SELECT COUNT(*) FROM audit_entry WHERE operation = 'station.enrol'"), 1)
        << "the station's own log has it too";
    EXPECT_EQ(error_kind([&] { sql("DELETE FROM server_log"); }), StoreErrorKind::conflict);
    expect_sound(server);
    expect_sound(*a.store);
    // It is of no use to another station.
    const Station b;
    link->finish(b.store->station_id(), "none");
    EXPECT_EQ(error_kind([&] { sync_linked(b); }), StoreErrorKind::conflict);
}

TEST_F(Enrolments, ATokenThatWasUsedOrEndedOrIsOfAnotherServerIsRefusedWithWhatToDo) {
    const std::string used = token(), ended = token(), withdrawn = token();
    enrol_a(used);
    EXPECT_THROW(enrol_a(used), StoreError);
    const Station b;
    EXPECT_NE(refusal(b, used, server).find("another station has used this token"), std::string::npos);
    sql("UPDATE enrolment SET expires = 1000 WHERE id = '" + EnrolmentToken::parse(ended).id + "'");
    EXPECT_NE(refusal(b, ended, server).find("was good until 1970"), std::string::npos);
    withdraw_enrolment(server, EnrolmentToken::parse(withdrawn).id);
    EXPECT_NE(refusal(b, withdrawn, server).find("was withdrawn"), std::string::npos);
    EXPECT_NE(refusal(b, token(), PostgresqlServer::of_this_process()->new_database())
                  .find("does not know this token"),
              std::string::npos);
    EnrolmentToken guessed = EnrolmentToken::parse(token());
    guessed.secret = std::string(20, 'a');
    EXPECT_NE(refusal(b, guessed.text(), server).find("does not know this token"), std::string::npos);
    // The server itself lets the account of a token in until its end.
    const std::string old = token();
    sql("ALTER ROLE \"enrol_" + EnrolmentToken::parse(old).id + "\" VALID UNTIL '2000-01-01'");
    *b.clock.time = EnrolmentToken::parse(old).until + 1000;
    EXPECT_NE(refusal(b, old, server).find("was good until"), std::string::npos);
    EXPECT_FALSE(ServerLink::of(b.store->station_id()));
    EXPECT_EQ(error_kind([&] { server_of(*b.store); }), StoreErrorKind::missing);
    EXPECT_EQ(count("SELECT COUNT(*) FROM server_log WHERE operation = 'enrolment.refuse'"), 4);
    EXPECT_EQ(error_kind([&] { make_enrolment_token(server, "", {"No such cohort"}, 1); }),
              StoreErrorKind::not_found);
    EXPECT_EQ(error_kind([&] { make_enrolment_token(server, "", {}, 0); }), StoreErrorKind::bad_value);
}

TEST_F(Enrolments, CutOffOrTwoAtOnceTheStationEndsWithAnAccountThatWorks) {
    const std::string with = token();
    enrol_a(with);
    const QFileInfo key(QString::fromStdString(StationKey::path_of(a.store->station_id())));
    const QString link = key.path() + "/" + key.completeBaseName() + ".server";
    ASSERT_TRUE(QFile::rename(link, link + "." + QString::fromStdString(EnrolmentToken::parse(with).id)));
    EXPECT_EQ(error_kind([&] { sync_a(); }), StoreErrorKind::missing);
    enrol_a(with);
    EXPECT_TRUE(sync_a().complete);
    expect_sound(server);
    // Two programs of one station at once.
    const std::string both = token();
    int enrolled[2] = {0, 0};
    std::vector<std::thread> threads;
    for (int& one : enrolled)
        threads.emplace_back([this, &one, &both] {
            StoreOptions options = a.clock.options();
            options.busy_timeout_ms = 5000;
            const Store store = Store::open(a.path, options);
            try {
                enrol_station(store, a.session("administrator"), server, both);
                one = 1;
            } catch (const StoreError& error) {
                EXPECT_EQ(error.kind(), StoreErrorKind::conflict) << error.what();
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_GE(enrolled[0] + enrolled[1], 1);
    EXPECT_TRUE(sync_a().complete);
}

TEST_F(Enrolments, ATokenGivenAgainWithAnotherAddressOfItsServerKeepsThePassword) {
    const std::string with = token(), id = EnrolmentToken::parse(with).id, station = a.store->station_id();
    ServerLink begun;  // cut off before the server had answered
    begun.address = server;
    begun.address.host = "/before";
    begun.password = "0123";
    ASSERT_TRUE(begun.begin(station, id));
    enrol_a(with);
    EXPECT_TRUE(sync_a().complete);
    ServerLink lost = *ServerLink::of(station);  // or its answer was lost
    EXPECT_EQ(lost.password, begun.password);
    lost.address.host = "/before";
    const QFileInfo key(QString::fromStdString(StationKey::path_of(station)));
    ASSERT_TRUE(QFile::remove(key.path() + "/" + key.completeBaseName() + ".server"));
    ASSERT_TRUE(lost.begin(station, id));
    enrol_a(with);
    EXPECT_EQ(server_of(*a.store).host, server.host);
    EXPECT_TRUE(sync_a().complete);
}

TEST_F(Enrolments, AnotherTokenReplacesTheAccountAndAWithdrawnStationIsOutAtOnce) {
    fill(a);
    enrol_a(token());
    sync_a();
    const ServerLink first = *ServerLink::of(a.store->station_id());
    enrol_a(token({"Year 1"}));
    EXPECT_EQ(error_kind([&] { Connection(first.address, false, first.password); }),
              StoreErrorKind::unreachable);
    const SyncResult limited = sync_a();
    EXPECT_TRUE(limited.complete);
    EXPECT_TRUE(limited.conflicts.empty()) << "it had everybody, and may go on naming them";
    const ServerLink second = *ServerLink::of(a.store->station_id());
    Connection open(second.address, false, second.password);
    withdraw_enrolment(server, a.store->station_id());
    EXPECT_EQ(error_kind([&] { open.execute("SELECT 1 FROM person"); }), StoreErrorKind::read_only);
    try {
        sync_a();
        ADD_FAILURE() << "was withdrawn";
    } catch (const StoreError& error) {
        EXPECT_NE(std::string(error.what()).find("withdrawn"), std::string::npos) << error.what();
    }
    EXPECT_EQ(error_kind([&] { withdraw_enrolment(server, a.store->station_id()); }),
              StoreErrorKind::not_found);
}

TEST_F(Enrolments, ASyncBringsThePeopleOfTheStationsCohortsOnly) {
    const Session& director = a.session("director");
    const std::string other = a.people().create_cohort(director, "Year 2");
    a.people().set_members(director, other, {a.id("eve")});
    a.people().set_educators(director, other, {a.id("other_educator")});
    const std::string by_ann = fill(a), by_eve = a.record("eve", true, 66);
    a.open();  // closes the attempt that was cut off
    Reviews(*a.store).write(a.session("other_educator"), by_eve, 0.5, "Well done.", true);
    enrol_a(token());
    sync_a();
    Station year_1("one.db"), year_2("two.db");
    enrol_and_sync(year_1, token({"Year 1"}));
    enrol_and_sync(year_2, token({other}));
    const std::set<std::string> of_1 = logins_of(*year_1.store), of_2 = logins_of(*year_2.store);
    EXPECT_EQ(of_1, (std::set<std::string>{"administrator", "director", "educator", "ann", "ben"}));
    EXPECT_EQ(of_2, (std::set<std::string>{"administrator", "director", "other_educator", "eve"}));
    EXPECT_EQ(attempts_of(*year_2.store), std::set<std::string>{by_eve});
    EXPECT_EQ(attempts_of(*year_1.store).count(by_eve), 0U);
    // Ann's state is the same at both stations, also after she has practised at the other one.
    const std::string again = year_1.record("ann", 88);
    sync_linked(year_1);
    sync_a();
    EXPECT_EQ(sync_linked(year_1).transferred(), 0);
    const Session here = a.session("ann"), there = year_1.sign_in("ann");
    EXPECT_EQ(a.attempts().list(here).size(), Attempts(*year_1.store).list(there).size());
    for (const std::string& id : {by_ann, again})
        EXPECT_EQ(a.attempts().score(here, id)->points, Attempts(*year_1.store).score(there, id)->points);
    EXPECT_EQ(Reviews(*a.store).comments(here, by_ann).size(),
              Reviews(*year_1.store).comments(there, by_ann).size());
    // Whoever leaves the cohort stays up to date where their attempts are.
    a.people().set_members(director, a.cohort, {a.id("ben")});
    a.people().set_members(director, other, {a.id("eve"), a.id("ann")});
    a.record("ann", true, 91);
    sync_a();
    sync_linked(year_1);
    sync_linked(year_2);
    EXPECT_EQ(Attempts(*year_1.store).list(year_1.sign_in("ann")).size(), a.attempts().list(here).size());
    EXPECT_EQ(attempts_of(*year_2.store).count(by_ann), 1U) << "she is in its cohort now";
    // What is made at a station of some cohorts reaches the others.
    const Session administrator = year_2.sign_in("administrator");
    People(*year_2.store).create(administrator, "fay", "Fay New", {Role::trainee});
    const Session director_there = year_2.sign_in("director");
    const std::string made = People(*year_2.store).create_cohort(director_there, "Year 3");
    EXPECT_TRUE(sync_linked(year_2).conflicts.empty());
    EXPECT_EQ(sync_linked(year_2).transferred(), 0);
    sync_a();
    EXPECT_EQ(logins_of(*a.store).count("fay"), 1U);
    EXPECT_TRUE(a.people().find_cohort(director, made));
    sync_linked(year_1);
    EXPECT_EQ(logins_of(*year_1.store).count("fay"), 0U);
    // A login, or a cohort's name, that somebody has whom the server does not show here: that one waits.
    People(*year_1.store).create(year_1.sign_in("administrator"), "fay", "Another Fay", {Role::trainee});
    People(*year_1.store).create(year_1.sign_in("administrator"), "gus", "Gus New", {Role::trainee});
    People(*year_1.store).create_cohort(year_1.sign_in("director"), "Year 3");
    People(*year_1.store).create_cohort(year_1.sign_in("director"), "Year \\ \"4\", {5}");
    const SyncResult waiting = sync_linked(year_1);
    EXPECT_EQ(waiting.conflicts.size(), 2U);
    EXPECT_TRUE(waiting.complete);
    sync_a();
    EXPECT_EQ(logins_of(*a.store).count("gus"), 1U);
    EXPECT_TRUE(a.people().find_cohort(director, "Year \\ \"4\", {5}"));
    // Erased on the server while the stations were offline.
    erase_at_programme_server(server, a.id("eve"), false);
    year_2.record("ann", 12);
    EXPECT_EQ(sync_linked(year_2).erased, 1);
    EXPECT_EQ(attempts_of(*year_2.store).count(by_eve), 0U);
    EXPECT_EQ(sync_linked(year_1).erased, 0) << "it never had her";
    EXPECT_EQ(sync_linked(year_2).transferred(), 0);
    sync_a();
    for (const Station* station : {&year_1, &year_2}) expect_sound(*station->store);
    expect_sound(*a.store);
    expect_sound(server);
}

TEST_F(Enrolments, ATraceOfAnotherStationComesWhenItIsWantedAndIsWhatWasSigned) {
    const std::string by_ann = fill(a), by_eve = a.record("eve");
    const std::string copy =
        a.attempts().reassign(a.session("educator"), by_ann, a.id("ben"), "he was the one");
    enrol_a(token());
    sync_a();
    Station b;
    enrol_and_sync(b, token({"Year 1"}));
    const Session educator = b.sign_in("educator");
    EXPECT_TRUE(can_fetch_trace(*b.store, educator, by_ann));
    EXPECT_THROW(fetch_trace(*b.store, b.sign_in("administrator"), server_of(*b.store), by_ann),
                 AccessDenied);
    const auto fetch = [&](const std::string& id, const SyncOptions& options = {}) {
        return fetch_trace(*b.store, educator, server_of(*b.store), id, options);
    };
    // Stopped before any of its statements it leaves nothing.
    int statements = 0;
    for (bool complete = false; !complete; ++statements) {
        SyncOptions stopping;
        int asked = 0;
        stopping.stop = [&] { return ++asked > statements; };
        EXPECT_TRUE(can_fetch_trace(*b.store, educator, by_ann)) << statements;
        complete = fetch(by_ann, stopping).complete;
    }
    EXPECT_GT(statements, 5);
    EXPECT_EQ(fetch(by_ann).chunks, 0) << "it is here";
    EXPECT_FALSE(can_fetch_trace(*b.store, educator, by_ann));
    const Trace here = a.attempts().read_trace(a.session("educator"), by_ann),
                there = Attempts(*b.store).read_trace(educator, by_ann);
    ASSERT_EQ(there.samples.size(), here.samples.size());
    EXPECT_EQ(there.samples[999].hand[1].tip[2], here.samples[999].hand[1].tip[2]);
    // Two at once: one stores it. It is signed in the row of the reassignment.
    std::vector<std::thread> threads;
    std::string keys_found[2];
    for (std::string& key : keys_found)
        threads.emplace_back([&] {
            StoreOptions options = b.clock.options();
            options.busy_timeout_ms = 5000;
            const Store store = Store::open(b.path, options);
            key = fetch_trace(store, educator, server_of(store), copy).signed_by;
        });
    for (std::thread& thread : threads) thread.join();
    for (const std::string& key : keys_found)
        EXPECT_TRUE(key.empty() || key == Audit(*a.store).signing_key());
    EXPECT_FALSE(keys_found[0].empty() && keys_found[1].empty());
    EXPECT_EQ(Attempts(*b.store).read_trace(educator, copy).samples.size(), 1000U);
    EXPECT_EQ(error_kind([&] { fetch(by_eve); }), StoreErrorKind::not_found) << "not of its cohorts";
    // The trace stays as it is, as any other.
    EXPECT_EQ(error_kind([&] {
                  b.store->connection().execute(
                      QString("INSERT INTO trace_chunk SELECT attempt_id, stream, number + 1000, first_tick, "
                              "last_tick, records, checksum, data FROM trace_chunk"));
              }),
              StoreErrorKind::conflict);
    EXPECT_EQ(sync_linked(b).transferred(), 0);
    expect_sound(*b.store);
    expect_sound(server);
}

TEST_F(Enrolments, ATraceThatWasChangedOnTheServerOrCannotBeReachedIsNotTaken) {
    const std::string attempt = fill(a);
    enrol_a(token());
    sync_a();
    Station b;
    enrol_and_sync(b, token());
    const Session educator = b.sign_in("educator");
    const ServerAddress at = server_of(*b.store);
    const auto refused_after = [&](const std::string& change, const std::string& back) {
        sql("ALTER TABLE trace_chunk DISABLE TRIGGER USER; ALTER TABLE audit_entry DISABLE TRIGGER USER; "
            "ALTER TABLE audit_signature DISABLE TRIGGER USER; ALTER TABLE audit_payload DISABLE TRIGGER "
            "USER");
        sql(change);
        EXPECT_EQ(error_kind([&] { fetch_trace(*b.store, educator, at, attempt); }), StoreErrorKind::corrupt)
            << change;
        EXPECT_TRUE(can_fetch_trace(*b.store, educator, attempt)) << "nothing was stored";
        sql(back);
    };
    refused_after("UPDATE trace_chunk SET data = data || 'x'::bytea WHERE stream = 0",
                  "UPDATE trace_chunk SET data = substring(data FOR length(data) - 1) WHERE stream = 0");
    refused_after("UPDATE trace_chunk SET last_tick = last_tick + 1 WHERE stream = 3",
                  "UPDATE trace_chunk SET last_tick = last_tick - 1 WHERE stream = 3");
    refused_after("UPDATE audit_entry SET time = time + 1", "UPDATE audit_entry SET time = time - 1");
    refused_after(
        "UPDATE audit_signature SET signature = set_byte(signature, 3, get_byte(signature, 3) # 1)",
        "UPDATE audit_signature SET signature = set_byte(signature, 3, get_byte(signature, 3) # 1)");
    refused_after("UPDATE audit_payload SET payload = payload || ' '",
                  "UPDATE audit_payload SET payload = rtrim(payload)");
    refused_after("CREATE TABLE kept AS SELECT * FROM audit_payload; DELETE FROM audit_payload",
                  "INSERT INTO audit_payload SELECT * FROM kept");
    ServerAddress nowhere = at;
    nowhere.host = "/nowhere";
    EXPECT_EQ(error_kind([&] { fetch_trace(*b.store, educator, nowhere, attempt); }),
              StoreErrorKind::unreachable);
    EXPECT_GT(fetch_trace(*b.store, educator, at, attempt).chunks, 0);
    expect_sound(*b.store);
}

TEST_F(Enrolments, TheOwnerOfTheServerNeedsNoMoreThanTheRightToMakeAccounts) {
    static int owners = 0;
    const std::string owner = "plain_owner" + std::to_string(++owners);
    const PostgresqlServer& postgresql = *PostgresqlServer::of_this_process();
    postgresql.execute(server, "CREATE ROLE " + owner + " LOGIN CREATEROLE PASSWORD 'plain'");
    qputenv("PGPASSWORD", "plain");  // tests' server asks every member of fulcrum_station
    for (const char* group :
         {"fulcrum_station", "fulcrum_enrol", "fulcrum_trainee", "fulcrum_educator", "fulcrum_director"})
        postgresql.execute(server, std::string("GRANT ") + group + " TO " + owner + " WITH ADMIN OPTION");
    ServerAddress plain = PostgresqlServer::of_this_process()->new_database(false);
    postgresql.execute(plain,
                       "GRANT ALL ON SCHEMA public TO " + owner + "; ALTER SCHEMA public OWNER TO " + owner);
    plain.user = owner;
    create_programme_server(plain);
    const auto made = [&] { return make_enrolment_token(plain, "", {}, 1).text; };
    enrol_station(*a.store, a.session("administrator"), plain, made());
    EXPECT_TRUE(sync_a().complete);
    enrol_station(*a.store, a.session("administrator"), plain, made());
    EXPECT_TRUE(sync_a().complete);
    withdraw_enrolment(plain, a.store->station_id());
    EXPECT_EQ(error_kind([&] { sync_a(); }), StoreErrorKind::unreachable);
    // Accounts of tokens that have ended go with the next token.
    postgresql.execute(plain, "UPDATE enrolment SET expires = 1000");
    made();
    Connection connection(plain);
    Query left(connection,
               "SELECT COUNT(*) FROM pg_roles r JOIN enrolment e ON r.rolname = 'enrol_' || e.id");
    EXPECT_TRUE(left.next() && left.integer(0) == 1);
    qunsetenv("PGPASSWORD");
}

TEST_F(Enrolments, AServerFromBeforeThereWereTokensIsUpgradedByServerCreate) {
    fill(a);
    sync(a);
    sql("DROP TABLE enrolment_cohort, enrolment, station_unit, server_log; DROP FUNCTION own_enrolment "
        "CASCADE");
    EXPECT_EQ(error_kind([&] { sync(a); }), StoreErrorKind::older_schema);
    EXPECT_EQ(error_kind([&] { token(); }), StoreErrorKind::older_schema);
    create_programme_server(server);
    EXPECT_TRUE(sync(a).complete);
    enrol_a(token());
    EXPECT_TRUE(sync_a().complete);
    expect_sound(server);
}

TEST_F(Enrolments, ALostKeyIsRefusedUntilTheOwnerWithdrawsTheStation) {
    enrol_a(token());
    sync_a();
    ASSERT_TRUE(QFile::remove(QString::fromStdString(StationKey::path_of(a.store->station_id()))));
    a.open();
    try {
        enrol_a(token());
        ADD_FAILURE() << "another key";
    } catch (const StoreError& error) {
        EXPECT_NE(std::string(error.what()).find("another signing key"), std::string::npos) << error.what();
    }
    withdraw_enrolment(server, a.store->station_id());
    enrol_a(token());
    sync_a();
    const ServerCheck check = check_programme_server(server);
    EXPECT_TRUE(check.problems.empty()) << check.problems.front().words();
    EXPECT_EQ(check.notes.size(), 1U) << "the key before did not announce this one";
}

}  // namespace
}  // namespace fulcrum::database::test
