// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum replay: simulates a stored attempt again from its record.
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/live/performance.h"
#include "assessment/assets/assets.h"
#include "assessment/attempt/engine_state.h"
#include "database/records/attempts.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum::app {
namespace {

/// The stored metrics and a recomputation from the stored record: the same numbers to the last bit, the same
/// absences.
bool same_metrics(const std::vector<database::MetricRow>& stored,
                  const std::vector<database::MetricRow>& again) {
    if (stored.size() != again.size()) return false;
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const database::MetricRow &a = stored[i], &b = again[i];
        if (a.id != b.id || a.hand != b.hand || a.tissue != b.tissue ||
            a.value.has_value() != b.value.has_value())
            return false;
        if (a.value && *a.value != *b.value) return false;
    }
    return true;
}

nlohmann::json origin_json(const std::optional<database::AttemptOrigin>& origin) {
    if (!origin) return {};
    return {{"attempt", origin->source_id.empty() ? nlohmann::json() : nlohmann::json(origin->source_id)},
            {"tick", origin->tick},
            {"goal", origin->goal}};
}

int run_replay(const Arguments& arguments) {
    const database::Store store = open_store(arguments, false, false);
    const database::Session session = session_of(arguments, store);
    const database::Attempts attempts(store);
    const std::string& id = arguments.words()[0];
    const database::AttemptSummary summary = attempts.read(session, id);
    database::Trace trace = attempts.read_trace(session, id);
    const LoadedTask loaded = load_recorded(attempts, session, summary);

    AttemptRecord record{std::move(trace.inputs), std::move(trace.samples), std::move(trace.steps),
                         std::move(trace.events), summary.meta.force_devices};
    if (record.inputs.size() != record.samples.size())
        throw InputError(id, "trace", QT_TRANSLATE_NOOP("errors", "the numbers of inputs and samples differ"),
                         QT_TRANSLATE_NOOP("errors", "run fulcrum db check"));
    AttemptEngine engine(loaded.scene, loaded.task, summary.meta.seed);
    if (summary.meta.origin) {
        if (summary.meta.origin->build != state_build())
            throw InputError(
                id, "",
                {QT_TRANSLATE_NOOP(
                     "errors", "began with a state that \"%1\" wrote and this build (\"%2\") cannot read"),
                 summary.meta.origin->build, state_build()},
                QT_TRANSLATE_NOOP("errors", "replay it with that version of the program"));
        restore_engine(engine, attempts.start_state(session, id));
    }
    const ReplayOutcome outcome = replay_record(engine, record);

    const Limits limits = limits_for(loaded.task, loaded.scene, summary.meta.device_class);
    const std::vector<TargetSphere>& targets = engine.initial_snapshot().targets;
    const ScoredAttempt again =
        score_record(loaded.scene, loaded.task, targets, record.samples, record.events, limits);
    const auto stored = attempts.score(session, id);
    const bool metrics_identical =
        stored && same_metrics(stored->metrics, to_row(again, summary.meta.limits).metrics);

    // An attempt that was interrupted has no hash of its end.
    const bool hash_identical = summary.state_hash.empty() || summary.state_hash == hex(outcome.state_hash);

    const nlohmann::json document = {
        {"attempt", id},
        {"identical", outcome.identical},
        {"first_divergence_s",
         outcome.first_divergence_s < 0 ? nlohmann::json() : nlohmann::json(outcome.first_divergence_s)},
        {"state_hash", hex(outcome.state_hash)},
        {"recorded_state_hash", summary.state_hash},
        {"state_hash_identical", hash_identical},
        {"metrics_identical", metrics_identical},
        {"continues", origin_json(summary.meta.origin)},
        {"samples", record.samples.size()},
        {"built_for", cpu_features()},
        {"recorded_on", summary.meta.cpu_features}};
    if (arguments.has("--json")) {
        print_json(document);
    } else {
        std::cout << (outcome.identical
                          ? "identical"
                          : "differs from " + decimal_text(outcome.first_divergence_s, 3) + " s on")
                  << ", metrics " << (metrics_identical ? "identical" : "differ") << ", state_hash "
                  << hex(outcome.state_hash)
                  << (hash_identical ? "" : ", but the store has " + summary.state_hash) << '\n';
    }
    // What continues another attempt has no score, so no metrics to compare.
    const bool same = outcome.identical && hash_identical && (metrics_identical || summary.meta.origin);
    return arguments.has("--verify") && !same ? 1 : 0;
}

}  // namespace

Command replay_command() {
    return {
        "replay",
        "ATTEMPT",
        1,
        1,
        QT_TRANSLATE_NOOP("commands", "Simulates a stored attempt again from its record."),
        joined({{"--verify", "",
                 QT_TRANSLATE_NOOP("commands",
                                   "Exit with 1 if state hash, forces or metrics differ from the record.")}},
               session_options()),
        run_replay};
}

}  // namespace fulcrum::app
