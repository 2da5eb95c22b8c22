// SPDX-License-Identifier: GPL-3.0-or-later
// Backups of a folder: the oldest of this station go, nothing else does; a copy that does not pass the check
// gets no name and removes nothing.
#include "database/store/backup_rotation.h"

#include <algorithm>
#include <fstream>
#include <future>

#include "database/rows/connection.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

class BackupRotation : public ::testing::Test {
  protected:
    BackupRotation() {
        attempt = programme.record("ann");
        files::create_directory(folder);
    }
    std::optional<RotatedBackup> rotate(int keep, const StoreProgress& progress = {}) const {
        programme.clock.pass_s(60);
        return backup_into(*programme.store, programme.session("administrator"), folder, keep, progress);
    }
    std::vector<std::string> names() const {
        std::vector<std::string> list;
        for (const auto& entry : files::directory_iterator(folder))
            list.push_back(entry.path().filename().string());
        std::sort(list.begin(), list.end());
        return list;
    }
    Programme programme;
    std::string attempt, folder = programme.folder.filePath("backups").toStdString();
};

TEST_F(BackupRotation, KeepsTheNewestOfItsOwnAndTouchesNothingElse) {
    const std::string start = "fulcrum-" + programme.store->station_id().substr(0, 8) + "-";
    // Not of its kind: another station's, other names, a folder, and a link of just that name.
    const std::vector<std::string> foreign = {"fulcrum-00000000-20200101T000000Z.db", "notes.txt",
                                              start + "20200101T000000Z.db.old", "copy.db",
                                              start + "2020.db"};
    for (const std::string& name : foreign) std::ofstream(folder + "/" + name) << "not ours";
    files::create_directory(folder + "/" + start + "20200102T000000Z.db");
    files::create_symlink(programme.path, folder + "/" + start + "20200103T000000Z.db");
    const std::size_t others = names().size();

    std::vector<std::string> made;
    for (int i = 0; i < 4; ++i) {
        const auto done = rotate(3);
        ASSERT_TRUE(done);
        made.push_back(done->path);
        EXPECT_EQ(done->removed, i < 3 ? std::vector<std::string>() : std::vector<std::string>{made[0]});
    }
    EXPECT_EQ(names().size(), others + 3);
    EXPECT_EQ(files::path(made[3]).filename().string().rfind(start, 0), 0U);
    EXPECT_EQ(rotate(1)->removed, (std::vector<std::string>{made[1], made[2], made[3]}));
    EXPECT_EQ(names().size(), others + 1);
    for (const std::string& name : foreign) EXPECT_TRUE(files::exists(folder + "/" + name)) << name;
    EXPECT_TRUE(files::exists(programme.path));
}

TEST_F(BackupRotation, WritesACopyThatNeedsNoFileNextToItAndOpensAsAStore) {
    const std::string path = rotate(1)->path;
    EXPECT_EQ(names().size(), 1U) << "no log, no temporary file";
    StoreOptions reading = programme.clock.options();
    reading.read_only = true;
    {
        const Store copy = Store::open(path, reading);
        EXPECT_TRUE(copy.check(copy.station_session()).ok);
        EXPECT_EQ(names().size(), 1U) << "reading makes no file";
    }
    const Store copy = Store::open(path, programme.clock.options());
    EXPECT_EQ(Attempts(copy).read_trace(programme.session("ann"), attempt).samples.size(), 1000U);
}

TEST_F(BackupRotation, TheNewOneStaysWhenTheClockWasSetBack) {
    const std::string first = rotate(1)->path;
    programme.clock.set_forward_s(-3600);
    const auto second = rotate(1);
    EXPECT_EQ(second->removed, std::vector<std::string>{first});
    EXPECT_TRUE(files::exists(second->path));
    programme.clock.set_forward_s(-60);
    EXPECT_EQ(error_kind([&] { rotate(1); }), StoreErrorKind::exists) << "the same second";
    EXPECT_TRUE(files::exists(second->path));
}

TEST_F(BackupRotation, TheOneOfTheNightBeforeStaysWhicheverWayTheClockWasSet) {
    const std::string first = rotate(2)->path, second = rotate(2)->path;
    programme.clock.set_forward_s(-86400);
    const auto third = rotate(2);
    EXPECT_EQ(third->removed, std::vector<std::string>{first});
    const auto fourth = rotate(2);
    EXPECT_EQ(fourth->removed, std::vector<std::string>{second}) << "not that of the night before";
    EXPECT_TRUE(files::exists(third->path));
    // The clock is a year ahead for a night, and put right.
    programme.clock.set_forward_s(400 * 86400.0);
    const auto ahead = rotate(2);
    EXPECT_EQ(ahead->removed, std::vector<std::string>{third->path});
    programme.clock.set_forward_s(-400 * 86400.0);
    EXPECT_EQ(rotate(2)->removed, std::vector<std::string>{ahead->path});
    EXPECT_TRUE(files::exists(fourth->path));
}

TEST_F(BackupRotation, ACopyThatDoesNotPassTheCheckGetsNoNameAndRemovesNothing) {
    const std::string good = rotate(2)->path;
    programme.store->connection().execute(
        "UPDATE person SET display_name = 'Somebody Else' WHERE login = 'ann'");
    try {
        rotate(1);
        ADD_FAILURE() << "a name that was changed by hand was backed up";
    } catch (const StoreError& error) {
        EXPECT_EQ(error.kind(), StoreErrorKind::corrupt);
        EXPECT_NE(error.problem().find("does not pass the check (records: person " + programme.id("ann")),
                  std::string::npos)
            << error.problem();
        EXPECT_NE(error.hint().find("db check"), std::string::npos);
    }
    EXPECT_EQ(names(), std::vector<std::string>{files::path(good).filename().string()});
}

TEST_F(BackupRotation, StoppedRefusedAndWrongOnesLeaveTheFolderAsItWas) {
    rotate(2);
    const std::vector<std::string> before = names();
    for (const double stop_at : {0.0, 0.4, 0.5, 0.7, 0.99})
        EXPECT_FALSE(rotate(1, [&](double done, const std::string&) { return done < stop_at; })) << stop_at;
    EXPECT_EQ(error_kind([&] { rotate(0); }), StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] { rotate(most_kept_backups + 1); }), StoreErrorKind::bad_value);
    for (const std::string& no_folder : {folder + "/none", programme.path})
        EXPECT_EQ(error_kind([&] {
                      backup_into(*programme.store, programme.session("administrator"), no_folder, 1);
                  }),
                  StoreErrorKind::bad_value);
    EXPECT_THROW(backup_into(*programme.store, programme.session("director"), folder, 1), AccessDenied);
    EXPECT_EQ(names(), before);
}

TEST_F(BackupRotation, TwoAtOnceLeaveAsManyAsEachKeeps) {
    const auto one = [&](int later) {
        ManualClock clock;
        clock.pass_s(later);
        const Store store = Store::open(programme.path, clock.options());
        return backup_into(store, programme.session("administrator"), folder, 1)->path;
    };
    std::future<std::string> other = std::async(std::launch::async, one, 10);
    const std::string here = one(20), there = other.get();
    EXPECT_EQ(names().size(), 1U);
    EXPECT_NE(files::exists(here), files::exists(there));
}

}  // namespace
}  // namespace fulcrum::database::test
