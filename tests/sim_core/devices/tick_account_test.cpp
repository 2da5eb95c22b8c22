// SPDX-License-Identifier: Apache-2.0
// A late tick is attributed to program or scheduler by its thread's processor time, not by wall time.
#include "sim_core/devices/tick_account.h"

#include <gtest/gtest.h>

#include <ctime>

namespace fulcrum {
namespace {

constexpr std::int64_t account_us = 1000;
constexpr std::int64_t account_period = 1000 * account_us;

/// Counts as the haptic thread does, from durations set by the test.
struct AccountedTicks {
    TickAccount account{account_period};
    std::int64_t late = 0;
    int program = 0, scheduler = 0;

    /// A tick whose work took `wall`, including `processor` on the processor; if the thread then slept, it
    /// was woken `woken` late.
    Lateness tick(std::int64_t wall, std::int64_t processor, std::int64_t waits = 0, std::int64_t woken = 0) {
        late += wall - account_period;
        if (late < 0) late = woken;
        const Lateness lateness = account.begin(late, wall, {processor, waits});
        program += lateness == Lateness::by_program ? 1 : 0;
        scheduler += lateness == Lateness::by_scheduler ? 1 : 0;
        return lateness;
    }
    void quick_ticks(int count) {
        for (int i = 0; i < count; ++i) tick(20 * account_us, 20 * account_us);
    }
};

TEST(TickAccount, LongWallTimeAndShortProcessorTimeIsCausedByTheScheduler) {
    AccountedTicks clock;
    EXPECT_EQ(clock.tick(2500 * account_us, 20 * account_us), Lateness::by_scheduler);
}

TEST(TickAccount, LongProcessorTimeIsCausedByTheProgram) {
    AccountedTicks clock;
    EXPECT_EQ(clock.tick(2500 * account_us, 2500 * account_us), Lateness::by_program);
    // Preempted for half of the time: the thread's own work still fills the period.
    AccountedTicks halved;
    EXPECT_EQ(halved.tick(2500 * account_us, 1000 * account_us), Lateness::by_program);
}

TEST(TickAccount, OwnWorkJustBelowThePeriodIsCausedByTheScheduler) {
    AccountedTicks clock;
    EXPECT_EQ(clock.tick(2500 * account_us, 1000 * account_us - 1), Lateness::by_scheduler);
}

TEST(TickAccount, LateByLessThanAPeriodIsNotMissed) {
    AccountedTicks clock;
    EXPECT_EQ(clock.tick(1999 * account_us, 1999 * account_us), Lateness::in_time);
    EXPECT_EQ(clock.program + clock.scheduler, 0);
}

TEST(TickAccount, LateWakingIsCausedByTheScheduler) {
    AccountedTicks clock;
    EXPECT_EQ(clock.tick(20 * account_us, 25 * account_us, 0, 3000 * account_us), Lateness::by_scheduler);
}

TEST(TickAccount, TickWithAVoluntaryWaitCountsWithItsWallTime) {
    AccountedTicks clock;
    EXPECT_EQ(clock.tick(2500 * account_us, 20 * account_us, 1), Lateness::by_program);
    AccountedTicks quick;  // a wait shorter than a period causes no missed tick
    EXPECT_EQ(quick.tick(400 * account_us, 20 * account_us, 1), Lateness::in_time);
    // A short wait, after which the system woke the thread late.
    EXPECT_EQ(quick.tick(20 * account_us, 20 * account_us, 1, 2000 * account_us), Lateness::by_scheduler);
}

TEST(TickAccount, TicksThatCatchUpAreAttributedToTheCauseOfTheDelay) {
    AccountedTicks own;
    own.tick(5200 * account_us, 5200 * account_us);  // 4.2 ms behind; each short tick recovers 0.98 ms
    own.quick_ticks(10);
    EXPECT_EQ(own.program, 4);
    EXPECT_EQ(own.scheduler, 0);
    AccountedTicks stolen;
    stolen.tick(5200 * account_us, 20 * account_us);
    stolen.quick_ticks(10);
    EXPECT_EQ(stolen.program, 0);
    EXPECT_EQ(stolen.scheduler, 4);
}

TEST(TickAccount, ManyTicksALittleTooLongAddUp) {
    AccountedTicks clock;
    for (int i = 0; i < 30; ++i) clock.tick(1100 * account_us, 1100 * account_us);
    EXPECT_EQ(clock.program, 21);  // a period behind from the tenth tick
    EXPECT_EQ(clock.scheduler, 0);
}

TEST(TickAccount, OwnDelayIsForgottenOnceCaughtUp) {
    AccountedTicks clock;
    clock.tick(2500 * account_us, 2500 * account_us);
    clock.quick_ticks(5);
    EXPECT_EQ(clock.tick(2500 * account_us, 20 * account_us), Lateness::by_scheduler);
    EXPECT_EQ(clock.program, 1);
}

TEST(TickAccount, NoDelayIsLeftAfterTheDeadlineWasMoved) {
    AccountedTicks clock;
    clock.tick(30000 * account_us, 30000 * account_us);
    clock.account.clock_moved();
    clock.late = 0;
    EXPECT_EQ(clock.tick(2500 * account_us, 20 * account_us), Lateness::by_scheduler);
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
}  // namespace fulcrum
