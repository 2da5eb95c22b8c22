// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/background_job.h"

#include <gtest/gtest.h>

#include <QThreadPool>
#include <atomic>
#include <future>

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

}  // namespace
}  // namespace fulcrum::ui::window_test
