// SPDX-License-Identifier: GPL-3.0-or-later
// Which backups are offered where the store cannot be opened.
#include "database/store/backup_list.h"

#include <algorithm>
#include <fstream>

#include "database/store/backup_rotation.h"
#include "database/store/damaged_copy.h"
#include "database/store/store_restore.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

class BackupList : public ::testing::Test {
  protected:
    BackupList() {
        programme.record("ann");
        files::create_directory(folder);
    }
    std::string back_up() const {
        programme.clock.pass_s(60);
        return backup_into(*programme.store, programme.session("administrator"), folder, 9)->path;
    }
    std::vector<FoundBackup> found() const {
        return find_backups(programme.path, backup_folders(programme.path));
    }
    std::vector<std::string> names() const {
        std::vector<std::string> list;
        for (const FoundBackup& one : found()) list.push_back(files::path(one.path).filename().string());
        return list;
    }
    Programme programme;
    std::string folder = programme.folder.filePath("backups").toStdString();
};

TEST_F(BackupList, FindsThemWhereTheyWereWrittenWithWhatTheyHoldTheNewestFirst) {
    EXPECT_TRUE(found().empty());
    const std::string first = back_up();
    programme.record("ben");
    const std::string second = back_up();
    programme.store.reset();
    std::ofstream(programme.path) << "garbage";
    const auto list = found();
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(list[0].path, second);
    EXPECT_EQ(list[1].path, first);
    EXPECT_EQ(list[0].programme, "Test programme");
    EXPECT_EQ(list[0].people, 7);
    EXPECT_EQ(list[0].attempts, 2);
    EXPECT_EQ(list[1].attempts, 1);
    EXPECT_EQ(list[0].schema, Store::schema_version());
    EXPECT_GT(list[0].newest, list[1].newest);
    EXPECT_GT(list[0].bytes, 100000);
    for (const FoundBackup& one : list) EXPECT_TRUE(one.problems.empty()) << one.problems.front().words();
}

TEST_F(BackupList, LeavesOutWhatIsNoVerifiedCopy) {
    const std::string good = back_up();
    const std::string live = folder + "/live.db";
    const Store other = Store::create(live);
    std::ofstream(folder + "/letter.db") << std::string(5000, 'x');
    files::create_symlink(good, folder + "/link.db");
    files::copy_file(good, folder + "/fulcrum.db.before-restore-20260101T000000Z");
    files::copy_file(good, folder + "/fulcrum.db.damaged-20260101T000000Z");
    const DamagedCopy copy = copy_damaged(programme.path, folder,
                                          [&](const Store&) { return programme.session("administrator"); });
    EXPECT_TRUE(files::exists(copy.path));
    EXPECT_EQ(names(), std::vector<std::string>{files::path(good).filename().string()});
}

TEST_F(BackupList, SaysOfADamagedOneThatItIsAndOfANewerOneThatItCannotBeUsed) {
    const std::string path = back_up();
    {
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        for (std::streamoff at = 8192; at < static_cast<std::streamoff>(files::file_size(path)); at += 4096) {
            file.seekp(at);
            file.write(std::string(200, '\x5a').data(), 200);
        }
    }
    ASSERT_EQ(found().size(), 1U);
    EXPECT_FALSE(found().front().problems.empty());
}

TEST_F(BackupList, KeepsTheNewestFoldersAndLeavesOtherLinesOut) {
    for (int i = 0; i < 15; ++i)
        note_backup_folder(programme.path, "/backups/disk" + std::to_string(i) + "/x.db");
    note_backup_folder(programme.path, "/backups/disk3/y.db");
    std::vector<std::string> folders = backup_folders(programme.path);
    ASSERT_EQ(folders.size(), 11U);
    EXPECT_EQ(folders[0], programme.folder.path().toStdString());
    EXPECT_EQ(folders[1], "/backups/disk3");
    EXPECT_EQ(folders[2], "/backups/disk14");
    std::ofstream(programme.path + ".backups") << "relative\n\n" << std::string(10000, 'x') << "\n/a\n";
    EXPECT_EQ(backup_folders(programme.path).size(), 2U);
    files::remove(programme.path + ".backups");
    files::create_directory(programme.path + ".backups");  // cannot be written
    EXPECT_NO_THROW(note_backup_folder(programme.path, "/b/x.db"));
    EXPECT_FALSE(back_up().empty());
}

TEST_F(BackupList, CanBeStopped) {
    back_up();
    back_up();
    int calls = 0;
    const auto list = find_backups(programme.path, backup_folders(programme.path),
                                   [&](double, const std::string&) { return ++calls < 2; });
    EXPECT_EQ(list.size(), 1U);
}

}  // namespace
}  // namespace fulcrum::database::test
