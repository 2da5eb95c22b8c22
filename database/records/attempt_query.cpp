// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/attempt_query.h"

#include <QHash>

#include "database/records/replaced_limits.h"
#include "database/rows/enum_column.h"
#include "database/rows/force_devices.h"
#include "database/rows/person_kind.h"
#include "database/rows/same_person.h"

namespace fulcrum::database {
namespace {

enum class In {
    lists,   ///< of single attempts alone
    tables,  ///< also of the tables of a cohort, which have an attempt by the ten thousand
    /// The same: words and numbers of the program, of which a table has few that differ. There they come as
    /// one text.
    words
};

struct Column {
    const char* sql;
    In in;
};

/// In the order in which summary_of_row() takes them.
constexpr Column columns[] = {
    {"a.id", In::tables},
    {"p.id", In::tables},
    {"a.task_id", In::tables},
    {"a.task_version", In::words},
    {"a.mode", In::words},
    {"a.device_class", In::words},
    {"a.device", In::lists},
    {"a.operator_name", In::lists},
    {"a.variant", In::words},
    {"a.seed", In::lists},
    {"a.fidelity", In::words},
    {"a.scene", In::lists},
    {"a.scene_digest", In::lists},
    {"a.curriculum", In::words},
    {"a.limits", In::words},
    {"a.program_version", In::words},
    {"a.cpu_features", In::lists},
    {"a.started", In::tables},
    {"a.utc_offset_min", In::words},
    {"a.force_devices", In::lists},
    {"a.station_id", In::words},
    {"p.login", In::lists},
    {"p.display_name", In::lists},
    {"p.kind", In::words},
    {"a.state", In::words},
    {"a.duration_s", In::tables},
    {"a.wall_s", In::lists},
    {"a.missed_ticks", In::lists},
    {"a.lost_samples", In::lists},
    {"a.events", In::lists},
    {"a.state_hash", In::lists},
    {"s.passed", In::tables},
    {"s.points", In::tables},
    {"COALESCE(s.not_scored_because, '')", In::tables},
    // 1: by provisional limits; 2: failed without a set of limits, also where the task's own are provisional;
    // 3: the set was replaced before an attempt that had been cut off was scored, and the score does not have
    // that it was provisional (ReplacedLimits).
    {"CASE WHEN s.passed = 0 AND NOT EXISTS (SELECT 1 FROM gate g WHERE g.score_id = s.id "
     "AND g.kind = 'benchmark' AND g.limit_value IS NOT NULL) "
     "AND EXISTS (SELECT 1 FROM gate g WHERE g.score_id = s.id AND g.kind = 'benchmark') "
     "THEN CASE WHEN NOT EXISTS (SELECT 1 FROM gate g WHERE g.score_id = s.id "
     "AND g.not_passed_because LIKE '%\"gate.limits_replaced\"%') THEN 2 "
     "WHEN EXISTS (SELECT 1 FROM gate g WHERE g.score_id = s.id AND g.kind = 'benchmark' AND g.provisional = "
     "1) THEN 1 ELSE 3 END "
     "WHEN EXISTS (SELECT 1 FROM gate g WHERE g.score_id = s.id AND g.provisional = 1) THEN 1 ELSE 0 END",
     In::tables},
    {"COALESCE(v.reason, '')", In::lists},
    {"COALESCE(w.display_name, '')", In::lists},
    {"COALESCE(v.time, 0)", In::tables},
    {"COALESCE((SELECT from_id FROM attempt_reassignment WHERE to_id = a.id), '')", In::lists},
    {"COALESCE((SELECT to_id FROM attempt_reassignment WHERE from_id = a.id), '')", In::lists},
    {"(SELECT COUNT(*) FROM comment c WHERE c.attempt_id = a.id AND c.sent > 0 AND c.read = 0)", In::lists},
    {"(SELECT COUNT(*) FROM comment c WHERE c.attempt_id = a.id AND c.sent > 0)", In::lists},
    // Tables have of an origin that there is one. It is asked of practice alone.
    {"CASE WHEN a.mode <> 'practice' THEN 0 WHEN EXISTS (SELECT 1 FROM attempt_origin b WHERE b.attempt_id = "
     "a.id) THEN 1 ELSE 0 END",
     In::tables},
    {"COALESCE(o.source_id, '')", In::lists},
    {"COALESCE(o.tick, 0)", In::lists},
    {"COALESCE(o.goal, 0)", In::lists},
    {"COALESCE(o.build, '')", In::lists}};

constexpr char between_words = '\x1f';  // in none of them

QString select(bool for_table) {
    QString list, words;
    for (const Column& column : columns) {
        const bool packed = for_table && column.in == In::words;
        if (for_table && column.in == In::lists) continue;
        QString& to = packed ? words : list;
        if (!to.isEmpty())
            to += packed ? QString(" || '%1' || ").arg(QLatin1Char(between_words)) : QString(", ");
        to += column.sql;
    }
    if (for_table) list = words + ", " + list;
    QString sql = "SELECT " + list + " FROM attempt a " + join_owner("a.person_id", "p") +
                  "LEFT JOIN score s ON s.attempt_id = a.id AND s.in_force = 1 "
                  "LEFT JOIN attempt_void v ON v.attempt_id = a.id ";
    if (!for_table)
        sql += "LEFT JOIN attempt_origin o ON o.attempt_id = a.id LEFT JOIN person w ON w.id = v.person_id ";
    return sql;
}

constexpr std::size_t word_count() {
    std::size_t count = 0;
    for (const Column& column : columns) count += column.in == In::words ? 1 : 0;
    return count;
}

/// The texts in which the words of a table's rows come, each taken apart once.
class PackedWords {
  public:
    const std::vector<std::string>& of(const Query& row) {
        const QString text = row.row().front().toString();
        const auto known = known_.find(text);
        if (known != known_.end()) return *known;
        std::vector<std::string> words;
        for (const QString& word : text.split(QLatin1Char(between_words)))
            words.push_back(word.toStdString());
        if (words.size() != word_count())
            throw StoreError(
                StoreErrorKind::corrupt,
                {QT_TRANSLATE_NOOP("errors", "a word in a row of table %1 has a control character"),
                 "attempt"},
                QT_TRANSLATE_NOOP("errors", "run `fulcrum db check`, or restore the newest backup"));
        return *known_.insert(text, std::move(words));
    }

  private:
    QHash<QString, std::vector<std::string>> known_;
};

/// Takes the columns one after another; those that were not asked for are empty.
class Fields {
  public:
    /// `words`: those of a table's row; null: every column is there.
    Fields(const Query& row, const std::vector<std::string>* words)
        : row_(row), words_(words), column_(words != nullptr ? 1 : 0) {}
    std::string text() {
        const Column& column = columns[at_++];
        if (words_ != nullptr && column.in == In::words) return words_->at(word_++);
        return is_there(column) ? row_.text(column_++) : std::string();
    }
    std::int64_t integer() {
        const Column& column = columns[at_++];
        if (words_ != nullptr && column.in == In::words) return std::stoll(words_->at(word_++));
        return is_there(column) ? row_.integer(column_++) : 0;
    }
    bool flag() { return integer() != 0; }
    double real() { return is_there(columns[at_++]) ? row_.real(column_++) : 0; }
    std::optional<bool> optional_flag() {
        return is_there(columns[at_++]) ? row_.optional_flag(column_++) : std::optional<bool>();
    }
    std::optional<double> optional_real() {
        return is_there(columns[at_++]) ? row_.optional_real(column_++) : std::optional<double>();
    }

  private:
    bool is_there(const Column& column) const { return words_ == nullptr || column.in == In::tables; }
    const Query& row_;
    const std::vector<std::string>* words_;
    std::size_t at_ = 0, word_ = 0;
    int column_;
};

/// `replaced`: ReplacedLimits is to decide what it is judged by. Not asked here: another statement would run
/// between the rows of this one.
AttemptSummary summary_of_row(const Query& row, bool& replaced,
                              const std::vector<std::string>* words = nullptr) {
    AttemptSummary attempt;
    Fields fields(row, words);
    const auto text = [&] { return fields.text(); };
    const auto integer = [&] { return fields.integer(); };
    AttemptMeta& meta = attempt.meta;
    meta.id = text();
    meta.person_id = text();
    meta.task_id = text();
    meta.task_version = static_cast<int>(integer());
    const auto place = [&meta](const char* column_name) {
        return [&meta, column_name] { return column_name + (" of attempt " + meta.id); };
    };
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
    meta.force_devices = force_devices_of(devices, place("force devices")());
    meta.rig_use = rig_use_of(devices, place("force devices")());
    attempt.station_id = text();
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
    const std::int64_t judged_by = integer();
    attempt.provisional = judged_by == 1;
    attempt.without_limits = judged_by == 2;
    replaced = judged_by == 3;
    attempt.void_reason = text();
    attempt.voided_by = text();
    attempt.voided_at = integer();
    attempt.reassigned_from = text();
    attempt.reassigned_to = text();
    attempt.unread_comments = static_cast<int>(integer());
    attempt.comments = static_cast<int>(integer());
    const bool continues = fields.flag();
    AttemptOrigin origin;
    origin.source_id = text();
    origin.tick = static_cast<std::uint32_t>(integer());
    origin.goal = static_cast<int>(integer());
    origin.build = text();
    if (continues) meta.origin = std::move(origin);
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

namespace {

/// `order`: what follows the conditions.
Query attempts_query(const Store& store, const Session& session, const AttemptFilter& filter,
                     const char* order) {
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
    Query rows(store.connection(), sql + order);
    bind_visible_people(rows, session, Operation::read_attempt);
    if (!filter.person_id.empty()) rows.bind(filter.person_id);
    if (!filter.task_id.empty()) rows.bind(filter.task_id);
    if (!filter.cohort_id.empty()) rows.bind(filter.cohort_id);
    if (filter.state && !voided) rows.bind(std::string(row_of(attempt_states, *filter.state).name));
    return rows;
}

template <typename Visit>
void each_row(Query& rows, const AttemptFilter& filter, const Visit& visit) {
    PackedWords words;
    while (rows.next()) {
        bool replaced = false;
        AttemptSummary attempt = summary_of_row(rows, replaced, filter.for_table ? &words.of(rows) : nullptr);
        visit(std::move(attempt), replaced);
    }
}

}  // namespace

std::vector<AttemptSummary> query_attempts(const Store& store, const Session& session,
                                           const AttemptFilter& filter) {
    const bool limited = filter.limit >= 0;
    Query rows =
        attempts_query(store, session, filter,
                       limited ? " ORDER BY a.started DESC, a.id LIMIT ?" : " ORDER BY a.started DESC, a.id");
    if (limited) rows.bind(filter.limit);
    std::vector<AttemptSummary> attempts;
    std::vector<std::size_t> undecided;
    each_row(rows, filter, [&](AttemptSummary&& attempt, bool replaced) {
        if (replaced) undecided.push_back(attempts.size());
        attempts.push_back(std::move(attempt));
    });
    ReplacedLimits limits(store.connection());
    for (const std::size_t i : undecided) limits.decide(attempts[i]);
    return attempts;
}

void for_each_attempt(const Store& store, const Session& session, const AttemptFilter& filter,
                      const std::function<void(AttemptSummary&&)>& visit) {
    Query rows = attempts_query(store, session, filter, "");
    std::vector<AttemptSummary> undecided;
    each_row(rows, filter, [&](AttemptSummary&& attempt, bool replaced) {
        if (replaced)
            undecided.push_back(std::move(attempt));
        else
            visit(std::move(attempt));
    });
    ReplacedLimits limits(store.connection());
    for (AttemptSummary& attempt : undecided) {
        limits.decide(attempt);
        visit(std::move(attempt));
    }
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
    bool replaced = false;
    AttemptSummary attempt = summary_of_row(row, replaced);
    if (replaced) ReplacedLimits(store.connection()).decide(attempt);
    return attempt;
}

std::set<std::string> copies_among(const Store& store, const QString& whose, const std::string& value) {
    // Both lists are short and read once; to look each attempt up would cost more, most at a server, whose
    // row policies look at each row that is read.
    Query rows(
        store.connection(),
        "SELECT a.id FROM attempt a WHERE " + whose +
            " AND (a.id IN (SELECT to_id FROM attempt_reassignment) OR a.id IN (SELECT attempt_id FROM "
            "attempt_asset WHERE file = " FULCRUM_COPIED_FROM "))");
    rows.bind(value);
    std::set<std::string> copies;
    while (rows.next()) copies.insert(rows.text(0));
    return copies;
}

std::vector<AssetFile> assets_of(const Store& store, const std::string& attempt_id) {
    Query rows(store.connection(),
               "SELECT file, digest FROM attempt_asset WHERE attempt_id = ? AND file <> " FULCRUM_COPIED_FROM
               " ORDER BY file");
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
