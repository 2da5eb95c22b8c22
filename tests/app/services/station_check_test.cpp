// SPDX-License-Identifier: GPL-3.0-or-later
// The check on the page *Station* simulates attempts again, as `fulcrum db check` does.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "app/services/application.h"
#include "tests/app/live/forged_record.h"
#include "tests/ui/hands.h"
#include "ui/language/language.h"
#include "ui/shell/main_window.h"

namespace fulcrum::app {
namespace {

using namespace fulcrum::ui::window_test;

class StationCheck : public ::testing::Test {
  protected:
    /// An administrator opens the page in a window of their own.
    void open_page(ui::Language language = ui::Language::english, int percent = 100) {
        services = make_services(folder.path().toStdString());
        window = std::make_unique<ui::MainWindow>(*services);
        window->resize(1280, 800);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        if (language != ui::Language::english) window->set_language(language);
        if (percent != 100) window->set_text_size(percent);
        window->context().set_session(administrator);
        QCoreApplication::processEvents();
        choose_page(*window, "rail_station");
    }
    void press_check() {
        open_page();
        click(*window, "check_store");
    }
    QString verdict() {
        EXPECT_TRUE(wait_for([&] { return sees(*window, "check_verdict"); }, 60000));
        return find<QLabel>(*window, "check_verdict")->text();
    }
    /// Of the row on the simulation; empty where there is none.
    QStringList row_of_simulation() {
        auto* items = find<QTableWidget>(*window, "check_items");
        for (int row = 0; row < items->rowCount(); ++row)
            if (items->item(row, 0)->text() == "simulation")
                return {items->item(row, 1)->text(), items->item(row, 2)->text(),
                        items->item(row, 3)->text()};
        return {};
    }

    QTemporaryDir folder;
    const std::string path = folder.filePath("fulcrum.db").toStdString();
    const std::vector<std::string> ids = place_two_attempts(path);
    KeptStation station{path};
    const database::Session administrator =
        database::People(station.store)
            .create_programme("Department", "administrator", "Ada Min", "correct horse battery")
            .administrator;
    std::unique_ptr<ui::ApplicationServices> services;
    std::unique_ptr<ui::MainWindow> window;
};

TEST_F(StationCheck, SaysHowManyAttemptsWereSimulatedAgainAndThatAllAgree) {
    press_check();
    EXPECT_EQ(verdict(),
              "✓ The store is intact. 2 attempts were simulated again; all agree with their records.");
    const QStringList row = row_of_simulation();
    ASSERT_EQ(row.size(), 3);
    EXPECT_EQ(row[0], "✓ intact");
    EXPECT_EQ(row[1], "2");
    for (const std::string& id : ids) EXPECT_TRUE(row[2].contains(QString::fromStdString(id)));
    EXPECT_FALSE(sees(*window, "cancel_job"));
    EXPECT_TRUE(find<QPushButton>(*window, "check_store")->isEnabled());
    keep_picture(*window, "station-check");
}

TEST_F(StationCheck, ItsResultIsReadableInGermanWithLargeText) {
    open_page(ui::Language::german, 200);
    window->resize(1024, 768);
    bring(*find<QPushButton>(*window, "check_store"));
    click(*window, "check_store");
    EXPECT_TRUE(verdict().contains("unversehrt")) << verdict().toStdString();
    auto* said = find<QLabel>(*window, "check_verdict");
    EXPECT_TRUE(wait_for([&] {
        return said->height() >= said->heightForWidth(said->width()) && window->width() == 1024;
    })) << "its lines are cut off, or the page is wider than the window";
    keep_picture(*window, "station-check-german");
    window->set_text_size(100);
    ui::use_language(ui::Language::english);
}

TEST_F(StationCheck, NamesAnAttemptThatWasReplacedAndSignedAgain) {
    take_forces_away(station, ids[0]);
    sign_again(station, ids[0]);
    ASSERT_TRUE(station.store.check(station.session).ok) << "nothing else finds it";
    press_check();
    const QString said = verdict();
    EXPECT_TRUE(said.startsWith("✕")) << said.toStdString();
    EXPECT_TRUE(said.contains(QString::fromStdString(ids[0])));
    EXPECT_FALSE(said.contains(QString::fromStdString(ids[1]))) << "the other one is as it was";
    const QStringList row = row_of_simulation();
    ASSERT_EQ(row.size(), 3);
    EXPECT_EQ(row[0], "✕ damaged");
    EXPECT_EQ(row[1], "2");
    keep_picture(*window, "station-check-replaced");
}

TEST_F(StationCheck, SimulatesNothingFromADamagedStoreAndSaysSo) {
    take_forces_away(station, ids[0]);  // not signed again
    press_check();
    EXPECT_TRUE(verdict().contains("damaged")) << verdict().toStdString();
    EXPECT_TRUE(row_of_simulation().isEmpty());
}

TEST_F(StationCheck, IsCancelledAndCanBeginAgain) {
    press_check();
    ASSERT_TRUE(wait_for([&] { return sees(*window, "cancel_job"); }));
    EXPECT_FALSE(find<QPushButton>(*window, "check_store")->isEnabled());
    click(*window, "cancel_job");
    ASSERT_TRUE(wait_for([&] { return find<QPushButton>(*window, "check_store")->isEnabled(); }));
    EXPECT_FALSE(sees(*window, "cancel_job"));
    EXPECT_FALSE(sees(*window, "check_verdict")) << "a check that was cut off says nothing";
    click(*window, "check_store");
    EXPECT_TRUE(verdict().contains("2 attempts were simulated again")) << verdict().toStdString();
}

}  // namespace
}  // namespace fulcrum::app
