// SPDX-License-Identifier: GPL-3.0-or-later
// Which scores are based on metrics or limits that are no longer in force.
#include "database/records/attempt_query.h"
#include "database/rows/enum_column.h"
#include "database/rows/same_person.h"

namespace fulcrum::database {
namespace {

void add(std::string& list, const std::string& line) {
    list += (list.empty() ? "" : "; ") + line;
}

std::string in_words(int version) {
    return version == 0 ? "none" : std::to_string(version);
}

/// Empty if the score is based on what is in force.
std::string why_stale(Connection& connection, const std::string& score_id, const std::string& limits,
                      const std::string& limits_now, const ScoringInForce& now) {
    std::string why;
    Query rows(connection, "SELECT DISTINCT id, version FROM metric WHERE score_id = ? ORDER BY id, version");
    rows.bind(score_id);
    while (rows.next()) {
        const auto found = now.metric_versions.find(rows.text(0));
        const int known = found == now.metric_versions.end() ? 0 : found->second;
        if (rows.integer(1) != known)
            add(why, rows.text(0) + " " + rows.text(1) + ", now " + in_words(known));
    }
    if (limits != limits_now)
        add(why, "limits " + (limits.empty() ? "none" : limits) + ", now " +
                     (limits_now.empty() ? "none" : limits_now));
    return why;
}

}  // namespace

std::vector<StaleScore> Attempts::stale_scores(const Session& session, const ScoringInForce& now,
                                               const std::string& person_id) const {
    if (person_id.empty()) {
        store_.require(session, Operation::recompute_score);
    } else {
        store_.require(session, Operation::recompute_score, Subject::person(person_id));
    }
    QString sql =
        "SELECT a.id, p.id, p.display_name, a.task_id, s.id, s.limits, s.in_force, s.passed, "
        "a.variant, a.device_class, a.fidelity FROM attempt a " +
        join_owner("a.person_id", "p") +
        "JOIN score s ON s.attempt_id = a.id "
        "LEFT JOIN attempt_void v ON v.attempt_id = a.id "
        "WHERE v.attempt_id IS NULL AND a.state <> 'running' AND " +
        has_trace_here("a") + " AND " + visible_people(session, Operation::recompute_score, "p.id");
    if (!person_id.empty()) sql += " AND " + belongs_to("a.person_id");
    Query rows(store_.connection(), sql + " ORDER BY a.started, a.id, s.in_force DESC, s.computed, s.id");
    bind_visible_people(rows, session, Operation::recompute_score);
    if (!person_id.empty()) rows.bind(person_id);
    std::vector<StaleScore> stale;
    std::string attempt;
    bool current = false;  // one score of this attempt is based on what is in force
    while (rows.next()) {
        const bool next_attempt = rows.text(0) != attempt;
        if (!next_attempt && current) continue;
        AttemptMeta meta;
        meta.task_id = rows.text(3);
        meta.variant = rows.text(8);
        meta.device_class = enum_of(rows.text(9), device_classes, "device class of attempt " + rows.text(0));
        meta.fidelity = rows.text(10);
        const std::string why =
            why_stale(store_.connection(), rows.text(4), rows.text(5), now.limits(meta), now);
        current = why.empty();
        if (current && !next_attempt) stale.pop_back();
        if (!current && next_attempt)
            stale.push_back({rows.text(0), rows.text(1), rows.text(2), rows.text(3), why, {}});
        if (!current) stale.back().why = why;  // of the newest, which comes last
        if (!current && rows.flag(6)) stale.back().passed = rows.optional_flag(7);
        attempt = rows.text(0);
    }
    return stale;
}

}  // namespace fulcrum::database
