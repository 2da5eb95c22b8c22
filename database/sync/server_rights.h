// SPDX-License-Identifier: GPL-3.0-or-later
// Who may do what on a programme server, in its own roles and row policies: nothing depends on the program
// that connects.
#pragma once

#include <string>
#include <vector>

#include "database/rows/connection.h"

namespace fulcrum::database {

/// Makes the roles and sets rights and policies as this program has them; inside the caller's transaction.
/// May be called again. Throws StoreError read_only where this account may not make roles.
void set_server_rights(Connection& server);
/// Tables of which nobody has decided who sees their rows: people see none. A test asks that there are none.
std::vector<std::string> tables_without_policy(Connection& server);

}  // namespace fulcrum::database
