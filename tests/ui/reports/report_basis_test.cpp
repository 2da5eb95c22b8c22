// SPDX-License-Identifier: GPL-3.0-or-later
// What reports say of themselves in every format: the files behind the values with their digests, the
// program, and that the store is not tamper-evident while its owner is whoever runs the window.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QCryptographicHash>
#include <QFile>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "assessment/assets/assets.h"
#include "database/rows/crypto.h"
#include "database/store/accepted_assets.h"
#include "tests/database/programme_fixture.h"
#include "tests/ui/reports/pdf_pages.h"
#include "tests/ui/reports/workbook_cells.h"
#include "ui/language/language.h"
#include "ui/reports/report.h"

namespace fulcrum::ui {
namespace {

using database::AssetFile;

class ReportBasis : public ::testing::Test {
  protected:
    ReportBasis() {
        for (const AssetFile& file : database::delivered_assets())
            if (file.name == "tasks/A2.json" || file.name == "scenes/a2_targets.json") files.push_back(file);
        files.push_back({"benchmarks/A2.json", database::sha256_hex("limits of our experts")});
        database::AcceptedAssets(*programme.store)
            .accept(programme.session("educator"), files.back(), "from our experts");
        database::AttemptMeta meta = database::test::example_meta(programme.id("ann"), "A2");
        meta.assets = files;
        database::Recorder recorder(programme.path, programme.session("ann"), meta,
                                    programme.clock.options());
        database::test::Programme::append_second(recorder);
        recorder.finish(database::test::example_result(true, 70));
        attempt = recorder.attempt_id();
        QFile program(QStringLiteral("/proc/self/exe"));
        QCryptographicHash hash(QCryptographicHash::Sha256);
        EXPECT_TRUE(program.open(QIODevice::ReadOnly) && hash.addData(&program));
        program_digest = QString::fromLatin1(hash.result().toHex()).toStdString();
    }
    ~ReportBasis() override { use_language(Language::english); }
    std::string write(ReportFormat format, const char* name, const std::string& of_attempt = {}) {
        ReportRequest request;
        request.format = format;
        request.path = programme.folder.filePath(QString::fromLatin1(name)).toStdString();
        if (of_attempt.empty())
            request.cohort_id = programme.cohort;
        else
            request.attempt_id = of_attempt;
        write_report(*programme.store, programme.session("director"), request, {load_task(task_file("A2"))},
                     "0.1.0");
        return request.path;
    }
    static std::string read(const std::string& path) {
        std::ifstream file(path);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }
    /// Without the breaks of the layout.
    static std::string words_of_pdf(const std::string& path) {
        std::string words;
        for (const QByteArray& page : pages_of(path))
            words += QString::fromUtf8(page.simplified()).replace("- ", "-").toStdString() + " ";
        return words;
    }

    database::test::Programme programme;
    std::vector<AssetFile> files;
    std::string attempt, program_digest;
};

TEST_F(ReportBasis, IsInEveryFormat) {
    ASSERT_EQ(files.size(), 3U);
    const nlohmann::json json = nlohmann::json::parse(read(write(ReportFormat::json, "cohort.json")));
    const nlohmann::json& said = json.at("provenance");
    ASSERT_EQ(said.at("assets").size(), 3U) << said.dump(1);
    const std::string csv = read(write(ReportFormat::csv, "cohort.csv"));
    const auto cells = cells_of(QString::fromStdString(write(ReportFormat::xlsx, "cohort.xlsx")),
                                "xl/worksheets/sheet3.xml");
    std::string origin;
    for (const auto& [place, value] : cells) origin += value.toStdString() + "\n";
    const std::string pdf = words_of_pdf(write(ReportFormat::pdf, "cohort.pdf")),
                      paper = words_of_pdf(write(ReportFormat::pdf, "attempt.pdf", attempt));
    for (const AssetFile& file : files) {
        bool listed = false;
        for (const nlohmann::json& one : said.at("assets"))
            listed = listed || (one.at("file") == file.name && one.at("sha256") == file.digest);
        EXPECT_TRUE(listed) << file.name;
        const std::string long_line = file.name + " sha256:" + file.digest;
        EXPECT_NE(csv.find(long_line), std::string::npos) << file.name;
        EXPECT_NE(origin.find(long_line), std::string::npos) << file.name;
        for (const std::string& text : {pdf, paper})
            EXPECT_NE(text.find(file.name + " " + file.digest.substr(0, 16)), std::string::npos)
                << file.name << ": " << text;
    }
    EXPECT_EQ(said.at("program_sha256"), program_digest);
    EXPECT_NE(csv.find(program_digest), std::string::npos);
    EXPECT_NE(origin.find(program_digest), std::string::npos);
    EXPECT_NE(pdf.find("sha256:" + program_digest.substr(0, 16)), std::string::npos) << pdf;
}

TEST_F(ReportBasis, OfPracticeNamesTheFilesThatNobodyAccepted) {
    const AssetFile own{"tasks/A2.json", database::sha256_hex("four targets instead of ten")};
    database::AttemptMeta meta = database::test::example_meta(programme.id("ann"), "A2");
    meta.mode = AttemptMode::practice;
    meta.assets = {files.back(), own};
    database::Recorder recorder(programme.path, programme.session("ann"), meta, programme.clock.options());
    database::test::Programme::append_second(recorder);
    recorder.finish(database::test::example_result(true, 70));
    const std::string practice = recorder.attempt_id();
    const auto attempt_document = [&](const std::string& id) {
        return nlohmann::json::parse(read(write(ReportFormat::json, "attempt.json", id)));
    };
    const nlohmann::json json = attempt_document(practice);
    ASSERT_EQ(json.at("files_not_accepted").size(), 1U) << json.dump(1);
    EXPECT_EQ(json.at("files_not_accepted")[0].at("file"), own.name);
    EXPECT_EQ(json.at("files_not_accepted")[0].at("sha256"), own.digest);
    EXPECT_EQ(json.at("provenance").at("assets").size(), 2U) << "all that it was performed with";
    EXPECT_TRUE(attempt_document(attempt).at("files_not_accepted").empty()) << "its limits are accepted";
    const auto paper = [&] { return words_of_pdf(write(ReportFormat::pdf, "attempt.pdf", practice)); };
    EXPECT_NE(paper().find("neither part of this program nor accepted"), std::string::npos) << paper();
    EXPECT_NE(paper().find(own.name + " " + own.digest.substr(0, 16)), std::string::npos) << paper();
    EXPECT_NE(
        read(write(ReportFormat::csv, "attempt.csv", practice)).find(own.name + " sha256:" + own.digest),
        std::string::npos);
    use_language(Language::german);
    EXPECT_NE(paper().find("noch vom Programm anerkannt"), std::string::npos);
    use_language(Language::english);
    database::AcceptedAssets(*programme.store)
        .accept(programme.session("educator"), own, "a short A2 for the first day");
    EXPECT_TRUE(attempt_document(practice).at("files_not_accepted").empty());
    EXPECT_EQ(paper().find("neither part of this program"), std::string::npos) << paper();
}

TEST_F(ReportBasis, SaysNotTamperEvidentUntilAServiceAccountOwnsTheStore) {
    const auto all = [&] {
        return std::vector<std::string>{read(write(ReportFormat::json, "c.json")),
                                        read(write(ReportFormat::csv, "c.csv")),
                                        words_of_pdf(write(ReportFormat::pdf, "c.pdf")),
                                        words_of_pdf(write(ReportFormat::pdf, "a.pdf", attempt))};
    };
    for (const std::string& text : all()) {
        EXPECT_NE(text.find("not tamper-evident"), std::string::npos) << text;
        EXPECT_NE(text.find("Who can change the store"), std::string::npos) << text;
    }
    use_language(Language::german);
    EXPECT_NE(words_of_pdf(write(ReportFormat::pdf, "g.pdf")).find("Handbuch: Who can change the store"),
              std::string::npos);
    use_language(Language::english);
    if (::geteuid() != 0) GTEST_SKIP() << "only the superuser gives files away";
    ::chmod(programme.folder.path().toLocal8Bit().constData(), 0700);
    ::chmod(programme.path.c_str(), 0600);
    ASSERT_EQ(::chown(programme.folder.path().toLocal8Bit().constData(), 120, 120), 0);
    ASSERT_EQ(::chown(programme.path.c_str(), 120, 120), 0);
    for (const std::string& text : all())
        EXPECT_EQ(text.find("not tamper-evident"), std::string::npos) << text;
}

}  // namespace
}  // namespace fulcrum::ui
