// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/checked_attempts.h"

#include "database/records/attempt_query.h"
#include "database/store/score_rows.h"

namespace fulcrum::database {
namespace {

void require_check(const Store& store, const Session& session) {
    if (!store.is_server()) store.require(session, Operation::check_store);
}

}  // namespace

CheckableAttempts checkable_attempts(const Store& store, const Session& session,
                                     const std::string& program_version, const std::string& cpu_features) {
    require_check(store, session);
    Query rows(store.connection(),
               "SELECT a.id, a.program_version, a.cpu_features, EXISTS (SELECT 1 FROM attempt_origin o WHERE "
               "o.attempt_id = a.id), a.task_id FROM attempt a WHERE a.state <> 'running' AND a.events <> ? "
               "AND EXISTS (SELECT 1 FROM trace_chunk c WHERE c.attempt_id = a.id AND c.stream = 0) ORDER BY "
               "a.id");
    rows.bind(trace_not_kept);
    CheckableAttempts found;
    while (rows.next()) {
        if (is_external_task(rows.text(4))) continue;  // recorded elsewhere: nothing here can repeat it
        if (rows.text(1) == program_version && rows.text(2) == cpu_features && !rows.flag(3))
            found.ids.push_back(rows.text(0));
        else
            ++found.others;
    }
    return found;
}

CheckedAttempt read_checked_attempt(const Store& store, const Session& session,
                                    const std::string& attempt_id) {
    require_check(store, session);
    CheckedAttempt found{query_attempt(store, attempt_id), stored_scene_text(store, attempt_id),
                         assets_of(store, attempt_id), stored_trace(store, attempt_id), std::nullopt};
    Query row(store.connection(), "SELECT id FROM score WHERE attempt_id = ? AND in_force = 1");
    row.bind(attempt_id);
    if (row.next()) found.score = read_score(store.connection(), row.text(0));
    return found;
}

}  // namespace fulcrum::database
