// SPDX-License-Identifier: GPL-3.0-or-later
// Who may do what on a programme server, in its own roles and row policies: nothing depends on the program
// that connects.
#pragma once

#include "database/rows/connection.h"

namespace fulcrum::database {

/// Makes the roles and sets rights and policies as this program has them; inside the caller's transaction.
/// May be called again. Throws StoreError read_only where this account may not make roles.
void set_server_rights(Connection& server);

}  // namespace fulcrum::database
