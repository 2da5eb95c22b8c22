// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/schedule_watch.h"

#include <algorithm>
#include <memory>

#include "ui/page/background_job.h"
#include "ui/reports/scheduled_reports.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

constexpr int due_every_ms = 60000;
constexpr std::int64_t try_again_ms = 3'600'000;

}  // namespace

ScheduleWatch::ScheduleWatch(Context& context, QObject* parent) : QObject(parent), context_(context) {
    timer_.setInterval(due_every_ms);
    connect(&timer_, &QTimer::timeout, this, &ScheduleWatch::look);
    connect(&context_, &Context::session_changed, this, &ScheduleWatch::session_changed);
}

void ScheduleWatch::session_changed() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
    timer_.stop();
    not_before_.clear();
    if (!context_.signed_in() || context_.session().role() != database::Role::director ||
        context_.session().must_change_password() || context_.store().is_server() ||
        context_.store().is_demo() || context_.store().is_read_only())
        return;
    timer_.start();
    QTimer::singleShot(0, this, &ScheduleWatch::look);
}

void ScheduleWatch::look() {
    if (!timer_.isActive() || job_ != nullptr) return;
    std::string due;
    const database::UtcMilliseconds now = context_.store().now();
    try {
        for (const database::ReportSchedule& one :
             database::Schedules(context_.store()).list(context_.session()))
            if (due.empty() && is_due(one, now) && now >= not_before_[one.id]) due = one.id;
    } catch (const std::exception&) {
        return;  // the store is in use or the role was withdrawn: the next page says so
    }
    if (due.empty()) return;
    // One after the other, so that one that fails is left out of the next look.
    not_before_[due] = now + try_again_ms;
    auto run = std::make_shared<ScheduledRun>();
    job_ = BackgroundJob::run(
        this,
        [run, due, session = context_.session(), path = context_.store().path(),
         tasks = context_.services().tasks(), curriculum = context_.services().curriculum(),
         version = context_.services().program_version()](const Progress& progress) {
            const database::Store store = database::Store::open(path);
            *run = run_schedules(store, session, {tasks, curriculum, version}, ScheduleRequest{due, true},
                                 progress);
        },
        [this, run, due] {
            job_ = nullptr;
            if (run->busy) not_before_.erase(due);
            for (const ScheduledRun::Failed& one : run->failed)
                context_.complain(tr("The scheduled report of %1 was not written: %2")
                                      .arg(text(one.cohort), text(one.words)));
            if (!run->written.empty()) {
                not_before_.erase(due);
                context_.say(tr("A scheduled report was written: %1").arg(text(run->written.front())));
            }
            if (!run->busy) look();
        },
        [this](const QString& why) {
            job_ = nullptr;
            context_.complain(why);
        });
}

}  // namespace fulcrum::ui

#include "moc_schedule_watch.cpp"
