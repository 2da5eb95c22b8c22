// SPDX-License-Identifier: GPL-3.0-or-later
// Key frames that are made during an attempt: from each of them the replay continues bit for bit, they are in
// their file when the attempt is over, and whatever goes wrong leaves no frame and no trouble.
#include "app/live/frame_follower.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "app/live/live_attempt.h"
#include "app/live/performance.h"
#include "app/services/application.h"
#include "app/services/replay_source.h"
#include "assessment/operators/operator.h"
#include "database/records/attempts.h"
#include "database/store/kept_frames.h"
#include "tests/app/live/kept_station.h"
#include "tests/assessment/attempt/expert_record.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

class FollowedAttempt : public ::testing::Test {
  protected:
    FollowedAttempt() {
        keeping = {(folder / "a.db.frames").string(), "attempt.frames", frames_belong_to("A2")};
    }
    ReplayStart start() const { return {load_task_and_scene("A2"), test::expert_seed}; }
    /// In pieces, as the recorder does; the steps of ticks that come first.
    static void feed(FrameFollower& follower, const AttemptRecord& record, std::size_t from,
                     std::size_t until) {
        std::size_t step = 0;
        while (step < record.steps.size() && record.steps[step].last_tick <= from) ++step;
        for (std::size_t i = from; i < until; ++i) {
            follower.append(record.inputs[i], record.samples[i]);
            for (; step < record.steps.size() && record.steps[step].last_tick <= record.samples[i].tick;
                 ++step)
                follower.append(record.steps[step]);
            if (i % 20 == 0) follower.hand_on();
        }
        follower.hand_on();
    }
    bool kept() const { return std::filesystem::exists(keeping.folder); }

    const test::ExpertRecord& made = test::expert_record("A2");
    const test::OwnFolder folder;
    FrameKeeping keeping;
};

TEST_F(FollowedAttempt, FramesAreInTheirFileWhenItIsOverAndContinueBitForBit) {
    FrameFollower follower;
    follower.begin(start(), made.record.devices);
    feed(follower, made.record, 0, made.record.inputs.size());
    follower.complete("attempt", keeping);
    ASSERT_TRUE(follower.finish_here());
    const AttemptRecord& record = made.record;
    expect_frames_bit_for_bit(keeping, load_task_and_scene("A2"), test::expert_seed, record);
    EXPECT_TRUE(follower.take("attempt").empty()) << "they are in the file";
}

TEST_F(FollowedAttempt, AReplayThatIsOpenedBeforeTheEndWasReachedContinuesFromItsFrames) {
    const AttemptRecord& record = made.record;
    const auto follower = std::make_shared<FrameFollower>();
    follower->begin(start(), record.devices);
    EXPECT_TRUE(follower->take("attempt").empty()) << "it runs";
    feed(*follower, record, 0, record.inputs.size());
    follower->complete("attempt", keeping);
    EXPECT_TRUE(follower->take("another").empty());
    ReplayRequest request;
    request.start = start();
    request.attempt_id = "attempt";
    request.trace = std::make_shared<const database::Trace>(
        database::Trace{record.samples, record.inputs, record.steps, record.events});
    request.devices = record.devices;
    request.keeping = keeping;
    request.follower = follower;
    const auto replay = make_replay_source(request);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while ((replay->ready() < 1 || !kept()) && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_FALSE(replay->differs_from_s());
    while (FrameFile::open(keeping) == nullptr && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    expect_frames_bit_for_bit(keeping, request.start.loaded, test::expert_seed, record);
}

TEST_F(FollowedAttempt, OfARecordThatTheSimulationDoesNotRepeatNothingIsKept) {
    AttemptRecord altered = made.record;
    altered.samples[3000].hand[0].force[1] += 1;
    FrameFollower follower;
    follower.begin(start(), altered.devices);
    feed(follower, altered, 0, altered.inputs.size());
    follower.complete("attempt", keeping);
    EXPECT_FALSE(follower.finish_here());
    EXPECT_FALSE(kept());
    EXPECT_TRUE(follower.take("attempt").empty());
}

TEST_F(FollowedAttempt, WhereTooMuchWaitsItGivesUp) {
    FrameFollower follower(1U << 20U);  // about two thousand ticks
    follower.begin(start(), made.record.devices);
    for (std::size_t i = 0; i < 4000; ++i) follower.append(made.record.inputs[i], made.record.samples[i]);
    follower.hand_on();
    follower.complete("attempt", keeping);
    EXPECT_FALSE(follower.finish_here());
    EXPECT_FALSE(kept());
}

TEST_F(FollowedAttempt, ClosingTheProgramDoesNotWaitForTheRest) {
    const auto begin = std::chrono::steady_clock::now();
    {
        FrameFollower follower;
        follower.begin(start(), made.record.devices);
        feed(follower, made.record, 0, made.record.inputs.size() / 2);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
    EXPECT_FALSE(kept());
}

TEST_F(FollowedAttempt, OnTheClockItsReplayIsPreparedWhenItEnds) {
    const KeptStation station((folder / "station.db").string());
    LiveRequest request;
    request.loaded = load_task_and_scene("A2");
    request.seed = test::expert_seed;
    request.assessed = false;
    request.rig =
        make_operator(OperatorLevel::expert, request.loaded.task, request.loaded.scene, test::expert_seed);
    request.store_path = station.store.path();
    request.session = station.session;
    request.meta = station.meta(request.loaded);
    const auto follower = request.follower = std::make_shared<FrameFollower>();
    std::string attempt;
    {
        LiveAttempt live(std::move(request));
        live.start();
        while (live.health().ticks < 1500 && live.phase() != ui::AttemptPhase::failed)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        live.interrupt();
        live.wait();
        live.rethrow();
        attempt = live.outcome()->attempt_id;
    }
    ASSERT_TRUE(follower->finish_here());
    AttemptRecord record = station.record(attempt);
    record.devices = database::Attempts(station.store).read(station.session, attempt).meta.force_devices;
    expect_frames_bit_for_bit(station.keeping(attempt), load_task_and_scene("A2"), test::expert_seed, record);
}

/// An attempt in the program that begins at this goal: its replay is opened as soon as it is over.
void expect_prepared(const std::string& task, int goal) {
    database::test::Programme programme;
    const database::Session ann = programme.session("ann");
    programme.store.reset();
    const auto services = make_services(programme.folder.path().toStdString());
    services->open_store(false);
    const LoadedTask loaded = load_task_and_scene(task);
    ui::AttemptRequest request{
        ann,
        task,
        false,
        test::expert_seed,
        make_operator(OperatorLevel::expert, loaded.task, loaded.scene, test::expert_seed),
        ui::window_device,
        "mouse and keyboard",
        false,
        nullptr,
        goal,
        false,
        {}};
    std::string id;
    {
        const auto attempt = services->start_attempt(request);
        attempt->start();
        while (attempt->phase() == ui::AttemptPhase::starting)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const std::uint32_t first = attempt->health().ticks;
        while (attempt->health().ticks < first + 1500 && attempt->phase() != ui::AttemptPhase::failed)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        attempt->abandon();
        while (!attempt->outcome() && attempt->phase() != ui::AttemptPhase::failed)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ASSERT_TRUE(attempt->outcome());
        id = attempt->outcome()->attempt_id;
    }
    const database::Attempts attempts(*services->store());
    const std::string file =
        database::kept_frames_folder(*services->store()) + '/' + database::kept_frames_name(id);
    ino_t inode = 0;
    for (const bool again : {false, true}) {
        const auto replay =
            services->open_replay(ann, attempts.read(ann, id),
                                  std::make_shared<const database::Trace>(attempts.read_trace(ann, id)));
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (replay->ready() < 1 && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        EXPECT_EQ(replay->ready(), 1) << again;
        EXPECT_FALSE(replay->differs_from_s());
        struct stat status {};
        while (::stat(file.c_str(), &status) != 0 && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        EXPECT_TRUE(!again || status.st_ino == inode) << "the file was good, and none had to be made";
        inode = status.st_ino;
    }
}

TEST_F(FollowedAttempt, ItsReplayIsOpenedAsSoonAsItIsOverAndIsPrepared) {
    expect_prepared("A2", 0);
}

TEST_F(FollowedAttempt, OneThatBeginsAtALaterGoalToo) {
    expect_prepared("A2", 1);
}

TEST_F(FollowedAttempt, PerformedWithoutAWindowItsReplayIsPreparedToo) {
    const KeptStation station((folder / "station.db").string());
    PerformRequest request;
    request.loaded = load_task_and_scene("B3");
    request.operator_level = OperatorLevel::expert;
    request.seed = test::expert_seed;
    request.keep_going = [](double now) { return now < 40; };
    FrameStore frames(1U << 20U);
    request.frames = &frames;
    database::Recorder recorder(station.store.path(), station.session, station.meta(request.loaded));
    const Performed performed = perform(request, &recorder, {});
    const FrameKeeping where = station.keeping(recorder.attempt_id());
    FrameFileWriter writer(where, frames.frames(), performed.record.inputs.back().tick);
    while (writer.write_more()) {
    }
    EXPECT_TRUE(writer.complete());
    EXPECT_GT(frames.count(), 1U);
    AttemptRecord record = station.record(recorder.attempt_id());
    record.devices = performed.record.devices;
    expect_frames_bit_for_bit(where, request.loaded, test::expert_seed, record);
}

}  // namespace
}  // namespace fulcrum::app
