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
#include "assessment/attempt/engine_state.h"
#include "assessment/attempt/memory_sink.h"
#include "assessment/operators/operator.h"
#include "database/rows/packed_ticks.h"
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
        request.start.loaded = load_task_and_scene("A2");
        request.start.seed = test::expert_seed;
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
    /// What a cursor without key frames makes of the request.
    void use_reference() {
        const database::Trace& all = *request.trace;
        const AttemptRecord record{all.inputs, all.samples, all.steps, all.events, request.devices};
        AttemptEngine engine(request.start.loaded.scene, request.start.loaded.task, request.start.seed);
        ReplayCursor cursor(engine, record);
        cursor.run_to(all.inputs.back().tick);
        right_end = engine.world().snapshot();
    }
    /// The end of the attempt is shown, and is the right one.
    void expect_end(ui::ReplaySource& replay) const {
        replay.seek(replay.duration_s());
        EXPECT_TRUE(wait_until([&] { return replay.update() && replay.snapshot().step == right_end.step; }));
        EXPECT_FALSE(replay.differs_from_s());
        expect_same(replay.snapshot(), right_end);
    }
    static void expect_same(const WorldSnapshot& found, const WorldSnapshot& expected) {
        EXPECT_EQ(found.bowel.nodes, expected.bowel.nodes);
        EXPECT_EQ(found.step, expected.step);
        ASSERT_EQ(found.targets.size(), expected.targets.size());
        for (std::size_t i = 0; i < found.targets.size(); ++i)
            EXPECT_EQ(found.targets[i].centre, expected.targets[i].centre);
    }
    /// Opened, prepared, and closed when its frames are in the file.
    void prepare() {
        use_reference();
        const auto replay = make_replay_source(request);
        expect_end(*replay);
        EXPECT_TRUE(wait_until([&] { return FrameFile::open(request.keeping) != nullptr; }));
    }

    void write(const std::vector<PackedFrame>& frames, std::uint32_t last) const {
        FrameFileWriter writer(request.keeping, frames, last);
        while (writer.write_more()) {
        }
    }
    /// The replay shows the right end in spite of the file that is there, and puts a new one in its place.
    void expect_made_again() const {
        struct stat before {
        }, after{};
        ASSERT_EQ(::stat(file().c_str(), &before), 0);
        const auto wrong = FrameFile::open(request.keeping);  // its inode is not given to another file
        ASSERT_NE(wrong, nullptr);
        const auto again = make_replay_source(request);
        ASSERT_TRUE(wait_until([&] { return again->update(); }));
        EXPECT_TRUE(wait_until([&] {
            again->seek(again->duration_s());
            return ::stat(file().c_str(), &after) == 0 && after.st_ino != before.st_ino;
        })) << "kept again";
        expect_end(*again);
    }

    const test::ExpertRecord& made;
    const test::OwnFolder folder;
    std::shared_ptr<const database::Trace> trace;
    ReplayRequest request;
    WorldSnapshot right_end;
};

TEST_F(KeptReplay, OpenedAgainIsPreparedAtOnceAndShowsTheSame) {
    prepare();
    struct stat before {
    }, after{};
    ASSERT_EQ(::stat(file().c_str(), &before), 0);
    const auto again = make_replay_source(request);
    ASSERT_TRUE(wait_until([&] { return again->update(); }));
    expect_end(*again);
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
    prepare();
    {
        std::fstream altered(file(), std::ios::in | std::ios::out | std::ios::binary);
        altered.seekp(-3, std::ios::end);
        altered.put('\x55').put('\x55').put('\x55');
    }
    expect_made_again();
}

TEST_F(KeptReplay, FramesOfOtherMomentsAreMadeAgain) {
    prepare();
    const std::uint32_t last = trace->inputs.back().tick;
    {
        // Whole and with right checksums, but each one is said to be 100 ticks later.
        AttemptEngine engine(made.scene, made.task, test::expert_seed);
        ReplayCursor cursor(engine, made.record);
        FrameStore frames;
        for (; !cursor.at_end(); cursor.run_to(cursor.tick() + 5000)) frames.add(cursor);
        std::vector<PackedFrame> wrong = frames.frames();
        for (PackedFrame& frame : wrong) frame.tick += 100;
        write(wrong, last);
    }
    expect_made_again();
}

/// The beginning of B3, by an operator of this level.
AttemptRecord short_record(const LoadedTask& loaded, OperatorLevel level) {
    AttemptEngine engine(loaded.scene, loaded.task, test::expert_seed);
    const auto rig = make_operator(level, loaded.task, loaded.scene, test::expert_seed);
    MemorySink sink;
    run_headless(engine, *rig, sink, [](double now) { return now < 1.2; });
    return std::move(sink.record);
}

TEST_F(KeptReplay, OfAPackedRecordIsThatOfTheRecordItself) {
    use_reference();
    const auto ticks = std::make_shared<database::PackedTicks>();
    database::TraceCodec codec;
    constexpr std::size_t chunk = 700;
    for (std::size_t first = 0; first < trace->samples.size(); first += chunk) {
        const std::size_t count = std::min(chunk, trace->samples.size() - first);
        const RigSample* inputs = trace->inputs.data() + first;
        database::TraceChunk packed = codec.encode(inputs, count);
        ASSERT_TRUE(
            ticks->add(std::move(packed), codec.encode(trace->samples.data() + first, count, inputs)));
    }
    request.trace =
        std::make_shared<const database::Trace>(database::Trace{{}, {}, trace->steps, trace->events, ticks});
    const auto replay = make_replay_source(request);
    EXPECT_EQ(replay->duration_s(), trace->samples.back().tick * 1e-3);
    expect_end(*replay);
    EXPECT_NE(replay->moment(replay->duration_s() / 2), nullptr);
}

TEST_F(KeptReplay, FramesThatLeadAwayFromTheRecordAreMadeAgain) {
    request.start.loaded = load_task_and_scene("B3");
    const AttemptRecord record = short_record(request.start.loaded, OperatorLevel::expert);
    request.trace = std::make_shared<const database::Trace>(
        database::Trace{record.samples, record.inputs, record.steps, record.events});
    prepare();
    {
        // Of this task, seed and length, but of other hands.
        const AttemptRecord other = short_record(request.start.loaded, OperatorLevel::novice);
        AttemptEngine engine(request.start.loaded.scene, request.start.loaded.task, test::expert_seed);
        ReplayCursor cursor(engine, other);
        FrameStore frames;
        for (; !cursor.at_end(); cursor.run_to(cursor.tick() + 400)) frames.add(cursor);
        write(frames.frames(), record.inputs.back().tick);
    }
    expect_made_again();
}

TEST_F(KeptReplay, OfAStateThatCannotBeReadShowsTheRecordedPoses) {
    AttemptEngine engine(request.start.loaded.scene, request.start.loaded.task, request.start.seed);
    request.start.state = engine_state(engine);
    request.start.state.push_back(0);
    for (const bool said_to_be_readable : {true, false}) {
        request.start_is_readable = said_to_be_readable;
        const auto replay = make_replay_source(request);
        ASSERT_TRUE(wait_until([&] { return replay->update(); }));
        EXPECT_TRUE(replay->differs_from_s());
        for (const std::uint32_t second : {1U, 2U}) {
            replay->seek(second);
            ASSERT_TRUE(replay->update());
            EXPECT_EQ(replay->shown_s(), second);
            const TickSample& sample = trace->samples.at(1000 * second - 1);
            ASSERT_EQ(sample.tick, 1000 * second);
            for (int hand = 0; hand < hand_count; ++hand) {
                for (int i = 0; i < 3; ++i)
                    EXPECT_EQ(replay->snapshot().tools[hand].tip[i],
                              sample.hand[hand].tip[i] * sample_length_unit);
            }
        }
        EXPECT_EQ(replay->moment(1), nullptr);
    }
}

TEST_F(KeptReplay, OfAPassThatDiffersFromTheRecordNothingIsKept) {
    request.start.seed = test::expert_seed + 1;
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
