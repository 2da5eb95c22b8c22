// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/store_reading.h"

#include "ui/page/background_job.h"

namespace fulcrum::ui {

StoreReading::StoreReading(Context& context, QWidget* part) : QObject(part), context_(context) {}

void StoreReading::start(std::function<void(const database::Store&, const database::Session&)> find,
                         std::function<void()> show, std::function<void(const QString&)> failed) {
    stop();
    job_ = BackgroundJob::run(
        this,
        [find = std::move(find), session = context_.session(),
         path = context_.store().path()](const Progress&) {
            database::StoreOptions options;
            options.read_only = true;
            find(database::Store::open(path, options), session);
        },
        [this, show = std::move(show), role = context_.session().role()] {
            job_ = nullptr;
            read_as_ = role;
            context_.guarded(show);
        },
        [this, failed = std::move(failed)](const QString& why) {
            job_ = nullptr;
            read_as_.reset();
            context_.complain(why);
            failed(why);
        });
}

void StoreReading::stop() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
}

}  // namespace fulcrum::ui

#include "moc_store_reading.cpp"
