// SPDX-License-Identifier: GPL-3.0-or-later
// For tests that look at the window while something works in the background.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <future>

#include "ui/page/background_job.h"

namespace fulcrum::ui::window_test {

/// Work in the background waits until it is released.
class HeldWork {
  public:
    HeldWork() : threads_(pool().maxThreadCount()) {
        pool().waitForDone();
        pool().setMaxThreadCount(1);
        BackgroundJob::run(
            &owner_, [released = release_.get_future().share()](const Progress&) { released.wait(); }, [] {},
            [](const QString&) {});
    }
    ~HeldWork() {
        release();
        pool().waitForDone();
        pool().setMaxThreadCount(threads_);
    }
    HeldWork(const HeldWork&) = delete;
    HeldWork& operator=(const HeldWork&) = delete;
    void release() {
        if (!released_) release_.set_value();
        released_ = true;
    }

  private:
    static QThreadPool& pool() { return *QThreadPool::globalInstance(); }
    QObject owner_;
    std::promise<void> release_;
    int threads_;
    bool released_ = false;
};

}  // namespace fulcrum::ui::window_test
