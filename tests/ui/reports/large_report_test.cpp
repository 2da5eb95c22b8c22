// SPDX-License-Identifier: GPL-3.0-or-later
// A cohort of two hundred on paper: everybody has a page. How long it takes is measured by benchmark_review.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include "tests/database/large_programme.h"
#include "tests/support/support.h"
#include "ui/reports/report.h"

namespace fulcrum::ui {
namespace {

/// The pages of a PDF as they are laid out.
QList<QByteArray> pages_of(const std::string& path) {
    QProcess process;
    process.start(QStringLiteral("pdftotext"),
                  {QStringLiteral("-layout"), QString::fromStdString(path), QStringLiteral("-")});
    EXPECT_TRUE(process.waitForFinished(20000)) << "pdftotext (poppler-utils) is needed";
    QList<QByteArray> pages = process.readAllStandardOutput().split('\f');
    if (!pages.isEmpty() && pages.back().trimmed().isEmpty()) pages.pop_back();
    return pages;
}

// FULCRUM_PICTURES keeps the paper.
TEST(LargeReport, FiveTasksStandOnItWithTheirWholeTitles) {
    const QTemporaryDir folder;
    const database::Store store = database::Store::create(folder.filePath("five.db").toStdString());
    const std::vector<const char*> ids = {"A2", "B1", "B2", "B3", "C4"};
    const auto large = database::test::make_large_programme(store, 6, 20, 2, 3, ids);
    std::vector<TaskDefinition> tasks;
    for (const char* id : ids)
        tasks.push_back(load_task(test::source_path(std::string("assets/tasks/") + id + ".json")));
    ReportRequest request;
    request.cohort_id = large.cohort;
    request.path = folder.filePath("five.pdf").toStdString();
    const auto files = write_report(store, large.director, request, tasks, "0.1.0", {});
    ASSERT_EQ(files.size(), 1U);
    ReportRequest one;
    one.person_id = "trainee-1003";
    one.path = folder.filePath("one.pdf").toStdString();
    const auto alone = write_report(store, large.director, one, tasks, "0.1.0", {});
    ASSERT_EQ(alone.size(), 1U);
    const QString kept = qEnvironmentVariable("FULCRUM_PICTURES");
    for (const std::string& file : {files[0], alone[0]}) {
        const QString path = QString::fromStdString(file);
        if (!kept.isEmpty()) QFile::copy(path, QDir(kept).filePath(QFileInfo(path).fileName()));
    }
    QList<QByteArray> pages = pages_of(files[0]);
    ASSERT_EQ(pages.size(), 1 + 6);
    pages += pages_of(alone[0]);
    ASSERT_EQ(pages.size(), 1 + 6 + 1);
    for (const QByteArray& page : pages) {
        EXPECT_FALSE(page.contains("\xE2\x80\xA6")) << "nothing is cut off: " << page.toStdString();
        for (const TaskDefinition& task : tasks) {
            for (const QByteArray& word : QByteArray::fromStdString(task.title).split(' '))
                EXPECT_TRUE(page.contains(word)) << word.toStdString();
        }
    }
}

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
    const QList<QByteArray> pages = pages_of(files[0]);
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
