// SPDX-License-Identifier: GPL-3.0-or-later
// The page of personal data with real events: a copy for the person, an erasure, people whose time is over.
#include <QCheckBox>
#include <QComboBox>
#include <QSpinBox>

#include "database/rows/connection.h"
#include "database/store/audit.h"
#include "tests/database/station_keys.h"
#include "tests/ui/screens.h"
#include "ui/administration/personal_data_page.h"

namespace fulcrum::ui::window_test {
namespace {

class PersonalData : public Screens {
  protected:
    void open_page() {
        open(QSize(1024, 768));
        sign_in(Role::director);
        go_to("rail_data");
        expect_fits("personal data");
    }
    void choose(const QString& name) {
        auto* people = find<QComboBox>(*window, "data_person");
        for (int i = 0; i < people->count(); ++i)
            if (people->itemText(i).startsWith(name)) people->setCurrentIndex(i);
        settle();
    }
    void press(const char* name) {
        bring(*find<QAbstractButton>(*window, name));
        click(*window, name);
        settle();
    }
    std::string newest() const {
        database::Query row(services_store().connection(),
                            "SELECT operation FROM audit_entry ORDER BY sequence DESC LIMIT 1");
        return row.next() ? row.text(0) : "";
    }
    const database::Store& services_store() const { return *const_cast<FakeServices&>(services).store(); }
    const database::test::KeysOfOneTest own_keys;
};

TEST_F(PersonalData, ShowsWhatIsStoredAndWritesItToAFolder) {
    open_page();
    EXPECT_FALSE(sees(*window, "data_rows"));
    EXPECT_FALSE(find<QPushButton>(*window, "export_all")->isEnabled());
    choose("Tara");
    auto* rows = find<QTableWidget>(*window, "data_rows");
    EXPECT_GT(rows->rowCount(), 3);
    keep("personal-data");
    const QString folder = text(services.store_path(false)) + ".tara";
    static_cast<PersonalDataPage*>(window->current_page())->export_to(folder);
    settle();
    EXPECT_TRUE(QFile::exists(folder + "/index.html"));
    EXPECT_EQ(newest(), "person.export");
    static_cast<PersonalDataPage*>(window->current_page())->export_to(folder);
    settle();
    EXPECT_FALSE(error_shown().isEmpty()) << "the folder is there already";
}

TEST_F(PersonalData, ErasesAPersonAfterAReasonAndASecondClick) {
    open_page();
    choose("Tara");
    EXPECT_FALSE(find<QPushButton>(*window, "erase_person")->isEnabled()) << "no reason yet";
    bring(*find<QLineEdit>(*window, "erase_reason"));
    type(*window, "erase_reason", "asked for it");
    press("erase_person");
    EXPECT_TRUE(sees(*window, "erase_person_sure"));
    // Another choice takes the second click back.
    choose("Ed");
    EXPECT_FALSE(sees(*window, "erase_person_sure"));
    choose("Tara");
    bring(*find<QLineEdit>(*window, "erase_reason"));
    type(*window, "erase_reason", "asked for it");
    press("erase_person");
    press("erase_person_sure");
    EXPECT_TRUE(error_shown().isEmpty()) << error_shown().toStdString();
    auto* people = find<QComboBox>(*window, "data_person");
    for (int i = 0; i < people->count(); ++i) EXPECT_FALSE(people->itemText(i).startsWith("Tara"));
    EXPECT_TRUE(services.store()->check(services.store()->station_session()).ok);
    // Nobody erases themselves.
    choose("Dora");
    bring(*find<QLineEdit>(*window, "erase_reason"));
    type(*window, "erase_reason", "mine");
    press("erase_person");
    press("erase_person_sure");
    EXPECT_FALSE(error_shown().isEmpty());
}

TEST_F(PersonalData, SetsHowLongDataAreKeptAndErasesThoseDueAfterASecondClick) {
    open_page();
    EXPECT_TRUE(find<QLabel>(*window, "due_summary")->text().startsWith("No end is set"));
    bring(*find<QCheckBox>(*window, "retention_limited"));
    find<QCheckBox>(*window, "retention_limited")->click();
    find<QSpinBox>(*window, "retention_months")->setValue(12);
    press("save_retention");
    EXPECT_EQ(find<QLabel>(*window, "due_summary")->text(), "Nobody is due.");
    EXPECT_FALSE(sees(*window, "erase_due"));
    // Tara's last sign-in was two years ago.
    services.store()->connection().execute("UPDATE sign_in SET last = last - 63072000000");
    services.store()->connection().execute("UPDATE person SET created = created - 63072000000");
    go_to("rail_cohort");
    go_to("rail_data");
    ASSERT_TRUE(sees(*window, "due_people"));
    EXPECT_EQ(find<QTableWidget>(*window, "due_people")->rowCount(), 1);
    EXPECT_EQ(find<QTableWidget>(*window, "due_people")->item(0, 1)->text(), "tara");
    press("erase_due");
    EXPECT_TRUE(find<QPushButton>(*window, "erase_due_sure")->text().contains("1 person"));
    keep("retention");
    press("erase_due_sure");
    EXPECT_EQ(find<QLabel>(*window, "due_summary")->text(), "Nobody is due.");
    database::Query row(services.store()->connection(), "SELECT COUNT(*) FROM person WHERE login = 'tara'");
    ASSERT_TRUE(row.next());
    EXPECT_EQ(row.integer(0), 0);
}

TEST_F(PersonalData, IsForDirectorsOnly) {
    open(QSize(1024, 768));
    for (const Role role : {Role::trainee, Role::educator, Role::administrator}) {
        sign_in(role);
        EXPECT_FALSE(sees(*window, "rail_data"));
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
