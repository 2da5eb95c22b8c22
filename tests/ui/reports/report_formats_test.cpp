// SPDX-License-Identifier: GPL-3.0-or-later
// Workbooks and statements for a record store hold what the CSV holds, and nothing that their readers could
// take for something else.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "tests/support/support.h"
#include "tests/ui/reports/workbook_cells.h"
#include "ui/reports/report_sheet.h"
#include "ui/reports/report_xapi.h"

namespace fulcrum::ui {
namespace {

constexpr const char* home = "https://training.example";

PersonReport attempts_of_ada() {
    PersonReport report;
    report.provenance.programme = "Surgery";
    report.provenance.program_version = "Fulcrum 0.1";
    report.provenance.as_of = 1'763'700'000'000;
    report.person_id = "6f1f3bd0-0000-4000-8000-000000000001";
    report.login = "ada";
    report.name = "=HYPERLINK(\"x\")";
    report.tasks = {{"A2", "Fulcrum targeting", "A"}};
    database::PersonProgress progress;
    progress.task_id = "A2";
    database::ProgressPoint passed;
    passed.attempt_id = "6f1f3bd0-0000-4000-8000-00000000000a";
    passed.number = 1;
    passed.started = 1'763'600'000'000;
    passed.mode = AttemptMode::assessed;
    passed.state = AttemptState::completed;
    passed.variant = "standard";
    passed.fidelity = "standard";
    passed.counting = true;
    passed.duration_s = 63.204;
    passed.passed = true;
    passed.points = 83.333333333333329;
    database::MetricRow length;
    length.id = "path_len";
    length.hand = "left";
    length.unit = "mm";
    length.value = 1234.5678901234567;
    passed.metrics = {length};
    database::ProgressPoint cut_off = passed;
    cut_off.attempt_id = "6f1f3bd0-0000-4000-8000-00000000000b";
    cut_off.number = 2;
    cut_off.state = AttemptState::interrupted;
    cut_off.passed.reset();
    cut_off.points.reset();
    cut_off.counting = false;
    cut_off.not_scored_because = StatementId::never_inside;
    cut_off.metrics.clear();
    progress.series.push_back({DeviceClass::haptic, {passed, cut_off}});
    progress.voided.push_back({"6f1f3bd0-0000-4000-8000-00000000000c", 1'763'500'000'000, 1'763'650'000'000});
    report.progress.push_back(progress);
    return report;
}

TEST(Workbook, HoldsEveryCellOfTheSheetAsWordsAndNumbersAndNoFormula) {
    const PersonReport report = attempts_of_ada();
    const DataSheet sheet = person_sheet(report);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("ada.xlsx"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(workbook(sheet, report.provenance)));
    file.close();
    const std::map<std::string, QString> cells = cells_of(path, "xl/worksheets/sheet1.xml");
    std::size_t filled = 0;
    for (std::size_t column = 0; column < sheet.columns.size(); ++column) {
        EXPECT_EQ(cells.at(reference(column, 0)).toStdString(), sheet.columns[column].name);
        EXPECT_EQ(cells.at(reference(column, 1)).toStdString(), sheet.columns[column].unit);
        filled += 2;
        for (std::size_t row = 0; row < sheet.rows.size(); ++row) {
            const SheetCell& cell = sheet.rows[row][column];
            const auto found = cells.find(reference(column, row + 2));
            if (std::holds_alternative<std::monostate>(cell)) {
                EXPECT_EQ(found, cells.end()) << sheet.columns[column].name;
                continue;
            }
            ASSERT_NE(found, cells.end()) << sheet.columns[column].name;
            ++filled;
            if (const auto* words = std::get_if<std::string>(&cell)) {
                EXPECT_EQ(found->second.toStdString(), *words);
            } else if (const auto* number = std::get_if<double>(&cell)) {
                EXPECT_NEAR(found->second.toDouble(), *number, 1e-15 * std::abs(*number));
            } else if (const auto* count = std::get_if<long long>(&cell)) {
                EXPECT_EQ(found->second.toLongLong(), *count);
            } else {
                EXPECT_EQ(found->second, std::get<bool>(cell) ? QStringLiteral("1") : QStringLiteral("0"));
            }
        }
    }
    EXPECT_EQ(cells.size(), filled);
    const std::map<std::string, QString> dictionary = cells_of(path, "xl/worksheets/sheet2.xml");
    EXPECT_EQ(dictionary.at("A1"), QStringLiteral("column"));
    for (std::size_t column = 0; column < sheet.columns.size(); ++column)
        EXPECT_EQ(dictionary.at(reference(2, column + 1)).toStdString(), sheet.columns[column].meaning);
    EXPECT_EQ(cells_of(path, "xl/worksheets/sheet3.xml").at("B1"), QStringLiteral("Surgery"));
}

TEST(PersonSheet, KeepsVersionsOfAMetricApart) {
    PersonReport report = attempts_of_ada();
    std::vector<database::ProgressPoint>& points = report.progress[0].series[0].points;
    points[1].metrics = points[0].metrics;
    points[1].metrics[0].version = points[0].metrics[0].version + 1;
    points[1].metrics[0].value = 2;
    const DataSheet sheet = person_sheet(report);
    const auto place = [&](const std::string& name) {
        std::size_t at = 0;
        while (at < sheet.columns.size() && sheet.columns[at].name != name) ++at;
        return at;
    };
    const std::size_t newer = place("path_len.left"), older = place("path_len.left@1");
    ASSERT_LT(newer, sheet.columns.size());
    ASSERT_LT(older, sheet.columns.size());
    EXPECT_EQ(sheet.columns[newer].meaning.substr(0, 10), "path_len@2");
    EXPECT_EQ(sheet.columns[older].meaning.substr(0, 10), "path_len@1");
    EXPECT_TRUE(sheet.rows[0][older] == SheetCell(1234.5678901234567));
    EXPECT_TRUE(sheet.rows[0][newer] == SheetCell());
    EXPECT_TRUE(sheet.rows[1][older] == SheetCell());
    EXPECT_TRUE(sheet.rows[1][newer] == SheetCell(2.0));
    const DataSheet one_version = person_sheet(attempts_of_ada());
    EXPECT_EQ(one_version.columns.size() + 1, sheet.columns.size());
}

TEST(XapiStatements, FollowTheSpecificationAndNameNobody) {
    const std::string text = xapi_statements({attempts_of_ada()}, home);
    const std::string schema =
        read_text_file(test::source_path("assets/schemas/xapi_statements.schema.json"), 1U << 20U);
    EXPECT_NO_THROW(JsonDocument::parse(text, "statements").check_schema(schema.c_str())) << text;
    EXPECT_EQ(text.find("ada"), std::string::npos);
    EXPECT_EQ(text.find("HYPERLINK"), std::string::npos);
    const nlohmann::json statements = nlohmann::json::parse(text);
    ASSERT_EQ(statements.size(), 3U);
    const nlohmann::json& passed = statements[0];
    EXPECT_EQ(passed["verb"]["id"], "http://adlnet.gov/expapi/verbs/passed");
    EXPECT_EQ(passed["actor"]["account"]["name"], "6f1f3bd0-0000-4000-8000-000000000001");
    EXPECT_EQ(passed["result"]["score"]["raw"].get<double>(), 83.333333333333329);
    EXPECT_EQ(passed["result"]["score"]["scaled"].get<double>(), 83.333333333333329 / 100);
    EXPECT_EQ(passed["result"]["success"], true);
    EXPECT_EQ(passed["result"]["duration"], "PT63.20S");
    EXPECT_EQ(passed["result"]["extensions"]["urn:fulcrum:xapi:metrics"][0]["value"].get<double>(),
              1234.5678901234567);
    const nlohmann::json& cut_off = statements[1];
    EXPECT_EQ(cut_off["verb"]["id"], "http://adlnet.gov/expapi/verbs/attempted");
    EXPECT_FALSE(cut_off["result"].contains("score"));
    EXPECT_FALSE(cut_off["result"].contains("success"));
    EXPECT_EQ(cut_off["result"]["completion"], false);
}

TEST(Reports, PracticeOfAPartIsNotTheCompletionOfTheTask) {
    PersonReport report = attempts_of_ada();
    database::ProgressPoint& part = report.progress[0].series[0].points[1];
    part.mode = AttemptMode::practice;
    part.state = AttemptState::completed;
    part.not_scored_because = Statement();
    part.continues = true;
    const nlohmann::json statement = nlohmann::json::parse(xapi_statements({report}, home))[1];
    EXPECT_EQ(statement["verb"]["id"], "http://adlnet.gov/expapi/verbs/attempted");
    EXPECT_EQ(statement["result"]["completion"], false);
    EXPECT_FALSE(statement["result"].contains("success"));
    const std::string why = statement["result"]["extensions"]["urn:fulcrum:xapi:not-scored-because"];
    EXPECT_NE(why.find("never scored"), std::string::npos) << why;

    const nlohmann::json points =
        nlohmann::json::parse(person_json(report))["tasks"][0]["series"][0]["attempts"];
    EXPECT_EQ(points[0]["continues"], false);
    EXPECT_EQ(points[1]["continues"], true);
    EXPECT_EQ(points[1]["not_scored_because"], why);
    const DataSheet sheet = person_sheet(report);
    const auto column = std::find_if(sheet.columns.begin(), sheet.columns.end(),
                                     [](const SheetColumn& one) { return one.name == "continues"; });
    ASSERT_NE(column, sheet.columns.end());
    const auto at = static_cast<std::size_t>(column - sheet.columns.begin());
    EXPECT_TRUE(sheet.rows[0][at] == SheetCell(false));
    EXPECT_TRUE(sheet.rows[1][at] == SheetCell(true));
}

TEST(XapiStatements, VoidWhatWasTakenOutByTheIdThatItWasSentWith) {
    PersonReport report = attempts_of_ada();
    const nlohmann::json statements = nlohmann::json::parse(xapi_statements({report}, home));
    const nlohmann::json& voiding = statements[2];
    EXPECT_EQ(voiding["verb"]["id"], "http://adlnet.gov/expapi/verbs/voided");
    EXPECT_EQ(voiding["object"]["objectType"], "StatementRef");
    // The same attempt before it was voided.
    database::ProgressPoint point = report.progress[0].series[0].points[0];
    point.attempt_id = report.progress[0].voided[0].attempt_id;
    report.progress[0].series[0].points = {point};
    report.progress[0].voided.clear();
    const nlohmann::json before = nlohmann::json::parse(xapi_statements({report}, home));
    EXPECT_EQ(before[0]["id"], voiding["object"]["id"]);
    EXPECT_NE(before[0]["id"], voiding["id"]);
}

TEST(XapiStatements, NameTheAttemptThatTheyAreAbout) {
    const PersonReport report = attempts_of_ada();
    std::vector<std::string> attempts;
    each_xapi_statement(report, home,
                        [&](XapiStatement&& made) { attempts.push_back(std::move(made.attempt_id)); });
    const std::vector<database::ProgressPoint>& points = report.progress[0].series[0].points;
    EXPECT_EQ(attempts, (std::vector<std::string>{points[0].attempt_id, points[1].attempt_id,
                                                  report.progress[0].voided[0].attempt_id}));
}

TEST(XapiStatements, HaveTheSameIdsEachTimeAndOthersAtAnotherAddress) {
    const auto ids = [](const std::string& address) {
        std::set<std::string> found;
        for (const nlohmann::json& one : nlohmann::json::parse(xapi_statements({attempts_of_ada()}, address)))
            found.insert(one["id"].get<std::string>());
        return found;
    };
    EXPECT_EQ(ids(home).size(), 3U);
    EXPECT_EQ(ids(home), ids(home));
    EXPECT_EQ(ids(home), ids(std::string(home) + "/"));
    for (const std::string& id : ids("https://elsewhere.example")) EXPECT_EQ(ids(home).count(id), 0U);
}

TEST(XapiStatements, AreRefusedWithoutAnAddressOfTheWeb) {
    for (const char* wrong : {"", "training", "ftp://training.example", "https://", "mailto:a@b.example"})
        EXPECT_THROW(xapi_statements({attempts_of_ada()}, wrong), InputError) << wrong;
}

TEST(ReportFormat, IsFoundByTheEndingOfTheFileAndByItsName) {
    for (const ReportFormatRow& row : report_formats) EXPECT_EQ(parse_report_format(row.name), row.kind);
    try {
        parse_report_format("odt");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("xlsx"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace fulcrum::ui
