// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes the units of one table on either side.
#pragma once

#include <QVariant>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "database/rows/connection.h"
#include "database/sync/sync_tables.h"

namespace fulcrum::database {

using SyncRow = std::vector<QVariant>;

struct Unit {
    std::string key;
    SyncRow root;
    std::vector<std::vector<SyncRow>> children;  ///< in the order of SyncTable::children
};

/// The state of a versioned unit.
struct UnitState {
    std::int64_t version = 0;
    QByteArray content;  ///< equal on both sides exactly where the unit is
    std::string unique;  ///< of SyncTable::unique
};

/// Rows of a table for which `where` holds, with its values, to the same table of the other side; those that
/// it has stay as they are there.
void copy_rows(Connection& from, Connection& to, const char* table, const char* where, const SyncRow& values);

class Units {
  public:
    /// `layout`: the store, whose columns both sides have.
    Units(const SyncTable& table, Connection& layout);
    const SyncTable& table() const { return table_; }

    /// Of the rows that are exchanged, or of all.
    std::set<std::string> keys(Connection& connection, bool exchanged) const;
    /// Of exchanged units that `from` has and `to` lacks. A score in force of an attempt that has another one
    /// in force at `to` is not among them: each side keeps its own.
    std::vector<std::string> missing(Connection& from, Connection& to) const;
    std::map<std::string, UnitState> states(Connection& connection) const;
    /// Without `whole`, rows of tables that only go up are left out.
    std::vector<Unit> read(Connection& connection, const std::vector<std::string>& keys, bool whole) const;
    /// Adds new units.
    void add(Connection& connection, const std::vector<Unit>& units) const;
    /// Makes versioned units what these are; where `guarded`, only those whose version is higher than that
    /// which is there. Returns how many were written.
    int replace(Connection& connection, const std::vector<Unit>& units, bool guarded) const;
    /// Values of a unit's column, of its own row or of those of a child.
    std::set<std::string> values(const Unit& unit, const Reference& reference) const;

  private:
    struct Columns {
        const char* table;
        const char* key;
        std::vector<std::string> names;
        std::size_t key_at = 0;
    };
    Columns columns_of(Connection& layout, const char* table, const char* key) const;
    const SyncTable& table_;
    Columns root_;
    std::vector<Columns> children_;
};

}  // namespace fulcrum::database
