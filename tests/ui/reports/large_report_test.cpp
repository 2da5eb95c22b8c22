// SPDX-License-Identifier: GPL-3.0-or-later
// A cohort of two hundred on paper: everybody has a page. How long it takes is measured by benchmark_review.
#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include "tests/database/large_programme.h"
#include "tests/support/support.h"
#include "ui/reports/report.h"

namespace fulcrum::ui {
namespace {

TEST(LargeReport, HasAPageForEachOfTwoHundredTrainees) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("large.db").toStdString();
    const database::Store store = database::Store::create(path);
    const auto large = database::test::make_large_programme(store, 200, 2, 2, 1);
    std::vector<TaskDefinition> tasks;
    for (const char* id : {"A2", "B1"})
        tasks.push_back(load_task(test::source_path(std::string("assets/tasks/") + id + ".json")));
    ReportRequest request;
    request.cohort_id = large.cohort;
    request.path = folder.filePath("large.pdf").toStdString();
    double furthest = 0;
    const std::vector<std::string> files =
        write_report(store, large.director, request, tasks, "0.1.0", [&](double done, const std::string&) {
            EXPECT_GE(done, furthest);
            furthest = done;
            return true;
        });
    ASSERT_EQ(files.size(), 1U);
    EXPECT_GT(furthest, 0.9);
    QProcess process;
    process.start(QStringLiteral("pdftotext"),
                  {QStringLiteral("-layout"), QString::fromStdString(files[0]), QStringLiteral("-")});
    ASSERT_TRUE(process.waitForFinished(20000)) << "pdftotext (poppler-utils) is needed";
    const QList<QByteArray> pages = process.readAllStandardOutput().split('\f');
    int people = 0;
    for (const QByteArray& page : pages) people += page.contains("progress report") ? 1 : 0;
    EXPECT_EQ(people, 200);
    const QByteArray all = pages.join('\n');
    for (const char* name : {"Trainee 1000", "Trainee 1117", "Trainee 1199"})
        EXPECT_GE(all.count(name), 2) << name;
}

TEST(LargeReport, StopsWhereItIsToldToAndLeavesNoFile) {
    const QTemporaryDir folder;
    const database::Store store = database::Store::create(folder.filePath("large.db").toStdString());
    const auto large = database::test::make_large_programme(store, 12, 1, 1, 2);
    ReportRequest request;
    request.cohort_id = large.cohort;
    request.path = folder.filePath("stopped.pdf").toStdString();
    const auto files = write_report(store, large.director, request, {}, "0.1.0",
                                    [](double done, const std::string&) { return done < 0.7; });
    EXPECT_TRUE(files.empty());
    EXPECT_FALSE(QFile::exists(QString::fromStdString(request.path)));
    EXPECT_FALSE(QFile::exists(QString::fromStdString(request.path) + ".part"));
}

}  // namespace
}  // namespace fulcrum::ui
