// SPDX-License-Identifier: GPL-3.0-or-later
// The key of a station: whoever writes the audit log of a store signs each row with it. Its secret half is a
// file of its own, away from the store, so that an edited store cannot be signed again by somebody who has
// the store alone. Any thread.
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
    static StationKey of(const std::string& station_id, std::int64_t next_row);
    /// As above where the file exists; makes none.
    static std::optional<StationKey> existing(const std::string& station_id);

    /// Of the file: the folder FULCRUM_STATION_KEYS, else XDG configuration folder /fulcrum/keys.
    static std::string path_of(const std::string& station_id);

    const Bytes& public_half() const noexcept { return public_half_; }
    /// The first row that it can have signed.
    std::int64_t first_row() const noexcept { return first_row_; }
    /// Of the hash of an audit row.
    Bytes sign(const Bytes& row_hash) const;

  private:
    StationKey(Bytes seed, std::int64_t first_row);
    Bytes seed_, public_half_;
    std::int64_t first_row_ = 1;
};

/// Hexadecimal digits by which people compare keys: BLAKE2b-128 of the public half.
std::string key_fingerprint(const Bytes& public_half);
bool row_signature_holds(const Bytes& public_half, const Bytes& row_hash, const Bytes& signature);

}  // namespace fulcrum::database
