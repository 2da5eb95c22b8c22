// SPDX-License-Identifier: GPL-3.0-or-later
// The director's main path on the delivered demonstration with real events: sign in, the dashboard, a table
// next to its picture, values copied and compared with the CSV export, a person behind a number.
#include <gtest/gtest.h>

#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <filesystem>
#include <map>
#include <set>

#include "app/lab/demonstration_plan.h"
#include "app/services/application.h"
#include "assessment/curriculum/standing.h"
#include "database/roster/csv_rows.h"
#include "tests/ui/hands.h"
#include "ui/charts/figure_chart.h"
#include "ui/dashboards/dashboard_page.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"

namespace fulcrum::app {
namespace {

using namespace ui::window_test;

class DirectorsPath : public ::testing::Test {
  protected:
    DirectorsPath() : services(make_services(folder.path().toStdString())), window(*services) {
        window.resize(1280, 800);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.start();
        click(window, "look_around");
        EXPECT_TRUE(wait_for([&] { return sees(window, "pick_demo_person"); }, 20000));
        for (QAbstractButton* button : window.findChildren<QAbstractButton*>("pick_demo_person")) {
            if (!button->isVisible() || !button->text().startsWith("Prof. Anna")) continue;
            bring(*button);
            QTest::mouseClick(button, Qt::LeftButton);
            break;
        }
        EXPECT_TRUE(wait_for([&] { return window.context().signed_in(); }));
        wait_until_read(window);
    }
    void press(const char* name) {
        auto* button = find<QAbstractButton>(window, name);
        ASSERT_NE(button, nullptr);
        bring(*button);
        QCoreApplication::processEvents();
        QTest::mouseClick(button, Qt::LeftButton);
    }
    /// The rows that were copied, without the one of titles.
    QVector<QStringList> copied(const char* button) {
        QGuiApplication::clipboard()->clear();
        press(button);
        QVector<QStringList> rows;
        for (const QString& line : QGuiApplication::clipboard()->text().split(QLatin1Char('\n')))
            if (!line.isEmpty()) rows << line.split(QLatin1Char('\t'));
        EXPECT_GT(rows.size(), 1) << button;
        titles = rows.isEmpty() ? QStringList() : rows.takeFirst();
        return rows;
    }
    database::CsvRows exported() {
        const QString path = folder.filePath("cohort.csv");
        auto* page = static_cast<ui::DashboardPage*>(window.current_page());
        QSignalSpy done(page, &ui::DashboardPage::exported);
        page->export_to(path, ui::ReportFormat::csv);
        EXPECT_TRUE(wait_for([&] { return done.count() == 1; }));
        return database::CsvRows::load(path.toStdString());
    }

    QTemporaryDir folder;
    std::unique_ptr<ui::ApplicationServices> services;
    ui::MainWindow window;
    QStringList titles;
};

TEST_F(DirectorsPath, CopiedValuesAreThoseOfTheCsvExportAndPeopleAreAClickAway) {
    ASSERT_EQ(window.current_page()->objectName(), "dashboard_page") << "where a director begins";
    ASSERT_TRUE(sees(window, "dashboard_pass_rates_chart"));
    // A picture, its table, and the same values as data.
    press("dashboard_pass_rates_as_table");
    auto* table = find<QTableWidget>(window, "dashboard_pass_rates_table");
    ASSERT_NE(table, nullptr);
    const QVector<QStringList> rates = copied("dashboard_pass_rates_copy_data");
    EXPECT_EQ(titles.value(1), "Tried (people)");
    ASSERT_EQ(rates.size(), table->rowCount());
    for (int row = 0; row < rates.size(); ++row)
        for (int column = 0; column < 3; ++column)
            EXPECT_EQ(rates[row][column], table->item(row, column)->text()) << row << ", " << column;

    // The same counts from the file that the page writes.
    const database::CsvRows csv = exported();
    std::map<std::string, std::set<std::string>> tried, passed, everyone;
    std::map<std::string, std::set<std::string>> by_standing;
    for (std::size_t i = 1; i < csv.size(); ++i) {  // after the row of units
        const std::string task = csv.cell(i, "task"), person = csv.cell(i, "person_id");
        everyone[""].insert(person);
        if (std::stoll(csv.cell(i, "attempts")) > 0) tried[task].insert(person);
        if (std::stoll(csv.cell(i, "passes")) > 0) passed[task].insert(person);
        if (!csv.cell(i, "next_check_utc").empty())
            by_standing[csv.cell(i, "standing") == "due" ? "due" : "planned"].insert(person + task);
    }
    long long counted = 0;
    for (const QStringList& row : rates) {
        const std::string task = row[0].section(QLatin1Char(' '), 0, 0).toStdString();
        EXPECT_EQ(row[1].toULongLong(), tried[task].size()) << task;
        EXPECT_EQ(row[2].toULongLong(), passed[task].size()) << task;
        if (!tried[task].empty()) {
            const double share =
                100.0 * static_cast<double>(passed[task].size()) / static_cast<double>(tried[task].size());
            EXPECT_NEAR(row[3].toDouble(), share, 1e-9) << task;
            EXPECT_LE(row[4].toDouble(), share + 1e-9);
            EXPECT_GE(row[5].toDouble(), share - 1e-9);
        }
        counted += row[1].toLongLong();
    }
    EXPECT_GT(counted, 50);

    // Checks: as many as the export has, due ones and planned ones.
    const QVector<QStringList> checks = copied("dashboard_checks_copy_data");
    std::size_t due = 0;
    for (const QStringList& row : checks) due += row[0] == "overdue" || row[0] == "due now" ? 1 : 0;
    EXPECT_EQ(due, by_standing["due"].size());
    EXPECT_EQ(static_cast<std::size_t>(checks.size()),
              by_standing["due"].size() + by_standing["planned"].size());

    // Stages: who began is everyone in the cohort at most; a click lists them, Enter opens one.
    auto* stages = find<ui::FigureChart>(window, "dashboard_stages_chart");
    bring(*stages);
    ASSERT_TRUE(wait_for([&] { return !stages->place_of("0").isEmpty(); }));
    const int begun = std::get<ui::FunnelFigure>(stages->figure()).steps[0].count;
    EXPECT_LE(static_cast<std::size_t>(begun), everyone[""].size());
    QTest::mouseClick(stages, Qt::LeftButton, {}, stages->place_of("0").center().toPoint());
    auto* people = find<QTableWidget>(window, "dashboard_stages_table");
    ASSERT_NE(people, nullptr);
    ASSERT_EQ(people->rowCount(), begun);
    const QString name = people->item(1, 0)->text();
    QTest::keyClick(people, Qt::Key_Down);
    QTest::keyClick(people, Qt::Key_Return);
    ASSERT_EQ(window.current_page()->objectName(), "progress_page");
    EXPECT_TRUE(find<QComboBox>(window, "progress_person")->currentText().contains(name))
        << name.toStdString();
}

TEST_F(DirectorsPath, TimeToProficiencyIsThatOfTheChosenTask) {
    auto* task = find<QComboBox>(window, "dashboard_task");
    auto* times = find<ui::FigureChart>(window, "dashboard_times_chart");
    ASSERT_NE(task, nullptr);
    bring(*task);
    const std::vector<ui::StepCurve> shown = std::get<ui::StepFigure>(times->figure()).curves;
    ASSERT_EQ(shown.size(), 2U);
    EXPECT_FALSE(shown[0].steps.empty());
    double before = 0;
    for (const ui::CurveStep& step : shown[0].steps) {
        EXPECT_GE(step.value, before);
        EXPECT_LE(step.low, step.value);
        EXPECT_GE(step.high, step.value);
        before = step.value;
    }
    task->setFocus();
    QTest::keyClick(task, Qt::Key_End);
    const QVector<QStringList> rows = copied("dashboard_times_copy_data");
    for (const QStringList& row : rows) EXPECT_EQ(row[0], task->currentText());
    EXPECT_EQ(titles.value(2), "Since the first attempt (days)");
}

std::optional<double> best_points_in(const database::CsvRows& csv, std::size_t row) {
    const std::string& points = csv.cell(row, "best_points");
    return points.empty() ? std::nullopt : std::optional<double>(std::stod(points));
}

/// What the page's table says of a row of the CSV when it is asked for more.
QString cell_tip(const database::CsvRows& csv, std::size_t row) {
    const std::string &state = csv.cell(row, "state"), &device = csv.cell(row, "device_class");
    const bool provisional = csv.cell(row, "provisional") == "1";
    QString tip = state == "passed" ? provisional ? "✓ passed (provisional)" : "✓ passed"
                  : state == "open" ? "not attempted"
                                    : "attempted";
    if (device.empty()) return tip;
    tip += " · attempts " + QString::fromStdString(csv.cell(row, "attempts"));
    if (const auto points = best_points_in(csv, row)) tip += " · best " + ui::points_text(*points);
    return tip + "\n" + ui::device_class_text(find_row(device_classes, device)->kind);
}

/// The same in the signs of a cell.
QString cell_mark(const database::CsvRows& csv, std::size_t row) {
    const std::string& state = csv.cell(row, "state");
    if (state == "open") return "–";
    const QString sign = state != "passed" ? "○" : csv.cell(row, "provisional") == "1" ? "(✓)" : "✓";
    const QString attempts = QString::fromStdString(csv.cell(row, "attempts"));
    const auto points = best_points_in(csv, row);
    return points ? sign + " " + ui::points_figure(points) + " · " + attempts : sign + " " + attempts;
}

TEST_F(DirectorsPath, TheCohortsTableAndGridHaveTheValuesOfItsCsv) {
    press("rail_cohort");
    wait_until_read(window);
    ASSERT_EQ(window.current_page()->objectName(), "cohort_page");
    const QString path = folder.filePath("table.csv");
    type(window, "export_path", path);
    press("export_cohort");
    ASSERT_TRUE(wait_for([&] {
        return sees(window, "message_text") &&
               find<QLabel>(window, "message_text")->text().contains("table.csv");
    }));
    const database::CsvRows csv = database::CsvRows::load(path.toStdString());
    std::map<std::pair<QString, QString>, std::vector<std::size_t>> rows;  // of a person and a task
    for (std::size_t i = 1; i < csv.size(); ++i)                           // after the row of units
        rows[{ui::text(csv.cell(i, "person_id")), ui::text(csv.cell(i, "task"))}].push_back(i);
    ASSERT_GT(rows.size(), 24U * 5);

    choose_tab(window, "cohort_views", "Table");
    auto* table = find<QTableWidget>(window, "cohort_table");
    ASSERT_NE(table, nullptr);
    std::size_t cells = 0;
    for (int line = 0; line < table->rowCount(); ++line) {
        const QString person = table->item(line, 0)->data(Qt::UserRole).toString();
        for (int column = 1; column < table->columnCount(); ++column) {
            const QTableWidgetItem* cell = table->item(line, column);
            ASSERT_NE(cell, nullptr);
            const auto found = rows.find({person, cell->data(Qt::UserRole).toString()});
            ASSERT_NE(found, rows.end()) << table->item(line, 0)->text().toStdString();
            QStringList tips;
            for (const std::size_t row : found->second) tips << cell_tip(csv, row);
            QString tip = cell->toolTip(), mark;
            if (csv.cell(found->second.front(), "proficient_by_decision") == "1") {
                mark = "* ";
                EXPECT_TRUE(tip.section('\n', 0, 0).endsWith(" (decision)")) << tip.toStdString();
                tip = tip.section('\n', 1);
            }
            EXPECT_EQ(tip, tips.join("\n"));
            if (found->second.size() == 1) {
                EXPECT_EQ(cell->text(), mark + cell_mark(csv, found->second.front()));
            }
            ++cells;
        }
    }
    EXPECT_EQ(cells, rows.size());

    choose_tab(window, "cohort_views", "Grid");
    auto* grid = find<QTableView>(window, "cohort_grid");
    ASSERT_NE(grid, nullptr);
    const QAbstractItemModel& shown = *grid->model();
    std::size_t standings = 0;
    for (const auto& [of, lines] : rows) standings += csv.cell(lines.front(), "standing").empty() ? 0 : 1;
    ASSERT_EQ(static_cast<std::size_t>(shown.rowCount() * (shown.columnCount() - 2)), standings);
    for (int line = 0; line < shown.rowCount(); ++line) {
        for (int column = 1; column + 1 < shown.columnCount(); ++column) {
            const QModelIndex cell = shown.index(line, column);
            const auto found = rows.find(
                {cell.data(Qt::UserRole).toString(), shown.headerData(column, Qt::Horizontal).toString()});
            ASSERT_NE(found, rows.end()) << line << ", " << column;
            const auto* standing = find_row(standing_names, csv.cell(found->second.front(), "standing"));
            ASSERT_NE(standing, nullptr);
            const QString spoken = cell.data(Qt::AccessibleTextRole).toString();
            // A check that is late has words of its own.
            EXPECT_TRUE(spoken.contains(QString(": ") + standing->title) ||
                        (standing->kind == Standing::due && spoken.contains(": check overdue")))
                << spoken.toStdString() << ", not " << standing->title;
        }
    }
}

}  // namespace
}  // namespace fulcrum::app
