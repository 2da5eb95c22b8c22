// SPDX-License-Identifier: GPL-3.0-or-later
// What the administrator of a programme server does with it. Each call connects, works and ends. Any thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/access/access.h"
#include "database/rows/errors.h"
#include "database/rows/server_address.h"

namespace fulcrum::database {

struct ServerSchema {
    int from = 0, to = 0;  ///< equal: nothing was to be done
};
/// Makes the tables in an empty database, or brings them up to this program's schema, in one transaction.
/// Throws StoreError: unreachable; newer_schema; not_a_store (tables of something else); read_only.
ServerSchema create_programme_server(const ServerAddress& address);

struct ServerCheck {
    std::int64_t stations = 0, audit_rows = 0, signatures = 0, records = 0;
    std::string audit_head;  ///< as reports from this server print it
    std::vector<Sentence> problems;
    std::vector<Sentence> notes;  ///< keys that the key before did not announce; refused claims of stations
};
/// Verifies the audit chain and the signatures of every station that has pushed, and compares attempts,
/// traces, scores and reviews with the digests that were signed.
ServerCheck check_programme_server(const ServerAddress& address);

struct ServerAccount {
    std::string name;  ///< the person's id
    std::string login, display_name;
    std::vector<Role> roles;  ///< of a server; empty: the account sees nothing
    bool made = false;        ///< it was not there before
    std::string address;      ///< to be named as the store
};
/// Makes the account of a person, or brings its roles up to what the programme gives the person now. It has
/// no password until the server's administrator gives it one. Throws StoreError not_found (no such login),
/// bad_value (no role that has an account), read_only.
ServerAccount grant_at_programme_server(const ServerAddress& address, const std::string& login);

struct ErasedRows {
    std::string table;
    std::int64_t rows = 0;
};
/// Erases a person at the server; stations follow at their next sync. A dry run only counts. Returns what
/// was, or would be, deleted. Throws StoreError not_found, read_only (this account may not).
std::vector<ErasedRows> erase_at_programme_server(const ServerAddress& address, const std::string& person_id,
                                                  bool dry_run);

}  // namespace fulcrum::database
