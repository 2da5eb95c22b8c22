// SPDX-License-Identifier: GPL-3.0-or-later
// Cut off anywhere, the next run completes the exchange; what cannot begin says why and changes nothing.
#include <fstream>

#include "database/sync/server_schema.h"
#include "tests/database/processes.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class SyncCutOff : public Sync {
  protected:
    /// Runs again and again, each time cut off after a few statements more or less, until one run completes.
    template <typename Who>
    int sync_with_cuts(const Store& store, Who&& session, const ServerAddress& to, int first,
                       int step) const {
        for (int run = 1; run < 400; ++run) {
            SyncOptions options;
            int left = first + run * step;
            options.stop = [&left] { return left-- <= 0; };
            const SyncResult result = sync_with_server(store, session(), to, options);
            expect_chain(store);
            if (result.complete) return run;
        }
        ADD_FAILURE() << "never completed";
        return 0;
    }
    static void expect_chain(const Store& store) {
        for (const Sentence& problem : Audit(store).verify()) ADD_FAILURE() << problem.words();
    }
};

TEST_F(SyncCutOff, EndStateIsThatOfAnUninterruptedExchange) {
    fill(a);
    a.open();
    a.store.reset();
    const std::string copy = a.folder.filePath("copy.db").toStdString();
    std::filesystem::copy_file(a.path, copy);
    a.open();
    const ServerAddress other = PostgresqlServer::of_this_process()->new_database();
    sync(a);
    const Store cut = Store::open(copy, a.clock.options());
    const int runs = sync_with_cuts(
        cut, [&] { return a.session("administrator"); }, other, 6, 1);
    EXPECT_GT(runs, 20);
    EXPECT_EQ(rows_on(server), rows_on(other));
    EXPECT_EQ(rows_at(cut, true), rows_at(*a.store, true));
    expect_sound(cut);
    expect_sound(other);

    // The same for a station that receives; each run of it is checked from end to end.
    const Station whole, parts;
    sync(whole);
    const auto session = [&] {
        return parts.store->has_administrator() ? parts.sign_in("administrator")
                                                : parts.store->station_session();
    };
    EXPECT_GT(sync_with_cuts(*parts.store, session, other, 6, 2), 10);
    const auto without_stations = [](std::vector<std::string> rows) {
        rows.erase(std::remove_if(rows.begin(), rows.end(),
                                  [](const std::string& row) { return row.rfind("station|", 0) == 0; }),
                   rows.end());
        return rows;
    };
    EXPECT_EQ(without_stations(rows_at(*whole.store)), without_stations(rows_at(*parts.store)));
    expect_sound(*parts.store);
}

TEST_F(SyncCutOff, EveryRunLeavesAStationThatChecks) {
    fill(a);
    a.open();
    sync(a);
    // A cut at each statement in turn, each on a station of its own kind: from nothing.
    for (int statements = 1; statements < 120; statements += 9) {
        const Station b;
        SyncOptions options;
        int left = statements;
        options.stop = [&left] { return left-- <= 0; };
        sync_with_server(*b.store, b.store->station_session(), server, options);
        expect_sound(*b.store);
    }
}

TEST_F(SyncCutOff, KilledAtManyStatementsLosesNothing) {
    fill(a);
    a.open();
    a.store.reset();
    const std::string copy = a.folder.filePath("copy.db").toStdString();
    std::filesystem::copy_file(a.path, copy);
    const ServerAddress other = PostgresqlServer::of_this_process()->new_database();
    std::ofstream(a.folder.filePath("server").toStdString()) << server.text() << '\n';
    int killed = 0;
    for (int statement = 5; killed < 200; statement += 3) {
        if (wait_for_child(start_child("sync", a.folder.path().toStdString(), statement)) == 0) break;
        ++killed;
    }
    EXPECT_GT(killed, 10);
    a.open();
    expect_sound(*a.store);
    expect_sound(server);
    const Store whole = Store::open(copy, a.clock.options());
    sync_with_server(whole, a.session("administrator"), other);
    EXPECT_EQ(rows_on(server), rows_on(other));
    EXPECT_EQ(rows_at(*a.store, true), rows_at(whole, true));
}

TEST_F(SyncCutOff, ALostConnectionSaysSoAndLosesNothing) {
    fill(a);
    a.open();
    const PostgresqlServer& postgresql = *PostgresqlServer::of_this_process();
    SyncOptions options;
    int statements = 0;
    options.stop = [&] {
        if (++statements == 40)
            postgresql.execute(
                server,
                "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE pid <> pg_backend_pid() "
                "AND datname = current_database()");
        return false;
    };
    EXPECT_EQ(error_kind([&] { sync_with_server(*a.store, a.session("administrator"), server, options); }),
              StoreErrorKind::unreachable);
    expect_sound(*a.store);
    EXPECT_TRUE(sync(a).complete);
    EXPECT_EQ(rows_at(*a.store, true), rows_on(server));
    expect_sound(server);
}

class SyncRefusal : public Sync {
  protected:
    std::string refusal(const ServerAddress& to, StoreErrorKind kind) const {
        const std::string head = Audit(*a.store).head();
        try {
            sync_with_server(*a.store, a.session("administrator"), to);
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), kind) << error.what();
            EXPECT_EQ(Audit(*a.store).head(), head) << "the store was changed";
            return error.what();
        }
        ADD_FAILURE() << "not refused";
        return {};
    }
};

TEST_F(SyncRefusal, AProblemOfTheServerIsShownWithWhatToDo) {
    ServerAddress nobody = server;
    nobody.host = "/nowhere";
    EXPECT_NE(refusal(nobody, StoreErrorKind::unreachable).find("nothing is lost"), std::string::npos);
    ServerAddress no_database = server;
    no_database.database = "nothing";
    EXPECT_NE(refusal(no_database, StoreErrorKind::unreachable).find("createdb"), std::string::npos);
    const ServerAddress empty = PostgresqlServer::of_this_process()->new_database(false);
    EXPECT_NE(refusal(empty, StoreErrorKind::missing).find("fulcrum server create"), std::string::npos);
    PostgresqlServer& postgresql = *PostgresqlServer::of_this_process();
    postgresql.execute(server, "UPDATE programme_server SET schema = schema + 1");
    EXPECT_NE(refusal(server, StoreErrorKind::newer_schema).find("update Fulcrum"), std::string::npos);
    postgresql.execute(server, "UPDATE programme_server SET schema = schema - 2");
    EXPECT_NE(refusal(server, StoreErrorKind::older_schema).find("fulcrum server create"), std::string::npos);
}

TEST_F(SyncRefusal, AStationsAccountNeedsItsPasswordAndMayNotDelete) {
    const ServerAddress station = PostgresqlServer::as(server, "station");
    qputenv("PGPASSWORD", "wrong");
    EXPECT_NE(refusal(station, StoreErrorKind::unreachable).find("pgpass"), std::string::npos);
    const QTemporaryDir folder;
    QFile file(folder.filePath("pgpass"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray("*:*:*:station:") + PostgresqlServer::station_password + "\n");
    file.close();
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    qunsetenv("PGPASSWORD");
    qputenv("PGPASSFILE", file.fileName().toLocal8Bit());
    fill(a);
    a.open();
    EXPECT_TRUE(sync_with_server(*a.store, a.session("administrator"), station).complete);
    a.people().rename(a.session("administrator"), a.id("ben"), "Ben Changed");
    EXPECT_EQ(sync_with_server(*a.store, a.session("administrator"), station).transferred(), 1);
    EXPECT_EQ(error_kind([&] { erase_at_programme_server(station, a.id("ann"), false); }),
              StoreErrorKind::read_only);
    for (const char* sql : {"DELETE FROM attempt", "UPDATE score SET points = 100", "DELETE FROM audit_entry",
                            "INSERT INTO erasure VALUES ('x', 1)"})
        EXPECT_EQ(error_kind([&] { Connection(station).execute(sql); }), StoreErrorKind::read_only) << sql;
    qunsetenv("PGPASSFILE");
}

TEST_F(SyncRefusal, AnotherProgrammeAnOlderCopyAndTheWrongRoleAreRefused) {
    sync(a);
    a.store.reset();
    const std::string copy = a.folder.filePath("older.db").toStdString();
    std::filesystem::copy_file(a.path, copy);
    a.open();
    a.record("ann");
    sync(a);
    const Store older = Store::open(copy, a.clock.options());
    EXPECT_EQ(error_kind([&] { sync_with_server(older, a.session("administrator"), server); }),
              StoreErrorKind::conflict);
    Station other;
    const Session administrator =
        People(*other.store).create_programme("Elsewhere", "boss", "Other Boss", password).administrator;
    EXPECT_EQ(error_kind([&] { sync_with_server(*other.store, administrator, server); }),
              StoreErrorKind::conflict);
    EXPECT_THROW(sync_with_server(*a.store, a.session("ann"), server), AccessDenied);
    EXPECT_THROW(sync_with_server(*a.store, a.store->station_session(), server), AccessDenied);
}

TEST(ServerAddress, IsReadAndAPasswordInItIsRefused) {
    const ServerAddress address = ServerAddress::parse("postgresql://station1@host.example:5433/fulcrum");
    EXPECT_EQ(address.user, "station1");
    EXPECT_EQ(address.host, "host.example");
    EXPECT_EQ(address.port, 5433);
    EXPECT_EQ(address.text(), "postgresql://station1@host.example:5433/fulcrum");
    EXPECT_FALSE(address.is_local());
    EXPECT_NE(address.options().find("sslmode=require"), std::string::npos);
    const ServerAddress socket = ServerAddress::parse("postgresql:///fulcrum?host=/run/postgresql");
    EXPECT_TRUE(socket.is_local());
    EXPECT_EQ(ServerAddress::parse(socket.text()).host, "/run/postgresql");
    EXPECT_EQ(ServerAddress::parse("postgresql://?service=fulcrum").service, "fulcrum");
    for (const char* bad : {"", "mysql://a@b/c", "postgresql://host", "postgresql://a:secret@b/c",
                            "postgresql://a@b/c?sslmode=disable", "postgresql://a@b/c;sslmode=disable"}) {
        EXPECT_EQ(error_kind([&] { ServerAddress::parse(bad); }), StoreErrorKind::bad_value) << bad;
    }
    try {
        ServerAddress::parse("postgresql://a:secret@b/c");
    } catch (const StoreError& error) {
        EXPECT_EQ(std::string(error.what()).find("secret"), std::string::npos);
    }
}

class ServerTables : public Sync {};

TEST_F(ServerTables, ATraineesAccountSeesOwnRowsOnlyAndWritesNone) {
    const std::string own = fill(a);
    a.record("ben", true, 44);
    a.open();
    sync(a);
    const auto connect_as = [&](const std::string& login) {
        EXPECT_EQ(grant_at_programme_server(server, login).roles, std::vector<Role>{Role::trainee});
        return std::make_unique<Connection>(PostgresqlServer::as(server, a.id(login)));
    };
    const auto ann = connect_as("ann"), eve = connect_as("eve");
    const auto count = [](Connection& connection, const std::string& from) {
        Query row(connection, QString::fromStdString("SELECT COUNT(*) FROM " + from));
        return row.next() ? row.integer(0) : -1;
    };
    Connection owner(server);
    for (const char* table :
         {"attempt", "score", "gate", "metric", "trace_chunk", "comment", "rating", "rating_item",
          "rating_release", "person", "personal_goal", "personal_goal_end"}) {
        const std::int64_t all = count(owner, table), hers = count(*ann, table), none = count(*eve, table);
        EXPECT_GT(hers, 0) << table;
        EXPECT_LE(hers, all) << table;
        EXPECT_EQ(none, std::string(table) == "person" ? 1 : 0) << table;
    }
    EXPECT_EQ(count(*ann, "attempt"), 2);
    EXPECT_EQ(count(*ann, "attempt WHERE person_id <> '" + a.id("ann") + "'"), 0);
    // Herself, and by name the educator who commented, voided and rated.
    EXPECT_EQ(count(*ann, "person"), 2);
    EXPECT_EQ(count(*ann, "person WHERE id = '" + a.id("educator") + "'"), 1);
    EXPECT_EQ(count(*ann, "cohort_member WHERE person_id <> '" + a.id("ann") + "'"), 0);
    EXPECT_EQ(count(*ann, "audit_entry WHERE operation <> 'attempt.practice'"), 0);
    // Nothing that a client can set makes her somebody else.
    for (const std::string& sql :
         {std::string("SET ROLE owner"), std::string("SET row_security = off; SELECT COUNT(*) FROM attempt"),
          std::string("SELECT * FROM credential"), std::string("SELECT * FROM audit_payload"),
          std::string("SELECT verifier FROM credential"), std::string("CREATE TABLE mine (x int)"),
          std::string("SELECT recovery_verifier FROM programme"),
          std::string("INSERT INTO rating_seen VALUES ('x', 'y', 1)"),
          std::string("SELECT * FROM rating_seen"), std::string("UPDATE score SET points = 100"),
          std::string("DELETE FROM attempt"), std::string("INSERT INTO erasure VALUES ('x', 1)")})
        EXPECT_EQ(error_kind([&] { ann->execute(QString::fromStdString(sql)); }), StoreErrorKind::read_only)
            << sql;
}

TEST_F(ServerTables, HaveTheColumnsOfAStoreAndItsRefusals) {
    Connection connection(server);
    for (const SyncTable& table : sync_tables()) {
        std::vector<std::string> names = {table.table};
        for (const ChildTable& child : table.children) names.emplace_back(child.table);
        for (const std::string& name : names) {
            const QString text = QString::fromStdString(name);
            const QSqlRecord here = a.store->connection().database().record(text),
                             there = connection.database().record(text);
            ASSERT_EQ(here.count(), there.count()) << name;
            for (int i = 0; i < here.count(); ++i) EXPECT_EQ(here.fieldName(i), there.fieldName(i)) << name;
        }
    }
    fill(a);
    sync(a);
    for (const char* sql :
         {"UPDATE attempt SET seed = 1", "UPDATE score SET points = 100", "UPDATE audit_entry SET time = 1",
          "DELETE FROM audit_entry", "DELETE FROM rating", "UPDATE comment SET text = 'x'"})
        EXPECT_EQ(error_kind([&] { connection.execute(sql); }), StoreErrorKind::conflict) << sql;
}

TEST_F(ServerTables, AFailureOfALaterStatementIsNotLost) {
    Connection connection(server);
    EXPECT_EQ(error_kind([&] { connection.execute("SELECT 1; SELECT nothing; SELECT 2"); }),
              StoreErrorKind::failed);
    EXPECT_EQ(error_kind([&] {
                  Transaction transaction(connection);
                  connection.execute("DELETE FROM erasure; INSERT INTO programme VALUES (NULL)");
              }),
              StoreErrorKind::conflict);
    connection.execute("SELECT 1; SELECT 2");
}

TEST_F(ServerTables, AreMadeOnceAndUpgraded) {
    const ServerAddress empty = PostgresqlServer::of_this_process()->new_database(false);
    const ServerSchema made = create_programme_server(empty);
    EXPECT_EQ(made.from, 0);
    EXPECT_EQ(made.to, Store::schema_version());
    EXPECT_EQ(create_programme_server(empty).from, Store::schema_version());
    const ServerAddress older = PostgresqlServer::of_this_process()->new_database(false);
    Connection connection(older);
    create_server(connection, 0, 16);
    connection.execute("INSERT INTO cohort (id, name, created) VALUES ('c', 'Year 1', 0)");
    EXPECT_EQ(create_programme_server(older).from, 16);
    Query version(connection, "SELECT version FROM cohort");
    EXPECT_TRUE(version.next() && version.integer(0) == 1);
    Query guard(connection,
                "SELECT COUNT(*) FROM pg_trigger WHERE tgrelid = 'personal_goal'::regclass AND tgname = "
                "'of_erased_person'");
    EXPECT_TRUE(guard.next() && guard.integer(0) == 1) << "a table that the upgrade added";
    const ServerAddress foreign = PostgresqlServer::of_this_process()->new_database(false);
    PostgresqlServer::of_this_process()->execute(foreign, "CREATE TABLE person (name text)");
    EXPECT_EQ(error_kind([&] { create_programme_server(foreign); }), StoreErrorKind::not_a_store);
    EXPECT_EQ(error_kind([] {
                  step_for_server("CREATE TRIGGER x AFTER INSERT ON y BEGIN SELECT RAISE(ABORT, 'z'); END;");
              }),
              StoreErrorKind::failed);
}

}  // namespace
}  // namespace fulcrum::database::test
