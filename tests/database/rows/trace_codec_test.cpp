// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/trace_codec.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "database/rows/crypto.h"
#include "database/rows/errors.h"

namespace fulcrum::database {
namespace {

bool same(const HandSample& a, const HandSample& b) {
    return std::equal(a.tip, a.tip + 3, b.tip) && std::equal(a.axis, a.axis + 3, b.axis) &&
           a.roll == b.roll && a.jaw_angle == b.jaw_angle && std::equal(a.force, a.force + 3, b.force) &&
           std::equal(a.device_force, a.device_force + 3, b.device_force) &&
           std::equal(a.torque, a.torque + 3, b.torque) && a.jaw_force == b.jaw_force &&
           a.jaw_area == b.jaw_area && a.tissue == b.tissue && a.patch == b.patch && a.flags == b.flags &&
           a.filter_grade == b.filter_grade;
}
bool same(const TickSample& a, const TickSample& b) {
    return a.tick == b.tick && a.rig_flags == b.rig_flags && a.model_step == b.model_step &&
           a.missed == b.missed && same(a.hand[0], b.hand[0]) && same(a.hand[1], b.hand[1]) &&
           std::equal(a.camera.tip, a.camera.tip + 3, b.camera.tip) &&
           std::equal(a.camera.orientation, a.camera.orientation + 4, b.camera.orientation);
}
bool same(const DeviceSample& a, const DeviceSample& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}
bool same(const RigSample& a, const RigSample& b) {
    return a.tick == b.tick && a.flags == b.flags && same(a.hand[0], b.hand[0]) &&
           same(a.hand[1], b.hand[1]) && same(a.camera, b.camera);
}
bool same(const StepRecord& a, const StepRecord& b) {
    return a.step == b.step && a.first_tick == b.first_tick && a.last_tick == b.last_tick &&
           a.outcome == b.outcome && a.state_hash == b.state_hash;
}
bool same(const Event& a, const Event& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// Any bytes are a valid record of these types: integers, and a float that is stored by its bits.
template <typename Record>
std::vector<Record> random_records(std::mt19937_64& random, std::size_t count, unsigned bits) {
    std::vector<Record> records(count);
    for (Record& record : records) {
        auto* bytes = reinterpret_cast<unsigned char*>(&record);
        for (std::size_t i = 0; i < sizeof record; ++i) {
            bytes[i] = static_cast<unsigned char>(bits == 0 ? 0 : random() & ((1U << bits) - 1U));
        }
    }
    return records;
}

template <typename Record>
void expect_round_trip(const std::vector<Record>& records) {
    TraceCodec codec;
    const TraceChunk chunk = codec.encode(records.data(), records.size());
    std::vector<Record> back;
    codec.decode(chunk, back);
    ASSERT_EQ(back.size(), records.size());
    for (std::size_t i = 0; i < back.size(); ++i) ASSERT_TRUE(same(back[i], records[i])) << "record " << i;
}

template <typename Record>
class EveryStream : public ::testing::Test {};
using Streams = ::testing::Types<TickSample, RigSample, StepRecord, Event>;
TYPED_TEST_SUITE(EveryStream, Streams);

TYPED_TEST(EveryStream, AnyRecordsComeBackAsTheyWere) {
    rc::check([] {
        std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
        const auto count = *rc::gen::inRange<std::size_t>(1, 700);
        const auto bits = *rc::gen::inRange<unsigned>(0, 9);
        expect_round_trip(random_records<TypeParam>(random, count, bits));
    });
}

TYPED_TEST(EveryStream, SizesAtTheEdges) {
    std::mt19937_64 random(1);
    for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{128},
                                    std::size_t{129}, chunk_maximum_records}) {
        expect_round_trip(random_records<TypeParam>(random, count, 8));
    }
    TraceCodec codec;
    const std::vector<TypeParam> many(chunk_maximum_records + 1);
    EXPECT_THROW(codec.encode(many.data(), many.size()), StoreError);
    EXPECT_THROW(codec.encode(many.data(), 0), StoreError);
}

TYPED_TEST(EveryStream, DamageIsNoticedOrHarmless) {
    std::mt19937_64 random(7);
    TraceCodec codec;
    const auto records = random_records<TypeParam>(random, 300, 5);
    const TraceChunk good = codec.encode(records.data(), records.size());
    for (int round = 0; round < 2000; ++round) {
        TraceChunk bad = good;
        switch (random() % 4) {
            case 0:
                bad.data[random() % bad.data.size()] ^= static_cast<std::uint8_t>(1U << (random() % 8));
                break;
            case 1:
                bad.data.resize(random() % bad.data.size());
                break;
            case 2:
                bad.count = static_cast<std::uint32_t>(random());
                break;
            default:
                bad.data.push_back(static_cast<std::uint8_t>(random()));
        }
        std::vector<TypeParam> back;
        EXPECT_THROW(codec.decode(bad, back), StoreError);
        EXPECT_TRUE(back.empty());
        // Past the checksum, as a hostile file would be: it may decode to other records but must stay within
        // its bounds.
        bad.checksum = blake2b(bad.data, 16);
        try {
            codec.decode(bad, back);
            EXPECT_EQ(back.size(), bad.count);
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), StoreErrorKind::corrupt);
            EXPECT_TRUE(back.empty());
        }
    }
}

TYPED_TEST(EveryStream, RandomBytesNeverDecodeBeyondTheirBounds) {
    std::mt19937_64 random(11);
    TraceCodec codec;
    std::vector<TypeParam> back;
    std::vector<TypeParam> one(1);
    TraceChunk chunk = codec.encode(one.data(), 1);
    for (int round = 0; round < 2000; ++round) {
        chunk.data.resize(random() % 200);
        for (auto& byte : chunk.data) byte = static_cast<std::uint8_t>(random());
        chunk.count = static_cast<std::uint32_t>(random() % (chunk_maximum_records + 2));
        chunk.checksum = blake2b(chunk.data, 16);
        EXPECT_THROW(codec.decode(chunk, back), StoreError);
    }
}

/// Any samples with any inputs at the same ticks, drawn inside a property.
std::pair<std::vector<TickSample>, std::vector<RigSample>> any_record() {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const auto count = *rc::gen::inRange<std::size_t>(1, 700);
    auto samples = random_records<TickSample>(random, count, *rc::gen::inRange<unsigned>(0, 9));
    auto inputs = random_records<RigSample>(random, count, *rc::gen::inRange<unsigned>(0, 9));
    for (std::size_t i = 0; i < count; ++i)
        samples[i].tick = inputs[i].tick = static_cast<std::uint32_t>(i) + 7;
    return {std::move(samples), std::move(inputs)};
}

TEST(TraceCodec, SamplesComeBackByTheirInputsWhateverTheyAre) {
    rc::check([] {
        auto [samples, inputs] = any_record();
        const std::size_t count = samples.size();
        TraceCodec codec;
        const TraceChunk chunk = codec.encode(samples.data(), count, inputs.data());
        std::vector<TickSample> back;
        codec.decode(chunk, back, &inputs);
        RC_ASSERT(back.size() == count);
        for (std::size_t i = 0; i < count; ++i) RC_ASSERT(same(back[i], samples[i]));
    });
}

TEST(TraceCodec, AnOverviewHoldsTheSameColumnsAsTheWhole) {
    rc::check([] {
        auto [samples, inputs] = any_record();
        const std::size_t count = samples.size();
        const bool with_inputs = *rc::gen::arbitrary<bool>();
        TraceCodec codec;
        const TraceChunk of_inputs = codec.encode(inputs.data(), count);
        const TraceChunk chunk = codec.encode(samples.data(), count, with_inputs ? inputs.data() : nullptr);
        TraceOverview overview;
        overview.tick.assign(3, 0);  // what was there before is replaced
        codec.decode_overview(chunk, &of_inputs, overview);
        RC_ASSERT(overview.tick.size() == count);
        for (std::size_t i = 0; i < count; ++i) {
            RC_ASSERT(overview.tick[i] == samples[i].tick);
            for (std::size_t h = 0; h < 2; ++h) {
                const HandSample& hand = samples[i].hand[h];
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    RC_ASSERT(static_cast<std::int32_t>(overview.hand[h].tip[axis][i]) == hand.tip[axis]);
                    RC_ASSERT(static_cast<std::int32_t>(overview.hand[h].force[axis][i]) == hand.force[axis]);
                }
                RC_ASSERT(overview.hand[h].flags[i] == hand.flags);
            }
        }
    });
}

TEST(TraceCodec, AnOverviewOfADamagedChunkIsRefused) {
    std::mt19937_64 random(5);
    auto samples = random_records<TickSample>(random, 300, 3);
    auto inputs = random_records<RigSample>(random, 300, 3);
    for (std::uint32_t i = 0; i < 300; ++i) samples[i].tick = inputs[i].tick = i;
    TraceCodec codec;
    const TraceChunk of_inputs = codec.encode(inputs.data(), 300);
    TraceChunk chunk = codec.encode(samples.data(), 300, inputs.data());
    TraceOverview overview;
    codec.decode_overview(chunk, &of_inputs, overview);
    const TraceChunk others = codec.encode(inputs.data(), 299);
    EXPECT_THROW(codec.decode_overview(of_inputs, &of_inputs, overview), StoreError) << "another stream";
    for (int i = 0; i < 200; ++i) {
        TraceChunk broken = chunk;
        broken.data[random() % broken.data.size()] ^= static_cast<std::uint8_t>(1U << (random() % 8));
        EXPECT_THROW(codec.decode_overview(broken, &of_inputs, overview), StoreError) << "its checksum";
        // With a recomputed checksum any result is allowed but a crash.
        broken.checksum = blake2b(broken.data, 16);
        try {
            codec.decode_overview(broken, i % 2 == 0 ? &of_inputs : &others, overview);
        } catch (const StoreError&) {
        }
    }
}

TEST(TraceCodec, SamplesNeedTheInputsTheyWereMadeWith) {
    std::mt19937 random(3);
    std::vector<TickSample> samples(500), back;
    std::vector<RigSample> inputs(500);
    for (std::uint32_t i = 0; i < 500; ++i) {
        samples[i].tick = inputs[i].tick = 1000 + i;
        inputs[i].hand[0].handle[0] = static_cast<std::int32_t>(random() % 1000);
        samples[i].hand[0].tip[0] = 3 * inputs[i].hand[0].handle[0] - 40;
    }
    TraceCodec codec;
    const TraceChunk alone = codec.encode(samples.data(), 500);
    const TraceChunk chunk = codec.encode(samples.data(), 500, inputs.data());
    EXPECT_LT(chunk.data.size() * 3, alone.data.size());
    EXPECT_THROW(codec.decode(chunk, back), StoreError);
    const std::vector<RigSample> fewer(inputs.begin(), inputs.begin() + 499);
    EXPECT_THROW(codec.decode(chunk, back, &fewer), StoreError);
    std::vector<RigSample> more(3);
    more.insert(more.end(), inputs.begin(), inputs.end());
    codec.decode(chunk, back, &more);
    ASSERT_EQ(back.size(), 500U);
    EXPECT_TRUE(same(back[499], samples[499]));
    // Inputs of other ticks are not used at all.
    inputs[250].tick = 9;
    EXPECT_EQ(codec.encode(samples.data(), 500, inputs.data()).data, alone.data);
}

TEST(TraceCodec, AChunkIsNotTakenForAnotherStream) {
    TraceCodec codec;
    const std::vector<TickSample> records(3);
    TraceChunk chunk = codec.encode(records.data(), records.size());
    std::vector<RigSample> inputs;
    EXPECT_THROW(codec.decode(chunk, inputs), StoreError);
    chunk.stream = TraceStream::inputs;
    EXPECT_THROW(codec.decode(chunk, inputs), StoreError);
}

TEST(TraceCodec, NotANumberInAnEventKeepsItsBits) {
    Event event;
    event.value = std::numeric_limits<float>::quiet_NaN();
    expect_round_trip(std::vector<Event>{event, event});
}

TEST(TraceCodec, AChunkFromBeforeTorquesWereRecordedIsStillRead) {
    // Six samples, written when a sample had 51 columns.
    const std::string hex =
        "28b52ffd20869d0300a246192590398d018bff818c1bc10ee8fc57fd33772441ce2455dffd0648d4709f65b3e21c0c223b05"
        "cdc9"
        "19d6cf63aadf4191d6b5f5403da8ec8a1613f537d0095710182acc3a76a48d1c702d11d45ff186ac6b4ee2f4b0f65f09d204"
        "ab87"
        "24a93fc887b839300b0300c5f56faa2e60813a03";
    TraceChunk chunk;
    chunk.first_tick = 100;
    chunk.last_tick = 105;
    chunk.count = 6;
    for (std::size_t i = 0; i < hex.size(); i += 2)
        chunk.data.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    chunk.checksum = blake2b(chunk.data, 16);
    TraceCodec codec;
    std::vector<TickSample> back;
    codec.decode(chunk, back);
    ASSERT_EQ(back.size(), 6U);
    for (std::uint32_t i = 0; i < 6; ++i) {
        TickSample expected;
        expected.tick = 100 + i;
        expected.model_step = 20;
        for (int h = 0; h < 2; ++h) {
            HandSample& hand = expected.hand[h];
            hand.tip[0] = (h == 1 ? -1 : 1) * static_cast<std::int32_t>(1000 + i * i);
            hand.force[2] = -250 * static_cast<std::int32_t>(i);
            hand.device_force[2] = -240 * static_cast<std::int32_t>(i);
            hand.tissue = 1;
        }
        expected.camera.tip[1] = 77;
        EXPECT_TRUE(same(back[i], expected)) << i;
    }
}

}  // namespace
}  // namespace fulcrum::database
