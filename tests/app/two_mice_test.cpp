// SPDX-License-Identifier: GPL-3.0-or-later
// Two mice through the X server: each moves its own hand.
#include <gtest/gtest.h>

#include <QRadioButton>
#include <algorithm>
#include <cstdlib>

#include "sim_core/numerics/input_error.h"
#include "tests/app/virtual_mice.h"
#include "tests/app/window_fixture.h"
#include "ui/theatre/two_mice.h"

namespace fulcrum::app::program_test {
namespace {

using ui::AttemptPhase;
using ui::MouseMotion;
using ui::TwoMice;
using ui::window_test::keep_picture;
using ui::window_test::sees;
using ui::window_test::wait_for;

/// Adds up what arrives until the condition holds.
bool read_until(TwoMice& mice, MouseMotion (&sum)[2], const std::function<bool()>& holds) {
    return wait_for(
        [&] {
            MouseMotion now[2];
            mice.read(now);
            for (int h = 0; h < 2; ++h) {
                const MouseMotion before = sum[h];
                sum[h] = now[h];
                sum[h].right += before.right;
                sum[h].down += before.down;
                sum[h].notches += before.notches;
                sum[h].turned_notches += before.turned_notches;
                sum[h].held_right += before.held_right;
                sum[h].held_down += before.held_down;
            }
            return holds();
        },
        5000);
}

TEST(TwoMiceOfTheServer, EachIsReadByItself) {
    VirtualMice hands;
    const auto mice = TwoMice::open(true);
    EXPECT_NE(mice->mouse(0).id, mice->mouse(1).id);
    MouseMotion sum[2];
    hands.move(0, 30, -10);
    hands.move(1, -7, 5);
    hands.wheel(1, 2);
    hands.button(0, 1, true);
    hands.button(1, 3, true);
    hands.wheel(1, -3);
    hands.move(1, 2, -6);
    hands.button(1, 3, false);
    hands.button(1, 2, true);
    ASSERT_TRUE(read_until(*mice, sum, [&] { return sum[1].middle_button && sum[0].left_button; }));
    EXPECT_EQ(sum[0].right, 30);
    EXPECT_EQ(sum[0].down, -10);
    EXPECT_EQ(sum[0].notches, 0);
    EXPECT_EQ(sum[1].right, -7);
    EXPECT_EQ(sum[1].down, 5);
    EXPECT_EQ(sum[1].notches, 2);
    EXPECT_EQ(sum[1].turned_notches, -3);
    EXPECT_EQ(sum[1].held_right, 2);
    EXPECT_EQ(sum[1].held_down, -6);
    EXPECT_FALSE(sum[1].left_button);
    mice->swap();
    sum[0] = sum[1] = {};
    hands.move(0, 4, 0);
    ASSERT_TRUE(read_until(*mice, sum, [&] { return sum[1].right != 0; }));
    EXPECT_EQ(sum[1].right, 4);
    EXPECT_EQ(sum[0].right, 0);
    hands.button(0, 1, false);
    hands.button(1, 2, false);
}

TEST(TwoMiceOfTheServer, AMouseThatIsUnpluggedIsReportedAndFoundAgain) {
    VirtualMice hands;
    const auto mice = TwoMice::open(true);
    MouseMotion sum[2];
    hands.button(1, 1, true);
    ASSERT_TRUE(read_until(*mice, sum, [&] { return sum[1].left_button; }));
    hands.unplug_second();
    ASSERT_TRUE(read_until(*mice, sum, [&] { return !sum[1].connected; }));
    EXPECT_TRUE(sum[0].connected);
    EXPECT_FALSE(sum[1].left_button) << "nothing stays held";
    hands.plug_in_second();
    ASSERT_TRUE(read_until(*mice, sum, [&] { return sum[1].connected; }));
    sum[1] = {};
    hands.move(1, 9, 0);
    ASSERT_TRUE(read_until(*mice, sum, [&] { return sum[1].right == 9; }));
}

TEST(TwoMiceOfTheServer, OneMouseIsNotEnough) {
    EXPECT_THROW(TwoMice::open(true), InputError);
}

struct UsesTwoMice {
    UsesTwoMice() { setenv("FULCRUM_DEVICE", "two-mice:virtual", 1); }
    ~UsesTwoMice() { unsetenv("FULCRUM_DEVICE"); }
    VirtualMice hands;
};
class TwoMiceWindow : public UsesTwoMice, public Window {};

TEST_F(TwoMiceWindow, EachMouseMovesItsHandAtTheSameTimeAndAnUnpluggedOnePauses) {
    window.resize(1024, 768);
    create_programme_and_trainee();
    start("A2", false);
    keep_picture(window, "50-two-mice");
    const auto& targets = [this]() -> const ui::HandTargets& { return theatre().input()->targets(); };
    const ui::HandTargets before = targets();
    hands.move(0, 20, 0);
    hands.move(1, -20, 0);
    ASSERT_TRUE(wait_for([&] {
        return (targets().hand[0].handle - before.hand[0].handle).norm() > 5e-3 &&
               (targets().hand[1].handle - before.hand[1].handle).norm() > 5e-3;
    }));
    const double in_before = targets().hand[0].handle.norm();
    hands.wheel(0, 2);
    ASSERT_TRUE(wait_for([&] { return targets().hand[0].handle.norm() < in_before - 7e-3; })) << "8 mm in";
    const ui::HandTargets in_now = targets();
    hands.button(0, 3, true);
    hands.move(0, 1, 10);
    ASSERT_TRUE(wait_for([&] {
        return targets().hand[0].handle.norm() > in_now.hand[0].handle.norm() + 3e-3;
    })) << "3.5 mm out";
    hands.move(0, 50, 3);
    ASSERT_TRUE(wait_for([&] { return targets().hand[0].roll > in_now.hand[0].roll + 0.3; })) << "turned";
    hands.button(0, 3, false);
    EXPECT_LT(targets().hand[0].handle.normalized().cross(in_now.hand[0].handle.normalized()).norm(), 1e-9)
        << "the handle does not move across";
    hands.button(1, 1, true);
    ASSERT_TRUE(wait_for([&] { return targets().hand[1].jaw == 0; }));
    EXPECT_GT(targets().hand[0].jaw, 0) << "the other hand's jaws stay open";
    hands.button(1, 1, false);
    ASSERT_TRUE(wait_for([&] { return targets().hand[1].jaw > 0; }));
    QTest::keyClick(theatre().view(), Qt::Key_F1);
    keep_picture(window, "51-two-mice-help");
    QTest::keyClick(theatre().view(), Qt::Key_F1);

    hands.unplug_second();
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::device_lost; }));
    ASSERT_TRUE(wait_for([&] { return sees(window, "theatre_panel"); }));
    hands.plug_in_second();
    ASSERT_TRUE(wait_for([&] { return aligned().in_place; }));
    QTest::keyClick(theatre().view(), Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }));
    abandon();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_EQ(attempt.meta.device, "two mice and keyboard");
    EXPECT_EQ(attempt.meta.device_class, DeviceClass::mouse_keyboard);
    EXPECT_FALSE(attempt.meta.limits.empty()) << "those of one mouse";
    EXPECT_TRUE(shown("debrief_notes").contains("two mice, for which no limits exist: it is compared with"))
        << shown("debrief_notes").toStdString();
    EXPECT_TRUE(shown("debrief_notes").contains("Force was not felt"))
        << shown("debrief_notes").toStdString();
    expect_replays(attempt.meta.id);
}

TEST_F(TwoMiceWindow, AreForPracticeOnlyAndTheBriefingSaysWhatTheScoreIsComparedWith) {
    create_programme_and_trainee();
    EXPECT_EQ(services.device_in_use().device_class, DeviceClass::mouse_keyboard);
    ui::window_test::click(window, "briefing_A2");
    expect_page("briefing_page");
    EXPECT_FALSE(ui::window_test::find<QRadioButton>(window, "mode_assessed")->isEnabled());
    for (const char* words : {"One mouse for each hand: practice only.", "No limits exist for two mice",
                              "compared with those of mouse and keyboard, where the task has them"})
        EXPECT_TRUE(shown("mode_note").contains(words)) << shown("mode_note").toStdString();
    const auto limits = services.judged_limits(window.context().session(), "A2",
                                               services.device_in_use().device_class, "standard");
    EXPECT_TRUE(std::any_of(limits.begin(), limits.end(), [](const JudgedLimit& one) { return one.of_set; }));
    // The button is not the only guard.
    emit window.context().attempt_wanted(QStringLiteral("A2"), true, 0, false);
    ASSERT_TRUE(wait_for([&] { return sees(window, "message_text"); }));
    EXPECT_TRUE(shown("message_text").contains("this device is for practice only"))
        << shown("message_text").toStdString();
    expect_page("briefing_page");
}

}  // namespace
}  // namespace fulcrum::app::program_test
