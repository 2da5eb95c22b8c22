// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/quick_check.h"

#include <algorithm>
#include <chrono>

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
constexpr int newest_chunks = 64;

std::int64_t pragma_number(Connection& connection, const char* sql) {
    Query row(connection, sql);
    return row.next() ? row.integer(0) : 0;
}

bool is_large(const std::string& table) {
    return table == "trace_chunk" || table == "attempt_product" || table == "attempt_origin";
}

/// Small tables first: accounts and scores count more than recordings, which have checksums of their own.
std::vector<std::string> tables_of(Connection& connection) {
    std::vector<std::string> tables;
    Query names(connection, "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
    while (names.next()) tables.push_back(names.text(0));
    std::stable_partition(tables.begin(), tables.end(),
                          [](const std::string& one) { return !is_large(one); });
    return tables;
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
                                       .arg(newest_chunks));
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
            pragma_number(connection, "PRAGMA page_count") * pragma_number(connection, "PRAGMA page_size");
        const std::vector<std::string> tables = tables_of(connection);
        found.tables = static_cast<int>(tables.size());
        for (const std::string& table : tables) {
            if (Clock::now() >= end) break;
            const bool whole = !is_large(table) || bytes < whole_below_bytes;
            Sentence problem = look_at_table(connection, table, whole);
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
