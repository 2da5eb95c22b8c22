// SPDX-License-Identifier: GPL-3.0-or-later
// Released ratings in the reports of a person and a cohort: the same values in PDF, CSV, XLSX, JSON and xAPI,
// and none of a form that was not released, was struck out with its attempt, or is a draft.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "database/records/ratings.h"
#include "sim_core/scene/json_document.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/support.h"
#include "tests/ui/reports/pdf_pages.h"
#include "tests/ui/reports/workbook_cells.h"
#include "ui/reports/report_sheet.h"
#include "ui/reports/report_xapi.h"

namespace fulcrum::ui {
namespace {

using database::test::Programme;
constexpr const char* ratings_home = "https://training.example";

class RatedReports : public ::testing::Test {
  protected:
    void SetUp() override {
        programme.people().set_educators(programme.session("director"), programme.cohort,
                                         {programme.id("educator"), programme.id("other_educator")});
        first = programme.record("ann");
        programme.clock.pass_s(60);
        second = programme.record("ann");
        programme.clock.pass_s(60);
        rate("educator", first, "goals", {5, 4, 3, 2, 1});
        rate("other_educator", first, "goals", {3, 3, 3, 3, 4});
        rate("educator", first, "osats", {5, 5, 5, {}, 5, 5, 5});
        ratings().release(programme.session("educator"), first);
        rate("educator", second, "goals", {1, 1, 1, 1, 1});  // not released
        const std::string third = programme.record("ann");
        voided = rate("educator", third, "goals", {2, 2, 2, 2, 2});
        ratings().release(programme.session("educator"), third);
        programme.attempts().void_attempt(programme.session("educator"), third, "wrong person");
        ratings().begin(programme.session("other_educator"), second, form("goals"));  // a draft
        tasks = {load_task(task_file("A2"))};
    }
    database::Ratings ratings() const { return database::Ratings(*programme.store); }
    static ObserverForm form(const std::string& id) { return load_form(asset_path("forms/" + id + ".json")); }
    std::string rate(const char* login, const std::string& attempt, const char* id,
                     const FormAnswers& answers) const {
        const database::Session& rater = programme.session(login);
        if (login == std::string("other_educator")) ratings().note_seen(rater, attempt);
        const std::string rating = ratings().begin(rater, attempt, form(id));
        ratings().answer(rater, rating, answers, std::vector<bool>(answers.size(), true), "");
        ratings().hand_in(rater, rating);
        return rating;
    }
    PersonReport person(const char* by = "director") const {
        return gather_person(*programme.store, programme.session(by), programme.id("ann"), tasks, "0.1.0");
    }
    CohortReport cohort() const {
        return *gather_cohort(*programme.store, programme.session("director"), programme.cohort, tasks,
                              "0.1.0", PeoplePages::pages);
    }
    std::map<std::string, QString> cells(const DataSheet& sheet, std::size_t row) const {
        const QString path = folder.filePath(QStringLiteral("sheet.xlsx"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(workbook(sheet, ReportProvenance())));
        file.close();
        const std::map<std::string, QString> all = cells_of(path, "xl/worksheets/sheet1.xml");
        std::map<std::string, QString> found;
        for (std::size_t i = 0; i < sheet.columns.size(); ++i) {
            const auto cell = all.find(reference(i, row + 2));
            if (cell != all.end()) found[sheet.columns[i].name] = cell->second;
        }
        return found;
    }
    /// The cells of a row of the CSV by column; a row of values comes after names and units.
    static std::map<std::string, std::string> csv_cells(const DataSheet& sheet, std::size_t row) {
        const QStringList lines = QString::fromStdString(sheet_csv(sheet)).split(QStringLiteral("\r\n"));
        const QStringList names = lines[0].split(QLatin1Char(',')),
                          values = lines[static_cast<int>(row) + 2].split(QLatin1Char(','));
        EXPECT_EQ(names.size(), values.size()) << "no value here holds a comma";
        std::map<std::string, std::string> found;
        for (int i = 0; i < names.size(); ++i) found[names[i].toStdString()] = values[i].toStdString();
        return found;
    }

    Programme programme;
    QTemporaryDir folder;
    std::string first, second, voided;
    std::vector<TaskDefinition> tasks;
    // (4 + 3 + 2 + 1 + 0) / 20 and (2 + 2 + 2 + 2 + 3) / 20; each rater weighs the same.
    static constexpr double goals = (0.5 + 0.55) / 2;
};

TEST_F(RatedReports, OfAPersonHaveTheSameValuesInEveryFormat) {
    const PersonReport report = person();
    const DataSheet sheet = person_sheet(report);
    ASSERT_EQ(sheet.rows.size(), 2U);
    const auto csv = csv_cells(sheet, 0);
    const auto xlsx = cells(sheet, 0);
    const nlohmann::json json = nlohmann::json::parse(person_json(report));
    const nlohmann::json& attempt = json.at("tasks")[0].at("series")[0].at("attempts")[0];
    const nlohmann::json& rated = attempt.at("rated")[0];
    ASSERT_EQ(attempt.at("ratings").size(), 3U);
    ASSERT_EQ(attempt.at("rated").size(), 2U);
    EXPECT_EQ(rated.at("form"), "goals@1");
    EXPECT_NEAR(rated.at("scaled").get<double>(), goals, 1e-12);
    EXPECT_EQ(rated.at("forms"), 2);
    const std::map<std::string, double> items{{"depth_perception", 4},
                                              {"bimanual_dexterity", 3.5},
                                              {"efficiency", 3},
                                              {"tissue_handling", 2.5},
                                              {"autonomy", 2.5}};
    for (const auto& [item, mean] : items) {
        const std::string column = "rating.goals@1." + item;
        EXPECT_NEAR(rated.at("items").at(item).get<double>(), mean, 1e-12) << item;
        EXPECT_NEAR(std::stod(csv.at(column)), mean, 1e-12) << item;
        EXPECT_NEAR(xlsx.at(column).toDouble(), mean, 1e-12) << item;
    }
    for (const char* column : {"rating.goals@1.raters", "rating.goals@1.scaled"}) {
        const double value = std::string(column).find("raters") == std::string::npos ? goals : 2;
        EXPECT_NEAR(std::stod(csv.at(column)), value, 1e-12) << column;
        EXPECT_NEAR(xlsx.at(column).toDouble(), value, 1e-12) << column;
    }
    EXPECT_EQ(csv.at("rating.osats@1.knowledge_of_instruments"), "") << "not seen";
    EXPECT_EQ(xlsx.count("rating.osats@1.knowledge_of_instruments"), 0U);
    EXPECT_EQ(csv_cells(sheet, 1).at("rating.goals@1.raters"), "") << "handed in, not released";
    // The statements hold each form; their mean is the value of the tables.
    const std::string text = xapi_statements({report}, ratings_home);
    const std::string schema =
        read_text_file(test::source_path("assets/schemas/xapi_statements.schema.json"), 1U << 20U);
    EXPECT_NO_THROW(JsonDocument::parse(text, "statements").check_schema(schema.c_str())) << text;
    double sum = 0;
    int forms = 0, instructors = 0;
    for (const nlohmann::json& one : nlohmann::json::parse(text)) {
        if (one["verb"]["id"] != "http://adlnet.gov/expapi/verbs/scored") continue;
        const nlohmann::json& extensions = one["context"]["extensions"];
        EXPECT_EQ(one["actor"]["account"]["name"], programme.id("ann"));
        if (one["context"].contains("instructor")) {
            ++instructors;
            EXPECT_EQ(one["context"]["instructor"]["account"]["name"], programme.id("other_educator"));
            EXPECT_EQ(extensions["urn:fulcrum:xapi:blinding"], "lifted");
        }
        if (extensions["urn:fulcrum:xapi:form"] != "goals@1") continue;
        ++forms;
        sum += one["result"]["score"]["scaled"].get<double>();
        EXPECT_EQ(one["result"]["score"]["max"], 25);
    }
    EXPECT_EQ(forms, 2);
    EXPECT_NEAR(sum / 2, goals, 1e-12);
    EXPECT_EQ(text.find("Cator"), std::string::npos) << "nobody is named";
    // On paper, rounded as everywhere on screens.
    const std::string path = folder.filePath(QStringLiteral("ann.pdf")).toStdString();
    write_person_pdf(report, path);
    const QList<QByteArray> pages = pages_of(path);
    ASSERT_FALSE(pages.isEmpty());
    EXPECT_TRUE(pages[0].contains("Ratings by observers"));
    EXPECT_TRUE(pages[0].contains("52.5 %")) << pages[0].constData();
    EXPECT_TRUE(pages[0].contains("100 %")) << "OSATS";
}

TEST_F(RatedReports, OfACohortHaveTheSameValuesInEveryFormat) {
    const CohortReport report = cohort();
    const DataSheet sheet = cohort_sheet(report);
    std::size_t row = 0;
    while (report.table.rows[row].login != "ann") ++row;
    const auto csv = csv_cells(sheet, row);
    const auto xlsx = cells(sheet, row);
    const nlohmann::json json = nlohmann::json::parse(cohort_json(report));
    const nlohmann::json& rated = json["rows"][row]["ratings"][0];
    EXPECT_EQ(rated["form"], "goals@1");
    const std::map<std::string, double> values{{"attempts", 1}, {"forms", 2}, {"scaled", goals}};
    for (const auto& [name, value] : values) {
        EXPECT_NEAR(rated[name].get<double>(), value, 1e-12) << name;
        EXPECT_NEAR(std::stod(csv.at("rating.goals@1." + name)), value, 1e-12) << name;
        EXPECT_NEAR(xlsx.at("rating.goals@1." + name).toDouble(), value, 1e-12) << name;
    }
    for (std::size_t other = 0; other < report.table.rows.size(); ++other) {
        if (other == row) continue;
        EXPECT_EQ(csv_cells(sheet, other).at("rating.goals@1.scaled"), "");
    }
    const std::string path = folder.filePath(QStringLiteral("year.pdf")).toStdString();
    write_cohort_pdf(report, path);
    EXPECT_TRUE(pages_of(path)[0].contains("GOALS: 52.5 %")) << pages_of(path)[0].constData();
    const auto people =
        gather_people(*programme.store, programme.session("director"), programme.cohort, tasks, "0.1.0");
    ASSERT_TRUE(people);
    EXPECT_NE(xapi_statements(*people, ratings_home).find("scored"), std::string::npos);
}

TEST_F(RatedReports, StatementsOfAVoidedAttemptsRatingsAreVoidedByTheirIds) {
    const std::string text = xapi_statements({person()}, ratings_home);
    std::set<std::string> sent, referred;
    for (const nlohmann::json& one : nlohmann::json::parse(text)) {
        EXPECT_TRUE(sent.insert(one["id"].get<std::string>()).second) << "an id twice";
        if (one["verb"]["id"] == "http://adlnet.gov/expapi/verbs/voided")
            referred.insert(one["object"]["id"].get<std::string>());
    }
    EXPECT_EQ(referred.size(), 2U) << "the attempt and its rating";
    for (const std::string& id : referred) EXPECT_EQ(sent.count(id), 0U);
}

TEST_F(RatedReports, ATraineeExportsTheSame) {
    EXPECT_EQ(sheet_csv(person_sheet(person("ann"))), sheet_csv(person_sheet(person())));
    EXPECT_EQ(xapi_statements({person("ann")}, ratings_home), xapi_statements({person()}, ratings_home));
}

}  // namespace
}  // namespace fulcrum::ui
