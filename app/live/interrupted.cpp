// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/interrupted.h"

#include "database/scoring/rescoring.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

/// The first score is the one in force: it belongs to the task as it was when the attempt began.
void require_same_task(const database::AttemptSummary& summary, const LoadedTask& loaded,
                       const std::vector<database::AssetFile>& assets) {
    const database::AssetFile& now = loaded.assets.front();
    for (const database::AssetFile& then : assets) {
        if (then.name == now.name && then.digest != now.digest)
            throw InputError(
                now.name, "",
                {QT_TRANSLATE_NOOP("errors", "is not the file that attempt %1 began with (sha256 %2)"),
                 summary.meta.id, then.digest},
                QT_TRANSLATE_NOOP("errors", "restore that file, then start the program again"));
    }
}

ScoredAttempt score_one(const database::Attempts& attempts, const database::Session& session,
                        const database::AttemptSummary& summary) {
    const LoadedTask loaded = load_recorded(attempts, session, summary);
    const std::vector<database::AssetFile> assets = attempts.assets(session, summary.meta.id);
    require_same_task(summary, loaded, assets);
    return score_stored(
        attempts, session, summary, loaded,
        limits_at_start(loaded.task, loaded.scene, summary.meta.device_class, summary.meta.limits, assets));
}

}  // namespace

std::vector<ui::InterruptedScore> score_interrupted(const std::string& store_path,
                                                    const database::Session& session,
                                                    const ui::Progress& progress) {
    std::vector<ui::InterruptedScore> scored;
    database::StoreOptions options;
    options.close_interrupted = false;
    const database::Store store = database::Store::open(store_path, options);
    if (!store.allowed(session, database::Operation::score_interrupted)) return scored;
    const database::Attempts attempts(store);
    const std::vector<database::AttemptSummary> open = attempts.interrupted_without_score(session);
    for (const database::AttemptSummary& summary : open) {
        if (progress && !progress(static_cast<double>(scored.size()) / static_cast<double>(open.size()),
                                  summary.meta.task_id))
            break;
        ui::InterruptedScore one{
            summary.meta.id, summary.meta.task_id, summary.meta.started, summary.duration_s, {}, {}, {}};
        try {
            const ScoredAttempt score = score_one(attempts, session, summary);
            attempts.add_score(session, summary.meta.id, to_row(score, summary.meta.limits));
            one.passed = score.score.passed;
            one.why = score.score.passed ? score.score.advice : score.score.not_scored_because;
        } catch (const InputError& error) {
            one.problem = error.sentence();
        } catch (const database::StoreError& error) {
            if (error.kind() != database::StoreErrorKind::corrupt) throw;
            one.problem = error.sentence();
        }
        scored.push_back(std::move(one));
    }
    return scored;
}

}  // namespace fulcrum::app
