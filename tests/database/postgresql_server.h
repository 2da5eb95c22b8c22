// SPDX-License-Identifier: GPL-3.0-or-later
// A PostgreSQL of the tests' own: in a temporary folder, on a socket in it, run by an account that is not
// root, started once a process and gone with it. Accounts of stations may also come over the loopback
// (network_server.h).
#pragma once

#include <string>

#include "database/rows/server_address.h"

namespace fulcrum::database::test {

class PostgresqlServer {
  public:
    /// Null where the programs of PostgreSQL are missing. Ends the program if they do not start.
    static PostgresqlServer* of_this_process();
    /// A new database with the tables of a programme server, or empty.
    ServerAddress new_database(bool with_tables = true);
    /// With tables, in a database that sorts texts by the rules of a language, as many servers do: "a" before
    /// "B". PostgreSQL before 15 has no such rules by name; there it is as new_database().
    ServerAddress new_database_sorted_as(const std::string& language);
    /// Account "station" has a password; "owner", who made the databases, needs none here.
    static ServerAddress as(ServerAddress address, const std::string& user);
    static constexpr const char* station_password = "a station's secret";
    void execute(const ServerAddress& address, const std::string& sql) const;
    /// Its messages are German from now on, where those of its package are installed, or English as at first.
    void write_german(bool german) const;

  private:
    PostgresqlServer() = default;
    std::string socket_folder_;
    int databases_ = 0;
};

}  // namespace fulcrum::database::test

#define FULCRUM_NEEDS_POSTGRESQL()                                                 \
    if (::fulcrum::database::test::PostgresqlServer::of_this_process() == nullptr) \
    GTEST_SKIP() << "the programs of PostgreSQL are missing: install the package postgresql"
