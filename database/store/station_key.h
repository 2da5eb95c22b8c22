// SPDX-License-Identifier: GPL-3.0-or-later
// The key of a station: whoever writes the audit log of a store signs each row with it. Its secret half is a
// file of its own, away from the store, so that an edited store cannot be signed again by somebody who has
// the store alone. A new key (key_rotation.h) is a second file until the audit log says that it signs: then
// it takes the place of the first. Any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "database/rows/crypto.h"

namespace fulcrum::database {

class StationKey {
  public:
    /// Reads the key of this station, or makes one (file 0600, folder 0700) that signs from row `next_row` of
    /// its audit log on. Throws StoreError (failed) where the file can be neither read nor made, or is not a
    /// key.
    /// `expected`: the public half that the audit log asks for, empty where it has none yet. Where a prepared
    /// key has it, a rotation was cut off after the log had it: the prepared key takes its place now.
    static StationKey of(const std::string& station_id, std::int64_t next_row, const Bytes& expected = {});
    /// As above where the file exists; makes none.
    static std::optional<StationKey> existing(const std::string& station_id);
    /// Makes the key that shall sign from row `first_row` on, or takes the one that a rotation which was cut
    /// off has left. `present` (public half) stays the key until adopt_prepared(). Within the transaction of
    /// the rotation. Throws StoreError (failed).
    static StationKey prepare(const std::string& station_id, std::int64_t first_row, const Bytes& present);
    /// The prepared key, where there is one.
    static std::optional<StationKey> prepared(const std::string& station_id);
    /// The prepared key takes the place of the key, whose secret half is gone then. Once the audit log has
    /// it for good; where it fails, of() does it later.
    static void adopt_prepared(const std::string& station_id) noexcept;

    /// Of the file: the folder FULCRUM_STATION_KEYS, else XDG configuration folder /fulcrum/keys.
    static std::string path_of(const std::string& station_id);

    const Bytes& public_half() const noexcept { return public_half_; }
    /// The first row that it can have signed.
    std::int64_t first_row() const noexcept { return first_row_; }
    /// Of the hash of an audit row.
    Bytes sign(const Bytes& row_hash) const;
    /// Of the statement with which the station joins a programme server (database/sync/enrolment_proof.h).
    Bytes sign_enrolment(const std::string& statement) const;

  private:
    StationKey(Bytes seed, std::int64_t first_row);
    static std::optional<StationKey> read(const std::string& path);
    Bytes seed_, public_half_;
    std::int64_t first_row_ = 1;
};

/// Hexadecimal digits by which people compare keys: BLAKE2b-128 of the public half.
std::string key_fingerprint(const Bytes& public_half);
bool row_signature_holds(const Bytes& public_half, const Bytes& row_hash, const Bytes& signature);
bool enrolment_signature_holds(const Bytes& public_half, const std::string& statement,
                               const Bytes& signature);

}  // namespace fulcrum::database
