// SPDX-License-Identifier: GPL-3.0-or-later
// Records for the check that simulates attempts again (app/live/simulation_check.h): whoever checks the store
// is shown the ids of attempts, no person and no score, so this needs Operation::check_store only. At a
// programme server the account sees what its row policies show it.
#pragma once

#include <string>
#include <vector>

#include "database/records/attempts.h"
#include "database/rows/trace_codec.h"

namespace fulcrum::database {

struct CheckableAttempts {
    std::vector<std::string> ids;  ///< in order
    std::int64_t others = 0;       ///< with a recording, but made by another version, or begun with a state
};

/// Attempts that ended, whose recordings are here, and which this version of the program has recorded: on the
/// same processor level they are repeated bit for bit.
CheckableAttempts checkable_attempts(const Store& store, const Session& session,
                                     const std::string& program_version, const std::string& cpu_features);

struct CheckedAttempt {
    AttemptSummary summary;
    std::string scene_text;
    std::vector<AssetFile> assets;
    Trace trace;
    std::optional<ScoreRow> score;  ///< in force
};
/// Throws StoreError not_found, corrupt.
CheckedAttempt read_checked_attempt(const Store& store, const Session& session,
                                    const std::string& attempt_id);

}  // namespace fulcrum::database
