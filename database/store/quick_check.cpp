// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/quick_check.h"

#include <algorithm>
#include <chrono>
#include <tuple>

#include "database/rows/connection.h"
#include "database/store/audit.h"
#include "database/store/signing_keys.h"
#include "database/store/store_check.h"

namespace fulcrum::database {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int newest_audit_rows = 200;
/// SQLite looks at the pages of one table without asking whether to stop: recordings, which are nearly all of
/// a large store, are looked at whole up to this size of the file, else the newest of them are read.
constexpr std::int64_t whole_below_bytes = 100LL << 20;
constexpr int newest_rows = 64;
/// The same of the longest other tables (audit log, metrics): a table is looked at to its end once it was
/// begun.
constexpr std::int64_t whole_below_rows = 200000;

std::int64_t number_of(Connection& connection, const QString& sql) {
    Query row(connection, sql);
    return row.next() ? row.integer(0) : 0;
}

bool is_large(const std::string& table) {
    return table == "trace_chunk" || table == "attempt_product" || table == "attempt_origin";
}

/// The newest row's number, which is about how many there are and takes one path through the tree; 0 where
/// the table cannot be read.
std::int64_t rows_of(Connection& connection, const std::string& table) {
    try {
        return number_of(connection, "SELECT MAX(rowid) FROM " + QString::fromStdString(table));
    } catch (const StoreError& error) {
        if (error.kind() == StoreErrorKind::locked) throw;
        return 0;
    }
}

/// Empty: nothing was found.
Sentence look_at_table(Connection& connection, const std::string& table, bool whole) {
    const Sentence damaged(QT_TRANSLATE_NOOP("errors", "table %1: it or an index of it is damaged"), table);
    try {
        if (whole) {
            Query rows(connection, QString("PRAGMA quick_check('%1')").arg(QString::fromStdString(table)));
            while (rows.next())
                if (rows.text(0) != "ok") return damaged;
        } else {
            // The newest rows are on the last pages of the file, where one that was cut short ends.
            Query rows(connection, QString("SELECT * FROM %1 ORDER BY rowid DESC LIMIT %2")
                                       .arg(QString::fromStdString(table))
                                       .arg(newest_rows));
            while (rows.next()) {
            }
        }
    } catch (const StoreError& error) {
        if (error.kind() == StoreErrorKind::locked) return {};
        return damaged;
    }
    return {};
}

}  // namespace

std::vector<TableSize> smallest_tables_first(Connection& connection) {
    std::vector<TableSize> tables;
    {
        Query names(connection, "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
        while (names.next()) tables.push_back({names.text(0), 0});
    }
    for (TableSize& table : tables) table.rows = rows_of(connection, table.name);
    std::stable_sort(tables.begin(), tables.end(), [](const TableSize& a, const TableSize& b) {
        return std::make_tuple(is_large(a.name), a.rows) < std::make_tuple(is_large(b.name), b.rows);
    });
    return tables;
}

QuickCheck quick_check(const Store& store, int most_ms) {
    const Clock::time_point end = Clock::now() + std::chrono::milliseconds(most_ms);
    Connection& connection = store.connection();
    QuickCheck found;
    try {
        check_definitions(store, found.problems);
        if (store.found_schema() >= schema_with_signatures)
            for (Sentence& problem : verify_audit_end(connection, store.station_id(), newest_audit_rows))
                found.problems.push_back(std::move(problem));
        const std::int64_t bytes =
            number_of(connection, "PRAGMA page_count") * number_of(connection, "PRAGMA page_size");
        const std::vector<TableSize> tables = smallest_tables_first(connection);
        found.tables = static_cast<int>(tables.size());
        for (const TableSize& table : tables) {
            if (Clock::now() >= end) break;
            const bool whole =
                is_large(table.name) ? bytes < whole_below_bytes : table.rows < whole_below_rows;
            Sentence problem = look_at_table(connection, table.name, whole);
            if (!problem.empty()) found.problems.push_back(std::move(problem));
            if (whole) ++found.tables_seen;
        }
    } catch (const StoreError& error) {
        if (error.kind() != StoreErrorKind::locked) found.problems.push_back(error.problem_sentence());
    }
    return found;
}

void require_quick_check(const std::string& path, int most_ms) {
    StoreOptions options;
    options.read_only = options.older_schema = true;
    const QuickCheck found = quick_check(Store::open(path, options), most_ms);
    if (found.problems.empty()) return;
    throw StoreError(
        StoreErrorKind::corrupt,
        {QT_TRANSLATE_NOOP("errors", "%1: the store is damaged (%2)"), path, found.problems.front()},
        QT_TRANSLATE_NOOP(
            "errors",
            "restore the newest backup; nothing was changed (`fulcrum db check` lists all damage)"));
}

}  // namespace fulcrum::database
