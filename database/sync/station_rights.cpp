// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/station_rights.h"

#include <algorithm>
#include <string>
#include <vector>

#include "database/schema/server_version.h"
#include "database/sync/enrolment_proof.h"
#include "database/sync/sync_tables.h"

namespace fulcrum::database {
namespace {

// `enrolment`: a token, and the station that used it, with the statement by which it proved that it holds its
// key (enrolment_proof.h; none of stations from before the server asked). `station_unit`: people and cohorts
// that a station of some cohorts has, of these or not; `whole`: people whose attempts it has. What a station
// has stays up to date there.
const char* const enrolment_schema = R"(
CREATE TABLE IF NOT EXISTS enrolment (id TEXT COLLATE "C" PRIMARY KEY, name TEXT NOT NULL, made BIGINT NOT NULL,
    made_by TEXT NOT NULL, expires BIGINT NOT NULL, proof TEXT NOT NULL, used BIGINT,
    station_id TEXT COLLATE "C", public_half BYTEA, withdrawn BIGINT);
ALTER TABLE enrolment ADD COLUMN IF NOT EXISTS statement TEXT;
ALTER TABLE enrolment ADD COLUMN IF NOT EXISTS signature BYTEA;
CREATE TABLE IF NOT EXISTS enrolment_cohort (enrolment_id TEXT COLLATE "C" NOT NULL REFERENCES enrolment (id),
    cohort_id TEXT COLLATE "C" NOT NULL REFERENCES cohort (id), PRIMARY KEY (enrolment_id, cohort_id));
CREATE TABLE IF NOT EXISTS station_unit (station_id TEXT COLLATE "C" NOT NULL,
    unit_id TEXT COLLATE "C" NOT NULL, whole BIGINT NOT NULL, PRIMARY KEY (station_id, unit_id));
CREATE TABLE IF NOT EXISTS server_log (number BIGSERIAL PRIMARY KEY, time BIGINT NOT NULL, account TEXT NOT NULL,
    operation TEXT NOT NULL, object TEXT NOT NULL, detail TEXT NOT NULL);
CREATE OR REPLACE FUNCTION server_log_is_fixed() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN
    RAISE EXCEPTION 'the log of the server is never changed'; END $$;
DO $$ BEGIN
    IF NOT EXISTS (SELECT 1 FROM pg_tables WHERE schemaname = 'public' AND tablename = 'station_shown') THEN
        CREATE TABLE station_shown (station_id TEXT COLLATE "C" NOT NULL, unit_id TEXT COLLATE "C" NOT NULL,
            PRIMARY KEY (station_id, unit_id));
        INSERT INTO station_shown SELECT station_id, unit_id FROM station_unit UNION SELECT a.station_id, a.person_id
            FROM attempt a JOIN enrolment e ON e.station_id = a.station_id;
    END IF;
END $$;
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
REVOKE ALL ON enrolment, enrolment_cohort, station_unit, station_shown, server_log FROM fulcrum_station;
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
    UNION SELECT e.author_id FROM error_review e WHERE e.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT v.person_id FROM attempt_void v WHERE v.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT q.person_id FROM correction_request q WHERE q.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT r.rater_id FROM rating r WHERE r.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT l.person_id FROM rating_release l JOIN rating r ON r.id = l.rating_id
        WHERE r.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT r.person_id FROM rating_seen r WHERE r.attempt_id IN (SELECT t.id FROM theirs t)
    UNION SELECT d.author_id FROM standing_override d WHERE d.person_id IN (SELECT s.id FROM seen s)
    UNION SELECT m.author_id FROM curriculum_move m WHERE m.person_id IN (SELECT s.id FROM seen s) $$;
-- Which of these logins and names of cohorts there are, whoever has them.
CREATE OR REPLACE FUNCTION names_taken(logins text[], cohort_names text[]) RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT p.login_key FROM person p WHERE p.login_key = ANY (logins)
    UNION ALL SELECT c.name FROM cohort c WHERE c.name = ANY (cohort_names) $$;
-- What stations have signed of a trace that the station may read. The erasure of the person that a copy was taken from
-- takes the row of the reassignment; the station has signed the trace again in the row of the erasure.
CREATE OR REPLACE FUNCTION trace_evidence(wanted text) RETURNS TABLE (station_id text, sequence bigint, "time" bigint,
    actor_id text, object_id text, operation text, digest bytea, previous_hash bytea, hash bytea, salt bytea,
    payload text, public_half bytea, signature bytea)
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT e.station_id, e.sequence, e.time, e.actor_id, e.object_id, e.operation, e.digest, e.previous_hash, e.hash,
        p.salt, p.payload, s.public_half, s.signature
    FROM audit_entry e JOIN audit_payload p ON p.station_id = e.station_id AND p.sequence = e.sequence
        LEFT JOIN audit_signature s ON s.station_id = e.station_id AND s.sequence = e.sequence
    WHERE (e.object_id = wanted OR e.operation = 'payload.erase' OR
        e.object_id IN (SELECT r.from_id FROM attempt_reassignment r WHERE r.to_id = wanted))
        AND e.operation <> 'sync.receive' AND position('"trace ' || wanted || '"' IN p.payload) > 0
        AND ((SELECT station_sees_all()) OR EXISTS (SELECT 1 FROM attempt a WHERE a.id = wanted AND
            (a.station_id = (SELECT enrolled_station()) OR a.person_id IN (SELECT station_trainees()))))
    ORDER BY e.time DESC, e.sequence DESC $$;
-- Asked by the account of a token. Answers instead of failing, so that a refusal is in the log too.
DROP FUNCTION IF EXISTS enrol_station(text, text, bytea, text);
CREATE OR REPLACE FUNCTION enrol_station(asked_proof text, asked_station text, asked_key bytea, verifier text,
    asked_signature bytea) RETURNS TABLE (answer text, about text, since bigint)
    LANGUAGE plpgsql SECURITY DEFINER SET search_path = public, pg_temp AS $$
#variable_conflict use_column
DECLARE
    e enrolment;
    old record;
    moment bigint := (extract(epoch FROM clock_timestamp()) * 1000)::bigint;
    said text;
BEGIN
    -- Two tokens of one station at once: one after the other.
    PERFORM pg_advisory_xact_lock(hashtext(asked_station));
    SELECT x.* INTO e FROM enrolment x WHERE 'enrol_' || x.id = session_user::text FOR UPDATE;
    said := 'fulcrum enrolment 1' || E'\nserver ' || (SELECT s.id FROM programme_server s) || E'\ntoken ' || e.id
        || E'\nstation ' || asked_station || E'\nkey ' || encode(asked_key, 'hex') || E'\npassword '
        || encode(sha256(convert_to(verifier, 'UTF8')), 'hex');
    answer := CASE WHEN e.id IS NULL OR e.proof <> asked_proof THEN 'unknown'
        WHEN e.withdrawn IS NOT NULL AND e.used IS NULL THEN 'withdrawn'
        WHEN e.used IS NOT NULL THEN 'used' WHEN e.expires < moment THEN 'expired'
        WHEN EXISTS (SELECT 1 FROM enrolment x WHERE x.station_id = asked_station AND x.withdrawn IS NULL
            AND x.public_half <> asked_key AND NOT EXISTS (SELECT 1 FROM station_key k
                WHERE k.station_id = asked_station AND k.public_half = asked_key)) THEN 'other_key'
        WHEN NOT COALESCE(ed25519_holds(asked_key, convert_to(said, 'UTF8'), asked_signature), false) THEN 'no_proof'
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
        -- A station that got everything until now keeps what it has.
        IF EXISTS (SELECT 1 FROM enrolment_cohort m WHERE m.enrolment_id = e.id) AND
            EXISTS (SELECT 1 FROM station_key k WHERE k.station_id = asked_station AND k.public_half = asked_key) AND
            NOT EXISTS (SELECT 1 FROM enrolment_cohort m WHERE m.enrolment_id = (SELECT x.id FROM enrolment x
                WHERE x.station_id = asked_station AND x.used IS NOT NULL ORDER BY x.used DESC LIMIT 1)) THEN
            INSERT INTO station_shown SELECT asked_station, p.id FROM person p
                UNION SELECT asked_station, c.id FROM cohort c ON CONFLICT DO NOTHING;
        END IF;
        EXECUTE format('CREATE ROLE %I LOGIN PASSWORD %L IN ROLE fulcrum_station', 'station_' || e.id, verifier);
        UPDATE enrolment x SET used = moment, station_id = asked_station, public_half = asked_key,
            statement = said, signature = asked_signature WHERE x.id = e.id;
        about := COALESCE((SELECT string_agg(m.cohort_id, ' ') FROM enrolment_cohort m WHERE m.enrolment_id = e.id), '');
        since := moment;
    END IF;
    INSERT INTO server_log (time, account, operation, object, detail) VALUES (moment, session_user::text,
        CASE answer WHEN 'enrolled' THEN 'enrolment.use' ELSE 'enrolment.refuse' END, asked_station, answer);
    RETURN NEXT;
END $$;
)";

// What a station of some cohorts may say of whom: it may name people and cohorts that the server has shown it
// or that it made. Else whoever runs a station and knows a person's id could write attempts for that person,
// and read theirs.
const char* const functions_of_claims = R"(
CREATE OR REPLACE FUNCTION station_given() RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT s.unit_id FROM station_shown s WHERE s.station_id = (SELECT enrolled_station()) $$;
-- Also those that the station does not see.
CREATE OR REPLACE FUNCTION attempt_is_there(wanted text) RETURNS boolean
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT EXISTS (SELECT 1 FROM attempt a WHERE a.id = wanted) $$;
CREATE OR REPLACE FUNCTION score_is_there(wanted text) RETURNS boolean
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT EXISTS (SELECT 1 FROM score s WHERE s.id = wanted) $$;
CREATE OR REPLACE FUNCTION rating_is_there(wanted text) RETURNS boolean
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT EXISTS (SELECT 1 FROM rating r WHERE r.id = wanted) $$;
-- Those that are on the server, and that it has never shown this station.
CREATE OR REPLACE FUNCTION refused_claims(held text[]) RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT h.k FROM (SELECT DISTINCT unnest(held) AS k) h
    WHERE NOT (SELECT station_sees_all()) AND h.k NOT IN (SELECT station_given()) AND
        (EXISTS (SELECT 1 FROM person p WHERE p.id = h.k) OR EXISTS (SELECT 1 FROM cohort c WHERE c.id = h.k)) $$;
CREATE OR REPLACE FUNCTION log_claim(about text) RETURNS void
    LANGUAGE sql SECURITY DEFINER SET search_path = public, pg_temp AS $$
    INSERT INTO server_log (time, account, operation, object, detail)
        SELECT (extract(epoch FROM clock_timestamp()) * 1000)::bigint, session_user::text, 'claim.refuse', about,
            COALESCE((SELECT enrolled_station()), '')
        WHERE NOT EXISTS (SELECT 1 FROM server_log l WHERE l.account = session_user::text AND
            l.operation = 'claim.refuse' AND l.object = about) $$;
-- At the begin and end of an exchange: what the server shows now is what it gives, and what the station has of
-- that stays up to date there. What it says of others is refused, and in the log.
CREATE OR REPLACE FUNCTION station_holds(held text[], held_whole text[]) RETURNS bigint
    LANGUAGE plpgsql SECURITY DEFINER SET search_path = public, pg_temp AS $$
DECLARE
    own text := enrolled_station();
    written bigint;
BEGIN
    IF own IS NULL OR station_sees_all() THEN RETURN 0; END IF;
    INSERT INTO station_shown SELECT own, p.id FROM person p WHERE p.id IN (SELECT station_people())
        UNION SELECT own, c.id FROM cohort c WHERE c.id IN (SELECT station_cohorts()) ON CONFLICT DO NOTHING;
    PERFORM log_claim(r.k) FROM refused_claims(held) AS r(k);
    INSERT INTO station_unit AS u (station_id, unit_id, whole)
        SELECT own, h.k, CASE WHEN h.k = ANY (held_whole) THEN 1 ELSE 0 END
        FROM (SELECT DISTINCT unnest(held) AS k) h WHERE h.k NOT IN (SELECT refused_claims(held))
        ON CONFLICT (station_id, unit_id) DO UPDATE SET whole = excluded.whole WHERE u.whole < excluded.whole;
    GET DIAGNOSTICS written = ROW_COUNT;
    RETURN written;
END $$;
-- Whoever brings a person or cohort first may name it; what others said of it before is void.
CREATE OR REPLACE FUNCTION unit_is_made() RETURNS trigger
    LANGUAGE plpgsql SECURITY DEFINER SET search_path = public, pg_temp AS $$
DECLARE
    own text := COALESCE(enrolled_station(), '');
BEGIN
    DELETE FROM station_unit u WHERE u.unit_id = NEW.id AND u.station_id <> own;
    DELETE FROM station_shown s WHERE s.unit_id = NEW.id AND s.station_id <> own;
    IF own <> '' THEN INSERT INTO station_shown VALUES (own, NEW.id) ON CONFLICT DO NOTHING; END IF;
    RETURN NULL;
END $$;
-- Left out instead of refused, so that the log keeps it: a refusal would take back the row of the log too.
CREATE OR REPLACE FUNCTION attempt_of_stranger() RETURNS trigger
    LANGUAGE plpgsql SECURITY DEFINER SET search_path = public, pg_temp AS $$ BEGIN
    IF station_sees_all() OR EXISTS (SELECT 1 FROM station_shown s
        WHERE s.station_id = enrolled_station() AND s.unit_id = NEW.person_id) THEN RETURN NEW; END IF;
    PERFORM log_claim(NEW.person_id);
    RETURN NULL;
END $$;
-- Rows of a person who was merged into another are read as the other's.
CREATE OR REPLACE FUNCTION merge_with_stranger() RETURNS trigger
    LANGUAGE plpgsql SECURITY DEFINER SET search_path = public, pg_temp AS $$
DECLARE
    target text := COALESCE(to_jsonb(NEW) ->> 'merged_into', '');
BEGIN
    IF target <> '' AND NOT station_sees_all() AND NOT EXISTS (SELECT 1 FROM station_shown s
        WHERE s.station_id = enrolled_station() AND s.unit_id = target) AND
        NOT EXISTS (SELECT 1 FROM person p WHERE p.id = NEW.id AND p.merged_into = target)
    THEN RAISE EXCEPTION 'the server has not shown that person to this station'; END IF;
    RETURN NEW;
END $$;
DROP TRIGGER IF EXISTS merge_with_stranger ON person;
CREATE TRIGGER merge_with_stranger BEFORE INSERT OR UPDATE ON person
    FOR EACH ROW EXECUTE FUNCTION merge_with_stranger();
DROP TRIGGER IF EXISTS unit_is_made ON person;
CREATE TRIGGER unit_is_made AFTER INSERT ON person FOR EACH ROW EXECUTE FUNCTION unit_is_made();
DROP TRIGGER IF EXISTS unit_is_made ON cohort;
CREATE TRIGGER unit_is_made AFTER INSERT ON cohort FOR EACH ROW EXECUTE FUNCTION unit_is_made();
DROP TRIGGER IF EXISTS attempt_of_stranger ON attempt;
CREATE TRIGGER attempt_of_stranger BEFORE INSERT ON attempt FOR EACH ROW EXECUTE FUNCTION attempt_of_stranger();
)";

struct FunctionRight {
    const char *name, *group;  ///< null: called by other functions and triggers only
};
constexpr FunctionRight function_rights[] = {
    {"own_enrolment()", "fulcrum_station"},
    {"enrolled_station()", "fulcrum_station"},
    {"station_sees_all()", "fulcrum_station"},
    {"station_cohorts()", "fulcrum_station"},
    {"station_trainees()", "fulcrum_station"},
    {"station_people()", "fulcrum_station"},
    {"station_holds(text[], text[])", "fulcrum_station"},
    {"names_taken(text[], text[])", "fulcrum_station"},
    {"trace_evidence(text)", "fulcrum_station"},
    {"station_given()", "fulcrum_station"},
    {"attempt_is_there(text)", "fulcrum_station"},
    {"score_is_there(text)", "fulcrum_station"},
    {"rating_is_there(text)", "fulcrum_station"},
    {"refused_claims(text[])", "fulcrum_station"},
    {"log_claim(text)", nullptr},
    {"unit_is_made()", nullptr},
    {"attempt_of_stranger()", nullptr},
    {"merge_with_stranger()", nullptr},
    {"ed25519_holds(bytea, bytea, bytea)", nullptr},
    {"enrol_station(text, text, bytea, text, bytea)", "fulcrum_enrol"}};

#define FULCRUM_SEES_ALL "(SELECT station_sees_all()) OR "
#define FULCRUM_OF_TRAINEES FULCRUM_SEES_ALL "person_id IN (SELECT station_trainees())"
#define FULCRUM_OF_PEOPLE FULCRUM_SEES_ALL "person_id IN (SELECT station_people())"
#define FULCRUM_OF_COHORTS FULCRUM_SEES_ALL "cohort_id IN (SELECT station_cohorts())"
#define FULCRUM_OF_ATTEMPT FULCRUM_SEES_ALL "EXISTS (SELECT 1 FROM attempt x WHERE x.id = attempt_id)"
#define FULCRUM_OF_SCORE FULCRUM_SEES_ALL "EXISTS (SELECT 1 FROM score x WHERE x.id = score_id)"
#define FULCRUM_OF_RATING FULCRUM_SEES_ALL "EXISTS (SELECT 1 FROM rating x WHERE x.id = rating_id)"
#define FULCRUM_OF_GOAL FULCRUM_SEES_ALL "EXISTS (SELECT 1 FROM personal_goal x WHERE x.id = goal_id)"
#define FULCRUM_OF_STATION FULCRUM_SEES_ALL "station_id = (SELECT enrolled_station())"
/// What belongs to an attempt, a score or a rating comes before it, and nothing is added later.
#define FULCRUM_BEFORE_ATTEMPT FULCRUM_SEES_ALL "NOT attempt_is_there(attempt_id)"
#define FULCRUM_BEFORE_SCORE FULCRUM_SEES_ALL "NOT score_is_there(score_id)"
#define FULCRUM_GIVEN(column) column " IN (SELECT station_given())"
#define FULCRUM_BY(column) FULCRUM_SEES_ALL FULCRUM_GIVEN(column)
#define FULCRUM_OF_ATTEMPT_BY(column) \
    FULCRUM_SEES_ALL                  \
    "(EXISTS (SELECT 1 FROM attempt x WHERE x.id = attempt_id) AND " FULCRUM_GIVEN(column) ")"
#define FULCRUM_OF_COHORT_WITH \
    FULCRUM_SEES_ALL "(cohort_id IN (SELECT station_cohorts()) AND " FULCRUM_GIVEN("person_id") ")"
#define FULCRUM_DECIDED FULCRUM_SEES_ALL "(" FULCRUM_GIVEN("person_id") " AND " FULCRUM_GIVEN("author_id") ")"
constexpr const char* every_row = "true";
/// A station that was enrolled writes its own log and nobody else's.
constexpr const char* own_log = "COALESCE(station_id = (SELECT enrolled_station()), true)";

struct StationPolicy {
    const char *table, *sees, *writes = every_row;
};

/// The other tables: every row.
constexpr StationPolicy station_policies[] = {
    {"person", FULCRUM_SEES_ALL "id IN (SELECT station_people())"},
    {"person_role", FULCRUM_OF_PEOPLE, FULCRUM_BY("person_id")},
    {"credential", FULCRUM_OF_PEOPLE, FULCRUM_BY("person_id")},
    {"sign_in", FULCRUM_OF_PEOPLE},
    {"cohort", FULCRUM_SEES_ALL "id IN (SELECT station_cohorts())"},
    {"cohort_member", FULCRUM_OF_COHORTS, FULCRUM_OF_COHORT_WITH},
    {"cohort_educator", FULCRUM_OF_COHORTS, FULCRUM_OF_COHORT_WITH},
    {"asset_acceptance", every_row, FULCRUM_BY("person_id")},
    // What every station puts into its folder comes from stations that have the whole programme.
    {"asset_text", every_row, FULCRUM_SEES_ALL "false"},
    {"attempt", FULCRUM_OF_STATION " OR person_id IN (SELECT station_trainees())", FULCRUM_BY("person_id")},
    {"attempt_asset", FULCRUM_OF_ATTEMPT, FULCRUM_BEFORE_ATTEMPT},
    {"attempt_origin", FULCRUM_OF_ATTEMPT, FULCRUM_BEFORE_ATTEMPT},
    {"attempt_void", FULCRUM_OF_ATTEMPT, FULCRUM_OF_ATTEMPT_BY("person_id")},
    {"attempt_reassignment",
     FULCRUM_SEES_ALL
     "EXISTS (SELECT 1 FROM attempt x WHERE x.id = from_id) OR EXISTS (SELECT 1 FROM attempt x "
     "WHERE x.id = to_id)",
     FULCRUM_SEES_ALL
     "(EXISTS (SELECT 1 FROM attempt x WHERE x.id = from_id) AND EXISTS (SELECT 1 FROM attempt "
     "x WHERE x.id = to_id))"},
    {"trace_chunk", FULCRUM_OF_ATTEMPT},  // refused by a trigger where the attempt is there
    {"attempt_product", FULCRUM_OF_ATTEMPT, FULCRUM_BEFORE_ATTEMPT},
    {"score", FULCRUM_OF_ATTEMPT, FULCRUM_OF_ATTEMPT},
    {"gate", FULCRUM_OF_SCORE, FULCRUM_BEFORE_SCORE},
    {"metric", FULCRUM_OF_SCORE, FULCRUM_BEFORE_SCORE},
    {"critical_error", FULCRUM_OF_SCORE, FULCRUM_BEFORE_SCORE},
    {"pathology", FULCRUM_OF_SCORE, FULCRUM_BEFORE_SCORE},
    {"comment", FULCRUM_OF_ATTEMPT, FULCRUM_OF_ATTEMPT_BY("author_id")},
    {"error_review", FULCRUM_OF_ATTEMPT, FULCRUM_OF_ATTEMPT_BY("author_id")},
    {"correction_request", FULCRUM_OF_ATTEMPT, FULCRUM_OF_ATTEMPT_BY("person_id")},
    {"standing_override", FULCRUM_OF_TRAINEES, FULCRUM_DECIDED},
    {"curriculum_move", FULCRUM_OF_TRAINEES, FULCRUM_DECIDED},
    {"personal_goal", FULCRUM_OF_TRAINEES, FULCRUM_BY("person_id")},
    {"personal_goal_end", FULCRUM_OF_GOAL, FULCRUM_OF_GOAL},
    {"rating", FULCRUM_OF_ATTEMPT, FULCRUM_OF_ATTEMPT_BY("rater_id")},
    {"rating_item", FULCRUM_OF_RATING, FULCRUM_SEES_ALL "NOT rating_is_there(rating_id)"},
    {"rating_release", FULCRUM_OF_RATING,
     FULCRUM_SEES_ALL
     "(EXISTS (SELECT 1 FROM rating x WHERE x.id = rating_id) AND " FULCRUM_GIVEN("person_id") ")"},
    {"rating_seen", FULCRUM_OF_ATTEMPT, FULCRUM_OF_ATTEMPT_BY("person_id")},
    {"xapi_outbox", FULCRUM_OF_PEOPLE},
    {"audit_entry", FULCRUM_OF_STATION, own_log},
    {"audit_payload", FULCRUM_OF_STATION, own_log},
    {"audit_signature", FULCRUM_OF_STATION, own_log},
    {"station_key", FULCRUM_OF_STATION, own_log}};

/// Stations write these; the other tables are a station's own affair and have no rows on a server.
bool is_exchanged(const std::string& name) {
    for (const char* log : {"audit_entry", "audit_payload", "audit_signature", "station_key"})
        if (name == log) return true;
    for (const SyncTable& table : sync_tables()) {
        if (name == table.table) return true;
        for (const ChildTable& child : table.children)
            if (name == child.table) return true;
    }
    return false;
}

}  // namespace

void make_enrolment_tables(Connection& server) {
    server.execute(enrolment_schema);
}

void set_station_rights(Connection& server) {
    server.execute(signature_function());
    server.execute(functions_of_stations);
    server.execute(functions_of_claims);
    for (const FunctionRight& one : function_rights) {
        server.execute(QString("REVOKE ALL ON FUNCTION %1 FROM PUBLIC, fulcrum_station").arg(one.name));
        if (one.group != nullptr)
            server.execute(QString("GRANT EXECUTE ON FUNCTION %1 TO %2").arg(one.name, one.group));
    }
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
        if (!is_exchanged(name))
            server.execute(
                QString("REVOKE INSERT ON %1 FROM fulcrum_station").arg(QString::fromStdString(name)));
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
