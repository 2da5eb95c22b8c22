// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum replay: simulates a stored attempt again from its record.
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/attempt_document.h"
#include "app/cli/commands.h"
#include "app/live/performance.h"
#include "app/live/simulation_check.h"
#include "database/records/attempts.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum::app {
namespace {

int run_replay(const Arguments& arguments) {
    const database::Store store = open_store(arguments, false, false);
    const database::Session session = session_of(arguments, store);
    const database::Attempts attempts(store);
    const std::string& id = arguments.words()[0];
    const database::AttemptSummary summary = attempts.read(session, id);
    const LoadedTask loaded = load_recorded(attempts, session, summary);
    std::vector<std::uint8_t> start;
    if (summary.meta.origin) {
        if (summary.meta.origin->build != state_build())
            throw InputError(
                id, "",
                {QT_TRANSLATE_NOOP(
                     "errors", "began with a state that \"%1\" wrote and this build (\"%2\") cannot read"),
                 summary.meta.origin->build, state_build()},
                QT_TRANSLATE_NOOP("errors", "replay it with that version of the program"));
        start = attempts.start_state(session, id);
    }
    const ReplayVerdict verdict =
        verify_replay(loaded, summary, attempts.read_trace(session, id), start, attempts.score(session, id));
    const ReplayOutcome& outcome = verdict.outcome;

    const nlohmann::json document = {
        {"attempt", id},
        {"identical", outcome.identical},
        {"first_divergence_s",
         outcome.first_divergence_s < 0 ? nlohmann::json() : nlohmann::json(outcome.first_divergence_s)},
        {"state_hash", hex(outcome.state_hash)},
        {"recorded_state_hash", summary.state_hash},
        {"state_hash_identical", verdict.hash_identical},
        {"events_identical", verdict.events_identical},
        {"metrics_identical", verdict.metrics_identical},
        {"continues", origin_json(summary.meta.origin)},
        {"samples", verdict.samples},
        {"built_for", cpu_features()},
        {"recorded_on", summary.meta.cpu_features}};
    if (arguments.has("--json")) {
        print_json(document);
    } else {
        std::cout << (outcome.identical
                          ? "identical"
                          : "differs from " + decimal_text(outcome.first_divergence_s, 3) + " s on")
                  << (verdict.events_identical ? "" : ", events differ") << ", metrics "
                  << (verdict.metrics_identical ? "identical" : "differ") << ", state_hash "
                  << hex(outcome.state_hash)
                  << (verdict.hash_identical ? "" : ", but the store has " + summary.state_hash) << '\n';
    }
    // What continues another attempt has no score, so no metrics to compare.
    const bool same = verdict.same() && (verdict.metrics_identical || summary.meta.origin);
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
