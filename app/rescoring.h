// SPDX-License-Identifier: GPL-3.0-or-later
// Scores made from a stored record: the first one of what was interrupted (interrupted.h), and new ones
// beside those that older metrics or limits gave. The score in force never changes (docs/MANUAL.md).
#pragma once

#include <string>
#include <vector>

#include "app/scoring.h"
#include "database/records/attempts.h"
#include "ui/page/application_services.h"

namespace fulcrum::app {

/// From the record alone. Throws AccessDenied, StoreError, InputError (a task or scene that is not known
/// here).
ScoredAttempt score_stored(const database::Attempts& attempts, const database::Session& session,
                           const database::AttemptSummary& summary, const BenchmarkSet* benchmark);

/// The metrics of this program and the benchmark sets of its assets.
database::ScoringInForce scoring_in_force();

/// Adds a score beside each one that is out of date and within the session's scope, oldest first; `person_id`
/// empty: of everybody. One that cannot be made says why and does not keep the others from theirs. Opens the
/// store at `store_path` for itself. Any thread but the haptic and world threads. Throws StoreError,
/// AccessDenied.
std::vector<ui::RecomputedScore> recompute_scores(const std::string& store_path,
                                                  const database::Session& session,
                                                  const std::string& person_id,
                                                  const ui::Progress& progress = {});

}  // namespace fulcrum::app
