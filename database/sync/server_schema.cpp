// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/server_schema.h"

#include <QRegularExpression>

#include "database/rows/crypto.h"
#include "database/schema/server_version.h"
#include "database/sync/server_rights.h"
#include "database/sync/station_rights.h"

namespace fulcrum::database {
namespace {

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
                                    {"error_review", "author_id"},
                                    {"correction_request", "person_id"},
                                    {"standing_override", "person_id"},
                                    {"curriculum_move", "person_id"},
                                    {"personal_goal", "person_id"}};

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
    require_postgresql_version(server);
    Transaction transaction(server);
    server.execute("SELECT pg_advisory_xact_lock(" + QString::number(application_id) + ")");
    ServerSchema schema{found_server_schema(server), target};
    if (schema.from > schema.to) fail_as_newer_server(server, schema.from);
    if (schema.from == 0 && has_server_table(server, "person"))
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
    make_enrolment_tables(server);
    for (const auto& [table, column] : owned) {
        if (!has_server_table(server, table)) continue;  // of a later schema than `target`
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

}  // namespace fulcrum::database
