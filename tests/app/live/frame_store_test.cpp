// SPDX-License-Identifier: GPL-3.0-or-later
// Key frames of a replay: differences give back every byte, seeks continue bit for bit from every frame, and
// the store keeps within its bound.
#include "app/live/frame_store.h"

#include <gtest/gtest.h>

#include <random>

#include "app/live/state_difference.h"
#include "sim_core/numerics/state_archive.h"
#include "tests/assessment/attempt/expert_record.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

StateImage random_image(std::mt19937& random) {
    StateImage image;
    const std::size_t sections = 1 + random() % 6;
    for (std::size_t s = 0; s < sections; ++s) {
        if (s > 0) image.starts.push_back(static_cast<std::uint32_t>(image.bytes.size()));
        const std::size_t size = random() % 3 == 0 ? 0 : random() % 700;
        for (std::size_t i = 0; i < size; ++i)
            image.bytes.push_back(static_cast<std::uint8_t>(random() % 4 == 0 ? random() : i));
    }
    return image;
}

void expect_same(const StateImage& found, const StateImage& expected) {
    EXPECT_EQ(found.bytes, expected.bytes);
    EXPECT_EQ(found.starts, expected.starts);
}

StateImage applied(StateImage from, const std::vector<std::uint8_t>& difference) {
    StateImage spare;
    apply_difference(from, difference, spare);
    return from;
}

TEST(StateDifference, GivesBackEveryByteOfAnyTwoStates) {
    std::mt19937 random(1);
    StateImage from;
    for (int i = 0; i < 300; ++i) {
        const StateImage to = random_image(random);
        expect_same(applied(from, state_difference(from, to)), to);
        if (HasFailure()) FAIL() << "round " << i;
        from = to;
    }
}

TEST(StateDifference, FollowsAStateWhoseTablesKeepTheirPlaces) {
    std::mt19937 random(2);
    StateImage from, kept, spare;
    from.bytes.assign(20'000, 7);
    from.starts = {37, 37, 9'000};
    kept = from;
    const std::uint8_t* const place = kept.bytes.data();
    for (int i = 0; i < 100; ++i) {
        StateImage to = from;
        for (int change = 0; change < i % 5; ++change)
            to.bytes[random() % to.bytes.size()] = static_cast<std::uint8_t>(random());
        apply_difference(kept, state_difference(from, to), spare);
        expect_same(kept, to);
        if (HasFailure()) FAIL() << "round " << i;
        from = to;
    }
    EXPECT_EQ(kept.bytes.data(), place) << "it was copied";
    EXPECT_TRUE(spare.bytes.empty());
}

TEST(StateDifference, IsSmallWhereATableGrows) {
    StateImage from, to;
    from.bytes.assign(100'000, 7);
    from.starts = {1000, 50'000};
    to = from;
    to.bytes[20'000] = 8;
    to.bytes.insert(to.bytes.begin() + 50'000, 100, 9);  // at the end of the second table
    to.starts[1] += 100;
    EXPECT_LT(state_difference(from, to).size(), 600U);
    expect_same(applied(from, state_difference(from, to)), to);
}

TEST(StateDifference, DamagedOnesAreRefusedOrGiveAState) {
    std::mt19937 random(3);
    const StateImage from = random_image(random), to = random_image(random);
    const std::vector<std::uint8_t> good = state_difference(from, to);
    for (std::size_t cut = 0; cut < good.size(); ++cut)
        EXPECT_THROW(applied(from, {good.begin(), good.begin() + static_cast<std::ptrdiff_t>(cut)}),
                     StateArchiveError)
            << cut;
    for (int i = 0; i < 2000; ++i) {
        std::vector<std::uint8_t> bytes = good;
        bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
        try {
            EXPECT_LE(applied(from, bytes).bytes.size(), 6 * (from.bytes.size() + bytes.size()));
        } catch (const StateArchiveError&) {
        }
    }
}

std::vector<std::uint8_t> state_of(ReplayCursor& cursor) {
    std::vector<std::uint8_t> bytes;
    StateArchive archive(bytes);
    cursor.transfer(archive);
    return bytes;
}

class Frames : public ::testing::TestWithParam<const char*> {
  protected:
    Frames() : made(test::expert_record(GetParam())) {}
    /// Leaves a frame each `gap` ticks; every state is kept aside.
    void leave(FrameStore& frames, std::uint32_t gap, std::uint32_t last) {
        AttemptEngine engine(made.scene, made.task, test::expert_seed);
        ReplayCursor cursor(engine, made.record);
        while (cursor.tick() < last && !cursor.at_end()) {
            frames.add(cursor);
            states[cursor.tick()] = state_of(cursor);
            cursor.run_to(cursor.tick() + gap);
        }
    }
    const test::ExpertRecord& made;
    std::map<std::uint32_t, std::vector<std::uint8_t>> states;
};

TEST_P(Frames, EveryStateComesBackAndContinuesBitForBit) {
    FrameStore frames;
    leave(frames, 150, 12'000);
    ASSERT_GT(frames.count(), 2 * FrameStore::frames_in_group) << "several groups";
    for (const auto& [tick, state] : states) {
        EXPECT_EQ(frames.before(tick), tick);
        EXPECT_EQ(frames.state(tick), state) << tick;
        EXPECT_EQ(frames.before(tick + 149), tick);
    }
    AttemptEngine engine(made.scene, made.task, test::expert_seed);
    ReplayCursor cursor(engine, made.record);
    std::mt19937 random(4);
    for (int i = 0; i < 12; ++i) {
        const auto tick = static_cast<std::uint32_t>(random() % 12'000);
        frames.put(tick, cursor);
        EXPECT_EQ(cursor.tick(), frames.before(tick));
        cursor.run_to(tick);
        EXPECT_TRUE(cursor.outcome().identical) << tick;
    }
}

TEST_P(Frames, AboveTheBoundEverySecondOneGoesAndTheRestStaysRight) {
    FrameStore all;
    leave(all, 200, 9000);
    const std::size_t most = all.bytes() / 2;  // one group's whole frame takes a third
    FrameStore few(most);
    leave(few, 200, 9000);
    EXPECT_LE(few.bytes(), most);
    EXPECT_LT(few.count(), all.count());
    EXPECT_GT(few.count(), 3U);
    EXPECT_FALSE(few.wants(FrameStore::longest_gap_s)) << "further ones are made at a greater distance";
    for (const auto& [tick, state] : states) {
        const std::int64_t before = few.before(tick);
        ASSERT_GE(before, 0) << "the first one stays";
        EXPECT_EQ(few.state(tick), states.at(static_cast<std::uint32_t>(before))) << tick;
    }
}

TEST_P(Frames, WithoutOneNothingIsMoved) {
    FrameStore frames;
    EXPECT_EQ(frames.before(5), -1);
    EXPECT_TRUE(frames.state(5).empty());
    AttemptEngine engine(made.scene, made.task, test::expert_seed);
    ReplayCursor cursor(engine, made.record);
    cursor.run_to(100);
    frames.put(5, cursor);
    EXPECT_EQ(cursor.tick(), 100U);
}

TEST_P(Frames, FromAFileTheyContinueBitForBitAtEveryMoment) {
    const std::uint32_t last = 5100;  // two groups
    FrameStore made_now;
    leave(made_now, 150, last);
    const test::OwnFolder folder;
    const FrameKeeping keeping{(folder / "store.db.frames").string(), "attempt.frames",
                               frames_belong_to(GetParam())};
    FrameFileWriter writer(keeping, made_now.frames(), last);
    while (writer.write_more()) {
    }
    FrameStore kept;
    kept.restore(FrameFile::open(keeping));
    ASSERT_EQ(kept.count(), made_now.count());
    for (const auto& [tick, state] : states) EXPECT_EQ(kept.state(tick), state) << tick;
    AttemptEngine engine(made.scene, made.task, test::expert_seed);
    ReplayCursor cursor(engine, made.record);
    std::mt19937 random(5);
    for (int i = 0; i < 12; ++i) {
        const auto tick = static_cast<std::uint32_t>(random() % last);
        kept.put(tick, cursor);
        EXPECT_EQ(cursor.tick(), made_now.before(tick));
        cursor.run_to(tick + 20);
        EXPECT_TRUE(cursor.outcome().identical) << tick;
    }
    kept.restore(nullptr);
    EXPECT_EQ(kept.count(), 0U);
    EXPECT_TRUE(kept.state(last).empty());
}

INSTANTIATE_TEST_SUITE_P(Tasks, Frames, ::testing::Values("A2", "B2"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace fulcrum::app
