// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/schema/server_version.h"

#include "database/schema/migration.h"

namespace fulcrum::database {
namespace {

constexpr int oldest_postgresql = 120000;  // as server_version_num has it

}  // namespace

bool has_server_table(Connection& server, const char* name) {
    Query row(server, "SELECT 1 FROM pg_tables WHERE schemaname = 'public' AND tablename = ?");
    row.bind(name);
    return row.next();
}

/// 0: it has none of our tables.
int found_server_schema(Connection& server) {
    if (!has_server_table(server, "programme_server")) return 0;
    Query row(server, "SELECT schema FROM programme_server");
    return row.next() ? static_cast<int>(row.integer(0)) : 0;
}

void require_postgresql_version(Connection& server) {
    Query row(server, "SELECT current_setting('server_version_num')::int, current_setting('server_version')");
    if (row.next() && row.integer(0) < oldest_postgresql)
        throw StoreError(
            StoreErrorKind::older_schema,
            {QT_TRANSLATE_NOOP("errors", "%1: PostgreSQL %2 is too old"), server.path(), row.text(1)},
            QT_TRANSLATE_NOOP("errors", "upgrade the server to PostgreSQL 12 or newer"));
}

[[noreturn]] void fail_as_newer_server(const Connection& server, int found) {
    throw StoreError(
        StoreErrorKind::newer_schema,
        {QT_TRANSLATE_NOOP("errors", "%1: made by a newer program (schema %2, this program knows %3)"),
         server.path(), found, latest_schema_version()},
        QT_TRANSLATE_NOOP("errors", "update Fulcrum on this station, then sync again; nothing is lost"));
}

std::string require_server(Connection& server) {
    require_postgresql_version(server);
    const int found = found_server_schema(server), known = latest_schema_version();
    if (found == 0)
        throw StoreError(StoreErrorKind::missing,
                         {QT_TRANSLATE_NOOP("errors", "%1: is not a programme server"), server.path()},
                         Sentence(QT_TRANSLATE_NOOP(
                                      "errors", "have its administrator run `fulcrum server create --to %1`"),
                                  server.path()));
    if (found > known) fail_as_newer_server(server, found);
    if (found < known)
        throw StoreError(StoreErrorKind::older_schema,
                         {QT_TRANSLATE_NOOP("errors", "%1: schema %2 is older than this program's %3"),
                          server.path(), found, known},
                         Sentence(QT_TRANSLATE_NOOP("errors",
                                                    "have its administrator run `fulcrum server create --to "
                                                    "%1` with this program; nothing is lost"),
                                  server.path()));
    Query row(server, "SELECT id FROM programme_server");
    return row.next() ? row.text(0) : std::string();
}

}  // namespace fulcrum::database
