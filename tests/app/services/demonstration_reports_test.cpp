// SPDX-License-Identifier: GPL-3.0-or-later
// The cohort of the delivered demonstration in every kind of file, as `fulcrum report` writes it, read back:
// points, attempts, passes and states of each person and task are those of the query behind the grid.
#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QTemporaryDir>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/cli/installed_curriculum.h"
#include "app/lab/demonstration_plan.h"
#include "app/services/demo.h"
#include "assessment/assets/assets.h"
#include "database/records/people.h"
#include "database/roster/csv_rows.h"
#include "tests/support/xapi_profile.h"
#include "tests/ui/reports/pdf_pages.h"
#include "tests/ui/reports/workbook_cells.h"
#include "ui/reports/report.h"
#include "ui/reports/report_xapi.h"
#include "ui/style/text.h"

namespace fulcrum::app {
namespace {

using database::CohortRow;
using database::Role;

constexpr const char* reports_home = "https://training.example";

/// What a file says of one person, task and device class.
struct Said {
    std::string state, standing;
    long long attempts = 0, passes = 0;
    std::optional<double> best;
    bool operator==(const Said& other) const {
        return state == other.state && standing == other.standing && attempts == other.attempts &&
               passes == other.passes && best == other.best;
    }
};
std::ostream& operator<<(std::ostream& out, const Said& said) {
    return out << said.state << ", " << said.standing << ", attempts " << said.attempts << ", passes "
               << said.passes << ", best " << said.best.value_or(-1);
}
/// By person, task and device class ("" where the task was not tried).
using Table = std::map<std::string, Said>;

std::string key_of(const std::string& person, const std::string& task, const std::string& device) {
    return person + " " + task + " " + device;
}

std::optional<double> number_in(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional<double>(std::stod(text));
}

class DemonstrationReports : public ::testing::Test {
  protected:
    DemonstrationReports() {
        for (const std::string& id : task_ids()) tasks.push_back(load_task(task_file(id)));
        const std::string path = in("demo.db");
        EXPECT_TRUE(unpack_demo(path, {}));
        store.emplace(database::Store::open(path));
        const database::People people(*store);
        director.emplace(people.demo_session(demo_director, Role::director));
        cohort = people.cohorts(*director).at(0).id;
        database::CohortTableOptions options;  // as ui/dashboards/cohort_page.cpp asks for the grid
        for (const TaskDefinition& task : tasks) options.tasks.push_back(task.id);
        options.curriculum = &curriculum;
        screen = database::Reports(*store).cohort_table(*director, cohort, options);
        for (const CohortRow& row : screen.rows) {
            const std::string device =
                row.device_class ? row_of(device_classes, *row.device_class).name : std::string();
            wanted[key_of(row.person_id, row.task_id, device)] = {database::task_state_name(row.state),
                                                                  standing(row.person_id, row.task_id),
                                                                  row.attempts, row.passes, row.best_points};
        }
    }
    std::string in(const char* name) const { return folder.filePath(name).toStdString(); }
    /// Of the grid's cell; empty: not a task of the curriculum.
    std::string standing(const std::string& person, const std::string& task) const {
        for (const database::PersonStandings& one : screen.standings)
            for (const database::PersonTask& at : one.tasks)
                if (one.person_id == person && at.standing.task == task)
                    return row_of(standing_names, at.standing.standing).name;
        return {};
    }
    std::string write(const char* name, ui::ReportFormat format) const {
        ui::ReportRequest request;
        request.cohort_id = cohort;
        request.format = format;
        request.path = in(name);
        request.home_page = reports_home;
        request.curriculum = &curriculum;
        EXPECT_FALSE(ui::write_report(*store, *director, request, tasks, "1").empty()) << name;
        return request.path;
    }
    nlohmann::json json_in(const std::string& path) const {
        std::ifstream file(path);
        return nlohmann::json::parse(file);
    }
    /// `tolerance`: of the points, where a format has fewer digits.
    void expect_as_on_screen(const Table& found, const char* format, double tolerance = 0) const {
        EXPECT_EQ(found.size(), wanted.size()) << format;
        for (const auto& [key, said] : wanted) {
            const auto here = found.find(key);
            if (here == found.end()) {
                ADD_FAILURE() << format << ": nothing about " << key;
            } else {
                Said same = here->second;
                if (same.best && said.best && std::abs(*same.best - *said.best) <= tolerance)
                    same.best = said.best;
                EXPECT_EQ(same, said) << format << ": " << key;
            }
        }
    }

    QTemporaryDir folder;
    std::vector<TaskDefinition> tasks;
    const Curriculum curriculum = installed_curriculum();
    std::optional<database::Store> store;
    std::optional<database::Session> director;
    std::string cohort;
    database::CohortTable screen;
    Table wanted;
};

TEST_F(DemonstrationReports, HaveTheValuesOfTheScreenAsCsvXlsxAndJson) {
    ASSERT_GT(wanted.size(), 24U * 5);
    Table csv, xlsx, json;
    const database::CsvRows rows = database::CsvRows::load(write("cohort.csv", ui::ReportFormat::csv));
    for (std::size_t i = 1; i < rows.size(); ++i)  // after the row of units
        csv[key_of(rows.cell(i, "person_id"), rows.cell(i, "task"), rows.cell(i, "device_class"))] = {
            rows.cell(i, "state"), rows.cell(i, "standing"), std::stoll(rows.cell(i, "attempts")),
            std::stoll(rows.cell(i, "passes")), number_in(rows.cell(i, "best_points"))};
    expect_as_on_screen(csv, "CSV");

    const std::string workbook = write("cohort.xlsx", ui::ReportFormat::xlsx);
    const auto cells = ui::cells_of(QString::fromStdString(workbook), "xl/worksheets/sheet1.xml");
    std::map<std::string, std::size_t> columns;
    for (std::size_t i = 0; cells.count(ui::reference(i, 0)) != 0; ++i)
        columns[cells.at(ui::reference(i, 0)).toStdString()] = i;
    for (std::size_t row = 2; cells.count(ui::reference(0, row)) != 0; ++row) {
        const auto cell = [&](const char* column) {
            const auto found = cells.find(ui::reference(columns.at(column), row));
            return found == cells.end() ? std::string() : found->second.toStdString();
        };
        xlsx[key_of(cell("person_id"), cell("task"), cell("device_class"))] = {
            cell("state"), cell("standing"), std::stoll(cell("attempts")), std::stoll(cell("passes")),
            number_in(cell("best_points"))};
    }
    expect_as_on_screen(xlsx, "XLSX", 1e-12);  // written with 16 digits

    const nlohmann::json document = json_in(write("cohort.json", ui::ReportFormat::json));
    std::map<std::string, std::string> standings;
    for (const nlohmann::json& person : document["standings"])
        for (const nlohmann::json& task : person["tasks"])
            standings[person["person_id"].get<std::string>() + task["task"].get<std::string>()] =
                task["standing"];
    for (const nlohmann::json& row : document["rows"]) {
        const std::string person = row["person_id"], task = row["task"];
        const nlohmann::json& device = row["device_class"];
        json[key_of(person, task, device.is_null() ? "" : device.get<std::string>())] = {
            row["state"], standings[person + task], row["attempts"], row["passes"],
            row["best_points"].is_null() ? std::nullopt
                                         : std::optional<double>(row["best_points"].get<double>())};
    }
    expect_as_on_screen(json, "JSON");
}

// A record store computes from the statements what the screen says.
TEST_F(DemonstrationReports, HaveTheValuesOfTheScreenAsStatements) {
    Table found;
    for (const auto& [key, said] : wanted) found[key] = {"open", said.standing, 0, 0, {}};
    std::size_t counted = 0;
    const std::string task_start = std::string(reports_home) + "/task/", terms = "urn:fulcrum:xapi:";
    const nlohmann::json profile = nlohmann::json::parse(xapi_profile_text);
    for (const nlohmann::json& one : json_in(write("cohort.xapi", ui::ReportFormat::xapi))) {
        const std::vector<std::string> problems = fulcrum::test::profile_problems(profile, one);
        ASSERT_TRUE(problems.empty()) << problems.front() << '\n' << one.dump(1);
        const nlohmann::json extensions = one.contains("context")
                                              ? one["context"].value("extensions", nlohmann::json::object())
                                              : nlohmann::json::object();
        if (!extensions.value(terms + "counting", false)) continue;
        ++counted;
        const std::string object = one["object"]["id"];
        ASSERT_EQ(object.rfind(task_start, 0), 0U) << object;
        const auto at = found.find(key_of(one["actor"]["account"]["name"], object.substr(task_start.size()),
                                          extensions[terms + "device-class"]));
        ASSERT_NE(at, found.end()) << one["id"];
        Said& said = at->second;
        ++said.attempts;
        const bool passed = one["result"].value("success", false);
        said.passes += passed ? 1 : 0;
        if (passed || said.state == "open") said.state = passed ? "passed" : "attempted";
        if (one["result"].contains("score"))
            said.best = std::max(said.best.value_or(0), one["result"]["score"]["raw"].get<double>());
    }
    EXPECT_GT(counted, 300U);
    expect_as_on_screen(found, "xAPI");
}

TEST_F(DemonstrationReports, HaveTheValuesOfTheScreenOnPaper) {
    const QList<QByteArray> pages = ui::pages_of(write("cohort.pdf", ui::ReportFormat::pdf));
    ASSERT_GT(pages.size(), 24);
    std::map<std::string, QString> by_person;
    for (const CohortRow& row : screen.rows) {
        if (by_person.count(row.person_id) != 0) continue;
        const QRegularExpression heading("^ *" + QRegularExpression::escape(ui::text(row.name)) + " *$",
                                         QRegularExpression::MultilineOption);
        for (const QByteArray& page : pages)
            if (QString::fromUtf8(page).contains(heading))
                by_person[row.person_id] += QString::fromUtf8(page);
        EXPECT_FALSE(by_person[row.person_id].isEmpty()) << row.name << " has no page";
    }
    std::map<std::string, int> from;  // the rows of a page are in the order of the query
    for (const CohortRow& row : screen.rows) {
        const QString& page = by_person[row.person_id];
        QString state = row.state == database::TaskState::open
                            ? QStringLiteral("not attempted")
                            : QString::fromLatin1(database::task_state_name(row.state));
        if (row.provisional) state += " (provisional)";
        const QRegularExpression line(
            QStringLiteral("(?:^|\\n) *%1 · [^\\n]*? %2 +%3 +%4 +%5 +%6 *(?:\\n|$)")
                .arg(QString::fromStdString(row.task_id), QRegularExpression::escape(state))
                .arg(row.attempts)
                .arg(row.passes)
                .arg(row.not_counting)
                .arg(ui::points_figure(row.best_points)));
        const QRegularExpressionMatch match = line.match(page, from[row.person_id]);
        if (match.hasMatch())
            from[row.person_id] = match.capturedEnd() - 1;
        else
            ADD_FAILURE() << row.name << ", " << row.task_id << ": " << line.pattern().toStdString();
    }
}

// What a trainee or a director prints of one person.
TEST_F(DemonstrationReports, AreOnePageForEachTraineeWithEveryTaskOfTheCurriculum) {
    std::set<std::string> people;
    for (const CohortRow& row : screen.rows) {
        if (!people.insert(row.person_id).second) continue;
        ui::ReportRequest request;
        request.person_id = row.person_id;
        request.path = in("person.pdf");
        request.curriculum = &curriculum;
        ASSERT_FALSE(ui::write_report(*store, *director, request, tasks, "1").empty()) << row.name;
        const QList<QByteArray> pages = ui::pages_of(request.path);
        EXPECT_EQ(pages.size(), 1) << row.name;
        ASSERT_FALSE(pages.isEmpty());
        EXPECT_TRUE(pages[0].contains("Progress report")) << row.name;
        for (const CurriculumTask& task : curriculum.tasks)
            EXPECT_TRUE(pages[0].contains(QByteArray::fromStdString(task.task + " · ")))
                << row.name << ": " << task.task;
    }
    EXPECT_EQ(people.size(), 24U);
}

}  // namespace
}  // namespace fulcrum::app
