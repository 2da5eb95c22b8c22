// SPDX-License-Identifier: GPL-3.0-or-later
// Simulates stored attempts again from their inputs and compares all that was recorded of them: what a person
// who holds the station's key replaced and signed again is found here, and only here.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "assessment/attempt/engine.h"
#include "database/records/checked_attempts.h"
#include "database/scoring/loaded_task.h"

namespace fulcrum::app {

struct ReplayVerdict {
    ReplayOutcome outcome;
    std::size_t samples = 0;     ///< of the record
    bool complete = true;        ///< false: stopped; what was simulated until then was compared
    bool hash_identical = true;  ///< of the end; true where the record has none
    bool events_identical =
        true;  ///< but those that the simulation does not make: pauses, lost devices, the end
    bool metrics_identical = false;  ///< of the score that was given, and there is one
    bool score_differs = false;      ///< it has other values, though it is of this version of the metrics
    bool same() const { return outcome.identical && hash_identical && events_identical; }
};

/// `start`: the state that the attempt began with, or empty. `keep_going` is asked after every step. Throws
/// InputError where the record has not as many inputs as samples.
ReplayVerdict verify_replay(const LoadedTask& loaded, const database::AttemptSummary& summary,
                            database::Trace trace, const std::vector<std::uint8_t>& start,
                            const std::optional<database::ScoreRow>& score,
                            const std::function<bool()>& keep_going = {});

struct SimulationSample {
    int attempts = 3;
    std::uint64_t seed = 0;  ///< which of them
    double most_s = 20;      ///< for all of them together; 0: as long as it takes
};
inline constexpr int most_simulated = 100000;
std::uint64_t random_sample_seed();

/// Notes name the seed and each attempt that was simulated, and what was left out. Operation::check_store; at
/// a programme server whoever owns it.
database::CheckItem check_by_simulation(const database::Store& store, const database::Session& session,
                                        const SimulationSample& sample,
                                        const database::StoreProgress& progress = {});

/// The whole check of a store, for `db check` and for the window: Store::check(), then the sample. A store
/// that is damaged is not simulated from, and an older one has other tables: without the item `simulation`.
database::CheckReport check_store_and_sample(const database::Store& store, const database::Session& session,
                                             const SimulationSample& sample,
                                             const database::StoreProgress& progress = {});

}  // namespace fulcrum::app
