// SPDX-License-Identifier: Apache-2.0
// Samples become columns; gaps, pauses and lost samples become blocks.
#include "assessment/trace/trace.h"

#include <gtest/gtest.h>

namespace fulcrum {
namespace {

Event make_event(std::uint32_t tick, EventKind kind, int detail = 0) {
    Event event;
    event.tick = tick;
    event.kind = kind;
    event.detail = detail;
    return event;
}

std::vector<TickSample> samples_of(std::uint32_t count) {
    std::vector<TickSample> samples(count);
    for (std::uint32_t i = 0; i < count; ++i) samples[i].tick = i;
    return samples;
}

TEST(TraceFromSamples, GivesSiUnits) {
    std::vector<TickSample> samples = samples_of(2);
    HandSample& hand = samples[1].hand[1];
    hand.tip[0] = 1234567;      // 0.1234567 m
    hand.axis[2] = -100000000;  // -1
    hand.force[1] = 2500;       // 2.5 N
    hand.jaw_force = 750;
    hand.jaw_area = 60000;  // 60 mm2
    hand.roll = 500000;
    hand.tissue = 1;
    hand.patch = 17;
    hand.flags = hand_inside | hand_energy;
    const Trace trace = trace_from_samples(samples, {}, {"wall", "bowel"}, 1000, {false, true});
    EXPECT_EQ(trace.t[1], 0.001);
    const HandTrace& right = trace.hand[1];
    EXPECT_EQ(right.px[1], 0.1234567);
    EXPECT_EQ(right.az[1], -1.0);
    EXPECT_EQ(right.fy[1], 2.5);
    EXPECT_EQ(right.jaw_force[1], 0.75);
    EXPECT_EQ(right.jaw_area[1], 60e-6);
    EXPECT_EQ(right.roll[1], 0.5);
    EXPECT_EQ(right.tissue[1], 1);
    EXPECT_EQ(right.tissue[0], -1);
    EXPECT_EQ(right.patch[1], 17);
    EXPECT_EQ(right.inside[1], 1);
    EXPECT_EQ(right.in_view[1], 0);
    EXPECT_EQ(right.energy[1], 1);
    EXPECT_EQ(trace.camera.qw[0], 1.0);
    for (const Channel channel : {Channel::position, Channel::axis, Channel::roll, Channel::force,
                                  Channel::jaw_force, Channel::jaw_area, Channel::tissue, Channel::patch,
                                  Channel::inside, Channel::in_view, Channel::energy}) {
        EXPECT_TRUE(trace.hand[1].has(channel));
        EXPECT_FALSE(trace.hand[0].has(channel));  // no instrument there
    }
}

TEST(Blocks, SplitAtGapsLongerThanATenthOfASecond) {
    Trace trace;
    trace.t = {0.0, 0.1, 0.2, 0.301, 0.4};
    split_blocks(trace, {});
    ASSERT_EQ(trace.blocks.size(), 2U);
    EXPECT_EQ(trace.blocks[0].last, 3U);
    EXPECT_EQ(trace.blocks[1].first, 3U);
    EXPECT_EQ(trace.blocks[1].last, 5U);
}

TEST(Blocks, ExcludePausesAndSamplesAfterTheEnd) {
    const std::vector<Event> events = {
        make_event(100, EventKind::pause),       make_event(300, EventKind::resume),
        make_event(500, EventKind::device_lost), make_event(550, EventKind::pause),
        make_event(600, EventKind::device_back), make_event(700, EventKind::resume),
        make_event(900, EventKind::completed)};
    const Trace trace = trace_from_samples(samples_of(1000), events, {});
    ASSERT_EQ(trace.blocks.size(), 3U);
    EXPECT_EQ(trace.blocks[0].first, 0U);
    EXPECT_EQ(trace.blocks[0].last, 101U);
    EXPECT_EQ(trace.blocks[1].first, 300U);
    EXPECT_EQ(trace.blocks[1].last, 501U);
    EXPECT_EQ(trace.blocks[2].first, 700U);
    EXPECT_EQ(trace.blocks[2].last, 901U);
    ASSERT_EQ(trace.pauses.size(), 2U);
    EXPECT_DOUBLE_EQ(trace.pauses[1].begin, 0.5);  // a lost device during a pause: one pause
    EXPECT_DOUBLE_EQ(trace.pauses[1].end, 0.7);
    EXPECT_DOUBLE_EQ(trace.end, 0.9);
}

TEST(Blocks, PauseWithoutResumeLastsToTheEnd) {
    const std::vector<Event> events = {make_event(100, EventKind::pause),
                                       make_event(400, EventKind::abandoned)};
    const Trace trace = trace_from_samples(samples_of(500), events, {});
    ASSERT_EQ(trace.blocks.size(), 1U);
    EXPECT_EQ(trace.blocks[0].last, 101U);
    EXPECT_DOUBLE_EQ(trace.pauses.at(0).end, 0.4);
}

TEST(Blocks, SplitWhereSamplesWereLost) {
    const std::vector<Event> events = {make_event(50, EventKind::samples_lost, 7)};
    const Trace trace = trace_from_samples(samples_of(100), events, {});
    EXPECT_EQ(trace.samples_lost, 7U);
    ASSERT_EQ(trace.blocks.size(), 2U);
    EXPECT_EQ(trace.blocks[1].first, 50U);
}

TEST(MeanRate, IgnoresGapsButNotALowRate) {
    Trace trace;
    for (int i = 0; i < 100; ++i) trace.t.push_back(i * 0.01);
    for (int i = 0; i < 100; ++i) trace.t.push_back(60 + i * 0.01);
    split_blocks(trace, {});
    EXPECT_NEAR(trace.mean_rate(), 100.0, 1e-9);
    Trace slow;
    for (int i = 0; i < 20; ++i) slow.t.push_back(i * 0.5);
    split_blocks(slow, {});
    EXPECT_NEAR(slow.mean_rate(), 2.0, 1e-9);
    EXPECT_EQ(Trace{}.mean_rate(), 0.0);
}

}  // namespace
}  // namespace fulcrum
