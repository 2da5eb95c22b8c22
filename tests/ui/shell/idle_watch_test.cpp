// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/idle_watch.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QSignalSpy>
#include <QWidget>

#include "tests/support/clock_ahead.h"
#include "tests/ui/hands.h"

namespace fulcrum::ui::window_test {
namespace {

constexpr int minute_ms = 60'000;

void press_a_key() {
    QWidget somewhere;
    QKeyEvent press(QEvent::KeyPress, Qt::Key_A, Qt::NoModifier);
    QCoreApplication::sendEvent(&somewhere, &press);
}

TEST(IdleWatch, TheSleepOfTheMachineIsTimeWithoutInput) {
    if (!fulcrum::test::clocks_can_be_set) GTEST_SKIP() << "a sanitizer owns the clocks";
    IdleWatch watch(nullptr, minute_ms, minute_ms);
    QSignalSpy locked(&watch, &IdleWatch::lock), closed(&watch, &IdleWatch::close_attempt);
    watch.set_active(true);
    QTest::qWait(1200);  // it has looked
    EXPECT_EQ(locked.count(), 0);
    const fulcrum::test::ClockAhead slept(CLOCK_BOOTTIME, 61);
    press_a_key();  // of the person who opens the lid
    EXPECT_TRUE(wait_for([&] { return locked.count() == 1; }, 5000));
    EXPECT_EQ(closed.count(), 0);
    const fulcrum::test::ClockAhead slept_again(CLOCK_BOOTTIME, 61);
    EXPECT_TRUE(wait_for([&] { return closed.count() == 1; }, 5000));
    watch.unlocked();
    QTest::qWait(1200);
    EXPECT_FALSE(watch.locked());
    EXPECT_EQ(locked.count(), 1);
}

TEST(IdleWatch, InputKeepsTheWindowOpen) {
    if (!fulcrum::test::clocks_can_be_set) GTEST_SKIP() << "a sanitizer owns the clocks";
    IdleWatch watch(nullptr, minute_ms, minute_ms);
    QSignalSpy locked(&watch, &IdleWatch::lock);
    watch.set_active(true);
    const fulcrum::test::ClockAhead passed(CLOCK_BOOTTIME, 40);
    press_a_key();
    const fulcrum::test::ClockAhead passed_again(CLOCK_BOOTTIME, 40);
    QTest::qWait(1200);
    EXPECT_EQ(locked.count(), 0);
    watch.lock_after(minute_ms / 2);
    const fulcrum::test::ClockAhead shorter(CLOCK_BOOTTIME, 31);
    EXPECT_TRUE(wait_for([&] { return locked.count() == 1; }, 5000));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
