// SPDX-License-Identifier: GPL-3.0-or-later
// A store that cannot be backed up is copied as it is, and the copy never passes for a backup.
#include "database/store/damaged_copy.h"

#include <fstream>

#include "database/rows/connection.h"
#include "database/store/backup_rotation.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

class DamagedStore : public ::testing::Test {
  protected:
    DamagedStore() {
        attempt = programme.record("ann");
        // All of it in the file, so that a page can be damaged there.
        programme.store->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
        programme.store.reset();
        files::create_directory(folder);
    }
    void write_at(std::streamoff place, std::size_t bytes) const {
        std::fstream file(programme.path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(place);
        file.write(std::string(bytes, '\x5a').data(), static_cast<std::streamsize>(bytes));
    }
    /// The page of a table that nobody needs to sign in.
    void damage_a_page() const {
        std::int64_t page = 0;
        {
            Connection connection(programme.path, true, false, 1000);
            Query root(connection, "SELECT rootpage FROM sqlite_master WHERE name = 'gate'");
            ASSERT_TRUE(root.next());
            page = root.integer(0);
        }
        write_at((page - 1) * 4096, 4000);
    }
    void damage_the_header() const { write_at(0, 100); }
    DamagedCopy copy(const std::string& to, const std::string& login = "administrator") const {
        return copy_damaged(programme.path, to,
                            [&](const Store& store) { return People(store).sign_in(login, password); });
    }
    static std::string bytes_of(const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    Programme programme;
    std::string attempt, folder = programme.folder.filePath("copies").toStdString();
};

TEST_F(DamagedStore, IsRefusedAsABackupAndCopiedUnderANameThatSaysSo) {
    damage_a_page();
    programme.open();
    EXPECT_EQ(
        error_kind([&] { programme.store->backup(programme.session("administrator"), folder + "/good.db"); }),
        StoreErrorKind::corrupt);
    programme.store.reset();
    const DamagedCopy done = copy(folder + "/as-it-is.db");
    EXPECT_EQ(done.path, folder + "/as-it-is-unverified.db");
    EXPECT_TRUE(done.by_database);
    EXPECT_FALSE(files::exists(folder + "/good.db") || files::exists(folder + "/as-it-is.db"));
    EXPECT_EQ(files::status(done.path).permissions() & files::perms(0777), files::perms(0600));
    StoreOptions reading;
    reading.read_only = true;
    const Store copied = Store::open(done.path, reading);
    const CheckReport report = copied.check(copied.station_session());
    EXPECT_FALSE(report.ok) << "the damage is in the copy";
    EXPECT_EQ(error_kind([&] { copy(folder + "/as-it-is.db"); }), StoreErrorKind::exists);
    EXPECT_EQ(copy(folder).path.find(folder + "/fulcrum-"), 0U) << "a folder: named by the time";
}

TEST_F(DamagedStore, IsCopiedByAnAdministratorOnlyAndTheAuditLogHasIt) {
    damage_a_page();
    EXPECT_THROW(copy(folder + "/x.db", "ann"), AccessDenied);
    EXPECT_THROW(copy(folder + "/x.db", "director"), AccessDenied);
    EXPECT_TRUE(files::is_empty(folder));
    copy(folder + "/x.db");
    programme.open();
    const auto entries = Audit(*programme.store).entries(programme.session("administrator"));
    EXPECT_EQ(entries.front().operation, "store.copy_damaged");
    EXPECT_NE(entries.front().payload.find("x-unverified.db"), std::string::npos);
}

TEST_F(DamagedStore, WhoseHeaderIsGarbageIsCopiedByteByByteWithItsLog) {
    damage_the_header();
    std::ofstream(programme.path + "-wal") << "what is left of the log";
    const std::string before = bytes_of(programme.path);
    bool asked = false;
    const DamagedCopy done = copy_damaged(programme.path, folder + "/x.db", [&](const Store&) -> Session {
        asked = true;
        throw std::runtime_error("nobody can sign in");
    });
    EXPECT_FALSE(done.by_database || asked);
    EXPECT_EQ(done.unreadable_bytes, 0);
    EXPECT_EQ(bytes_of(done.path), before);
    EXPECT_EQ(bytes_of(done.path + "-wal"), "what is left of the log");
    EXPECT_EQ(bytes_of(programme.path), before);
}

TEST_F(DamagedStore, CopyThatIsStoppedLeavesNothing) {
    damage_a_page();
    const DamagedCopy done = copy_damaged(
        programme.path, folder + "/x.db", [&](const Store&) { return programme.session("administrator"); },
        [](double, const std::string&) { return false; });
    EXPECT_TRUE(done.stopped);
    damage_the_header();
    EXPECT_TRUE(copy_damaged(
                    programme.path, folder + "/y.db",
                    [](const Store& store) { return store.station_session(); },
                    [](double, const std::string&) { return false; })
                    .stopped);
    EXPECT_TRUE(files::is_empty(folder));
}

TEST_F(DamagedStore, CopiesAreNotCountedAmongTheBackupsAndNotRemovedWithThem) {
    const DamagedCopy done = copy(folder);
    programme.open();
    for (int i = 0; i < 3; ++i) {
        programme.clock.pass_s(60);
        ASSERT_TRUE(backup_into(*programme.store, programme.session("administrator"), folder, 1));
    }
    int backups = 0;
    for (const auto& entry : files::directory_iterator(folder)) backups += entry.path().string() != done.path;
    EXPECT_EQ(backups, 1);
    EXPECT_TRUE(files::exists(done.path));
}

}  // namespace
}  // namespace fulcrum::database::test
