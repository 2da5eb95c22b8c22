// SPDX-License-Identifier: GPL-3.0-or-later
// When which limits were put in force, as far as the programme keeps what accepted benchmark sets say: the
// same at every station that has exchanged, and on the server. Internal to this room.
#pragma once

#include <vector>

#include "assessment/curriculum/standing.h"
#include "database/rows/connection.h"

namespace fulcrum::database {

/// Of the standard variant and fidelity, for every task and class of devices, oldest first. A set counts
/// where it is newer than those accepted before it (database/scoring/asset_placing.h). One that is not
/// provisional is firm here; where it leaves an absolute limit of the task provisional, the next attempt
/// shows it.
std::vector<LimitsPutInForce> limits_put_in_force(Connection& connection);

}  // namespace fulcrum::database
