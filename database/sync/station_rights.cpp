// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/station_rights.h"

#include <algorithm>
#include <string>
#include <vector>

#include "database/schema/server_version.h"

namespace fulcrum::database {
namespace {

// `enrolment`: a token, and the station that used it. `station_unit`: people and cohorts that a station of
// some cohorts has, of these or not; `whole`: people whose attempts it has. What a station has stays up to
// date there.
const char* const enrolment_schema = R"(
CREATE TABLE IF NOT EXISTS enrolment (id TEXT COLLATE "C" PRIMARY KEY, name TEXT NOT NULL, made BIGINT NOT NULL,
    made_by TEXT NOT NULL, expires BIGINT NOT NULL, proof TEXT NOT NULL, used BIGINT,
    station_id TEXT COLLATE "C", public_half BYTEA, withdrawn BIGINT);
CREATE TABLE IF NOT EXISTS enrolment_cohort (enrolment_id TEXT COLLATE "C" NOT NULL REFERENCES enrolment (id),
    cohort_id TEXT COLLATE "C" NOT NULL REFERENCES cohort (id), PRIMARY KEY (enrolment_id, cohort_id));
CREATE TABLE IF NOT EXISTS station_unit (station_id TEXT COLLATE "C" NOT NULL,
    unit_id TEXT COLLATE "C" NOT NULL, whole BIGINT NOT NULL, PRIMARY KEY (station_id, unit_id));
CREATE TABLE IF NOT EXISTS server_log (number BIGSERIAL PRIMARY KEY, time BIGINT NOT NULL, account TEXT NOT NULL,
    operation TEXT NOT NULL, object TEXT NOT NULL, detail TEXT NOT NULL);
CREATE OR REPLACE FUNCTION server_log_is_fixed() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN
    RAISE EXCEPTION 'the log of the server is never changed'; END $$;
DROP TRIGGER IF EXISTS server_log_is_fixed ON server_log;
CREATE TRIGGER server_log_is_fixed BEFORE UPDATE OR DELETE ON server_log
    FOR EACH ROW EXECUTE FUNCTION server_log_is_fixed();
)";

// Each answers for the account that connected (session_user); asked in a subquery, once a statement and not
// once a row. An account that was made by hand, before there
// were tokens, has no row of `enrolment` and sees everything.
const char* const functions_of_stations = R"(
DO $$ BEGIN
    IF NOT EXISTS (SELECT 1 FROM pg_roles WHERE rolname = 'fulcrum_enrol') THEN CREATE ROLE fulcrum_enrol; END IF;
END $$;
REVOKE ALL ON enrolment, enrolment_cohort, station_unit, server_log FROM fulcrum_station;
REVOKE ALL ON ALL TABLES IN SCHEMA public FROM fulcrum_enrol;
GRANT USAGE ON SCHEMA public TO fulcrum_enrol;
GRANT SELECT ON programme_server TO fulcrum_enrol;
CREATE OR REPLACE FUNCTION own_enrolment() RETURNS TABLE (id text, station_id text, limited boolean, cohorts text)
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT e.id, e.station_id, EXISTS (SELECT 1 FROM enrolment_cohort c WHERE c.enrolment_id = e.id),
        (SELECT COALESCE(string_agg(c.cohort_id, ' '), '') FROM enrolment_cohort c WHERE c.enrolment_id = e.id)
        FROM enrolment e WHERE 'station_' || e.id = session_user::text AND e.used IS NOT NULL AND e.withdrawn IS NULL $$;
CREATE OR REPLACE FUNCTION enrolled_station() RETURNS text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT o.station_id FROM own_enrolment() o $$;
CREATE OR REPLACE FUNCTION station_sees_all() RETURNS boolean
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT CASE WHEN EXISTS (SELECT 1 FROM enrolment e WHERE 'station_' || e.id = session_user::text)
        THEN EXISTS (SELECT 1 FROM own_enrolment() o WHERE NOT o.limited) ELSE true END $$;
CREATE OR REPLACE FUNCTION station_cohorts() RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT c.cohort_id FROM enrolment_cohort c JOIN own_enrolment() o ON o.id = c.enrolment_id
    UNION SELECT u.unit_id FROM station_unit u WHERE u.station_id = (SELECT enrolled_station()) $$;
-- Whose attempts and reviews the station gets, with the accounts that were merged.
CREATE OR REPLACE FUNCTION station_trainees() RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    WITH chosen AS (
        SELECT m.person_id AS id FROM cohort_member m JOIN enrolment_cohort c ON c.cohort_id = m.cohort_id
            JOIN own_enrolment() o ON o.id = c.enrolment_id
        UNION SELECT u.unit_id FROM station_unit u WHERE u.station_id = (SELECT enrolled_station()) AND u.whole = 1),
    kept AS (SELECT COALESCE(NULLIF(p.merged_into, ''), p.id) AS id FROM person p WHERE p.id IN (SELECT c.id FROM chosen c))
    SELECT k.id FROM kept k UNION SELECT c.id FROM chosen c
    UNION SELECT p.id FROM person p WHERE p.merged_into IN (SELECT k.id FROM kept k) $$;
-- Whom it knows: these, their cohorts' educators, who looks after the programme, and who wrote of them.
CREATE OR REPLACE FUNCTION station_people() RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    WITH seen AS (SELECT station_trainees() AS id), near AS (SELECT station_cohorts() AS id),
    theirs AS (SELECT a.id FROM attempt a WHERE a.person_id IN (SELECT s.id FROM seen s) OR a.station_id = (SELECT enrolled_station()))
    SELECT s.id FROM seen s
    UNION SELECT u.unit_id FROM station_unit u WHERE u.station_id = (SELECT enrolled_station())
    UNION SELECT a.person_id FROM attempt a WHERE a.station_id = (SELECT enrolled_station())
    UNION SELECT m.person_id FROM cohort_member m WHERE m.cohort_id IN (SELECT n.id FROM near n)
    UNION SELECT m.person_id FROM cohort_educator m WHERE m.cohort_id IN (SELECT n.id FROM near n)
    UNION SELECT r.person_id FROM person_role r WHERE r.role IN ('administrator', 'director')
    UNION SELECT f.person_id FROM asset_acceptance f
    UNION SELECT c.author_id FROM comment c WHERE c.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT v.person_id FROM attempt_void v WHERE v.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT q.person_id FROM correction_request q WHERE q.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT r.rater_id FROM rating r WHERE r.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT l.person_id FROM rating_release l JOIN rating r ON r.id = l.rating_id
        WHERE r.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT r.person_id FROM rating_seen r WHERE r.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT d.author_id FROM standing_override d WHERE d.person_id IN (SELECT s.id FROM seen s)
    UNION SELECT m.author_id FROM curriculum_move m WHERE m.person_id IN (SELECT s.id FROM seen s) $$;
CREATE OR REPLACE FUNCTION station_holds(held text[], held_whole text[]) RETURNS bigint
    LANGUAGE sql SECURITY DEFINER SET search_path = public, pg_temp AS $$
    WITH written AS (INSERT INTO station_unit AS u (station_id, unit_id, whole)
        SELECT o.station_id, k, CASE WHEN k = ANY (held_whole) THEN 1 ELSE 0 END
        FROM own_enrolment() o, (SELECT DISTINCT unnest(held) AS k) h
        ON CONFLICT (station_id, unit_id) DO UPDATE SET whole = excluded.whole WHERE u.whole < excluded.whole
        RETURNING 1)
    SELECT COUNT(*) FROM written $$;
-- Which of these logins and names of cohorts there are, whoever has them.
CREATE OR REPLACE FUNCTION names_taken(logins text[], cohort_names text[]) RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT p.login_key FROM person p WHERE p.login_key = ANY (logins)
    UNION ALL SELECT c.name FROM cohort c WHERE c.name = ANY (cohort_names) $$;
-- What stations have signed of a trace that the station may read.
CREATE OR REPLACE FUNCTION trace_evidence(wanted text) RETURNS TABLE (station_id text, sequence bigint, "time" bigint,
    actor_id text, object_id text, operation text, digest bytea, previous_hash bytea, hash bytea, salt bytea,
    payload text, public_half bytea, signature bytea)
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT e.station_id, e.sequence, e.time, e.actor_id, e.object_id, e.operation, e.digest, e.previous_hash, e.hash,
        p.salt, p.payload, s.public_half, s.signature
    FROM audit_entry e JOIN audit_payload p ON p.station_id = e.station_id AND p.sequence = e.sequence
        LEFT JOIN audit_signature s ON s.station_id = e.station_id AND s.sequence = e.sequence
    WHERE (e.object_id = wanted OR e.object_id IN (SELECT r.from_id FROM attempt_reassignment r WHERE r.to_id = wanted))
        AND e.operation <> 'sync.receive' AND position('"trace ' || wanted || '"' IN p.payload) > 0
        AND ((SELECT station_sees_all()) OR EXISTS (SELECT 1 FROM attempt a WHERE a.id = wanted AND
            (a.station_id = (SELECT enrolled_station()) OR a.person_id IN (SELECT station_trainees()))))
    ORDER BY e.time DESC, e.sequence DESC $$;
-- Asked by the account of a token. Answers instead of failing, so that a refusal is in the log too.
CREATE OR REPLACE FUNCTION enrol_station(asked_proof text, asked_station text, asked_key bytea, verifier text)
    RETURNS TABLE (answer text, about text, since bigint)
    LANGUAGE plpgsql SECURITY DEFINER SET search_path = public, pg_temp AS $$
#variable_conflict use_column
DECLARE
    e enrolment;
    old record;
    moment bigint := (extract(epoch FROM clock_timestamp()) * 1000)::bigint;
BEGIN
    -- Two tokens of one station at once: one after the other.
    PERFORM pg_advisory_xact_lock(hashtext(asked_station));
    SELECT x.* INTO e FROM enrolment x WHERE 'enrol_' || x.id = session_user::text FOR UPDATE;
    answer := CASE WHEN e.id IS NULL OR e.proof <> asked_proof THEN 'unknown'
        WHEN e.withdrawn IS NOT NULL AND e.used IS NULL THEN 'withdrawn'
        WHEN e.used IS NOT NULL THEN 'used' WHEN e.expires < moment THEN 'expired'
        WHEN EXISTS (SELECT 1 FROM enrolment x WHERE x.station_id = asked_station AND x.withdrawn IS NULL
            AND x.public_half <> asked_key AND NOT EXISTS (SELECT 1 FROM station_key k
                WHERE k.station_id = asked_station AND k.public_half = asked_key)) THEN 'other_key'
        ELSE 'enrolled' END;
    about := COALESCE(e.station_id, '');
    since := COALESCE(e.used, e.withdrawn, e.expires);
    IF answer = 'enrolled' THEN
        FOR old IN SELECT x.id FROM enrolment x WHERE x.station_id = asked_station AND x.withdrawn IS NULL LOOP
            EXECUTE format('ALTER ROLE %I NOLOGIN', 'station_' || old.id);
            EXECUTE format('REVOKE fulcrum_station FROM %I', 'station_' || old.id);
            UPDATE enrolment x SET withdrawn = moment WHERE x.id = old.id;
            INSERT INTO server_log (time, account, operation, object, detail)
                VALUES (moment, session_user::text, 'enrolment.replace', old.id, asked_station);
        END LOOP;
        EXECUTE format('CREATE ROLE %I LOGIN PASSWORD %L IN ROLE fulcrum_station', 'station_' || e.id, verifier);
        UPDATE enrolment x SET used = moment, station_id = asked_station, public_half = asked_key WHERE x.id = e.id;
        about := COALESCE((SELECT string_agg(m.cohort_id, ' ') FROM enrolment_cohort m WHERE m.enrolment_id = e.id), '');
        since := moment;
    END IF;
    INSERT INTO server_log (time, account, operation, object, detail) VALUES (moment, session_user::text,
        CASE answer WHEN 'enrolled' THEN 'enrolment.use' ELSE 'enrolment.refuse' END, asked_station, answer);
    RETURN NEXT;
END $$;
)";

struct FunctionRight {
    const char *name, *group;
};
constexpr FunctionRight function_rights[] = {{"own_enrolment()", "fulcrum_station"},
                                             {"enrolled_station()", "fulcrum_station"},
                                             {"station_sees_all()", "fulcrum_station"},
                                             {"station_cohorts()", "fulcrum_station"},
                                             {"station_trainees()", "fulcrum_station"},
                                             {"station_people()", "fulcrum_station"},
                                             {"station_holds(text[], text[])", "fulcrum_station"},
                                             {"names_taken(text[], text[])", "fulcrum_station"},
                                             {"trace_evidence(text)", "fulcrum_station"},
                                             {"enrol_station(text, text, bytea, text)", "fulcrum_enrol"}};

#define FULCRUM_SEES_ALL "(SELECT station_sees_all()) OR "
#define FULCRUM_OF_TRAINEES FULCRUM_SEES_ALL "person_id IN (SELECT station_trainees())"
#define FULCRUM_OF_PEOPLE FULCRUM_SEES_ALL "person_id IN (SELECT station_people())"
#define FULCRUM_OF_COHORTS FULCRUM_SEES_ALL "cohort_id IN (SELECT station_cohorts())"
#define FULCRUM_OF_ATTEMPT FULCRUM_SEES_ALL "EXISTS (SELECT 1 FROM attempt x WHERE x.id = attempt_id)"
#define FULCRUM_OF_SCORE FULCRUM_SEES_ALL "EXISTS (SELECT 1 FROM score x WHERE x.id = score_id)"
#define FULCRUM_OF_RATING FULCRUM_SEES_ALL "EXISTS (SELECT 1 FROM rating x WHERE x.id = rating_id)"
#define FULCRUM_OF_STATION FULCRUM_SEES_ALL "station_id = (SELECT enrolled_station())"
constexpr const char* every_row = "true";
/// A station that was enrolled writes its own log and nobody else's.
constexpr const char* own_log = "COALESCE(station_id = (SELECT enrolled_station()), true)";

struct StationPolicy {
    const char *table, *sees, *writes = every_row;
};

/// The other tables: every row.
constexpr StationPolicy station_policies[] = {
    {"person", FULCRUM_SEES_ALL "id IN (SELECT station_people())"},
    {"person_role", FULCRUM_OF_PEOPLE},
    {"credential", FULCRUM_OF_PEOPLE},
    {"sign_in", FULCRUM_OF_PEOPLE},
    {"cohort", FULCRUM_SEES_ALL "id IN (SELECT station_cohorts())"},
    {"cohort_member", FULCRUM_OF_COHORTS},
    {"cohort_educator", FULCRUM_OF_COHORTS},
    {"attempt", FULCRUM_OF_STATION " OR person_id IN (SELECT station_trainees())"},
    {"attempt_asset", FULCRUM_OF_ATTEMPT},
    {"attempt_origin", FULCRUM_OF_ATTEMPT},
    {"attempt_void", FULCRUM_OF_ATTEMPT},
    {"attempt_reassignment", FULCRUM_SEES_ALL
     "EXISTS (SELECT 1 FROM attempt x WHERE x.id = from_id) OR EXISTS (SELECT 1 FROM attempt x WHERE x.id = "
     "to_id)"},
    {"trace_chunk", FULCRUM_OF_ATTEMPT},
    {"attempt_product", FULCRUM_OF_ATTEMPT},
    {"score", FULCRUM_OF_ATTEMPT},
    {"gate", FULCRUM_OF_SCORE},
    {"metric", FULCRUM_OF_SCORE},
    {"critical_error", FULCRUM_OF_SCORE},
    {"pathology", FULCRUM_OF_SCORE},
    {"comment", FULCRUM_OF_ATTEMPT},
    {"correction_request", FULCRUM_OF_ATTEMPT},
    {"standing_override", FULCRUM_OF_TRAINEES},
    {"curriculum_move", FULCRUM_OF_TRAINEES},
    {"personal_goal", FULCRUM_OF_TRAINEES},
    {"personal_goal_end", FULCRUM_SEES_ALL "EXISTS (SELECT 1 FROM personal_goal x WHERE x.id = goal_id)"},
    {"rating", FULCRUM_OF_ATTEMPT},
    {"rating_item", FULCRUM_OF_RATING},
    {"rating_release", FULCRUM_OF_RATING},
    {"rating_seen", FULCRUM_OF_ATTEMPT},
    {"xapi_outbox", FULCRUM_OF_PEOPLE},
    {"audit_entry", FULCRUM_OF_STATION, own_log},
    {"audit_payload", FULCRUM_OF_STATION, own_log},
    {"audit_signature", FULCRUM_OF_STATION, own_log},
    {"station_key", FULCRUM_OF_STATION, own_log}};

}  // namespace

void make_enrolment_tables(Connection& server) {
    server.execute(enrolment_schema);
}

void set_station_rights(Connection& server) {
    server.execute(functions_of_stations);
    for (const FunctionRight& one : function_rights)
        server.execute(QString("REVOKE ALL ON FUNCTION %1 FROM PUBLIC; GRANT EXECUTE ON FUNCTION %1 TO %2")
                           .arg(one.name, one.group));
    std::vector<std::string> names;
    {
        Query rows(server, "SELECT tablename FROM pg_tables WHERE schemaname = 'public' ORDER BY tablename");
        while (rows.next()) names.push_back(rows.text(0));
    }
    for (const std::string& name : names) {
        const auto is_own = [&](const char* own) { return name == own; };
        if (std::any_of(std::begin(enrolment_tables), std::end(enrolment_tables), is_own)) {
            server.execute(QString("DROP POLICY IF EXISTS station ON %1").arg(QString::fromStdString(name)));
            continue;
        }
        const auto found = std::find_if(std::begin(station_policies), std::end(station_policies),
                                        [&](const StationPolicy& one) { return name == one.table; });
        const bool is_named = found != std::end(station_policies);
        server.execute(QString("DROP POLICY IF EXISTS station ON %1; CREATE POLICY station ON %1 TO "
                               "fulcrum_station USING (%2) WITH CHECK (%3)")
                           .arg(QString::fromStdString(name), is_named ? found->sees : every_row,
                                is_named ? found->writes : every_row));
    }
    server.execute(
        "DROP POLICY IF EXISTS enrolling ON programme_server; CREATE POLICY enrolling ON programme_server "
        "FOR "
        "SELECT TO fulcrum_enrol USING (true)");
}

}  // namespace fulcrum::database
