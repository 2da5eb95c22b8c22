// SPDX-License-Identifier: GPL-3.0-or-later
// Accounts from a list on the page People: looked at first, then made, stopped in the middle, and refused
// where the list or the file for the passwords is wrong.
#include <QComboBox>
#include <QFile>
#include <QPushButton>
#include <QTableWidget>
#include <fstream>

#include "tests/app/services/window_access.h"
#include "ui/administration/import_card.h"
#include "ui/style/palette.h"

namespace fulcrum::app::program_test {
namespace {

class PeopleImport : public WindowAccess {
  protected:
    PeopleImport() {
        act_as(programme.asker(Role::administrator));
        click(*window, "rail_people");
    }
    QString path(const char* name) const { return programme.folder.filePath(QString::fromLatin1(name)); }
    void write(const char* name, const std::string& rows) const {
        std::ofstream(path(name).toStdString()) << "login,name,role\n" << rows;
    }
    void look(const char* name) {
        auto* line = find<QLineEdit>(*window, "import_path");
        bring(*line);
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, path(name));
        QTest::keyClick(line, Qt::Key_Return);
    }
    std::size_t people() const {
        return database::People(*services->store()).list(programme.asker(Role::administrator)).size();
    }
    /// Returns while the accounts are being made.
    void import_forty(std::size_t before) {
        std::string rows;
        for (int i = 0; i < 40; ++i)
            rows += "many" + std::to_string(i) + ",Many " + std::to_string(i) + ",\n";
        write("many.csv", rows);
        look("many.csv");
        click(*window, "import_people");
        ASSERT_TRUE(wait_for([&] { return people() > before + 1; }));
    }
    void expect_some_with_passwords(std::size_t before) const {
        ASSERT_TRUE(wait_for([&] { return QFile::exists(path("passwords.csv")); }));
        const std::size_t made = people() - before;
        EXPECT_LT(made, 40U);
        QFile passwords(path("passwords.csv"));
        ASSERT_TRUE(passwords.open(QIODevice::ReadOnly));
        EXPECT_EQ(passwords.readAll().split('\n').size(), static_cast<int>(made) + 2);
    }
};

TEST_F(PeopleImport, ShowsThePlanThenMakesTheAccounts) {
    const std::size_t before = people();
    write("list.csv", "mia,Mia Berg,\nann,Ann Trainee,\ntea,Tea Cher,educator\n");
    look("list.csv");
    auto* table = find<QTableWidget>(*window, "import_table");
    ASSERT_EQ(table->rowCount(), 3);
    EXPECT_EQ(table->item(0, 3)->text(), "new account");
    EXPECT_EQ(table->item(1, 3)->text(), "exists already");
    EXPECT_TRUE(find<QLabel>(*window, "import_summary")->text().startsWith("2 new accounts"));
    EXPECT_EQ(people(), before) << "looking changes nothing";
    bring(*find<QPushButton>(*window, "import_people"));
    keep_picture(*window, "people-import");

    click(*window, "import_people");
    ASSERT_TRUE(wait_for([&] { return complaint().contains("2 accounts were made"); }));
    EXPECT_EQ(people(), before + 2);
    EXPECT_FALSE(sees(*window, "import_table"));
    QFile passwords(path("passwords.csv"));
    ASSERT_TRUE(passwords.open(QIODevice::ReadOnly));
    EXPECT_FALSE(passwords.permissions() & (QFile::ReadGroup | QFile::ReadOther));
    const QList<QByteArray> lines = passwords.readAll().split('\n');
    ASSERT_EQ(lines.size(), 4);
    const std::string secret = lines[1].split(',').last().toStdString();
    EXPECT_TRUE(database::People(*services->store()).sign_in("mia", secret).must_change_password());

    // Again: nothing is left to do, and the file is not replaced.
    look("list.csv");
    EXPECT_FALSE(find<QPushButton>(*window, "import_people")->isEnabled());
    write("more.csv", "leo,Leo Late,\n");
    look("more.csv");
    click(*window, "import_people");
    ASSERT_TRUE(wait_for([&] { return complaint().contains("passwords.csv"); }));
    EXPECT_EQ(people(), before + 2) << "no account without a place for its password";
}

TEST_F(PeopleImport, StoppedItKeepsThePasswordsOfTheAccountsThatWereMade) {
    const std::size_t before = people();
    import_forty(before);
    click(*window, "cancel_job");
    ASSERT_TRUE(wait_for([&] { return complaint().contains("Stopped"); }));
    expect_some_with_passwords(before);
}

TEST_F(PeopleImport, SigningOutStopsItAndNobodyReadsTheListOfPeopleThen) {
    const std::size_t before = people();
    import_forty(before);
    auto* card = window->findChild<ImportCard*>();
    ASSERT_NE(card, nullptr);
    const QSignalSpy imported(card, &ImportCard::imported);
    window->context().sign_out();
    EXPECT_EQ(imported.count(), 0);
    EXPECT_FALSE(sees(*window, "message_text"));
    settle();
    expect_some_with_passwords(before);
}

TEST_F(PeopleImport, MergesSomebodyWhoWasEnteredTwiceAndUndoesIt) {
    const auto row_of = [&](const char* login) {
        auto* table = find<QTableWidget>(*window, "people_table");
        int row = 0;
        while (row < table->rowCount() && table->item(row, 1)->text() != QLatin1String(login)) ++row;
        EXPECT_LT(row, table->rowCount());
        table->selectRow(row);
        return row;
    };
    row_of("eve");
    auto* into = find<QComboBox>(*window, "merge_into");
    EXPECT_FALSE(find<QPushButton>(*window, "merge_people")->isEnabled()) << "nobody is chosen";
    into->setCurrentIndex(into->findText("Ann", Qt::MatchStartsWith));
    EXPECT_TRUE(find<QLabel>(*window, "merge_plan")->text().contains("Ann"));
    click(*window, "merge_people");
    EXPECT_TRUE(complaint().contains("reason")) << complaint().toStdString();
    auto* reason = find<QLineEdit>(*window, "merge_reason");
    bring(*reason);
    reason->setFocus();
    QTest::keyClicks(reason, "entered twice");
    bring(*find<QPushButton>(*window, "merge_people"));
    keep_picture(*window, "people-merge");
    click(*window, "merge_people");
    EXPECT_EQ(find<QTableWidget>(*window, "people_table")->item(row_of("eve"), 3)->text(), "merged");
    EXPECT_FALSE(find<QPushButton>(*window, "toggle_active")->isEnabled());
    bring(*find<QPushButton>(*window, "unmerge_people"));
    ui::apply_theme(*qApp, ui::Theme::dark);
    keep_picture(*window, "people-merged-dark");
    ui::apply_theme(*qApp, ui::Theme::light);
    reason->setFocus();
    QTest::keyClicks(reason, "another person");
    click(*window, "unmerge_people");
    EXPECT_EQ(find<QTableWidget>(*window, "people_table")->item(row_of("eve"), 3)->text(), "deactivated");
}

TEST_F(PeopleImport, SaysWhatIsWrongWithAList) {
    write("bad.csv", "a b,Ab,\n");
    look("bad.csv");
    ASSERT_TRUE(wait_for([&] { return complaint().contains("bad.csv:2"); })) << complaint().toStdString();
    EXPECT_FALSE(sees(*window, "import_table"));
    look("none.csv");
    ASSERT_TRUE(wait_for([&] { return complaint().contains("cannot be read"); }));
}

}  // namespace
}  // namespace fulcrum::app::program_test
