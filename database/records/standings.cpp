// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/standings.h"

#include "database/records/attempt_query.h"
#include "database/records/cohort_standings.h"
#include "database/records/curricula.h"
#include "database/records/limits_in_force.h"
#include "database/records/ratings.h"
#include "database/rows/crypto.h"
#include "database/store/audit.h"
#include "database/store/override_rows.h"

namespace fulcrum::database {
namespace {

/// As is_counting(), but also what was voided: until then it counted.
bool counted_once(AttemptSummary attempt) {
    attempt.voided_at = 0;
    return is_counting(attempt);
}

/// Refuses a decision that changes nothing: it would be kept and audited as if it did.
void require_effect(const Store& store, const Session& educator, const std::string& person_id,
                    const StandingOverride& decision, const Curriculum& newest) {
    Curricula(store).require_here(educator, person_id, newest);
    const PersonRecord record = Standings(store).record(educator, person_id, newest);
    const Curriculum& followed = *curriculum_at(record.assignments, decision.time);
    if (followed.find(decision.task) == nullptr)
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "%1 is not a task of the curriculum %2, which the person follows"),
             decision.task, followed.name()},
            QT_TRANSLATE_NOOP(
                "errors", "name one of its tasks, or move the person to a version that has this one first"));
    if (effect_of(record, decision) != DecisionEffect::none) return;
    if (decision.kind == StandingOverride::Kind::unlocked)
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "the decision would change nothing: %1 is not locked"),
             decision.task},
            QT_TRANSLATE_NOOP("errors",
                              "nothing has to be decided: the person can perform assessed attempts of it"));
    throw StoreError(StoreErrorKind::bad_value,
                     {QT_TRANSLATE_NOOP("errors",
                                        "the decision would change nothing: the person is proficient in %1, "
                                        "and no check is due"),
                      decision.task},
                     QT_TRANSLATE_NOOP("errors", "decide again when the next check is due"));
}

}  // namespace

PersonRecord Standings::record(const Session& session, const std::string& person_id,
                               const Curriculum& curriculum, bool with_limits) const {
    store_.require(session, Operation::read_progress, Subject::person(person_id));
    PersonRecord record;
    record.assignments = Curricula(store_).assignments(session, person_id, curriculum);
    AttemptFilter filter;
    filter.person_id = person_id;
    filter.limit = -1;
    const std::int64_t now = store_.now();
    for (const AttemptSummary& attempt : query_attempts(store_, session, filter)) {
        if (!counted_once(attempt)) continue;
        record.attempts.push_back(counted_attempt(attempt));
        // A void of a station whose clock is ahead counts from its arrival, as in lists and reports.
        CountedAttempt& counted = record.attempts.back();
        if (counted.voided_at > now) counted.voided_at = counted.time;
    }
    for (const OverrideRow& row : overrides(session, person_id))
        if (!row.own) record.overrides.push_back(row.decision);
    if (asks_for_ratings(curriculum)) record.ratings = released_ratings(store_.connection(), person_id);
    if (with_limits) record.limits = limits_put_in_force(store_.connection());
    return record;
}

std::vector<OverrideRow> Standings::overrides(const Session& session, const std::string& person_id) const {
    store_.require(session, Operation::read_progress, Subject::person(person_id));
    return read_overrides(store_.connection(), person_id);
}

std::string Standings::decide(const Session& educator, const std::string& person_id,
                              const std::string& task_id, StandingOverride::Kind kind,
                              const std::string& reason, const Curriculum* newest) const {
    store_.require(educator, Operation::decide_standing, Subject::person(person_id));
    if (reason.find_first_not_of(" \t\r\n") == std::string::npos || reason.size() > 4000)
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a reason is missing or too long"),
                         QT_TRANSLATE_NOOP("errors", "give a reason of 1 to 4,000 characters"));
    if (task_id.empty())
        throw StoreError(StoreErrorKind::bad_value, QT_TRANSLATE_NOOP("errors", "no task was named"),
                         QT_TRANSLATE_NOOP("errors", "name a task of the curriculum"));
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    OverrideRow row;
    row.decision = {random_uuid(), task_id, kind, store_.now()};
    if (newest != nullptr) {
        // Within the transaction: the same may have been decided since the page was filled.
        require_effect(store_, educator, person_id, row.decision, *newest);
        // First: what is decided is decided under the version that is kept.
        Curricula(store_).keep_version(educator, person_id, *newest, row.decision.id, reason);
    }
    row.person_id = person_id;
    row.author_id = educator.person_id();
    row.reason = reason;
    write_override(connection, row);
    Audit(store_).append(educator, row.decision.id, "standing.decide", override_payload(row),
                         {{RecordKind::decision, row.decision.id}});
    transaction.commit();
    return row.decision.id;
}

}  // namespace fulcrum::database
