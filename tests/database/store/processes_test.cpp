// SPDX-License-Identifier: GPL-3.0-or-later
// One store and many programs: no score that was acknowledged is lost, nobody is refused, and a program may
// be killed at any moment. FULCRUM_STORE_ROUNDS sets how many rounds and kills (200 for the long run).
#include "tests/database/processes.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "database/schema/migration.h"
#include "database/store/store_state.h"
#include "sim_core/lab/machine.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/kill_pages.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;
using namespace std::chrono_literals;

int rounds_asked(int usually) {
    const char* asked = std::getenv("FULCRUM_STORE_ROUNDS");
    return asked != nullptr ? std::atoi(asked) : usually;
}

/// In the page of all kills.
void enter_in_page(fulcrum::test::Killed activity, int kills, const char* checked, std::size_t found) {
    fulcrum::test::enter_kills({activity, static_cast<std::size_t>(kills), checked, found, 0},
                               lab::this_machine(lab::build_info()));
}

/// Waits for a condition that the child brings about; false if the child ended instead.
template <typename Condition>
bool wait_until(pid_t child, Condition&& condition) {
    while (!condition()) {
        if (!is_running(child)) return condition();
        std::this_thread::sleep_for(1ms);
    }
    return true;
}

class StoreProcesses : public ::testing::Test {
  protected:
    StoreProcesses() : counters(counters_in(folder_path)) {}
    /// Starts the child, waits until it begins and kills it within `span`. False if it ended by itself first.
    bool kill_at_random(const char* child_name, std::chrono::microseconds span) {
        const std::uint32_t before = counters.begun.load();
        const pid_t child = start_child(child_name, folder_path);
        if (!wait_until(child, [&] { return counters.begun.load() > before; })) return false;
        std::this_thread::sleep_for(std::chrono::microseconds(
            static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(span.count()))));
        return kill_child(child);
    }
    /// How long the child takes from its beginning to its end when nobody kills it.
    std::chrono::microseconds duration_of(const char* child_name) {
        const std::uint32_t before = counters.begun.load();
        const pid_t child = start_child(child_name, folder_path);
        EXPECT_TRUE(wait_until(child, [&] { return counters.begun.load() > before; }));
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(wait_for_child(child), 0);
        return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() -
                                                                     start) +
               1ms;
    }
    std::size_t scores() const {
        const Store store = Store::open(path);
        Query count(store.connection(), "SELECT COUNT(*) FROM score");
        return count.next() ? static_cast<std::size_t>(count.integer(0)) : 0;
    }
    void expect_sound() const {
        const Store store = Store::open(path);
        const CheckReport report = store.check(store.station_session());
        for (const CheckItem& item : report.items)
            EXPECT_TRUE(item.ok) << item.name << ": " << item.problems.front().words();
    }
    /// Names in the folder that begin with the store's.
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : files::directory_iterator(folder_path)) {
            const std::string name = entry.path().filename().string();
            if (name != "counters") found.push_back(name);
        }
        return found;
    }
    void remove_all() const {
        for (const std::string& name : names()) files::remove(files::path(folder_path) / name);
    }

    QTemporaryDir folder;
    const std::string folder_path = folder.path().toStdString(), path = folder_path + "/fulcrum.db";
    ChildCounters& counters;
    std::mt19937_64 random{20261122};
};

/// Whether another program could take the whole file for itself: SQLite does when it closes a store as its
/// last user, and then deletes the log.
bool others_may_lock(const std::string& path) {
    const pid_t child = ::fork();
    if (child == 0) {
        struct flock lock {};
        lock.l_type = F_WRLCK;
        lock.l_whence = SEEK_SET;
        const int file = ::open(path.c_str(), O_RDWR);
        ::_exit(file < 0 || ::fcntl(file, F_GETLK, &lock) != 0 ? 2 : lock.l_type == F_UNLCK ? 1 : 0);
    }
    const int status = wait_for_child(child);
    EXPECT_NE(status, 2);
    return status == 1;
}

TEST_F(StoreProcesses, OpeningTheStoreAgainKeepsTheLocksOfTheFirstConnection) {
    const Store first = Store::create(path);
    EXPECT_FALSE(others_may_lock(path));
    StoreOptions reading;
    reading.read_only = true;
    for (const StoreOptions& options : {StoreOptions(), reading}) {
        Store::open(path, options);
        EXPECT_FALSE(others_may_lock(path)) << "closing the second connection dropped the first one's locks";
    }
    EXPECT_TRUE(Store::exists(path));
    EXPECT_FALSE(others_may_lock(path));
    EXPECT_EQ(error_kind([&] { Store::create(path); }), StoreErrorKind::exists);
    EXPECT_FALSE(others_may_lock(path));
    EXPECT_TRUE(copy_database(first.connection(), folder_path + "/copy.db"));
    EXPECT_FALSE(others_may_lock(path));
    EXPECT_TRUE(first.check(first.station_session()).ok);
    EXPECT_FALSE(others_may_lock(path));
}

TEST_F(StoreProcesses, FiftyForeignOpensAndAKillLoseNoScoreAndNoSecondOfTheRunningAttempt) {
    Store::create(path);
    const pid_t window = start_child("window", folder_path);
    // The child ends with the test, also where an assertion returns early.
    const struct KillAtEnd {
        pid_t child;
        ~KillAtEnd() {
            if (is_running(child)) kill_child(child);
        }
    } kill_at_end{window};
    ASSERT_TRUE(wait_until(window, [&] { return counters.begun.load() == 1; }));
    for (int open = 0; open < 50; ++open) {
        const std::uint32_t before = counters.acknowledged.load();
        ASSERT_EQ(wait_for_child(start_child(open % 2 == 0 ? "command" : "foreign", folder_path)), 0) << open;
        ASSERT_TRUE(wait_until(window, [&] {
            return counters.acknowledged.load() > before || counters.failed.load() > 0;
        })) << "the window ended";
        ASSERT_EQ(counters.failed.load(), 0U) << open;
    }
    ASSERT_TRUE(kill_child(window));
    const std::uint32_t acknowledged = counters.acknowledged.load();
    EXPECT_GE(acknowledged, 50U);
    EXPECT_GE(scores(), acknowledged);
    EXPECT_EQ(counters.refused.load(), 0U);
    const Store store = Store::open(path);
    std::size_t interrupted = 0;
    for (const AttemptSummary& attempt : Attempts(store).list(store.station_session())) {
        if (attempt.state != AttemptState::interrupted) continue;
        ++interrupted;
        if (attempt.duration_s <= 1) continue;
        EXPECT_EQ(Attempts(store).read_trace(store.station_session(), attempt.meta.id).samples.size(),
                  static_cast<std::size_t>(attempt.duration_s * 1000 + 0.5));
    }
    EXPECT_GE(interrupted, 1U);
    expect_sound();
    std::printf("%u scores acknowledged, %zu in the store after 50 foreign opens and a kill\n", acknowledged,
                scores());
    enter_in_page(fulcrum::test::Killed::writing, 1, "scores that were acknowledged during 50 foreign opens",
                  acknowledged);
}

class StoreRounds : public StoreProcesses, public ::testing::WithParamInterface<int> {};

TEST_P(StoreRounds, RefuseNobodyAndLoseNoAcknowledgedScore) {
    const int count = rounds_asked(8);
    Store::create(path);
    std::vector<pid_t> programs;
    for (int i = 0; i < GetParam(); ++i) programs.push_back(start_child("rounds", folder_path, count));
    for (const pid_t program : programs) EXPECT_EQ(wait_for_child(program), 0);
    EXPECT_EQ(counters.refused.load(), 0U);
    EXPECT_EQ(counters.failed.load(), 0U);
    EXPECT_EQ(counters.acknowledged.load(), static_cast<std::uint32_t>(count * GetParam()));
    EXPECT_EQ(scores(), counters.acknowledged.load());
    expect_sound();
    std::printf(
        "%d programs, %d rounds each: %u scores acknowledged, %zu stored, %u refused, %u failed, longest "
        "round %u ms\n",
        GetParam(), count, counters.acknowledged.load(), scores(), counters.refused.load(),
        counters.failed.load(), counters.longest_ms.load());
    char value[160];
    std::snprintf(value, sizeof value,
                  "%u scores acknowledged, all in the store; 0 writes refused; longest %u ms",
                  counters.acknowledged.load(), counters.longest_ms.load());
    fulcrum::test::enter_shared_store(std::to_string(GetParam()) + " programs that write at the same time, " +
                                          std::to_string(count) + " rounds each",
                                      value, lab::this_machine(lab::build_info()));
}
INSTANTIATE_TEST_SUITE_P(Programs, StoreRounds, ::testing::Values(2, 8));

TEST_F(StoreProcesses, KilledFirstStartNeverBlocksTheNext) {
    const auto span = duration_of("create");
    const int kills = rounds_asked(25);
    int killed = 0, unnamed = 0;
    for (int kill = 0; kill < kills; ++kill) {
        remove_all();
        killed += kill_at_random("create", span) ? 1 : 0;
        unnamed += files::exists(path) ? 0 : 1;
        // What is there under the store's name is complete.
        ASSERT_EQ(files::exists(path), Store::exists(path)) << "kill " << kill;
        const Store store = Store::open_or_create(path);
        ASSERT_FALSE(store.station_id().empty());
        ASSERT_TRUE(kill % 5 != 0 || store.check(store.station_session()).ok);
    }
    remove_all();
    EXPECT_GT(killed, 0);
    kill_at_random("create", span);
    files::remove(path);
    Store::create(path);
    for (const std::string& name : names())
        EXPECT_EQ(name.find(".making-"), std::string::npos) << name << " was left by a killed program";
    std::printf("%d first starts killed, %d before the store had its name; every next start worked\n", killed,
                unnamed);
    enter_in_page(fulcrum::test::Killed::first_start, killed, "next starts that work",
                  static_cast<std::size_t>(killed));
}

TEST_F(StoreProcesses, UnfinishedStoreOfAnOlderProgramIsMadeAgain) {
    const auto with_connection = [&](const std::function<void(Connection&)>& steps) {
        Connection connection(path, false, true, 100);
        steps(connection);
    };
    const QString id =
        "PRAGMA journal_mode = WAL; PRAGMA application_id = " + QString::number(application_id);
    const std::vector<std::function<void()>> interrupted = {
        [&] { std::ofstream(path) << ""; },
        [&] { with_connection([](Connection& store) { store.execute("PRAGMA journal_mode = WAL"); }); },
        [&] { with_connection([&](Connection& store) { store.execute(id); }); },
        [&] { with_connection([&](Connection& store) { store.execute(id), migrate(store, 1); }); },
        [&] {
            with_connection(
                [&](Connection& store) { store.execute(id), migrate(store, latest_schema_version()); });
        },
    };
    for (std::size_t i = 0; i < interrupted.size(); ++i) {
        remove_all();
        interrupted[i]();
        ASSERT_TRUE(files::exists(path));
        EXPECT_FALSE(Store::exists(path)) << i;
        EXPECT_EQ(error_kind([&] { Store::open(path); }), StoreErrorKind::missing) << i;
        Store::create(path);
        EXPECT_TRUE(Store::exists(path));
        EXPECT_FALSE(Store::open(path).station_id().empty()) << i;
    }
}

TEST_F(StoreProcesses, SomebodyElsesFileIsNeverTakenForAnUnfinishedStore) {
    const auto refused = [&] {
        EXPECT_TRUE(Store::exists(path));
        EXPECT_EQ(error_kind([&] { Store::create(path); }), StoreErrorKind::exists);
        EXPECT_EQ(error_kind([&] { Store::open(path); }), StoreErrorKind::not_a_store);
        remove_all();
    };
    std::ofstream(path) << "a letter";
    refused();
    {
        Connection other(path, false, true, 100);
        other.execute("CREATE TABLE recipe (name)");
    }
    refused();
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    refused();
}

TEST_F(StoreProcesses, KilledBackupLeavesAWholeCopyOrNone) {
    {
        const Store store = Store::create(path);
        store.connection().execute(
            "CREATE TABLE ballast (data); WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n "
            "WHERE "
            "i < 200) INSERT INTO ballast SELECT randomblob(50000) FROM n");
    }
    const std::string copy = folder_path + "/copy.db";
    const auto span = duration_of("backup");
    const int kills = rounds_asked(15);
    int killed = 0, copies = 0;
    for (int kill = 0; kill < kills; ++kill) {
        files::remove(copy);
        killed += kill_at_random("backup", span) ? 1 : 0;
        if (!files::exists(copy)) continue;
        ++copies;
        Connection connection(copy, true, false, 100);
        Query sound(connection, "PRAGMA integrity_check"), rows(connection, "SELECT COUNT(*) FROM ballast");
        ASSERT_TRUE(sound.next() && rows.next());
        EXPECT_EQ(sound.text(0), "ok");
        EXPECT_EQ(rows.integer(0), 200);
    }
    EXPECT_GT(killed, 0);
    files::remove(copy);
    EXPECT_EQ(wait_for_child(start_child("backup", folder_path)), 0);
    for (const std::string& name : names())
        EXPECT_EQ(name.find(".part-"), std::string::npos) << name << " was left by a killed program";
    std::printf("%d backups killed: %d copies, each whole\n", killed, copies);
    enter_in_page(fulcrum::test::Killed::backing_up, killed, "copies under their final name, each whole",
                  static_cast<std::size_t>(copies));
}

TEST_F(StoreProcesses, ACopyEndsWhileAnotherProgramWritesAndHasTheStateOfItsBeginning) {
    const Store store = Store::create(path);
    store.connection().execute(
        "CREATE TABLE ballast (data); WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE "
        "i < 200) INSERT INTO ballast SELECT randomblob(50000) FROM n");
    Connection other(path, false, false, 100);
    int calls = 0;
    const std::string copy = folder_path + "/copy.db";
    EXPECT_TRUE(copy_database(store.connection(), copy, [&](double, const std::string&) {
        other.execute("INSERT INTO ballast VALUES (1)");
        return ++calls < 500;
    }));
    EXPECT_GT(calls, 2) << "written between the steps";
    Connection copied(copy, true, false, 100);
    Query sound(copied, "PRAGMA integrity_check"), rows(copied, "SELECT COUNT(*) FROM ballast");
    ASSERT_TRUE(sound.next() && rows.next());
    EXPECT_EQ(sound.text(0), "ok");
    EXPECT_EQ(rows.integer(0), 200);
    Query written(store.connection(), "SELECT COUNT(*) FROM ballast");
    ASSERT_TRUE(written.next());
    EXPECT_EQ(written.integer(0), 200 + calls) << "the view of the copy has ended";
}

TEST_F(StoreProcesses, KilledMigrationKeepsAUsableCopyAndTheNextStartFinishesIt) {
    const std::string copy = path + ".before-v" + std::to_string(Store::schema_version());
    const auto make_old_store = [&] {
        remove_all();
        Connection connection(path, false, true, 100);
        connection.execute("PRAGMA journal_mode = WAL; PRAGMA application_id = " +
                           QString::number(application_id));
        migrate(connection, 1);
        connection.execute(
            "INSERT INTO station VALUES ('s1', 'old', 1); INSERT INTO setting VALUES ('this_station', 's1'), "
            "('demo', '0'); CREATE TABLE ballast (data); WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT "
            "i + "
            "1 FROM n WHERE i < 60) INSERT INTO ballast SELECT randomblob(50000) FROM n");
    };
    const auto expect_copy = [&](int kill) {
        Connection before(copy, true, false, 100);
        EXPECT_EQ(read_schema_version(before), 1) << kill;
        Query sound(before, "PRAGMA integrity_check"), rows(before, "SELECT COUNT(*) FROM ballast");
        ASSERT_TRUE(sound.next() && rows.next());
        EXPECT_EQ(sound.text(0), "ok");
        EXPECT_EQ(rows.integer(0), 60);
    };
    make_old_store();
    const auto span = duration_of("migrate");
    const int kills = rounds_asked(15);
    int killed = 0, copies = 0;
    for (int kill = 0; kill < kills && !HasFatalFailure(); ++kill) {
        make_old_store();
        if (kill % 5 == 0) std::ofstream(copy) << "";  // as older programs left it
        killed += kill_at_random("migrate", span) ? 1 : 0;
        if (files::exists(copy) && files::file_size(copy) > 0) {
            ++copies;
            expect_copy(kill);
        }
        const Store store = Store::open(path);
        EXPECT_EQ(read_schema_version(store.connection()), Store::schema_version());
        expect_copy(kill);
    }
    EXPECT_GT(killed, 0);
    std::printf("%d migrations killed: %d had made their copy, each whole; every next start finished\n",
                killed, copies);
    enter_in_page(fulcrum::test::Killed::migrating, killed, "copies of the old store, each whole",
                  static_cast<std::size_t>(copies));
}

}  // namespace
}  // namespace fulcrum::database::test
