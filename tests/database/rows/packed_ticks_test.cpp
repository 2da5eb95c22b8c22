// SPDX-License-Identifier: GPL-3.0-or-later
// What is packed answers as the record itself, from anywhere, to several readers.
#include "database/rows/packed_ticks.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <thread>

#include "database/rows/errors.h"
#include "database/rows/trace_codec.h"

namespace fulcrum::database {
namespace {

struct PackedExample {
    std::vector<RigSample> inputs;
    std::vector<TickSample> samples;
    std::shared_ptr<PackedTicks> ticks = std::make_shared<PackedTicks>();

    /// Ticks from 5 on, with gaps; chunks of different lengths.
    PackedExample() {
        std::mt19937 random(7);
        std::uint32_t tick = 5;
        for (const std::size_t count : {1000, 1, 300, 999}) {
            const std::size_t first = samples.size();
            for (std::size_t i = 0; i < count; ++i) {
                RigSample input;
                TickSample sample;
                input.tick = sample.tick = tick;
                tick += random() % 10 == 0 ? 3 : 1;
                for (int h = 0; h < hand_count; ++h) {
                    input.hand[h].handle[1] = static_cast<std::int32_t>(random() % 100000);
                    sample.hand[h].tip[2] = -input.hand[h].handle[1];
                    sample.hand[h].force[0] = static_cast<std::int32_t>(random() % 5000);
                }
                sample.model_step = tick / 5;
                inputs.push_back(input);
                samples.push_back(sample);
            }
            TraceCodec codec;
            TraceChunk of_inputs = codec.encode(inputs.data() + first, count);
            EXPECT_TRUE(ticks->add(std::move(of_inputs),
                                   codec.encode(samples.data() + first, count, inputs.data() + first)));
        }
    }
    void expect_same(TickReader& reader, std::size_t index) const {
        EXPECT_EQ(std::memcmp(&reader.input(index), &inputs[index], sizeof(RigSample)), 0) << index;
        EXPECT_EQ(std::memcmp(&reader.sample(index), &samples[index], sizeof(TickSample)), 0) << index;
    }
};

TEST(PackedTicks, AnswerAsTheRecordItselfFromAnywhere) {
    const PackedExample made;
    ASSERT_EQ(made.ticks->size(), made.samples.size());
    EXPECT_EQ(made.ticks->first_tick(), 5U);
    EXPECT_EQ(std::memcmp(&made.ticks->last_sample(), &made.samples.back(), sizeof(TickSample)), 0);
    const auto reader = made.ticks->reader();
    for (std::size_t i = 0; i < made.samples.size(); ++i) made.expect_same(*reader, i);
    std::mt19937 random(3);
    for (int i = 0; i < 100; ++i) made.expect_same(*reader, random() % made.samples.size());
    const auto record = std::make_shared<Trace>(Trace{made.samples, made.inputs, {}, {}});
    const auto as_it_is = ticks_of(record);
    const auto other = as_it_is->reader();
    for (std::uint32_t tick = 0; tick < made.samples.back().tick + 3; ++tick)
        EXPECT_EQ(reader->at_or_after(tick), other->at_or_after(tick)) << tick;
    EXPECT_EQ(reader->at_or_after(0xffffffff), made.samples.size());
}

TEST(PackedTicks, HaveReadersThatOutliveTheRecordAndDoNotDisturbEachOther) {
    PackedExample made;
    std::vector<std::unique_ptr<TickReader>> readers;
    for (int i = 0; i < 3; ++i) readers.push_back(made.ticks->reader());
    made.ticks.reset();
    std::vector<std::thread> threads;
    for (std::size_t r = 0; r < readers.size(); ++r)
        threads.emplace_back([&made, &reader = *readers[r], r] {
            for (std::size_t i = r * 700; i < made.samples.size(); i += 37) made.expect_same(reader, i);
        });
    for (std::thread& thread : threads) thread.join();
}

TEST(PackedTicks, RefuseChunksThatAreNoPairOrDamaged) {
    PackedExample made;
    TraceCodec codec;
    const auto inputs = [&](std::size_t first, std::size_t count) {
        return codec.encode(made.inputs.data() + first, count);
    };
    const auto alone = [&](std::size_t first, std::size_t count) {
        return codec.encode(made.samples.data() + first, count);
    };
    EXPECT_FALSE(made.ticks->add(inputs(0, 10), alone(1, 10)));
    EXPECT_FALSE(made.ticks->add(inputs(0, 11), alone(0, 10)));
    EXPECT_FALSE(made.ticks->add(inputs(0, 10), alone(0, 11)));
    TraceChunk damaged = alone(0, 10);
    damaged.data[damaged.data.size() / 2] ^= 1U;
    EXPECT_THROW(made.ticks->add(inputs(0, 10), damaged), StoreError);
    EXPECT_EQ(made.ticks->size(), made.samples.size());
}

}  // namespace
}  // namespace fulcrum::database
