// SPDX-License-Identifier: GPL-3.0-or-later
// Traces on demand: a sync brings an attempt's result and scores; its trace comes from the programme server
// when somebody wants to see it, and then stays here. Any thread.
#pragma once

#include <string>

#include "database/sync/sync.h"

namespace fulcrum::database {

struct FetchedTrace {
    bool complete = true;  ///< false: stopped by SyncOptions::stop; nothing was stored
    std::int64_t chunks = 0, bytes = 0;
    std::string signed_by;  ///< fingerprint of the key; empty where the trace was here already
};

/// Whether the trace was kept, is not here, and the station was enrolled at a server. Operation::read_trace.
bool can_fetch_trace(const Store& store, const Session& session, const std::string& attempt_id);

/// Fetches and stores the trace, after it was found to be what the recording station has signed; audited.
/// Nothing happens where it is here. Operation::read_trace. Throws StoreError unreachable; not_found (no such
/// attempt, or the server has no trace of it); corrupt (not as it was signed); missing (not enrolled).
FetchedTrace fetch_trace(const Store& store, const Session& session, const ServerAddress& address,
                         const std::string& attempt_id, const SyncOptions& options = {});

}  // namespace fulcrum::database
