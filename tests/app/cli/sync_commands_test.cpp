// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum sync and fulcrum server, as they are called.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <thread>

#include "app/services/application.h"
#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"
#include "assessment/scoring/benchmark.h"
#include "database/rows/connection.h"
#include "database/store/accepted_assets.h"
#include "tests/app/access_programme.h"
#include "tests/app/live/forged_record.h"
#include "tests/database/network_server.h"
#include "tests/database/postgresql_server.h"
#include "tests/database/station_keys.h"
#include "tests/support/own_folder.h"

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
    const database::test::KeysOfOneTest keys;  // the list of erased people is next to them
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

TEST_F(SyncCommands, TheServersCheckSimulatesAttemptsAgainAndFindsAForgedOne) {
    FULCRUM_NEEDS_POSTGRESQL();
    const database::test::KeysOfOneTest keys;
    const std::string to = database::test::PostgresqlServer::of_this_process()->new_database().text();
    const std::string path = programme.folder.filePath("recorded.db").toStdString();
    const KeptStation station(path);
    const People people(station.store);
    const Session administrator =
        people.create_programme("Department", "administrator", "Ada Min", database::test::password)
            .administrator;
    const People::Created made = people.create(administrator, "ann", "Ann Trainee", {Role::trainee});
    const Session ann = people.change_password(people.sign_in("ann", made.one_time_password),
                                               made.one_time_password, database::test::password);
    // Attempts of simulated people stay at their station.
    const auto record = [&](std::uint64_t seed) {
        return record_expert_hands(station, path, seed, ann, DeviceClass::mouse_keyboard);
    };
    const auto send = [&] {
        EXPECT_TRUE(run({"sync", "--to", to, "--db", path, "--as", "administrator", "--role", "administrator",
                         "--password-file", password_file},
                        0)["complete"]);
    };
    const auto check = [&](int wanted) {
        return run({"server", "check", "--to", to, "--simulate", "10"}, wanted);
    };
    const std::string honest = record(11);
    send();
    const nlohmann::json good = check(0);
    EXPECT_TRUE(good["ok"]);
    EXPECT_NE(good["notes"].dump().find("attempt " + honest + ": simulated, "), std::string::npos)
        << good["notes"];
    // Only a simulation finds the next one: its station's key has signed what it has become.
    const std::string forged = record(12);
    take_forces_away(station, forged, ann);
    sign_again(station, forged);
    send();
    EXPECT_TRUE(run({"server", "check", "--to", to, "--simulate", "0"}, 0)["ok"]);
    const nlohmann::json bad = check(1);
    EXPECT_FALSE(bad["ok"]);
    ASSERT_EQ(bad["problems"].size(), 1U) << bad["problems"];
    EXPECT_EQ(bad["problems"][0].get<std::string>().find("attempt " + forged +
                                                         ": its record is not what its inputs give"),
              0U)
        << bad["problems"];
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

/// A station's own assets folder, as long as it lives.
class AssetsOfAStation {
  public:
    AssetsOfAStation() {
        std::filesystem::copy(folder_before_, folder_.path(), std::filesystem::copy_options::recursive);
        qputenv("FULCRUM_ASSETS", QByteArray::fromStdString(folder_.path().string()));
    }
    ~AssetsOfAStation() {
        before_.isNull() ? qunsetenv("FULCRUM_ASSETS") : qputenv("FULCRUM_ASSETS", before_);
    }
    std::filesystem::path operator/(const char* name) const { return folder_ / name; }

  private:
    QByteArray before_ = qgetenv("FULCRUM_ASSETS");
    std::string folder_before_ = assets_folder();
    fulcrum::test::OwnFolder folder_;
};

TEST_F(SyncCommands, WhatIsAcceptedAtOneStationIsInForceAtTheOtherAndInItsWindow) {
    FULCRUM_NEEDS_POSTGRESQL();
    const std::string to = database::test::PostgresqlServer::of_this_process()->new_database().text();
    const auto set_version = [](const std::filesystem::path& file, int version) {
        nlohmann::json set = nlohmann::json::parse(std::ifstream(file));
        set["version"] = version;
        std::ofstream(file) << set.dump(2);
    };
    {
        const AssetsOfAStation here;
        // A set and the next version of the curriculum, as an administrator puts them there.
        set_version(here / "benchmarks/A2.json", 90);
        std::filesystem::copy_file(here / "curricula/rectal.json", here / "curricula/rectal-1001.json");
        set_version(here / "curricula/rectal-1001.json", 1001);
        for (const char* file : {"benchmarks/A2.json", "curricula/rectal-1001.json"})
            run({"assets", "accept", (here / file).string(), "--reason", "ours", "--db", programme.path,
                 "--as", "educator", "--role", "educator", "--password-file", password_file},
                0);
        EXPECT_TRUE(sync(to, 0)["placed"].empty()) << "both are in place here";
    }
    const AssetsOfAStation there;
    const std::filesystem::path data = programme.folder.filePath("other").toStdString();
    std::filesystem::create_directory(data);
    const std::string other = (data / "fulcrum.db").string();
    run({"db", "create", "--db", other}, 0);
    // The first exchange cannot write.
    std::filesystem::rename(there / "curricula", there / "curricula away");
    std::filesystem::create_directory(there / "curricula");
    std::filesystem::copy_file(there / "curricula away/rectal.json", there / "curricula/rectal.json");
    std::filesystem::rename(there / "benchmarks", there / "benchmarks away");
    const nlohmann::json first = run({"sync", "--to", to, "--db", other}, 0)["placed"];
    ASSERT_EQ(first.size(), 2U);
    for (const nlohmann::json& one : first)
        EXPECT_EQ(one["refused"].is_null(), one["file"] == "curricula/rectal-1001.json") << one;
    std::filesystem::rename(there / "benchmarks away", there / "benchmarks");
    const nlohmann::json placed = run({"assets", "place", "--db", other}, 0)["placed"];
    ASSERT_EQ(placed.size(), 1U);
    EXPECT_EQ(placed[0]["file"], "benchmarks/A2.json");
    EXPECT_EQ(load_benchmark((there / "benchmarks/A2.json").string()).version, 90);
    EXPECT_TRUE(run({"assets", "place", "--db", other}, 0)["placed"].empty());
    for (const nlohmann::json& one : run({"assets", "list", "--db", other}, 0)["files"])
        EXPECT_NE(one["standing"], "unknown") << one;
    // A window whose folder lost the file puts it back when it opens the store.
    const auto window = make_services(data.string());
    std::filesystem::remove(there / "curricula/rectal-1001.json");
    const auto late = make_services(data.string());
    EXPECT_EQ(late->curriculum().version,
              load_curriculum(asset_path("curricula/rectal.json"), task_ids()).version);
    late->open_store(false);
    EXPECT_EQ(late->curriculum().version, 1001);
    EXPECT_EQ(window->curriculum().version, 1001);
}

TEST_F(SyncCommands, AWindowThatIsOpenFindsACurriculumThatCameSince) {
    const AssetsOfAStation here;
    const auto window = make_services(programme.folder.path().toStdString());
    window->open_store(false);
    const Curriculum& before = window->curriculum();
    const std::string name = before.name();
    window->look_for_curriculum();
    EXPECT_EQ(&window->curriculum(), &before) << "nothing has come";
    // As an exchange leaves it: accepted, with its contents, and not yet in the folder.
    nlohmann::json next = nlohmann::json::parse(std::ifstream(here / "curricula/rectal.json"));
    next["version"] = 1001;
    std::ofstream(here / "ours.json") << next.dump(2);
    run({"assets", "accept", (here / "ours.json").string(), "--reason", "ours", "--db", programme.path,
         "--as", "educator", "--role", "educator", "--password-file", password_file},
        0);
    window->look_for_curriculum();
    EXPECT_EQ(window->curriculum().name(), "rectal@1001");
    EXPECT_TRUE(std::filesystem::exists(here / "curricula/rectal-1001.json"));
    EXPECT_EQ(before.name(), name) << "pages hold on to it";
}

TEST_F(SyncCommands, ASetThatIsAcceptedFromAnyFolderHasTheNameThatItWillHave) {
    const AssetsOfAStation here;
    nlohmann::json set = nlohmann::json::parse(std::ifstream(here / "benchmarks/A2.json"));
    set["version"] = 90;
    std::ofstream(here / "ours.json") << set.dump(2);
    const nlohmann::json accepted =
        run({"assets", "accept", (here / "ours.json").string(), "--reason", "ours", "--db", programme.path,
             "--as", "educator", "--role", "educator", "--password-file", password_file},
            0);
    EXPECT_EQ(accepted["file"], "benchmarks/A2.json");
    {
        const database::Store store = database::Store::open(programme.path);
        EXPECT_EQ(database::AcceptedAssets(store).texts().size(), 1U) << "it is passed on";
    }
    const nlohmann::json placed = run({"assets", "place", "--db", programme.path}, 0)["placed"];
    ASSERT_EQ(placed.size(), 1U);
    EXPECT_EQ(load_benchmark((here / "benchmarks/A2.json").string()).version, 90);
}

/// Variables of the environment, as libpq reads them, as long as it lives.
class Variables {
  public:
    void set(const char* name, const std::string& value) {
        if (before_.count(name) == 0) before_[name] = qgetenv(name);
        qputenv(name, QByteArray::fromStdString(value));
    }
    ~Variables() {
        for (const auto& [name, value] : before_) {
            if (value.isNull())
                qunsetenv(name.c_str());
            else
                qputenv(name.c_str(), value);
        }
    }

  private:
    std::map<std::string, QByteArray> before_;
};

TEST_F(SyncCommands, OverANetworkItIsEncryptedOrRefusedAndTheServersCertificateIsCheckedWhereOneIsKnown) {
    FULCRUM_NEEDS_POSTGRESQL();
    const database::test::KeysOfOneTest keys;
    database::test::NetworkServer server(database::test::PostgresqlServer::of_this_process()->new_database());
    const std::optional<database::ServerAddress> station = server.as("station");
    if (!station) GTEST_SKIP() << "another program has port 5432 of this machine's loopback addresses";
    const std::string folder = programme.folder.path().toStdString();
    const auto own = database::test::make_certificate(folder, "programme-server"),
               other = database::test::make_certificate(folder, "somebody-else");
    if (!own || !other) GTEST_SKIP() << "the program openssl is missing: install the package openssl";
    Variables libpq;
    libpq.set("PGPASSWORD", database::test::PostgresqlServer::station_password);
    libpq.set("PGSSLMODE", "prefer");  // what a station's administrator may have set is not enough
    libpq.set("PGSSLROOTCERT", folder + "/none.crt");
    const std::string to = station->text();
    const auto refused = [&](const char* what_to_do) {
        try {
            sync(to, 1);
            ADD_FAILURE() << "it connected; expected: " << what_to_do;
        } catch (const database::StoreError& error) {
            EXPECT_EQ(error.kind(), database::StoreErrorKind::unreachable);
            EXPECT_NE(error.hint().find(what_to_do), std::string::npos) << error.what();
        }
    };
    refused("have the server's administrator turn ssl on");
    server.encrypt_with(*own);
    {
        database::Connection connection(*station);
        database::Query row(connection,
                            "SELECT CASE WHEN ssl THEN 1 ELSE 0 END FROM pg_stat_ssl WHERE pid = "
                            "pg_backend_pid()");
        ASSERT_TRUE(row.next());
        EXPECT_EQ(row.integer(0), 1) << "though only preferred by the environment";
    }
    EXPECT_TRUE(sync(to, 0)["complete"]);
    // With an authority that libpq knows, also where only encryption is asked for.
    for (const char* mode : {"require", "verify-ca"}) {
        libpq.set("PGSSLMODE", mode);
        libpq.set("PGSSLROOTCERT", other->file);
        refused("the server's certificate is not known here");
        libpq.set("PGSSLROOTCERT", own->file);
        EXPECT_EQ(sync(to, 0)["transferred"], 0) << mode;
    }
    libpq.set("PGSSLROOTCERT", folder + "/none.crt");
    refused("PGSSLROOTCERT");
    libpq.set("PGSSLROOTCERT", own->file);
    libpq.set("PGSSLMODE", "verify-full");
    refused("write the server's name in the address as its certificate names it");
    // An account that the server lets in from nowhere.
    libpq.set("PGSSLMODE", "verify-ca");
    try {
        const database::Connection connection(*server.as("owner"));
        ADD_FAILURE() << "the owner's account came over the network";
    } catch (const database::StoreError& error) {
        EXPECT_NE(error.hint().find("pg_hba.conf"), std::string::npos) << error.what();
    }
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
