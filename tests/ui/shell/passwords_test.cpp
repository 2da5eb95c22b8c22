// SPDX-License-Identifier: GPL-3.0-or-later
// Passwords and recovery codes that exist only once, from the first start to the way back of the last
// administrator, with real events.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>

#include "database/records/people.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/page/background_job.h"
#include "ui/shell/main_window.h"

namespace fulcrum::ui::window_test {
namespace {

class Passwords : public ::testing::Test {
  protected:
    Passwords() : window(services) {
        window.resize(1280, 800);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.activateWindow();
        window.start();
    }
    void expect_page(const char* name) {
        EXPECT_TRUE(wait_for([&] { return window.current_page()->objectName() == QLatin1String(name); }))
            << window.current_page()->objectName().toStdString();
    }
    /// Keeps the recovery code; the administrator has signed in then.
    void create_programme() {
        click(window, "create_programme");
        type_programme(window);
        click(window, "create_confirm");
        ASSERT_TRUE(wait_for([&] { return sees(window, "recovery_code"); }));
        code = find<QLabel>(window, "recovery_code")->text();
        check(window, "code_noted");
        click(window, "code_continue");
        expect_page("people_page");
    }
    /// The work that was just begun is shown, without a button that would lose its answer.
    void expect_no_cancel() {
        bool works = false;
        for (const JobBar* bar : window.findChildren<JobBar*>()) works = works || bar->isVisible();
        EXPECT_TRUE(works);
        EXPECT_FALSE(sees(window, "cancel_job"));
    }
    void ask_for_recovery(const QString& with) {
        if (!sees(window, "recover")) click(window, "forgotten_password");
        type(window, "recovery_login", "alma");
        type(window, "recovery_code_field", with);
        type(window, "recovery_password", "a brand new password");
        bring(*find<QPushButton>(window, "recover"));
        click(window, "recover");
    }

    FakeServices services;
    MainWindow window;
    QString code;
};

TEST_F(Passwords, NextRecoveryCodeIsShownUntilItIsConfirmed) {
    create_programme();
    click(window, "switch_user");
    expect_page("sign_in_page");
    ask_for_recovery(code);
    expect_no_cancel();
    EXPECT_FALSE(find<QPushButton>(window, "recover")->isEnabled()) << "one job at a time";
    EXPECT_FALSE(find<QPushButton>(window, "sign_in")->isEnabled());
    ASSERT_TRUE(wait_for([&] { return sees(window, "new_recovery_code"); }));
    const QString next = find<QLabel>(window, "new_recovery_code")->text();
    EXPECT_EQ(next.size(), code.size());
    EXPECT_NE(next, code);
    EXPECT_FALSE(sees(window, "recover"));
    keep_picture(window, "new-recovery-code");
    // Neither another message nor the page shown again hides it, and nobody signs in before.
    window.context().say("Something else.");
    window.current_page()->enter();
    QTest::qWait(50);
    ASSERT_TRUE(sees(window, "new_recovery_code"));
    EXPECT_EQ(find<QLabel>(window, "new_recovery_code")->text(), next);
    EXPECT_FALSE(find<QPushButton>(window, "sign_in")->isEnabled());
    bring(*find<QPushButton>(window, "new_code_noted"));
    click(window, "new_code_noted");
    EXPECT_FALSE(sees(window, "new_recovery_code"));
    for (const QLabel* label : window.findChildren<QLabel*>()) EXPECT_FALSE(label->text().contains(next));
    // It is the code of the store.
    const database::People people(*services.store());
    EXPECT_NO_THROW(people.recover_administrator("alma", next.toStdString(), "yet another password"));
    type(window, "login", "alma");
    type(window, "password", "yet another password");
    click(window, "sign_in");
    EXPECT_TRUE(wait_for([&] { return window.context().signed_in(); }));
}

TEST_F(Passwords, CreationOfAProgrammeIsNeitherCancelledNorLeft) {
    click(window, "create_programme");
    type_programme(window);
    click(window, "create_confirm");
    expect_no_cancel();
    EXPECT_FALSE(find<QPushButton>(window, "create_back")->isEnabled());
    ASSERT_TRUE(wait_for([&] { return sees(window, "recovery_code"); }));
    EXPECT_FALSE(find<QLabel>(window, "recovery_code")->text().isEmpty());
}

TEST_F(Passwords, ChangeAtTheFirstSignInIsNotCancelled) {
    create_programme();
    type(window, "new_person_name", "Tara Trainee");
    type(window, "new_person_login", "tara");
    click(window, "add_person");
    const QString once = find<QLabel>(window, "one_time_password")->property("password").toString();
    click(window, "switch_user");
    expect_page("sign_in_page");
    type(window, "login", "tara");
    type(window, "password", once);
    click(window, "sign_in");
    expect_page("password_page");
    type(window, "old_password", once);
    for (const char* field : {"new_password", "new_password_again"}) type(window, field, "tara's password");
    click(window, "password_change");
    expect_no_cancel();
    EXPECT_FALSE(find<QPushButton>(window, "password_cancel")->isEnabled());
    EXPECT_TRUE(wait_for([&] { return !window.context().session().must_change_password(); }));
}

TEST_F(Passwords, OneTimePasswordIsShownUntilItIsHandedOverWhateverTheAppearance) {
    create_programme();
    type(window, "new_person_name", "Tara Trainee");
    type(window, "new_person_login", "tara");
    click(window, "add_person");
    const QString once = find<QLabel>(window, "one_time_password")->property("password").toString();
    ASSERT_FALSE(once.isEmpty());
    window.set_theme(Theme::dark);
    EXPECT_TRUE(sees(window, "one_time_password"));
    window.set_theme(Theme::light);
    window.set_text_size(150);
    window.set_language(Language::german);
    expect_page("people_page");
    ASSERT_TRUE(wait_for([&] { return sees(window, "one_time_password"); }));
    const auto* shown = find<QLabel>(window, "one_time_password");
    EXPECT_EQ(shown->property("password").toString(), once);
    EXPECT_TRUE(shown->text().startsWith("Tara Trainee: " + once + "\nGilt 24 Stunden"))
        << shown->text().toStdString();
    bring(*find<QPushButton>(window, "password_noted"));
    click(window, "password_noted");
    window.set_text_size(100);
    window.set_language(Language::english);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the pages from before
    EXPECT_FALSE(sees(window, "one_time_password"));
    for (const QLabel* label : window.findChildren<QLabel*>()) EXPECT_FALSE(label->text().contains(once));
}

TEST_F(Passwords, OneTimePasswordsOfSeveralPeopleAreShownUntilTheyAreHandedOver) {
    create_programme();
    const auto add = [&](const char* name, const char* login) {
        type(window, "new_person_name", name);
        type(window, "new_person_login", login);
        click(window, "add_person");
        return find<QLabel>(window, "one_time_password")->property("password").toString();
    };
    const auto shown = [&] { return find<QLabel>(window, "one_time_password")->text(); };
    const QString tara = add("Tara Trainee", "tara"), ben = add("Ben Builder", "ben");
    EXPECT_NE(tara, ben);
    EXPECT_TRUE(shown().startsWith("Tara Trainee: " + tara + "\nBen Builder: " + ben + "\nValid"))
        << shown().toStdString();
    window.set_text_size(150);
    expect_page("people_page");
    EXPECT_TRUE(shown().startsWith("Tara Trainee: " + tara + "\nBen Builder: " + ben + "\nValid"))
        << shown().toStdString();
    window.set_text_size(100);
    // Another one for the same person ends the one before.
    auto* table = find<QTableWidget>(window, "people_table");
    int row = 0;
    while (row + 1 < table->rowCount() && table->item(row, 1)->text() != "tara") ++row;
    bring(*table);
    choose_row(*table, row);
    bring(*find<QPushButton>(window, "issue_password"));
    click(window, "issue_password");
    const QString again = find<QLabel>(window, "one_time_password")->property("password").toString();
    EXPECT_NE(again, tara);
    EXPECT_TRUE(shown().startsWith("Ben Builder: " + ben + "\nTara Trainee: " + again + "\nValid"))
        << shown().toStdString();
    EXPECT_FALSE(shown().contains(tara));
    bring(*find<QPushButton>(window, "password_noted"));
    click(window, "password_noted");
    EXPECT_FALSE(sees(window, "one_time_password"));
}

TEST_F(Passwords, WrongRecoveryCodeIsRefusedAndCanBeTypedAgain) {
    create_programme();
    click(window, "switch_user");
    expect_page("sign_in_page");
    ask_for_recovery("AAAA-BBBB");
    ASSERT_TRUE(wait_for(
        [&] { return find<QLabel>(window, "sign_in_problem")->text().contains("recovery code wrong"); }));
    EXPECT_TRUE(find<QPushButton>(window, "recover")->isEnabled());
    EXPECT_TRUE(find<QPushButton>(window, "sign_in")->isEnabled());
    EXPECT_FALSE(sees(window, "new_recovery_code"));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
