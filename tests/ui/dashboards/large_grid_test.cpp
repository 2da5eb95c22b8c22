// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of a large cohort: 200 people by 12 tasks at once, each cell as the query has it, scrolled and
// filtered by keys. Prints how long the page took to open.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>
#include <QTableView>
#include <algorithm>
#include <cstdio>
#include <map>

#include "database/records/report_data.h"
#include "tests/database/large_programme.h"
#include "tests/support/processor_time.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/dashboards/cohort_grid.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"

namespace fulcrum::ui::window_test {
namespace {

class LargeGrid : public ::testing::Test {
  protected:
    static constexpr int people = 200;
    static constexpr std::size_t tasks = 12;

    LargeGrid() {
        services.open_store(false);
        // The delivered curriculum, and as many tasks more that are open from the beginning.
        Curriculum curriculum = services.curriculum();
        curriculum.older.clear();
        const CurriculumTask like = curriculum.tasks.front();
        while (curriculum.tasks.size() < tasks) {
            curriculum.tasks.push_back(like);
            curriculum.tasks.back().task = "X" + std::to_string(curriculum.tasks.size());
        }
        services.set_curriculum(curriculum);
        std::vector<std::string> ids;
        for (const CurriculumTask& task : curriculum.tasks) ids.push_back(task.task);
        made.emplace(database::test::make_large_programme(*services.store(), people, static_cast<int>(tasks),
                                                          1, 7, ids));
    }
    database::CohortTable queried() {
        database::CohortTableOptions options;  // as the page asks for it
        for (const TaskDefinition& task : services.tasks()) options.tasks.push_back(task.id);
        options.curriculum = &services.curriculum();
        return database::Reports(*services.store()).cohort_table(made->director, made->cohort, options);
    }
    static QString spoken(const QTableView& grid, int row, std::size_t task) {
        return grid.model()->index(row, static_cast<int>(task) + 1).data(Qt::AccessibleTextRole).toString();
    }

    FakeServices services;
    std::optional<database::test::LargeProgramme> made;
};

TEST_F(LargeGrid, ShowsTwoHundredPeopleByTwelveTasksAtOnce) {
    MainWindow window(services);
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.start();
    window.context().set_session(made->director);
    const fulcrum::test::ProcessorTime opening;
    click(window, "rail_cohort");
    wait_until_read(window);
    auto* grid = find<QTableView>(window, "cohort_grid");
    ASSERT_NE(grid, nullptr);
    QCoreApplication::processEvents();
    grid->viewport()->repaint();
    const double opened_ms = opening.milliseconds();
    std::printf("the grid of %d people by %zu tasks opened in %.0f ms of processor time\n", people, tasks,
                opened_ms);
    EXPECT_LT(opened_ms, 3000);

    const database::CohortTable table = queried();
    ASSERT_EQ(table.standings.size(), static_cast<std::size_t>(people));
    ASSERT_EQ(grid->model()->rowCount(), people);
    ASSERT_EQ(grid->model()->columnCount(), static_cast<int>(tasks) + 2);
    EXPECT_EQ(grid->horizontalScrollBar()->maximum(), 0) << "all columns have room";
    std::map<std::string, const database::PersonStandings*> wanted;
    for (const database::PersonStandings& person : table.standings) wanted[person.person_id] = &person;
    QStringList titles;
    for (const CurriculumTask& task : services.curriculum().tasks)
        titles << window.context().task_title(task.task);
    for (int row = 0; row < people; ++row) {
        const std::string id = plain(grid->model()->index(row, 0).data(Qt::UserRole).toString());
        ASSERT_EQ(wanted.count(id), 1U) << row;
        const database::PersonStandings& person = *wanted.at(id);
        ASSERT_EQ(person.tasks.size(), tasks);
        for (std::size_t t = 0; t < tasks; ++t)
            ASSERT_EQ(spoken(*grid, row, t),
                      grid_cell_text(text(person.name), titles[static_cast<int>(t)], person.tasks[t]));
        wanted.erase(id);
    }
    EXPECT_TRUE(wanted.empty());

    // To the last cell by keys.
    grid->setFocus();
    grid->setCurrentIndex(grid->model()->index(0, 0));
    const fulcrum::test::ProcessorTime scrolling;
    QTest::keyClick(grid, Qt::Key_End, Qt::ControlModifier);
    EXPECT_EQ(grid->currentIndex(), grid->model()->index(people - 1, static_cast<int>(tasks) + 1));
    grid->viewport()->repaint();
    std::printf("scrolled to the last cell in %.0f ms\n", scrolling.milliseconds());
    EXPECT_TRUE(grid->viewport()->rect().contains(grid->visualRect(grid->currentIndex()).center()));

    // Filtered by name and by standing.
    auto* name = find<QLineEdit>(window, "grid_name");
    QTest::keyClicks(name, "trainee 119");
    EXPECT_EQ(grid->model()->rowCount(), 10);
    name->clear();
    auto* standing = find<QComboBox>(window, "grid_standing");
    standing->setFocus();
    for (int i = 0; i <= static_cast<int>(Standing::attempted); ++i) QTest::keyClick(standing, Qt::Key_Down);
    ASSERT_EQ(standing->currentData().toInt(), static_cast<int>(Standing::attempted));
    const auto attempting = std::count_if(
        table.standings.begin(), table.standings.end(), [](const database::PersonStandings& person) {
            return std::any_of(person.tasks.begin(), person.tasks.end(), [](const database::PersonTask& one) {
                return one.standing.standing == Standing::attempted;
            });
        });
    EXPECT_EQ(grid->model()->rowCount(), attempting);
    EXPECT_GT(attempting, 0);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
