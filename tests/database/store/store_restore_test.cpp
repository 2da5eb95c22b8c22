// SPDX-License-Identifier: GPL-3.0-or-later
// Restoring a backup, migrating by command, and what backups do to files that are not theirs.
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>

#include "database/rows/connection.h"
#include "database/schema/migration.h"
#include "database/store/store_restore.h"
#include "tests/database/processes.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

class Restore : public ::testing::Test {
  protected:
    Restore() {
        attempt = programme.record("ann");
        backup = programme.folder.filePath("backup.db").toStdString();
        programme.store->backup(programme.session("administrator"), backup);
        later = programme.record("ben");
        programme.store.reset();
    }
    Replaced restore(const std::string& from) const {
        return restore_store(
            from, programme.path,
            [](const Store& copy) { return People(copy).sign_in("administrator", password); },
            programme.clock.options());
    }
    std::vector<std::string> names() const {
        std::vector<std::string> list;
        for (const auto& entry : files::directory_iterator(programme.folder.path().toStdString()))
            list.push_back(entry.path().filename().string());
        return list;
    }
    bool has(const std::string& attempt_id) const {
        StoreOptions options = programme.clock.options();
        options.read_only = true;
        const Store store = Store::open(programme.path, options);
        Query row(store.connection(), "SELECT 1 FROM attempt WHERE id = ?");
        row.bind(attempt_id);
        return row.next();
    }
    static void run_sql(const std::string& path, const char* sql) {
        sqlite3* handle = nullptr;
        ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(handle, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(handle);
        sqlite3_close(handle);
    }
    Programme programme;
    std::string attempt, later, backup;
};

TEST_F(Restore, PutsTheBackupInPlaceKeepsTheOldStoreAndSaysSoInTheAuditLog) {
    files::create_directory(programme.path + ".frames");
    std::ofstream(programme.path + ".frames/" + later + ".frames") << "of a replay";
    const Replaced done = restore(backup);
    EXPECT_FALSE(files::exists(programme.path + ".frames")) << "key frames of the store that was replaced";
    EXPECT_TRUE(has(attempt));
    EXPECT_FALSE(has(later));
    EXPECT_EQ(done.from_schema, Store::schema_version());
    const Store store = Store::open(programme.path, programme.clock.options());
    EXPECT_TRUE(store.check(store.station_session()).ok);
    const auto entries = Audit(store).entries(programme.session("administrator"));
    EXPECT_EQ(entries.front().operation, "store.restore");
    EXPECT_TRUE(Audit(store).has_head(done.head));
    EXPECT_FALSE(Audit(store).has_head(done.before)) << "what came after the backup is not in it";
    Query mode(store.connection(), "PRAGMA journal_mode");
    ASSERT_TRUE(mode.next());
    EXPECT_EQ(mode.text(0), "wal");
    const Store old = Store::open(done.kept, programme.clock.options());
    EXPECT_TRUE(Audit(old).has_head(done.before));
    EXPECT_TRUE(old.check(old.station_session()).ok);
    for (const std::string& name : names()) EXPECT_EQ(name.find(".restoring-"), std::string::npos) << name;
}

TEST_F(Restore, ReplacesTheFileThatALinkNamesAndKeepsTheLink) {
    const QTemporaryDir elsewhere;
    const std::string link = elsewhere.filePath("fulcrum.db").toStdString();
    files::create_symlink(programme.path, link);
    EXPECT_EQ(error_kind([&] {
                  restore_store(
                      programme.path, link,
                      [](const Store& copy) { return People(copy).sign_in("administrator", password); },
                      programme.clock.options());
              }),
              StoreErrorKind::bad_value)
        << "the store itself";
    const Replaced done = restore_store(
        backup, link, [](const Store& copy) { return People(copy).sign_in("administrator", password); },
        programme.clock.options());
    EXPECT_TRUE(files::is_symlink(files::symlink_status(link)));
    EXPECT_TRUE(has(attempt));
    EXPECT_FALSE(has(later)) << "the file that the link names is the restored one";
    EXPECT_TRUE(files::is_regular_file(files::symlink_status(done.kept))) << done.kept;
    EXPECT_TRUE(
        files::equivalent(files::path(done.kept).parent_path(), files::path(programme.path).parent_path()))
        << done.kept;
}

TEST_F(Restore, LeavesTheStoreToItsAccountAndNeedsTheKeyOfThatAccount) {
    if (::geteuid() != 0) GTEST_SKIP() << "only the superuser gives files away";
    ASSERT_EQ(::chown(programme.path.c_str(), 120, 120), 0);
    const QByteArray usual = qgetenv("FULCRUM_STATION_KEYS");
    const QTemporaryDir other_keys;
    qputenv("FULCRUM_STATION_KEYS", other_keys.path().toLocal8Bit());
    EXPECT_EQ(error_kind([&] { restore(backup); }), StoreErrorKind::failed);
    qputenv("FULCRUM_STATION_KEYS", usual);
    EXPECT_TRUE(has(later)) << "nothing was changed";
    for (const std::string& name : names()) {
        EXPECT_EQ(name.find(".restoring-"), std::string::npos) << name;
        EXPECT_EQ(name.find(".before-restore"), std::string::npos) << name;
    }
    restore(backup);
    EXPECT_FALSE(has(later));
    struct stat status {};
    ASSERT_EQ(::stat(programme.path.c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, 120U);
    EXPECT_EQ(status.st_gid, 120U);
    EXPECT_EQ(status.st_mode & 0777U, 0600U);
    const Store store = Store::open(programme.path, programme.clock.options());
    EXPECT_TRUE(store.check(store.station_session()).ok);
}

TEST_F(Restore, IsRefusedWhileAProgramHasTheStoreOpenAndChangesNothing) {
    const Store open = Store::open(programme.path, programme.clock.options());
    EXPECT_FALSE(open.station_id().empty());
    EXPECT_EQ(error_kind([&] { restore(backup); }), StoreErrorKind::locked);
    EXPECT_TRUE(has(later));
}

TEST_F(Restore, WorksOnAStoreWhoseProgramWasKilledWithItsLog) {
    const std::string folder = programme.folder.path().toStdString();
    ASSERT_EQ(programme.path, folder + "/fulcrum.db");
    const pid_t child = start_child("window", folder);
    while (counters_in(folder).begun == 0) ASSERT_TRUE(is_running(child));
    EXPECT_TRUE(files::exists(programme.path + "-wal"));
    EXPECT_EQ(error_kind([&] { restore(backup); }), StoreErrorKind::locked);
    ASSERT_TRUE(kill_child(child));
    EXPECT_TRUE(files::exists(programme.path + "-wal"));
    restore(backup);
    EXPECT_FALSE(has(later));
    const Store store = Store::open(programme.path, programme.clock.options());
    EXPECT_TRUE(store.check(store.station_session()).ok);
}

TEST_F(Restore, RefusesADamagedAForgedOrAForeignFileAndChangesNothing) {
    const std::string bad = programme.folder.filePath("bad.db").toStdString();
    // SQLite may leave a log next to a damaged file. The files that follow must not find it.
    const auto clear = [&] {
        for (const char* ending : {"", "-wal", "-shm", "-journal"}) files::remove(bad + ending);
    };
    const auto copy = [&] {
        clear();
        files::copy_file(backup, bad);
    };
    copy();
    run_sql(bad, "UPDATE person SET kind = 'real', display_name = 'Forged' WHERE login_key = 'ann'");
    EXPECT_EQ(error_kind([&] { restore(bad); }), StoreErrorKind::corrupt);
    copy();
    {
        std::fstream file(bad, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(static_cast<std::streamoff>(files::file_size(bad) / 2));
        file.write(std::string(4096, '\x5a').data(), 4096);
    }
    EXPECT_EQ(error_kind([&] { restore(bad); }), StoreErrorKind::corrupt);
    copy();
    run_sql(bad, "PRAGMA user_version = 99");
    EXPECT_EQ(error_kind([&] { restore(bad); }), StoreErrorKind::newer_schema);
    clear();
    std::ofstream(bad) << "a letter to somebody, longer than a header of a database would be";
    EXPECT_EQ(error_kind([&] { restore(bad); }), StoreErrorKind::not_a_store);
    EXPECT_EQ(error_kind([&] { restore(bad + "-none"); }), StoreErrorKind::missing);
    EXPECT_EQ(error_kind([&] { restore(programme.path); }), StoreErrorKind::bad_value);
    EXPECT_THROW(
        restore_store(
            backup, programme.path, [](const Store& store) { return People(store).sign_in("ann", password); },
            programme.clock.options()),
        AccessDenied);
    EXPECT_THROW(restore_store(
                     backup, programme.path,
                     [](const Store& store) { return People(store).sign_in("administrator", "a guess"); },
                     programme.clock.options()),
                 SignInRefused);
    EXPECT_TRUE(has(later));
    for (const std::string& name : names()) {
        EXPECT_EQ(name.find(".restoring-"), std::string::npos) << name;
        EXPECT_EQ(name.find(".before-restore"), std::string::npos) << name;
    }
}

TEST_F(Restore, ReplacesADamagedStoreAndKeepsWhatIsLeftOfIt) {
    std::string garbage(4096, '\x5a');
    {
        std::fstream file(programme.path, std::ios::in | std::ios::out | std::ios::binary);
        for (std::uintmax_t page = 4096; page + 4096 <= files::file_size(programme.path); page += 4096) {
            file.seekp(static_cast<std::streamoff>(page));
            file.write(garbage.data(), 4096);
        }
    }
    const Replaced done = restore(backup);
    EXPECT_TRUE(has(attempt));
    EXPECT_TRUE(files::exists(done.kept));
}

TEST_F(Restore, IntoAFolderWithoutAStore) {
    files::remove(programme.path);
    EXPECT_TRUE(restore(backup).kept.empty());
    EXPECT_TRUE(has(attempt));
    files::remove(programme.path);
    std::ofstream(programme.path + "-wal") << "a log";
    EXPECT_EQ(error_kind([&] { restore(backup); }), StoreErrorKind::locked);
}

TEST(Backup, LeavesFilesOfOthersAloneAndBlamesTheDiskThatIsFull) {
    const Programme programme;
    const std::string copy = programme.folder.filePath("copy.db").toStdString();
    for (const char* foreign : {".part-backup", ".part-abc123", ".part"})
        std::ofstream(copy + foreign) << "x";
    programme.store->backup(programme.session("administrator"), copy);
    for (const char* foreign : {".part-backup", ".part-abc123", ".part"})
        EXPECT_TRUE(files::exists(copy + foreign)) << foreign;

    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto ignore = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = before;
    small.rlim_cur = 64 * 1024;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    std::string said;
    try {
        programme.store->backup(programme.session("administrator"), copy + "2");
    } catch (const StoreError& error) {
        said = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, ignore);
    EXPECT_EQ(said.rfind(copy + "2:", 0), 0U) << said;
    EXPECT_FALSE(files::exists(copy + "2"));
}

/// A store as an older program left it: schema 7, with people and an audit chain without digests of records.
void make_old_store(const std::string& path) {
    Connection connection(path, false, true, 100);
    connection.execute("PRAGMA journal_mode = WAL; PRAGMA application_id = " +
                       QString::number(application_id));
    migrate(connection, 7);
    connection.execute(
        "INSERT INTO station VALUES ('s1', 'old', 1); INSERT INTO setting VALUES ('this_station', 's1'), "
        "('demo', '0'); INSERT INTO person VALUES ('p1', 'Zoe', 'zoe', 'Zoe Old', 'real', 1, 5, 1); "
        "INSERT INTO person_role VALUES ('p1', 'trainee')");
}

TEST(Migrate, ChecksCopiesAndReplacesAnOlderStore) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("old.db").toStdString();
    make_old_store(path);
    StoreOptions looking;
    looking.read_only = looking.older_schema = true;
    {
        const Store old = Store::open(path, looking);
        EXPECT_EQ(old.found_schema(), 7);
        files::permissions(path, files::perms::owner_read | files::perms::owner_write);
        const CheckReport report = old.check(old.station_session());
        for (const CheckItem& item : report.items)
            EXPECT_TRUE(item.ok) << item.name << ": " << item.problems.front().words();
        EXPECT_EQ(read_schema_version(old.connection()), 7) << "looking changes nothing";
    }
    const Replaced done = migrate_store(path);
    EXPECT_EQ(done.from_schema, 7);
    {
        const Store store = Store::open(path);
        EXPECT_EQ(store.found_schema(), Store::schema_version());
        const CheckReport report = store.check(store.station_session());
        for (const CheckItem& item : report.items)
            EXPECT_TRUE(item.ok) << item.name << ": " << item.problems.front().words();
        store.connection().execute("UPDATE person SET kind = 'synthetic' WHERE id = 'p1'");
        EXPECT_FALSE(store.check(store.station_session()).ok) << "from then on edits are found";
    }
    Connection kept(done.kept, true, false, 100);
    EXPECT_EQ(read_schema_version(kept), 7);
    EXPECT_TRUE(migrate_store(path).kept.empty()) << "nothing is left to do";
    const Store open = Store::open(path);
    StoreOptions impatient;
    impatient.busy_timeout_ms = 100;
    EXPECT_EQ(error_kind([&] { migrate_store(path, impatient); }), StoreErrorKind::locked);
}

TEST(Migrate, ReplacesTheFileThatALinkNamesAndKeepsTheLink) {
    const QTemporaryDir folder, elsewhere;
    const std::string path = folder.filePath("old.db").toStdString(),
                      link = elsewhere.filePath("fulcrum.db").toStdString();
    make_old_store(path);
    files::create_symlink(path, link);
    const Replaced done = migrate_store(link);
    EXPECT_TRUE(files::is_symlink(files::symlink_status(link)));
    EXPECT_EQ(Store::open(path).found_schema(), Store::schema_version());
    EXPECT_TRUE(files::is_regular_file(files::symlink_status(done.kept))) << done.kept;
    Connection kept(done.kept, true, false, 100);
    EXPECT_EQ(read_schema_version(kept), 7);
}

TEST(Migrate, LeavesTheStoreToItsAccount) {
    if (::geteuid() != 0) GTEST_SKIP() << "only the superuser gives files away";
    const QTemporaryDir folder;
    const std::string path = folder.filePath("old.db").toStdString();
    make_old_store(path);
    ASSERT_EQ(::chown(path.c_str(), 120, 120), 0);
    EXPECT_EQ(migrate_store(path).from_schema, 7);
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, 120U);
    EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(Restore, SaysHowFarItIsAndCanBeStoppedUntilTheEnd) {
    const auto sign_in = [](const Store& copy) { return People(copy).sign_in("administrator", password); };
    std::vector<double> seen;
    int stop_after = 1000000;
    const StoreProgress progress = [&](double done, const std::string&) {
        seen.push_back(done);
        return static_cast<int>(seen.size()) < stop_after;
    };
    for (const int after : {1, 3, 8}) {
        seen.clear();
        stop_after = after;
        const Replaced done =
            restore_store(backup, programme.path, sign_in, programme.clock.options(), progress);
        EXPECT_TRUE(done.stopped) << after;
        EXPECT_TRUE(done.kept.empty());
        EXPECT_TRUE(has(later)) << "nothing was changed";
        for (const std::string& name : names())
            EXPECT_EQ(name.find(".restoring-"), std::string::npos) << name;
    }
    seen.clear();
    stop_after = 1000000;
    EXPECT_FALSE(restore_store(backup, programme.path, sign_in, programme.clock.options(), progress).stopped);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_GT(seen.size(), 10U);
    EXPECT_GT(seen.back(), 0.95);
    EXPECT_FALSE(has(later));
}

TEST_F(Restore, ReplacesAStoreWhoseFirstPageIsGarbageWhereItIsKnownToBeTheStore) {
    for (const char* ending : {"-wal", "-shm"}) files::remove(programme.path + ending);
    std::fstream(programme.path, std::ios::in | std::ios::out | std::ios::binary) << std::string(200, 'x');
    EXPECT_EQ(error_kind([&] { restore(backup); }), StoreErrorKind::not_a_store)
        << "it may be the wrong file";
    const Replaced done = restore_store(
        backup, programme.path,
        [](const Store& copy) { return People(copy).sign_in("administrator", password); },
        programme.clock.options(), {}, ReplacedFile::any);
    EXPECT_TRUE(has(attempt));
    std::ifstream kept(done.kept, std::ios::binary);
    std::string start(200, ' ');
    kept.read(start.data(), 200);
    EXPECT_EQ(start, std::string(200, 'x')) << "the damaged file is still there";
}

TEST_F(Restore, PuttingAsideKeepsTheFileAndFreesItsName) {
    {
        const Store open = Store::open(programme.path, programme.clock.options());
        EXPECT_EQ(error_kind([&] { put_aside(programme.path, programme.clock.options()); }),
                  StoreErrorKind::locked);
    }
    const std::string kept = put_aside(programme.path, programme.clock.options());
    EXPECT_NE(kept.find("fulcrum.db.damaged-2026"), std::string::npos) << kept;
    EXPECT_FALSE(Store::exists(programme.path));
    for (const std::string& name : names()) EXPECT_NE(name, "fulcrum.db-wal");
    {
        const Store store = Store::open(kept, programme.clock.options());
        Query rows(store.connection(), "SELECT COUNT(*) FROM attempt");
        ASSERT_TRUE(rows.next());
        EXPECT_EQ(rows.integer(0), 2);
    }
    restore(backup);
    EXPECT_TRUE(has(attempt)) << "the name is free for a backup";
    std::ofstream(programme.path) << "a letter";
    EXPECT_NE(put_aside(programme.path, programme.clock.options()), kept);
    EXPECT_EQ(error_kind([&] { put_aside(programme.path); }), StoreErrorKind::missing);
}

}  // namespace
}  // namespace fulcrum::database::test
