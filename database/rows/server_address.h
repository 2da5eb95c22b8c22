// SPDX-License-Identifier: GPL-3.0-or-later
// Where a programme server is: postgresql://USER@HOST:PORT/DATABASE. The password comes from where libpq
// looks for it (PGPASSFILE, ~/.pgpass, a service, PGPASSWORD), never from the address.
#pragma once

#include <string>

#include "database/rows/errors.h"

namespace fulcrum::database {

struct ServerAddress {
    std::string user, host, database, service;
    int port = 0;  ///< 0: the default, or that of the service

    /// Throws StoreError bad_value: another scheme, a password in it, an unknown parameter.
    static ServerAddress parse(const std::string& text);
    /// True for what parse() is for: it names a server, not a file.
    static bool is_address(const std::string& text);
    /// As people write it; without parameters that were not given.
    std::string text() const;
    /// True for a socket of this machine and its loopback.
    bool is_local() const;
    /// For libpq: patience, the program's name, the service, and TLS unless the address is local.
    std::string options() const;
};

/// Throws the ConnectError for a connection that could not be made; `said`: in libpq's words.
[[noreturn]] void fail_to_connect(const std::string& server, ServerRefusal why, const std::string& said);
/// The same for a statement that failed; `state`: the SQLSTATE, empty where the connection was lost.
[[noreturn]] void fail_on_server(const std::string& server, const std::string& state,
                                 const std::string& said);

}  // namespace fulcrum::database
