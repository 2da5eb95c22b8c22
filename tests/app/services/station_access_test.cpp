// SPDX-License-Identifier: GPL-3.0-or-later
// The administrators' pages (store, audit log), changing one's own password, and the window before sign-in.
#include <QDateEdit>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include "database/rows/connection.h"
#include "tests/app/services/window_access.h"
#include "tests/database/station_keys.h"
#include "ui/administration/station_page.h"

namespace fulcrum::app::program_test {
namespace {

TEST_F(WindowAccess, AdministratorsCheckAndBackUpInTheBackground) {
    act_as(programme.asker(Role::administrator));
    click(*window, "rail_station");
    click(*window, "check_store");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "check_verdict"); }, 60000));
    EXPECT_TRUE(find<QLabel>(*window, "check_verdict")->text().contains("intact"));
    EXPECT_TRUE(find<QLabel>(*window, "check_verdict")->text().contains("No attempt was simulated again"))
        << "there is none of this version of the program";
    EXPECT_EQ(find<QTableWidget>(*window, "check_items")->rowCount(), 11);
    auto* station = static_cast<StationPage*>(window->current_page());
    const QString path = programme.folder.filePath("copy.db");
    station->back_up_to(path);
    ASSERT_TRUE(
        wait_for([&] { return sees(*window, "message_text") && complaint().contains("Backed up"); }, 60000));
    EXPECT_TRUE(Store::open(path.toStdString()).check(services->store()->station_session()).ok);
    keep_picture(*window, "station");
    // An existing file is never overwritten.
    station->back_up_to(path);
    ASSERT_TRUE(wait_for([&] { return complaint().contains("already there"); }, 60000));
    ASSERT_TRUE(wait_for([&] { return find<QPushButton>(*window, "back_up")->isEnabled(); }));
    // A folder that does not exist.
    station->back_up_to(programme.folder.filePath("copy.db/below.db"));
    ASSERT_TRUE(wait_for([&] { return !complaint().contains("already there"); }, 60000));
    EXPECT_TRUE(QFile::exists(path));
}

TEST_F(WindowAccess, AdministratorsChangeTheStationsKey) {
    const database::test::KeysOfOneTest keys;
    act_as(programme.asker(Role::administrator));
    click(*window, "rail_station");
    auto* table = find<QTableWidget>(*window, "station_keys");
    auto* button = find<QPushButton>(*window, "change_key");
    ASSERT_EQ(table->rowCount(), 1);
    EXPECT_FALSE(button->isEnabled()) << "without a reason";
    const QString before = table->item(0, 0)->text();
    find<QLineEdit>(*window, "key_reason")->setText("A technician with access has left");
    ASSERT_TRUE(button->isEnabled());
    click(*window, "change_key");
    ASSERT_EQ(table->rowCount(), 2);
    EXPECT_NE(table->item(0, 0)->text(), before);
    EXPECT_EQ(table->item(0, 2)->text(), "in use");
    EXPECT_TRUE(table->item(0, 3)->text().contains("signed by the previous key"));
    EXPECT_EQ(table->item(1, 0)->text(), before);
    EXPECT_TRUE(find<QLineEdit>(*window, "key_reason")->text().isEmpty());
    EXPECT_TRUE(complaint().contains(table->item(0, 0)->text())) << "a message, not a complaint";
    keep_picture(*window, "station-key");
}

TEST_F(WindowAccess, AdministratorsReadTheAuditLogByPersonKindAndPeriod) {
    act_as(programme.asker(Role::administrator));
    click(*window, "rail_audit");
    auto* table = find<QTableWidget>(*window, "audit_table");
    auto* person = find<QComboBox>(*window, "audit_person");
    auto* kind = find<QComboBox>(*window, "audit_kind");
    auto* period = find<QComboBox>(*window, "audit_period");
    const auto choose = [&](QComboBox* box, const QVariant& value) {
        const int index = box->findData(value);
        ASSERT_GE(index, 0) << value.toString().toStdString();
        box->setCurrentIndex(index);
        emit box->activated(index);
    };
    EXPECT_EQ(table->rowCount(), Audit(*services->store()).count());
    ASSERT_TRUE(
        wait_for([&] { return find<QLabel>(*window, "audit_chain")->text().contains("intact"); }, 60000));
    keep_picture(*window, "audit-log");
    choose(kind, "attempt.request_correction");
    ASSERT_EQ(table->rowCount(), 2) << "Ann's and Eve's";
    choose(person, QString::fromStdString(programme.id("eve")));
    ASSERT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->item(0, 1)->text(), "Eve Elsewhere");
    EXPECT_EQ(table->item(0, 2)->text(), "trainee");
    EXPECT_EQ(table->item(0, 4)->text(), "Eve Elsewhere");
    EXPECT_TRUE(table->item(0, 5)->text().contains("withheld"));
    EXPECT_FALSE(table->item(0, 5)->text().contains("this was not me"));
    choose(kind, "comment");
    ASSERT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->item(0, 1)->text(), "Otto Cator");
    EXPECT_EQ(table->item(0, 2)->text(), "educator");
    EXPECT_EQ(table->item(0, 4)->text(), "Eve Elsewhere") << "the person whose attempt it concerns";
    choose(period, -2);
    find<QDateEdit>(*window, "audit_from")->setDate(QDate(2001, 1, 1));
    find<QDateEdit>(*window, "audit_until")->setDate(QDate(2001, 1, 2));
    EXPECT_EQ(table->rowCount(), 0);
    find<QDateEdit>(*window, "audit_until")->setDate(QDate(2000, 1, 2));  // ends before it begins
    EXPECT_EQ(table->rowCount(), 0);
}

TEST_F(WindowAccess, ABrokenAuditChainIsShownToAdministrators) {
    Connection& connection = services->store()->connection();
    QString trigger;
    {
        database::Query made(connection, "SELECT sql FROM sqlite_master WHERE name = 'audit_entry_is_fixed'");
        ASSERT_TRUE(made.next());
        trigger = QString::fromStdString(made.text(0));
    }
    connection.execute("DROP TRIGGER audit_entry_is_fixed");
    connection.execute("UPDATE audit_entry SET time = time + 1 WHERE sequence = 4");
    connection.execute(trigger);  // the check finds one that is missing too
    act_as(programme.asker(Role::administrator));
    click(*window, "rail_audit");
    ASSERT_TRUE(
        wait_for([&] { return find<QLabel>(*window, "audit_chain")->text().contains("damaged"); }, 60000));
    EXPECT_TRUE(find<QLabel>(*window, "audit_chain")->text().contains("audit row 4"));
    click(*window, "rail_station");
    click(*window, "check_store");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "check_verdict"); }, 60000));
    EXPECT_TRUE(find<QLabel>(*window, "check_verdict")->text().contains("damaged"));
    auto* items = find<QTableWidget>(*window, "check_items");
    for (int row = 0; row < items->rowCount(); ++row)
        EXPECT_EQ(items->item(row, 3)->text().isEmpty(), items->item(row, 0)->text() != "audit chain") << row;
}

TEST_F(WindowAccess, EveryoneCanChangeTheirOwnPassword) {
    for (const Role asked : people_roles) {
        act_as(programme.asker(asked));
        click(*window, "rail_password");
        type(*window, "old_password", database::test::password);
        type(*window, "new_password", "another horse battery");
        type(*window, "new_password_again", "another horse battery");
        click(*window, "password_change");
        ASSERT_TRUE(
            wait_for([&] { return sees(*window, "message_text") && complaint().contains("changed"); }, 60000))
            << role_name(asked);
        click(*window, "close_message");
    }
}

TEST_F(WindowAccess, TheStationSeesThePersonWhoSignedInAndNothingElse) {
    People(*services->store()).sign_in("ann", database::test::password);
    window->start();
    settle();
    ASSERT_EQ(window->current_page()->objectName(), "sign_in_page");
    EXPECT_TRUE(sees(*window, "pick_person")) << "everyone may read the sign-in list";
    for (const char* rail :
         {"rail_people", "rail_assign", "rail_cohort", "rail_attempts", "rail_progress", "rail_home"})
        EXPECT_FALSE(sees(*window, rail)) << rail;
}

}  // namespace
}  // namespace fulcrum::app::program_test
