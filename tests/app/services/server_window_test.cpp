// SPDX-License-Identifier: GPL-3.0-or-later
// The window on a programme server: the pages of what is read, with the person whose account it is; nothing
// that writes. With FULCRUM_PICTURES=FOLDER the screens are stored there.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QTableWidget>

#include "app/services/application.h"
#include "database/sync/programme_server.h"
#include "database/sync/sync.h"
#include "tests/app/access_programme.h"
#include "tests/database/postgresql_server.h"
#include "tests/database/sync/stations.h"
#include "tests/ui/hands.h"
#include "ui/dashboards/attempts_page.h"
#include "ui/shell/main_window.h"
#include "ui/shell/page_table.h"
#include "ui/style/palette.h"

namespace fulcrum::app::program_test {
namespace {

using database::test::PostgresqlServer;
using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

class ServerWindow : public ::testing::Test {
  protected:
    void SetUp() override {
        FULCRUM_NEEDS_POSTGRESQL();
        address = PostgresqlServer::of_this_process()->new_database();
        sync_with_server(*programme.store, programme.session("administrator"), address);
    }
    void TearDown() override { apply_theme(*qApp, Theme::light); }
    void open(const std::string& store) {
        window.reset();
        services = make_services(programme.folder.path().toStdString(), store);
        window = std::make_unique<MainWindow>(*services);
        window->resize(1280, 800);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
    }
    void open_as(const char* login) { open(grant_at_programme_server(address, login).address); }
    void keep(const QString& name) {
        QTest::qWait(300);
        const QString folder = qEnvironmentVariable("FULCRUM_PICTURES");
        if (!folder.isEmpty()) window->grab().save(QDir(folder).filePath(name + ".png"));
    }
    QString shown(const char* name) { return find<QLabel>(*window, name)->text(); }
    bool no_button_writes() {
        bool none = true;
        for (const char* name :
             {"switch_user", "rail_switch_user", "rail_password", "rail_rate", "rail_assign", "rail_tissues",
              "rail_home", "void_attempt", "reassign_attempt", "request_correction", "comment_send",
              "comment_draft", "ratings_release", "rating_begin", "decide_standing", "task_briefing",
              "replay_take_over", "curriculum_move"})
            if (sees(*window, name)) {
                none = false;
                ADD_FAILURE() << name << " is shown";
            }
        return none;
    }

    AccessProgramme programme;
    database::ServerAddress address;
    std::unique_ptr<ui::ApplicationServices> services;
    std::unique_ptr<MainWindow> window;
};

TEST_F(ServerWindow, OpensEachPageOfItsRoleAndShowsNoButtonThatWrites) {
    for (const char* login : {"director", "educator", "ann"}) {
        open_as(login);
        ASSERT_TRUE(window->context().signed_in()) << login;
        EXPECT_EQ(window->context().session().login(), login);
        EXPECT_TRUE(shown("banner_text").contains("read only"));
        // The educator trains as well, and acts as a trainee at first.
        if (std::string(login) == "educator")
            window->context().set_session(database::People(window->context().store())
                                              .act_as(window->context().session(), database::Role::educator));
        const auto pages = pages_of(window->context());
        EXPECT_GE(pages.size(), 3U) << login;
        for (const PageEntry* entry : pages) {
            click(*window, entry->name);
            QTest::qWait(50);
            EXPECT_FALSE(sees(*window, "message_text"))
                << login << ", " << entry->name << ": "
                << (sees(*window, "message_text") ? shown("message_text").toStdString() : std::string());
            EXPECT_TRUE(no_button_writes()) << login << ", " << entry->name;
        }
        // The debrief: score, comments, ratings; nothing to write.
        emit window->context().debrief_wanted(QString::fromStdString(programme.ann.attempt), -1);
        QTest::qWait(300);
        EXPECT_TRUE(no_button_writes()) << login;
        EXPECT_FALSE(sees(*window, "message_text"))
            << (sees(*window, "message_text") ? shown("message_text").toStdString() : std::string());
    }
}

TEST_F(ServerWindow, LooksRightInBothThemes) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        apply_theme(*qApp, theme);
        const QString suffix = theme == Theme::light ? "-light" : "-dark";
        open_as("director");
        click(*window, "rail_cohort");
        wait_until_read(*window);
        keep("server-cohort" + suffix);
        click(*window, "rail_attempts");
        keep("server-attempts" + suffix);
        emit window->context().debrief_wanted(QString::fromStdString(programme.ann.attempt), -1);
        keep("server-debrief" + suffix);
        const auto* banner = find<QLabel>(*window, "banner_text");
        EXPECT_TRUE(window->rect().contains(banner->mapTo(window.get(), banner->rect().center())));
    }
}

TEST_F(ServerWindow, AStationListsTheOthersWhoseAttemptsItHas) {
    open(programme.store->path());
    window->context().set_session(programme.session("administrator"));
    click(*window, "rail_station");
    EXPECT_FALSE(sees(*window, "stations")) << "it is the only one";
    const database::test::Station other;
    sync_with_server(*other.store, other.store->station_session(), address);
    other.record("ann", 77);
    sync_with_server(*other.store, other.sign_in("administrator"), address);
    sync_with_server(*programme.store, programme.session("administrator"), address);
    click(*window, "rail_people");
    click(*window, "rail_station");
    const auto* table = find<QTableWidget>(*window, "stations");
    ASSERT_TRUE(table->isVisible());
    ASSERT_EQ(table->rowCount(), 2);
    EXPECT_TRUE(table->item(0, 0)->text().contains("this one")) << table->item(0, 0)->text().toStdString();
    EXPECT_EQ(table->item(1, 1)->text(), "1");
    EXPECT_FALSE(table->item(0, 4)->toolTip().isEmpty());
    EXPECT_EQ(table->item(1, 4)->text(), "not known here") << "keys are not exchanged";
    window->resize(1024, 1500);  // the card is the page's last
    keep("server-stations");
}

TEST_F(ServerWindow, LocksWithThePasswordOfTheAccountAndSaysWhyItCannotOpen) {
    services = make_services(programme.folder.path().toStdString(),
                             grant_at_programme_server(address, "director").address);
    window = std::make_unique<MainWindow>(*services, nullptr, 400, 60000);
    window->show();
    window->start();
    ASSERT_TRUE(wait_for([&] { return sees(*window, "unlock_password"); }, 10000));
    EXPECT_FALSE(sees(*window, "lock_switch_user")) << "opening it again would need no password";
    EXPECT_FALSE(sees(*window, "cohort_choice"));
    auto* password = find<QLineEdit>(*window, "unlock_password");
    QTest::keyClicks(password, "trusted here");
    click(*window, "unlock");
    EXPECT_TRUE(wait_for([&] { return !sees(*window, "unlock_password"); }, 10000));
    // The owner of the database is nobody of the programme; a server that is not there says so.
    open(address.text());
    EXPECT_FALSE(window->context().signed_in());
    bool said = false;
    for (const QLabel* label : window->findChildren<QLabel*>())
        said = said || (label->isVisible() && label->text().contains("server grant"));
    EXPECT_TRUE(said);
    open("postgresql://nobody@127.0.0.1:1/fulcrum");
    EXPECT_FALSE(window->context().signed_in());
    said = false;
    for (const QLabel* label : window->findChildren<QLabel*>())
        said = said || (label->isVisible() && label->text().contains("cannot connect"));
    EXPECT_TRUE(said);
}

}  // namespace
}  // namespace fulcrum::app::program_test
