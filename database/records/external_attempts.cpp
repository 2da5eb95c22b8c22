// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/external_attempts.h"

#include <algorithm>
#include <cmath>

#include "database/records/attempts.h"
#include "database/rows/crypto.h"
#include "database/rows/force_devices.h"
#include "database/rows/json.h"
#include "database/rows/packed_bytes.h"
#include "database/rows/same_person.h"
#include "database/store/audit.h"
#include "database/store/score_rows.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

constexpr std::size_t longest_exercise = 40, longest_source = 200, most_product_bytes = 64U << 20U;

[[noreturn]] void refuse_import(const Sentence& wrong, const Sentence& hint) {
    throw StoreError(StoreErrorKind::bad_value, wrong, hint);
}

bool is_exercise_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-' || c == '_';
}

void require_sound(const ExternalAttempt& attempt, std::int64_t now) {
    if (attempt.exercise.empty() || attempt.exercise.size() > longest_exercise ||
        !std::all_of(attempt.exercise.begin(), attempt.exercise.end(), is_exercise_letter))
        refuse_import(
            {QT_TRANSLATE_NOOP("errors", "\"%1\" is not the name of an exercise"), attempt.exercise},
            {QT_TRANSLATE_NOOP("errors",
                               "use 1 to %1 letters, digits, dots, hyphens and underscores: peg-transfer"),
             longest_exercise});
    if (attempt.source.empty() || attempt.source.size() > longest_source)
        refuse_import(
            QT_TRANSLATE_NOOP("errors", "what recorded the trace is not named, or its name is too long"),
            {QT_TRANSLATE_NOOP("errors", "give a name of 1 to %1 characters"), longest_source});
    if (attempt.performed <= 0 || attempt.performed > now)
        refuse_import(QT_TRANSLATE_NOOP("errors", "the attempt is dated in the future, or before 1970"),
                      QT_TRANSLATE_NOOP("errors", "give the date and time at which it was performed"));
    if (!std::isfinite(attempt.duration_s) || attempt.duration_s < 0 || attempt.trace.empty())
        refuse_import(QT_TRANSLATE_NOOP("errors", "the trace has no samples or no duration"),
                      QT_TRANSLATE_NOOP("errors", "import a trace that fulcrum metrics reads"));
    if (attempt.trace.size() > packed_maximum_bytes)
        refuse_import(QT_TRANSLATE_NOOP("errors", "the trace has more than 256 MiB as text"),
                      QT_TRANSLATE_NOOP("errors", "import a part of it, or fewer columns"));
    const ScoreRow& score = attempt.score;
    if (score.passed || score.points || !score.gates.empty() || !score.limits.empty() ||
        !score.critical_errors.empty())
        refuse_import(QT_TRANSLATE_NOOP("errors", "an external attempt is measured, never judged"),
                      QT_TRANSLATE_NOOP("errors", "store its metrics alone"));
}

void require_new(Connection& connection, const ExternalAttempt& attempt) {
    for (const AssetFile& file : attempt.files) {
        if (file.name != external_trace_file) continue;
        Query known(connection,
                    "SELECT a.id FROM attempt a JOIN attempt_asset f ON f.attempt_id = a.id LEFT JOIN "
                    "attempt_void v ON v.attempt_id = a.id WHERE " +
                        belongs_to("a.person_id") +
                        " AND f.file = ? AND f.digest = ? AND v.attempt_id IS NULL");
        known.bind(attempt.person_id).bind(file.name).bind(file.digest);
        if (known.next())
            throw StoreError(
                StoreErrorKind::conflict,
                {QT_TRANSLATE_NOOP("errors", "this trace was imported for this person already: attempt %1"),
                 known.text(0)},
                QT_TRANSLATE_NOOP("errors", "void that attempt first if it is to be imported again"));
    }
}

void insert_external(const Store& store, const std::string& id, const ExternalAttempt& attempt) {
    Query(
        store.connection(),
        "INSERT INTO attempt (id, person_id, station_id, task_id, task_version, mode, device_class, device, "
        "operator_name, variant, seed, fidelity, scene, scene_digest, curriculum, limits, program_version, "
        "cpu_features, started, utc_offset_min, force_devices, state) "
        "VALUES (?, ?, ?, ?, 1, ?, ?, ?, '', '', 0, '', '', '', '', '', ?, '', ?, ?, ?, 'running')")
        .bind(id)
        .bind(attempt.person_id)
        .bind(store.station_id())
        .bind(external_task_prefix + attempt.exercise)
        .bind(row_of(attempt_modes, AttemptMode::practice).name)
        .bind(row_of(device_classes, DeviceClass::external).name)
        .bind(attempt.source)
        .bind(attempt.program_version)
        .bind(attempt.performed)
        .bind(attempt.utc_offset_min)
        .bind(force_devices_text({}))
        .run();
}

}  // namespace

void ExternalAttempts::check_values(const ExternalAttempt& attempt) const {
    require_sound(attempt, store_.now());
}

void ExternalAttempts::check(const Session& session, const ExternalAttempt& attempt) const {
    store_.require(session, Operation::import_attempt, Subject::person(attempt.person_id));
    check_values(attempt);
    require_new(store_.connection(), attempt);
}

std::string ExternalAttempts::add(const Session& session, const ExternalAttempt& attempt) const {
    check(session, attempt);
    const Bytes packed = pack_bytes({attempt.trace.begin(), attempt.trace.end()}, 9);
    if (packed.size() > most_product_bytes)
        refuse_import(QT_TRANSLATE_NOOP("errors", "the trace has more than 64 MiB when it is compressed"),
                      QT_TRANSLATE_NOOP("errors", "import a part of it, or fewer columns"));
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    require_new(connection, attempt);  // nobody else imported it since
    std::string id = random_uuid();
    insert_external(store_, id, attempt);
    for (const AssetFile& file : attempt.files)
        Query(connection, "INSERT INTO attempt_asset (attempt_id, file, digest) VALUES (?, ?, ?)")
            .bind(id)
            .bind(file.name)
            .bind(file.digest)
            .run();
    Query(connection, "INSERT INTO attempt_product (attempt_id, kind, checksum, data) VALUES (?, ?, ?, ?)")
        .bind(id)
        .bind(external_trace_product)
        .bind(blake2b(packed, 16))
        .bind(packed)
        .run();
    Query(connection, "UPDATE attempt SET state = ?, duration_s = ?, events = ? WHERE id = ?")
        .bind(row_of(attempt_states, AttemptState::completed).name)
        .bind(attempt.duration_s)
        .bind(trace_not_kept)
        .bind(id)
        .run();
    Audit(store_).append(session, id, "attempt.import",
                         json_object({{"task", external_task_prefix + attempt.exercise},
                                      {"person", attempt.person_id},
                                      {"source", attempt.source}}),
                         {{RecordKind::attempt, id}, {RecordKind::trace, id}});
    write_score(store_, session, id, attempt.score);
    transaction.commit();
    return id;
}

void no_imported_trace(const std::string& attempt_id) {
    throw StoreError(
        StoreErrorKind::not_found,
        {QT_TRANSLATE_NOOP("errors", "there is no imported trace of attempt %1 in this store"), attempt_id},
        QT_TRANSLATE_NOOP("errors", "open it at the station that imported it"));
}

std::string ExternalAttempts::trace(const Session& session, const std::string& attempt_id) const {
    for (const ProductBlob& product : Attempts(store_).products(session, attempt_id)) {
        if (product.kind != external_trace_product) continue;
        const Bytes plain = unpack_bytes(product.data);
        return {plain.begin(), plain.end()};
    }
    no_imported_trace(attempt_id);
}

}  // namespace fulcrum::database
