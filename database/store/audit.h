// SPDX-License-Identifier: GPL-3.0-or-later
// The audit chain of a station (docs/MANUAL.md): digest = BLAKE2b(salt, payload), every row bound to the one
// before. Without a copy of the head elsewhere (reports print it) the owner of the file can re-chain it.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "database/store/record_digests.h"
#include "database/store/store.h"

namespace fulcrum::database {

/// Key in the payload of a row with which a one-time password was issued: the digest (BLAKE2b-256, hex) of
/// the password's verifier, by which a sign-in knows the row. Not among what entries() shows.
inline constexpr const char* verifier_key = "verifier";

struct AuditEntry {
    std::int64_t sequence = 0;
    UtcMilliseconds time = 0;
    std::string station_id, actor_id, actor_name, object_id, operation;
    std::string role;  ///< in which the actor acted; "" where the payload is erased or older
    std::string person_id,
        person_name;  ///< whom the object is or belongs to; "" for cohorts, settings, the store
    std::string digest, previous_hash, hash;  ///< hex
    /// JSON, or "payload erased". What is said of an attempt (how it ended, why it was voided, what a trainee
    /// asked for) reads "withheld": whoever views the audit log sees no reviews (docs/MANUAL.md). Why it
    /// became practice is a stored statement (statement_of()), in rows of older programs an English text.
    std::string payload;
};

/// Which rows of this station's chain; empty fields ask for nothing.
struct AuditFilter {
    std::string person_id;                ///< did it, or it was done to them or to an attempt of theirs
    std::string kind;                     ///< "attempt.void", or "attempt" for every one of that group
    UtcMilliseconds from = 0, until = 0;  ///< from <= time < until; until 0: now
    std::int64_t before_sequence = -1;    ///< older rows than this one
    int limit = 500;
};

/// Sequences by station.
using AuditRows = std::map<std::string, std::set<std::int64_t>>;

/// As Audit::verify(), of a store or a programme server; `erased`: payloads that are known to be erased.
std::vector<Sentence> verify_audit_chains(Connection& connection, AuditRows erased = {});
/// The newest `rows` of a station's log: numbers, hashes and signatures, without the payloads.
std::vector<Sentence> verify_audit_end(Connection& connection, const std::string& station, int rows);
/// "audit row 12", on a server with its station.
Sentence audit_place(const Connection& connection, const std::string& station, std::int64_t sequence);

/// A row of some station's log with everything that proves it.
struct SignedRow {
    std::string station_id, actor_id, object_id, operation, payload;
    std::int64_t sequence = 0, time = 0;
    std::vector<std::uint8_t> previous, salt, digest, hash, public_half, signature;
};
/// Payload, digest, hash and signature belong together. Whose key it is the caller has to know.
bool signed_row_holds(const SignedRow& row);

/// Of a programme server: the newest hash of the one station that has sent its log, else the BLAKE2b of one
/// line "STATION HASH" for each, by id.
std::string server_audit_head(Connection& server);

class Audit {
  public:
    explicit Audit(const Store& store) : store_(store) {}
    /// Newest first. Operation::view_audit.
    std::vector<AuditEntry> entries(const Session& administrator, const AuditFilter& filter = {}) const;
    /// The operations that the chain holds, by name. Operation::view_audit.
    std::vector<std::string> kinds(const Session& administrator) const;
    /// Fingerprint of the key that signed the newest row of this station; empty where it is not signed.
    std::string signing_key() const;
    /// Fingerprint of the key that signed the end of the attempt, or its import or copy; empty where this
    /// store does not hold that row, it is not signed, or the store is a server, which shows signatures to
    /// nobody.
    std::string signer_of(const std::string& attempt_id) const;
    /// Hash of the newest row, hex; 64 zeros before the first.
    std::string head() const;
    /// Whether a row of any station has this hash; `hex`: at least its first 16 digits, as reports print
    /// them.
    bool has_head(const std::string& hex) const;
    /// Problems found, by sequence; empty if the chain holds and every payload is as it was written, or was
    /// erased by a deed that the chain holds.
    std::vector<Sentence> verify() const;
    std::int64_t count() const;
    /// The key that will sign the next row. Within a transaction that writes. For the rooms of this floor.
    const StationKey& next_key() const;

    /// Adds a row; inside the caller's transaction, after its changes. The role goes into the payload, and so
    /// do the digests of the records that the deed made, changed or deleted. For the rooms of this floor.
    void append(const Session& actor, const std::string& object_id, const std::string& operation,
                const std::string& payload_json, const std::vector<RecordName>& records = {}) const;
    /// Deletes the payloads of these rows; the rows stay. What they held of records that remain must be
    /// among `records`. For the rooms of this floor.
    void erase_payloads(const Session& actor, const std::vector<std::int64_t>& sequences,
                        const std::string& reason, const std::vector<RecordName>& records) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
