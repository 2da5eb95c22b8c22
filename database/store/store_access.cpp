// SPDX-License-Identifier: GPL-3.0-or-later
// Store::allowed and require: the actor's present state, the subject's relation to the actor, then the table.
#include "database/rows/person_kind.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

/// None if the session is still valid; else why not.
DenialReason why_session_ended(const Store& store, const Session& session, Operation operation) {
    if (session.station_id() != store.station_id()) return DenialReason::other_store;
    if (session.is_station()) return DenialReason::none;
    if (session.is_demo() && !store.is_demo()) return DenialReason::demo_people_elsewhere;
    Query person(
        store.connection(),
        "SELECT p.active, EXISTS (SELECT 1 FROM person_role r WHERE r.person_id = p.id AND r.role = ?), "
        "COALESCE((SELECT c.one_time FROM credential c WHERE c.person_id = p.id), 0) FROM person p WHERE "
        "p.id = ?");
    person.bind(role_name(session.role())).bind(session.person_id());
    if (!person.next() || !person.flag(0)) return DenialReason::account_inactive;
    if (!person.flag(1)) return DenialReason::role_withdrawn;
    if (person.flag(2) && operation != Operation::change_password) return DenialReason::one_time_password;
    return DenialReason::none;
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

/// None if allowed; else why not.
DenialReason refusal(const Store& store, const Session& session, Operation operation,
                     const Subject& subject) {
    const DenialReason ended = why_session_ended(store, session, operation);
    if (ended != DenialReason::none) return ended;
    if (scope_of(session.role(), operation) == Scope::none) return DenialReason::not_in_role;
    if (store.is_server() && !is_for_servers(operation)) return DenialReason::server_only_read;
    if (writes_store(operation) && store.is_demo() && read_setting(store.connection(), "demo_sealed") == "1")
        return DenialReason::demo_practice_only;
    if (subject.kind == Subject::Kind::none) return DenialReason::none;
    Relation relation;
    if (!relation_of(store, session, subject, relation)) return DenialReason::outside_people;
    if (permits(session.role(), operation, relation)) return DenialReason::none;
    return never_own(operation) && relation.own ? DenialReason::own_attempt : DenialReason::outside_people;
}

}  // namespace

void require_at_station(const Store& store, const Session& session, Operation operation) {
    store.require(session, operation);
    if (store.is_server())
        throw AccessDenied(operation_name(operation), role_name(session.role()),
                           DenialReason::server_only_read);
}

bool Store::allowed(const Session& session, Operation operation, const Subject& subject) const {
    return refusal(*this, session, operation, subject) == DenialReason::none;
}

void Store::require(const Session& session, Operation operation, const Subject& subject) const {
    const DenialReason why = refusal(*this, session, operation, subject);
    if (why != DenialReason::none)
        throw AccessDenied(operation_name(operation), role_name(session.role()), why);
}

}  // namespace fulcrum::database
