// SPDX-License-Identifier: GPL-3.0-or-later
// Key frames of stored attempts that have none are made in advance, of those only, and a replay that is
// opened before they are complete continues from what there is.
#include "app/live/frames_in_advance.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "app/services/application.h"
#include "database/records/recorder.h"
#include "database/rows/connection.h"
#include "database/store/kept_frames.h"
#include "tests/app/live/kept_station.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

template <typename Condition>
bool becomes_true(const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

/// As a program leaves it that is killed after so many ticks.
std::string cut_off(const std::string& path, const database::Session& session, database::AttemptMeta meta,
                    const std::string& task, std::size_t cut_off_at = 6000) {
    const AttemptRecord& record = test::expert_record(task).record;
    meta.force_devices = record.devices;
    database::Recorder recorder(path, session, meta);
    std::size_t step = 0;
    for (std::size_t i = 0; i < cut_off_at; ++i) {
        recorder.append(record.inputs[i]);
        recorder.append(record.samples[i]);
        for (; record.steps[step].last_tick <= record.samples[i].tick; ++step)
            recorder.append(record.steps[step]);
    }
    recorder.append(Event{record.samples[cut_off_at - 1].tick, EventKind::phase_begin});
    recorder.flush();
    return recorder.attempt_id();
}

class AdvanceFrames : public ::testing::Test {
  protected:
    std::string cut_off_here(const std::string& task = "A2", std::size_t ticks = 6000) const {
        const LoadedTask loaded = load_task_and_scene(task);
        std::string id = cut_off(station.store.path(), station.session, station.meta(loaded), task, ticks);
        (void)database::Store::open(station.store.path());  // which lists it as interrupted
        return id;
    }
    std::string file(const std::string& attempt) const {
        return database::kept_frames_folder(station.store) + '/' + database::kept_frames_name(attempt);
    }
    void prepare(std::set<std::string> except = {}) {
        frames.begin(station.store.path(), station.session, std::move(except));
        EXPECT_TRUE(becomes_true([&] { return !frames.at_work(); }));
    }
    void expect_right(const std::string& attempt, const std::string& task) const {
        AttemptRecord record = station.record(attempt);
        record.devices = test::expert_record(task).record.devices;
        const auto frames_file = FrameFile::open(station.keeping(attempt));
        ASSERT_NE(frames_file, nullptr);
        expect_frames_bit_for_bit(station.keeping(attempt), load_task_and_scene(task), test::expert_seed,
                                  record);
    }
    ino_t inode(const std::string& attempt) const {
        struct stat status {};
        return ::stat(file(attempt).c_str(), &status) == 0 ? status.st_ino : 0;
    }

    const test::OwnFolder folder;
    KeptStation station{(folder / "station.db").string()};
    FramesInAdvance frames;
};

TEST_F(AdvanceFrames, OfAttemptsThatWereCutOffAreMadeAndContinueBitForBit) {
    const std::string first = cut_off_here("A2"), second = cut_off_here("B3");
    EXPECT_EQ(database::Attempts(station.store).read(station.session, first).state,
              AttemptState::interrupted);
    prepare();
    expect_right(first, "A2");
    expect_right(second, "B3");
}

TEST_F(AdvanceFrames, AreMadeOnceAndNotForOpenReplays) {
    const std::string first = cut_off_here(), second = cut_off_here();
    prepare({second});
    const ino_t made = inode(first);
    EXPECT_NE(made, 0U);
    EXPECT_EQ(inode(second), 0U);
    prepare();
    EXPECT_NE(inode(second), 0U) << "its replay is closed";
    EXPECT_EQ(inode(first), made);
    FramesInAdvance another;  // the program starts again
    another.begin(station.store.path(), station.session);
    EXPECT_TRUE(becomes_true([&] { return !another.at_work(); }));
    EXPECT_EQ(inode(first), made);
}

TEST_F(AdvanceFrames, ThatWereThrownAwayAreMadeWhenTheProgramStartsAgain) {
    const std::string one = cut_off_here();
    prepare();
    database::remove_all_kept_frames(station.store.path());
    prepare();
    EXPECT_EQ(inode(one), 0U) << "looked at once";
    EXPECT_TRUE(frames.take(one).empty());
    prepare();
    EXPECT_NE(inode(one), 0U) << "its replay was opened, and closed before it was ready";
    database::remove_all_kept_frames(station.store.path());
    FramesInAdvance another;
    another.begin(station.store.path(), station.session);
    EXPECT_TRUE(becomes_true([&] { return !another.at_work(); }));
    EXPECT_NE(inode(one), 0U);
}

TEST_F(AdvanceFrames, StopInTheMiddleAndAreGivenToTheReplayThatIsOpened) {
    const std::string one = cut_off_here("B3", 90000);
    std::vector<PackedFrame> taken;
    for (int wait_ms = 5; taken.empty() && inode(one) == 0; wait_ms *= 2) {
        frames.begin(station.store.path(), station.session);
        std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));  // of its work, before it is stopped
        taken = frames.take(one);
        EXPECT_TRUE(becomes_true([&] { return !frames.at_work(); }));
    }
    ASSERT_FALSE(taken.empty()) << "made before it could be taken";
    FrameStore given;
    given.restore(taken);
    EXPECT_EQ(given.count(), taken.size());
    EXPECT_TRUE(frames.take(one).empty()) << "nothing is at work";
}

TEST_F(AdvanceFrames, OfADamagedRecordAreLeftOutAndTheOthersMade) {
    const std::string first = cut_off_here(), second = cut_off_here();
    database::Connection& connection = station.store.connection();
    connection.execute("DROP TRIGGER trace_chunk_is_fixed");
    database::Query(connection, "UPDATE trace_chunk SET data = x'00' WHERE stream = 0 AND attempt_id = ?")
        .bind(second)
        .run();
    prepare();
    EXPECT_EQ(inode(second), 0U);
    EXPECT_NE(inode(first), 0U);
}

TEST_F(AdvanceFrames, AreNotMadeWhereTheSessionMayNotReadTheAttempt) {
    database::test::Programme programme;
    const database::Session ann = programme.session("ann"), ben = programme.session("ben");
    database::AttemptMeta meta = station.meta(load_task_and_scene("A2"));
    meta.person_id = ann.person_id();
    meta.device_class = ui::window_device;
    const std::string path = programme.store->path();
    const std::string id = cut_off(path, ann, meta, "A2");
    (void)database::Store::open(path);
    for (const database::Session* const who : {&ben, &ann}) {
        frames.begin(path, *who);
        EXPECT_TRUE(becomes_true([&] { return !frames.at_work(); }));
        EXPECT_EQ(std::filesystem::exists(database::kept_frames_folder(*programme.store) + '/' +
                                          database::kept_frames_name(id)),
                  who == &ann);
    }
}

/// In the program: signed in after the other was killed, a minute later the replay is ready when it is
/// opened.
TEST(PreparedReplays, AreReadyWhenTheyAreOpened) {
    database::test::Programme programme;
    const database::Session ann = programme.session("ann");
    const std::string path = programme.store->path();
    programme.store.reset();
    database::AttemptMeta meta = attempt_meta(load_task_and_scene("A2"), test::expert_seed,
                                              AttemptMode::practice, ui::window_device, "mouse", {});
    meta.person_id = ann.person_id();
    const std::string id = cut_off(path, ann, meta, "A2");
    const auto services = make_services(programme.folder.path().toStdString());
    services->open_store(false);
    const database::Attempts attempts(*services->store());
    const std::string file =
        database::kept_frames_folder(*services->store()) + '/' + database::kept_frames_name(id);
    const auto open = [&] {
        return services->open_replay(ann, attempts.read(ann, id),
                                     std::make_shared<const database::Trace>(attempts.read_trace(ann, id)));
    };
    services->prepare_replays(ann);
    EXPECT_TRUE(becomes_true([&] { return std::filesystem::exists(file); }));
    struct stat made {
    }, after{};
    ASSERT_EQ(::stat(file.c_str(), &made), 0);
    const auto replay = open();
    EXPECT_TRUE(becomes_true([&] { return replay->update(); })) << "its beginning";
    EXPECT_TRUE(becomes_true([&] { return replay->ready() == 1; }));
    EXPECT_FALSE(replay->differs_from_s());
    ASSERT_EQ(::stat(file.c_str(), &after), 0);
    EXPECT_EQ(made.st_ino, after.st_ino) << "not made again";
}

}  // namespace
}  // namespace fulcrum::app
