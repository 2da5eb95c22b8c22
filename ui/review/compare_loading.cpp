// SPDX-License-Identifier: GPL-3.0-or-later
// What the page of a comparison reads and computes in the background.
#include <QPushButton>

#include "database/records/ratings.h"
#include "ui/language/error_text.h"
#include "ui/page/background_job.h"
#include "ui/review/compare_page.h"
#include "ui/review/comparison_table.h"
#include "ui/review/part_choice.h"
#include "ui/review/replay_panel.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

void ComparePage::stop() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
}

void ComparePage::run(std::function<void(const database::Store&, const Progress&)> work,
                      std::function<void()> done, const QString& line) {
    job_ = BackgroundJob::run(
        this,
        [work = std::move(work), path = context().store().path()](const Progress& progress) {
            database::StoreOptions options;
            options.read_only = true;
            const database::Store store = database::Store::open(path, options);
            work(store, progress);
        },
        [this, done = std::move(done)] {
            job_ = nullptr;
            done();
        },
        [this](const QString& why) {
            job_ = nullptr;
            context().complain(why);
        });
    job_bar_->watch(job_, line);
}

std::unique_ptr<ReplaySource> ComparePage::picture_of(const ComparedSide& side, QString& why) {
    if (!side.has_trace()) {
        why = side.why_no_trace;
        return nullptr;
    }
    try {
        ReplayService& replays = context().services();
        if (&side == other_.get() && expert_ != nullptr)
            return replays.open_expert_replay(context().session(), own_->model.summary, *expert_);
        return replays.open_replay(context().session(), side.model.summary, side.model.trace);
    } catch (const std::exception& error) {
        why = tr("No picture: %1").arg(error_text(error));
        return nullptr;
    }
}

void ComparePage::choose(int index) {
    if (own_ == nullptr || index < 0 || index >= static_cast<int>(choices_.size())) return;
    const ComparisonChoice& chosen = choices_[static_cast<std::size_t>(index)];
    stop();  // also where this one is refused at once
    own_replay_->play(false);
    play_->setText(tr("Play"));
    other_replay_->close();
    other_.reset();
    expert_.reset();
    pair_.reset();
    cohort_.reset();
    other_loaded();
    switch (chosen.kind) {
        case ComparisonChoice::Kind::attempt:
            return load_attempt(chosen.id);
        case ComparisonChoice::Kind::expert:
            return load_expert();
        case ComparisonChoice::Kind::cohort:
            return load_cohort(chosen.id);
    }
}

void ComparePage::load_attempt(const std::string& id) {
    std::optional<Scene> scene;
    if (!context().guarded([&] {
            const auto attempt = database::Attempts(context().store()).read(context().session(), id);
            if (context().task(attempt.meta.task_id) != nullptr)
                scene = context().services().scene_of(context().session(), attempt);
            // Its person, verdict and points are shown, as where it is opened by itself.
            database::Ratings(context().store()).note_seen(context().session(), id);
        }))
        return;
    struct Loaded {
        std::shared_ptr<const ComparedSide> side;
        ComparedPair pair;
    };
    auto loaded = std::make_shared<Loaded>();
    run(
        [loaded, id, scene, own = own_, session = context().session()](const database::Store& store,
                                                                       const Progress& progress) {
            std::optional<ComparedSide> side = load_side(store, session, id, scene, progress);
            if (!side) return;
            loaded->pair = align(*own, *side);
            loaded->side = std::make_shared<const ComparedSide>(std::move(*side));
        },
        [this, loaded] {
            if (loaded->side == nullptr) return;
            other_ = loaded->side;
            pair_ = std::move(loaded->pair);
            other_loaded();
        },
        tr("Reading the other attempt …"));
}

void ComparePage::load_expert() {
    std::function<std::optional<ExpertAttempt>(const Progress&)> make;
    if (!context().guarded(
            [&] { make = context().services().expert_attempt(context().session(), own_->model.summary); }))
        return;
    struct Loaded {
        std::shared_ptr<const ExpertAttempt> expert;
        std::shared_ptr<const ComparedSide> side;
        ComparedPair pair;
    };
    auto loaded = std::make_shared<Loaded>();
    run(
        [loaded, make, own = own_](const database::Store&, const Progress& progress) {
            std::optional<ExpertAttempt> made = make(progress);
            if (!made) return;
            ComparedSide side = expert_side(*made, own->scene);
            loaded->pair = align(*own, side);
            loaded->expert = std::make_shared<const ExpertAttempt>(std::move(*made));
            loaded->side = std::make_shared<const ComparedSide>(std::move(side));
        },
        [this, loaded] {
            if (loaded->side == nullptr) return;
            expert_ = loaded->expert;
            other_ = loaded->side;
            pair_ = std::move(loaded->pair);
            other_loaded();
        },
        tr("An expert performs the task …"));
}

void ComparePage::load_cohort(const std::string& id) {
    auto loaded = std::make_shared<std::optional<CohortSide>>();
    run([loaded, id, own = own_, session = context().session()](
            const database::Store& store,
            const Progress& progress) { *loaded = ui::load_cohort(store, session, id, *own, progress); },
        [this, loaded] {
            if (!*loaded) return;
            cohort_ = std::move(*loaded);
            other_loaded();
        },
        tr("Reading the attempts of the cohort …"));
}

void ComparePage::measure_part() {
    table_->clear();
    const TaskDefinition* task = context().task(own_->model.summary.meta.task_id);
    if (task == nullptr || !own_->scene) return;
    const auto of = [](const ComparedSide& side, double from, double to) {
        return MeasuredPart{side.model.trace, side.scene, side.model.summary.meta.seed, from, to};
    };
    std::vector<MeasuredPart> parts{of(*own_, part_->from(), part_->to())};
    if (other_ != nullptr && other_->has_trace())
        parts.push_back(of(*other_, pair_->map.to_second(part_->from()), pair_->map.to_second(part_->to())));
    measure_->measure(std::move(parts), *task);
}

}  // namespace fulcrum::ui
