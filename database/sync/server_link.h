// SPDX-License-Identifier: GPL-3.0-or-later
// The programme server of a station, and the password of its account there: a file next to the station's key
// (STATION.server, 0600), away from the store, so that a copy of the store cannot write at the server. Any
// thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/rows/server_address.h"

namespace fulcrum::database {

struct ServerLink {
    ServerAddress address;  ///< with the station's account
    std::string server_id, password;
    std::vector<std::string> cohorts;  ///< ids; empty: everybody

    /// Nothing where the station was not enrolled. Throws StoreError (failed) where the file is not one.
    static std::optional<ServerLink> of(const std::string& station_id);
    /// The same of an enrolment that has not come to its end; `enrolment`: the id of its token.
    static std::optional<ServerLink> unfinished(const std::string& station_id, const std::string& enrolment);
    /// Writes that; false where another program has been first. Throws StoreError (failed).
    bool begin(const std::string& station_id, const std::string& enrolment) const;
    /// Becomes the station's link; the unfinished one is gone then. Throws StoreError (failed).
    void finish(const std::string& station_id, const std::string& enrolment) const;
    /// Whether the address names this server with this account, or no account.
    bool is_for(const ServerAddress& other) const;
};

}  // namespace fulcrum::database
