// SPDX-License-Identifier: GPL-3.0-or-later
// The same report, byte by byte, from the station's own store and from the programme server after a sync:
// every format, of a person, a cohort and an attempt. The same grid and the same figures of the cohort's
// dashboard.
#include <gtest/gtest.h>

#include <QProcess>
#include <algorithm>
#include <fstream>
#include <iterator>

#include "app/services/program.h"
#include "tests/app/services/server_reports.h"
#include "tests/ui/reports/pdf_pages.h"

namespace fulcrum::app::program_test {
namespace {

std::string file_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A workbook's sheets; its files also have the time at which they were written.
std::string sheets_of(const std::string& path) {
    QProcess unzip;
    unzip.start("unzip", {"-p", QString::fromStdString(path), "xl/*.xml"});
    EXPECT_TRUE(unzip.waitForFinished(20000)) << "unzip is needed";
    return unzip.readAllStandardOutput().toStdString();
}

TEST_F(ServerReports, AreTheSameFromEitherStoreInEveryFormat) {
    if (!give_store_to_service_account()) GTEST_SKIP() << "this account cannot give a file to another one";
    struct Row {
        const char* of;
        ui::ReportFormat format;
        std::size_t least;
    };
    for (const Row& row :
         {Row{"person", ui::ReportFormat::csv, 2000}, Row{"person", ui::ReportFormat::json, 20000},
          Row{"person", ui::ReportFormat::xlsx, 2000}, Row{"person", ui::ReportFormat::xapi, 5000},
          Row{"person", ui::ReportFormat::pdf, 500}, Row{"cohort", ui::ReportFormat::csv, 2000},
          Row{"cohort", ui::ReportFormat::json, 20000}, Row{"cohort", ui::ReportFormat::xlsx, 2000},
          Row{"cohort", ui::ReportFormat::xapi, 50000}, Row{"cohort", ui::ReportFormat::pdf, 2000},
          Row{"attempt", ui::ReportFormat::csv, 100}, Row{"attempt", ui::ReportFormat::json, 500},
          Row{"attempt", ui::ReportFormat::pdf, 200}}) {
        ui::ReportRequest request;
        request.format = row.format;
        const std::string of = row.of;
        if (of == "person") request.person_id = "trainee-1001";
        if (of == "cohort") request.cohort_id = made->cohort;
        if (of == "attempt") request.attempt_id = "trainee-1000-0";
        const std::string name = of + "." + row_of(ui::report_formats, row.format).name;
        const std::vector<std::string> files = both(request, name);
        std::string here, there;
        if (row.format == ui::ReportFormat::pdf) {
            here = ui::pages_of(files[0]).join('\f').toStdString();
            there = ui::pages_of(files[1]).join('\f').toStdString();
        } else if (row.format == ui::ReportFormat::xlsx) {
            here = sheets_of(files[0]);
            there = sheets_of(files[1]);
        } else {
            here = file_text(files[0]);
            there = file_text(files[1]);
        }
        EXPECT_GE(here.size(), row.least) << name;
        EXPECT_TRUE(here == there) << name << " differs; the files are in " << folder.path().toStdString();
        if (here != there) {
            folder.setAutoRemove(false);
            const auto at = static_cast<std::size_t>(
                std::mismatch(here.begin(), here.end(), there.begin(), there.end()).first - here.begin());
            const std::size_t from = at > 80 ? at - 80 : 0;
            ADD_FAILURE() << here.substr(from, 200) << "\n---\n" << there.substr(from, 200);
        }
    }
}

TEST_F(ServerReports, GridFiguresAndDashboardAreTheSame) {
    database::CohortTableOptions options;
    for (const TaskDefinition& task : tasks) options.tasks.push_back(task.id);
    options.curriculum = &curriculum;
    const auto here = database::Reports(*station).cohort_table(made->director, made->cohort, options);
    const auto there = database::Reports(*server).cohort_table(*director, made->cohort, options);
    ASSERT_EQ(here.rows.size(), there.rows.size());
    ASSERT_GE(here.rows.size(), 12 * tasks.size());
    ASSERT_EQ(here.standings.size(), 12U);
    ASSERT_EQ(there.standings.size(), 12U);
    for (std::size_t i = 0; i < here.standings.size(); ++i) {
        const database::PersonStandings &a = here.standings[i], &b = there.standings[i];
        EXPECT_EQ(a.person_id, b.person_id);
        EXPECT_EQ(a.curriculum, b.curriculum);
        ASSERT_EQ(a.days.size(), b.days.size());
        ASSERT_EQ(a.concerns.size(), b.concerns.size());
        ASSERT_EQ(a.tasks.size(), b.tasks.size());
        for (std::size_t t = 0; t < a.tasks.size(); ++t) {
            EXPECT_EQ(a.tasks[t].standing.standing, b.tasks[t].standing.standing);
            EXPECT_EQ(a.tasks[t].first_pass, b.tasks[t].first_pass);
            ASSERT_EQ(a.tasks[t].recent.size(), b.tasks[t].recent.size());
            for (std::size_t r = 0; r < a.tasks[t].recent.size(); ++r)
                EXPECT_EQ(a.tasks[t].recent[r].points, b.tasks[t].recent[r].points);
        }
    }
    // Pass rates with their intervals; time to proficiency by Kaplan-Meier.
    const auto shown = database::overview_of(here.standings, here.as_of),
               asked = database::overview_of(there.standings, there.as_of);
    ASSERT_EQ(shown.size(), asked.size());
    int passed = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_EQ(shown[i].people, asked[i].people);
        EXPECT_EQ(shown[i].passed, asked[i].passed);
        EXPECT_EQ(shown[i].share.low, asked[i].share.low);
        EXPECT_EQ(shown[i].share.high, asked[i].share.high);
        EXPECT_EQ(shown[i].days_to_pass.median, asked[i].days_to_pass.median);
        EXPECT_EQ(shown[i].days_to_proficiency.median, asked[i].days_to_proficiency.median);
        passed += shown[i].passed;
    }
    EXPECT_GT(passed, 0);
    EXPECT_EQ(here.benchmark_sets, there.benchmark_sets);
    EXPECT_EQ(here.metric_versions, there.metric_versions);
    EXPECT_EQ(here.audit_head, there.audit_head);
}

TEST_F(ServerReports, TheCommandTakesTheServersAddress) {
    const std::string own = address.text(), file = folder.filePath("command.json").toStdString();
    const std::string account = server->path();
    EXPECT_EQ(
        run_command({"report", "--cohort", "Everyone", "--format", "json", "-o", file, "--db", account}), 0);
    EXPECT_NE(file_text(file).find("Trainee 1011"), std::string::npos);
    EXPECT_EQ(run_command({"report", "--person", "trainee1003", "--format", "csv", "-o", file, "--db",
                           account, "--as", "Director", "--role", "director"}),
              0);
    EXPECT_NE(file_text(file).find("trainee1003"), std::string::npos);
    const auto refused = [&](std::vector<std::string> words) {
        try {
            run_command(words);
        } catch (const std::exception& error) {
            return std::string(error.what());
        }
        return std::string("nothing was refused");
    };
    const std::vector<std::string> report = {"report", "--person", "trainee1003", "-o", file};
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> words = report;
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    EXPECT_NE(refused(with({"--db", account, "--as", "trainee1003"})).find("belongs to director"),
              std::string::npos);
    EXPECT_NE(refused(with({"--db", account, "--password-file", file})).find(".pgpass"), std::string::npos);
    EXPECT_NE(refused(with({"--db", own})).find("server grant"), std::string::npos) << "the owner is nobody";
    // An attempt is performed at a station, and a server's care is not that of a file.
    EXPECT_NE(refused({"perform", "A2", "--operator", "expert", "--db", account}).find("at a station"),
              std::string::npos);
    EXPECT_NE(refused({"db", "check", "--db", account}).find("not allowed"), std::string::npos);
    EXPECT_NE(refused({"db", "create", "--db", account}).find("not a file"), std::string::npos);
    EXPECT_NE(refused({"db", "migrate", "--db", account}).find("not a file"), std::string::npos);
    EXPECT_NE(refused({"db", "restore", path, "--db", account, "--as", "administrator"}).find("not a file"),
              std::string::npos);
    EXPECT_NE(refused({"db", "backup", file + ".copy", "--db", account}).find("not allowed"),
              std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app::program_test
