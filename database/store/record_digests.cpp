// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/record_digests.h"

#include <cstring>

#include "database/rows/crypto.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum::database {
namespace {

/// The columns are named one by one: a column that a later schema adds is not in the digests of older rows.
/// The first of the statements says whether the record is there.
struct RecordRow {
    RecordKind kind;
    const char* name;
    const char* ids;
    std::vector<const char*> rows;
    /// Of a later schema: in the digest only where it has rows, so that older digests stay as they were.
    const char* later = nullptr;
};

#define FULCRUM_ATTEMPT_COLUMNS                                                                         \
    "id, person_id, station_id, task_id, task_version, mode, device_class, device, operator_name, "     \
    "variant, seed, fidelity, scene, scene_digest, curriculum, limits, program_version, cpu_features, " \
    "started, utc_offset_min, state, duration_s, wall_s, missed_ticks, lost_samples, events, state_hash"
constexpr const char* attempt_assets =
    "SELECT file, digest FROM attempt_asset WHERE attempt_id = ? ORDER BY file";

const std::vector<const char*> attempt_before_origins = {
    "SELECT " FULCRUM_ATTEMPT_COLUMNS
    " FROM attempt WHERE id = ? AND force_devices = '' AND NOT EXISTS (SELECT 1 FROM attempt_origin o WHERE "
    "o.attempt_id = attempt.id)",
    attempt_assets};

const std::vector<RecordRow> record_kinds = {
    {RecordKind::station,
     "station",
     "SELECT id FROM station",
     {"SELECT id, name, created FROM station WHERE id = ?"}},
    {RecordKind::setting,
     "setting",
     "SELECT key FROM setting",
     {"SELECT key, value FROM setting WHERE key = ?"}},
    {RecordKind::programme,
     "programme",
     "SELECT id FROM programme",
     {"SELECT id, name, created, recovery_verifier FROM programme WHERE id = ?"}},
    {RecordKind::person,
     "person",
     "SELECT id FROM person UNION SELECT person_id FROM person_role UNION SELECT person_id FROM "
     "credential",
     {"SELECT id, login, login_key, display_name, kind, active, created, version FROM person WHERE id = "
      "?",
      "SELECT role FROM person_role WHERE person_id = ? ORDER BY role",
      "SELECT verifier, one_time, expires, changed, boot, boot_ms FROM credential WHERE person_id = ?"},
     "SELECT merged_into FROM person WHERE id = ? AND merged_into <> ''"},
    {RecordKind::cohort,
     "cohort",
     "SELECT id FROM cohort",
     {"SELECT id, name, created FROM cohort WHERE id = ?",
      "SELECT person_id FROM cohort_member WHERE cohort_id = ? ORDER BY person_id",
      "SELECT person_id FROM cohort_educator WHERE cohort_id = ? ORDER BY person_id"}},
    {RecordKind::attempt,
     "attempt",
     "SELECT id FROM attempt",
     {"SELECT " FULCRUM_ATTEMPT_COLUMNS ", force_devices FROM attempt WHERE id = ?",
      "SELECT source_id, tick, goal, build, checksum FROM attempt_origin WHERE attempt_id = ?",
      attempt_assets}},
    {RecordKind::trace,
     "trace",
     "SELECT id FROM attempt WHERE state <> 'running' AND (EXISTS (SELECT 1 FROM trace_chunk c WHERE "
     "c.attempt_id = attempt.id) OR EXISTS (SELECT 1 FROM attempt_product p WHERE p.attempt_id = "
     "attempt.id))",
     {"SELECT 1 FROM attempt a WHERE id = ? AND state <> 'running' AND (EXISTS (SELECT 1 FROM "
      "trace_chunk c "
      "WHERE c.attempt_id = a.id) OR EXISTS (SELECT 1 FROM attempt_product p WHERE p.attempt_id = a.id))",
      "SELECT stream, number, first_tick, last_tick, records, checksum FROM trace_chunk WHERE "
      "attempt_id = ? ORDER BY stream, number",
      "SELECT kind, checksum FROM attempt_product WHERE attempt_id = ? ORDER BY kind"}},
    {RecordKind::score,
     "score",
     "SELECT id FROM score",
     {"SELECT id, attempt_id, computed, program_version, limits, in_force, passed, not_scored_because, "
      "points, advice FROM score WHERE id = ?",
      "SELECT number, metric, hand, tissue, kind, value, unit, limit_value, limit_source, z, points, "
      "passed, provisional, not_passed_because FROM gate WHERE score_id = ? ORDER BY number",
      "SELECT number, id, version, hand, tissue, value, absent_because, unit, direction, evidence FROM "
      "metric WHERE score_id = ? ORDER BY number",
      "SELECT number, time_s, kind, hand, tissue, text FROM critical_error WHERE score_id = ? ORDER BY "
      "number",
      "SELECT report FROM pathology WHERE score_id = ?"}},
    {RecordKind::attempt_void,
     "void of attempt",
     "SELECT attempt_id FROM attempt_void",
     {"SELECT attempt_id, person_id, time, reason FROM attempt_void WHERE attempt_id = ?"}},
    {RecordKind::reassignment,
     "reassignment of attempt",
     "SELECT from_id FROM attempt_reassignment",
     {"SELECT from_id, to_id FROM attempt_reassignment WHERE from_id = ?"}},
    {RecordKind::comment,
     "comment",
     "SELECT id FROM comment WHERE sent <> 0",
     {"SELECT id, attempt_id, author_id, time_s, text, created, sent FROM comment WHERE id = ? AND sent "
      "<> 0"}},
    {RecordKind::correction,
     "correction request",
     "SELECT id FROM correction_request",
     {"SELECT id, attempt_id, person_id, text, asked FROM correction_request WHERE id = ?"}},
    {RecordKind::tissues,
     "tissues of task",
     "SELECT task_id || ' ' || version FROM tissue_setting UNION SELECT task_id || ' ' || version FROM "
     "tissue_value",
     {"SELECT task_id, version, person_id, time, reason FROM tissue_setting WHERE task_id || ' ' || "
      "version = ?",
      "SELECT tissue, name, value FROM tissue_value WHERE task_id || ' ' || version = ? ORDER BY tissue, "
      "name"}},
    {RecordKind::decision,
     "decision",
     "SELECT id FROM standing_override",
     {"SELECT id, person_id, task_id, kind, author_id, time, reason FROM standing_override WHERE id = "
      "?"}},
    {RecordKind::asset,
     "accepted file",
     "SELECT digest FROM asset_acceptance",
     {"SELECT digest, file, person_id, time, reason FROM asset_acceptance WHERE digest = ?"}},
    {RecordKind::curriculum_move,
     "move of curriculum",
     "SELECT id FROM curriculum_move",
     {"SELECT id, person_id, curriculum, author_id, time, reason FROM curriculum_move WHERE id = ?"}},
    {RecordKind::rating,
     "rating",
     "SELECT id FROM rating WHERE handed_in <> 0",
     {"SELECT id, attempt_id, rater_id, form, form_digest, blinding, begun, handed_in, remark FROM rating "
      "WHERE id = ? AND handed_in <> 0",
      "SELECT number, item, value FROM rating_item WHERE rating_id = ? ORDER BY number"}},
    {RecordKind::form,
     "form",
     "SELECT DISTINCT form_digest FROM rating WHERE handed_in <> 0",
     {"SELECT f.digest, f.text FROM form_text f WHERE f.digest = ? AND EXISTS (SELECT 1 FROM rating r WHERE "
      "r.form_digest = f.digest AND r.handed_in <> 0)"}},
    {RecordKind::rating_release,
     "release of rating",
     "SELECT rating_id FROM rating_release",
     {"SELECT rating_id, person_id, time FROM rating_release WHERE rating_id = ?"}},
    {RecordKind::goal,
     "goal",
     "SELECT id FROM personal_goal",
     {"SELECT id, person_id, kind, task_id, metric, target, due_day, time FROM personal_goal WHERE id = ?"}},
    {RecordKind::goal_end,
     "end of goal",
     "SELECT goal_id FROM personal_goal_end",
     {"SELECT goal_id, time FROM personal_goal_end WHERE goal_id = ?"}},
    {RecordKind::error_review,
     "error review",
     "SELECT id FROM error_review",
     {"SELECT id, attempt_id, author_id, tick, kind, hand, tissue, detail, verdict, reason, time FROM "
      "error_review WHERE id = ?"}},
    {RecordKind::asset_text,
     "content of accepted file",
     "SELECT digest FROM asset_text",
     {"SELECT digest, text FROM asset_text WHERE digest = ?"}},
};

#undef FULCRUM_ATTEMPT_COLUMNS

const RecordRow& record_row(RecordKind kind) {
    return record_kinds.at(static_cast<std::size_t>(kind));
}

void add_bytes(Bytes& bytes, const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
}

void add_count(Bytes& bytes, std::uint64_t value) {
    for (unsigned shift = 0; shift < 64; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void add_value(Bytes& bytes, const QVariant& value) {
    if (value.isNull()) {
        bytes.push_back('n');
        return;
    }
    switch (value.type()) {
        case QVariant::Double: {
            const double plain = value.toDouble() + 0.0;  // SQLite keeps no sign of zero
            std::uint64_t bits = 0;
            std::memcpy(&bits, &plain, sizeof bits);
            bytes.push_back('d');
            add_count(bytes, bits);
            return;
        }
        case QVariant::Int:
        case QVariant::LongLong:
            bytes.push_back('i');
            add_count(bytes, static_cast<std::uint64_t>(value.toLongLong()));
            return;
        default: {
            const bool blob = value.type() == QVariant::ByteArray;
            const QByteArray text = blob ? value.toByteArray() : value.toString().toUtf8();
            bytes.push_back(blob ? 'b' : 't');
            add_count(bytes, static_cast<std::uint64_t>(text.size()));
            add_bytes(bytes, text.constData(), static_cast<std::size_t>(text.size()));
        }
    }
}

}  // namespace

std::string RecordName::text() const {
    return std::string(record_row(kind).name) + " " + id;
}

std::optional<RecordName> RecordName::of_text(const std::string& text) {
    const RecordRow* best = nullptr;  // "station" and "station key" may begin alike
    std::size_t length = 0;
    for (const RecordRow& row : record_kinds) {
        const std::string start = std::string(row.name) + " ";
        if (text.compare(0, start.size(), start) == 0 && start.size() > length) {
            best = &row;
            length = start.size();
        }
    }
    if (best == nullptr) return std::nullopt;
    return RecordName{best->kind, text.substr(length)};
}

std::vector<RecordName> all_records(Connection& connection) {
    std::vector<RecordName> names;
    RecordDigests digests(connection);
    for (const RecordRow& row : record_kinds)
        for (std::string& id : digests.ids(row.kind)) names.push_back({row.kind, std::move(id)});
    return names;
}

RecordDigests::RecordDigests(Connection& connection) : connection_(connection) {}
RecordDigests::~RecordDigests() = default;

std::string RecordDigests::of(const RecordName& name) {
    const RecordRow& row = record_row(name.kind);
    return digest_of(name.id, row.rows, row.later);
}

std::string RecordDigests::of_before_origins(const RecordName& name) {
    return name.kind == RecordKind::attempt ? digest_of(name.id, attempt_before_origins, nullptr)
                                            : std::string();
}

std::string RecordDigests::digest_of(const std::string& id, const std::vector<const char*>& statements,
                                     const char* later) {
    Bytes bytes;
    bool first = true;
    const auto add_rows_of = [&](const char* sql, bool also_none) {
        std::unique_ptr<Query>& statement = statements_[sql];
        if (!statement) statement = std::make_unique<Query>(connection_, sql);
        Query& rows = statement->again();
        rows.bind(id);
        std::uint64_t count = 0;
        Bytes of_rows;
        while (rows.next()) {
            ++count;
            for (const QVariant& value : rows.row()) add_value(of_rows, value);
        }
        if (count == 0 && !also_none) return false;
        add_count(bytes, count);
        add_bytes(bytes, of_rows.data(), of_rows.size());
        return true;
    };
    for (const char* sql : statements) {
        if (!add_rows_of(sql, !first)) return {};
        first = false;
    }
    if (later != nullptr) add_rows_of(later, false);
    return to_hex(blake2b(bytes));
}

std::vector<std::string> RecordDigests::ids(RecordKind kind) {
    Query rows(connection_, record_row(kind).ids);
    std::vector<std::string> ids;
    while (rows.next()) ids.push_back(rows.text(0));
    return ids;
}

}  // namespace fulcrum::database
