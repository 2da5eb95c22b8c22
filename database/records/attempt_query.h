// SPDX-License-Identifier: GPL-3.0-or-later
// The one SELECT behind attempt lists, debriefs, progress and cohort tables, and the people a session may
// see. Internal to the database.
#pragma once

#include <QString>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "database/records/attempts.h"
#include "database/rows/connection.h"

namespace fulcrum::database {

/// An SQL condition on `column` (a person id) that keeps the people within the session's scope for the
/// operation, and its bindings.
QString visible_people(const Session& session, Operation operation, const QString& column);
void bind_visible_people(Query& query, const Session& session, Operation operation);

/// Newest first. Access to a named person or cohort was checked by the caller; rows outside the scope are
/// left out here.
std::vector<AttemptSummary> query_attempts(const Store& store, const Session& session,
                                           const AttemptFilter& filter);
/// The same attempts one after another, in no order; `limit` does not count.
void for_each_attempt(const Store& store, const Session& session, const AttemptFilter& filter,
                      const std::function<void(AttemptSummary&&)>& visit);
/// Access was checked by the caller. Throws not_found.
AttemptSummary query_attempt(const Store& store, const std::string& attempt_id);

/// Throws not_found.
[[noreturn]] void unknown_attempt(const std::string& id);
/// The id of the person who performed it; throws not_found. It says nothing else, so it may be asked before
/// access is checked.
std::string person_of(const Store& store, const std::string& attempt_id);
/// Checks the operation on the person who performed it and returns that person's id. Throws not_found,
/// AccessDenied.
std::string require_attempt(const Store& store, const Session& session, Operation operation,
                            const std::string& attempt_id);

/// An SQL condition on table `attempt` under this name: its trace is in this store. That of an attempt which
/// the programme server sent is where it was recorded.
QString has_trace_here(const QString& attempt);
/// Throws not_found with the station that recorded it.
void require_trace_here(const Store& store, const std::string& attempt_id);

/// As Attempts::read_trace() and scene_text(). Access was checked by the caller.
Trace stored_trace(const Store& store, const std::string& attempt_id);
std::string stored_scene_text(const Store& store, const std::string& attempt_id);

/// `file` of the row of attempt_asset by which a copy for another person is known as one, also where its
/// original is not there; the row's `digest` is the id of the original. In SQL.
#define FULCRUM_COPIED_FROM "'copied/from'"

/// Ids of the attempts (table `a`) for which `whose` holds with this value that are copies of reassigned
/// ones.
std::set<std::string> copies_among(const Store& store, const QString& whose, const std::string& value);

/// The files that an attempt was performed with. Access was checked by the caller.
std::vector<AssetFile> assets_of(const Store& store, const std::string& attempt_id);

/// Interrupted, or ended by a simulator fault: by nobody's will.
bool is_cut_off(AttemptState state);
/// Whatever the person: assessed, not voided, and ended by the trainee or the time limit with a score, or cut
/// off and failed (docs/MANUAL.md).
bool is_counting(const AttemptSummary& attempt);

}  // namespace fulcrum::database
