// SPDX-License-Identifier: GPL-3.0-or-later
// For each operation of the access table: the widgets and the commands that perform it. A new operation does
// not compile until it is listed here.
#pragma once

#include <string>
#include <vector>

#include "database/access/access.h"

namespace fulcrum::app::program_test {

using fulcrum::database::Operation;
using fulcrum::database::Role;

/// Widgets of which at least one is visible on some page to everyone who may perform the operation; empty:
/// the window does not offer it.
inline std::vector<const char*> window_places(Operation operation) {
    switch (operation) {
        case Operation::read_sign_in_list:
            return {"pick_person"};
        case Operation::list_people:
            return {"people_table", "filter_person", "cohort_members", "progress_person"};
        case Operation::manage_people:
            return {"add_person", "save_person", "person_login", "toggle_active"};
        case Operation::manage_roles:
            return {"role_educator"};
        case Operation::issue_one_time_password:
            return {"issue_password"};
        case Operation::change_password:
            return {"rail_password"};
        case Operation::create_synthetic:
            return {};  // by the station, with `fulcrum perform`
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
            return {"cohort_grid"};
        case Operation::score_interrupted:
            return {"interrupted_attempt"};
        case Operation::recompute_score:
            return {"recompute_scores"};
        case Operation::comment:
            return {"comment_text"};
        case Operation::review_error:
            return {"review_error_reason"};
        case Operation::read_comment:
            return {"comment_words"};
        case Operation::mark_comment_read:
            return {"unread_comment"};  // opening the comment marks it as read
        case Operation::void_attempt:
            return {"void_attempt"};
        case Operation::reassign_attempt:
            return {"reassign_attempt"};
        case Operation::decide_standing:
            return {"decide_standing"};
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
        case Operation::export_all:
            return {"export_all"};
        case Operation::erase_person:
            return {"erase_person"};
        case Operation::rotate_key:
            return {"change_key"};
        case Operation::manage_settings:
            return {"sign_in_picker"};
        case Operation::read_tissues:
            return {"tissue_table"};
        case Operation::set_tissues:
            return {"save_tissues"};
        case Operation::accept_assets:
            return {"benchmark_build"};
        case Operation::rate:
            return {"rating_begin"};
        case Operation::read_ratings:
            return {"rating_shown"};
        case Operation::release_ratings:
            return {"ratings_release"};
        case Operation::set_goal:
            return {"set_goal"};
        case Operation::read_goals:
            return {"goal_words"};
        case Operation::import_attempt:
            return {};
    }
    return {};
}

/// The reason why the window does not offer an operation that the table allows; null: it offers it.
inline const char* window_leaves_out(Operation operation, Role role) {
    if (role == Role::station && operation != Operation::read_sign_in_list)
        return "before sign-in the window shows only the people who have signed in here";
    if (role == Role::trainee && operation == Operation::list_cohorts)
        return "a trainee's pages show only their own attempts";
    if (role == Role::trainee && operation == Operation::list_people)
        return "a single person needs no selection; the title bar shows the name";
    if (role == Role::trainee && operation == Operation::read_tissues)
        return "a trainee's briefing states that the site has its own values, without the values";
    if (role == Role::educator && operation == Operation::score_interrupted)
        return "scored in the background at the educator's sign-in; it is shown on the trainee's home page";
    return nullptr;
}

/// The commands that perform the operation; empty: no command does.
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
            return {"report --cohort", "research export", "schedule add", "xapi send"};
        case Operation::view_audit:
            return {"db audit"};
        case Operation::check_store:
            return {"db check"};
        case Operation::backup:
            return {"db backup"};
        case Operation::export_all:
            return {"people export"};
        case Operation::erase_person:
            return {"people erase"};
        case Operation::rotate_key:
            return {"db rotate-key"};
        case Operation::read_tissues:
            return {"tissues"};
        case Operation::set_tissues:
            return {"tissues --set"};
        case Operation::accept_assets:
            return {"assets accept"};
        case Operation::import_attempt:
            return {"import"};
        case Operation::manage_people:
            return {"people login", "people merge", "people import"};
        case Operation::manage_cohorts:
            return {"cohort import"};
        case Operation::decide_standing:
            return {"curriculum move"};
        case Operation::read_sign_in_list:
        case Operation::list_people:
        case Operation::manage_roles:
        case Operation::issue_one_time_password:
        case Operation::change_password:
        case Operation::list_cohorts:
        case Operation::read_progress:
        case Operation::read_cohort_table:
        case Operation::comment:
        case Operation::review_error:
        case Operation::read_comment:
        case Operation::mark_comment_read:
        case Operation::void_attempt:
        case Operation::reassign_attempt:
        case Operation::request_correction:
        case Operation::read_requests:
        case Operation::manage_settings:
        case Operation::rate:
        case Operation::read_ratings:
        case Operation::release_ratings:
        case Operation::set_goal:
        case Operation::read_goals:
            return {};
    }
    return {};
}

}  // namespace fulcrum::app::program_test
