// SPDX-License-Identifier: GPL-3.0-or-later
// The window by keyboard alone and with a screen reader: no key that is held, or pressed once too often, does
// what cannot be undone; the keyboard is never lost; every control has a name.
#include <gtest/gtest.h>

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>

#include "database/records/people.h"
#include "database/schedules/schedules.h"
#include "tests/database/station_keys.h"
#include "tests/ui/heard.h"
#include "tests/ui/screens.h"
#include "ui/page/background_job.h"
#include "ui/shell/idle_watch.h"

namespace fulcrum::ui::window_test {
namespace {

class Keyboard : public Screens {
  protected:
    void open_page(Role role, const char* rail) {
        open({1280, 800});
        ASSERT_TRUE(become_active(*window));
        sign_in(role);
        go_to(rail);
    }
    QString focused() { return window->focusWidget() == nullptr ? "" : window->focusWidget()->objectName(); }
    void press(Qt::Key key) { QTest::keyClick(window->focusWidget(), key); }
    /// For some repetitions, each of which goes to what has the focus by then.
    void hold(Qt::Key key) {
        for (int i = 0; i < 8; ++i) {
            QKeyEvent down(QEvent::KeyPress, key, Qt::NoModifier, QString(), i > 0);
            QApplication::sendEvent(window->focusWidget(), &down);
        }
        QKeyEvent up(QEvent::KeyRelease, key, Qt::NoModifier);
        QApplication::sendEvent(window->focusWidget(), &up);
        settle();
    }
    bool knows(const std::string& login) {
        const auto all = database::People(*services.store()).list(sessions.at(Role::administrator));
        return std::any_of(all.begin(), all.end(),
                           [&](const database::Person& one) { return one.login == login; });
    }
    const database::test::KeysOfOneTest own_keys;
};

TEST_F(Keyboard, AHeldKeyErasesNobodyAndTwoDeliberateOnesDo) {
    open_page(Role::director, "rail_data");
    auto* people = find<QComboBox>(*window, "data_person");
    people->setCurrentIndex(people->findText("Tara", Qt::MatchStartsWith));
    settle();
    bring(*find<QLineEdit>(*window, "erase_reason"));
    type(*window, "erase_reason", "asked for it");
    press(Qt::Key_Return);
    EXPECT_FALSE(sees(*window, "erase_person_sure")) << "Enter in the reason does nothing";
    press(Qt::Key_Tab);
    ASSERT_EQ(focused(), "erase_person");
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space}) {
        hold(key);
        ASSERT_TRUE(sees(*window, "erase_person_sure")) << key;
        EXPECT_EQ(focused(), "erase_person") << "not the button that erases";
        EXPECT_TRUE(knows("tara")) << key;
        press(Qt::Key_Escape);
        EXPECT_FALSE(sees(*window, "erase_person_sure")) << "Escape takes it back";
    }
    press(Qt::Key_Return);
    press(Qt::Key_Tab);
    ASSERT_EQ(focused(), "erase_person_sure");
    press(Qt::Key_Return);
    EXPECT_TRUE(wait_for([&] { return !knows("tara"); }));
    settle();
    EXPECT_EQ(focused(), "data_person") << "not the next button";
}

TEST_F(Keyboard, AHeldKeyOpensABriefingAndStartsNoAttempt) {
    open_page(Role::trainee, "rail_home");
    emit window->context().progress_wanted(text(sessions.at(Role::trainee).person_id()), "A2");
    settle();
    find<QAbstractButton>(*window, "task_briefing")->setFocus();
    hold(Qt::Key_Return);
    EXPECT_EQ(window->current_page()->objectName(), "briefing_page");
    EXPECT_EQ(focused(), "start_attempt");
}

TEST_F(Keyboard, EnterLeadsThroughAFormAndPressesItsButtonOnlyThere) {
    open_page(Role::trainee, "rail_password");
    ASSERT_EQ(focused(), "old_password");
    const std::pair<const char*, const char*> steps[] = {{"a long password", "new_password"},
                                                         {"another long one", "new_password_again"},
                                                         {"another long one", "password_change"}};
    for (const auto& [words, next] : steps) {
        QTest::keyClicks(window->focusWidget(), words);
        press(Qt::Key_Return);
        EXPECT_EQ(focused(), next);
    }
    EXPECT_TRUE(window->findChildren<BackgroundJob*>().isEmpty()) << "nothing was changed yet";
    press(Qt::Key_Return);
    settle();
    EXPECT_TRUE(error_shown().isEmpty());
    EXPECT_NE(window->current_page()->objectName(), "password_page") << "changed";
}

TEST_F(Keyboard, EnterInAPathWritesNothing) {
    open_page(Role::director, "rail_cohort");
    QTemporaryDir folder;
    const QString file = folder.filePath("cohort.json");
    type(*window, "export_path", file);
    press(Qt::Key_Return);
    settle();
    EXPECT_FALSE(QFile::exists(file));
    find<QAbstractButton>(*window, "export_cohort")->setFocus();
    press(Qt::Key_Return);
    settle();
    EXPECT_TRUE(wait_for([&] { return QFile::exists(file); }));
}

TEST_F(Keyboard, RemovingAScheduleLeavesTheOthersAlone) {
    open_page(Role::director, "rail_cohort");
    const database::Schedules schedules(*services.store());
    const database::Session& dora = sessions.at(Role::director);
    QTemporaryDir folder;
    for (const char* format : {"csv", "json", "pdf"}) {
        database::ReportSchedule one;
        one.cohort_id = database::People(*services.store()).cohorts(dora).front().id;
        one.format = format;
        one.folder = plain(folder.path());
        schedules.add(dora, one);
    }
    go_to("rail_schedules");
    find<QAbstractButton>(*window, "schedules_remove")->setFocus();
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Space}) {
        hold(key);
        EXPECT_TRUE(sees(*window, "schedules_remove_sure")) << key;
        EXPECT_EQ(focused(), "schedules_remove") << "not the button that removes";
        EXPECT_EQ(schedules.list(dora).size(), 3U) << key;
        press(Qt::Key_Escape);
        EXPECT_FALSE(sees(*window, "schedules_remove_sure")) << key;
    }
    press(Qt::Key_Return);
    press(Qt::Key_Tab);
    ASSERT_EQ(focused(), "schedules_remove_sure");
    hold(Qt::Key_Return);
    settle();
    EXPECT_EQ(schedules.list(dora).size(), 2U);
    EXPECT_FALSE(sees(*window, "schedules_remove_sure"));
    EXPECT_EQ(focused(), "schedules_table");
}

TEST_F(Keyboard, IsWhereItWasAfterTheLock) {
    open_page(Role::administrator, "rail_people");
    find<QLineEdit>(*window, "new_person_login")->setFocus();
    QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock");
    type(*window, "unlock_password", "correct horse");
    click(*window, "unlock");
    ASSERT_TRUE(wait_for([&] { return !sees(*window, "unlock_password"); }));
    settle();
    EXPECT_EQ(focused(), "new_person_login");
}

TEST_F(Keyboard, ATipIsShownWhereTabLeads) {
    open_page(Role::trainee, "rail_home");
    emit window->context().briefing_wanted("A2");
    settle();
    find<QAbstractButton>(*window, "start_attempt")->setFocus();
    press(Qt::Key_Tab);
    ASSERT_EQ(focused(), "watch_demonstration");
    const QString tip = window->focusWidget()->toolTip();
    ASSERT_FALSE(tip.isEmpty());
    EXPECT_TRUE(wait_for([&] { return QToolTip::isVisible() && QToolTip::text() == tip; }, 5000));
    press(Qt::Key_Tab);
    EXPECT_TRUE(wait_for([&] { return !QToolTip::isVisible() || QToolTip::text() != tip; }, 5000));
}

TEST_F(Keyboard, AButtonIsReadAsItReadsNow) {
    open_page(Role::director, "rail_cohort");
    QTemporaryDir folder;
    auto* save = find<QPushButton>(*window, "export_cohort");
    EXPECT_EQ(spoken_name(save), save->text());
    QFile file(folder.filePath("cohort.json"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    type(*window, "export_path", file.fileName());
    EXPECT_EQ(save->text(), "Replace report");
    EXPECT_EQ(spoken_name(save), "Replace report") << "what it does";
    // Without the sign that stands in front.
    sign_in(Role::trainee);
    emit window->context().briefing_wanted("A2");
    settle();
    EXPECT_EQ(spoken_name(find<QPushButton>(*window, "briefing_back")), "Home");
}

TEST_F(Keyboard, AChoiceIsReadWithItsName) {
    open_page(Role::educator, "rail_attempts");
    auto* task = find<QComboBox>(*window, "filter_task");
    task->setFocus();
    EXPECT_EQ(task->accessibleDescription(), "Task");
}

/// A choice is read with its label or its description: Qt takes its line for its name.
bool has_spoken_name(QWidget* control) {
    if (const auto* box = qobject_cast<QComboBox*>(control);
        box != nullptr && box->accessibleName().isEmpty()) {
        for (const QLabel* label :
             box->parentWidget()->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
            if (label->buddy() == box) return true;
        return false;
    }
    return !spoken_name(control).trimmed().isEmpty() || !control->accessibleName().isEmpty();
}

bool is_control(const QWidget* widget) {
    return qobject_cast<const QAbstractButton*>(widget) != nullptr ||
           qobject_cast<const QLineEdit*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
           qobject_cast<const QAbstractItemView*>(widget) != nullptr ||
           qobject_cast<const QPlainTextEdit*>(widget) != nullptr ||
           (qobject_cast<const QAbstractSlider*>(widget) != nullptr &&
            qobject_cast<const QScrollBar*>(widget) == nullptr);
}

TEST_F(Keyboard, EveryControlOfEveryScreenHasAName) {
    open({1280, 800});
    const std::string attempt = perform();
    int seen = 0;
    visit(attempt, [&](const QString& screen) {
        for (QWidget* one : window->findChildren<QWidget*>()) {
            const bool reached =
                one->isVisible() && one->focusPolicy() != Qt::NoFocus && one->focusProxy() == nullptr;
            if (!reached || !is_control(one)) continue;
            ++seen;
            EXPECT_TRUE(has_spoken_name(one))
                << screen.toStdString() << ": " << one->metaObject()->className() << ' '
                << one->objectName().toStdString();
        }
    });
    EXPECT_GT(seen, 300);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
