// SPDX-License-Identifier: GPL-3.0-or-later
// Where each operation of the access table has its place: what stands for it in the window, and the commands
// that do it. A new operation does not compile before it says where it is.
#pragma once

#include <string>
#include <vector>

#include "database/access/access.h"

namespace fulcrum::app::test {

using fulcrum::database::Operation;
using fulcrum::database::Role;

/// Names of what the window shows to those who may do it, any one of them, somewhere on their pages; empty:
/// the window has no place for it.
inline std::vector<const char*> window_places(Operation operation) {
    switch (operation) {
        case Operation::read_sign_in_list:
            return {"pick_person"};
        case Operation::list_people:
            return {"people_table", "filter_person", "cohort_members", "progress_person"};
        case Operation::manage_people:
            return {"add_person", "save_person", "toggle_active"};
        case Operation::manage_roles:
            return {"role_educator"};
        case Operation::issue_one_time_password:
            return {"issue_password"};
        case Operation::change_password:
            return {"rail_password"};
        case Operation::create_synthetic:
            return {};  // the station's, by `fulcrum perform`
        case Operation::list_cohorts:
            return {"filter_cohort", "cohort_choice", "cohort_list"};
        case Operation::manage_cohorts:
            return {"save_cohort"};
        case Operation::perform_attempt:
            return {"briefing_A2"};
        case Operation::read_attempt:
            return {"attempts_table"};
        case Operation::read_trace:
            return {"force_chart"};
        case Operation::read_progress:
            return {"progress_table"};
        case Operation::read_cohort_table:
            return {"cohort_table"};
        case Operation::score_interrupted:
            return {"interrupted_attempt"};
        case Operation::recompute_score:
            return {"recompute_scores"};
        case Operation::comment:
            return {"comment_text"};
        case Operation::read_comment:
            return {"comment_words"};
        case Operation::mark_comment_read:
            return {"unread_comment"};  // opening it marks it
        case Operation::void_attempt:
            return {"void_attempt"};
        case Operation::reassign_attempt:
            return {"reassign_attempt"};
        case Operation::request_correction:
            return {"request_correction"};
        case Operation::read_requests:
            return {"correction_request"};
        case Operation::export_person:
            return {"export_person"};
        case Operation::export_cohort:
            return {"export_cohort"};
        case Operation::view_audit:
            return {"audit_table"};
        case Operation::check_store:
            return {"check_store"};
        case Operation::backup:
            return {"back_up"};
        case Operation::manage_settings:
            return {"sign_in_picker"};
        case Operation::read_tissues:
            return {"tissue_table"};
        case Operation::set_tissues:
            return {"save_tissues"};
    }
    return {};
}

/// Cells that the table allows and the window leaves out, with the reason.
inline const char* window_leaves_out(Operation operation, Role role) {
    if (role == Role::station && operation != Operation::read_sign_in_list)
        return "before anybody signed in the window shows who signed in here, and nothing else";
    if (role == Role::trainee && operation == Operation::list_cohorts)
        return "a trainee's pages are about their own attempts";
    if (role == Role::trainee && operation == Operation::list_people)
        return "of one person there is nothing to choose; their name stands in the title bar";
    if (role == Role::trainee && operation == Operation::read_tissues)
        return "a trainee's briefing says that the site has values of its own, not which";
    if (role == Role::educator && operation == Operation::score_interrupted)
        return "scored in the background at the educator's sign-in; home, where it is told, is the trainee's";
    return nullptr;
}

/// The commands that do it; empty: the command line has no place for it.
inline std::vector<std::string> commands_of(Operation operation) {
    switch (operation) {
        case Operation::create_synthetic:
        case Operation::perform_attempt:
            return {"perform"};
        case Operation::read_attempt:
            return {"benchmark build --experts"};
        case Operation::read_trace:
            return {"replay"};
        case Operation::score_interrupted:
            return {"db score"};
        case Operation::recompute_score:
            return {"db recompute"};
        case Operation::export_person:
            return {"report --person"};
        case Operation::export_cohort:
            return {"report --cohort"};
        case Operation::view_audit:
            return {"db audit"};
        case Operation::check_store:
            return {"db check"};
        case Operation::backup:
            return {"db backup"};
        case Operation::read_tissues:
            return {"tissues"};
        case Operation::set_tissues:
            return {"tissues --set"};
        case Operation::read_sign_in_list:
        case Operation::list_people:
        case Operation::manage_people:
        case Operation::manage_roles:
        case Operation::issue_one_time_password:
        case Operation::change_password:
        case Operation::list_cohorts:
        case Operation::manage_cohorts:
        case Operation::read_progress:
        case Operation::read_cohort_table:
        case Operation::comment:
        case Operation::read_comment:
        case Operation::mark_comment_read:
        case Operation::void_attempt:
        case Operation::reassign_attempt:
        case Operation::request_correction:
        case Operation::read_requests:
        case Operation::manage_settings:
            return {};
    }
    return {};
}

}  // namespace fulcrum::app::test
