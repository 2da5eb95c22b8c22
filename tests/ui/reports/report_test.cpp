// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/report.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/ui/reports/pdf_pages.h"
#include "ui/language/language.h"
#include "ui/reports/report_sheet.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

/// A CSV reader after RFC 4180.
std::vector<std::vector<std::string>> read_csv(const std::string& csv) {
    std::vector<std::vector<std::string>> rows{{std::string()}};
    bool quoted = false;
    for (std::size_t i = 0; i < csv.size(); ++i) {
        const char c = csv[i];
        if (quoted) {
            if (c == '"' && i + 1 < csv.size() && csv[i + 1] == '"') {
                rows.back().back() += '"';
                ++i;
            } else if (c == '"') {
                quoted = false;
            } else {
                rows.back().back() += c;
            }
        } else if (c == '"') {
            quoted = true;
        } else if (c == ',') {
            rows.back().emplace_back();
        } else if (c == '\n') {
            rows.push_back({std::string()});
        } else if (c != '\r') {
            rows.back().back() += c;
        }
    }
    rows.pop_back();
    return rows;
}

std::string cell(const std::vector<std::vector<std::string>>& rows, std::size_t row,
                 const std::string& column) {
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
        if (rows[0][i] == column) return rows.at(row).at(i);
    }
    ADD_FAILURE() << "no column " << column;
    return {};
}

CohortReport cohort() {
    CohortReport report;
    report.provenance.programme = "Surgery";
    report.provenance.as_of = 1'763'700'000'000;
    report.tasks = {{"A2", "Fulcrum targeting", "A"}};
    report.table.cohort_name = "=cmd|' /C calc'!A0";
    report.table.people = 2;
    report.table.tasks = {"A2"};
    report.table.metric_versions = {"path_len@1", "time@1"};
    report.table.benchmark_sets = {"A2-operators@1"};
    database::CohortRow row;
    row.person_id = "p1";
    row.login = "ada";
    row.name = "Lovelace, \"Ada\"";
    row.task_id = "A2";
    row.device_class = DeviceClass::mouse_keyboard;
    row.state = database::TaskState::passed;
    row.provisional = true;
    row.attempts = 3;
    row.passes = 1;
    row.best_points = 83.333333333333329;
    row.last_attempt = 1'763'600'000'000;
    report.table.rows.push_back(row);
    row = {};
    row.person_id = "p2";
    row.login = "bob";
    row.name = "-Bob";
    row.task_id = "A2";
    report.table.rows.push_back(row);
    return report;
}

TEST(ReportCsv, GuardsAgainstFormulas) {
    EXPECT_EQ(csv_text("=1+1"), "'=1+1");
    EXPECT_EQ(csv_text("+49"), "'+49");
    EXPECT_EQ(csv_text("@sum"), "'@sum");
    EXPECT_EQ(csv_text("\tx"), "'\tx");
    EXPECT_EQ(csv_text("-Bob"), "'-Bob");
    EXPECT_EQ(csv_text("Bob;=1+1"), "\"Bob;'=1+1\"");
    EXPECT_EQ(csv_text("Bob\t=1+1"), "Bob\t'=1+1");
    EXPECT_EQ(csv_text("  =1+1"), "'  =1+1");
    EXPECT_EQ(csv_text("\xEF\xBC\x9D"
                       "1+1"),
              "'\xEF\xBC\x9D"
              "1+1");  // full-width equals sign
    EXPECT_EQ(csv_text("\xEF\xBC\xA0sum"), "'\xEF\xBC\xA0sum");
    EXPECT_EQ(csv_text("a; b"), "\"a; b\"");
    EXPECT_EQ(csv_text("-"), "-");
    EXPECT_EQ(csv_text("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_text("say \"a\""), "\"say \"\"a\"\"\"");
    const auto rows = read_csv(sheet_csv(cohort_sheet(cohort())));
    EXPECT_EQ(cell(rows, 2, "cohort").substr(0, 2), "'=");
    EXPECT_EQ(cell(rows, 3, "name"), "'-Bob");
}

TEST(ReportCsv, HasUnitsRawAndScaledColumnsAndADictionaryLineEach) {
    const CohortReport report = cohort();
    const auto rows = read_csv(sheet_csv(cohort_sheet(report)));
    ASSERT_EQ(rows.size(), 4U);
    for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
    EXPECT_EQ(cell(rows, 1, "best_points"), "points");
    EXPECT_EQ(cell(rows, 2, "last_attempt_utc"), "2025-11-20T00:53:20Z");
    EXPECT_EQ(cell(rows, 3, "best_points"), "");
    EXPECT_EQ(cell(rows, 3, "last_attempt_utc"), "");
    double points = 0, scaled = 0;
    const std::string raw = cell(rows, 2, "best_points"), part = cell(rows, 2, "best_points_scaled");
    std::from_chars(raw.data(), raw.data() + raw.size(), points);
    std::from_chars(part.data(), part.data() + part.size(), scaled);
    EXPECT_EQ(points, *report.table.rows[0].best_points);
    EXPECT_DOUBLE_EQ(scaled, points / 100);
    const auto dictionary = read_csv(dictionary_csv(cohort_sheet(report)));
    ASSERT_EQ(dictionary.size(), rows[0].size() + 1);
    for (std::size_t i = 0; i < rows[0].size(); ++i) EXPECT_EQ(dictionary[i + 1][0], rows[0][i]);
}

TEST(Report, CsvAndJsonContainTheSameValues) {
    const CohortReport report = cohort();
    const auto rows = read_csv(sheet_csv(cohort_sheet(report)));
    const nlohmann::json json = nlohmann::json::parse(cohort_json(report));
    ASSERT_EQ(json["rows"].size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const nlohmann::json& row = json["rows"][i];
        EXPECT_EQ(std::to_string(row["attempts"].get<int>()), cell(rows, i + 2, "attempts"));
        EXPECT_EQ(std::to_string(row["passes"].get<int>()), cell(rows, i + 2, "passes"));
        EXPECT_EQ(row["state"].get<std::string>(), cell(rows, i + 2, "state"));
        const std::optional<double> best = row["best_points"].is_null()
                                               ? std::nullopt
                                               : std::optional<double>(row["best_points"].get<double>());
        EXPECT_EQ(csv_number(best), cell(rows, i + 2, "best_points"));
    }
    EXPECT_EQ(json["n"], 2);
    EXPECT_EQ(json["provenance"]["programme"], "Surgery");
}

TEST(Report, ShowsThatAProficiencyIsAnEducatorsDecision) {
    CohortReport report = cohort();
    for (const char* id : {"p1", "p2"}) {
        database::PersonStandings person;
        person.person_id = id;
        database::PersonTask task;
        task.standing.task = "A2";
        task.standing.standing = Standing::proficient;
        task.standing.declared_at = 1'763'600'000'000;
        task.standing.by_override = person.person_id == "p2";
        person.tasks.push_back(task);
        report.table.standings.push_back(person);
    }
    const auto rows = read_csv(sheet_csv(cohort_sheet(report)));
    EXPECT_EQ(cell(rows, 2, "proficient_by_decision"), "0");
    EXPECT_EQ(cell(rows, 3, "proficient_by_decision"), "1");
    const nlohmann::json json = nlohmann::json::parse(cohort_json(report));
    EXPECT_EQ(json["standings"][0]["tasks"][0]["by_decision"], false);
    EXPECT_EQ(json["standings"][1]["tasks"][0]["by_decision"], true);
}

TEST(Report, JsonSaysOfAConcernThatTheLimitsAreProvisional) {
    CohortReport report = cohort();
    database::PersonStandings person;
    person.person_id = "p1";
    for (const bool provisional : {true, false}) {
        Concern overdue;
        overdue.kind = ConcernKind::check_overdue;
        overdue.task = "A2";
        overdue.provisional = provisional;
        person.concerns.push_back(overdue);
    }
    report.table.standings.push_back(person);
    const nlohmann::json json = nlohmann::json::parse(cohort_json(report));
    EXPECT_EQ(json["standings"][0]["concerns"][0]["provisional"], true);
    EXPECT_EQ(json["standings"][0]["concerns"][1]["provisional"], false);
}

TEST(Report, JsonGivesNoStandingOfAVersionThatIsNotAtTheStation) {
    CohortReport report = cohort();
    database::PersonStandings person;
    person.person_id = "p1";
    person.curriculum = "rectal@1001";
    person.tasks.resize(1);
    person.tasks[0].standing.task = "A2";
    person.not_here = true;
    report.table.standings.push_back(person);
    const nlohmann::json json = nlohmann::json::parse(cohort_json(report));
    EXPECT_EQ(json["standings"][0]["curriculum_is_here"], false);
    EXPECT_TRUE(json["standings"][0]["tasks"].empty());
}

TEST(Report, TablesDoNotDependOnTheLanguage) {
    const CohortReport report = cohort();
    const std::string csv = sheet_csv(cohort_sheet(report)), json = cohort_json(report),
                      dictionary = dictionary_csv(cohort_sheet(report));
    use_language(Language::german);
    EXPECT_EQ(sheet_csv(cohort_sheet(report)), csv);
    EXPECT_EQ(cohort_json(report), json);
    EXPECT_EQ(dictionary_csv(cohort_sheet(report)), dictionary);
    use_language(Language::english);
}

TEST(ReportCsv, HasOneColumnPerMetricHandAndTissue) {
    PersonReport report;
    report.login = "ada";
    database::PersonProgress progress;
    progress.task_id = "B1";
    database::ProgressPoint point;
    point.attempt_id = "a1";
    point.number = 1;
    point.points = 50.0;
    database::MetricRow left;
    left.id = "path_len";
    left.hand = "left";
    left.unit = "mm";
    left.value = 1234.5;
    database::MetricRow absent = left;
    absent.hand = "right";
    absent.value.reset();
    absent.absent_because = StatementId::never_inside;
    point.metrics = {left, absent};
    progress.series.push_back({DeviceClass::haptic, {point}});
    report.progress.push_back(progress);
    const auto rows = read_csv(sheet_csv(person_sheet(report)));
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(cell(rows, 1, "path_len.left"), "mm");
    EXPECT_EQ(cell(rows, 2, "path_len.left"), "1234.5");
    EXPECT_EQ(cell(rows, 2, "path_len.right"), "");
    EXPECT_EQ(cell(rows, 2, "points_scaled"), "0.5");
}

TEST(Figures, HaveOneFormat) {
    EXPECT_EQ(figure(0.0).toStdString(), "0");
    EXPECT_EQ(figure(12.34).toStdString(), "12.3");
    EXPECT_EQ(figure(1234.4).toStdString(), "1234");
    EXPECT_EQ(figure(0.1234).toStdString(), "0.123");
    EXPECT_EQ(figure(-0.00001).toStdString(), "0");
    EXPECT_EQ(figure(std::nullopt).toStdString(), "–");
    EXPECT_EQ(clock_text(125.37).toStdString(), "2:05.4");
    EXPECT_EQ(clock_text(59.96).toStdString(), "1:00.0");
    EXPECT_EQ(figure_with_unit(3.0, "count").toStdString(), "3");
    EXPECT_EQ(z_text(-1.234).toStdString(), "−1.23");
    EXPECT_EQ(z_text(-28.83).toStdString(), "below −5");
    EXPECT_EQ(z_text(38.07).toStdString(), "above 5 (far outside)");
    EXPECT_EQ(points_text(60.8).toStdString(), "60.8 of 100 points");
}

TEST(Figures, AreJoinedWithoutEmptyParts) {
    EXPECT_EQ(join_with_dots({"Surgery", "attempt report"}).toStdString(), "Surgery · attempt report");
    EXPECT_EQ(join_with_dots({"", "attempt report"}).toStdString(), "attempt report");
    EXPECT_EQ(join_with_dots({"a", QString(), "b", ""}).toStdString(), "a · b");
    EXPECT_TRUE(join_with_dots({"", QString()}).isEmpty());
}

/// No line of the report begins or ends with a separator or contains two in a row.
void expect_no_part_missing(const QByteArray& page) {
    for (const QByteArray& one : page.split('\n')) {
        const QString line = QString::fromUtf8(one.simplified());
        EXPECT_FALSE(line.startsWith(QStringLiteral("·")) || line.endsWith(QStringLiteral("·")) ||
                     line.contains(QStringLiteral("· ·")))
            << line.toStdString();
    }
}

// A store without a programme, as in the demonstration, and a person without a name.
TEST(Report, LinesHaveNoSeparatorForMissingParts) {
    const QTemporaryDir folder;
    const std::string path = plain(folder.filePath("a.pdf"));
    CohortReport of_many = cohort();
    of_many.provenance.programme.clear();
    write_cohort_pdf(of_many, path, {});
    QList<QByteArray> pages = pages_of(path);
    PersonReport of_one;
    of_one.provenance = of_many.provenance;
    of_one.rows = of_many.table.rows;
    write_person_pdf(of_one, path);
    pages += pages_of(path);
    AttemptPaper attempt;
    attempt.provenance = of_many.provenance;
    attempt.task = {"A2", "Fulcrum targeting", "A"};
    attempt.report.attempt.state = AttemptState::completed;
    write_attempt_pdf(attempt, path);
    pages += pages_of(path);
    ASSERT_EQ(pages.size(), 3);
    for (const QByteArray& page : pages) expect_no_part_missing(page);
    EXPECT_TRUE(pages[0].startsWith("Cohort report\n")) << pages[0].toStdString();
    EXPECT_TRUE(pages[1].startsWith("Progress report\n")) << pages[1].toStdString();
    EXPECT_TRUE(pages[2].startsWith("Report on one attempt\n")) << pages[2].toStdString();
}

}  // namespace
}  // namespace fulcrum::ui
