// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/erasure.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <set>

#include "database/records/rating_seen.h"
#include "database/store/audit.h"
#include "database/store/kept_frames.h"
#include "database/store/record_digests.h"
#include "database/store/recording_lock.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

#define FULCRUM_THEIR_ATTEMPTS "(SELECT id FROM attempt WHERE person_id = ?)"
#define FULCRUM_THEIR_SCORES "(SELECT id FROM score WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS ")"
#define FULCRUM_THEIR_RATINGS "(SELECT id FROM rating WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS ")"

#define FULCRUM_THEIR_GOALS "(SELECT id FROM personal_goal WHERE person_id = ?)"

const std::vector<RowsAbout> deletions = {
    {"gate", "score_id IN " FULCRUM_THEIR_SCORES},
    {"metric", "score_id IN " FULCRUM_THEIR_SCORES},
    {"critical_error", "score_id IN " FULCRUM_THEIR_SCORES},
    {"pathology", "score_id IN " FULCRUM_THEIR_SCORES},
    {"score", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
    {"trace_chunk", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
    {"attempt_product", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
    {"attempt_asset", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
    {"attempt_origin", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
    {"recording", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
    {"attempt_void", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
    {"attempt_reassignment", "from_id IN " FULCRUM_THEIR_ATTEMPTS " OR to_id IN " FULCRUM_THEIR_ATTEMPTS},
    {"comment", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS " OR author_id = ?"},
    {"error_review", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS " OR author_id = ?"},
    {"correction_request", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS " OR person_id = ?"},
    {"rating_release", "rating_id IN " FULCRUM_THEIR_RATINGS},
    {"rating_item", "rating_id IN " FULCRUM_THEIR_RATINGS},
    {"rating", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
    {"rating_seen", "attempt_id IN " FULCRUM_THEIR_ATTEMPTS " OR person_id = ?"},
    {"attempt", "person_id = ?"},
    {"standing_override", "person_id = ?"},
    {"curriculum_move", "person_id = ?"},
    {"personal_goal_end", "goal_id IN " FULCRUM_THEIR_GOALS},
    {"personal_goal", "person_id = ?"},
    {"xapi_outbox", "person_id = ?"},
    {"credential", "person_id = ?"},
    {"person_role", "person_id = ?"},
    {"cohort_member", "person_id = ?"},
    {"cohort_educator", "person_id = ?"},
    {"sign_in", "person_id = ?"}};

/// What audit rows are about when they are about this person.
constexpr const char* objects[] = {
    "SELECT id FROM person WHERE id = ?",
    "SELECT id FROM attempt WHERE person_id = ?",
    "SELECT id FROM score WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS,
    "SELECT id FROM comment WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS " OR author_id = ?",
    "SELECT id FROM error_review WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS " OR author_id = ?",
    "SELECT id FROM rating WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS,
    "SELECT id FROM correction_request WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS " OR person_id = ?",
    "SELECT id FROM standing_override WHERE person_id = ?",
    "SELECT id FROM curriculum_move WHERE person_id = ?",
    "SELECT id FROM personal_goal WHERE person_id = ?"};

/// Where what was handed in or decided is never deleted, but for an erasure.
constexpr const char* guarded[] = {
    "rating",          "rating_item",   "rating_release",    "standing_override",
    "curriculum_move", "personal_goal", "personal_goal_end", "error_review"};

/// Sets the triggers that forbid deleting aside; they come back when it ends.
class WithoutGuards {
  public:
    explicit WithoutGuards(Connection& connection) : connection_(connection) {
        for (const char* table : guarded) {
            if (connection_.is_server()) {
                connection_.execute(QString("ALTER TABLE %1 DISABLE TRIGGER USER").arg(table));
                continue;
            }
            Query rows(
                connection_,
                "SELECT name, sql FROM sqlite_master WHERE type = 'trigger' AND tbl_name = ? AND sql LIKE "
                "'%BEFORE DELETE%'");
            rows.bind(table);
            while (rows.next()) triggers_.emplace_back(rows.text(0), rows.text(1));
        }
        for (const auto& trigger : triggers_)
            connection_.execute("DROP TRIGGER " + QString::fromStdString(trigger.first));
    }
    /// Within the same transaction: without it the transaction is rolled back, and the triggers with it.
    void restore() {
        for (const auto& trigger : triggers_) connection_.execute(QString::fromStdString(trigger.second));
        if (!connection_.is_server()) return;
        for (const char* table : guarded)
            connection_.execute(QString("ALTER TABLE %1 ENABLE TRIGGER USER").arg(table));
    }

  private:
    Connection& connection_;
    std::vector<std::pair<std::string, std::string>> triggers_;
};

/// Records that an erasure deletes or changes, whether this station made or received them.
std::set<std::string> their_records(Connection& connection, const std::string& person_id) {
    struct Source {
        RecordKind kind;
        const char* ids;
    };
    constexpr Source sources[] = {
        {RecordKind::cohort, "SELECT cohort_id FROM cohort_member WHERE person_id = ?"},
        {RecordKind::cohort, "SELECT cohort_id FROM cohort_educator WHERE person_id = ?"},
        {RecordKind::attempt, "SELECT id FROM attempt WHERE person_id = ?"},
        {RecordKind::trace, "SELECT id FROM attempt WHERE person_id = ?"},
        {RecordKind::score, "SELECT id FROM score WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
        {RecordKind::attempt_void,
         "SELECT attempt_id FROM attempt_void WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
        {RecordKind::reassignment,
         "SELECT from_id FROM attempt_reassignment WHERE from_id IN " FULCRUM_THEIR_ATTEMPTS
         " OR to_id IN " FULCRUM_THEIR_ATTEMPTS},
        {RecordKind::comment,
         "SELECT id FROM comment WHERE sent <> 0 AND (attempt_id IN " FULCRUM_THEIR_ATTEMPTS
         " OR author_id = ?)"},
        {RecordKind::error_review,
         "SELECT id FROM error_review WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS " OR author_id = ?"},
        {RecordKind::correction,
         "SELECT id FROM correction_request WHERE attempt_id IN " FULCRUM_THEIR_ATTEMPTS " OR person_id = ?"},
        {RecordKind::decision, "SELECT id FROM standing_override WHERE person_id = ?"},
        {RecordKind::curriculum_move, "SELECT id FROM curriculum_move WHERE person_id = ?"},
        {RecordKind::goal, "SELECT id FROM personal_goal WHERE person_id = ?"},
        {RecordKind::goal_end, "SELECT goal_id FROM personal_goal_end WHERE goal_id IN " FULCRUM_THEIR_GOALS},
        {RecordKind::rating,
         "SELECT id FROM rating WHERE handed_in <> 0 AND attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
        {RecordKind::form,
         "SELECT form_digest FROM rating WHERE handed_in <> 0 AND attempt_id IN " FULCRUM_THEIR_ATTEMPTS},
        {RecordKind::rating_release,
         "SELECT rating_id FROM rating_release WHERE rating_id IN " FULCRUM_THEIR_RATINGS}};
    std::set<std::string> names;
    for (const Source& source : sources) {
        Query rows = about_person(connection, source.ids, person_id);
        while (rows.next()) names.insert(RecordName{source.kind, rows.text(0)}.text());
    }
    return names;
}

void delete_rows(Connection& connection, const std::string& person_id) {
    // Who has seen an attempt of theirs has seen the copy that stays.
    note_copies(connection, "s.attempt_id IN " FULCRUM_THEIR_ATTEMPTS, person_id);
    WithoutGuards guards(connection);
    for (const RowsAbout& one : deletions)
        about_person(connection, std::string("DELETE FROM ") + one.table + " WHERE " + one.where, person_id)
            .run();
    guards.restore();
    // The same on every side, so that both sides agree, and above every version that a station may have.
    constexpr std::int64_t erased_version = 1000000000;
    const std::string login = "erased-" + person_id;
    Query(connection,
          "UPDATE person SET login = ?, login_key = ?, display_name = 'Erased person', active = 0, "
          "merged_into = '', "
          "version = ? "
          "WHERE id = ?")
        .bind(login)
        .bind(login)
        .bind(erased_version)
        .bind(person_id)
        .run();
}

}  // namespace

const std::vector<RowsAbout>& rows_about_people() {
    return deletions;
}

Query about_person(Connection& connection, const std::string& sql, const std::string& person_id) {
    Query query(connection, QString::fromStdString(sql));
    for (const char c : sql)
        if (c == '?') query.bind(person_id);
    return query;
}

std::set<std::string> audit_objects_of(Connection& connection, const std::string& person_id) {
    std::set<std::string> ids;
    for (const char* sql : objects) {
        Query rows = about_person(connection, sql, person_id);
        while (rows.next()) ids.insert(rows.text(0));
    }
    return ids;
}

std::vector<std::string> with_merged(Connection& connection, const std::string& person_id) {
    std::vector<std::string> ids = {person_id};
    Query rows(connection, "SELECT id FROM person WHERE merged_into = ? ORDER BY id");
    rows.bind(person_id);
    while (rows.next()) ids.push_back(rows.text(0));
    return ids;
}

std::vector<ErasedRows> rows_to_erase(Connection& connection, const std::string& person_id) {
    {
        Query person(connection, "SELECT 1 FROM person WHERE id = ?");
        person.bind(person_id);
        if (!person.next())
            throw StoreError(
                StoreErrorKind::not_found,
                {QT_TRANSLATE_NOOP("errors", "%1: has no person %2"), connection.path(), person_id},
                QT_TRANSLATE_NOOP(
                    "errors", "give the id (UUID) that `fulcrum report --format json` and exports print"));
    }
    std::vector<ErasedRows> result;
    for (const RowsAbout& one : deletions) {
        std::int64_t count = 0;
        for (const std::string& id : with_merged(connection, person_id)) {
            Query rows = about_person(
                connection, std::string("SELECT COUNT(*) FROM ") + one.table + " WHERE " + one.where, id);
            if (rows.next()) count += rows.integer(0);
        }
        if (count > 0) result.push_back({one.table, count});
    }
    return result;
}

namespace {

void erase_one_on_server(Connection& server, const std::string& person_id, std::int64_t time) {
    Query(server, "SELECT 1 FROM person WHERE id = ? FOR UPDATE").bind(person_id).run();
    Query(server, "INSERT INTO erasure (person_id, time) VALUES (?, ?) ON CONFLICT (person_id) DO NOTHING")
        .bind(person_id)
        .bind(time)
        .run();
    for (const std::string& id : audit_objects_of(server, person_id)) {
        Query(server,
              "INSERT INTO erased_payload SELECT p.station_id, p.sequence FROM audit_payload p JOIN "
              "audit_entry e ON "
              "e.station_id = p.station_id AND e.sequence = p.sequence WHERE e.object_id = ? ON CONFLICT DO "
              "NOTHING")
            .bind(id)
            .run();
    }
    server.execute(
        "DELETE FROM audit_payload p USING erased_payload g WHERE g.station_id = p.station_id AND g.sequence "
        "= "
        "p.sequence");
    delete_rows(server, person_id);
}

/// Whether a station has anything but the row of this person. An exchange reads the list of erasures before
/// it reads people: somebody whom the server erases in between comes as an erased row, and all else is still
/// there.
bool has_rows_about(Connection& station, const std::string& person_id) {
    for (const RowsAbout& one : deletions)
        if (about_person(station,
                         std::string("SELECT 1 FROM ") + one.table + " WHERE (" + one.where + ") LIMIT 1",
                         person_id)
                .next())
            return true;
    return about_person(station,
                        "SELECT 1 FROM audit_payload p JOIN audit_entry e ON e.station_id = p.station_id AND "
                        "e.sequence = p.sequence WHERE e.object_id = ? LIMIT 1",
                        person_id)
        .next();
}

}  // namespace

void erase_on_server(Connection& server, const std::string& person_id, std::int64_t time) {
    Transaction transaction(server);
    for (const std::string& id : with_merged(server, person_id)) erase_one_on_server(server, id, time);
    transaction.commit();
}

bool erase_at_station(const Store& store, const std::string& person_id, const Session& actor,
                      const std::string& reason) {
    Transaction transaction(store.connection());
    Connection& connection = store.connection();
    {
        Query person(connection, "SELECT login FROM person WHERE id = ?");
        person.bind(person_id);
        if (!person.next()) return false;
        if (person.text(0) == "erased-" + person_id && !has_rows_about(connection, person_id)) return false;
    }
    {
        Query running(connection, "SELECT id FROM attempt WHERE person_id = ? AND state = 'running'");
        running.bind(person_id);
        while (running.next()) {
            const std::string attempt = running.text(0);
            if (RecordingLock::is_held(store, attempt))
                throw StoreError(
                    StoreErrorKind::locked,
                    QT_TRANSLATE_NOOP("errors", "a person who is to be erased is performing at this station"),
                    QT_TRANSLATE_NOOP("errors", "try again when the attempt has ended"));
            RecordingLock::clean(store, attempt);  // of a program that was killed
        }
    }
    // What the erased payloads say of records that stay is said again.
    std::set<std::string> names = {RecordName{RecordKind::person, person_id}.text()};
    std::vector<std::int64_t> sequences;
    for (const std::string& id : audit_objects_of(connection, person_id)) {
        Query rows(connection,
                   "SELECT p.sequence, p.payload FROM audit_payload p JOIN audit_entry e ON e.station_id = "
                   "p.station_id AND e.sequence = p.sequence WHERE e.station_id = ? AND e.object_id = ?");
        rows.bind(store.station_id()).bind(id);
        while (rows.next()) {
            sequences.push_back(rows.integer(0));
            const QJsonObject said =
                QJsonDocument::fromJson(QByteArray::fromStdString(rows.text(1))).object();
            for (const QString& name : said.value(QLatin1String(records_key)).toObject().keys())
                names.insert(name.toStdString());
        }
    }
    for (const std::string& name : their_records(connection, person_id)) names.insert(name);
    std::vector<std::string> attempts;
    {
        Query rows(connection, "SELECT id FROM attempt WHERE person_id = ?");
        rows.bind(person_id);
        while (rows.next()) attempts.push_back(rows.text(0));
    }
    delete_rows(connection, person_id);
    std::vector<RecordName> records;
    for (const std::string& name : names)
        if (const auto record = RecordName::of_text(name)) records.push_back(*record);
    Audit(store).erase_payloads(actor, sequences, reason, records);
    // Before the commit: cut off in between, the person is still there and is erased again.
    for (const std::string& id : attempts) remove_kept_frames(store, id);
    transaction.commit();
    return true;
}

std::vector<Sentence> merged_into_erased(Connection& connection) {
    Query rows(connection,
               "SELECT p.id, p.login FROM person p JOIN person t ON t.id = p.merged_into WHERE t.login = "
               "'erased-' || t.id AND p.login <> 'erased-' || p.id ORDER BY p.login");
    std::vector<Sentence> found;
    while (rows.next())
        found.push_back(
            {QT_TRANSLATE_NOOP("errors",
                               "\"%1\" was merged into a person who was erased on the server, which "
                               "did not know of the merge: erase %2 there too (`fulcrum server "
                               "erase`), or undo the merge"),
             rows.text(1), rows.text(0)});
    return found;
}

}  // namespace fulcrum::database
