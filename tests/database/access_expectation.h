// SPDX-License-Identifier: GPL-3.0-or-later
// What the table of roles in docs/MANUAL.md says of roles, operations and scopes, written down once more for
// the tests: store, window and command line are each held against it.
#pragma once

#include <gtest/gtest.h>

#include "database/access/access.h"

namespace fulcrum::database::test {

struct Expected {
    Operation operation;
    const char* scopes;  ///< trainee educator director administrator station: o own, c cohort, p programme, s
                         ///< synthetic, - none
};

// Written from that table, not from the code.
inline const Expected expected_table[] = {
    {Operation::read_sign_in_list, "ppppp"},
    {Operation::list_people, "ocpps"},
    {Operation::manage_people, "---p-"},
    {Operation::manage_roles, "---p-"},
    {Operation::issue_one_time_password, "---p-"},
    {Operation::change_password, "oooo-"},
    {Operation::create_synthetic, "----s"},
    {Operation::list_cohorts, "ocp--"},
    {Operation::manage_cohorts, "--p--"},
    {Operation::perform_attempt, "o---s"},
    {Operation::read_attempt, "ocp-s"},
    {Operation::read_trace, "ocp-s"},
    {Operation::read_progress, "ocp-s"},
    {Operation::read_cohort_table, "-cp--"},
    {Operation::score_interrupted, "oc--s"},
    {Operation::recompute_score, "-c--s"},
    {Operation::comment, "-c---"},
    {Operation::read_comment, "ocp--"},
    {Operation::mark_comment_read, "o----"},
    {Operation::void_attempt, "-c---"},
    {Operation::reassign_attempt, "-c---"},
    {Operation::decide_standing, "-c---"},
    {Operation::request_correction, "o----"},
    {Operation::read_requests, "ocp--"},
    {Operation::export_person, "o-p-s"},
    {Operation::export_cohort, "--p--"},
    {Operation::view_audit, "---p-"},
    {Operation::check_store, "---pp"},
    {Operation::backup, "---p-"},
    {Operation::manage_settings, "---p-"},
    {Operation::read_tissues, "ppp-p"},
    {Operation::set_tissues, "-p---"},
    {Operation::accept_assets, "-p---"},
    {Operation::rate, "-cp--"},
    {Operation::read_ratings, "ocp--"},
    {Operation::release_ratings, "-cp--"},
    {Operation::set_goal, "o----"},
    {Operation::read_goals, "oc---"},
    {Operation::import_attempt, "-c--s"},
    {Operation::rotate_key, "---p-"},
    {Operation::erase_person, "--p--"},
    {Operation::review_error, "-c---"},
    {Operation::export_all, "--p--"},
};

inline Scope scope_of_letter(char letter) {
    switch (letter) {
        case 'o':
            return Scope::own;
        case 'c':
            return Scope::cohort;
        case 'p':
            return Scope::programme;
        case 's':
            return Scope::synthetic;
        default:
            return Scope::none;
    }
}

inline Scope expected_scope(Operation operation, Role role) {
    for (const Expected& row : expected_table) {
        if (row.operation == operation) return scope_of_letter(row.scopes[static_cast<int>(role)]);
    }
    ADD_FAILURE() << "no row for " << operation_name(operation);
    return Scope::none;
}

inline bool covers(Scope scope, const Relation& relation) {
    return scope == Scope::programme || (scope == Scope::own && relation.own) ||
           (scope == Scope::cohort && relation.in_cohort) ||
           (scope == Scope::synthetic && relation.synthetic);
}

/// What nobody does to themselves.
inline bool expected_never_own(Operation operation) {
    return operation == Operation::void_attempt || operation == Operation::reassign_attempt ||
           operation == Operation::decide_standing || operation == Operation::rate ||
           operation == Operation::release_ratings || operation == Operation::import_attempt ||
           operation == Operation::erase_person || operation == Operation::review_error;
}

/// The whole rule: the scope covers the relation, and nobody voids, reassigns or rates their own attempt.
inline bool expected_allowed(Operation operation, Role role, const Relation& relation) {
    return covers(expected_scope(operation, role), relation) &&
           !(expected_never_own(operation) && relation.own);
}

}  // namespace fulcrum::database::test
