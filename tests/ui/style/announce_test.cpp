// SPDX-License-Identifier: GPL-3.0-or-later
// What appears by itself is announced to a screen reader: each message once, none behind the lock.
#include "ui/style/announce.h"

#include <gtest/gtest.h>

#include <QLabel>

#include "tests/ui/heard.h"
#include "tests/ui/screens.h"
#include "ui/shell/idle_watch.h"

namespace fulcrum::ui::window_test {
namespace {

class Announced : public Screens {
  protected:
    QStringList heard_since() {
        const QStringList now = Heard::lines();
        Heard::lines().clear();
        return now;
    }
    const Heard heard;
};

TEST_F(Announced, EachMessageOnce) {
    open({1280, 800});
    sign_in(Role::administrator);
    Heard::lines().clear();
    window->context().complain("The disk is full.\nFree some space.");
    EXPECT_EQ(heard_since(), QStringList{"The disk is full. Free some space."});
    window->context().complain("The disk is full.\nFree some space.");
    EXPECT_EQ(heard_since().size(), 1) << "it happened again";
    window->context().say("Saved.");
    settle();
    EXPECT_EQ(heard_since(), QStringList{"Saved."});
}

TEST_F(Announced, NothingBehindTheLockUntilItIsUnlocked) {
    open({1280, 800});
    sign_in(Role::administrator);
    Heard::lines().clear();
    QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock");
    ASSERT_TRUE(sees(*window, "unlock_password"));
    window->context().complain("The report of Tara was not written.");
    EXPECT_EQ(heard_since(), QStringList());
    type(*window, "unlock_password", "correct horse");
    click(*window, "unlock");
    ASSERT_TRUE(wait_for([&] { return !sees(*window, "unlock_password"); }));
    settle();
    EXPECT_EQ(heard_since(), QStringList{"The report of Tara was not written."});
}

TEST_F(Announced, AProblemAtItsField) {
    open({1280, 800});
    Heard::lines().clear();
    click(*window, "sign_in");
    EXPECT_EQ(heard_since(), QStringList{"Enter your login and your password."});
    EXPECT_EQ(find<QLabel>(*window, "sign_in_problem")->text(), "Enter your login and your password.");
}

TEST_F(Announced, WhatIsLookedAtAgainAndAgainOnlyWhereItChanges) {
    QLabel label;
    announce_change(&label, "The device is lost.");
    EXPECT_EQ(heard_since(), QStringList()) << "nobody sees it";
    label.show();
    announce_change(&label, "The device is lost.");
    EXPECT_EQ(heard_since(), QStringList()) << "the same words";
    for (int i = 0; i < 3; ++i) announce_change(&label, "The device does not answer.");
    EXPECT_EQ(heard_since(), QStringList{"The device does not answer."});
    announce_change(&label, {});
    EXPECT_EQ(heard_since(), QStringList());
}

}  // namespace
}  // namespace fulcrum::ui::window_test
