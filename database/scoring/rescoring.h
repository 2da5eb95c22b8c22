// SPDX-License-Identifier: GPL-3.0-or-later
// Scores made from a stored record: the first one of what was interrupted (interrupted.h), and new ones
// next to those that older metrics or limits gave. The score in force never changes (docs/MANUAL.md).
#pragma once

#include <string>
#include <vector>

#include "database/records/attempts.h"
#include "database/scoring/loaded_task.h"
#include "database/scoring/scoring.h"

namespace fulcrum {

/// A score that was out of date and has a newer one next to it now.
struct RecomputedScore {
    std::string attempt_id, person_name, task_id;
    std::string why;                      ///< the versions it was computed with, and those in force
    std::optional<bool> passed_in_force;  ///< of the score in force, which stays
    std::optional<bool> passed;           ///< of the new one
    Statement not_scored_because;         ///< where it has neither passed nor failed
    Sentence problem;                     ///< why there is no new one; empty if there is
};

/// From the record alone; `loaded` as load_recorded() gives it. Throws AccessDenied, StoreError, InputError
/// (a task or scene that is not known here).
ScoredAttempt score_stored(const database::Attempts& attempts, const database::Session& session,
                           const database::AttemptSummary& summary, const LoadedTask& loaded,
                           const Limits& limits);

/// The metrics of this program and the benchmark sets of its assets.
database::ScoringInForce scoring_in_force();

/// Adds a score next to each one that is out of date and within the session's scope, oldest first;
/// `person_id` empty: of everybody. One that cannot be computed gives its reason, and the others are computed
/// all the same. Opens the store at `store_path` for itself. Any thread but the haptic and world threads.
/// Throws StoreError, AccessDenied.
std::vector<RecomputedScore> recompute_scores(const std::string& store_path, const database::Session& session,
                                              const std::string& person_id,
                                              const database::StoreProgress& progress = {});

}  // namespace fulcrum
