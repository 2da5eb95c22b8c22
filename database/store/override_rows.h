// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of educators' decisions on a standing, and what the audit log keeps of them.
#pragma once

#include <string>
#include <vector>

#include "assessment/curriculum/standing.h"
#include "database/rows/connection.h"

namespace fulcrum::database {

/// An educator's decision with its reason, shown wherever the standing is.
struct OverrideRow {
    StandingOverride decision;
    std::string person_id, author_id, reason;
    std::string author_name;  ///< read only
    std::string owner_id;     ///< read only: to whom person_id belongs
    bool own = false;         ///< read only: so does author_id, since a merge; then it does not count
};

/// Of one person and those merged into it, newest first; of everyone where `person_id` is empty.
std::vector<OverrideRow> read_overrides(Connection& connection, const std::string& person_id);
/// Of everyone, without owner_id and own: also of a store of an older schema.
std::vector<OverrideRow> read_raw_overrides(Connection& connection);
void write_override(Connection& connection, const OverrideRow& row);
/// JSON with everything but the author and the time, which the audit entry has itself.
std::string override_payload(const OverrideRow& row);
/// Whether a stored payload, which also has the role of the actor, says the same.
bool is_payload_of(const std::string& payload, const OverrideRow& row);

}  // namespace fulcrum::database
