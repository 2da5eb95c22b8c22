// SPDX-License-Identifier: GPL-3.0-or-later
// What a Store holds; internal to this floor.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "database/rows/connection.h"
#include "database/store/station_key.h"
#include "database/store/store.h"

namespace fulcrum::database {

struct Store::State {
    std::string path;
    StoreOptions options;
    std::unique_ptr<Connection> connection;
    std::string station_id;
    bool demo = false;
    int schema = 0;
    UtcMilliseconds ahead = 0;  ///< added to the clock: a demonstration resumes when its record ends
    std::vector<InterruptedAttempt> interrupted;
    std::optional<StationKey> key;  ///< read when the first row is signed
};

/// A row of table setting, or "".
std::string read_setting(Connection& connection, const std::string& key);
void write_setting(Connection& connection, const std::string& key, const std::string& value);

/// For what only stations keep, whatever a server answers of the same operation. Throws AccessDenied.
void require_at_station(const Store& store, const Session& session, Operation operation);

/// One view of the store for everything that is read while it exists: other programs may write, and a
/// record made after the audit log was read would have no row there. Begins with the first statement; within
/// a transaction there is one view already.
class OneView {
  public:
    explicit OneView(Connection& connection);
    ~OneView();
    OneView(const OneView&) = delete;
    OneView& operator=(const OneView&) = delete;

  private:
    Connection& connection_;
    bool own_;
};

/// Looks at a copy before it gets its name; false: stopped. What it throws leaves no file.
using CopyCheck = std::function<bool(const std::string& copy)>;
/// Copies the open database, as it is at the beginning, to a new file by SQLite's backup interface, 0600. It
/// has no log of its own: it is read without a file next to it, and whoever opens it for writing starts one.
/// Throws StoreError exists, disk_full, read_only. False if it was stopped, leaving no file.
bool copy_database(Connection& connection, const std::string& to_path, const StoreProgress& progress = {},
                   const CopyCheck& check = {});
/// The first check, but for the permissions of the file, that found something; null: none.
const CheckItem* first_finding(const CheckReport& report);

/// Closes attempts that were running without their program; audited. Within a transaction of its own.
std::vector<InterruptedAttempt> close_interrupted_attempts(const Store& store);

CheckReport check_store(const Store& store, const StoreProgress& progress);

}  // namespace fulcrum::database
