// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/sleep_account.h"

#include <gtest/gtest.h>

namespace fulcrum::app {
namespace {

constexpr std::int64_t us = 1000;
constexpr std::int64_t period = 1000 * us;

TEST(SleepAccount, SleepIsWhatTheClockThatCountsItGains) {
    constexpr std::int64_t hour = 3'600'000'000 * us;
    SleepAccount sleeps;
    EXPECT_EQ(sleeps.slept(7 * period, 7 * period + hour), 0) << "before the first tick";
    EXPECT_EQ(sleeps.slept(8 * period, 8 * period + hour), 0);
    EXPECT_EQ(sleeps.slept(9 * period, 9 * period + 3 * hour), 2 * hour);
    EXPECT_EQ(sleeps.slept(10 * period, 10 * period + 3 * hour + 5 * us), 5 * us) << "preempted";
    EXPECT_EQ(sleeps.slept(11 * period, 11 * period + 3 * hour), -5 * us);
}

TEST(SleepAccount, ASleepThatBeganInAPauseDoesNotCount) {
    constexpr std::int64_t second = 1'000'000 * us, minute = 60 * second;
    SleepAccount sleeps;
    std::int64_t now = 0, asleep = 0;
    const auto tick = [&](std::int64_t late, std::int64_t slept, bool paused) {
        now += period + late;
        asleep += slept;
        return sleeps.stood_still(late, now, now + asleep, paused);
    };
    EXPECT_EQ(tick(0, 0, false), 0);
    EXPECT_EQ(tick(3 * us, minute, true), minute + 3 * us) << "paused after it: by the lock of the screen";
    EXPECT_EQ(tick(0, minute, true), 0);
    EXPECT_EQ(tick(2 * second, minute, true), 0) << "programs started again some time after it";
    EXPECT_EQ(tick(2 * second, 0, true), 2 * second) << "stopped, and no machine slept";
    EXPECT_EQ(tick(2 * second, 5 * us, true), 2 * second + 5 * us) << "preempted between the clocks";
    EXPECT_EQ(tick(0, minute, false), 0) << "resumed after it, before this tick";
    EXPECT_EQ(tick(0, minute, false), minute);
}

}  // namespace
}  // namespace fulcrum::app
