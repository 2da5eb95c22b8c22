// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody has begun ends neither with the window nor with a sign-out before the window has said what
// would be lost; the lock leaves it alone.
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>

#include "database/records/people.h"
#include "database/records/ratings.h"
#include "tests/ui/screens.h"
#include "ui/language/language.h"
#include "ui/shell/idle_watch.h"

namespace fulcrum::ui::window_test {
namespace {

class BegunInput : public Screens {
  protected:
    ~BegunInput() override {
        if (window != nullptr) window->set_language(Language::english);
        use_language(Language::english);
    }
    const OutlivesItsWindows outlives;
    void open_page(Role role, const char* rail) {
        open({1280, 800});
        ASSERT_TRUE(become_active(*window));
        sign_in(role);
        go_to(rail);
    }
    QString typed(const char* name) { return find<QLineEdit>(*window, name)->text(); }
    QString question() {
        return sees(*window, "question_words") ? find<QLabel>(*window, "question_words")->text() : QString();
    }
    QString focused() { return window->focusWidget() == nullptr ? "" : window->focusWidget()->objectName(); }
    void lock() { QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock"); }
    /// The trainee's attempt, in the educator's debrief.
    std::string open_debrief() {
        open({1280, 800});
        const std::string attempt = perform();
        sign_in(Role::educator);
        emit window->context().debrief_wanted(text(attempt), -1);
        wait_for_debrief();
        return attempt;
    }
};

TEST_F(BegunInput, IsNamedBeforeTheWindowCloses) {
    for (const Language language : {Language::english, Language::german}) {
        const bool german = language == Language::german;
        open_page(Role::administrator, "rail_people");
        window->set_language(language);
        go_to("rail_people");
        EXPECT_TRUE(question().isEmpty());
        type(*window, "new_person_name", "Nora New");
        EXPECT_FALSE(window->close());
        EXPECT_TRUE(window->isVisible());
        EXPECT_EQ(question(), german ? "Noch nicht gespeichert und verloren, wenn das Fenster schließt: "
                                       "eine Person, die noch nicht angelegt ist."
                                     : "Not saved yet, and lost when the window closes: a person who is not "
                                       "added yet.");
        EXPECT_EQ(focused(), "question_no") << "a key pressed once too often goes back";
        click(*window, "question_no");
        EXPECT_TRUE(question().isEmpty());
        EXPECT_EQ(focused(), "new_person_name") << "the keyboard is where it was";
        EXPECT_EQ(typed("new_person_name"), "Nora New");
        EXPECT_FALSE(window->close());
        QTest::keyClick(window->focusWidget(), Qt::Key_Escape);
        EXPECT_TRUE(question().isEmpty()) << "Escape goes back";
        EXPECT_FALSE(window->close());
        click(*window, "question_yes");
        EXPECT_FALSE(window->isVisible());
        window.reset();
    }
    // Nothing begun, nothing asked.
    open_page(Role::administrator, "rail_people");
    window->set_language(Language::english);
    go_to("rail_people");
    type(*window, "new_person_name", "   ");
    EXPECT_TRUE(window->close());
}

TEST_F(BegunInput, IsNamedBeforeASignOut) {
    open_page(Role::administrator, "rail_people");
    choose_row(*find<QTableWidget>(*window, "people_table"), 0);
    type(*window, "person_name", "Alma Another");
    go_to("rail_station");  // from another page, too
    click(*window, "switch_user");
    EXPECT_TRUE(window->context().signed_in());
    EXPECT_EQ(question(), "Not saved yet, and lost at the sign-out: changes to a person.");
    click(*window, "question_no");
    EXPECT_TRUE(window->context().signed_in());
    click(*window, "switch_user");
    click(*window, "question_yes");
    EXPECT_FALSE(window->context().signed_in());
    EXPECT_EQ(window->current_page()->objectName(), "sign_in_page");
    EXPECT_TRUE(question().isEmpty());
    EXPECT_NE(database::People(*services.store()).list(sessions.at(Role::administrator))[0].display_name,
              "Alma Another");
}

TEST_F(BegunInput, StaysUnderTheLockAndIsNamedThere) {
    open_page(Role::administrator, "rail_people");
    type(*window, "new_person_name", "Nora New");
    lock();
    click(*window, "lock_switch_user");
    EXPECT_TRUE(window->context().signed_in());
    EXPECT_TRUE(question().contains("a person who is not added yet")) << question().toStdString();
    EXPECT_FALSE(question().contains("Nora")) << "the content stays hidden";
    EXPECT_TRUE(sees(*window, "unlock_password"));
    click(*window, "question_no");
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(question().startsWith("Not saved yet, and lost when the window closes"));
    type(*window, "unlock_password", "correct horse");
    click(*window, "unlock");
    ASSERT_TRUE(wait_for([&] { return !sees(*window, "unlock_password"); }));
    EXPECT_TRUE(question().isEmpty()) << "work continues";
    EXPECT_EQ(typed("new_person_name"), "Nora New");
}

TEST_F(BegunInput, IsNamedBeforeAnotherLanguageMakesThePagesAgain) {
    open_page(Role::administrator, "rail_people");
    type(*window, "new_person_name", "Nora New");
    go_to("rail_settings");
    check(*window, "language_de");
    EXPECT_EQ(language_in_use(), Language::english);
    EXPECT_TRUE(question().contains("when the pages are made again"));
    click(*window, "question_no");
    EXPECT_TRUE(find<QRadioButton>(*window, "language_en")->isChecked()) << "the page shows what is in use";
    check(*window, "language_de");
    click(*window, "question_yes");
    settle();
    EXPECT_EQ(language_in_use(), Language::german);
}

TEST_F(BegunInput, OfADirectorAndOfAReasonBehindAnotherTabIsNamed) {
    open_page(Role::director, "rail_data");
    check(*window, "retention_limited");
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(question().endsWith(": how long data are kept.")) << question().toStdString();
    check(*window, "retention_limited", false);
    EXPECT_TRUE(window->close());
    window.reset();
    open_debrief();
    choose_tab(*window, "debrief_tabs", "Corrections");
    type(*window, "action_reason", "performed by Ben");
    choose_tab(*window, "debrief_tabs", find<QTabWidget>(*window, "debrief_tabs")->tabText(0));
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(question().endsWith(": a reason for a correction.")) << question().toStdString();
}

TEST_F(BegunInput, NotesOfARatingAreKeptWhenTheWindowCloses) {
    const std::string attempt = open_debrief();
    bring(*find<QAbstractButton>(*window, "rating_begin"));
    click(*window, "rating_begin");
    QTest::keyClicks(find<QPlainTextEdit>(*window, "rating_remark"), "Slow start");
    EXPECT_TRUE(window->close()) << "a draft of a rating is kept: nothing is asked";
    const auto ratings =
        database::Ratings(*services.store()).of_attempt(sessions.at(Role::educator), attempt);
    ASSERT_EQ(ratings.rows.size(), 1U);
    EXPECT_EQ(ratings.rows[0].remark, "Slow start");
}

TEST_F(BegunInput, OfANewPasswordIsNamedWithoutIt) {
    open_page(Role::trainee, "rail_password");
    type(*window, "new_password", "correct horse");
    EXPECT_FALSE(window->close());
    EXPECT_EQ(question(), "Not saved yet, and lost when the window closes: a new password.");
    click(*window, "question_no");
    click(*window, "switch_user");
    EXPECT_TRUE(window->context().signed_in());
    EXPECT_EQ(question(), "Not saved yet, and lost at the sign-out: a new password.");
    click(*window, "question_no");
    EXPECT_EQ(typed("new_password"), "correct horse");
    go_to("rail_home");
    EXPECT_TRUE(window->close()) << "a page that was left has no password";
}

TEST_F(BegunInput, OfTheFirstPasswordIsNamedBeforeItsOwnSignOut) {
    database::Session once = sessions.at(Role::administrator);
    {
        const database::People people(*services.store());
        const auto made = people.create(sessions.at(Role::administrator), "nora", "Nora", {Role::trainee});
        once = people.sign_in("nora", made.one_time_password);
    }
    open({1280, 800});
    ASSERT_TRUE(become_active(*window));
    window->context().set_session(once);
    settle();
    type(*window, "new_password", "correct horse");
    click(*window, "password_cancel");
    EXPECT_TRUE(window->context().signed_in());
    EXPECT_TRUE(question().endsWith(": a new password.")) << question().toStdString();
    click(*window, "question_yes");
    EXPECT_FALSE(window->context().signed_in());
    // The way back of the last administrator, on the page of the sign-in.
    click(*window, "forgotten_password");
    type(*window, "recovery_password", "correct horse");
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(question().endsWith(": a new password.")) << question().toStdString();
    click(*window, "question_no");
    sign_in(Role::administrator);
    EXPECT_TRUE(window->close());
}

TEST_F(BegunInput, OfAnEnrolmentIsNamedWithoutItsToken) {
    open_page(Role::administrator, "rail_station");
    type(*window, "server_token", "0A1B2");
    EXPECT_FALSE(window->close());
    EXPECT_EQ(question(),
              "Not saved yet, and lost when the window closes: an enrolment of this station that is not "
              "complete yet.");
}

class BegunFirstStart : public BegunInput {
  protected:
    ~BegunFirstStart() override {
        if (window != nullptr) window->set_language(Language::english);
        window.reset();  // before its services
    }
    FakeServices empty;
};

TEST_F(BegunFirstStart, IsNamedUntilTheProgrammeIsThere) {
    window = std::make_unique<MainWindow>(empty);
    window->resize(1280, 800);
    window->show();
    ASSERT_TRUE(become_active(*window));
    window->start();
    click(*window, "create_programme");
    type(*window, "administrator_password", "correct horse");
    EXPECT_FALSE(window->close());
    EXPECT_EQ(question(),
              "Not saved yet, and lost when the window closes: a programme that is not created yet.");
    click(*window, "question_no");
    EXPECT_EQ(typed("administrator_password"), "correct horse");
    click(*window, "create_back");
    click(*window, "join_programme");
    type(*window, "join_token", "0A1B2");
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(
        question().endsWith(": a programme that is not created yet; a programme that is not joined yet."))
        << question().toStdString();
    click(*window, "question_no");
    click(*window, "join_back");
    // Over the demonstration another language is chosen; a sign-out there leaves the first page alone.
    click(*window, "look_around");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "pick_demo_person"); }));
    window->context().set_session(database::People(*empty.store()).demo_session("dora", Role::director));
    settle();
    go_to("rail_settings");
    check(*window, "language_de");
    EXPECT_EQ(language_in_use(), Language::english);
    EXPECT_TRUE(question().contains("a programme that is not created yet")) << question().toStdString();
    click(*window, "question_no");
    click(*window, "switch_user");
    EXPECT_FALSE(window->context().signed_in());
    click(*window, "leave_demo");
    click(*window, "create_programme");
    EXPECT_EQ(typed("administrator_password"), "correct horse");
    type_programme(*window);
    click(*window, "create_confirm");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "recovery_code"); }));
    check(*window, "code_noted");
    click(*window, "code_continue");
    settle();
    EXPECT_TRUE(window->close()) << question().toStdString();
}

}  // namespace
}  // namespace fulcrum::ui::window_test
