// SPDX-License-Identifier: GPL-3.0-or-later
// A replay opened again has its key frames at once; frames that are damaged, or lead away from the record,
// are thrown away and made again, and the picture is the same.
#include "app/services/replay_source.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "app/live/frame_store.h"
#include "database/scoring/loaded_task.h"
#include "tests/assessment/attempt/expert_record.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

class KeptReplay : public ::testing::Test {
  protected:
    KeptReplay() : made(test::expert_record("A2")) {
        const AttemptRecord& record = made.record;
        trace = std::make_shared<const database::Trace>(
            database::Trace{record.samples, record.inputs, record.steps, record.events});
        request.loaded = load_task_and_scene("A2");
        request.seed = test::expert_seed;
        request.attempt_id = "attempt";
        request.trace = trace;
        request.devices = record.devices;
        request.keeping = {(folder / "a.db.frames").string(), "attempt.frames", frames_belong_to("A2")};
    }
    std::filesystem::path file() const {
        return std::filesystem::path(request.keeping.folder) / request.keeping.name;
    }
    template <typename Condition>
    static bool wait_until(const Condition& condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return true;
    }
    /// The end of the attempt is shown.
    static WorldSnapshot end_of(ui::ReplaySource& replay) {
        replay.seek(replay.duration_s());
        EXPECT_TRUE(
            wait_until([&] { return replay.update() && replay.shown_s() >= replay.duration_s() - 1e-6; }));
        EXPECT_FALSE(replay.differs_from_s());
        return replay.snapshot();
    }
    static void expect_same(const WorldSnapshot& found, const WorldSnapshot& expected) {
        ASSERT_EQ(found.targets.size(), expected.targets.size());
        for (std::size_t i = 0; i < found.targets.size(); ++i)
            EXPECT_EQ(found.targets[i].centre, expected.targets[i].centre);
        for (int hand = 0; hand < hand_count; ++hand)
            EXPECT_EQ(found.tools[hand].tip, expected.tools[hand].tip);
        EXPECT_EQ(found.tick, expected.tick);
    }
    /// Opened, prepared, and closed when its frames are in the file.
    WorldSnapshot prepare() {
        const auto replay = make_replay_source(request);
        const WorldSnapshot end = end_of(*replay);
        EXPECT_TRUE(wait_until([&] { return FrameFile::open(request.keeping) != nullptr; }));
        return end;
    }

    const test::ExpertRecord& made;
    const test::OwnFolder folder;
    std::shared_ptr<const database::Trace> trace;
    ReplayRequest request;
};

TEST_F(KeptReplay, OpenedAgainIsPreparedAtOnceAndShowsTheSame) {
    const WorldSnapshot end = prepare();
    struct stat before {
    }, after{};
    ASSERT_EQ(::stat(file().c_str(), &before), 0);
    const auto again = make_replay_source(request);
    ASSERT_TRUE(wait_until([&] { return again->update(); }));
    expect_same(end_of(*again), end);
    EXPECT_EQ(again->ready(), 1);
    const auto moment = again->moment(0.5 * again->duration_s());
    ASSERT_NE(moment, nullptr) << "practice can begin anywhere";
    again->seek(0.25 * again->duration_s());
    EXPECT_TRUE(wait_until([&] { return again->update() && again->shown_s() < 0.26 * again->duration_s(); }));
    EXPECT_FALSE(again->differs_from_s());
    ASSERT_EQ(::stat(file().c_str(), &after), 0);
    EXPECT_EQ(after.st_ino, before.st_ino) << "no pass was made: it would have written a new file";
}

TEST_F(KeptReplay, AlteredFramesAreMadeAgain) {
    const WorldSnapshot end = prepare();
    {
        std::fstream altered(file(), std::ios::in | std::ios::out | std::ios::binary);
        altered.seekp(-3, std::ios::end);
        altered.put('\x55').put('\x55').put('\x55');
    }
    ASSERT_NE(FrameFile::open(request.keeping), nullptr) << "its table is right";
    const auto again = make_replay_source(request);
    expect_same(end_of(*again), end);
    EXPECT_TRUE(wait_until([&] {
        const auto opened = FrameFile::open(request.keeping);
        return opened != nullptr && !opened->packed(opened->count() - 1).empty();
    })) << "and kept again";
}

TEST_F(KeptReplay, FramesThatLeadAwayFromTheRecordAreMadeAgain) {
    const WorldSnapshot end = prepare();
    const auto right = FrameFile::open(request.keeping);
    {
        // Whole and with right checksums, but of another seed: its spheres are elsewhere.
        AttemptEngine engine(made.scene, made.task, test::expert_seed + 1);
        ReplayCursor cursor(engine, made.record);
        FrameStore wrong;
        while (!cursor.at_end()) {
            wrong.add(cursor);
            cursor.run_to(cursor.tick() + 5000);
        }
        FrameFileWriter writer(request.keeping, wrong.frames(), right->last_tick());
        while (writer.write_more()) {
        }
    }
    const auto again = make_replay_source(request);
    expect_same(end_of(*again), end);
    EXPECT_TRUE(wait_until([&] {
        const auto opened = FrameFile::open(request.keeping);
        return opened != nullptr && opened->bytes() == std::filesystem::file_size(file()) &&
               opened->packed(0) == right->packed(0);
    }));
}

TEST_F(KeptReplay, OfAPassThatDiffersFromTheRecordNothingIsKept) {
    request.seed = test::expert_seed + 1;
    const auto replay = make_replay_source(request);
    ASSERT_TRUE(wait_until([&] { return replay->ready() >= 1; }));
    EXPECT_TRUE(replay->differs_from_s());
    for (int i = 1; i <= 5; ++i) {  // more rounds of its thread than a file takes
        replay->seek(i);
        EXPECT_TRUE(wait_until([&] { return replay->update(); }));
    }
    EXPECT_FALSE(std::filesystem::exists(request.keeping.folder));
}

}  // namespace
}  // namespace fulcrum::app
