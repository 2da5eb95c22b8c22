// SPDX-License-Identifier: GPL-3.0-or-later
// What changes about an attempt after its end: another score, void, reassignment, a request for correction.
#include "database/records/attempt_query.h"
#include "database/records/attempts.h"
#include "database/records/external_attempts.h"
#include "database/records/rating_seen.h"
#include "database/rows/crypto.h"
#include "database/rows/enum_column.h"
#include "database/rows/json.h"
#include "database/rows/same_person.h"
#include "database/store/audit.h"
#include "database/store/score_rows.h"

namespace fulcrum::database {
namespace {

void require_reason(const std::string& reason) {
    if (reason.find_first_not_of(" \t\n") == std::string::npos || reason.size() > 4000) {
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a reason is missing or too long"),
                         QT_TRANSLATE_NOOP("errors", "give a reason of 1 to 4,000 characters"));
    }
}

void write_void(const Store& store, const Session& educator, const std::string& attempt_id,
                const std::string& reason) {
    Connection& connection = store.connection();
    Query row(connection,
              "SELECT state, EXISTS (SELECT 1 FROM attempt_void WHERE attempt_id = a.id) FROM attempt a "
              "WHERE id = ?");
    row.bind(attempt_id);
    if (!row.next()) unknown_attempt(attempt_id);
    const AttemptState state = enum_of(row.text(0), attempt_states, "state of attempt " + attempt_id);
    if (state == AttemptState::running)
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "the attempt is still running"),
                         QT_TRANSLATE_NOOP("errors", "wait for its end"));
    if (row.flag(1))
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "the attempt is voided already"),
                         QT_TRANSLATE_NOOP("errors", "there is nothing left to do"));
    Query(connection, "INSERT INTO attempt_void (attempt_id, person_id, time, reason) VALUES (?, ?, ?, ?)")
        .bind(attempt_id)
        .bind(educator.person_id())
        .bind(store.now())
        .bind(reason)
        .run();
}

/// A copy has a trace of its own: made where there is none, it would have none anywhere.
void require_trace_to_copy(const Store& store, const std::string& attempt_id) {
    Query row(store.connection(), "SELECT events, task_id FROM attempt WHERE id = ?");
    row.bind(attempt_id);
    if (!row.next()) return;
    if (row.integer(0) != trace_not_kept) require_trace_here(store, attempt_id);
    if (!is_external_task(row.text(1))) return;
    Query imported(store.connection(), "SELECT 1 FROM attempt_product WHERE attempt_id = ? AND kind = ?");
    imported.bind(attempt_id).bind(external_trace_product);
    if (!imported.next()) no_imported_trace(attempt_id);
}

/// Everything but scores and reviews, as an attempt of that person. The copy is this station's, as its trace
/// is, wherever the original was recorded.
void copy_attempt(const Store& store, const std::string& attempt_id, const std::string& copy,
                  const std::string& person_id) {
    Connection& connection = store.connection();
    Query(connection,
          "INSERT INTO attempt SELECT ?, ?, ?, task_id, task_version, mode, device_class, device, "
          "operator_name, variant, "
          "seed, fidelity, scene, scene_digest, curriculum, limits, program_version, cpu_features, started, "
          "utc_offset_min, 'running', "
          "duration_s, wall_s, missed_ticks, lost_samples, events, state_hash, force_devices FROM attempt "
          "WHERE id = ?")
        .bind(copy)
        .bind(person_id)
        .bind(store.station_id())
        .bind(attempt_id)
        .run();
    Query(connection,
          "INSERT INTO attempt_asset SELECT ?, file, digest FROM attempt_asset WHERE attempt_id = ? AND file "
          "<> " FULCRUM_COPIED_FROM)
        .bind(copy)
        .bind(attempt_id)
        .run();
    // The row of the reassignment goes with the original.
    Query(connection,
          "INSERT INTO attempt_asset (attempt_id, file, digest) VALUES (?, " FULCRUM_COPIED_FROM ", ?)")
        .bind(copy)
        .bind(attempt_id)
        .run();
    // The trace is copied, not shared: erasing one person must not damage the other's attempt.
    Query(connection,
          "INSERT INTO trace_chunk SELECT ?, stream, number, first_tick, last_tick, records, checksum, data "
          "FROM trace_chunk "
          "WHERE attempt_id = ?")
        .bind(copy)
        .bind(attempt_id)
        .run();
    Query(connection,
          "INSERT INTO attempt_product SELECT ?, kind, checksum, data FROM attempt_product WHERE attempt_id "
          "= ?")
        .bind(copy)
        .bind(attempt_id)
        .run();
    Query(connection,
          "INSERT INTO attempt_origin SELECT ?, source_id, tick, goal, build, checksum, state FROM "
          "attempt_origin WHERE attempt_id = ?")
        .bind(copy)
        .bind(attempt_id)
        .run();
    // Only a running attempt takes a trace.
    Query(connection, "UPDATE attempt SET state = (SELECT state FROM attempt WHERE id = ?) WHERE id = ?")
        .bind(attempt_id)
        .bind(copy)
        .run();
}

}  // namespace

std::string Attempts::add_score(const Session& session, const std::string& attempt_id,
                                const ScoreRow& score) const {
    Transaction transaction(store_.connection());
    const std::string person = person_of(store_, attempt_id);
    Query row(store_.connection(),
              "SELECT a.state, EXISTS (SELECT 1 FROM score s WHERE s.attempt_id = a.id) FROM attempt a WHERE "
              "a.id = ?");
    row.bind(attempt_id);
    if (!row.next()) unknown_attempt(attempt_id);
    const AttemptState state = enum_of(row.text(0), attempt_states, "state of attempt " + attempt_id);
    const bool first_of_interrupted = state == AttemptState::interrupted && !row.flag(1);
    store_.require(session, first_of_interrupted ? Operation::score_interrupted : Operation::recompute_score,
                   Subject::person(person));
    if (state == AttemptState::running)
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "the attempt is still running"),
                         QT_TRANSLATE_NOOP("errors", "wait for its end"));
    Query origin(store_.connection(), "SELECT 1 FROM attempt_origin WHERE attempt_id = ?");
    origin.bind(attempt_id);
    if (origin.next())
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "the attempt continues another one and is never scored"),
                         QT_TRANSLATE_NOOP("errors", "score an attempt from its beginning"));
    std::string id = write_score(store_, session, attempt_id, score);
    transaction.commit();
    return id;
}

void Attempts::void_attempt(const Session& educator, const std::string& attempt_id,
                            const std::string& reason) const {
    require_attempt(store_, educator, Operation::void_attempt, attempt_id);
    require_reason(reason);
    Transaction transaction(store_.connection());
    write_void(store_, educator, attempt_id, reason);
    Audit(store_).append(educator, attempt_id, "attempt.void", json_object({{"reason", reason}}),
                         {{RecordKind::attempt_void, attempt_id}});
    transaction.commit();
}

std::string Attempts::reassign(const Session& educator, const std::string& attempt_id,
                               const std::string& person_id, const std::string& reason) const {
    const std::string from = require_attempt(store_, educator, Operation::reassign_attempt, attempt_id);
    store_.require(educator, Operation::reassign_attempt, Subject::person(person_id));
    require_reason(reason);
    if (from == person_id) {
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "the attempt belongs to that person already"),
                         QT_TRANSLATE_NOOP("errors", "name the person who performed it"));
    }
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    write_void(store_, educator, attempt_id, reason);
    require_trace_to_copy(store_, attempt_id);
    std::string copy = random_uuid();
    copy_attempt(store_, attempt_id, copy, person_id);
    std::vector<std::string> ids;
    {
        Query rows(connection,
                   "SELECT id FROM score WHERE attempt_id = ? ORDER BY in_force DESC, computed, id");
        rows.bind(attempt_id);
        while (rows.next()) ids.push_back(rows.text(0));
    }
    for (const std::string& id : ids) write_score(store_, educator, copy, read_score(connection, id));
    Query(connection, "INSERT INTO attempt_reassignment (from_id, to_id) VALUES (?, ?)")
        .bind(attempt_id)
        .bind(copy)
        .run();
    note_copies(connection, "s.attempt_id = ?", attempt_id);
    Audit(store_).append(educator, attempt_id, "attempt.reassign",
                         json_object({{"from", from}, {"to", person_id}, {"copy", copy}, {"reason", reason}}),
                         {{RecordKind::attempt_void, attempt_id},
                          {RecordKind::attempt, copy},
                          {RecordKind::trace, copy},
                          {RecordKind::reassignment, attempt_id}});
    transaction.commit();
    return copy;
}

void Attempts::request_correction(const Session& trainee, const std::string& attempt_id,
                                  const std::string& text) const {
    require_attempt(store_, trainee, Operation::request_correction, attempt_id);
    require_reason(text);
    const std::string id = random_uuid();
    Transaction transaction(store_.connection());
    Query(store_.connection(),
          "INSERT INTO correction_request (id, attempt_id, person_id, text, asked) VALUES (?, ?, ?, ?, ?)")
        .bind(id)
        .bind(attempt_id)
        .bind(trainee.person_id())
        .bind(text)
        .bind(store_.now())
        .run();
    Audit(store_).append(trainee, attempt_id, "attempt.request_correction", json_object({{"text", text}}),
                         {{RecordKind::correction, id}});
    transaction.commit();
}

std::vector<CorrectionRequest> Attempts::correction_requests(const Session& session) const {
    store_.require(session, Operation::read_requests);
    Query rows(
        store_.connection(),
        "SELECT r.id, r.attempt_id, p.id, p.display_name, r.text, r.asked, "
        "EXISTS (SELECT 1 FROM attempt_void v WHERE v.attempt_id = r.attempt_id) FROM correction_request r " +
            join_owner("r.person_id", "p") + "WHERE " +
            visible_people(session, Operation::read_requests, "p.id") + " ORDER BY r.asked DESC, r.id");
    bind_visible_people(rows, session, Operation::read_requests);
    std::vector<CorrectionRequest> requests;
    while (rows.next()) {
        requests.push_back({rows.text(0), rows.text(1), rows.text(2), rows.text(3), rows.text(4),
                            rows.integer(5), rows.flag(6)});
    }
    return requests;
}

}  // namespace fulcrum::database
