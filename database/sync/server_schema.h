// SPDX-License-Identifier: GPL-3.0-or-later
// The database of a programme server: the same schema steps as a store, put into PostgreSQL's words, and what
// only a server has: its own row, the list of erasures, and the rights of stations.
#pragma once

#include <QString>

#include "database/rows/connection.h"
#include "database/schema/migration.h"
#include "database/sync/programme_server.h"

namespace fulcrum::database {

/// A schema step of the store in PostgreSQL's words: types, foreign keys that a transaction may check at its
/// end, triggers as functions. Throws StoreError failed if a trigger is left that it does not know.
QString step_for_server(const QString& step);

/// Makes or upgrades the tables, in one transaction; `now`: ms since 1970. Throws StoreError: newer_schema,
/// not_a_store (tables of something else), read_only. `target`: the schema to reach.
ServerSchema create_server(Connection& server, std::int64_t now, int target = latest_schema_version());

}  // namespace fulcrum::database
