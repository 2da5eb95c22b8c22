// SPDX-License-Identifier: GPL-3.0-or-later
// Scores as rows, and the digest that the audit chain keeps of each. Internal to the database.
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "database/rows/attempt_records.h"
#include "database/rows/connection.h"
#include "database/store/store.h"

namespace fulcrum::database {

/// Writes the score with a new id, in force if the attempt has none yet, and its digest into the audit chain.
/// Inside the caller's transaction. Returns the id. Throws StoreError bad_value where a value is not finite.
std::string write_score(const Store& store, const Session& session, const std::string& attempt_id,
                        ScoreRow score);
/// Empty id if there is no such score.
ScoreRow read_score(Connection& connection, const std::string& score_id);
/// By attempt, of the attempts (table `a`) for which `whose` holds with these values: five queries, however
/// many there are.
std::map<std::string, ScoreRow> read_scores_in_force(Connection& connection, const QString& whose,
                                                     const std::vector<std::string>& values);
/// The metrics of those scores alone, in one query.
std::unordered_map<std::string, std::vector<MetricRow>> read_metrics_in_force(
    Connection& connection, const QString& whose, const std::vector<std::string>& values);
/// BLAKE2b-256 over every field, hex.
std::string score_digest(const std::string& attempt_id, const ScoreRow& score);

}  // namespace fulcrum::database
