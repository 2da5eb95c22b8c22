// SPDX-License-Identifier: GPL-3.0-or-later
// The numbered .sql files of database/schema, compiled in, applied one transaction each. Internal to this
// floor.
#pragma once

#include "database/rows/connection.h"

namespace fulcrum::database {

inline constexpr int application_id = 0x46554c43;  ///< "FULC" in the file's header: this is one of ours

int latest_schema_version();
/// The statements that lead from schema `from` to the next one.
QString schema_step(int from);
/// `PRAGMA user_version`; throws StoreError not_a_store if the file is SQLite but not ours (version 0 with
/// tables, or another id).
int read_schema_version(Connection& connection);
/// Applies the steps from the file's version up to `target`; foreign keys are checked before each commit.
void migrate(Connection& connection, int target);

}  // namespace fulcrum::database
