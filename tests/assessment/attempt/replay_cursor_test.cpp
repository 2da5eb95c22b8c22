// SPDX-License-Identifier: Apache-2.0
// A replay continues from any of its key frames bit for bit, in another engine.
#include "assessment/attempt/replay_cursor.h"

#include <gtest/gtest.h>

#include <random>

#include "assessment/attempt/memory_sink.h"
#include "assessment/operators/operator.h"
#include "sim_core/numerics/state_archive.h"
#include "tests/assessment/attempt/expert_record.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

struct Frame {
    std::uint32_t tick = 0;
    std::vector<std::uint8_t> bytes;
};

std::vector<std::uint8_t> kept(ReplayCursor& cursor) {
    std::vector<std::uint8_t> bytes;
    StateArchive archive(bytes);
    cursor.transfer(archive);
    return bytes;
}

void put(ReplayCursor& cursor, const std::vector<std::uint8_t>& bytes) {
    StateArchive archive(bytes.data(), bytes.size());
    cursor.transfer(archive);
}

struct Performed {
    TaskDefinition task;
    Scene scene;
    std::uint64_t seed = 2001;
    AttemptRecord record;
};

Performed perform(const std::string& id, double longest_s) {
    Performed made;
    made.task = load_task(test::source_path("assets/tasks/" + id + ".json"));
    made.scene = load_scene(test::source_path("assets/scenes/" + made.task.scene));
    AttemptEngine engine(made.scene, made.task, made.seed);
    const auto rig = make_operator(OperatorLevel::expert, made.task, made.scene, made.seed);
    MemorySink sink;
    run_headless(engine, *rig, sink, [longest_s](double now) { return now < longest_s; });
    made.record = std::move(sink.record);
    return made;
}

/// Events from a tick on.
std::vector<Event> since(const std::vector<Event>& events, std::uint32_t tick) {
    std::vector<Event> later;
    for (const Event& event : events) {
        if (event.tick > tick) later.push_back(event);
    }
    return later;
}

class KeyFrames : public ::testing::TestWithParam<std::string> {};

TEST_P(KeyFrames, GiveTheSameSamplesEventsAndHashAsFromTheBeginning) {
    const test::ExpertRecord& made = test::expert_record(GetParam());
    std::vector<Frame> frames;
    std::vector<Event> events;
    {
        AttemptEngine engine(made.scene, made.task, test::expert_seed);
        ReplayCursor cursor(engine, made.record);
        std::mt19937 random(7);
        const auto last = static_cast<std::uint32_t>(made.record.inputs.size());
        std::uniform_int_distribution<std::uint32_t> gap(1, std::max(2U, last / 8));
        while (!cursor.at_end()) {
            frames.push_back({cursor.tick(), kept(cursor)});
            cursor.run_to(cursor.tick() + gap(random));
        }
        cursor.run_to_end();
        const ReplayOutcome whole = cursor.take_outcome();
        ASSERT_TRUE(whole.identical);
        ASSERT_EQ(whole.state_hash, made.outcome.state_hash);
        events = whole.events;
    }
    ASSERT_GE(frames.size(), 6U);

    // Another engine, from one place to another, back and forth.
    AttemptEngine engine(made.scene, made.task, test::expert_seed);
    ReplayCursor cursor(engine, made.record);
    std::mt19937 random(11);
    for (int round = 0; round < 12; ++round) {
        const Frame& frame = frames[static_cast<std::size_t>(random() % frames.size())];
        put(cursor, frame.bytes);
        EXPECT_EQ(cursor.tick(), frame.tick);
        cursor.run_to(frame.tick + 1 + static_cast<std::uint32_t>(random() % 1500));
        EXPECT_TRUE(cursor.outcome().identical)
            << "from " << frame.tick << ", differs at " << cursor.outcome().first_divergence_s << " s";
    }
    const Frame& middle = frames[frames.size() / 2];
    put(cursor, middle.bytes);
    EXPECT_EQ(kept(cursor).size(), middle.bytes.size());
    cursor.run_to_end();
    const ReplayOutcome rest = cursor.take_outcome();
    EXPECT_TRUE(rest.identical) << rest.first_divergence_s;
    EXPECT_EQ(rest.state_hash, made.outcome.state_hash);
    const std::vector<Event> expected = since(events, middle.tick), found = since(rest.events, middle.tick);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].tick, expected[i].tick);
        EXPECT_EQ(found[i].kind, expected[i].kind);
        EXPECT_EQ(found[i].value, expected[i].value);
    }
}

INSTANTIATE_TEST_SUITE_P(Tasks, KeyFrames, ::testing::ValuesIn(test::task_ids()),
                         [](const auto& instance) { return instance.param; });

TEST(KeyFrame, OfAnotherSceneOrCutShortIsRefused) {
    const Performed targets = perform("A2", 2), rings = perform("A3", 2);
    AttemptEngine engine(targets.scene, targets.task, targets.seed);
    ReplayCursor cursor(engine, targets.record);
    cursor.run_to(1000);
    const std::vector<std::uint8_t> bytes = kept(cursor);

    AttemptEngine other(rings.scene, rings.task, rings.seed);
    ReplayCursor elsewhere(other, rings.record);
    EXPECT_THROW(put(elsewhere, bytes), StateArchiveError);

    std::vector<std::uint8_t> cut(bytes.begin(), bytes.end() - 1);
    EXPECT_THROW(put(cursor, cut), StateArchiveError);
    std::vector<std::uint8_t> longer = bytes;
    longer.push_back(0);
    EXPECT_THROW(put(cursor, longer), StateArchiveError);
    put(cursor, bytes);
    EXPECT_EQ(cursor.tick(), 1000U);
}

}  // namespace
}  // namespace fulcrum
