// SPDX-License-Identifier: GPL-3.0-or-later
// The page of personal data with real events: a copy for the person, an erasure, people whose time is over.
#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QSpinBox>

#include "database/rows/connection.h"
#include "database/store/audit.h"
#include "database/sync/person_data.h"
#include "tests/database/station_keys.h"
#include "tests/ui/held_work.h"
#include "tests/ui/screens.h"
#include "ui/administration/personal_data_page.h"
#include "ui/language/language.h"
#include "ui/page/background_job.h"
#include "ui/shell/idle_watch.h"
#include "ui/shell/lock_page.h"

namespace fulcrum::ui::window_test {
namespace {

class PersonalData : public Screens {
  protected:
    ~PersonalData() override { use_language(Language::english); }
    void open_page() {
        open(QSize(1024, 768));
        sign_in(Role::director);
        go_to("rail_data");
        expect_fits("personal data");
    }
    QComboBox& people() { return *find<QComboBox>(*window, "data_person"); }
    /// Without waiting for what is read then.
    void pick(const QString& name) {
        QComboBox& box = people();
        for (int i = 0; i < box.count(); ++i)
            if (box.itemText(i).startsWith(name)) box.setCurrentIndex(i);
    }
    void choose(const QString& name) {
        pick(name);
        settle();
    }
    bool offers(const QString& name) { return people().findText(name, Qt::MatchStartsWith) >= 0; }
    /// Of one person: it is the window's, not the page's.
    void wait_for_erasure() {
        EXPECT_TRUE(wait_for([&] { return window->context().findChildren<BackgroundJob*>().isEmpty(); }));
        settle();
    }
    QString message() { return window->findChild<QLabel*>("message_text")->text(); }
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
    wait_for_erasure();
    EXPECT_TRUE(error_shown().isEmpty()) << error_shown().toStdString();
    EXPECT_FALSE(offers("Tara"));
    EXPECT_TRUE(services.store()->check(services.store()->station_session()).ok);
    // Nobody erases themselves.
    choose("Dora");
    bring(*find<QLineEdit>(*window, "erase_reason"));
    type(*window, "erase_reason", "mine");
    press("erase_person");
    press("erase_person_sure");
    wait_for_erasure();
    EXPECT_FALSE(error_shown().isEmpty());
}

TEST_F(PersonalData, ReadsInTheBackgroundWhatIsStoredAndCanBeStopped) {
    open_page();
    HeldWork held;
    pick("Tara");
    EXPECT_FALSE(sees(*window, "data_rows")) << "the window answers while it is read";
    EXPECT_FALSE(find<QPushButton>(*window, "export_all")->isEnabled());
    ASSERT_TRUE(sees(*window, "data_looking"));
    auto* stop = find<JobBar>(*window, "data_looking")->findChild<QPushButton*>("cancel_job");
    bring(*stop);
    QTest::mouseClick(stop, Qt::LeftButton);
    EXPECT_FALSE(sees(*window, "data_looking"));
    EXPECT_EQ(people().currentIndex(), 0) << "nobody is chosen";
    pick("Tara");
    pick("Ed");  // in place of her
    held.release();
    settle();
    const database::PersonDataExport found = database::export_person_data(
        services_store(), sessions.at(Role::director), sessions.at(Role::educator).person_id(), {});
    auto* rows = find<QTableWidget>(*window, "data_rows");
    ASSERT_EQ(rows->rowCount(), static_cast<int>(found.rows.size()));
    for (int row = 0; row < rows->rowCount(); ++row)
        EXPECT_EQ(rows->item(row, 1)->text(),
                  QString::number(found.rows[static_cast<std::size_t>(row)].rows));
    EXPECT_TRUE(find<QPushButton>(*window, "export_all")->isEnabled());
}

TEST_F(PersonalData, LeavingAnotherLanguageOrSigningOutStopsReadingAndALockDoesNot) {
    open_page();
    for (const char* way : {"leave", "language", "lock", "sign out"}) {
        const std::string chosen = way;
        HeldWork held;
        go_to_now("rail_data");
        pick("Tara");
        if (chosen == "leave") choose_page(*window, "rail_cohort");
        if (chosen == "language") emit window->context().language_wanted(Language::german);
        if (chosen == "sign out") window->context().sign_out();
        if (chosen == "lock") QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock");
        held.release();
        settle();
        if (chosen == "lock") QMetaObject::invokeMethod(window->findChild<LockPage*>(), "unlocked");
        EXPECT_TRUE(error_shown().isEmpty()) << way << ": " << error_shown().toStdString();
        EXPECT_EQ(sees(*window, "data_rows"), chosen == "lock") << way;
    }
    sign_in(Role::director);
    go_to("rail_data");
    EXPECT_EQ(people().currentIndex(), 0) << "nothing stays of the session before";
}

TEST_F(PersonalData, ErasesInTheBackgroundOnceAndSaysSoAlsoElsewhere) {
    open_page();
    choose("Tara");
    bring(*find<QLineEdit>(*window, "erase_reason"));
    type(*window, "erase_reason", "asked for it");
    press("erase_person");
    {
        HeldWork held;
        click(*window, "erase_person_sure");
        EXPECT_FALSE(find<QPushButton>(*window, "erase_person")->isEnabled()) << "not a second time";
        EXPECT_FALSE(find<QPushButton>(*window, "export_all")->isEnabled());
        EXPECT_FALSE(sees(*window, "cancel_job")) << "it would be done all the same";
        // The pages are made again, and the page is left once more.
        emit window->context().language_wanted(Language::german);
        go_to_now("rail_data");
        EXPECT_TRUE(offers("Tara"));
        EXPECT_FALSE(find<QPushButton>(*window, "save_retention")->isEnabled()) << "it still erases";
        emit window->context().language_wanted(Language::english);
        EXPECT_NE(newest(), "payload.erase");
        held.release();
        wait_for_erasure();
    }
    EXPECT_EQ(newest(), "payload.erase");
    EXPECT_TRUE(message().startsWith("Erased.")) << message().toStdString();
    go_to("rail_data");
    EXPECT_FALSE(offers("Tara"));
    EXPECT_TRUE(find<QPushButton>(*window, "save_retention")->isEnabled());
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
