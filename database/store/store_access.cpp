// SPDX-License-Identifier: GPL-3.0-or-later
// Store::allowed and require: the actor's present state, the subject's relation to the actor, then the table.
#include "database/rows/person_kind.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

/// What a sealed demo store still takes is practice (the recorder checks the mode).
bool writes(Operation operation) {
    switch (operation) {
        case Operation::manage_people:
        case Operation::manage_roles:
        case Operation::issue_one_time_password:
        case Operation::change_password:
        case Operation::create_synthetic:
        case Operation::manage_cohorts:
        case Operation::score_interrupted:
        case Operation::recompute_score:
        case Operation::comment:
        case Operation::mark_comment_read:
        case Operation::void_attempt:
        case Operation::reassign_attempt:
        case Operation::decide_standing:
        case Operation::request_correction:
        case Operation::manage_settings:
        case Operation::set_tissues:
        case Operation::accept_assets:
        case Operation::set_goal:
        case Operation::rate:
        case Operation::release_ratings:
        case Operation::import_attempt:
        case Operation::rotate_key:
        case Operation::erase_person:
        case Operation::review_error:
        case Operation::export_all:
            return true;
        default:
            return false;
    }
}

/// What a programme server is asked through a Store. Whoever wants to write does it at a station, and what
/// concerns the server itself is the business of `fulcrum server`.
bool is_for_servers(Operation operation) {
    switch (operation) {
        case Operation::list_people:
        case Operation::list_cohorts:
        case Operation::read_attempt:
        case Operation::read_trace:
        case Operation::read_progress:
        case Operation::read_cohort_table:
        case Operation::read_comment:
        case Operation::read_requests:
        case Operation::export_person:
        case Operation::export_cohort:
        case Operation::read_tissues:
        case Operation::read_ratings:
        case Operation::read_goals:
            return true;
        default:
            return false;
    }
}

/// Empty if the session is still valid; else why not.
Sentence why_session_ended(const Store& store, const Session& session, Operation operation) {
    if (session.station_id() != store.station_id())
        return QT_TRANSLATE_NOOP("errors", "signed in to another store");
    if (session.is_station()) return {};
    if (session.is_demo() && !store.is_demo())
        return QT_TRANSLATE_NOOP("errors", "demo people exist in the demo store only");
    Query person(
        store.connection(),
        "SELECT p.active, EXISTS (SELECT 1 FROM person_role r WHERE r.person_id = p.id AND r.role = ?), "
        "COALESCE((SELECT c.one_time FROM credential c WHERE c.person_id = p.id), 0) FROM person p WHERE "
        "p.id = ?");
    person.bind(role_name(session.role())).bind(session.person_id());
    if (!person.next() || !person.flag(0))
        return QT_TRANSLATE_NOOP("errors", "the account is no longer active");
    if (!person.flag(1)) return QT_TRANSLATE_NOOP("errors", "the role was withdrawn");
    if (person.flag(2) && operation != Operation::change_password)
        return QT_TRANSLATE_NOOP("errors", "the one-time password must be changed first");
    return {};
}

bool relation_of(const Store& store, const Session& session, const Subject& subject, Relation& relation) {
    Connection& connection = store.connection();
    if (subject.kind == Subject::Kind::person) {
        Query row(connection,
                  "SELECT p.kind, EXISTS (SELECT 1 FROM cohort_member m JOIN cohort_educator e ON "
                  "e.cohort_id = m.cohort_id "
                  "WHERE m.person_id = p.id AND e.person_id = ?) FROM person p WHERE p.id = ?");
        row.bind(session.person_id()).bind(subject.id);
        if (!row.next()) return false;
        relation.synthetic = person_kind_of(row.text(0), subject.id) != PersonKind::real;
        relation.in_cohort = row.flag(1);
        relation.own = !session.is_station() && subject.id == session.person_id();
        return true;
    }
    Query row(connection,
              "SELECT EXISTS (SELECT 1 FROM cohort_educator WHERE cohort_id = c.id AND person_id = ?), "
              "EXISTS (SELECT 1 FROM cohort_member WHERE cohort_id = c.id AND person_id = ?) FROM cohort c "
              "WHERE c.id = ?");
    row.bind(session.person_id()).bind(session.person_id()).bind(subject.id);
    if (!row.next()) return false;
    relation.in_cohort = row.flag(0);
    relation.own = row.flag(1);
    return true;
}

/// Empty if allowed; else why not.
Sentence refusal(const Store& store, const Session& session, Operation operation, const Subject& subject) {
    Sentence ended = why_session_ended(store, session, operation);
    if (!ended.empty()) return ended;
    if (scope_of(session.role(), operation) == Scope::none)
        return QT_TRANSLATE_NOOP("errors", "not in this role");
    if (store.is_server() && !is_for_servers(operation))
        return QT_TRANSLATE_NOOP("errors",
                                 "the programme server is only read here; do it at a station, with its own "
                                 "store");
    if (writes(operation) && store.is_demo() && read_setting(store.connection(), "demo_sealed") == "1") {
        return QT_TRANSLATE_NOOP("errors", "the demo takes practice attempts only");
    }
    if (subject.kind == Subject::Kind::none) return {};
    Relation relation;
    if (!relation_of(store, session, subject, relation))
        return QT_TRANSLATE_NOOP("errors", "outside this role's people");
    if (permits(session.role(), operation, relation)) return {};
    if (never_own(operation) && relation.own)
        return QT_TRANSLATE_NOOP("errors", "not allowed on one's own attempt");
    return QT_TRANSLATE_NOOP("errors", "outside this role's people");
}

}  // namespace

bool Store::allowed(const Session& session, Operation operation, const Subject& subject) const {
    return refusal(*this, session, operation, subject).empty();
}

void Store::require(const Session& session, Operation operation, const Subject& subject) const {
    const Sentence why = refusal(*this, session, operation, subject);
    if (!why.empty()) throw AccessDenied(operation_name(operation), role_name(session.role()), why);
}

}  // namespace fulcrum::database
