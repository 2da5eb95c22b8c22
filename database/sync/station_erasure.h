// SPDX-License-Identifier: GPL-3.0-or-later
// Erasing a person at a station whose programme has no server. Whom it has erased, and whom a programme's
// server has, is in a list away from the store, next to the station's key (UUID and time, nothing else): a
// backup that is older than the erasure still has the person, and the list erases them again when it is
// restored.
#pragma once

#include <string>
#include <vector>

#include "database/store/store.h"
#include "database/sync/programme_server.h"

namespace fulcrum::database {

/// What is deleted, by table; `dry_run`: what would be. With the person go the accounts that were merged into
/// them. Never oneself, nor the last administrator. Operation::erase_person; audited with the reason. Throws
/// StoreError not_found; conflict where the programme has a server, which erases for all its stations; locked
/// while the person performs.
std::vector<ErasedRows> erase_person(const Store& store, const Session& director,
                                     const std::string& person_id, const std::string& reason, bool dry_run);

/// Whether the store's log has an exchange with a programme server, also one that was cut off: from then on
/// only the server erases.
bool has_begun_exchange(const Store& store);

/// Enters people whom the server or this station erases; lasts when it returns. Throws StoreError (failed).
void add_to_erasure_list(const Store& store, const std::vector<std::string>& people);

/// Erases whom the station's list names and the store still has: after a restore, at the start of a program,
/// and where an erasure was cut off. Returns how many.
int erase_listed(const Store& store);

/// The list's file: the folder of the station's key.
std::string erasure_list_path(const std::string& station_id);

}  // namespace fulcrum::database
