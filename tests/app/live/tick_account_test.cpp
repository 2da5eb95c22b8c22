// SPDX-License-Identifier: GPL-3.0-or-later
// A late tick is attributed to program or scheduler by its thread's processor time, not by wall time.
#include "app/live/tick_account.h"

#include <gtest/gtest.h>

#include <ctime>

namespace fulcrum::app {
namespace {

constexpr std::int64_t us = 1000;
constexpr std::int64_t period = 1000 * us;

/// Counts as the haptic thread does, from durations set by the test.
struct Clock {
    TickAccount account{period};
    std::int64_t late = 0;
    int program = 0, scheduler = 0;

    /// A tick whose work took `wall`, including `processor` on the processor; if the thread then slept, it
    /// was woken `woken` late.
    Lateness tick(std::int64_t wall, std::int64_t processor, std::int64_t waits = 0, std::int64_t woken = 0) {
        late += wall - period;
        if (late < 0) late = woken;
        const Lateness lateness = account.begin(late, wall, {processor, waits});
        program += lateness == Lateness::by_program ? 1 : 0;
        scheduler += lateness == Lateness::by_scheduler ? 1 : 0;
        return lateness;
    }
    void quick_ticks(int count) {
        for (int i = 0; i < count; ++i) tick(20 * us, 20 * us);
    }
};

TEST(TickAccount, LongWallTimeAndShortProcessorTimeIsCausedByTheScheduler) {
    Clock clock;
    EXPECT_EQ(clock.tick(2500 * us, 20 * us), Lateness::by_scheduler);
}

TEST(TickAccount, LongProcessorTimeIsCausedByTheProgram) {
    Clock clock;
    EXPECT_EQ(clock.tick(2500 * us, 2500 * us), Lateness::by_program);
    // Preempted for half of the time: the thread's own work still fills the period.
    Clock halved;
    EXPECT_EQ(halved.tick(2500 * us, 1000 * us), Lateness::by_program);
}

TEST(TickAccount, OwnWorkJustBelowThePeriodIsCausedByTheScheduler) {
    Clock clock;
    EXPECT_EQ(clock.tick(2500 * us, 1000 * us - 1), Lateness::by_scheduler);
}

TEST(TickAccount, LateByLessThanAPeriodIsNotMissed) {
    Clock clock;
    EXPECT_EQ(clock.tick(1999 * us, 1999 * us), Lateness::in_time);
    EXPECT_EQ(clock.program + clock.scheduler, 0);
}

TEST(TickAccount, LateWakingIsCausedByTheScheduler) {
    Clock clock;
    EXPECT_EQ(clock.tick(20 * us, 25 * us, 0, 3000 * us), Lateness::by_scheduler);
}

TEST(TickAccount, TickWithAVoluntaryWaitCountsWithItsWallTime) {
    Clock clock;
    EXPECT_EQ(clock.tick(2500 * us, 20 * us, 1), Lateness::by_program);
    Clock quick;  // a wait shorter than a period causes no missed tick
    EXPECT_EQ(quick.tick(400 * us, 20 * us, 1), Lateness::in_time);
    // A short wait, after which the system woke the thread late.
    EXPECT_EQ(quick.tick(20 * us, 20 * us, 1, 2000 * us), Lateness::by_scheduler);
}

TEST(TickAccount, TicksThatCatchUpAreAttributedToTheCauseOfTheDelay) {
    Clock own;
    own.tick(5200 * us, 5200 * us);  // 4.2 ms behind; each short tick recovers 0.98 ms
    own.quick_ticks(10);
    EXPECT_EQ(own.program, 4);
    EXPECT_EQ(own.scheduler, 0);
    Clock stolen;
    stolen.tick(5200 * us, 20 * us);
    stolen.quick_ticks(10);
    EXPECT_EQ(stolen.program, 0);
    EXPECT_EQ(stolen.scheduler, 4);
}

TEST(TickAccount, ManyTicksALittleTooLongAddUp) {
    Clock clock;
    for (int i = 0; i < 30; ++i) clock.tick(1100 * us, 1100 * us);
    EXPECT_EQ(clock.program, 21);  // a period behind from the tenth tick
    EXPECT_EQ(clock.scheduler, 0);
}

TEST(TickAccount, OwnDelayIsForgottenOnceCaughtUp) {
    Clock clock;
    clock.tick(2500 * us, 2500 * us);
    clock.quick_ticks(5);
    EXPECT_EQ(clock.tick(2500 * us, 20 * us), Lateness::by_scheduler);
    EXPECT_EQ(clock.program, 1);
}

TEST(TickAccount, NoDelayIsLeftAfterTheDeadlineWasMoved) {
    Clock clock;
    clock.tick(30000 * us, 30000 * us);
    clock.account.clock_moved();
    clock.late = 0;
    EXPECT_EQ(clock.tick(2500 * us, 20 * us), Lateness::by_scheduler);
}

TEST(TickAccount, SleepIsWhatTheClockThatCountsItGains) {
    constexpr std::int64_t hour = 3'600'000'000 * us;
    SleepAccount sleeps;
    EXPECT_EQ(sleeps.slept(7 * period, 7 * period + hour), 0) << "before the first tick";
    EXPECT_EQ(sleeps.slept(8 * period, 8 * period + hour), 0);
    EXPECT_EQ(sleeps.slept(9 * period, 9 * period + 3 * hour), 2 * hour);
    EXPECT_EQ(sleeps.slept(10 * period, 10 * period + 3 * hour + 5 * us), 5 * us) << "preempted";
    EXPECT_EQ(sleeps.slept(11 * period, 11 * period + 3 * hour), -5 * us);
}

TEST(TickAccount, ASleepThatBeganInAPauseDoesNotCount) {
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

TEST(ThreadUse, ProcessorTimeGrowsWithWorkAndWaitsWithSleep) {
    const ThreadUse before = use_of_this_thread();
    ThreadUse after = before;
    while (after.processor_ns < before.processor_ns + 1000000) after = use_of_this_thread();
    EXPECT_GE(after.waits, before.waits);
    // One sleep is enough unless the machine was suspended until its end.
    const timespec nap{0, 1000000};
    for (int i = 0; i < 100 && use_of_this_thread().waits == after.waits; ++i) nanosleep(&nap, nullptr);
    EXPECT_GT(use_of_this_thread().waits, after.waits);
}

}  // namespace
}  // namespace fulcrum::app
