// SPDX-License-Identifier: GPL-3.0-or-later
// Another text size or language while the window asks whether the pages may be made again: what the page
// shows is what the answer is about.
#include <QComboBox>
#include <QPushButton>
#include <QRadioButton>

#include "tests/ui/settings_screens.h"
#include "ui/shell/idle_watch.h"

namespace fulcrum::ui::window_test {
namespace {

class SettingsQuestion : public SettingsScreens {
  protected:
    /// With a person who is not added yet.
    void open_with_begun_input() {
        open({1280, 800});
        ASSERT_TRUE(become_active(*window));
        sign_in(Role::administrator);
        go_to("rail_people");
        type(*window, "new_person_name", "Nora New");
        go_to("rail_settings");
    }
    void step_size(Qt::Key key) { QTest::keyClick(find<QComboBox>(*window, "text_size"), key); }
    QString size_shown() { return find<QComboBox>(*window, "text_size")->currentText(); }
    bool german_shown() { return find<QRadioButton>(*window, "language_de")->isChecked(); }
    bool asks() {
        return sees(*window, "question_words") &&
               find<QLabel>(*window, "question_words")->text().contains("when the pages are made again");
    }
    void answer(const char* button) {
        click(*window, button);
        settle();
    }
};

TEST_F(SettingsQuestion, IsAboutTheSizeThatWasChosenLast) {
    open_with_begun_input();
    step_size(Qt::Key_Down);
    EXPECT_TRUE(asks());
    EXPECT_EQ(size_shown(), "125 %");
    step_size(Qt::Key_Down);
    EXPECT_TRUE(asks());
    EXPECT_EQ(size_shown(), "150 %") << "what the question is about";
    answer("question_no");
    EXPECT_EQ(size_shown(), "100 %");
    EXPECT_EQ(text_percent(), 100);
    step_size(Qt::Key_Down);
    step_size(Qt::Key_Down);
    answer("question_yes");
    EXPECT_EQ(text_percent(), 150);
    EXPECT_EQ(size_shown(), "150 %");
}

TEST_F(SettingsQuestion, IsAboutSizeAndLanguageWhereBothWereChosen) {
    open_with_begun_input();
    step_size(Qt::Key_Down);
    check(*window, "language_de");
    EXPECT_TRUE(asks());
    EXPECT_EQ(size_shown(), "125 %") << "the first choice is not lost";
    EXPECT_TRUE(german_shown());
    answer("question_no");
    EXPECT_EQ(size_shown(), "100 %");
    EXPECT_FALSE(german_shown());
    check(*window, "language_de");
    step_size(Qt::Key_Down);
    EXPECT_TRUE(german_shown());
    answer("question_yes");
    EXPECT_EQ(text_percent(), 125);
    EXPECT_EQ(language_in_use(), Language::german);
    EXPECT_EQ(size_shown(), "125 %");
    EXPECT_TRUE(german_shown());
}

TEST_F(SettingsQuestion, IsTakenBackWithTheChoice) {
    open_with_begun_input();
    step_size(Qt::Key_Down);
    step_size(Qt::Key_Up);
    EXPECT_FALSE(asks()) << "100 % is in use";
    check(*window, "language_de");
    EXPECT_TRUE(asks());
    check(*window, "language_en");
    EXPECT_FALSE(asks());
    EXPECT_EQ(text_percent(), 100);
    EXPECT_EQ(language_in_use(), Language::english);
    // Of two choices one is taken back.
    step_size(Qt::Key_Down);
    check(*window, "language_de");
    step_size(Qt::Key_Up);
    EXPECT_TRUE(asks());
    answer("question_yes");
    EXPECT_EQ(text_percent(), 100);
    EXPECT_EQ(language_in_use(), Language::german);
}

TEST_F(SettingsQuestion, AnotherThemeLeavesItAndTheChoice) {
    open_with_begun_input();
    step_size(Qt::Key_Down);
    check(*window, "theme_dark");
    EXPECT_EQ(current_theme(), Theme::dark);
    EXPECT_TRUE(asks());
    EXPECT_EQ(size_shown(), "125 %");
    go_to("rail_settings");  // the page again
    EXPECT_TRUE(asks());
    EXPECT_EQ(size_shown(), "125 %");
    answer("question_no");
    EXPECT_EQ(size_shown(), "100 %");
}

TEST_F(SettingsQuestion, EndsWithALockAnotherPageAndTheSession) {
    open_with_begun_input();
    step_size(Qt::Key_Down);
    QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock");
    EXPECT_FALSE(asks());
    type(*window, "unlock_password", "correct horse");
    click(*window, "unlock");
    ASSERT_TRUE(wait_for([&] { return !sees(*window, "unlock_password"); }));
    EXPECT_EQ(size_shown(), "100 %");
    step_size(Qt::Key_Down);
    go_to("rail_station");
    EXPECT_FALSE(asks());
    go_to("rail_settings");
    EXPECT_EQ(size_shown(), "100 %");
    step_size(Qt::Key_Down);
    click(*window, "switch_user");
    EXPECT_FALSE(asks()) << "another question";
    EXPECT_EQ(size_shown(), "100 %");
    answer("question_yes");
    EXPECT_FALSE(window->context().signed_in());
    EXPECT_EQ(text_percent(), 100);
    sign_in(Role::administrator);
    go_to("rail_settings");
    EXPECT_EQ(size_shown(), "100 %");
    check(*window, "language_de");
    settle();
    EXPECT_EQ(language_in_use(), Language::german) << "nothing is begun any longer";
    EXPECT_EQ(text_percent(), 100) << "of the session before";
}

}  // namespace
}  // namespace fulcrum::ui::window_test
