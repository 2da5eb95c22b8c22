// SPDX-License-Identifier: GPL-3.0-or-later
// The cohort page with many people: grid, days of practice, those who need attention, table; found, filtered,
// ordered and opened by keyboard. With FULCRUM_PICTURES=FOLDER the views are stored there.
#include "ui/dashboards/cohort_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QThreadPool>
#include <QToolTip>
#include <future>
#include <nlohmann/json.hpp>

#include "tests/ui/fake_services.h"
#include "tests/ui/files.h"
#include "tests/ui/hands.h"
#include "tests/ui/large_store.h"
#include "ui/dashboards/cohort_grid.h"
#include "ui/dashboards/concern_words.h"
#include "ui/dashboards/overview_view.h"
#include "ui/page/background_job.h"
#include "ui/reports/report.h"
#include "ui/shell/main_window.h"

namespace fulcrum::ui::window_test {
namespace {

constexpr int people = large_store_people, attempts_each = large_store_attempts_each;

class CohortViews : public ::testing::Test {
  protected:
    CohortViews() {
        apply_theme(*qApp, Theme::light);
        director = open_large_store(services);
    }
    ~CohortViews() override { apply_theme(*qApp, Theme::light); }

    void open(QSize size = {1024, 740}) {
        window = std::make_unique<MainWindow>(services);
        window->resize(size);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        window->context().set_session(*director);
        click(*window, "rail_cohort");
        wait_until_read(*window);
        views = find<QTabWidget>(*window, "cohort_views");
        grid = find<QTableView>(*window, "cohort_grid");
    }
    void keep(const QString& name) {
        QCoreApplication::processEvents();
        if (!qEnvironmentVariableIsSet("FULCRUM_PICTURES")) return;
        window->grab().save(QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES")) + "/" + name + ".png");
    }
    void choose(const char* name, int index) {
        auto* box = find<QComboBox>(*window, name);
        box->setCurrentIndex(index);
        emit box->activated(index);
    }
    QString name_in(int row) { return grid->model()->index(row, 0).data().toString(); }

    FakeServices services;
    std::optional<database::Session> director;
    std::unique_ptr<MainWindow> window;
    QTabWidget* views = nullptr;
    QTableView* grid = nullptr;
};

TEST_F(CohortViews, TheGridShowsEveryoneIsFilteredOrderedAndOpenedByKeys) {
    open();
    EXPECT_EQ(views->currentIndex(), 0) << "a picture first";
    ASSERT_EQ(grid->model()->rowCount(), people);
    const auto& tasks = services.curriculum().tasks;
    ASSERT_EQ(grid->model()->columnCount(), static_cast<int>(tasks.size()) + 2);
    int a2 = 1;
    while (grid->model()->headerData(a2, Qt::Horizontal).toString() != "A2") ++a2;
    const QString spoken = grid->model()->index(0, a2).data(Qt::AccessibleTextRole).toString();
    EXPECT_TRUE(spoken.startsWith("Trainee 1000, A2")) << spoken.toStdString();
    EXPECT_TRUE(spoken.contains("Latest attempts with haptic device: ")) << spoken.toStdString();
    EXPECT_GT(grid->columnWidth(0), grid->fontMetrics().horizontalAdvance("Trainee 1000"))
        << "a name is not cut off";
    EXPECT_EQ(grid->horizontalScrollBar()->maximum(), 0) << "all columns have room at 1024 pixels";
    keep("cohort-grid-light");
    window->set_theme(Theme::dark);
    keep("cohort-grid-dark");
    window->set_theme(Theme::light);

    QTest::keyClicks(find<QLineEdit>(*window, "grid_name"), "trainee 101");
    EXPECT_EQ(grid->model()->rowCount(), 10);
    find<QLineEdit>(*window, "grid_name")->clear();
    EXPECT_EQ(grid->model()->rowCount(), people);
    choose("grid_order", 2);
    EXPECT_EQ(grid->model()->rowCount(), people);
    choose("grid_order", 0);
    EXPECT_EQ(name_in(0), "Trainee 1000");
    // Nobody has relapsed; everyone has a task that is locked.
    choose("grid_standing", 1 + static_cast<int>(Standing::relapsed));
    EXPECT_EQ(grid->model()->rowCount(), 0);
    choose("grid_standing", 1 + static_cast<int>(Standing::locked));
    EXPECT_EQ(grid->model()->rowCount(), people);

    grid->setFocus();
    grid->setCurrentIndex(grid->model()->index(2, a2));
    QTest::keyClick(grid, Qt::Key_Return);
    ASSERT_EQ(window->current_page()->objectName(), "progress_page");
    EXPECT_EQ(find<QComboBox>(*window, "progress_task")->currentData().toString(), "A2");
}

TEST_F(CohortViews, TabLeavesTheGridArrowsMoveInItAndACellSaysWhatItShows) {
    open();
    ASSERT_TRUE(become_active(*window));
    const std::pair<int, const char*> pictures[] = {{0, "cohort_grid"}, {2, "practice_days"}};
    for (const auto& [tab, name] : pictures) {
        views->setCurrentIndex(tab);
        auto* picture = find<QTableView>(*window, name);
        picture->setFocus();
        picture->setCurrentIndex(picture->model()->index(0, 0));
        QTest::keyClick(picture, Qt::Key_Right);
        QTest::keyClick(picture, Qt::Key_Down);
        const QModelIndex cell = picture->currentIndex();
        EXPECT_EQ(cell.row(), 1) << name;
        EXPECT_EQ(cell.column(), 1) << name;
        // Signs and colours alone: the words are shown to the keyboard as well.
        const QString words = cell.data(Qt::AccessibleTextRole).toString();
        EXPECT_TRUE(wait_for([&] { return QToolTip::isVisible() && QToolTip::text() == words; }, 5000))
            << name << ": " << QToolTip::text().toStdString();
        QTest::keyClick(picture, Qt::Key_Tab);
        EXPECT_NE(window->focusWidget(), picture) << name;
        QTest::keyClick(window->focusWidget(), Qt::Key_Backtab);
        EXPECT_EQ(window->focusWidget(), picture) << name;
        QTest::keyClick(picture, Qt::Key_Backtab);
        EXPECT_NE(window->focusWidget(), picture) << name;
    }
}

TEST_F(CohortViews, DaysReasonsAndTableComeFromTheSameQuery) {
    open();
    views->setCurrentIndex(1);
    auto* overview = find<QTableWidget>(*window, "cohort_overview");
    ASSERT_EQ(overview->rowCount(), static_cast<int>(services.curriculum().tasks.size()));
    keep("cohort-tasks-light");
    window->set_theme(Theme::dark);
    keep("cohort-tasks-dark");
    window->set_theme(Theme::light);

    views->setCurrentIndex(2);
    auto* days = find<QTableView>(*window, "practice_days");
    ASSERT_EQ(days->model()->rowCount(), people);
    EXPECT_EQ(days->model()->columnCount(), 13) << "twelve weeks";
    int attempts = 0;
    for (int week = 1; week <= 12; ++week) {
        const QString spoken = days->model()->index(0, week).data(Qt::AccessibleTextRole).toString();
        attempts += spoken.section(": ", 1, 1).section(' ', 0, 0).toInt();
    }
    EXPECT_EQ(attempts, attempts_each);
    window->resize(1280, 740);
    EXPECT_TRUE(wait_for([&] { return days->horizontalScrollBar()->maximum() == 0; }))
        << "names and all weeks are in view";
    keep("cohort-days-light");
    window->set_theme(Theme::dark);
    keep("cohort-days-dark");
    window->set_theme(Theme::light);

    views->setCurrentIndex(3);
    auto* reasons = find<QTableWidget>(*window, "cohort_concerns");
    EXPECT_EQ(views->tabText(3), QString("Needs attention (%1)").arg(reasons->rowCount()));
    keep("cohort-attention-light");

    views->setCurrentIndex(4);
    auto* table = find<QTableWidget>(*window, "cohort_table");
    ASSERT_EQ(table->rowCount(), people);
    window->resize(1024, 768);
    keep("cohort-table-light");
    for (int row = 0; row < people; ++row)
        EXPECT_LT(2 * table->rowHeight(row), 5 * table->fontMetrics().lineSpacing()) << "one line a person";
    // No cell has a colour of its own, so all of them follow a theme that is switched while they are shown.
    for (const QTableWidget* shown : {overview, reasons, table})
        for (int row = 0; row < shown->rowCount(); ++row)
            for (int column = 0; column < shown->columnCount(); ++column)
                if (const QTableWidgetItem* item = shown->item(row, column)) {
                    EXPECT_EQ(item->background().style(), Qt::NoBrush) << row << ", " << column;
                    EXPECT_EQ(item->foreground().style(), Qt::NoBrush) << row << ", " << column;
                }
    window->set_theme(Theme::dark);
    const QColor ground = table->viewport()->grab().toImage().pixelColor(2, table->viewport()->height() - 3);
    EXPECT_LT(ground.lightness(), 100);
    window->set_theme(Theme::light);

    QTemporaryDir folder;
    const QString path = folder.filePath("cohort.json");
    auto* page = static_cast<CohortPage*>(window->current_page());
    QSignalSpy done(page, &CohortPage::exported);
    page->export_to(path, ReportFormat::json);
    ASSERT_TRUE(wait_for([&] { return done.count() == 1; }));
    const nlohmann::json json = nlohmann::json::parse(read_text(path));
    ASSERT_EQ(json["standings"].size(), static_cast<std::size_t>(people));
    std::size_t concerns = 0;
    for (const nlohmann::json& person : json["standings"]) concerns += person["concerns"].size();
    EXPECT_EQ(concerns, static_cast<std::size_t>(reasons->rowCount()));
    ASSERT_EQ(json["overview"].size(), static_cast<std::size_t>(overview->rowCount()));
    for (int row = 0; row < overview->rowCount(); ++row) {
        const nlohmann::json& task = json["overview"][static_cast<std::size_t>(row)];
        if (task["attempted"] == 0) continue;
        const QString shown =
            QString("%1 of %2 (").arg(task["passed"].get<int>()).arg(task["attempted"].get<int>());
        EXPECT_TRUE(overview->item(row, 1)->text().startsWith(shown)) << task.dump();
    }
    const nlohmann::json& first = json["standings"][0]["tasks"];
    for (std::size_t t = 0; t < first.size(); ++t) {
        const QString spoken =
            grid->model()->index(0, static_cast<int>(t) + 1).data(Qt::AccessibleTextRole).toString();
        const std::string standing = first[t]["standing"];
        EXPECT_TRUE(spoken.contains(QString::fromStdString(": " + standing))) << spoken.toStdString();
    }
}

TEST_F(CohortViews, AReportIsWrittenAlsoWhereThePagesAreMadeAgainAndEndsWithTheSession) {
    open();
    QTemporaryDir folder;
    const auto save = [&](const char* name) {
        static_cast<CohortPage*>(window->current_page())
            ->export_to(folder.filePath(name), ReportFormat::json);
    };
    save("kept.json");
    window->set_language(Language::german);
    // The page from before is gone when the report's end is heard of.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_TRUE(wait_for([&] {
        return sees(*window, "message_text") &&
               find<QLabel>(*window, "message_text")->text().contains("kept.json");
    }));
    EXPECT_EQ(nlohmann::json::parse(read_text(folder.filePath("kept.json")))["standings"].size(),
              static_cast<std::size_t>(people));
    window->set_language(Language::english);
    click(*window, "rail_cohort");
    wait_until_read(*window);
    save("dropped.json");
    window->context().sign_out();
    QThreadPool::globalInstance()->waitForDone();
    QCoreApplication::processEvents();
    EXPECT_FALSE(sees(*window, "message_text")) << "nothing is said to the next person";
}

TEST_F(CohortViews, TheBarOfAReportIsShownWithItsCancelWhereThePagesAreMadeAgain) {
    open();
    QTemporaryDir folder;
    const QString path = folder.filePath("late.json");
    QThreadPool& pool = *QThreadPool::globalInstance();
    pool.waitForDone();
    const int threads = pool.maxThreadCount();
    pool.setMaxThreadCount(1);
    std::promise<void> release;
    QObject owner;
    BackgroundJob::run(
        &owner, [released = release.get_future().share()](const Progress&) { released.wait(); }, [] {},
        [](const QString&) {});
    static_cast<CohortPage*>(window->current_page())->export_to(path, ReportFormat::json);
    EXPECT_TRUE(sees(*window, "cancel_job"));
    window->set_language(Language::german);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_FALSE(sees(*window, "cancel_job")) << "another page is shown";
    choose_page(*window, "rail_cohort");
    EXPECT_TRUE(sees(*window, "cancel_job"));
    window->set_text_size(150);
    choose_page(*window, "rail_cohort");
    click(*window, "cancel_job");
    EXPECT_FALSE(sees(*window, "cancel_job"));
    release.set_value();
    pool.waitForDone();
    pool.setMaxThreadCount(threads);
    QCoreApplication::processEvents();
    EXPECT_FALSE(QFile::exists(path)) << "it was cancelled";
    window->set_text_size(100);
    window->set_language(Language::english);
}

TEST_F(CohortViews, TheTableShowsPracticeAloneAsNotAttempted) {
    const auto practise = [&](const char* person, const char* task) {
        database::Query(
            services.store()->connection(),
            "INSERT INTO attempt (id, person_id, station_id, task_id, task_version, mode, "
            "device_class, device, operator_name, variant, seed, fidelity, scene, scene_digest, "
            "curriculum, limits, program_version, cpu_features, started, utc_offset_min, state, "
            "duration_s) VALUES (?, ?, ?, ?, 1, 'practice', 'mouse-keyboard', 'mouse', '', "
            "'standard', 1, 'standard', 'scene', '', '', '', '0.1.0', '', ?, 60, 'completed', 30)")
            .bind(std::string(person) + "-practice")
            .bind(person)
            .bind(services.store()->station_id())
            .bind(task)
            .bind(services.store()->now() - 60'000)
            .run();
    };
    practise("trainee-1000", "A2");
    practise("trainee-1001", "A1");
    open();
    views->setCurrentIndex(4);
    auto* table = find<QTableWidget>(*window, "cohort_table");
    const auto cell_of = [&](int row, const char* task) -> const QTableWidgetItem* {
        for (int column = 1; column < table->columnCount(); ++column)
            if (const QTableWidgetItem* item = table->item(row, column))
                if (item->data(Qt::UserRole).toString() == task) return item;
        return nullptr;
    };
    const QTableWidgetItem* practised = cell_of(1, "A1");
    ASSERT_NE(practised, nullptr);
    EXPECT_EQ(practised->text().toStdString(), "–");
    EXPECT_TRUE(practised->toolTip().startsWith("not attempted · attempts 0"))
        << practised->toolTip().toStdString();
    // Practice with another type of device does not hide what counts, nor its colour.
    const QTableWidgetItem *both = cell_of(0, "A2"), *other = cell_of(1, "A2");
    ASSERT_TRUE(both != nullptr && other != nullptr);
    EXPECT_TRUE(both->text().endsWith(" · 9 +1")) << both->text().toStdString();
    EXPECT_TRUE(other->text().endsWith(" · 9")) << other->text().toStdString();
    EXPECT_EQ(both->text().at(0), other->text().at(0)) << "passed, both";
}

TEST(CohortCells, ATraineeWhoHasOnlyPractisedHasNotAttemptedTheTask) {
    database::CohortRow row;
    EXPECT_EQ(cohort_cell_mark(row).toStdString(), "–");
    row.device_class = DeviceClass::mouse_keyboard;
    row.not_counting = 3;
    EXPECT_EQ(cohort_cell_mark(row).toStdString(), "–");
    row.state = database::TaskState::attempted;
    row.attempts = 2;
    EXPECT_EQ(cohort_cell_mark(row).toStdString(), "○ 2");
}

TEST(CohortCells, TheGridSaysThatAProficiencyIsAnEducatorsDecision) {
    database::PersonTask task;
    task.standing.standing = Standing::proficient;
    task.standing.declared_at = 1;
    EXPECT_EQ(grid_cell_text("Ann", "A2", task).toStdString(), "Ann, A2: proficient.");
    task.standing.by_override = true;
    EXPECT_EQ(grid_cell_text("Ann", "A2", task).toStdString(), "Ann, A2: proficient (decision).");
}

TEST(OverviewWords, NameTheShareAndTheDaysWithTheirIntervals) {
    database::TaskOverview task;
    EXPECT_EQ(share_text(task), "–");
    task.attempted = 18;
    task.passed = 12;
    task.share = wilson(12, 18);
    EXPECT_EQ(share_text(task), "12 of 18 (67 %, 44 to 84 %)");
    EXPECT_EQ(days_text({}, 0), "–");
    EXPECT_EQ(days_text({}, 18), "fewer than half so far");
    EXPECT_EQ(days_text({23, 15, 40}, 18), "23 days (15 to 40)");
    EXPECT_EQ(days_text({23, 15, {}}, 18), "23 days (15 or more)");
}

TEST(ConcernWords, SayWhatSinceWhenAndHowMuch) {
    Concern concern;
    concern.kind = ConcernKind::plateau;
    concern.attempts = 16;
    concern.plateau = 48.2;
    concern.low = 46.1;
    concern.high = 51.4;
    EXPECT_EQ(
        concern_text(concern, "B1 · Bowel", 0),
        "B1 · Bowel: after 16 attempts the curve levels off at 48.2 points (95 % interval 46.1 to 51.4), "
        "below the pass mark of 60.");
    concern.kind = ConcernKind::stopped;
    concern.since = std::int64_t{86'400'000} * 20'000;
    EXPECT_TRUE(concern_text(concern, "", concern.since + std::int64_t{86'400'000} * 30)
                    .startsWith("No practice for 30 days, since "));
    for (const ConcernKind kind : {ConcernKind::relapsed, ConcernKind::check_overdue}) {
        concern.kind = kind;
        concern.provisional = false;
        EXPECT_FALSE(concern_text(concern, "A2", 0).contains("provisional"));
        concern.provisional = true;
        EXPECT_TRUE(concern_text(concern, "A2", 0).contains("build the benchmark set, or decide"));
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
