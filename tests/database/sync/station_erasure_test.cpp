// SPDX-License-Identifier: GPL-3.0-or-later
// A person of a programme without a server is erased, stays erased when an older backup is restored, and
// nobody else loses anything.
#include "database/sync/station_erasure.h"

#include <filesystem>
#include <fstream>
#include <map>

#include "assessment/assets/assets.h"
#include "database/records/curricula.h"
#include "database/records/person_merge.h"
#include "database/records/ratings.h"
#include "database/store/kept_frames.h"
#include "database/store/store_restore.h"
#include "database/sync/trace_fetch.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class StationErasure : public ::testing::Test {
  protected:
    StationErasure() {
        programme.record("ann");
        programme.record("ben");
    }
    std::vector<ErasedRows> erase(const std::string& login, bool dry_run = false) const {
        return erase_person(*programme.store, programme.session("director"), programme.id(login),
                            "asked for it", dry_run);
    }
    std::string name_of(const std::string& login) const {
        Query row(programme.store->connection(), "SELECT display_name FROM person WHERE id = ?");
        row.bind(programme.id(login));
        return row.next() ? row.text(0) : "";
    }
    int attempts() const {
        Query rows(programme.store->connection(), "SELECT COUNT(*) FROM attempt");
        return rows.next() ? static_cast<int>(rows.integer(0)) : -1;
    }

    Programme programme;
    const KeysOfOneTest own_keys;  // the list of erased people is next to them
};

TEST_F(StationErasure, DeletesThePersonAndNobodyElse) {
    const std::vector<ErasedRows> planned = erase("ann", true);
    EXPECT_EQ(name_of("ann"), "Ann Trainee");
    EXPECT_FALSE(QFile::exists(QString::fromStdString(erasure_list_path(programme.store->station_id()))));
    const std::vector<ErasedRows> done = erase("ann");
    ASSERT_EQ(planned.size(), done.size());
    for (std::size_t i = 0; i < done.size(); ++i) EXPECT_EQ(planned[i].rows, done[i].rows) << done[i].table;
    EXPECT_EQ(name_of("ann"), "Erased person");
    EXPECT_EQ(attempts(), 1);
    EXPECT_EQ(name_of("ben"), "Ben Trainee");
    EXPECT_THROW(programme.people().sign_in("ann", password), SignInRefused);
    expect_sound(*programme.store);
    std::ifstream list(erasure_list_path(programme.store->station_id()));
    const std::string text{std::istreambuf_iterator<char>(list), {}};
    EXPECT_NE(text.find(programme.id("ann")), std::string::npos);
    EXPECT_EQ(text.find("Ann"), std::string::npos);
    EXPECT_EQ(erase_listed(*programme.store), 0) << "she is gone already";
}

TEST_F(StationErasure, ACopyIsKnownAsOneAfterThePersonItWasTakenFromIsErased) {
    const Session &educator = programme.session("educator"), &director = programme.session("director");
    programme.people().set_members(director, programme.cohort,
                                   {programme.id("ann"), programme.id("ben"), programme.id("eve")});
    const Curriculum newest = load_versions(asset_path("curricula"), "rectal", task_ids());
    ASSERT_NE(newest.version_named("rectal@1"), nullptr);
    AttemptMeta meta = example_meta(programme.id("ann"));
    meta.curriculum = "rectal@1";
    std::string taken;
    {
        Recorder recorder(programme.path, programme.session("ann"), meta, programme.clock.options());
        Programme::append_second(recorder);
        recorder.finish(example_result(true, 70));
        taken = recorder.attempt_id();
    }
    const Attempts attempts = programme.attempts();
    const auto assets_before = attempts.assets(educator, taken);
    const Ratings ratings(*programme.store);
    ratings.note_seen(educator, taken);
    const std::string copy = attempts.reassign(educator, taken, programme.id("eve"), "Eve sat there");
    ratings.note_seen(director, taken);  // the original, after the reassignment
    erase("ann");
    const auto followed = Curricula(*programme.store).followed(director, programme.id("eve"), newest);
    EXPECT_EQ(followed.back().name, newest.name()) << "the copy names what Ann followed";
    for (const Session& rater : {educator, director}) {
        Query seen(programme.store->connection(),
                   "SELECT 1 FROM rating_seen WHERE attempt_id = ? AND person_id = ?");
        seen.bind(copy).bind(rater.person_id());
        EXPECT_TRUE(seen.next()) << rater.login();
    }
    EXPECT_EQ(attempts.assets(director, copy).size(), assets_before.size()) << "the mark is no file";
    expect_sound(*programme.store);
}

TEST_F(StationErasure, WaitsForAnAttemptThatRunsAndNotForOneWhoseProgramWasKilled) {
    {
        Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                          programme.clock.options());
        Programme::append_second(recorder);
        recorder.flush();
        EXPECT_EQ(error_kind([&] { erase("ann"); }), StoreErrorKind::locked);
        EXPECT_EQ(name_of("ann"), "Ann Trainee");
    }
    EXPECT_EQ(attempts(), 3) << "it stays as running until the store is opened again";
    erase("ann");
    EXPECT_EQ(name_of("ann"), "Erased person");
    EXPECT_EQ(attempts(), 1);
    for (const auto& entry : std::filesystem::directory_iterator(programme.folder.path().toStdString()))
        EXPECT_EQ(entry.path().filename().string().find(".recording-"), std::string::npos) << entry.path();
    expect_sound(*programme.store);
}

TEST_F(StationErasure, TakesTheKeyFramesOfTheirReplaysToo) {
    std::map<std::string, std::string> attempt_of;
    Query rows(programme.store->connection(), "SELECT person_id, id FROM attempt");
    while (rows.next()) attempt_of[rows.text(0)] = rows.text(1);
    const std::filesystem::path folder = kept_frames_folder(*programme.store);
    EXPECT_EQ(folder, programme.path + ".frames");
    std::filesystem::create_directory(folder);
    const auto put = [&](const std::string& name) {
        std::ofstream(folder / name) << "frames";
        return folder / name;
    };
    const auto has = [](const std::filesystem::path& file) { return std::filesystem::exists(file); };
    const std::string anns = kept_frames_name(attempt_of.at(programme.id("ann")));
    const auto hers = put(anns), unfinished = put(anns + ".new-77-1"),
               his = put(kept_frames_name(attempt_of.at(programme.id("ben")))), other = put("notes.txt");
    erase("ann", true);
    EXPECT_TRUE(has(hers));
    erase("ann");
    EXPECT_FALSE(has(hers));
    EXPECT_FALSE(has(unfinished));
    EXPECT_TRUE(has(his));
    // A window that made frames of her attempt while she was erased.
    put(anns);
    EXPECT_EQ(remove_frames_without_attempt(*programme.store), 1);
    EXPECT_FALSE(has(hers));
    EXPECT_TRUE(has(his));
    EXPECT_TRUE(has(other));
}

TEST_F(StationErasure, AStoreThatIsOnlyReadKeepsNoKeyFrames) {
    StoreOptions options = programme.clock.options();
    options.read_only = true;
    const Store only_read = Store::open(programme.path, options);
    EXPECT_EQ(kept_frames_folder(only_read), "");
    std::filesystem::create_directory(programme.path + ".frames");
    std::ofstream(programme.path + ".frames/gone.frames") << "frames";
    EXPECT_EQ(remove_frames_without_attempt(only_read), 0);
    remove_kept_frames(only_read, "gone");
    EXPECT_TRUE(std::filesystem::exists(programme.path + ".frames/gone.frames"));
}

TEST(KeptFrames, OnlyAPlainIdNamesAFileAndALinkedFolderIsLeftAlone) {
    for (const char* bad : {"", "..", "a/b", "../x", "a.b", "a b"})
        EXPECT_EQ(kept_frames_name(bad), "") << bad;
    EXPECT_EQ(kept_frames_name(std::string(65, 'a')), "");
    EXPECT_EQ(kept_frames_name("0b-1C"), "0b-1C.frames");
    const QTemporaryDir folder;
    const std::filesystem::path real = folder.filePath("elsewhere").toStdString();
    std::filesystem::create_directory(real);
    std::ofstream(real / "a.frames") << "somebody else's";
    const std::string store = folder.filePath("x.db").toStdString();
    std::filesystem::create_directory_symlink(real, store + ".frames");
    remove_all_kept_frames(store);
    EXPECT_TRUE(std::filesystem::exists(real / "a.frames"));
}

TEST_F(StationErasure, IsDoneAgainAfterAnOlderBackupWasRestored) {
    const std::string backup = programme.folder.filePath("older.db").toStdString();
    programme.store->backup(programme.session("administrator"), backup);
    erase("ann");
    programme.store.reset();
    restore_store(
        backup, programme.path, [&](const Store&) { return programme.session("administrator"); },
        programme.clock.options());
    programme.open();
    EXPECT_EQ(name_of("ann"), "Ann Trainee") << "the backup has her";
    EXPECT_EQ(erase_listed(*programme.store), 1);
    EXPECT_EQ(name_of("ann"), "Erased person");
    EXPECT_EQ(attempts(), 1);
    expect_sound(*programme.store);
}

TEST_F(StationErasure, TakesTheMergedAccountsToo) {
    programme.record("eve");
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("eve"), programme.id("ann"), "entered twice");
    erase("ann");
    EXPECT_EQ(name_of("eve"), "Erased person");
    EXPECT_EQ(attempts(), 1);
    expect_sound(*programme.store);
}

TEST_F(StationErasure, IsTheDirectorsAndNeverOfOneself) {
    const std::string ann = programme.id("ann");
    for (const char* login : {"ann", "educator", "administrator", "station"})
        EXPECT_THROW(erase_person(*programme.store, programme.session(login), ann, "asked", false),
                     AccessDenied)
            << login;
    EXPECT_THROW(erase("director"), AccessDenied);
    EXPECT_EQ(error_kind([&] { erase("administrator"); }), StoreErrorKind::conflict) << "the last one";
    EXPECT_EQ(
        error_kind([&] { erase_person(*programme.store, programme.session("director"), ann, " ", false); }),
        StoreErrorKind::bad_value);
    EXPECT_THROW(erase_person(*programme.store, programme.session("director"), "nobody", "asked", false),
                 AccessDenied);
    EXPECT_EQ(attempts(), 2);
}

TEST_F(StationErasure, CutOffAnywhereIsDoneOrNotAndTheNextStartFinishesIt) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    programme.store->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
    const std::string list = erasure_list_path(programme.store->station_id());
    programme.store.reset();
    const std::string kept = programme.path + ".kept";
    std::filesystem::copy_file(programme.path, kept);
    const auto erasing = [&] {
        const Store store = Store::open(programme.path, programme.clock.options());
        erase_person(store, programme.session("director"), programme.id("ann"), "asked for it", false);
    };
    const auto put_back = [&] {
        programme.store.reset();
        for (const char* ending : {"-wal", "-shm"}) std::filesystem::remove(programme.path + ending);
        std::filesystem::copy_file(kept, programme.path, std::filesystem::copy_options::overwrite_existing);
        std::filesystem::remove(list);
    };
    const CutOff whole = cut_off(0, erasing);
    ASSERT_EQ(whole.status, 0);
    for (const int point : cut_off_points(whole.changes, 6)) {
        put_back();
        if (!cut_off(point, erasing).killed) continue;
        programme.open();
        erase_listed(*programme.store);
        const bool listed = std::filesystem::exists(list);
        EXPECT_EQ(name_of("ann"), listed ? "Erased person" : "Ann Trainee") << point;
        EXPECT_EQ(attempts(), listed ? 1 : 2) << point;
        expect_sound(*programme.store);
    }
}

class SyncAndErase : public Sync {
  protected:
    /// An exchange that is cut off there. Returns whether it is complete.
    bool sync_until_attempts_are_sent() const {
        bool sent = false;
        SyncOptions options;
        options.progress = [&sent](double, const std::string& line) {
            sent = sent || line.rfind("sent attempts", 0) == 0;
        };
        options.stop = [&sent] { return sent; };
        return sync_with_server(*a.store, a.session("administrator"), server, options).complete;
    }
};

TEST_F(SyncAndErase, AProgrammeWithAServerErasesThere) {
    sync(a);
    EXPECT_EQ(
        error_kind([&] { erase_person(*a.store, a.session("director"), a.id("ann"), "asked for it", true); }),
        StoreErrorKind::conflict);
}

TEST_F(SyncAndErase, AFirstExchangeThatWasCutOffLeavesErasingToTheServer) {
    a.record("ann");
    EXPECT_FALSE(sync_until_attempts_are_sent());
    EXPECT_EQ(
        error_kind([&] { erase_person(*a.store, a.session("director"), a.id("ann"), "asked for it", true); }),
        StoreErrorKind::conflict);
    expect_sound(*a.store);
    erase_at_programme_server(server, a.id("ann"), false);
    EXPECT_EQ(sync(a).erased, 1);
    expect_sound(*a.store);
    expect_sound(server);
}

TEST_F(SyncAndErase, ARestoredBackupDoesNotBringBackWhomTheServerErased) {
    const KeysOfOneTest own_keys;
    a.record("ann");
    sync(a);
    const std::string backup = a.folder.filePath("older.db").toStdString();
    a.store->backup(a.session("administrator"), backup);
    erase_at_programme_server(server, a.id("ann"), false);
    EXPECT_EQ(sync(a).erased, 1);
    const auto name_of_ann = [&] {
        Query row(a.store->connection(), "SELECT display_name FROM person WHERE id = ?");
        row.bind(a.id("ann"));
        return row.next() ? row.text(0) : std::string();
    };
    const auto restore = [&] {
        a.store.reset();
        restore_store(
            backup, a.path, [&](const Store&) { return a.session("administrator"); }, a.clock.options());
        a.open();
        EXPECT_EQ(name_of_ann(), "Ann Trainee") << "the backup has her";
    };
    restore();
    EXPECT_EQ(erase_listed(*a.store), 1);
    EXPECT_EQ(name_of_ann(), "Erased person");
    expect_sound(*a.store);
    // Without its list the station gets it from the server again, though the exchange is refused.
    ASSERT_TRUE(QFile::remove(QString::fromStdString(erasure_list_path(a.store->station_id()))));
    restore();
    EXPECT_EQ(erase_listed(*a.store), 0);
    EXPECT_EQ(error_kind([&] { sync(a); }), StoreErrorKind::conflict) << "an older copy";
    EXPECT_EQ(name_of_ann(), "Erased person");
    expect_sound(*a.store);
    expect_sound(server);
}

TEST_F(SyncAndErase, AnAttemptThatAnOlderBackupGetsBackIsSoundWithoutItsRecording) {
    const KeysOfOneTest own_keys;
    sync(a);
    const std::string backup = a.folder.filePath("older.db").toStdString();
    a.store->backup(a.session("administrator"), backup);
    const std::string attempt = a.record("ann", true, 70, "A2", {Programme::slip()});
    EXPECT_FALSE(sync_until_attempts_are_sent());
    EXPECT_EQ(a.attempts().read_trace(a.session("ann"), attempt).samples.size(), 1000U);
    a.store.reset();
    restore_store(
        backup, a.path, [&](const Store&) { return a.session("administrator"); }, a.clock.options());
    a.open();
    EXPECT_EQ(sync(a).transferred(), 1);
    expect_sound(*a.store);
    EXPECT_EQ(error_kind([&] { a.attempts().read_trace(a.session("ann"), attempt); }),
              StoreErrorKind::not_found);
    // Nor does a later row about it say that it began here.
    a.attempts().void_attempt(a.session("educator"), attempt, "without its recording");
    EXPECT_EQ(sync(a).transferred(), 1);
    expect_sound(*a.store);
    EXPECT_NO_THROW(a.store->backup(a.session("administrator"), backup + ".next"));
}

TEST_F(SyncAndErase, TheRecordingOfACopyIsFetchedAfterThePersonItWasTakenFromIsErased) {
    const KeysOfOneTest own_keys;
    const std::string copy =
        a.attempts().reassign(a.session("educator"), a.record("ann"), a.id("ben"), "he was the one");
    sync(a);
    erase_at_programme_server(server, a.id("ann"), false);
    EXPECT_EQ(sync(a).erased, 1);
    const Station b;
    sync(b);
    const FetchedTrace fetched = fetch_trace(*b.store, b.sign_in("educator"), server, copy);
    EXPECT_GT(fetched.chunks, 0);
    EXPECT_EQ(fetched.signed_by, Audit(*a.store).signing_key());
    expect_sound(*a.store);
    expect_sound(*b.store);
    expect_sound(server);
}

}  // namespace
}  // namespace fulcrum::database::test
