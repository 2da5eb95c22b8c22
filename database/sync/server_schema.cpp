// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/server_schema.h"

#include <QRegularExpression>

#include "database/rows/crypto.h"
#include "database/sync/server_rights.h"

namespace fulcrum::database {
namespace {

constexpr int oldest_postgresql = 120000;  // as server_version_num has it

/// A trigger that refuses, as all of ours do, becomes a function of the same name.
QString trigger_for_server(const QRegularExpressionMatch& trigger) {
    const QString name = trigger.captured(1), condition = trigger.captured(4);
    return "CREATE OR REPLACE FUNCTION " + name + "() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN IF " +
           (condition.isEmpty() ? "TRUE" : condition) + " THEN RAISE EXCEPTION '" + trigger.captured(5) +
           "'; END IF; IF TG_OP = 'DELETE' THEN RETURN OLD; END IF; RETURN NEW; END $$;\nCREATE TRIGGER " +
           name + " BEFORE " + trigger.captured(2) + " ON " + trigger.captured(3) +
           " FOR EACH ROW EXECUTE FUNCTION " + name + "();";
}

const char* const server_tables = R"(
CREATE TABLE programme_server (id TEXT PRIMARY KEY, schema BIGINT NOT NULL, created BIGINT NOT NULL);
CREATE TABLE erasure (person_id TEXT COLLATE "C" PRIMARY KEY, time BIGINT NOT NULL);
CREATE TABLE erased_payload (station_id TEXT COLLATE "C" NOT NULL, sequence BIGINT NOT NULL,
    PRIMARY KEY (station_id, sequence));
CREATE FUNCTION of_erased_person() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN
    IF EXISTS (SELECT 1 FROM erasure WHERE person_id = to_jsonb(NEW) ->> TG_ARGV[0]) AND
        NOT (TG_TABLE_NAME = 'person' AND to_jsonb(NEW) ->> 'login' = 'erased-' || (to_jsonb(NEW) ->> 'id'))
    THEN RAISE EXCEPTION 'this person was erased'; END IF;
    RETURN NEW; END $$;
CREATE FUNCTION of_erased_payload() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN
    IF EXISTS (SELECT 1 FROM erased_payload WHERE station_id = NEW.station_id AND sequence = NEW.sequence)
    THEN RAISE EXCEPTION 'this payload was erased'; END IF;
    RETURN NEW; END $$;
CREATE TRIGGER of_erased BEFORE INSERT ON audit_payload FOR EACH ROW EXECUTE FUNCTION of_erased_payload();
)";

/// Tables whose rows belong to a person, and by which column: rows of an erased person are refused.
constexpr const char* owned[][2] = {{"person", "id"},
                                    {"person_role", "person_id"},
                                    {"credential", "person_id"},
                                    {"cohort_member", "person_id"},
                                    {"cohort_educator", "person_id"},
                                    {"attempt", "person_id"},
                                    {"comment", "author_id"},
                                    {"correction_request", "person_id"},
                                    {"standing_override", "person_id"},
                                    {"curriculum_move", "person_id"},
                                    {"personal_goal", "person_id"}};

bool has_table(Connection& server, const char* name) {
    Query row(server,
              "SELECT 1 FROM information_schema.tables WHERE table_schema = 'public' AND table_name = ?");
    row.bind(name);
    return row.next();
}

/// 0: it has none of our tables.
int found_schema(Connection& server) {
    if (!has_table(server, "programme_server")) return 0;
    Query row(server, "SELECT schema FROM programme_server");
    return row.next() ? static_cast<int>(row.integer(0)) : 0;
}

void require_version(Connection& server) {
    Query row(server, "SELECT current_setting('server_version_num')::int, current_setting('server_version')");
    if (row.next() && row.integer(0) < oldest_postgresql)
        throw StoreError(
            StoreErrorKind::older_schema,
            {QT_TRANSLATE_NOOP("errors", "%1: PostgreSQL %2 is too old"), server.path(), row.text(1)},
            QT_TRANSLATE_NOOP("errors", "upgrade the server to PostgreSQL 12 or newer"));
}

[[noreturn]] void fail_as_newer(const Connection& server, int found) {
    throw StoreError(
        StoreErrorKind::newer_schema,
        {QT_TRANSLATE_NOOP("errors", "%1: made by a newer program (schema %2, this program knows %3)"),
         server.path(), found, latest_schema_version()},
        QT_TRANSLATE_NOOP("errors", "update Fulcrum on this station, then sync again; nothing is lost"));
}

}  // namespace

QString step_for_server(const QString& step) {
    static const QRegularExpression trigger(
        "CREATE TRIGGER (\\w+) BEFORE (UPDATE(?: OF [\\w, ]+?)?|DELETE|INSERT) ON "
        "(\\w+)\\s+(?:WHEN\\s+(.*?)\\s*)?BEGIN "
        "SELECT RAISE\\(ABORT, '((?:[^']|'')*)'\\); END;",
        QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression text("\\bTEXT\\b"), integer("\\bINTEGER\\b"), blob("\\bBLOB\\b"),
        reference("(REFERENCES \\w+ \\([^)]*\\))");
    QString result;
    int done = 0;
    for (auto match = trigger.globalMatch(step); match.hasNext();) {
        const QRegularExpressionMatch one = match.next();
        result += step.mid(done, one.capturedStart() - done) + trigger_for_server(one);
        done = one.capturedEnd();
    }
    result += step.mid(done);
    if (result.contains("RAISE(ABORT"))
        throw StoreError(StoreErrorKind::failed,
                         QT_TRANSLATE_NOOP("errors", "a trigger of the schema has no form for a server"),
                         QT_TRANSLATE_NOOP("errors", "report this: the program is incomplete"));
    result.replace(text, "TEXT COLLATE \"C\"").replace(integer, "BIGINT").replace(blob, "BYTEA");
    return result.replace(reference, "\\1 DEFERRABLE");
}

ServerSchema create_server(Connection& server, std::int64_t now, int target) {
    require_version(server);
    Transaction transaction(server);
    server.execute("SELECT pg_advisory_xact_lock(" + QString::number(application_id) + ")");
    ServerSchema schema{found_schema(server), target};
    if (schema.from > schema.to) fail_as_newer(server, schema.from);
    if (schema.from == 0 && has_table(server, "person"))
        throw StoreError(StoreErrorKind::not_a_store,
                         {QT_TRANSLATE_NOOP("errors", "%1: has tables of another program"), server.path()},
                         QT_TRANSLATE_NOOP("errors", "make a database of its own (createdb) and name that"));
    for (int step = schema.from; step < schema.to; ++step) server.execute(step_for_server(schema_step(step)));
    if (schema.from == 0) {
        server.execute(server_tables);
        Query(server, "INSERT INTO programme_server (id, schema, created) VALUES (?, ?, ?)")
            .bind(random_uuid())
            .bind(schema.to)
            .bind(now)
            .run();
    }
    for (const auto& [table, column] : owned) {
        if (!has_table(server, table)) continue;  // of a later schema than `target`
        server.execute(
            QString("DROP TRIGGER IF EXISTS of_erased_person ON %1; CREATE TRIGGER of_erased_person BEFORE "
                    "INSERT OR UPDATE ON %1 FOR EACH ROW EXECUTE FUNCTION of_erased_person('%2')")
                .arg(table, column));
    }
    Query(server, "UPDATE programme_server SET schema = ?").bind(schema.to).run();
    set_server_rights(server);
    transaction.commit();
    return schema;
}

std::string require_server(Connection& server) {
    require_version(server);
    const int found = found_schema(server), known = latest_schema_version();
    if (found == 0)
        throw StoreError(StoreErrorKind::missing,
                         {QT_TRANSLATE_NOOP("errors", "%1: is not a programme server"), server.path()},
                         Sentence(QT_TRANSLATE_NOOP(
                                      "errors", "have its administrator run `fulcrum server create --to %1`"),
                                  server.path()));
    if (found > known) fail_as_newer(server, found);
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
