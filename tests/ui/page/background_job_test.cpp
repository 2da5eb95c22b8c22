// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/background_job.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QThreadPool>
#include <QtTest>
#include <atomic>
#include <future>
#include <memory>

namespace fulcrum::ui::window_test {
namespace {

TEST(BackgroundJobs, CancelledWhileTheyWaitForAThreadDoNothing) {
    QThreadPool& pool = *QThreadPool::globalInstance();
    pool.waitForDone();
    const int threads = pool.maxThreadCount();
    pool.setMaxThreadCount(1);
    std::promise<void> release;
    std::atomic<bool> began{false};
    QObject owner;
    BackgroundJob::run(
        &owner, [released = release.get_future().share()](const Progress&) { released.wait(); }, [] {},
        [](const QString&) {});
    BackgroundJob* waits = BackgroundJob::run(
        &owner, [&began](const Progress&) { began = true; }, [] {}, [](const QString&) {});
    waits->cancel();
    release.set_value();
    pool.waitForDone();
    pool.setMaxThreadCount(threads);
    EXPECT_FALSE(began.load());
}

TEST(BackgroundJobs, TheBarShowsTheOtherJobOnceTheLastOneHasEnded) {
    QThreadPool& pool = *QThreadPool::globalInstance();
    pool.waitForDone();
    std::promise<void> release;
    const auto wait = [released = release.get_future().share()](const Progress&) { released.wait(); };
    const auto run = [&wait](QObject* owner) {
        return BackgroundJob::run(
            owner, wait, [] {}, [](const QString&) {});
    };
    QObject owner;
    auto other_owner = std::make_unique<QObject>();
    JobBar bar;
    auto* button = bar.findChild<QPushButton*>("cancel_job");
    BackgroundJob* report = run(&owner);
    bar.watch(report, "the report");
    const auto shows = [&bar](const QString& line) {
        for (const QLabel* label : bar.findChildren<QLabel*>())
            if (label->text() == line) return bar.isVisible();
        return false;
    };
    bar.watch(run(&owner), "the attempt", JobBar::Cancel::none);
    EXPECT_TRUE(shows("the attempt"));
    EXPECT_FALSE(button->isVisible());
    bar.watch(run(other_owner.get()), "the list");
    button->click();  // cancels the one that is shown
    EXPECT_TRUE(shows("the attempt"));
    bar.watch(run(other_owner.get()), "the list again");
    other_owner.reset();
    EXPECT_TRUE(shows("the attempt"));
    report->cancel();
    EXPECT_TRUE(shows("the attempt"));
    release.set_value();
    EXPECT_TRUE(QTest::qWaitFor([&bar] { return !bar.isVisible(); }));
    pool.waitForDone();
}

}  // namespace
}  // namespace fulcrum::ui::window_test
