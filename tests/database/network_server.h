// SPDX-License-Identifier: GPL-3.0-or-later
// The tests' PostgreSQL as a station meets it over a network, with TLS and without.
#pragma once

#include <optional>
#include <string>

#include "database/rows/server_address.h"

namespace fulcrum::database::test {

/// With its private key, which has no passphrase.
struct Certificate {
    std::string file, key;
};

/// Made and signed by itself for a machine of this name, in that folder; empty where the program openssl is
/// missing.
std::optional<Certificate> make_certificate(const std::string& folder, const std::string& name);

class NetworkServer {
  public:
    /// `database`: as its owner reaches it, over the socket.
    explicit NetworkServer(ServerAddress database);
    /// As before: without TLS.
    ~NetworkServer();
    NetworkServer(const NetworkServer&) = delete;
    NetworkServer& operator=(const NetworkServer&) = delete;
    /// The database over the network, as that account; empty where the server could not listen there.
    std::optional<ServerAddress> as(const std::string& user) const;
    void encrypt_with(const Certificate& certificate);

  private:
    void turn_tls(bool on);
    std::string setting(const char* name) const;
    ServerAddress database_;
    bool is_encrypted_ = false;
};

}  // namespace fulcrum::database::test
