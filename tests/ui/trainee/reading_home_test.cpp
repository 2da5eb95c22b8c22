// SPDX-License-Identifier: GPL-3.0-or-later
// The pages about a trainee's own attempts: the window answers while they are read, and who uses the keyboard
// keeps it.
#include <QComboBox>
#include <QPushButton>

#include "database/rows/connection.h"
#include "tests/ui/held_work.h"
#include "tests/ui/screens.h"
#include "ui/language/language.h"
#include "ui/shell/idle_watch.h"

namespace fulcrum::ui::window_test {
namespace {

class ReadingHome : public Screens {
  protected:
    ~ReadingHome() override { use_language(Language::english); }
    /// At home, which is not read yet.
    void sign_in_now() {
        window->context().set_session(sessions.at(Role::trainee));
        QCoreApplication::processEvents();
        ASSERT_EQ(window->current_page()->objectName(), "home_page");
    }
    void activate() { ASSERT_TRUE(become_active(*window)); }
    QString used() {
        return window->focusWidget() == nullptr ? QString() : window->focusWidget()->objectName();
    }
    void lock() {
        QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock");
        ASSERT_TRUE(sees(*window, "unlock_password"));
    }
    void unlock() {
        type(*window, "unlock_password", "a long password");
        click(*window, "unlock");
        ASSERT_TRUE(wait_for([&] { return !sees(*window, "unlock_password"); }));
    }
};

TEST_F(ReadingHome, WhatIsRecommendedAppearsWhenItIsReadAndHasTheKeyboard) {
    open(QSize(1280, 800));
    activate();
    HeldWork held;
    sign_in_now();
    EXPECT_EQ(find<QLabel>(*window, "home_reading")->text(), "Reading your attempts …");
    EXPECT_FALSE(sees(*window, "next_briefing"));
    EXPECT_FALSE(sees(*window, "briefing_A2"));
    held.release();
    settle();
    EXPECT_FALSE(sees(*window, "home_reading"));
    EXPECT_TRUE(sees(*window, "briefing_A2"));
    EXPECT_EQ(used(), "next_briefing");
}

TEST_F(ReadingHome, StaysAsItWasUntilItIsReadAgain) {
    open(QSize(1280, 800));
    sign_in(Role::trainee);
    activate();
    HeldWork held;
    go_to_now("rail_home");
    EXPECT_TRUE(sees(*window, "next_briefing"));
    EXPECT_FALSE(sees(*window, "home_reading"));
    find<QPushButton>(*window, "briefing_A2")->setFocus();
    held.release();
    settle();
    EXPECT_EQ(used(), "briefing_A2");
}

TEST_F(ReadingHome, ABriefingShowsItsLimitsBeforeOnesLastValues) {
    open(QSize(1280, 800));
    perform();
    HeldWork held;
    emit window->context().briefing_wanted("A2");
    QCoreApplication::processEvents();
    EXPECT_TRUE(sees(*window, "judged_bars"));
    EXPECT_TRUE(find<QPushButton>(*window, "start_attempt")->isEnabled());
    click(*window, "judged_list_toggle");
    held.release();
    settle();
    EXPECT_TRUE(sees(*window, "judged_list")) << "what was chosen while it was read";
    HeldWork again;
    emit window->context().briefing_wanted("A2");
    window->context().sign_out();
    again.release();
    settle();
    EXPECT_TRUE(error_shown().isEmpty()) << error_shown().toStdString();
}

TEST_F(ReadingHome, EndsWithThePageTheSessionAndTheLanguage) {
    open(QSize(1280, 800));
    {
        HeldWork held;
        sign_in_now();
        go_to_now("rail_settings");
        go_to_now("rail_home");
        window->set_theme(Theme::dark);
        window->set_theme(Theme::light);
        window->set_language(Language::german);
        window->context().sign_out();
        held.release();
        settle();
        EXPECT_TRUE(error_shown().isEmpty()) << error_shown().toStdString();
        window->set_language(Language::english);
    }
    HeldWork held;
    sign_in_now();
    QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock");
    ASSERT_TRUE(sees(*window, "unlock_password"));
    QWidget* const locked = window->focusWidget();
    held.release();
    settle();
    EXPECT_EQ(window->focusWidget(), locked) << "not by what was read behind the lock";
    EXPECT_NE(window->findChild<QPushButton*>("next_briefing"), nullptr);
}

TEST_F(ReadingHome, ThatFailsLeavesNoTasksAndCanBeTriedAgain) {
    open(QSize(1280, 800));
    sign_in(Role::trainee);
    activate();
    ASSERT_TRUE(sees(*window, "briefing_A2"));
    services.store()->connection().execute("ALTER TABLE comment RENAME TO comment_away");
    go_to("rail_home");
    for (const char* old : {"briefing_A2", "next_briefing", "next_reason", "home_reading"})
        EXPECT_FALSE(sees(*window, old)) << old;
    EXPECT_TRUE(find<QLabel>(*window, "home_failed")->text().startsWith("Your attempts could not be read: "));
    EXPECT_EQ(used(), "home_again");
    {
        HeldWork held;
        QTest::keyClick(window->focusWidget(), Qt::Key_Return);
        QCoreApplication::processEvents();
        EXPECT_TRUE(sees(*window, "home_reading"));
        EXPECT_FALSE(sees(*window, "home_failed"));
        held.release();
        settle();
    }
    EXPECT_TRUE(sees(*window, "home_failed")) << "it fails again";
    EXPECT_EQ(used(), "home_again");
    lock();
    unlock();
    EXPECT_EQ(used(), "home_again");
    services.store()->connection().execute("ALTER TABLE comment_away RENAME TO comment");
    QTest::keyClick(window->focusWidget(), Qt::Key_Return);
    settle();
    EXPECT_FALSE(sees(*window, "home_failed"));
    EXPECT_TRUE(sees(*window, "briefing_A2"));
    EXPECT_EQ(used(), "next_briefing");
}

TEST_F(ReadingHome, BehindALockTheKeyboardComesBackToWhatReplacesItsControl) {
    open(QSize(1280, 800));
    activate();
    {
        HeldWork held;
        sign_in_now();
        lock();
        held.release();
        settle();
    }
    unlock();
    EXPECT_EQ(used(), "next_briefing") << "nothing of the page had the keyboard";
    {
        HeldWork held;
        go_to_now("rail_home");
        find<QPushButton>(*window, "briefing_A2")->setFocus();
        lock();
        held.release();
        settle();
    }
    unlock();
    EXPECT_EQ(used(), "briefing_A2");
    lock();
    unlock();
    EXPECT_EQ(used(), "briefing_A2");
    window->context().sign_out();
    HeldWork held;
    sign_in_now();
    lock();
    QMetaObject::invokeMethod(window->findChild<QWidget*>("lock_page"), "unlocked");
    ASSERT_FALSE(sees(*window, "unlock_password"));
    held.release();
    settle();
    EXPECT_EQ(used(), "next_briefing") << "read after the lock";
}

TEST_F(ReadingHome, InterruptedAttemptsThatAreScoredBehindTheLockLeaveItTheKeyboard) {
    open(QSize(1280, 800));
    sign_in(Role::trainee);
    activate();
    ASSERT_TRUE(sees(*window, "next_briefing"));
    lock();
    emit window->context().interrupted_scored();
    EXPECT_EQ(used(), "unlock_password");
    settle();
    EXPECT_EQ(used(), "unlock_password");
}

TEST_F(ReadingHome, InterruptedAttemptsThatAreScoredLeaveAGoalThatIsBeingSet) {
    open(QSize(1280, 800));
    sign_in(Role::trainee);
    activate();
    click(*window, "set_goal");
    ASSERT_TRUE(sees(*window, "goal_kind"));
    EXPECT_EQ(used(), "goal_kind");
    emit window->context().interrupted_scored();
    settle();
    EXPECT_TRUE(sees(*window, "goal_kind"));
    EXPECT_EQ(used(), "goal_kind");
    find<QPushButton>(*window, "briefing_A2")->setFocus();
    emit window->context().interrupted_scored();
    settle();
    EXPECT_EQ(used(), "briefing_A2") << "the keyboard stays, too";
}

TEST_F(ReadingHome, ProgressIsReadInTheBackgroundAndTheMetricStaysChosen) {
    open(QSize(1280, 800));
    perform();
    HeldWork held;
    go_to_now("rail_progress");
    auto* task = find<QComboBox>(*window, "progress_task");
    ASSERT_EQ(task->currentData().toString(), "A2") << "of the newest attempt";
    auto* table = find<QTableWidget>(*window, "progress_table");
    EXPECT_EQ(table->rowCount(), 0);
    EXPECT_EQ(find<QLabel>(*window, "progress_summary")->text(), "Reading the attempts …");
    const auto choose = [&](QComboBox* box, const QString& data) {
        box->setCurrentIndex(box->findData(data));
        emit box->activated(box->currentIndex());
    };
    choose(task, "B1");
    choose(task, "A2");
    held.release();
    settle();
    EXPECT_EQ(table->rowCount(), 1) << "of the task that was chosen last";
    auto* metric = find<QComboBox>(*window, "progress_metric");
    ASSERT_GT(metric->count(), 1);
    const QString other = metric->itemData(1).toString();
    choose(metric, other);
    choose(task, "B1");
    settle();
    EXPECT_EQ(table->rowCount(), 0);
    choose(task, "A2");
    settle();
    EXPECT_EQ(table->rowCount(), 1);
    EXPECT_EQ(metric->currentData().toString(), other);
    HeldWork again;
    go_to_now("rail_home");
    go_to_now("rail_progress");
    EXPECT_EQ(table->rowCount(), 1) << "until it is read again";
    window->context().sign_out();
    again.release();
    settle();
    EXPECT_TRUE(error_shown().isEmpty()) << error_shown().toStdString();
}

}  // namespace
}  // namespace fulcrum::ui::window_test
