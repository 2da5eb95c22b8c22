// SPDX-License-Identifier: GPL-3.0-or-later
// Large reports: each of two hundred trainees has a page, and a person's table continues over several pages.
// benchmark_review measures the time.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "tests/database/large_programme.h"
#include "tests/support/support.h"
#include "tests/ui/reports/pdf_pages.h"
#include "ui/reports/report.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

std::vector<TaskDefinition> tasks_of(const std::vector<std::string>& ids) {
    std::vector<TaskDefinition> tasks;
    for (const std::string& id : ids)
        tasks.push_back(load_task(test::source_path("assets/tasks/" + id + ".json")));
    return tasks;
}

/// The whole title of every task, word by word, and nothing cut off.
void expect_titles(const QByteArray& pages, const std::vector<TaskDefinition>& tasks) {
    EXPECT_FALSE(pages.contains("\xE2\x80\xA6")) << "nothing is cut off: " << pages.toStdString();
    for (const TaskDefinition& task : tasks) {
        for (const QByteArray& word : QByteArray::fromStdString(task.title).split(' '))
            EXPECT_TRUE(pages.contains(word)) << word.toStdString();
    }
}

// With FULCRUM_PICTURES=FOLDER the reports are kept there.
TEST(LargeReport, ShowsEveryTaskWithItsWholeTitle) {
    const QTemporaryDir folder;
    const database::Store store = database::Store::create(folder.filePath("all.db").toStdString());
    const std::vector<std::string> ids = fulcrum::test::task_ids();
    ASSERT_GE(ids.size(), 5U);
    const int trainees = 6, attempts = 4 * static_cast<int>(ids.size());
    const auto large = database::test::make_large_programme(store, trainees, attempts, 2, 3, ids);
    const std::vector<TaskDefinition> tasks = tasks_of(ids);
    ReportRequest request;
    request.cohort_id = large.cohort;
    request.path = folder.filePath("all.pdf").toStdString();
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
    // The cohort's own pages come first, then those of each person; every page repeats whose it is.
    const QList<QByteArray> pages = pages_of(files[0]);
    QByteArray cohort;
    for (const QByteArray& page : pages) cohort += page.contains("Progress report") ? QByteArray() : page;
    expect_titles(cohort, tasks);
    for (int i = 0; i < trainees; ++i) {
        QByteArray of_person;
        for (const QByteArray& page : pages) {
            if (page.contains("Progress report") && page.contains("Trainee " + QByteArray::number(1000 + i)))
                of_person += page;
        }
        expect_titles(of_person, tasks);
    }
    expect_titles(pages_of(alone[0]).join(), tasks);
}

// Forty rows with a different number in every cell.
PersonReport person_of_forty_rows() {
    PersonReport report;
    report.provenance.programme = "Surgery";
    report.provenance.metric_versions = {"path_len@1", "time@1"};
    report.provenance.benchmark_sets = {"A2-operators@1"};
    report.login = "ada";
    report.name = "Ada Lovelace";
    for (int i = 0; i < 20; ++i) {
        const std::string number = std::to_string(100 + i), id = "T" + number;
        report.tasks.push_back({id, "Title" + number + " of an exercise that takes two lines", "A"});
        database::PersonProgress progress;
        progress.task_id = id;
        for (const DeviceClass device : {DeviceClass::haptic, DeviceClass::mouse_keyboard}) {
            database::CohortRow row;
            row.task_id = id;
            row.device_class = device;
            row.state = database::TaskState::passed;
            row.provisional = true;
            row.attempts = 2000 + static_cast<int>(report.rows.size());
            row.passes = row.attempts - 1000;
            row.not_counting = row.attempts + 1000;
            row.best_points = 50 + static_cast<double>(report.rows.size()) / 10;
            report.rows.push_back(row);
            database::ProgressPoint first, second;
            first.number = 1;
            second.number = 2;
            first.counting = second.counting = true;
            first.points = 40.0;
            second.points = row.best_points;
            progress.series.push_back({device, {first, second}});
        }
        report.progress.push_back(std::move(progress));
    }
    return report;
}

TEST(LargeReport, ShowsAndCountsAllFortyRowsOfAPerson) {
    const QTemporaryDir folder;
    const PersonReport report = person_of_forty_rows();
    const QString path = folder.filePath("forty.pdf");
    write_person_pdf(report, path.toStdString());
    const QString kept = qEnvironmentVariable("FULCRUM_PICTURES");
    if (!kept.isEmpty()) QFile::copy(path, QDir(kept).filePath(QStringLiteral("forty.pdf")));
    const QList<QByteArray> pages = pages_of(path.toStdString());
    EXPECT_GE(pages.size(), 3);
    QList<QByteArray> lines;
    int attempts = 0, heads = 0;
    for (const database::CohortRow& row : report.rows) attempts += row.attempts;
    for (const QByteArray& page : pages) {
        EXPECT_FALSE(page.contains("\xE2\x80\xA6")) << "nothing is cut off: " << page.toStdString();
        EXPECT_TRUE(page.contains("Ada Lovelace"));
        EXPECT_TRUE(page.contains("n = " + QByteArray::number(attempts))) << page.toStdString();
        const bool has_rows = page.contains("Title1");
        EXPECT_EQ(page.simplified().contains("Task Device State Attempts Passed Other Best"), has_rows)
            << page.toStdString();
        heads += has_rows ? 1 : 0;
        for (const QByteArray& line : page.split('\n')) lines << line.simplified();
    }
    EXPECT_GE(heads, 2) << "the table continues on further pages";
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const database::CohortRow& row = report.rows[i];
        const QByteArray device = i % 2 == 0 ? "haptic device" : "mouse and keyboard";
        const QByteArray figures = device + " passed (provisional) " + QByteArray::number(row.attempts) +
                                   ' ' + QByteArray::number(row.passes) + ' ' +
                                   QByteArray::number(row.not_counting) + ' ' +
                                   points_figure(row.best_points).toUtf8();
        int found = 0;
        for (const QByteArray& line : lines) {
            found += line.startsWith(QByteArray::fromStdString(row.task_id) + " \xC2\xB7 Title" +
                                     QByteArray::fromStdString(row.task_id).mid(1)) &&
                             line.endsWith(figures)
                         ? 1
                         : 0;
        }
        EXPECT_EQ(found, 1) << row.task_id << ": " << figures.toStdString();
    }
    // Every task has a chart with its name above it; three charts share a row.
    for (const ReportTask& task : report.tasks) {
        const QByteArray id = QByteArray::fromStdString(task.id);
        int charts = 0;
        for (const QByteArray& line : lines) charts += line.contains(id) && !line.contains("Title") ? 1 : 0;
        EXPECT_EQ(charts, 1) << task.id;
    }
}

TEST(LargeReport, HasAPageForEachOfTwoHundredTrainees) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("large.db").toStdString();
    const database::Store store = database::Store::create(path);
    const auto large = database::test::make_large_programme(store, 200, 2, 2, 1);
    const std::vector<TaskDefinition> tasks = tasks_of({"A2", "B1"});
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
    for (const QByteArray& page : pages) people += page.contains("Progress report") ? 1 : 0;
    EXPECT_EQ(people, 200);
    const QByteArray all = pages.join('\n');
    for (const char* name : {"Trainee 1000", "Trainee 1117", "Trainee 1199"})
        EXPECT_GE(all.count(name), 2) << name;
}

TEST(LargeReport, StopsOnRequestAndLeavesNoFile) {
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
