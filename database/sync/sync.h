// SPDX-License-Identifier: GPL-3.0-or-later
// The exchange between a station's store and the programme server: erasures, then what the server lacks, then
// the audit log, then what the station lacks (docs/FORMATS.md, Sync). Each batch is one transaction on the
// side that is written, and the other side is only read: cut off anywhere, the next run completes it. Any
// thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "database/rows/errors.h"
#include "database/rows/server_address.h"
#include "database/store/store.h"

namespace fulcrum::database {

struct SyncCount {
    std::string title;  ///< "attempts"
    std::int64_t pushed = 0, pulled = 0;
};

struct SyncResult {
    bool complete = true;     ///< false: stopped by `stop`; the next run completes it
    std::int64_t erased = 0;  ///< people whom the server's list of erasures names and who were still here
    std::vector<SyncCount> counts;    ///< tables of which something was transferred
    std::int64_t audit_rows = 0;      ///< pushed
    std::vector<Sentence> conflicts;  ///< what was decided, or waits for somebody
    double clock_ahead_s = 0;         ///< of the server: this station's clock
    std::int64_t transferred() const;
};

struct SyncOptions {
    /// How far it is, 0..1, and what it is at.
    std::function<void(double done, const std::string& line)> progress = {};
    /// Asked before each statement for the server; true ends the exchange, the open batch is rolled back.
    std::function<bool()> stop = {};
};

/// The server at which the station was enrolled. Throws StoreError missing where it was not.
ServerAddress server_of(const Store& store);

/// Operation::backup (an administrator); where the store has no administrator yet, the station itself may.
/// Throws AccessDenied and StoreError: unreachable, missing, older_schema, newer_schema; conflict where the
/// store belongs to another programme or is not the one that the server knows; sealed_demo.
/// An address without an account, or with the one that the station was enrolled with, is asked with the
/// station's password; others with the one that libpq finds.
SyncResult sync_with_server(const Store& store, const Session& session, const ServerAddress& address,
                            const SyncOptions& options = {});

/// Differences of more than this are reported.
inline constexpr double clock_tolerance_s = 120;

}  // namespace fulcrum::database
