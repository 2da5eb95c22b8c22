// SPDX-License-Identifier: GPL-3.0-or-later
// The stations of the programme, as far as a store knows them: itself, and those whose attempts it has.
#pragma once

#include <string>
#include <vector>

#include "database/rows/errors.h"
#include "database/store/store.h"

namespace fulcrum::database {

struct KnownStation {
    std::string id, name;
    bool own = false;             ///< the station of this store
    std::int64_t attempts = 0;    ///< that were performed there, also those of simulated people
    UtcMilliseconds created = 0;  ///< when its store was made
    UtcMilliseconds newest = 0;   ///< newest attempt or row of its audit log that is known here; 0: none
    std::string key;              ///< fingerprint of its newest signing key; empty where it is not known here
};

/// The own station first, the others by name. Operation::view_audit. Throws AccessDenied, StoreError. Any
/// thread.
std::vector<KnownStation> known_stations(const Store& store, const Session& session);

}  // namespace fulcrum::database
