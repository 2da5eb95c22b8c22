// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/background_job.h"

#include <QPointer>
#include <QProgressBar>
#include <QRunnable>
#include <QThreadPool>
#include <algorithm>

#include "ui/language/error_text.h"
#include "ui/page/mail_room.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

class Work : public QRunnable {
  public:
    explicit Work(std::function<void()> body) : body_(std::move(body)) {}
    void run() override { body_(); }

  private:
    std::function<void()> body_;
};

}  // namespace

BackgroundJob::BackgroundJob(QObject* parent)
    : QObject(parent), stop_(std::make_shared<std::atomic<bool>>(false)) {}

BackgroundJob::~BackgroundJob() {
    stop_->store(true);
}

BackgroundJob* BackgroundJob::run(QObject* parent, std::function<void(const Progress&)> work,
                                  std::function<void()> done, std::function<void(const QString&)> failed) {
    auto* job = new BackgroundJob(parent);
    const QPointer<BackgroundJob> guard(job);
    const std::shared_ptr<std::atomic<bool>> stop = job->stop_;
    MailRoom* const ui_thread = MailRoom::of_application();
    const Progress progress = [guard, stop, ui_thread](double share, const std::string& line) {
        // The guard is looked at on the UI thread only, where the job lives and dies.
        ui_thread->post([guard, share, line] {
            if (guard) emit guard->progressed(share, sentence_text(line.c_str()));
        });
        return !stop->load();
    };
    auto body = [guard, stop, ui_thread, progress, work = std::move(work), done = std::move(done),
                 failed = std::move(failed)] {
        if (stop->load()) return;
        QString error;
        bool threw = false;
        try {
            work(progress);
        } catch (const std::exception& problem) {
            error = error_text(problem);
            threw = true;
        }
        ui_thread->post([guard, stop, done, failed, error, threw] {
            if (!guard || stop->load()) return;
            if (threw) {
                failed(error);
            } else {
                done();
            }
            if (guard) {
                emit guard->ended();
                guard->deleteLater();
            }
        });
    };
    QThreadPool::globalInstance()->start(new Work(std::move(body)));
    return job;
}

void BackgroundJob::cancel() {
    if (stop_->exchange(true)) return;
    emit ended();
    deleteLater();
}

bool BackgroundJob::cancelled() const {
    return stop_->load();
}

JobBar::JobBar(QWidget* parent) : QWidget(parent), line_(make_label({})), bar_(new QProgressBar) {
    button_ = make_button(tr("Cancel"), "cancel_job");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 4, 0, 4);
    row->addWidget(line_, 2);
    row->addWidget(bar_, 3);
    row->addWidget(button_);
    bar_->setRange(0, 1000);
    hide();
}

void JobBar::watch(BackgroundJob* job, const QString& line, Cancel cancel) {
    jobs_.push_back({job, line, cancel});
    connect(job, &BackgroundJob::ended, this, [this, job] { forget(job); });
    connect(job, &QObject::destroyed, this, &JobBar::forget);
    connect(job, &BackgroundJob::progressed, this, [this, job](double done, const QString& now) {
        if (jobs_.empty() || jobs_.back().job != job) return;
        bar_->setRange(0, 1000);
        bar_->setValue(static_cast<int>(done * 1000));
        if (!now.isEmpty()) line_->setText(now);
    });
    show_last();
}

void JobBar::show_last() {
    BackgroundJob* job = jobs_.back().job;
    line_->setText(jobs_.back().line);
    bar_->setAccessibleName(jobs_.back().line);
    button_->setVisible(jobs_.back().cancel == Cancel::offered);
    bar_->setRange(0, 0);
    show();
    disconnect(cancel_);
    cancel_ = connect(button_, &QPushButton::clicked, job, [this, job] {
        job->cancel();
        emit cancelled();
    });
}

void JobBar::forget(const QObject* job) {
    const auto ended = std::find_if(jobs_.begin(), jobs_.end(),
                                    [job](const Watched& watched) { return watched.job == job; });
    if (ended == jobs_.end()) return;
    const bool shown = ended + 1 == jobs_.end();
    jobs_.erase(ended);
    if (jobs_.empty())
        hide();
    else if (shown)
        show_last();
}

}  // namespace fulcrum::ui

#include "moc_background_job.cpp"
