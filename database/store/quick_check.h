// SPDX-License-Identifier: GPL-3.0-or-later
// A look at a store that takes a bounded time, for every start of the window and for a list of backups: the
// schema, the newest audit rows, and the pages of as many tables as the time allows, recordings last. What it
// finds is wrong; what it does not find may be there all the same: `db check` reads everything.
#pragma once

#include <string>
#include <vector>

#include "database/store/store.h"

namespace fulcrum::database {

struct QuickCheck {
    std::vector<Sentence> problems;  ///< empty: nothing was found
    int tables = 0, tables_seen = 0;
    bool complete() const noexcept { return tables_seen == tables; }
};

/// Of a large store at the start of the window, with what a slow disk needs.
inline constexpr int quick_check_ms = 1000;

struct TableSize {
    std::string name;
    std::int64_t rows = 0;  ///< about; 0 where it cannot be read
};
/// The order of the look: accounts and scores count more than the audit log's past, and recordings, which
/// come last, have checksums of their own. With the tables by name, the log of a large store took all the
/// time.
std::vector<TableSize> smallest_tables_first(Connection& connection);

/// Stops beginning new tables after `most_ms`. Throws nothing that the store says: a page that cannot be read
/// is a problem.
QuickCheck quick_check(const Store& store, int most_ms = quick_check_ms);

/// Opens the store to read, as it is, and looks at it; before a program writes to it. Throws StoreError as
/// Store::open(), and corrupt with the first problem.
void require_quick_check(const std::string& path, int most_ms = quick_check_ms);

}  // namespace fulcrum::database
