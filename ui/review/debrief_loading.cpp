// SPDX-License-Identifier: GPL-3.0-or-later
// What the debrief reads in the background: first what its charts need, then the whole record for the replay.
#include "database/records/ratings.h"
#include "ui/language/error_text.h"
#include "ui/page/background_job.h"
#include "ui/reports/unaccepted_files.h"
#include "ui/review/debrief_page.h"
#include "ui/review/part_card.h"
#include "ui/review/replay_panel.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

void DebriefPage::load() {
    std::optional<Scene> scene;
    database::AttemptSummary attempt;
    if (!context().guarded([&] {
            attempt = database::Attempts(context().store()).read(context().session(), attempt_id_);
            const database::Ratings ratings(context().store());
            blind_ = blind_ || ratings.is_blind(context().session(), attempt_id_);
            if (!blind_) ratings.note_seen(context().session(), attempt_id_);
            unaccepted_ = unaccepted_files(context().store(), context().session(), attempt);
        })) {
        return;
    }
    if (context().task(attempt.meta.task_id) != nullptr) {
        context().guarded([&] { scene = context().services().scene_of(context().session(), attempt); });
    }
    scene_ = scene;
    auto loaded = std::make_shared<std::optional<AttemptModel>>();
    auto missing = std::make_shared<TraceElsewhere>();
    job_ = BackgroundJob::run(
        this,
        [loaded, missing, scene, attempt_id = attempt_id_, path = context().store().path(),
         session = context().session()](const Progress& progress) {
            *loaded = load_with_trace(path, session, attempt_id, scene, progress, *missing);
        },
        [this, loaded, missing] {
            job_ = nullptr;
            if (!*loaded) return;
            elsewhere_ = *missing;
            model_ = std::make_shared<const AttemptModel>(std::move(**loaded));
            show_model();
        },
        [this](const QString& why) {
            job_ = nullptr;
            context().complain(why);
        });
    job_bar_->watch(job_, tr("Reading the attempt …"));
}

void DebriefPage::read_record() {
    auto trace = std::make_shared<database::Trace>();
    if (!model_->summary.meta.keep_trace) {
        show_record(trace);
        return;
    }
    job_ = BackgroundJob::run(
        this,
        [trace, id = attempt_id_, path = context().store().path(),
         session = context().session()](const Progress&) {
            database::StoreOptions options;
            options.read_only = true;
            const database::Store store = database::Store::open(path, options);
            *trace = database::Attempts(store).read_packed_trace(session, id);
        },
        [this, trace] {
            job_ = nullptr;
            show_record(trace);
        },
        [this](const QString& why) {
            job_ = nullptr;
            replay_->set_record(model_, nullptr, tr("No picture: %1").arg(why));
            context().complain(why);
        });
}

void DebriefPage::show_record(std::shared_ptr<const database::Trace> trace) {
    auto model = std::make_shared<AttemptModel>(*model_);
    model->trace = std::move(trace);
    model_ = std::move(model);
    std::unique_ptr<ReplaySource> source;
    QString why;
    if (model_->trace->tick_count() == 0) {
        why = tr("Nothing was recorded.");
    } else {
        try {
            source = context().services().open_replay(context().session(), model_->summary, model_->trace);
        } catch (const std::exception& error) {
            why = tr("No picture: %1").arg(error_text(error));
        }
    }
    replay_->offer_practice(source != nullptr &&
                            context().allowed(database::Operation::perform_attempt,
                                              database::Subject::person(context().session().person_id())));
    replay_->set_record(model_, std::move(source), why);
    part_->set_record(model_, scene_);
    part_->set_moment(moment());
    emit ready();
}

}  // namespace fulcrum::ui
