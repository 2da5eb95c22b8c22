// SPDX-License-Identifier: GPL-3.0-or-later
// The page of reports: schedules are added, written, removed; what is due is written while a director's
// window is open, by one of two; files for research. With FULCRUM_PICTURES=FOLDER pictures are stored there.
#include "ui/dashboards/schedules_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QTemporaryDir>
#include <thread>

#include "database/store/audit.h"
#include "tests/database/large_programme.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/files.h"
#include "tests/ui/hands.h"
#include "ui/language/language.h"
#include "ui/page/background_job.h"
#include "ui/reports/scheduled_reports.h"
#include "ui/shell/main_window.h"
#include "ui/shell/schedule_watch.h"

namespace fulcrum::ui::window_test {
namespace {

class ReportsPage : public ::testing::Test {
  protected:
    ReportsPage() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        programme = std::make_unique<database::test::LargeProgramme>(
            database::test::make_large_programme(*services.store(), 6, 2, 1, 7));
        cohort = database::People(*services.store()).cohorts(programme->director).front();
    }
    ~ReportsPage() override {
        window.reset();
        apply_theme(*qApp, Theme::light);
        use_language(Language::english);
    }
    void open(QSize size = {1012, 726}) {
        window = std::make_unique<MainWindow>(services);
        window->resize(size);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        window->context().set_session(programme->director);
    }
    bool idle() {
        QCoreApplication::processEvents();
        return window->findChildren<BackgroundJob*>().isEmpty();
    }
    QStringList files(const QTemporaryDir& folder) {
        return QDir(folder.path()).entryList(QDir::Files, QDir::Name);
    }
    database::ReportSchedule wish(const QTemporaryDir& folder, const char* format = "json") {
        database::ReportSchedule one;
        one.cohort_id = cohort.id;
        one.format = format;
        one.folder = folder.path().toStdString();
        return one;
    }
    ScheduledRun run(const database::Store& store) {
        return run_schedules(store, programme->director,
                             {services.tasks(), services.curriculum(), services.program_version()});
    }

    FakeServices services;
    std::unique_ptr<database::test::LargeProgramme> programme;
    database::Cohort cohort;
    std::unique_ptr<MainWindow> window;
};

TEST_F(ReportsPage, SchedulesAreAddedWrittenAndRemoved) {
    QTemporaryDir folder;
    open();
    ASSERT_TRUE(wait_for([&] { return idle(); }));  // the window has looked for what is due: nothing
    click(*window, "rail_schedules");
    EXPECT_TRUE(sees(*window, "schedules_none"));
    EXPECT_FALSE(find<QAbstractButton>(*window, "schedule_add")->isEnabled()) << "no folder yet";
    type(*window, "schedule_folder", "reports");
    click(*window, "schedule_add");
    EXPECT_TRUE(find<QLabel>(*window, "message_text")->text().contains("a path from /"));
    auto* format = find<QComboBox>(*window, "schedule_format");
    format->setFocus();
    QTest::keyClick(format, Qt::Key_End);
    type(*window, "schedule_folder", folder.path());
    QTest::keyClick(find<QLineEdit>(*window, "schedule_folder"), Qt::Key_Return);
    EXPECT_TRUE(sees(*window, "schedules_none")) << "Enter in a field adds nothing";
    click(*window, "schedule_add");
    auto* table = find<QTableWidget>(*window, "schedules_table");
    ASSERT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->item(0, 0)->text().toStdString(), cohort.name);
    EXPECT_EQ(table->item(0, 5)->text(), "● due");
    click(*window, "schedules_write_due");
    ASSERT_TRUE(wait_for([&] { return idle(); }));
    EXPECT_EQ(files(folder).size(), 1);
    EXPECT_TRUE(files(folder).value(0).endsWith(".json"));
    EXPECT_EQ(table->item(0, 5)->text(), "✓ written");
    for (const Theme theme : {Theme::light, Theme::dark}) {
        window->set_theme(theme);
        keep_picture(*window, theme == Theme::light ? "reports-page-light" : "reports-page-dark");
    }
    // What cannot be written says why, and is tried again.
    folder.remove();
    click(*window, "schedules_write_one");
    ASSERT_TRUE(wait_for([&] { return idle(); }));
    EXPECT_TRUE(table->item(0, 5)->text().startsWith("✕ failed")) << table->item(0, 5)->text().toStdString();
    click(*window, "schedules_remove");
    EXPECT_EQ(database::Schedules(*services.store()).list(programme->director).size(), 1U) << "asked first";
    click(*window, "schedules_remove_sure");
    EXPECT_TRUE(sees(*window, "schedules_none"));
    EXPECT_TRUE(database::Schedules(*services.store()).list(programme->director).empty());
}

TEST_F(ReportsPage, WhyAReportFailedIsReadInTodaysLanguage) {
    QTemporaryDir folder;
    const database::Schedules schedules(*services.store());
    const std::string id = schedules.add(programme->director, wish(folder));
    EXPECT_TRUE(run(*services.store()).failed.empty());  // nothing is due while the page is open
    schedules.note(
        programme->director, id, "2026-W48",
        Sentence("%1; %2", Sentence("%1: cannot be created (%2)", std::string("reports"), std::string("x")),
                 Sentence("make the store's folder writable and free some space on the disk")));
    use_language(Language::german);
    open();
    ASSERT_TRUE(wait_for([&] { return idle(); }));
    click(*window, "rail_schedules");
    const QString state = find<QTableWidget>(*window, "schedules_table")->item(0, 5)->text();
    EXPECT_TRUE(state.startsWith("✕ misslungen: reports: kann nicht angelegt werden (x); machen Sie"))
        << state.toStdString();
    use_language(Language::english);
    click(*window, "rail_schedules");
    EXPECT_EQ(
        find<QTableWidget>(*window, "schedules_table")->item(0, 5)->text(),
        "✕ failed: reports: cannot be created (x); make the store's folder writable and free some space "
        "on the disk");
}

TEST_F(ReportsPage, WhatIsDueIsWrittenWhileADirectorsWindowIsOpen) {
    QTemporaryDir folder, gone;
    for (const QTemporaryDir* one : {&gone, &folder})
        database::Schedules(*services.store()).add(programme->director, wish(*one));
    gone.remove();
    open();
    ASSERT_TRUE(wait_for([&] { return files(folder).size() == 1; })) << "without a click";
    ASSERT_TRUE(wait_for([&] {
        const auto all = database::Schedules(*services.store()).list(programme->director);
        return idle() && std::all_of(all.begin(), all.end(), [](const database::ReportSchedule& one) {
                   return !one.last_period.empty() || !one.problem.empty();
               });
    }));
    // The next minute neither writes again nor tries again what has just failed.
    const auto count = [&] { return database::Audit(*services.store()).head(); };
    const auto before = count();
    auto* watch = window->findChild<ScheduleWatch*>();
    ASSERT_NE(watch, nullptr);
    watch->look();
    EXPECT_FALSE(watch->is_writing());
    EXPECT_EQ(count(), before);
    // Nobody but a director's window writes.
    window->context().sign_out();
    QFile::remove(folder.filePath(files(folder).value(0)));
    watch->look();
    EXPECT_FALSE(watch->is_writing());
    EXPECT_EQ(files(folder).size(), 0);
}

TEST_F(ReportsPage, OfTwoRunsAtOnceOneWritesEachReportOnce) {
    QTemporaryDir folder;
    database::Schedules(*services.store()).add(programme->director, wish(folder));
    database::Schedules(*services.store()).add(programme->director, wish(folder, "csv"));
    std::vector<ScheduledRun> runs(4);
    std::vector<std::thread> all;
    for (ScheduledRun& one : runs)
        all.emplace_back([&] {
            const database::Store own = database::Store::open(services.store()->path());
            one = run(own);
        });
    for (std::thread& one : all) one.join();
    std::size_t written = 0;
    for (const ScheduledRun& one : runs) {
        written += one.written.size();
        EXPECT_TRUE(one.failed.empty());
        EXPECT_TRUE(one.busy || one.current + static_cast<int>(one.written.size()) >= 2);
    }
    EXPECT_EQ(written, 3U) << "the JSON, the CSV and its dictionary, once each";
    EXPECT_EQ(files(folder).size(), 3);
    const ScheduledRun after = run(*services.store());
    EXPECT_EQ(after.current, 2);
    EXPECT_TRUE(after.written.empty());
}

TEST_F(ReportsPage, AScheduleThatIsRemovedWhileItsReportIsWrittenStopsNoOther) {
    QTemporaryDir folder;
    const database::Schedules schedules(*services.store());
    const std::string id = schedules.add(programme->director, wish(folder, "pdf"));
    schedules.add(programme->director, wish(folder, "csv"));
    bool removed = false;
    const Progress remove_it = [&](double done, const std::string&) {  // pages of people: the PDF alone
        if (!removed && done > 0.5) {
            schedules.remove(programme->director, id);
            removed = true;
        }
        return true;
    };
    const ScheduledRun run =
        run_schedules(*services.store(), programme->director,
                      {services.tasks(), services.curriculum(), services.program_version()}, {}, remove_it);
    EXPECT_TRUE(removed);
    EXPECT_TRUE(run.failed.empty()) << run.failed[0].problem;
    EXPECT_EQ(run.written.size(), 3U) << "the PDF, the CSV and its dictionary";
    const auto left = schedules.list(programme->director);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].format, "csv");
    EXPECT_FALSE(left[0].last_period.empty());
}

TEST_F(ReportsPage, FilesForResearchAreWrittenToAFolder) {
    QTemporaryDir folder;
    open();
    click(*window, "rail_schedules");
    type(*window, "research_folder", "/nowhere/at/all");
    click(*window, "research_export");
    EXPECT_TRUE(find<QLabel>(*window, "message_text")->text().contains("is not a folder"));
    type(*window, "research_folder", folder.path());
    click(*window, "research_export");
    ASSERT_TRUE(wait_for([&] { return idle(); }));
    EXPECT_EQ(files(folder), (QStringList{"attempts.csv", "attempts_by_task.csv", "dictionary.csv",
                                          "metrics.csv", "people_by_task.csv"}))
        << find<QLabel>(*window, "message_text")->text().toStdString();
    EXPECT_TRUE(find<QLabel>(*window, "research_result")->text().startsWith("5 files written: "));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
