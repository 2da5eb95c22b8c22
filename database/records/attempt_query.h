// SPDX-License-Identifier: GPL-3.0-or-later
// The one SELECT behind attempt lists, debriefs, progress and cohort tables, and the people a session may
// see. Internal to this floor.
#pragma once

#include <QString>
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
/// Access was checked by the caller. Throws not_found.
AttemptSummary query_attempt(const Store& store, const std::string& attempt_id);

/// Assessed, real or asked-for person aside: ended by trainee or clock and scored, or interrupted and failed;
/// not voided (docs/MANUAL.md).
bool is_counting(const AttemptSummary& attempt);

}  // namespace fulcrum::database
