// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt as files: its score as a JSON document, its record as tables (docs/FORMATS.md, Trace export).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "assessment/trace/trace.h"
#include "database/rows/attempt_records.h"
#include "database/scoring/loaded_task.h"
#include "database/scoring/scoring.h"
#include "database/store/store.h"

namespace fulcrum::app {

/// metrics, gates, pathology, passed, points and what else a score consists of.
nlohmann::json score_document(const ScoredAttempt& scored);
/// score_document() with the attempt's own data: task, seed, device_class, fidelity and others.
nlohmann::json attempt_document(const database::AttemptMeta& meta, const std::string& attempt,
                                const ScoredAttempt& scored);

/// Where an attempt began that did not begin at the beginning: attempt, tick, goal. Null: it did.
nlohmann::json origin_json(const std::optional<database::AttemptOrigin>& origin);

/// Writes trace.csv, events.csv and attempt.json of a stored attempt, with its score in force; without one
/// the metrics of its record and no verdict. Returns the paths. Throws InputError, StoreError, AccessDenied.
std::vector<std::string> export_trace(const database::Store& store, const database::Session& session,
                                      const std::string& attempt, const std::string& folder);

/// The score of an attempt at this task from its exported trace and the file of its events, held against the
/// limits of this device class and of the task's variant and fidelity.
nlohmann::json score_of_trace(Trace trace, const std::string& events_file, const LoadedTask& loaded,
                              DeviceClass device_class);

}  // namespace fulcrum::app
