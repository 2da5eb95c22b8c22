// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/server_rights.h"

#include <algorithm>
#include <vector>

#include "database/store/server_roles.h"
#include "database/sync/station_rights.h"

namespace fulcrum::database {
namespace {

/// Stations add rows; they change and delete those only that a newer version of a person or cohort replaces.
/// People read. PUBLIC has nothing.
const char* const rights = R"(
DO $$
DECLARE name text;
BEGIN
    FOREACH name IN ARRAY ARRAY['fulcrum_station', 'fulcrum_trainee', 'fulcrum_educator', 'fulcrum_director'] LOOP
        IF NOT EXISTS (SELECT 1 FROM pg_roles WHERE rolname = name) THEN EXECUTE format('CREATE ROLE %I', name); END IF;
    END LOOP;
END $$;
REVOKE ALL ON ALL TABLES IN SCHEMA public FROM PUBLIC, fulcrum_station, fulcrum_trainee, fulcrum_educator, fulcrum_director;
REVOKE CREATE ON SCHEMA public FROM PUBLIC;
GRANT USAGE ON SCHEMA public TO fulcrum_station, fulcrum_trainee, fulcrum_educator, fulcrum_director;
GRANT SELECT, INSERT ON ALL TABLES IN SCHEMA public TO fulcrum_station;
REVOKE INSERT ON programme_server, erasure, erased_payload FROM fulcrum_station;
GRANT UPDATE ON person, cohort, programme TO fulcrum_station;
GRANT DELETE ON person_role, credential, cohort_member, cohort_educator TO fulcrum_station;
GRANT INSERT ON rating_seen TO fulcrum_educator, fulcrum_director;
)";

// What a policy has to know that the asking person may not read. Each answers for the account that connected
// (session_user, which nobody but a superuser changes), and only while that person is active and holds the
// role: an account that was forgotten when a role was withdrawn shows nothing.
const char* const functions = R"(
CREATE OR REPLACE FUNCTION holds_role(wanted text) RETURNS boolean
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT EXISTS (SELECT 1 FROM person_role r JOIN person p ON p.id = r.person_id
        WHERE r.person_id = session_user::text AND r.role = wanted AND p.active = 1) $$;
-- The ids under which the person's own rows are: theirs, and those that were merged into it.
CREATE OR REPLACE FUNCTION own_people() RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT session_user::text UNION SELECT id FROM person WHERE merged_into = session_user::text $$;
CREATE OR REPLACE FUNCTION taught_cohorts() RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT cohort_id FROM cohort_educator WHERE person_id = session_user::text AND holds_role('educator') $$;
CREATE OR REPLACE FUNCTION taught_people() RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    WITH members AS (SELECT m.person_id FROM cohort_member m WHERE m.cohort_id IN (SELECT taught_cohorts()))
    SELECT person_id FROM members UNION SELECT id FROM person WHERE merged_into IN (SELECT person_id FROM members) $$;
CREATE OR REPLACE FUNCTION own_cohorts() RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT cohort_id FROM cohort_member WHERE person_id = session_user::text $$;
-- Those that were released: ratings and releases name each other, and policies may not.
CREATE OR REPLACE FUNCTION own_ratings() RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT r.id FROM rating_release l JOIN rating r ON r.id = l.rating_id JOIN attempt a ON a.id = r.attempt_id
        WHERE a.person_id IN (SELECT own_people()) $$;
-- Who wrote what the person reads: their names are shown with it.
CREATE OR REPLACE FUNCTION named_people() RETURNS SETOF text
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    WITH seen AS (SELECT own_people() AS id UNION SELECT taught_people())
    SELECT c.author_id FROM comment c JOIN attempt a ON a.id = c.attempt_id WHERE a.person_id IN (SELECT id FROM seen)
    UNION SELECT e.author_id FROM error_review e JOIN attempt a ON a.id = e.attempt_id
        WHERE a.person_id IN (SELECT id FROM seen)
    UNION SELECT v.person_id FROM attempt_void v JOIN attempt a ON a.id = v.attempt_id
        WHERE a.person_id IN (SELECT id FROM seen)
    UNION SELECT r.rater_id FROM rating r JOIN attempt a ON a.id = r.attempt_id
        WHERE a.person_id IN (SELECT taught_people())
    UNION SELECT r.rater_id FROM rating r JOIN rating_release l ON l.rating_id = r.id JOIN attempt a ON a.id = r.attempt_id
        WHERE a.person_id IN (SELECT own_people())
    UNION SELECT author_id FROM standing_override WHERE person_id IN (SELECT id FROM seen)
    UNION SELECT author_id FROM curriculum_move WHERE person_id IN (SELECT id FROM seen)
    UNION SELECT person_id FROM asset_acceptance
    UNION SELECT person_id FROM cohort_educator
        WHERE cohort_id IN (SELECT own_cohorts() UNION SELECT taught_cohorts()) $$;
-- The newest row of each station's audit log, for the foot of reports: says nothing of what it is about.
CREATE OR REPLACE FUNCTION audit_heads() RETURNS TABLE (station_id text, hash bytea, public_half bytea)
    LANGUAGE sql STABLE SECURITY DEFINER SET search_path = public, pg_temp AS $$
    SELECT e.station_id, e.hash, s.public_half FROM station t JOIN LATERAL (SELECT * FROM audit_entry a
        WHERE a.station_id = t.id ORDER BY a.sequence DESC LIMIT 1) e ON true
        LEFT JOIN audit_signature s ON s.station_id = e.station_id AND s.sequence = e.sequence $$;
)";

constexpr const char* function_names[] = {"holds_role(text)", "own_people()",  "taught_cohorts()",
                                          "taught_people()",  "own_cohorts()", "own_ratings()",
                                          "named_people()",   "audit_heads()"};

struct Policy {
    const char* table;
    /// Which rows each role sees; policies of the tables named in it apply within it. Null: none, and no
    /// right to ask.
    const char *trainee, *educator, *director;
    const char* columns = "";  ///< "(id, name)": only these are read
};

#define FULCRUM_HOLDS_DIRECTOR "(SELECT holds_role('director'))"
constexpr const char* all = "true";
constexpr const char* directors_all = FULCRUM_HOLDS_DIRECTOR;
constexpr const char* own_account = "person_id = current_user::text";
constexpr const char* own_person = "person_id IN (SELECT own_people())";
constexpr const char* of_attempt = "EXISTS (SELECT 1 FROM attempt x WHERE x.id = attempt_id)";
constexpr const char* of_score = "EXISTS (SELECT 1 FROM score x WHERE x.id = score_id)";
constexpr const char* of_rating = "EXISTS (SELECT 1 FROM rating x WHERE x.id = rating_id)";
constexpr const char* of_goal = "EXISTS (SELECT 1 FROM personal_goal x WHERE x.id = goal_id)";
constexpr const char* lost_device =  // which assessed attempts became practice, and nothing else
    "operation = 'attempt.practice' AND EXISTS (SELECT 1 FROM attempt x WHERE x.id = object_id)";
constexpr const char* of_taught = "person_id IN (SELECT taught_people())";

/// A person's account has the person's id as its name, and only that is asked: no setting that a client can
/// change.
constexpr Policy policies[] = {
    {"programme_server", all, all, all},
    {"programme", all, all, all, "(id, name, created)"},
    {"station", all, all, all},
    {"setting", all, all, all},
    {"person", "id IN (SELECT own_people() UNION SELECT named_people())",
     "id IN (SELECT own_people() UNION SELECT taught_people() UNION SELECT named_people())",
     "id = current_user::text OR " FULCRUM_HOLDS_DIRECTOR},
    {"person_role", own_person, "EXISTS (SELECT 1 FROM person x WHERE x.id = person_id)",
     "EXISTS (SELECT 1 FROM person x WHERE x.id = person_id)"},
    {"credential", own_account, own_account, own_account, "(person_id, one_time)"},
    {"sign_in", own_person, of_taught, directors_all},
    {"cohort", "id IN (SELECT own_cohorts())", "id IN (SELECT taught_cohorts())", directors_all},
    {"cohort_member", own_person, "cohort_id IN (SELECT taught_cohorts())", directors_all},
    {"cohort_educator", "cohort_id IN (SELECT own_cohorts())", "cohort_id IN (SELECT taught_cohorts())",
     directors_all},
    {"audit_entry", lost_device, lost_device, lost_device},
    {"attempt", own_person, of_taught, directors_all},
    {"attempt_asset", of_attempt, of_attempt, directors_all},
    {"attempt_origin", of_attempt, of_attempt, directors_all},
    {"attempt_void", of_attempt, of_attempt, directors_all},
    {"attempt_reassignment",
     "EXISTS (SELECT 1 FROM attempt x WHERE x.id = from_id) OR EXISTS (SELECT 1 FROM attempt x WHERE x.id = "
     "to_id)",
     "EXISTS (SELECT 1 FROM attempt x WHERE x.id = from_id) OR EXISTS (SELECT 1 FROM attempt x WHERE x.id = "
     "to_id)",
     directors_all},
    {"trace_chunk", of_attempt, of_attempt, directors_all},
    {"attempt_product", of_attempt, of_attempt, directors_all},
    {"score", of_attempt, of_attempt, directors_all},
    {"gate", of_score, of_score, directors_all},
    {"metric", of_score, of_score, directors_all},
    {"critical_error", of_score, of_score, directors_all},
    {"pathology", of_score, of_score, directors_all},
    {"comment", of_attempt, of_attempt, directors_all},
    {"error_review", of_attempt, of_attempt, directors_all},
    {"correction_request", of_attempt, of_attempt, directors_all},
    {"standing_override", own_person, of_taught, directors_all},
    {"curriculum_move", own_person, of_taught, directors_all},
    // Nobody's but the trainee's and the educators'.
    {"personal_goal", own_person, of_taught, nullptr},
    {"personal_goal_end", of_goal, of_goal, nullptr},
    {"rating_release", "rating_id IN (SELECT own_ratings())", of_rating, directors_all},
    {"rating", "id IN (SELECT own_ratings())", of_attempt, directors_all},
    {"rating_item", of_rating, of_rating, directors_all},
    {"rating_seen", nullptr, of_attempt, directors_all},
    {"form_text", all, all, all},
    {"scene_text", all, all, all},
    {"tissue_setting", all, all, all},
    {"tissue_value", all, all, all},
    {"asset_acceptance", all, all, all},
    {"asset_text", all, all, all},
    // Nobody's: signing in, the audit log, and what the server keeps of erasures and stations.
    {"sign_in_wait", nullptr, nullptr, nullptr},
    {"recording", nullptr, nullptr, nullptr},
    {"xapi_outbox", nullptr, nullptr, nullptr},
    {"audit_payload", nullptr, nullptr, nullptr},
    {"audit_signature", nullptr, nullptr, nullptr},
    {"station_key", nullptr, nullptr, nullptr},
    {"erasure", nullptr, nullptr, nullptr},
    {"erased_payload", nullptr, nullptr, nullptr},
    {"enrolment", nullptr, nullptr, nullptr},
    {"enrolment_cohort", nullptr, nullptr, nullptr},
    {"station_unit", nullptr, nullptr, nullptr},
    {"station_shown", nullptr, nullptr, nullptr},
    {"server_log", nullptr, nullptr, nullptr}};
#undef FULCRUM_HOLDS_DIRECTOR

std::vector<std::string> tables_of(Connection& server) {
    Query rows(server, "SELECT tablename FROM pg_tables WHERE schemaname = 'public' ORDER BY tablename");
    std::vector<std::string> names;
    while (rows.next()) names.push_back(rows.text(0));
    return names;
}

const char* rows_for(const Policy& policy, Role role) {
    return role == Role::trainee    ? policy.trainee
           : role == Role::educator ? policy.educator
                                    : policy.director;
}

void set_policy(Connection& server, const QString& table, const QString& name, const QString& group,
                const QString& what) {
    server.execute(QString("DROP POLICY IF EXISTS %2 ON %1; CREATE POLICY %2 ON %1 %4 TO %3 %5")
                       .arg(table, name, group, what.section('|', 0, 0), what.section('|', 1)));
}

}  // namespace

std::vector<std::string> tables_without_policy(Connection& server) {
    std::vector<std::string> names;
    for (std::string& name : tables_of(server))
        if (std::none_of(std::begin(policies), std::end(policies),
                         [&](const Policy& policy) { return name == policy.table; }))
            names.push_back(std::move(name));
    return names;
}

void set_server_rights(Connection& server) {
    server.execute(rights);
    // A server of an earlier step has not got every column that they name.
    server.execute("SET LOCAL check_function_bodies = off");
    server.execute(functions);
    for (const char* function : function_names)
        server.execute(QString("REVOKE ALL ON FUNCTION %1 FROM PUBLIC; GRANT EXECUTE ON FUNCTION %1 TO "
                               "fulcrum_trainee, fulcrum_educator, fulcrum_director")
                           .arg(function));
    const std::vector<std::string> tables = tables_of(server);
    for (const std::string& table : tables)
        server.execute(
            QString("ALTER TABLE %1 ENABLE ROW LEVEL SECURITY").arg(QString::fromStdString(table)));
    set_station_rights(server);
    for (const Policy& policy : policies) {
        // Of a later schema than this server has, or of a station only.
        if (std::find(tables.begin(), tables.end(), policy.table) == tables.end()) continue;
        for (const Role role : server_roles) {
            const QString group = QString::fromStdString(server_group(role));
            const char* const rows = rows_for(policy, role);
            if (rows == nullptr) continue;
            server.execute(QString("GRANT SELECT %2 ON %1 TO %3").arg(policy.table, policy.columns, group));
            set_policy(server, policy.table, role_name(role), group,
                       QString("FOR SELECT|USING (%1)").arg(rows));
        }
    }
    // Whoever opens an attempt with name and score at the server is not blind for it any more.
    for (const Role role : {Role::educator, Role::director})
        set_policy(server, "rating_seen", QString("%1_sees").arg(role_name(role)),
                   QString::fromStdString(server_group(role)),
                   QString("FOR INSERT|WITH CHECK (%1 AND %2)").arg(own_account, of_attempt));
}

}  // namespace fulcrum::database
