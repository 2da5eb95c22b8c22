// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt's report: the same values as CSV, as JSON and in words; a PDF of one page.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "assessment/assets/assets.h"
#include "assessment/pathology/pathology.h"
#include "tests/ui/reports/pdf_pages.h"
#include "ui/language/language.h"
#include "ui/reports/pathology_words.h"
#include "ui/reports/report.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

constexpr double mm = 1e-3;

/// All four levels divided at a signed distance of each, 6 mm too shallow on the left of the third.
PathologyReport dissection(double inwards = 9 * mm) {
    SpecimenPlan plan{4,      60 * mm, 20 * mm,
                      3 * mm, 6 * mm,  18 * mm,
                      2 * mm, 10 * mm, Tumour{1, Sector::mid, 8 * mm, 12 * mm}};
    std::vector<CutStroke> strokes(1);
    for (int i = 0; i < 240; ++i) {
        CutElement e;
        e.begin = 0.1 * i;
        e.end = e.begin + 0.1;
        e.from = i * mm;
        e.to = (i + 1) * mm;
        e.from_distance = e.distance = i >= 165 && i < 175 ? -inwards : 0.4 * mm;
        e.length = mm;
        strokes[0].elements.push_back(e);
    }
    return pathology_report(strokes, plan);
}

AttemptPaper paper() {
    AttemptPaper paper;
    paper.provenance.programme = "Surgery";
    paper.provenance.as_of = 1'763'700'000'000;
    paper.task = {"C4", "Posterior dissection", "C"};
    database::AttemptSummary& attempt = paper.report.attempt;
    attempt.meta.id = "a1";
    attempt.meta.task_id = "C4";
    attempt.meta.mode = AttemptMode::assessed;
    attempt.meta.device_class = DeviceClass::haptic;
    attempt.meta.started = 1'763'600'000'000;
    attempt.person_login = "ada";
    attempt.person_name = "Ada Lovelace";
    attempt.state = AttemptState::completed;
    attempt.passed = false;
    attempt.points = 41.5;
    database::ScoreRow score;
    score.advice = Statement::plain("Stay on the shiny surface of the mesorectum.");
    score.gates.push_back(
        {"tme_grade", "", "", GateKind::absolute, 2.0, "-", 3.0, "Quirke", {}, {}, false, false, {}});
    score.metrics.push_back({"tme_grade", 1, "", "", 2.0, {}, "-", Direction::higher, {{16, 17}}});
    score.metrics.push_back({"sparc",
                             1,
                             "left",
                             "",
                             {},
                             {StatementId::few_movements, {{"count", 3.0}, {"least", 5.0}}},
                             "-",
                             Direction::higher,
                             {}});
    paper.report.pathology = dissection();
    score.pathology = pathology_json(*paper.report.pathology);
    paper.report.score = score;
    return paper;
}

TEST(AttemptReport, CsvJsonAndWordsContainTheSameValues) {
    const AttemptPaper one = paper();
    const nlohmann::json json = nlohmann::json::parse(attempt_json(one));
    EXPECT_EQ(json["pathology"]["tme_grade"], 2);
    EXPECT_EQ(json["pathology"]["grade_reasons"][0], "defect");
    EXPECT_EQ(json["gates"][0]["passed"], false);
    ASSERT_EQ(json["pathology"]["findings"].size(), 12U);
    std::istringstream csv(attempt_csv(one));
    std::string line;
    int findings = 0;
    while (std::getline(csv, line)) {
        std::vector<std::string> cells(1);
        bool quoted = false;
        for (const char c : line) {
            if (c == '"') quoted = !quoted;
            if (c == ',' && !quoted) {
                cells.emplace_back();
            } else if (c != '\r') {
                cells.back() += c;
            }
        }
        ASSERT_EQ(cells.size(), 14U) << line;
        if (cells[4] != "pathology.defect" || cells[8] == "all") continue;
        const nlohmann::json& finding = json["pathology"]["findings"][static_cast<std::size_t>(findings++)];
        EXPECT_EQ(std::to_string(finding["level"].get<int>() + 1), cells[8]);
        EXPECT_EQ(finding["sector"], cells[9]);
        EXPECT_NEAR(finding["defect_mm"].get<double>(), std::stod(cells[10]), 1e-9);
        const QStringList row = pathology_rows(*one.report.pathology)[static_cast<std::size_t>(findings - 1)];
        EXPECT_NEAR(row[9].toDouble(), std::stod(cells[10]), 0.051);
    }
    EXPECT_EQ(findings, 12);
}

database::RatingRow rating(const char* form, const char* rater, FormAnswers answers) {
    database::RatingRow row;
    row.form = load_form(asset_path("forms/" + std::string(form) + ".json"));
    row.rater_name = rater;
    row.blinding = database::Blinding::kept;
    row.handed_in = 1'763'610'000'000;
    row.released = 1'763'620'000'000;
    row.answers = std::move(answers);
    row.answered.assign(row.answers.size(), true);
    return row;
}

/// The attempt with two GOALS ratings and one OSATS rating, in which an item was not seen.
AttemptPaper rated_paper() {
    AttemptPaper one = paper();
    one.ratings = {rating("goals", "Ed Educator", {4, 3, 2, 5, 3}),
                   rating("goals", "Ida Instructor", {5, 4, 4, 4, 4}),
                   rating("osats", "=Ed", {4, 4, 4, std::nullopt, 3, 3, 3})};
    one.ratings[1].remark = "Calm hands.";
    return one;
}

TEST(AttemptReport, RatingsAreInCsvAndJson) {
    const AttemptPaper one = rated_paper();
    const nlohmann::json ratings = nlohmann::json::parse(attempt_json(one))["ratings"];
    ASSERT_EQ(ratings.size(), 3U);
    EXPECT_EQ(ratings[0]["form"], "goals@1");
    EXPECT_EQ(ratings[0]["sum"], 17);
    EXPECT_EQ(ratings[0]["sum_highest"], 25);
    EXPECT_EQ(ratings[0]["blinding"], "kept");
    EXPECT_TRUE(ratings[0]["remark"].is_null());
    EXPECT_EQ(ratings[1]["remark"], "Calm hands.");
    EXPECT_TRUE(ratings[2]["items"][3]["value"].is_null());
    EXPECT_EQ(ratings[2]["sum"], 21);
    const std::string csv = attempt_csv(one);
    const auto lines_with = [&](const std::string& part) {
        std::istringstream rows(csv);
        std::vector<std::string> found;
        for (std::string line; std::getline(rows, line);)
            if (line.find(part) != std::string::npos) found.push_back(line);
        return found;
    };
    EXPECT_EQ(lines_with(",rating.goals.").size(), 10U);
    const auto efficiency = lines_with(",rating.goals.efficiency,1,,,,,");
    ASSERT_EQ(efficiency.size(), 2U);
    EXPECT_NE(efficiency[0].find(",2,-,,Ed Educator"), std::string::npos) << efficiency[0];
    EXPECT_NE(efficiency[1].find(",4,-,,Ida Instructor"), std::string::npos) << efficiency[1];
    const auto unseen = lines_with(",rating.osats.knowledge_of_instruments,");
    ASSERT_EQ(unseen.size(), 1U);
    EXPECT_NE(unseen[0].find(",,-,not seen,'=Ed"), std::string::npos) << unseen[0];
    EXPECT_TRUE(nlohmann::json::parse(attempt_json(paper()))["ratings"].empty());
}

TEST(AttemptReport, RatingsArePrintedAndMoveToAPageOfTheirOwnWhereThereIsNoRoom) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("rated.pdf");
    AttemptPaper one = rated_paper();
    write_attempt_pdf(one, plain(path));
    const QList<QByteArray> pages = pages_of(plain(path));
    ASSERT_EQ(pages.size(), 2) << "the pathology report fills the first";
    EXPECT_FALSE(pages[0].contains("Ida Instructor"));
    for (const char* words : {"Ratings with observer forms", "Depth perception", "Ida Instructor", "17 of 25",
                              "Calm hands.", "not seen", "blind"})
        EXPECT_TRUE(pages[1].contains(words)) << words;
    for (const QByteArray& page : pages) EXPECT_TRUE(page.contains("attempt a1")) << "its foot";
    const QByteArray kept = qgetenv("FULCRUM_REPORT_PAGE");  // for inspection
    if (!kept.isEmpty()) QFile::copy(path, QString::fromLocal8Bit(kept + "-rated.pdf"));
    one.report.pathology.reset();
    write_attempt_pdf(one, plain(path));
    EXPECT_EQ(pages_of(plain(path)).size(), 1);
}

TEST(AttemptReport, TheTableOfSectorsMovesToTheNextPageInOnePieceWhereThereIsNoRoom) {
    const QTemporaryDir folder;
    const std::string path = plain(folder.filePath("long.pdf"));
    AttemptPaper one = paper();
    database::GateRow gate = one.report.score->gates.front();
    for (int more = 0; more < 13; ++more) one.report.score->gates.push_back(gate);
    write_attempt_pdf(one, path);
    const QList<QByteArray> pages = pages_of(path);
    ASSERT_EQ(pages.size(), 2);
    EXPECT_TRUE(pages[0].contains("Circumferential margin"));
    EXPECT_FALSE(pages[0].contains("Median mm")) << "the table would run over the foot";
    for (const char* words : {"Median mm", "Levels from cranial to caudal", "attempt a1"})
        EXPECT_TRUE(pages[1].contains(words)) << words;
}

TEST(AttemptReport, InGermanIsAGermanPageWhileTheTablesKeepEveryByte) {
    const std::string csv = attempt_csv(paper()), json = attempt_json(paper());
    use_language(Language::german);
    const std::string csv_in_german = attempt_csv(paper()), json_in_german = attempt_json(paper());
    const QTemporaryDir folder;
    const QString path = folder.filePath("attempt.pdf");
    write_attempt_pdf(paper(), plain(path));
    use_language(Language::english);
    EXPECT_EQ(csv_in_german, csv);
    EXPECT_EQ(json_in_german, json);
    const QList<QByteArray> pages = pages_of(plain(path));
    ASSERT_EQ(pages.size(), 1);
    const QString page = QString::fromUtf8(pages[0]);
    EXPECT_TRUE(page.contains(QStringLiteral("Pathologiebericht (simuliert)"))) << page.toStdString();
    EXPECT_FALSE(page.contains(QStringLiteral("Pathology report"))) << page.toStdString();
    EXPECT_TRUE(page.contains(QStringLiteral("41,5"))) << page.toStdString();
    const QByteArray kept = qgetenv("FULCRUM_REPORT_PAGE");  // for inspection
    if (!kept.isEmpty()) QFile::copy(path, QString::fromLocal8Bit(kept + "-de.pdf"));
}

TEST(AttemptReport, AVoidedAttemptIsVoidedOnPaperTooAndHasNoResult) {
    const QTemporaryDir folder;
    const std::string path = plain(folder.filePath("voided.pdf"));
    AttemptPaper one = paper();
    one.report.pathology.reset();
    database::AttemptSummary& attempt = one.report.attempt;
    attempt.passed = true;
    attempt.points = 85;
    write_attempt_pdf(one, path);
    EXPECT_TRUE(pages_of(path).value(0).contains("Passed")) << pages_of(path).value(0).toStdString();
    EXPECT_TRUE(nlohmann::json::parse(attempt_json(one))["voided"].is_null());
    EXPECT_EQ(attempt_csv(one).find("voided"), std::string::npos);
    attempt.state = AttemptState::voided;
    attempt.recorded_state = AttemptState::completed;
    attempt.voided_by = "Eve Educator";
    attempt.voided_at = 1'763'650'000'000;
    attempt.void_reason = "wrong person";
    attempt.reassigned_to = "a2";
    write_attempt_pdf(one, path);
    const QList<QByteArray> pages = pages_of(path);
    ASSERT_EQ(pages.size(), 1);
    for (const char* words : {"Voided", "Voided by Eve Educator", "wrong person", "It does not count.",
                              "A copy was stored", "completed"})
        EXPECT_TRUE(pages[0].contains(words)) << words << " in " << pages[0].toStdString();
    for (const char* words : {"Passed", "85 of 100"})
        EXPECT_FALSE(pages[0].contains(words)) << words << " in " << pages[0].toStdString();
    const nlohmann::json json = nlohmann::json::parse(attempt_json(one));
    EXPECT_EQ(json["state"], "voided");
    EXPECT_EQ(json["voided"]["time"], database::iso_utc(attempt.voided_at));
    EXPECT_EQ(json["voided"]["reason"], "wrong person");
    EXPECT_EQ(json["passed"], true) << "what the score has";
    std::istringstream csv(attempt_csv(one));
    std::string line;
    for (int i = 0; i < 3; ++i) std::getline(csv, line);
    EXPECT_EQ(line.rfind("a1,ada,C4,", 0), 0U) << line;
    EXPECT_NE(line.find(",voided,,,,,,,-,wrong person,"), std::string::npos) << line;
}

TEST(AttemptReport, UsesThePathologistsTerms) {
    const auto words = [](const PathologyReport& report, const char* title) {
        QString all;
        for (const PathologyLine& line : pathology_lines(report))
            if (line.title == QLatin1String(title)) all += line.words;
        return all.toStdString();
    };
    const PathologyReport report = dissection();
    EXPECT_EQ(words(report, "Mesorectum"), "Grade 2, nearly complete: a defect of 6.0 mm, deeper than 5 mm.");
    EXPECT_EQ(words(report, "Defects"), "level 3, left: 6.0 mm deep, 10.0 mm wide, at 0:16.5.");
    EXPECT_NE(words(report, "Circumferential margin").find("7.4 mm, negative"), std::string::npos)
        << words(report, "Circumferential margin");
    EXPECT_NE(
        words(report, "Distal margin").find("No transection was done in this task: the distal margin is"),
        std::string::npos);
    EXPECT_NE(words(report, "Distal margin").find("34.0 mm (level 4)"), std::string::npos);
    EXPECT_NE(words(dissection(15 * mm), "Mesorectum").find("Grade 1"), std::string::npos);
    EXPECT_NE(words(dissection(0), "Mesorectum").find("Grade 3, complete"), std::string::npos);
    const PathologyReport nothing = pathology_report({}, report.plan);
    EXPECT_EQ(words(nothing, "Mesorectum"), "Not gradable: nothing was cut.");
    // Where the first decimal would hide on which side of the limit a value lies, more are shown.
    EXPECT_NE(words(dissection(8.02 * mm), "Mesorectum").find("a defect of 5.02 mm"), std::string::npos)
        << words(dissection(8.02 * mm), "Mesorectum");
    EXPECT_EQ(pathology_rows(nothing).size(), 16U);
    EXPECT_EQ(pathology_rows(nothing)[0][3], QStringLiteral("–"));
}

TEST(AttemptReport, TheLegendSaysWhatPartOfTheLineIsAskedFor) {
    PathologyReport report = dissection();
    EXPECT_FALSE(pathology_legend(report).contains("The task asks")) << "all of it";
    report.plan.asked = 240 * mm;
    EXPECT_FALSE(pathology_legend(report).contains("The task asks")) << "all of it";
    report.plan.asked = 224 * mm;
    EXPECT_TRUE(pathology_legend(report).endsWith(
        " The task asks for 224.0 of 240.0 mm of the line; shares divided are of that."))
        << pathology_legend(report).toStdString();
}

TEST(AttemptReport, IsOnePdfPage) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("attempt.pdf");
    write_attempt_pdf(paper(), plain(path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray pdf = file.readAll();
    EXPECT_TRUE(pdf.startsWith("%PDF"));
    EXPECT_TRUE(pdf.contains("/Count 1")) << "one page";
    const QByteArray kept = qgetenv("FULCRUM_REPORT_PAGE");  // for inspection
    if (!kept.isEmpty()) QFile::copy(path, QString::fromLocal8Bit(kept));
    // An attempt without a specimen also has a page.
    AttemptPaper plain_one = paper();
    plain_one.report.pathology.reset();
    write_attempt_pdf(plain_one, plain(folder.filePath("plain.pdf")));
    EXPECT_TRUE(QFile::exists(folder.filePath("plain.pdf")));
    EXPECT_TRUE(nlohmann::json::parse(attempt_json(plain_one))["pathology"].is_null());
}

}  // namespace
}  // namespace fulcrum::ui
