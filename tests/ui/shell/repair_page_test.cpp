// SPDX-License-Identifier: GPL-3.0-or-later
// A store that is damaged when the window starts, and restoring a backup in the window, with real events.
#include <QFileInfo>
#include <QSignalSpy>
#include <filesystem>
#include <fstream>

#include "database/rows/connection.h"
#include "database/store/damaged_copy.h"
#include "tests/ui/four_people.h"
#include "tests/ui/picture_kinds.h"
#include "tests/ui/screens.h"
#include "ui/shell/repair_page.h"

namespace fulcrum::ui::window_test {
namespace {

class Repair : public Screens {
  protected:
    Repair()
        : path(services.store_path(false)),
          folder(std::filesystem::path(path).parent_path().string() + "/backups") {
        std::filesystem::create_directory(folder);
        backup = folder + "/monday.db";
        services.store()->backup(sessions.at(Role::administrator), backup);
    }
    /// The store is closed, and a page of it, or its header, is garbage.
    void damage(std::streamoff from, std::size_t bytes) {
        services.store()->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
        services.close_store();
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(from);
        file.write(std::string(bytes, '\x5a').data(), static_cast<std::streamsize>(bytes));
    }
    /// The root of this table.
    void damage_table(const char* table) {
        std::int64_t page = 0;
        {
            database::Query root(services.store()->connection(),
                                 "SELECT rootpage FROM sqlite_master WHERE name = ?");
            root.bind(table);
            ASSERT_TRUE(root.next());
            page = root.integer(0);
        }
        damage((page - 1) * 4096, 512);
    }
    RepairPage* page() {
        return window->current_page()->objectName() == "repair_page"
                   ? static_cast<RepairPage*>(window->current_page())
                   : nullptr;
    }
    void expect_backups(int count) {
        auto* table = find<QTableWidget>(*window, "found_backups");
        EXPECT_TRUE(wait_for([&] { return table->rowCount() == count; })) << table->rowCount();
        settle();
    }
    void restore_as(const QString& login, const QString& password) {
        bring(*find<QLineEdit>(*window, "restore_login"));
        type(*window, "restore_login", login);
        type(*window, "restore_password", password);
        bring(*find<QPushButton>(*window, "restore_backup"));
        click(*window, "restore_backup");
        settle();
    }
    /// Without what is left of their logs.
    std::vector<std::string> named(const std::string& part) const {
        std::vector<std::string> list;
        for (const auto& entry :
             std::filesystem::directory_iterator(std::filesystem::path(path).parent_path())) {
            const QString name = text(entry.path().filename().string());
            if (name.contains(text(part)) && !name.endsWith("-wal") && !name.endsWith("-shm") &&
                !name.endsWith("-journal"))
                list.push_back(entry.path().string());
        }
        return list;
    }
    const std::string path, folder;
    std::string backup;
};

TEST_F(Repair, ADamagedTableIsDescribedAndTheBackupTakesItsPlace) {
    damage_table("person");
    open(QSize(1024, 768));
    ASSERT_NE(page(), nullptr);
    EXPECT_TRUE(find<QLabel>(*window, "store_problem")->text().contains("damaged")) << "in words";
    expect_backups(1);
    auto* table = find<QTableWidget>(*window, "found_backups");
    EXPECT_EQ(table->item(0, 2)->text(), "4 people, 0 attempts");
    EXPECT_TRUE(table->item(0, 4)->text().startsWith("✓"));
    keep("repair");
    restore_as("tara", "a long password");
    EXPECT_TRUE(find<QLabel>(*window, "restore_problem")->text().contains("dministrator") ||
                !find<QLabel>(*window, "restore_problem")->text().isEmpty())
        << "a trainee restores nothing";
    EXPECT_TRUE(named(".before-restore-").empty());
    restore_as("alma", "not her password");
    EXPECT_FALSE(find<QLabel>(*window, "restore_problem")->text().isEmpty());
    ASSERT_NE(page(), nullptr);
    // The wait after a wrong password is in the copy, which is gone.
    restore_as("alma", "correct horse");
    ASSERT_TRUE(wait_for([&] { return window->current_page()->objectName() == "sign_in_page"; }));
    EXPECT_TRUE(find<QLabel>(*window, "message_text")->text().contains(".before-restore-"));
    EXPECT_EQ(named(".before-restore-").size(), 1U) << "the damaged file is still there";
    EXPECT_TRUE(services.store()->check(services.store()->station_session()).ok);
}

TEST_F(Repair, AHeaderThatIsGarbageIsRepairedTheSameWay) {
    damage(0, 200);
    open(QSize(1024, 768));
    ASSERT_NE(page(), nullptr);
    expect_backups(1);
    restore_as("alma", "correct horse");
    ASSERT_TRUE(wait_for([&] { return window->current_page()->objectName() == "sign_in_page"; }));
    ASSERT_EQ(named(".before-restore-").size(), 1U);
    std::ifstream kept(named(".before-restore-").front(), std::ios::binary);
    std::string start(200, ' ');
    kept.read(start.data(), 200);
    EXPECT_EQ(start, std::string(200, '\x5a'));
}

TEST_F(Repair, TheFileIsKeptUnderAnotherNameAfterASecondClick) {
    damage_table("score");
    const auto size = std::filesystem::file_size(path);
    open(QSize(1024, 768));
    ASSERT_NE(page(), nullptr);
    settle();
    bring(*find<QPushButton>(*window, "put_aside"));
    click(*window, "put_aside");
    EXPECT_TRUE(std::filesystem::exists(path)) << "it is asked first";
    click(*window, "put_aside_cancel");
    EXPECT_FALSE(sees(*window, "put_aside_confirm"));
    click(*window, "put_aside");
    bring(*find<QPushButton>(*window, "put_aside_confirm"));
    click(*window, "put_aside_confirm");
    EXPECT_EQ(window->current_page()->objectName(), "first_start_page");
    ASSERT_EQ(named(".damaged-").size(), 1U);
    EXPECT_EQ(std::filesystem::file_size(named(".damaged-").front()), size);
    // From there a backup can still be restored.
    bring(*find<QPushButton>(*window, "first_restore"));
    click(*window, "first_restore");
    ASSERT_NE(page(), nullptr);
    expect_backups(1);
    restore_as("alma", "correct horse");
    ASSERT_TRUE(wait_for([&] { return window->current_page()->objectName() == "sign_in_page"; }));
    EXPECT_EQ(named(".damaged-").size(), 1U);
}

TEST_F(Repair, ADamagedBackupIsMarkedAndCannotBeChosenAndAnotherFolderIsSearched) {
    const std::string elsewhere = std::filesystem::path(path).parent_path().string() + "/elsewhere";
    std::filesystem::create_directory(elsewhere);
    std::filesystem::copy_file(backup, elsewhere + "/tuesday.db");
    {
        std::fstream file(backup, std::ios::in | std::ios::out | std::ios::binary);
        for (std::streamoff at = 8192; at < static_cast<std::streamoff>(std::filesystem::file_size(backup));
             at += 4096) {
            file.seekp(at);
            file.write(std::string(200, '\x5a').data(), 200);
        }
    }
    damage_table("person");
    open(QSize(1024, 768));
    expect_backups(1);
    auto* table = find<QTableWidget>(*window, "found_backups");
    EXPECT_TRUE(table->item(0, 4)->text().startsWith("✕"));
    type(*window, "restore_login", "alma");
    type(*window, "restore_password", "correct horse");
    table->selectRow(0);
    EXPECT_FALSE(find<QPushButton>(*window, "restore_backup")->isEnabled());
    page()->look_in(text(elsewhere));
    expect_backups(2);
    EXPECT_TRUE(find<QPushButton>(*window, "restore_backup")->isEnabled()) << "the sound one is chosen";
}

TEST_F(Repair, AStoreThatCannotBeWrittenIsNotCalledDamaged) {
    services.close_store();
    std::filesystem::permissions(path, std::filesystem::perms::owner_read);
    open(QSize(1024, 768));
    ASSERT_NE(page(), nullptr);
    EXPECT_FALSE(sees(*window, "restore_backup") || sees(*window, "put_aside"));
    EXPECT_TRUE(sees(*window, "open_other") && sees(*window, "quit"));
    std::filesystem::permissions(path,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    click(*window, "try_again");
    EXPECT_EQ(window->current_page()->objectName(), "sign_in_page");
}

TEST_F(Repair, AnotherProgrammeIsOpenedInstead) {
    const std::string other = std::filesystem::path(path).parent_path().string() + "/other.db";
    {
        const database::Store store = database::Store::create(other);
        make_four_people(store, "Another department");
    }
    damage(0, 200);
    open(QSize(1024, 768));
    ASSERT_NE(page(), nullptr);
    settle();
    page()->open_other(text(other));
    EXPECT_EQ(window->current_page()->objectName(), "sign_in_page");
    EXPECT_EQ(services.store()->programme_name(), "Another department");
    EXPECT_TRUE(std::filesystem::exists(path)) << "the damaged one is left alone";
}

TEST_F(Repair, AnAdministratorRestoresInTheWindowAndGoesBackWithoutDoingIt) {
    open(QSize(1024, 768));
    sign_in(Role::administrator);
    go_to("rail_station");
    bring(*find<QAbstractButton>(*window, "restore_a_backup"));
    click(*window, "restore_a_backup");
    EXPECT_TRUE(window->context().signed_in()) << "asked first";
    EXPECT_NE(services.store(), nullptr);
    QTest::keyClick(find<QAbstractButton>(*window, "restore_a_backup"), Qt::Key_Space);
    EXPECT_TRUE(window->context().signed_in()) << "the same key again is no answer";
    click(*window, "restore_a_backup_sure");
    ASSERT_NE(page(), nullptr);
    EXPECT_FALSE(window->context().signed_in());
    EXPECT_EQ(services.store(), nullptr) << "nothing holds the store open";
    expect_backups(1);
    keep("restore");
    click(*window, "try_again");  // Back
    EXPECT_EQ(window->current_page()->objectName(), "sign_in_page");
    sign_in(Role::administrator);
    go_to("rail_station");
    bring(*find<QAbstractButton>(*window, "restore_a_backup"));
    click(*window, "restore_a_backup");
    click(*window, "restore_a_backup_sure");
    expect_backups(1);
    restore_as("alma", "correct horse");
    ASSERT_TRUE(wait_for([&] { return window->current_page()->objectName() == "sign_in_page"; }));
    sign_in(Role::director);
    EXPECT_FALSE(window->context().allowed(database::Operation::backup));
}

TEST_F(Repair, PageFitsInEveryThemeLanguageAndSizeOfText) {
    damage_table("person");
    open(QSize(1024, 768));
    for (const PictureKind& kind : picture_kinds({{{1024, 768}, Theme::light, Language::english, 100},
                                                  {{1024, 768}, Theme::dark, Language::german, 200}})) {
        window->set_theme(kind.theme);
        if (kind.language != language_in_use()) window->set_language(kind.language);
        if (kind.percent != text_percent()) window->set_text_size(kind.percent);
        window->resize(kind.size);
        size_ = kind.size;
        window->start();
        ASSERT_NE(page(), nullptr);
        expect_backups(1);
        click(*window, "put_aside");
        settle();
        expect_fits(kind.name());
        keep("repair-" + kind.name());
    }
    window.reset();
    apply_text_size(*qApp, 100);
    use_language(Language::english);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
