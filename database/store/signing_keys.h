// SPDX-License-Identifier: GPL-3.0-or-later
// The keys that signed the audit log of a station, one after the other, and the change to a new one. The row
// key.rotate is signed by the old key and names the public half of the new one as its object, which the hash
// of the row holds and no erasure of payloads takes away; the next row, key.begin, is the first that the new
// key signs. So whoever trusts one key can follow the chain to the present one, and a key that has ended can
// sign nothing later.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/rows/crypto.h"
#include "database/store/store.h"

namespace fulcrum::database {

inline constexpr const char *key_rotation = "key.rotate", *key_beginning = "key.begin";
inline constexpr int schema_with_signatures = 14;

struct SigningKey {
    Bytes public_half;
    std::string fingerprint;
    std::int64_t first_row = 0, last_row = 0;  ///< of the audit log
    UtcMilliseconds from = 0, until = 0;       ///< when these were written
    /// The key before it has signed that this one follows; false for the first, and where the one before was
    /// lost.
    bool announced = false;
};

/// In the order of their first rows; the last one is in use. As the log has them: db check verifies it.
std::vector<SigningKey> signing_keys(Connection& connection, const std::string& station_id);

/// Whether the key of this fingerprint (or its first digits) is the newest, or announced keys lead from it to
/// the newest.
bool leads_to_newest(const std::vector<SigningKey>& keys, const std::string& fingerprint);

/// A new key signs from now on; audited, with the reason, by the old key and the new one in one transaction.
/// The secret half of the old key is gone afterwards. Operation::rotate_key. Throws StoreError bad_value
/// without a reason, failed where the new key cannot be written.
SigningKey rotate_station_key(const Store& store, const Session& administrator, const std::string& reason);

/// What a look at all signatures has found.
struct SignatureCheck {
    std::int64_t count = 0;  ///< signatures looked at
    std::vector<Sentence> problems;
    std::vector<Sentence> notes;  ///< keys that the one before did not announce
};

/// Of a store or a server: from the first signed row of a station on, each row has to have a signature that
/// fits, by the key whose turn it is. `own_station`: the station whose key is on this machine; its rows have
/// to be signed by that key.
SignatureCheck verify_audit_signatures(Connection& connection, const std::string& own_station);

}  // namespace fulcrum::database
