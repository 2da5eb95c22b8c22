// SPDX-License-Identifier: GPL-3.0-or-later
// The file itself: making, opening, migrating, everything that may be wrong with it, check and backup.
#include <sqlite3.h>
#include <sys/stat.h>

#include <fstream>
#include <random>

#include "database/rows/connection.h"
#include "database/schema/migration.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

unsigned mode_of(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
    return status.st_mode & 0777U;
}

void run_sql(const std::string& path, const char* sql) {
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(handle, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(handle);
    sqlite3_close(handle);
}

TEST(Store, NewFileIsPrivateAndKnowsItsStation) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("new/folder/fulcrum.db").toStdString();
    {
        const Store store = Store::create(path);
        EXPECT_FALSE(store.station_id().empty());
        EXPECT_FALSE(store.has_administrator());
        EXPECT_FALSE(store.is_demo());
        EXPECT_EQ(mode_of(path), 0600U);
        EXPECT_EQ(mode_of(path + "-wal"), 0600U);
        EXPECT_EQ(mode_of(files::path(path).parent_path()), 0700U);
        EXPECT_EQ(mode_of(files::path(path).parent_path().parent_path()), 0700U);
        EXPECT_EQ(error_kind([&] { Store::create(path); }), StoreErrorKind::exists);
    }
    EXPECT_FALSE(Store::open(path).station_id().empty());
}

TEST(Store, MigratesAnOlderFileStepByStepAndKeepsACopy) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("old.db").toStdString();
    {
        Connection connection(path, false, true, 100);
        connection.execute("PRAGMA journal_mode = WAL; PRAGMA application_id = " +
                           QString::number(application_id));
        migrate(connection, 1);
        connection.execute(
            "INSERT INTO station VALUES ('s1', 'old', 1); INSERT INTO setting VALUES ('this_station', 's1'), "
            "('demo', '0')");
        connection.execute("INSERT INTO person VALUES ('p1', 'Zoe', 'zoe', 'Zoe Old', 'real', 1, 5, 1)");
        EXPECT_EQ(read_schema_version(connection), 1);
    }
    StoreOptions read_only;
    read_only.read_only = true;
    EXPECT_EQ(error_kind([&] { Store::open(path, read_only); }), StoreErrorKind::older_schema);
    const Store store = Store::open(path);
    EXPECT_EQ(read_schema_version(store.connection()), Store::schema_version());
    EXPECT_GE(Store::schema_version(), 4);
    Query person(store.connection(), "SELECT display_name FROM person WHERE id = 'p1'");
    ASSERT_TRUE(person.next());
    EXPECT_EQ(person.text(0), "Zoe Old");
    EXPECT_TRUE(Attempts(store).list(store.station_session()).empty());
    const std::string copy = path + ".before-v" + std::to_string(Store::schema_version());
    Connection before(copy, true, false, 100);
    EXPECT_EQ(read_schema_version(before), 1);
}

TEST(Store, AGateThatHadNoLimitLosesItsZeroAndAnOtherKeepsItsOwn) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("old.db").toStdString();
    {
        Connection connection(path, false, true, 100);
        connection.execute("PRAGMA journal_mode = WAL; PRAGMA application_id = " +
                           QString::number(application_id));
        migrate(connection, 3);
        connection.execute(
            "INSERT INTO station VALUES ('s1', 'old', 1); INSERT INTO setting VALUES ('this_station', 's1'), "
            "('demo', '0'); INSERT INTO person VALUES ('p1', 'Zoe', 'zoe', 'Zoe Old', 'real', 1, 5, 1); "
            "INSERT INTO attempt (id, person_id, station_id, task_id, task_version, mode, device_class, "
            "device, "
            "operator_name, variant, seed, fidelity, scene, scene_digest, curriculum, limits, "
            "program_version, "
            "cpu_features, started, utc_offset_min, state) VALUES ('a1', 'p1', 's1', 'A2', 1, 'assessed', "
            "'haptic', "
            "'', '', '', 1, '', '', '', '', '', '0.1.0', '', 1, 0, 'completed'); "
            "INSERT INTO score VALUES ('c1', 'a1', 1, '0.1.0', '', 1, NULL, 'no set', NULL, ''); "
            "INSERT INTO gate VALUES ('c1', 0, 'path_len', 'left', '', 'benchmark', 812.5, 'mm', 0, '', "
            "NULL, NULL, NULL, "
            "0, 'no level'), ('c1', 1, 'drop', '', '', 'absolute', 0, 'count', 0, 'safety', NULL, NULL, 1, "
            "0, '')");
    }
    const Store store = Store::open(path);
    Query gates(store.connection(), "SELECT limit_value IS NULL, limit_value FROM gate ORDER BY number");
    ASSERT_TRUE(gates.next());
    EXPECT_TRUE(gates.flag(0));
    ASSERT_TRUE(gates.next());
    EXPECT_FALSE(gates.flag(0));
    EXPECT_EQ(gates.real(1), 0.0);
    EXPECT_THROW(store.connection().execute("UPDATE gate SET limit_value = 5 WHERE number = 1"), StoreError);
}

TEST(Store, NewerSchemaIsRefusedUntouched) {
    Programme programme;
    programme.store.reset();
    run_sql(programme.path, "PRAGMA user_version = 99");
    try {
        Store::open(programme.path);
        FAIL();
    } catch (const StoreError& error) {
        EXPECT_EQ(error.kind(), StoreErrorKind::newer_schema);
        EXPECT_NE(error.problem().find("schema 99"), std::string::npos);
        EXPECT_TRUE(error.is_bad_input());
    }
}

TEST(Store, SaysWhatAFileIsNot) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("file").toStdString();
    EXPECT_EQ(error_kind([&] { Store::open(path); }), StoreErrorKind::missing);
    std::ofstream(path) << "This is a text, long enough to have a header of sixteen bytes.";
    EXPECT_EQ(error_kind([&] { Store::open(path); }), StoreErrorKind::not_a_store);
    files::remove(path);
    run_sql(path, "CREATE TABLE other (a)");
    EXPECT_EQ(error_kind([&] { Store::open(path); }), StoreErrorKind::not_a_store);
}

TEST(Store, ReadOnlyFileIsRefusedForWritingAndReadOtherwise) {
    Programme programme;
    const std::string attempt = programme.record("ann");
    programme.store.reset();
    files::permissions(programme.path, files::perms::owner_read);
    EXPECT_EQ(error_kind([&] { Store::open(programme.path); }), StoreErrorKind::read_only);
    StoreOptions read_only;
    read_only.read_only = true;
    const Store store = Store::open(programme.path, read_only);
    EXPECT_EQ(Attempts(store).read(programme.session("ann"), attempt).meta.task_id, "A2");
    EXPECT_EQ(
        error_kind([&] { Attempts(store).request_correction(programme.session("ann"), attempt, "not me"); }),
        StoreErrorKind::read_only);
}

TEST(Store, LockedFileSaysSoAndNothingIsLost) {
    Programme programme;
    sqlite3* other = nullptr;
    ASSERT_EQ(sqlite3_open(programme.path.c_str(), &other), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
    EXPECT_EQ(error_kind([&] {
                  programme.people().rename(programme.session("administrator"), programme.id("ann"), "Ann B");
              }),
              StoreErrorKind::locked);
    sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
    sqlite3_close(other);
    programme.people().rename(programme.session("administrator"), programme.id("ann"), "Ann B");
    EXPECT_EQ(programme.people().find(programme.session("director"), programme.id("ann"))->display_name,
              "Ann B");
}

TEST(Store, FullDiskSaysSoAndTheRecorderTriesAgain) {
    Programme programme;
    Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                      programme.clock.options());
    // The limit on pages replaces a full disk: SQLite answers both with the same code.
    std::int64_t page_count = 0;
    {
        Query pages(programme.store->connection(), "PRAGMA page_count");
        ASSERT_TRUE(pages.next());
        page_count = pages.integer(0);
    }
    programme.store->connection().execute("PRAGMA max_page_count = " + QString::number(page_count));
    EXPECT_EQ(error_kind([&] {
                  for (int i = 0; i < 200; ++i) {
                      programme.people().rename(programme.session("administrator"), programme.id("ann"),
                                                std::string(100, 'x'));
                  }
              }),
              StoreErrorKind::disk_full);
    programme.store->connection().execute("PRAGMA max_page_count = 1000000");
    Programme::append_second(recorder);
    recorder.finish(example_result(true, 50));
    EXPECT_TRUE(programme.store->check(programme.session("administrator")).ok);
    EXPECT_EQ(programme.attempts().read_trace(programme.session("ann"), recorder.attempt_id()).samples.size(),
              1000U);
}

const CheckItem& item(const CheckReport& report, const std::string& name) {
    for (const CheckItem& candidate : report.items) {
        if (candidate.name == name) return candidate;
    }
    ADD_FAILURE() << "no check named " << name;
    return report.items.front();
}

TEST(Store, CheckPassesOnAGoodStore) {
    Programme programme;
    programme.record("ann");
    const CheckReport report = programme.store->check(programme.session("station"));
    for (const CheckItem& each : report.items)
        EXPECT_TRUE(each.ok) << each.name << ": " << each.problems.front().words();
    EXPECT_TRUE(report.ok);
    EXPECT_EQ(item(report, "score digests").count, 1);
    EXPECT_GE(item(report, "trace checksums").count, 4);
}

TEST(Store, CheckPassesWhileAnotherProgramWrites) {
    const Programme programme;
    const Session& director = programme.session("director");
    std::vector<std::string> cohorts;
    for (int i = 0; i < 80; ++i)  // more records than it reads between two calls
        cohorts.push_back(programme.people().create_cohort(director, "Year " + std::to_string(i + 2)));
    const Store second = Store::open(programme.path, programme.clock.options());
    int calls = 0;
    const CheckReport report =
        programme.store->check(programme.session("administrator"), [&](double, const std::string& line) {
            if (line != "records" || ++calls != 2) return true;
            // The digests in the audit log were read, most cohorts were not.
            for (const std::string& cohort : cohorts)
                People(second).set_members(director, cohort, {programme.id("ann")});
            return true;
        });
    EXPECT_GE(calls, 2);
    for (const CheckItem& each : report.items)
        EXPECT_TRUE(each.ok) << each.name << ": " << each.problems.front().words();
    EXPECT_TRUE(report.ok && report.complete);
    // The view ends with the check: the same connection writes, and the next check sees what was written.
    programme.record("ann");
    programme.people().set_members(director, cohorts[0], {});
    EXPECT_EQ(programme.people().find_cohort(director, cohorts[1])->members.size(), 1U);
    EXPECT_TRUE(programme.store->check(programme.session("administrator")).ok);
}

TEST(Store, CheckFindsAnEditedScoreADamagedChunkAndALostOne) {
    Programme programme;
    programme.record("ann");
    programme.store.reset();
    run_sql(programme.path,
            "DROP TRIGGER metric_is_fixed; UPDATE metric SET value = 1 WHERE id = 'path_len'");
    programme.open();
    CheckReport report = programme.store->check(programme.session("station"));
    EXPECT_FALSE(report.ok);
    EXPECT_FALSE(item(report, "score digests").ok);
    EXPECT_TRUE(item(report, "trace checksums").ok);

    programme.store.reset();
    run_sql(programme.path,
            "DROP TRIGGER trace_chunk_is_fixed; UPDATE trace_chunk SET data = zeroblob(10) WHERE stream = 0;"
            "UPDATE trace_chunk SET number = 5 WHERE stream = 1");
    programme.open();
    report = programme.store->check(programme.session("station"));
    EXPECT_EQ(item(report, "trace checksums").problems.size(), 2U);
    EXPECT_EQ(error_kind([&] {
                  programme.attempts().read_trace(
                      programme.session("ann"),
                      programme.attempts().list(programme.session("ann"))[0].meta.id);
              }),
              StoreErrorKind::corrupt);
}

TEST(Store, ScoresAttemptsAndTracesCannotBeEdited) {
    Programme programme;
    programme.record("ann");
    for (const char* sql :
         {"UPDATE score SET points = 100", "UPDATE metric SET value = 0", "UPDATE gate SET passed = 1",
          "UPDATE attempt SET state = 'abandoned'", "UPDATE trace_chunk SET data = x'00'",
          "UPDATE audit_entry SET time = 0", "DELETE FROM audit_entry"}) {
        EXPECT_EQ(error_kind([&] { programme.store->connection().execute(sql); }), StoreErrorKind::conflict)
            << sql;
    }
}

TEST(Store, CorruptPagesAreReportedNotHidden) {
    Programme programme;
    for (int i = 0; i < 5; ++i) programme.record("ann");
    programme.store->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
    programme.store.reset();
    const auto size = files::file_size(programme.path);
    {
        // Every page but the first: whatever table a page belongs to, something must notice.
        std::fstream file(programme.path, std::ios::in | std::ios::out | std::ios::binary);
        for (std::uintmax_t page = 4096; page + 4096 <= size; page += 4096) {
            file.seekp(static_cast<std::streamoff>(page));
            file.write("\x5a\x5a\x5a\x5a\x5a\x5a\x5a\x5a\x5a\x5a\x5a\x5a\x5a\x5a\x5a\x5a", 16);
        }
    }
    EXPECT_EQ(error_kind([&] { Store::open(programme.path); }), StoreErrorKind::corrupt);
}

TEST(Store, CheckContinuesAfterADamagedTable) {
    Programme programme;
    for (int i = 0; i < 20; ++i) programme.record("ann");
    programme.store->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
    Query root(programme.store->connection(),
               "SELECT rootpage FROM sqlite_master WHERE name = 'trace_chunk'");
    ASSERT_TRUE(root.next());
    const std::int64_t page = root.integer(0);
    programme.store.reset();
    {
        std::fstream file(programme.path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp((page - 1) * 4096);
        const std::string garbage(4096, '\x5a');
        file.write(garbage.data(), 4096);
    }
    programme.open();
    const CheckReport report = programme.store->check(programme.session("station"));
    EXPECT_FALSE(item(report, "integrity").ok);
    EXPECT_FALSE(item(report, "trace checksums").ok);
    EXPECT_TRUE(item(report, "audit chain").ok);
    EXPECT_TRUE(item(report, "score digests").ok);
}

// A store from elsewhere is input like any other: whatever bytes are in it, reading ends in data or in a
// StoreError.
TEST(Store, FlippedBytesEndInAnErrorOrInDataNeverInACrash) {
    Programme programme;
    const std::string attempt = programme.record("ann");
    Reviews(*programme.store).write(programme.session("educator"), attempt, 1, "Here", true);
    programme.store->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
    programme.store.reset();
    std::ifstream file(programme.path, std::ios::binary);
    const std::string good((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::mt19937 random(5);
    const std::string path = programme.folder.filePath("flipped.db").toStdString();
    int errors = 0, found_by_check = 0;
    constexpr int rounds = 150;
    for (int round = 0; round < rounds; ++round) {
        std::string bad = good;
        const int flips = 1 << (random() % 9);
        for (int flip = 0; flip < flips; ++flip) bad[random() % bad.size()] = static_cast<char>(random());
        for (const char* suffix : {"", "-wal", "-shm"}) files::remove(path + suffix);
        std::ofstream(path, std::ios::binary).write(bad.data(), static_cast<std::streamsize>(bad.size()));
        try {
            const Store store = Store::open(path, programme.clock.options());
            if (!store.check(store.station_session()).ok) ++found_by_check;
            const Attempts attempts(store);
            for (const AttemptSummary& each : attempts.list(programme.session("director"))) {
                attempts.scores(programme.session("director"), each.meta.id);
                attempts.read_trace(programme.session("director"), each.meta.id);
                Reviews(store).comments(programme.session("director"), each.meta.id);
            }
            Reports(store).cohort_table(programme.session("director"), programme.cohort);
            People(store).list(programme.session("director"));
        } catch (const StoreError&) {
            ++errors;
        } catch (const AccessDenied&) {
            ++errors;
        }
    }
    EXPECT_GT(errors + found_by_check, rounds / 4);
}

TEST(Store, CheckNamesLoosePermissions) {
    Programme programme;
    files::permissions(programme.path,
                       files::perms::owner_read | files::perms::owner_write | files::perms::others_read);
    EXPECT_FALSE(item(programme.store->check(programme.session("station")), "permissions").ok);
}

TEST(Store, BackupIsWholePrivateAndNeverOverwrites) {
    Programme programme;
    const std::string attempt = programme.record("ann");
    Recorder running(programme.path, programme.session("ben"), example_meta(programme.id("ben")),
                     programme.clock.options());
    Programme::append_second(running);
    const std::string copy = programme.folder.filePath("copy.db").toStdString();
    programme.store->backup(programme.session("administrator"), copy);
    EXPECT_EQ(mode_of(copy), 0600U);
    EXPECT_EQ(error_kind([&] { programme.store->backup(programme.session("administrator"), copy); }),
              StoreErrorKind::exists);
    EXPECT_THROW(programme.store->backup(programme.session("ann"), copy + "2"), AccessDenied);
    EXPECT_FALSE(files::exists(copy + "2"));
    const Store other = Store::open(copy, programme.clock.options());
    EXPECT_TRUE(other.check(other.station_session()).ok);
    EXPECT_EQ(Attempts(other).read_trace(programme.session("ann"), attempt).samples.size(), 1000U);
}

TEST(Store, CheckAndBackupReportProgressAndStopWhenAsked) {
    const Programme programme;
    for (int i = 0; i < 18; ++i) programme.record("ann");  // more chunks than it reads between two calls
    const Session& administrator = programme.session("administrator");
    double last = 0;
    int calls = 0;
    const auto go_on = [&](double done, const std::string& line) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1);
        EXPECT_FALSE(line.empty());
        last = done;
        ++calls;
        return true;
    };
    const CheckReport whole = programme.store->check(administrator, go_on);
    EXPECT_TRUE(whole.ok && whole.complete);
    EXPECT_EQ(whole.items.size(), 10U);
    EXPECT_EQ(last, 1);
    // Stopped at each of its calls: nothing that was not looked at is called sound, nothing is called
    // damaged.
    for (int stop_at = 1; stop_at <= calls; ++stop_at) {
        int call = 0;
        const CheckReport part = programme.store->check(
            administrator, [&](double, const std::string&) { return ++call < stop_at; });
        EXPECT_TRUE(part.ok) << stop_at;
        EXPECT_FALSE(part.complete) << stop_at;
        EXPECT_LT(part.items.size(), 10U);
    }
    EXPECT_TRUE(programme.store->check(administrator).complete) << "the stopping ends with the call";
    const std::string copy = programme.folder.filePath("copy.db").toStdString();
    const std::int64_t rows = Audit(*programme.store).count();
    EXPECT_FALSE(
        programme.store->backup(administrator, copy, [](double, const std::string&) { return false; }));
    EXPECT_FALSE(std::filesystem::exists(copy));
    EXPECT_EQ(Audit(*programme.store).count(), rows) << "nothing was backed up";
    last = 0;
    EXPECT_TRUE(programme.store->backup(administrator, copy, go_on));
    EXPECT_EQ(last, 1);
    EXPECT_TRUE(Store::open(copy).check(administrator).ok);
}

TEST(Store, SeveralConnectionsSeeEachOthersWork) {
    Programme programme;
    const Store second = Store::open(programme.path, programme.clock.options());
    const std::string attempt = programme.record("ann");
    EXPECT_EQ(Attempts(second).read(programme.session("ann"), attempt).state, AttemptState::completed);
}

}  // namespace
}  // namespace fulcrum::database::test
