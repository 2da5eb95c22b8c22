// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/sync_tables.h"

namespace fulcrum::database {
namespace {

// Simulated and external people, their attempts, drafts and attempts that still run stay at the station.
#define FULCRUM_REAL_ATTEMPTS                                                                               \
    "(SELECT a.id FROM attempt a JOIN person p ON p.id = a.person_id WHERE p.kind = 'real' AND a.state <> " \
    "'running')"
constexpr const char* everything = "1 = 1";
constexpr const char* of_real_attempts = "attempt_id IN " FULCRUM_REAL_ATTEMPTS;
constexpr const char* of_real_people = "person_id IN (SELECT id FROM person WHERE kind = 'real')";

constexpr SyncRule added = SyncRule::added, versioned = SyncRule::versioned;

const std::vector<SyncTable> tables = {
    {"programme", "programme", {"id"}, versioned, everything, {}, {}, RecordKind::programme},
    {"stations", "station", {"id"}, added, everything, {}, {}, RecordKind::station},
    {"people",
     "person",
     {"id"},
     versioned,
     "kind = 'real'",
     {{"person_role", "person_id"}, {"credential", "person_id"}},
     {},
     RecordKind::person,
     "login_key"},
    {"cohorts",
     "cohort",
     {"id"},
     versioned,
     everything,
     {{"cohort_member", "cohort_id"}, {"cohort_educator", "cohort_id"}},
     {{"cohort_member", "person_id", "person"}, {"cohort_educator", "person_id", "person"}},
     RecordKind::cohort,
     "name"},
    {"accepted files",
     "asset_acceptance",
     {"digest"},
     added,
     everything,
     {},
     {{"asset_acceptance", "person_id", "person"}},
     RecordKind::asset},
    {"scenes",
     "scene_text",
     {"digest"},
     added,
     "digest IN (SELECT s.scene_digest FROM attempt s WHERE s.id IN " FULCRUM_REAL_ATTEMPTS ")"},
    {"forms",
     "form_text",
     {"digest"},
     added,
     "digest IN (SELECT r.form_digest FROM rating r WHERE r.handed_in <> 0)"},
    {"attempts",
     "attempt",
     {"id"},
     added,
     "id IN " FULCRUM_REAL_ATTEMPTS,
     {{"attempt_asset", "attempt_id"},
      {"attempt_origin", "attempt_id"},
      {"trace_chunk", "attempt_id", true},
      {"attempt_product", "attempt_id", true}},
     {{"attempt", "person_id", "person"}, {"attempt", "station_id", "station"}},
     RecordKind::attempt,
     nullptr,
     20},
    {"scores",
     "score",
     {"id"},
     added,
     of_real_attempts,
     {{"gate", "score_id"},
      {"metric", "score_id"},
      {"critical_error", "score_id"},
      {"pathology", "score_id"}},
     {{"score", "attempt_id", "attempt"}},
     RecordKind::score},
    {"voids",
     "attempt_void",
     {"attempt_id"},
     added,
     of_real_attempts,
     {},
     {{"attempt_void", "attempt_id", "attempt"}, {"attempt_void", "person_id", "person"}},
     RecordKind::attempt_void},
    {"reassignments",
     "attempt_reassignment",
     {"from_id"},
     added,
     "from_id IN " FULCRUM_REAL_ATTEMPTS " AND to_id IN " FULCRUM_REAL_ATTEMPTS,
     {},
     {{"attempt_reassignment", "from_id", "attempt"}, {"attempt_reassignment", "to_id", "attempt"}},
     RecordKind::reassignment},
    {"comments",
     "comment",
     {"id"},
     added,
     "sent <> 0 AND attempt_id IN " FULCRUM_REAL_ATTEMPTS,
     {},
     {{"comment", "attempt_id", "attempt"}, {"comment", "author_id", "person"}},
     RecordKind::comment},
    {"corrections asked for",
     "correction_request",
     {"id"},
     added,
     of_real_attempts,
     {},
     {{"correction_request", "attempt_id", "attempt"}, {"correction_request", "person_id", "person"}},
     RecordKind::correction},
    {"decisions on standings",
     "standing_override",
     {"id"},
     added,
     of_real_people,
     {},
     {{"standing_override", "person_id", "person"}, {"standing_override", "author_id", "person"}},
     RecordKind::decision},
    {"moves of curriculum",
     "curriculum_move",
     {"id"},
     added,
     of_real_people,
     {},
     {{"curriculum_move", "person_id", "person"}, {"curriculum_move", "author_id", "person"}},
     RecordKind::curriculum_move},
    {"ratings",
     "rating",
     {"id"},
     added,
     "handed_in <> 0 AND attempt_id IN " FULCRUM_REAL_ATTEMPTS,
     {{"rating_item", "rating_id"}},
     {{"rating", "attempt_id", "attempt"},
      {"rating", "rater_id", "person"},
      {"rating", "form_digest", "form_text"}},
     RecordKind::rating},
    {"released ratings",
     "rating_release",
     {"rating_id"},
     added,
     "rating_id IN (SELECT r.id FROM rating r WHERE r.attempt_id IN " FULCRUM_REAL_ATTEMPTS ")",
     {},
     {{"rating_release", "rating_id", "rating"}, {"rating_release", "person_id", "person"}},
     RecordKind::rating_release},
    {"who saw names of attempts to be rated",
     "rating_seen",
     {"attempt_id", "person_id"},
     added,
     of_real_attempts,
     {},
     {{"rating_seen", "attempt_id", "attempt"}, {"rating_seen", "person_id", "person"}}},
};

}  // namespace

const std::vector<SyncTable>& sync_tables() {
    return tables;
}

#undef FULCRUM_REAL_ATTEMPTS

std::string key_expression(const SyncTable& table) {
    std::string text;
    for (const char* column : table.key) text += (text.empty() ? "" : " || ' ' || ") + std::string(column);
    return text;
}

}  // namespace fulcrum::database
