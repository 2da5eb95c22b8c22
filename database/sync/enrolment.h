// SPDX-License-Identifier: GPL-3.0-or-later
// How a station becomes one of a programme server: the server's owner makes a token
// (database/sync/server_enrolment.h), the station gives it once and gets an account of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/rows/server_address.h"
#include "database/store/store.h"

namespace fulcrum::database {

struct Enrolment {
    ServerAddress address;             ///< of the station's account
    std::vector<std::string> cohorts;  ///< ids of those whose people it gets; empty: everybody
};

/// Registers the station with the public half of its key, and proves to the server that it holds the other
/// half (enrolment_proof.h); its account's password goes next to the key.
/// Audited. Cut off anywhere, the same call with the same token completes it. Operation::backup (an
/// administrator); where the store has no administrator yet, the station itself may. Throws StoreError:
/// bad_value (mistyped), conflict (used, withdrawn, out of date, of another server; another key),
/// unreachable, older_schema, sealed_demo.
Enrolment enrol_station(const Store& store, const Session& session, const ServerAddress& server,
                        const std::string& token);

/// Whether the station has an account of this server (whatever account the address names).
bool is_enrolled_at(const Store& store, const ServerAddress& server);

/// What the station was enrolled for, in words of its store.
struct LinkedServer {
    std::string address;               ///< as people write it
    std::vector<std::string> cohorts;  ///< names, or ids of cohorts that have not come yet; empty: everybody
    UtcMilliseconds last_sync = 0;     ///< the last exchange that transferred something; 0: none
};
/// Nothing where the station was not enrolled. Operation::backup. Throws StoreError (failed).
std::optional<LinkedServer> linked_server(const Store& store, const Session& session);

/// That the station has some cohorts of the programme only, for whoever reads figures of cohorts here.
/// Nothing for trainees, where the station has everybody, and where the store is the server. Throws
/// StoreError (failed).
std::optional<Sentence> station_scope(const Store& store, const Session& session);

/// For what must be of the whole programme. Throws StoreError: conflict where the station has some cohorts of
/// it only, failed.
void require_whole_programme(const Store& store);

}  // namespace fulcrum::database
