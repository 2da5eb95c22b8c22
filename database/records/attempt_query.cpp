// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/attempt_query.h"

#include "database/rows/enum_column.h"
#include "database/rows/force_devices.h"
#include "database/rows/person_kind.h"
#include "database/rows/same_person.h"

namespace fulcrum::database {
namespace {

struct Column {
    const char* sql;
    bool in_tables;  ///< read also for the tables of a cohort, which have an attempt by the ten thousand
};

/// In the order in which summary_of_row() takes them.
constexpr Column columns[] = {
    {"a.id", true},
    {"p.id", true},
    {"a.task_id", true},
    {"a.task_version", true},
    {"a.mode", true},
    {"a.device_class", true},
    {"a.device", false},
    {"a.operator_name", false},
    {"a.variant", true},
    {"a.seed", false},
    {"a.fidelity", true},
    {"a.scene", false},
    {"a.scene_digest", false},
    {"a.curriculum", true},
    {"a.limits", true},
    {"a.program_version", true},
    {"a.cpu_features", false},
    {"a.started", true},
    {"a.utc_offset_min", true},
    {"a.force_devices", false},
    {"p.login", false},
    {"p.display_name", false},
    {"p.kind", true},
    {"a.state", true},
    {"a.duration_s", true},
    {"a.wall_s", false},
    {"a.missed_ticks", false},
    {"a.lost_samples", false},
    {"a.events", false},
    {"a.state_hash", false},
    {"s.passed", true},
    {"s.points", true},
    {"COALESCE(s.not_scored_because, '')", true},
    {"EXISTS (SELECT 1 FROM gate g WHERE g.score_id = s.id AND g.provisional = 1)", true},
    {"COALESCE(v.reason, '')", false},
    {"COALESCE(w.display_name, '')", false},
    {"COALESCE(v.time, 0)", true},
    {"COALESCE((SELECT from_id FROM attempt_reassignment WHERE to_id = a.id), '')", false},
    {"COALESCE((SELECT to_id FROM attempt_reassignment WHERE from_id = a.id), '')", false},
    {"(SELECT COUNT(*) FROM comment c WHERE c.attempt_id = a.id AND c.sent > 0 AND c.read = 0)", false},
    {"(SELECT COUNT(*) FROM comment c WHERE c.attempt_id = a.id AND c.sent > 0)", false},
    {"COALESCE(o.source_id, '')", false},
    {"COALESCE(o.tick, 0)", false},
    {"COALESCE(o.goal, 0)", false},
    {"COALESCE(o.build, '')", false}};

QString select(bool for_table) {
    QString list;
    for (const Column& column : columns)
        if (column.in_tables || !for_table) list += (list.isEmpty() ? "" : ", ") + QString(column.sql);
    QString sql = "SELECT " + list + " FROM attempt a " + join_owner("a.person_id", "p") +
                  "LEFT JOIN score s ON s.attempt_id = a.id AND s.in_force = 1 "
                  "LEFT JOIN attempt_void v ON v.attempt_id = a.id ";
    if (!for_table)
        sql += "LEFT JOIN attempt_origin o ON o.attempt_id = a.id LEFT JOIN person w ON w.id = v.person_id ";
    return sql;
}

/// Takes the columns one after another; those that were not asked for are empty.
class Fields {
  public:
    Fields(const Query& row, bool for_table) : row_(row), for_table_(for_table) {}
    std::string text() { return take() ? row_.text(column_ - 1) : std::string(); }
    std::int64_t integer() { return take() ? row_.integer(column_ - 1) : 0; }
    bool flag() { return integer() != 0; }
    double real() { return take() ? row_.real(column_ - 1) : 0; }
    std::optional<bool> optional_flag() {
        return take() ? row_.optional_flag(column_ - 1) : std::optional<bool>();
    }
    std::optional<double> optional_real() {
        return take() ? row_.optional_real(column_ - 1) : std::optional<double>();
    }

  private:
    bool take() {
        const bool is_there = !for_table_ || columns[at_].in_tables;
        ++at_;
        if (is_there) ++column_;
        return is_there;
    }
    const Query& row_;
    bool for_table_;
    std::size_t at_ = 0;
    int column_ = 0;
};

AttemptSummary summary_of_row(const Query& row, bool for_table) {
    AttemptSummary attempt;
    Fields fields(row, for_table);
    const auto text = [&] { return fields.text(); };
    const auto integer = [&] { return fields.integer(); };
    AttemptMeta& meta = attempt.meta;
    meta.id = text();
    meta.person_id = text();
    meta.task_id = text();
    meta.task_version = static_cast<int>(integer());
    const auto place = [&](const char* column_name) { return column_name + (" of attempt " + meta.id); };
    meta.mode = enum_of(text(), attempt_modes, place("mode"));
    meta.device_class = enum_of(text(), device_classes, place("device class"));
    meta.device = text();
    meta.operator_name = text();
    meta.variant = text();
    meta.seed = static_cast<std::uint64_t>(integer());
    meta.fidelity = text();
    meta.scene = text();
    meta.scene_digest = text();
    meta.curriculum = text();
    meta.limits = text();
    meta.program_version = text();
    meta.cpu_features = text();
    meta.started = integer();
    meta.utc_offset_min = static_cast<int>(integer());
    const std::string devices = text();
    meta.force_devices = force_devices_of(devices, place("force devices"));
    meta.rig_use = rig_use_of(devices, place("force devices"));
    attempt.person_login = text();
    attempt.person_name = text();
    attempt.synthetic = person_kind_of(text(), meta.person_id) != PersonKind::real;
    attempt.recorded_state = enum_of(text(), attempt_states, place("state"));
    attempt.duration_s = fields.real();
    attempt.wall_s = fields.real();
    attempt.missed_ticks = static_cast<std::uint32_t>(integer());
    attempt.lost_samples = static_cast<std::uint64_t>(integer());
    const std::int64_t events = integer();
    attempt.meta.keep_trace = events != trace_not_kept;
    attempt.events = attempt.meta.keep_trace ? static_cast<std::uint64_t>(events) : 0;
    attempt.state_hash = text();
    attempt.passed = fields.optional_flag();
    attempt.points = fields.optional_real();
    attempt.not_scored_because = statement_of(text());
    attempt.provisional = fields.flag();
    attempt.void_reason = text();
    attempt.voided_by = text();
    attempt.voided_at = integer();
    attempt.reassigned_from = text();
    attempt.reassigned_to = text();
    attempt.unread_comments = static_cast<int>(integer());
    attempt.comments = static_cast<int>(integer());
    AttemptOrigin origin;
    origin.source_id = text();
    origin.tick = static_cast<std::uint32_t>(integer());
    origin.goal = static_cast<int>(integer());
    origin.build = text();
    if (!origin.build.empty()) meta.origin = std::move(origin);
    attempt.state = attempt.voided_at > 0 ? AttemptState::voided : attempt.recorded_state;
    attempt.counting = is_counting(attempt);
    return attempt;
}

}  // namespace

QString visible_people(const Session& session, Operation operation, const QString& column) {
    switch (scope_of(session.role(), operation)) {
        case Scope::programme:
            return "1 = 1";
        case Scope::own:
            return column + " = ?";
        case Scope::cohort:
            return column +
                   " IN (SELECT m.person_id FROM cohort_member m JOIN cohort_educator e ON e.cohort_id = "
                   "m.cohort_id "
                   "WHERE e.person_id = ?)";
        case Scope::synthetic:
            return column + " IN (SELECT id FROM person WHERE kind <> 'real')";
        case Scope::none:
            break;
    }
    return "1 = 0";
}

void bind_visible_people(Query& query, const Session& session, Operation operation) {
    const Scope scope = scope_of(session.role(), operation);
    if (scope == Scope::own || scope == Scope::cohort) query.bind(session.person_id());
}

std::vector<AttemptSummary> query_attempts(const Store& store, const Session& session,
                                           const AttemptFilter& filter) {
    QString sql =
        select(filter.for_table) + "WHERE " + visible_people(session, Operation::read_attempt, "p.id");
    if (!filter.person_id.empty()) sql += " AND " + belongs_to("a.person_id");
    if (!filter.task_id.empty()) sql += " AND a.task_id = ?";
    if (!filter.cohort_id.empty())
        sql += " AND p.id IN (SELECT person_id FROM cohort_member WHERE cohort_id = ?)";
    const bool voided = filter.state == AttemptState::voided;
    if (voided) sql += " AND v.attempt_id IS NOT NULL";
    if (filter.state && !voided) sql += " AND v.attempt_id IS NULL AND a.state = ?";
    if (!filter.include_voided) sql += " AND v.attempt_id IS NULL";
    if (!filter.include_synthetic) sql += " AND p.kind = 'real'";
    sql += " ORDER BY a.started DESC, a.id";
    if (filter.limit >= 0) sql += " LIMIT ?";
    Query rows(store.connection(), sql);
    bind_visible_people(rows, session, Operation::read_attempt);
    if (!filter.person_id.empty()) rows.bind(filter.person_id);
    if (!filter.task_id.empty()) rows.bind(filter.task_id);
    if (!filter.cohort_id.empty()) rows.bind(filter.cohort_id);
    if (filter.state && !voided) rows.bind(std::string(row_of(attempt_states, *filter.state).name));
    if (filter.limit >= 0) rows.bind(filter.limit);
    std::vector<AttemptSummary> attempts;
    while (rows.next()) attempts.push_back(summary_of_row(rows, filter.for_table));
    return attempts;
}

[[noreturn]] void unknown_attempt(const std::string& id) {
    throw StoreError(StoreErrorKind::not_found, {QT_TRANSLATE_NOOP("errors", "no attempt %1"), id},
                     QT_TRANSLATE_NOOP("errors", "list the attempts and name one of them"));
}

std::string person_of(const Store& store, const std::string& attempt_id) {
    Query row(store.connection(), "SELECT " + owner_of("a.person_id") + " FROM attempt a WHERE a.id = ?");
    row.bind(attempt_id);
    if (!row.next()) unknown_attempt(attempt_id);
    return row.text(0);
}

std::string require_attempt(const Store& store, const Session& session, Operation operation,
                            const std::string& attempt_id) {
    std::string person = person_of(store, attempt_id);
    store.require(session, operation, Subject::person(person));
    return person;
}

AttemptSummary query_attempt(const Store& store, const std::string& attempt_id) {
    Query row(store.connection(), select(false) + "WHERE a.id = ?");
    row.bind(attempt_id);
    if (!row.next()) unknown_attempt(attempt_id);
    return summary_of_row(row, false);
}

std::vector<AssetFile> assets_of(const Store& store, const std::string& attempt_id) {
    Query rows(store.connection(),
               "SELECT file, digest FROM attempt_asset WHERE attempt_id = ? ORDER BY file");
    rows.bind(attempt_id);
    std::vector<AssetFile> files;
    while (rows.next()) files.push_back({rows.text(0), rows.text(1)});
    return files;
}

bool is_cut_off(AttemptState state) {
    return state == AttemptState::interrupted || state == AttemptState::failed_simulation;
}

bool is_counting(const AttemptSummary& attempt) {
    if (attempt.meta.mode != AttemptMode::assessed || attempt.voided_at > 0 || !attempt.passed) return false;
    const AttemptState state = attempt.recorded_state;
    if (state == AttemptState::completed || state == AttemptState::abandoned ||
        state == AttemptState::timed_out)
        return true;
    // What was cut off does not count, unless what was recorded failed already.
    return is_cut_off(state) && !*attempt.passed;
}

}  // namespace fulcrum::database
