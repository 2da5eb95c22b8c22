// SPDX-License-Identifier: GPL-3.0-or-later
// The audit chain of a station (platform.md): digest = BLAKE2b(salt, payload), every row bound to the one
// before. Without a copy of the head elsewhere (reports print it) the owner of the file can re-chain it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/store.h"

namespace fulcrum::database {

struct AuditEntry {
    std::int64_t sequence = 0;
    UtcMilliseconds time = 0;
    std::string station_id, actor_id, actor_name, object_id, operation;
    std::string digest, previous_hash, hash;  ///< hex
    std::string payload;                      ///< JSON, or "payload erased"
};

class Audit {
  public:
    explicit Audit(const Store& store) : store_(store) {}
    /// Newest first. Operation::view_audit.
    std::vector<AuditEntry> entries(const Session& administrator, int limit = 500,
                                    std::int64_t before_sequence = -1) const;
    /// Hash of the newest row, hex; 64 zeros before the first.
    std::string head() const;
    /// Problems found, by sequence; empty if the chain and all payloads hold.
    std::vector<std::string> verify() const;
    std::int64_t count() const;

    /// Adds a row; inside the caller's transaction. For the rooms of this floor.
    void append(const Session& actor, const std::string& object_id, const std::string& operation,
                const std::string& payload_json) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
