// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/real_time.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>

#include "tests/support/clock_ahead.h"

namespace fulcrum::app {
namespace {

// The recorder waits so between two looks at what is to be stored.
TEST(RealTime, AWaitIsNotLongerWhereTheClockIsSetBack) {
    if (!fulcrum::test::clocks_can_be_set) GTEST_SKIP() << "a sanitizer owns the clocks";
    // Read before the clock was set back by an hour; the kernel waits by the clock as it is.
    const fulcrum::test::ClockAhead before(CLOCK_REALTIME, 3600);
    Signal signal;
    std::future<bool> waited = std::async(std::launch::async, [&signal] { return signal.wait_for_ms(20); });
    EXPECT_EQ(waited.wait_for(std::chrono::seconds(5)), std::future_status::ready);
    signal.post();
    EXPECT_FALSE(waited.get()) << "its time was over";
}

TEST(RealTime, AWaitEndsWithTheSignal) {
    Signal signal;
    signal.post();
    EXPECT_TRUE(signal.wait_for_ms(20));
    EXPECT_FALSE(signal.wait_for_ms(20));
}

}  // namespace
}  // namespace fulcrum::app
