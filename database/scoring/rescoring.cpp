// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/rescoring.h"

#include <map>
#include <memory>

#include "assessment/assets/assets.h"
#include "assessment/attempt/engine.h"
#include "assessment/metrics/registry.h"
#include "database/scoring/loaded_task.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

void recompute(const database::Attempts& attempts, const database::Session& session, RecomputedScore& one) {
    const database::AttemptSummary summary = attempts.read(session, one.attempt_id);
    const LoadedTask loaded = load_recorded(attempts, session, summary);
    const Limits limits = limits_for(loaded.task, loaded.scene, summary.meta.device_class);
    const ScoredAttempt scored = score_stored(attempts, session, summary, loaded, limits);
    attempts.add_score(session, one.attempt_id, to_row(scored, limits.name()));
    one.passed = scored.score.passed;
    one.not_scored_because = scored.score.not_scored_because;
}

/// Of the variant of an attempt; the variant itself where the task is not installed. `tasks`: those read so
/// far.
std::string family_of(std::map<std::string, TaskDefinition>& tasks, const database::AttemptMeta& attempt) {
    auto found = tasks.find(attempt.task_id);
    if (found == tasks.end()) {
        TaskDefinition task;
        try {
            task = load_task(task_file(attempt.task_id));
        } catch (const InputError&) {
            task.id = attempt.task_id;
        }
        found = tasks.emplace(attempt.task_id, std::move(task)).first;
    }
    return variant_family(found->second, attempt.variant);
}

}  // namespace

ScoredAttempt score_stored(const database::Attempts& attempts, const database::Session& session,
                           const database::AttemptSummary& summary, const LoadedTask& loaded,
                           const Limits& limits) {
    const database::Trace trace = attempts.read_trace(session, summary.meta.id);
    return score_record(loaded.scene, loaded.task, targets_of(loaded.scene, loaded.task, summary.meta.seed),
                        trace.samples, trace.events, limits);
}

database::ScoringInForce scoring_in_force() {
    database::ScoringInForce now;
    for (const Metric& metric : metric_registry())
        now.metric_versions[metric.descriptor.id] = metric.descriptor.version;
    auto names = std::make_shared<std::map<std::string, std::string>>();  // by the sets' names
    auto tasks = std::make_shared<std::map<std::string, TaskDefinition>>();
    now.limits = [names, tasks](const database::AttemptMeta& attempt) {
        const BenchmarkKey key{attempt.task_id, family_of(*tasks, attempt),
                               limits_class(attempt.device_class), attempt.fidelity};
        const auto [entry, added] = names->try_emplace(benchmark_name(key));
        if (added) entry->second = benchmark_in_force(key).name();
        return entry->second;
    };
    return now;
}

std::vector<RecomputedScore> recompute_scores(const std::string& store_path, const database::Session& session,
                                              const std::string& person_id,
                                              const database::StoreProgress& progress) {
    database::StoreOptions options;
    options.close_interrupted = false;
    const database::Store store = database::Store::open(store_path, options);
    const database::Attempts attempts(store);
    const std::vector<database::StaleScore> stale =
        attempts.stale_scores(session, scoring_in_force(), person_id);
    std::vector<RecomputedScore> recomputed;
    for (const database::StaleScore& old : stale) {
        const double share = static_cast<double>(recomputed.size()) / static_cast<double>(stale.size());
        if (progress && !progress(share, old.person_name + ", " + old.task_id)) break;
        RecomputedScore one{old.attempt_id, old.person_name, old.task_id, old.why, old.passed, {}, {}, {}};
        try {
            recompute(attempts, session, one);
        } catch (const InputError& error) {
            one.problem = error.sentence();
        } catch (const database::StoreError& error) {
            if (error.kind() != database::StoreErrorKind::corrupt) throw;
            one.problem = error.sentence();
        }
        recomputed.push_back(std::move(one));
    }
    return recomputed;
}

}  // namespace fulcrum
