// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/server_rights.h"

#include <algorithm>
#include <vector>

namespace fulcrum::database {
namespace {

/// Stations add rows; they change and delete those only that a newer version of a person or cohort replaces.
/// PUBLIC has nothing.
const char* const rights = R"(
DO $$ BEGIN
    IF NOT EXISTS (SELECT 1 FROM pg_roles WHERE rolname = 'fulcrum_station') THEN CREATE ROLE fulcrum_station; END IF;
    IF NOT EXISTS (SELECT 1 FROM pg_roles WHERE rolname = 'fulcrum_trainee') THEN CREATE ROLE fulcrum_trainee; END IF;
END $$;
REVOKE ALL ON ALL TABLES IN SCHEMA public FROM PUBLIC, fulcrum_station, fulcrum_trainee;
GRANT USAGE ON SCHEMA public TO fulcrum_station, fulcrum_trainee;
GRANT SELECT, INSERT ON ALL TABLES IN SCHEMA public TO fulcrum_station;
REVOKE INSERT ON programme_server, erasure, erased_payload FROM fulcrum_station;
GRANT UPDATE ON person, cohort, programme TO fulcrum_station;
GRANT DELETE ON person_role, credential, cohort_member, cohort_educator TO fulcrum_station;
)";

struct Policy {
    const char* table;
    const char* rows;  ///< which a trainee sees; policies of other tables apply within it
};

/// A trainee's account has the person's id as its name, and only that is asked: no setting that a client can
/// change.
constexpr Policy trainee[] = {{"person", "id = current_user::text"},
                              {"attempt", "person_id = current_user::text"},
                              {"attempt_void", "attempt_id IN (SELECT id FROM attempt)"},
                              {"score", "attempt_id IN (SELECT id FROM attempt)"},
                              {"gate", "score_id IN (SELECT id FROM score)"},
                              {"metric", "score_id IN (SELECT id FROM score)"},
                              {"critical_error", "score_id IN (SELECT id FROM score)"},
                              {"pathology", "score_id IN (SELECT id FROM score)"},
                              {"trace_chunk", "attempt_id IN (SELECT id FROM attempt)"},
                              {"attempt_product", "attempt_id IN (SELECT id FROM attempt)"},
                              {"comment", "attempt_id IN (SELECT id FROM attempt)"},
                              {"rating_release", "rating_id IN (SELECT own_ratings())"},
                              {"rating", "id IN (SELECT rating_id FROM rating_release)"},
                              {"rating_item", "rating_id IN (SELECT id FROM rating)"},
                              {"standing_override", "person_id = current_user::text"},
                              {"personal_goal", "person_id = current_user::text"},
                              {"personal_goal_end", "goal_id IN (SELECT id FROM personal_goal)"},
                              {"curriculum_move", "person_id = current_user::text"}};

std::vector<std::string> tables_of(Connection& server) {
    Query rows(server, "SELECT tablename FROM pg_tables WHERE schemaname = 'public'");
    std::vector<std::string> names;
    while (rows.next()) names.push_back(rows.text(0));
    return names;
}

}  // namespace

void set_server_rights(Connection& server) {
    server.execute(rights);
    // A release names a rating, and a rating is seen where it was released: one of the two has to look past
    // the policies, for the asking person's rows only.
    server.execute(
        "CREATE OR REPLACE FUNCTION own_ratings() RETURNS SETOF text LANGUAGE sql STABLE SECURITY DEFINER "
        "SET "
        "search_path = public AS $$ SELECT r.id FROM rating r JOIN attempt a ON a.id = r.attempt_id WHERE "
        "a.person_id "
        "= session_user::text $$; REVOKE ALL ON FUNCTION own_ratings() FROM PUBLIC; GRANT EXECUTE ON "
        "FUNCTION "
        "own_ratings() TO fulcrum_trainee");
    const std::vector<std::string> tables = tables_of(server);
    for (const std::string& table : tables) {
        server.execute(
            QString("ALTER TABLE %1 ENABLE ROW LEVEL SECURITY; DROP POLICY IF EXISTS station ON %1; CREATE "
                    "POLICY station ON %1 TO fulcrum_station USING (true) WITH CHECK (true)")
                .arg(QString::fromStdString(table)));
    }
    for (const Policy& policy : trainee) {
        if (std::find(tables.begin(), tables.end(), policy.table) == tables.end()) continue;
        server.execute(
            QString("GRANT SELECT ON %1 TO fulcrum_trainee; DROP POLICY IF EXISTS trainee ON %1; CREATE "
                    "POLICY trainee ON %1 FOR SELECT TO fulcrum_trainee USING (%2)")
                .arg(policy.table, policy.rows));
    }
}

}  // namespace fulcrum::database
