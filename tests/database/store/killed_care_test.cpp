// SPDX-License-Identifier: GPL-3.0-or-later
// Backup and restore, killed before each of their changes to files: what was acknowledged is still there, no
// half file has a final name, and the next try works. FULCRUM_CUT_OFF=1 takes every change;
// FULCRUM_KILLS_PAGE is the folder of the page.
#include <QDir>
#include <algorithm>
#include <cstdio>
#include <set>

#include "database/rows/connection.h"
#include "database/schema/migration.h"
#include "database/store/backup_rotation.h"
#include "database/store/damaged_copy.h"
#include "database/store/store_restore.h"
#include "sim_core/lab/machine.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/kill_pages.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

class KilledCare : public ::testing::Test {
  protected:
    KilledCare() {
        attempt = programme.record("ann");
        programme.store->backup(programme.session("administrator"), backup);
        later = programme.record("ben");
        programme.store.reset();
        QDir(programme.folder.path()).mkdir("first");
        for (const std::string& name : names()) files::copy_file(in(name), first + "/" + name);
    }
    std::string in(const std::string& name) const {
        return programme.folder.filePath(QString::fromStdString(name)).toStdString();
    }
    /// Files of the folder, by name.
    std::vector<std::string> names() const {
        std::vector<std::string> list;
        for (const auto& entry : files::directory_iterator(programme.folder.path().toStdString()))
            if (entry.is_regular_file()) list.push_back(entry.path().filename().string());
        std::sort(list.begin(), list.end());
        return list;
    }
    void put_back() const {
        for (const std::string& name : names()) files::remove(in(name));
        for (const auto& entry : files::directory_iterator(first))
            files::copy_file(entry.path(), in(entry.path().filename().string()));
    }
    static bool is_temporary(const std::string& name) {
        for (const char* mark : {".restoring-", ".part-", ".backups"})
            if (name.find(mark) != std::string::npos) return true;
        for (const char* ending : {"-wal", "-shm", "-journal"})
            if (QString::fromStdString(name).endsWith(ending)) return true;
        return false;
    }
    /// A whole store, as db check finds it, and the attempts in it.
    std::set<std::string> attempts_in_sound(const std::string& file, const std::string& when) const {
        const Store store = Store::open(file, programme.clock.options());
        for (const CheckItem& item : store.check(store.station_session()).items)
            EXPECT_TRUE(item.ok || item.id == CheckId::permissions)
                << file << ", " << when << ": " << item.name << ": " << item.problems.front().words();
        std::set<std::string> ids;
        Query rows(store.connection(), "SELECT id FROM attempt WHERE state = 'completed'");
        while (rows.next()) ids.insert(rows.text(0));
        return ids;
    }
    void restore() const {
        restore_store(
            backup, programme.path,
            [](const Store& copy) { return People(copy).sign_in("administrator", password); },
            programme.clock.options());
    }
    void back_up(const std::string& to) const {
        const Store store = Store::open(programme.path, programme.clock.options());
        store.backup(programme.session("administrator"), to);
    }
    static std::string at(int point, const CutOff& cut) {
        return "before change " + std::to_string(point) + " (" + cut.call + ")";
    }
    static void enter_sweep(fulcrum::test::Killed activity, int kills, const char* checked) {
        const auto count = static_cast<std::size_t>(kills);
        fulcrum::test::enter_kills({activity, count, checked, count, 0},
                                   lab::this_machine(lab::build_info()));
    }

    const TemporaryFoldersInMemory in_memory;
    Programme programme;
    const std::string backup = programme.folder.filePath("backup.db").toStdString(),
                      first = programme.folder.filePath("first").toStdString();
    std::string attempt, later;
};

TEST_F(KilledCare, OfARestoreLeavesTheOldStoreOrTheRestoredOne) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    const CutOff whole = cut_off(0, [this] { restore(); });
    ASSERT_EQ(whole.status, 0);
    int kills = 0, replaced = 0;
    for (const int point : cut_off_points(whole.changes, 12)) {
        put_back();
        const CutOff cut = cut_off(point, [this] { restore(); });
        if (!cut.killed) continue;
        ++kills;
        const std::string when = at(point, cut);
        ASSERT_TRUE(files::exists(programme.path)) << when;
        std::set<std::string> all;
        for (const std::string& name : names()) {
            if (is_temporary(name)) continue;
            const std::set<std::string> found = attempts_in_sound(in(name), when);
            EXPECT_EQ(found.count(attempt), 1U) << name << " " << when;
            all.insert(found.begin(), found.end());
            if (name == "fulcrum.db" && found.count(later) == 0) ++replaced;
        }
        EXPECT_EQ(all, (std::set<std::string>{attempt, later})) << when;
        restore();
        EXPECT_EQ(attempts_in_sound(programme.path, when), (std::set<std::string>{attempt})) << when;
        for (const std::string& name : names())
            EXPECT_EQ(name.find(".restoring-"), std::string::npos) << name << " was left, killed " << when;
        if (HasFailure()) break;
    }
    EXPECT_GT(kills, 0);
    std::printf("restore killed at %d of %d changes to files: %d times the backup was in place\n", kills,
                whole.changes, replaced);
    enter_sweep(fulcrum::test::Killed::restoring, kills, "old stores or restored ones, each whole");
}

TEST_F(KilledCare, OfARestoreIntoAnEmptyFolderLeavesNothingOrTheRestoredStore) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    const auto begin = [this] {
        put_back();
        for (const char* suffix : {"", "-wal", "-shm"}) files::remove(programme.path + suffix);
    };
    begin();
    const CutOff whole = cut_off(0, [this] { restore(); });
    ASSERT_EQ(whole.status, 0);
    int kills = 0;
    for (const int point : cut_off_points(whole.changes, 5)) {
        begin();
        const CutOff cut = cut_off(point, [this] { restore(); });
        if (!cut.killed) continue;
        ++kills;
        const std::string when = at(point, cut);
        if (files::exists(programme.path)) {
            EXPECT_EQ(attempts_in_sound(programme.path, when), (std::set<std::string>{attempt})) << when;
        }
        restore();
        EXPECT_EQ(attempts_in_sound(programme.path, when), (std::set<std::string>{attempt})) << when;
        if (HasFailure()) break;
    }
    EXPECT_GT(kills, 0);
    std::printf("restore into an empty folder killed at %d of %d changes to files\n", kills, whole.changes);
}

TEST_F(KilledCare, OfABackupLeavesAWholeCopyOrNoneAndTheStoreAsItWas) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    const std::string copy = in("copy.db");
    const auto deed = [this, &copy] { back_up(copy); };
    const CutOff whole = cut_off(0, deed);
    ASSERT_EQ(whole.status, 0);
    int kills = 0, copies = 0;
    for (const int point : cut_off_points(whole.changes, 12)) {
        put_back();
        const CutOff cut = cut_off(point, deed);
        if (!cut.killed) continue;
        ++kills;
        const std::string when = at(point, cut);
        EXPECT_EQ(attempts_in_sound(programme.path, when), (std::set<std::string>{attempt, later})) << when;
        if (files::exists(copy)) {
            ++copies;
            EXPECT_EQ(attempts_in_sound(copy, when), (std::set<std::string>{attempt, later})) << when;
            for (const char* suffix : {"", "-wal", "-shm"}) files::remove(copy + suffix);
        }
        deed();
        EXPECT_EQ(attempts_in_sound(copy, when), (std::set<std::string>{attempt, later})) << when;
        for (const std::string& name : names())
            EXPECT_EQ(name.find(".part-"), std::string::npos) << name << " was left, killed " << when;
        if (HasFailure()) break;
    }
    EXPECT_GT(kills, 0);
    std::printf("backup killed at %d of %d changes to files: %d whole copies, no half one\n", kills,
                whole.changes, copies);
    enter_sweep(fulcrum::test::Killed::backing_up, kills, "stores as they were, and no half copy");
}

TEST_F(KilledCare, OfARotationLeavesTheOlderBackupsUntilTheNewOneIsWhole) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    const std::string folder = in("backups");
    const auto rotate = [&](int seconds) {
        programme.clock.set_forward_s(seconds);
        const Store store = Store::open(programme.path, programme.clock.options());
        return backup_into(store, programme.session("administrator"), folder, 2)->path;
    };
    const auto backups = [&] {
        std::vector<std::string> whole;
        for (const auto& entry : files::directory_iterator(folder))
            if (entry.path().extension() == ".db") whole.push_back(entry.path().string());
        std::sort(whole.begin(), whole.end());
        return whole;
    };
    const auto begin = [&] {
        put_back();
        files::remove_all(folder);
        files::create_directory(folder);
        rotate(60);
        rotate(60);
    };
    begin();
    const auto deed = [&] { rotate(60); };
    const CutOff whole = cut_off(0, deed);
    ASSERT_EQ(whole.status, 0);
    int kills = 0, unfinished = 0;
    for (const int point : cut_off_points(whole.changes, 6)) {
        begin();
        const std::vector<std::string> before = backups();
        ASSERT_EQ(before.size(), 2U);
        const CutOff cut = cut_off(point, deed);
        if (!cut.killed) continue;
        ++kills;
        const std::string when = at(point, cut);
        const std::vector<std::string> after = backups();
        EXPECT_GE(after.size(), 2U) << when;
        if (after.back() == before.back()) {
            EXPECT_EQ(after, before) << "an old one goes when the new one is there";
            ++unfinished;
        }
        for (const std::string& file : after)
            EXPECT_EQ(attempts_in_sound(file, when), (std::set<std::string>{attempt, later})) << when;
        rotate(120);
        EXPECT_EQ(backups().size(), 2U) << when;
        for (const auto& entry : files::directory_iterator(folder))
            EXPECT_EQ(entry.path().string().find(".part-"), std::string::npos)
                << entry.path() << " was left, killed " << when;
        if (HasFailure()) break;
    }
    EXPECT_GT(kills, 0);
    EXPECT_GT(unfinished, 0);
    std::printf("rotation killed at %d of %d changes to files\n", kills, whole.changes);
    enter_sweep(fulcrum::test::Killed::backing_up, kills,
                "older backups that are there until the new one is");
}

TEST_F(KilledCare, OfPuttingAsideLeavesTheFileUnderOneNameOrBoth) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    const auto deed = [this] { put_aside(programme.path, programme.clock.options()); };
    const CutOff whole = cut_off(0, deed);
    ASSERT_EQ(whole.status, 0);
    int kills = 0;
    for (const int point : cut_off_points(whole.changes, 12)) {
        put_back();
        const CutOff cut = cut_off(point, deed);
        if (!cut.killed) continue;
        ++kills;
        const std::string when = at(point, cut);
        int whole_ones = 0;
        for (const std::string& name : names()) {
            if (is_temporary(name) || name == "backup.db") continue;
            EXPECT_EQ(attempts_in_sound(in(name), when), (std::set<std::string>{attempt, later}))
                << name << " " << when;
            ++whole_ones;
        }
        EXPECT_GE(whole_ones, 1) << when;
        if (HasFailure()) break;
    }
    EXPECT_GT(kills, 0);
    std::printf("putting aside killed at %d of %d changes to files\n", kills, whole.changes);
}

TEST_F(KilledCare, OfACopyOfADamagedStoreLeavesAWholeCopyOrNone) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    const auto deed = [this] {
        copy_damaged(programme.path, in("copy.db"),
                     [](const Store& store) { return People(store).sign_in("administrator", password); });
    };
    const CutOff whole = cut_off(0, deed);
    ASSERT_EQ(whole.status, 0);
    int kills = 0;
    for (const int point : cut_off_points(whole.changes, 8)) {
        put_back();
        const CutOff cut = cut_off(point, deed);
        if (!cut.killed) continue;
        ++kills;
        const std::string when = at(point, cut);
        EXPECT_EQ(attempts_in_sound(programme.path, when), (std::set<std::string>{attempt, later})) << when;
        if (files::exists(in("copy-unverified.db"))) {
            EXPECT_EQ(attempts_in_sound(in("copy-unverified.db"), when),
                      (std::set<std::string>{attempt, later}))
                << when;
        }
        if (HasFailure()) break;
    }
    EXPECT_GT(kills, 0);
    std::printf("copy of a damaged store killed at %d of %d changes to files\n", kills, whole.changes);
}

}  // namespace
}  // namespace fulcrum::database::test
