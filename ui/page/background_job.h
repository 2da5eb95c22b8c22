// SPDX-License-Identifier: GPL-3.0-or-later
// Long work off the UI thread, with progress and a way to stop it. The job belongs to its parent: when that
// is deleted the work is asked to stop and its answer is dropped.
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "ui/services/application_services.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace fulcrum::ui {

class BackgroundJob : public QObject {
    Q_OBJECT
  public:
    /// `work` runs on a worker thread with a Progress to call; it must own what it touches (open its own
    /// Store). `done` runs on the UI thread after it returned, `failed` if it threw. Neither is called after
    /// cancel(), which also keeps work from beginning that waits for a thread.
    static BackgroundJob* run(QObject* parent, std::function<void(const Progress&)> work,
                              std::function<void()> done, std::function<void(const QString&)> failed);
    ~BackgroundJob() override;
    void cancel();
    bool cancelled() const;

  signals:
    void progressed(double done, const QString& line);
    /// After done, failed or cancel; the job deletes itself then.
    void ended();

  private:
    explicit BackgroundJob(QObject* parent);
    std::shared_ptr<std::atomic<bool>> stop_;
};

/// A progress bar, one line and a Cancel button for a job; hides itself when the job ends. Of several it
/// shows the one that began last. Work that cannot be undone has no button: it would be done all the same,
/// and its answer lost.
class JobBar : public QWidget {
    Q_OBJECT
  public:
    enum class Cancel { offered, none };
    explicit JobBar(QWidget* parent = nullptr);
    void watch(BackgroundJob* job, const QString& line, Cancel cancel = Cancel::offered);

  signals:
    void cancelled();

  private:
    struct Watched {
        BackgroundJob* job;
        QString line;
        Cancel cancel;
    };
    void show_last();
    void forget(const QObject* job);

    std::vector<Watched> jobs_;  ///< that have not ended, the one that is shown last
    QLabel* line_;
    QProgressBar* bar_;
    QMetaObject::Connection cancel_;
    QPushButton* button_;
};

}  // namespace fulcrum::ui
