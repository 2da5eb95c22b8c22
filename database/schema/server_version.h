// SPDX-License-Identifier: GPL-3.0-or-later
// What a PostgreSQL database is to this program: nothing, a programme server of some schema, or something
// else. Internal to this floor.
#pragma once

#include "database/rows/connection.h"

namespace fulcrum::database {

/// Whoever connects: also an account that may not read the table.
bool has_server_table(Connection& server, const char* name);
/// The schema of the tables there; 0: it has none of ours.
int found_server_schema(Connection& server);
/// Throws StoreError older_schema where PostgreSQL is too old.
void require_postgresql_version(Connection& server);
[[noreturn]] void fail_as_newer_server(const Connection& server, int found);
/// The server's id. Throws StoreError: missing (create it first), newer_schema, older_schema.
std::string require_server(Connection& server);

}  // namespace fulcrum::database
