// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum sync and fulcrum server, as they are called.
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/services/program.h"
#include "database/rows/connection.h"
#include "tests/app/access_programme.h"
#include "tests/database/postgresql_server.h"
#include "tests/database/station_keys.h"

namespace fulcrum::app::program_test {
namespace {

class SyncCommands : public ::testing::Test {
  protected:
    SyncCommands() {
        programme.store.reset();
        password_file = programme.folder.filePath("password.txt").toStdString();
        std::ofstream(password_file) << database::test::password << '\n';
    }
    static nlohmann::json run(std::vector<std::string> words, int wanted) {
        words.emplace_back("--json");
        std::ostringstream output;
        struct Redirected {
            std::streambuf* before;
            ~Redirected() { std::cout.rdbuf(before); }
        };
        {
            const Redirected redirected{std::cout.rdbuf(output.rdbuf())};
            EXPECT_EQ(run_command(words), wanted);
        }
        return nlohmann::json::parse(output.str());
    }
    nlohmann::json sync(const std::string& to, int wanted) const {
        return run({"sync", "--to", to, "--db", programme.path, "--as",
                    AccessProgramme::login_of(Role::administrator), "--role", "administrator",
                    "--password-file", password_file},
                   wanted);
    }
    AccessProgramme programme;
    std::string password_file;
};

TEST_F(SyncCommands, CreateSyncCheckAndErase) {
    FULCRUM_NEEDS_POSTGRESQL();
    const std::string to = database::test::PostgresqlServer::of_this_process()->new_database(false).text();
    EXPECT_EQ(run({"server", "create", "--to", to}, 0)["from"], 0);
    const nlohmann::json first = sync(to, 0);
    EXPECT_TRUE(first["complete"]);
    EXPECT_GT(first["transferred"].get<int>(), 0);
    EXPECT_EQ(sync(to, 0)["transferred"], 0);
    const nlohmann::json check = run({"server", "check", "--to", to}, 0);
    EXPECT_TRUE(check["ok"]);
    EXPECT_EQ(check["stations"], 1);
    const std::string trainee = programme.id("ann");
    const nlohmann::json dry = run({"server", "erase", trainee, "--to", to, "--dry-run"}, 0);
    EXPECT_EQ(run({"server", "erase", trainee, "--to", to}, 0)["rows"], dry["rows"]);
    EXPECT_EQ(sync(to, 0)["erased"], 1);
    EXPECT_TRUE(run({"db", "check", "--db", programme.path}, 0)["ok"]);
}

TEST_F(SyncCommands, CtrlCEndsItAndTheNextRunCompletesIt) {
    FULCRUM_NEEDS_POSTGRESQL();
    const database::ServerAddress server =
        database::test::PostgresqlServer::of_this_process()->new_database();
    database::Connection other(server);
    nlohmann::json stopped;
    {
        // Holds the exchange up in the middle until Ctrl-C was pressed.
        database::Transaction lock(other);
        other.execute("LOCK TABLE person IN ACCESS EXCLUSIVE MODE");
        std::thread syncing([&] { stopped = sync(server.text(), 1); });
        database::Connection watch(server);
        for (bool waits = false; !waits;) {
            database::Query row(watch,
                                "SELECT COUNT(*) FROM pg_stat_activity WHERE datname = current_database() "
                                "AND wait_event_type = 'Lock'");
            waits = row.next() && row.integer(0) > 0;
        }
        ::raise(SIGINT);
        lock.commit();
        syncing.join();
    }
    EXPECT_FALSE(stopped["complete"]);
    EXPECT_TRUE(sync(server.text(), 0)["complete"]);
    EXPECT_EQ(sync(server.text(), 0)["transferred"], 0);
}

TEST_F(SyncCommands, ATokenMakesAStationOfTheServersAndTracesComeOnDemand) {
    FULCRUM_NEEDS_POSTGRESQL();
    const database::test::KeysOfOneTest keys;
    const std::string to = database::test::PostgresqlServer::of_this_process()->new_database().text();
    const std::vector<std::string> as = {"--db",
                                         programme.path,
                                         "--as",
                                         AccessProgramme::login_of(Role::administrator),
                                         "--role",
                                         "administrator",
                                         "--password-file",
                                         password_file};
    const auto with = [](std::vector<std::string> words, const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    const nlohmann::json first = run({"server", "enrol", "--to", to, "--name", "Lab 1", "--hours", "2"}, 0);
    EXPECT_TRUE(first["cohorts"].empty());
    EXPECT_TRUE(run(with({"sync", "--to", to, "--enrol", first["token"]}, as), 0)["complete"]);
    EXPECT_EQ(run(with({"sync"}, as), 0)["transferred"], 0) << "it knows its server";
    // A further station, of one cohort: from an empty store, without a sign-in.
    const nlohmann::json second = run({"server", "enrol", "Year 1", "--to", to}, 0);
    EXPECT_EQ(second["cohorts"], nlohmann::json({"Year 1"}));
    const std::string other = programme.folder.filePath("other.db").toStdString();
    run({"db", "create", "--db", other}, 0);
    EXPECT_TRUE(run({"sync", "--to", to, "--enrol", second["token"], "--db", other}, 0)["complete"]);
    EXPECT_THROW(run({"sync", "--to", to, "--enrol", second["token"], "--db", programme.path}, 2),
                 UsageError);
    const nlohmann::json stations = run({"server", "stations", "--to", to}, 0)["stations"];
    ASSERT_EQ(stations.size(), 2U);
    for (const nlohmann::json& one : stations) EXPECT_EQ(one["state"], "enrolled");
    const std::vector<std::string> educator = {
        "--db", other, "--as", "educator", "--role", "educator", "--password-file", password_file};
    const nlohmann::json fetched = run(with({"sync", "--trace", programme.ann.attempt}, educator), 0);
    EXPECT_GT(fetched["chunks"], 0);
    EXPECT_EQ(run(with({"sync", "--trace", programme.ann.attempt}, educator), 0)["chunks"], 0);
    EXPECT_TRUE(run({"db", "check", "--db", other}, 0)["ok"]);
    run({"server", "withdraw", second["id"], "--to", to}, 0);
    EXPECT_EQ(run({"server", "stations", "--to", to}, 0)["stations"][0]["state"], "withdrawn");
}

TEST_F(SyncCommands, WithoutASignInOrAServerItSaysWhatToDo) {
    EXPECT_THROW(run({"sync", "--to", "postgresql://x@127.0.0.1:1/d", "--db", programme.path}, 2),
                 UsageError);
    EXPECT_THROW(run({"sync", "--db", programme.path}, 2), UsageError);
    try {
        sync("postgresql://x@127.0.0.1:1/d", 1);
        ADD_FAILURE() << "nothing listens there";
    } catch (const database::StoreError& error) {
        EXPECT_FALSE(error.is_bad_input()) << "exit 1: the call was right";
        EXPECT_NE(std::string(error.what()).find("nothing is lost"), std::string::npos);
    }
}

}  // namespace
}  // namespace fulcrum::app::program_test
