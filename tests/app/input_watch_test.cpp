// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/input_watch.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <QtTest>

namespace fulcrum::app::program_test {
namespace {

TEST(InputWatch, CountsKeysAndClicksOnceAndNotWhatAnotherDeviceHolds) {
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* edit = new QLineEdit;
    auto* button = new QPushButton;
    layout->addWidget(edit);
    layout->addWidget(button);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    InputWatch watch;
    QTest::mouseClick(edit, Qt::LeftButton);
    QTest::keyClicks(edit, "tara's");
    EXPECT_EQ(edit->text(), "tara's");
    EXPECT_EQ(watch.presses(), 7);
    // The edit does nothing with it and passes it on to the window.
    QTest::keyClick(edit, Qt::Key_F5);
    EXPECT_EQ(watch.presses(), 8);
    QTest::mouseClick(button, Qt::RightButton);
    EXPECT_EQ(watch.presses(), 9);
    watch.hold(3, true);
    EXPECT_EQ(watch.presses(), 9);
    watch.hold(3, false);
    watch.restart();
    EXPECT_EQ(watch.presses(), 0);
    EXPECT_EQ(watch.most_held(), 0);
}

TEST(InputWatch, SaysHowManyAreHeldAtTheSameTimeAndForHowLong) {
    QPushButton button;
    button.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&button));
    InputWatch watch;
    QTest::keyPress(&button, Qt::Key_B);
    QTest::keyPress(&button, Qt::Key_B);
    EXPECT_EQ(watch.most_held(), 1) << "pressed again, but never let go";
    QTest::keyPress(&button, Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_EQ(watch.most_held(), 3) << "with Shift";
    watch.restart();
    EXPECT_EQ(watch.most_held(), 0);
    QTest::keyPress(&button, Qt::Key_B);
    QTest::keyPress(&button, Qt::Key_Left, Qt::ShiftModifier);
    watch.hold(1, true);
    QTest::qWait(60);
    watch.hold(1, false);
    QTest::keyRelease(&button, Qt::Key_Left);
    QTest::keyRelease(&button, Qt::Key_B);
    QTest::qWait(30);
    EXPECT_EQ(watch.most_held(), 4);
    EXPECT_GT(watch.share_above(2), 0.05);
    EXPECT_LT(watch.share_above(2), 1);
    EXPECT_EQ(watch.share_above(4), 0);
}

TEST(InputWatch, LeavesTheButtonsOfTwoMiceToTheTest) {
    QPushButton button;
    button.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&button));
    InputWatch watch(InputWatch::MouseButtons::of_hold);
    QTest::mouseClick(&button, Qt::LeftButton);
    EXPECT_EQ(watch.presses(), 0);
    EXPECT_EQ(watch.most_held(), 0);
}

}  // namespace
}  // namespace fulcrum::app::program_test
