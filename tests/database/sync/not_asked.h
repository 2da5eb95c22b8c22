// SPDX-License-Identifier: GPL-3.0-or-later
// The calls of this floor's rooms that take a store and have no row in server_reads.h.
#pragma once

#include <vector>

namespace fulcrum::database::test::reads {

/// Why nobody asks a server, and which calls.
struct NotAsked {
    const char* why;
    std::vector<const char*> names;
};
inline const std::vector<NotAsked>& not_asked() {
    static const std::vector<NotAsked> list = {
        {"writes, which a server's read-only connection does not (Ratings::note_seen: server_store_test.cpp)",
         {"AcceptedAssets::accept",
          "Attempts::add_score",
          "Attempts::reassign",
          "Attempts::request_correction",
          "Attempts::void_attempt",
          "Audit::append",
          "Audit::erase_payloads",
          "Curricula::keep_version",
          "Curricula::move",
          "ErrorReviews::add",
          "ExternalAttempts::add",
          "Goals::change",
          "Goals::drop",
          "Goals::set",
          "PersonMerge::merge",
          "PersonMerge::undo",
          "Ratings::answer",
          "Ratings::begin",
          "Ratings::discard",
          "Ratings::hand_in",
          "Ratings::note_seen",
          "Ratings::release",
          "Reviews::delete_draft",
          "Reviews::edit_draft",
          "Reviews::mark_read",
          "Reviews::send",
          "Reviews::write",
          "RosterImport::bring_cohorts",
          "RosterImport::bring_people",
          "Schedules::add",
          "Schedules::note",
          "Schedules::remove",
          "Standings::decide",
          "Tissues::set",
          "XapiOutbox::add",
          "XapiOutbox::finish",
          "XapiOutbox::postpone",
          "XapiOutbox::quarantine",
          "XapiOutbox::release",
          "add_to_erasure_list",
          "backup_into",
          "enrol_station",
          "erase_at_station",
          "erase_due",
          "erase_listed",
          "erase_person",
          "fetch_trace",
          "place_accepted_assets",
          "publish_benchmark",
          "publish_curriculum",
          "remove_frames_without_attempt",
          "remove_kept_frames",
          "rotate_station_key",
          "set_retention_months",
          "set_site_tissues",
          "sync_with_server"}},
        {"writes accounts and cohorts",
         {"People::change_password", "People::create", "People::create_cohort", "People::create_demo_cohort",
          "People::create_programme", "People::ensure_synthetic", "People::issue_one_time_password",
          "People::recover_administrator", "People::rename", "People::rename_cohort", "People::set_active",
          "People::set_demo_roles", "People::set_educators", "People::set_login", "People::set_members",
          "People::set_roles", "People::set_sign_in_picker"}},
        {"signs in: server_store_test.cpp",
         {"People::account_session", "People::act_as", "People::demo_session", "People::sign_in",
          "People::sign_in_picker", "People::sign_in_wait_s"}},
        {"the administrators' (the audit log, stations, accounts), who have no account at a server",
         {"Audit::entries", "Audit::kinds", "PersonMerge::plan", "RosterImport::plan_cohorts",
          "RosterImport::plan_people", "known_stations", "linked_server"}},
        {"for the check of a store, which a server has as `fulcrum server check`",
         {"Audit::count", "Audit::has_head", "Audit::next_key", "Audit::signer_of", "Audit::verify",
          "quick_check"}},
        {"asked before an attempt, which is performed at a station", {"require_assessed"}},
        {"looks at a trace that is to be imported, which is done at a station",
         {"ExternalAttempts::check", "ExternalAttempts::check_values"}},
        {"says something of this machine, its file or its settings, which are not exchanged",
         {"Ratings::is_blind", "ScheduleLock::held", "Tissues::history", "Tissues::in_force",
          "can_fetch_trace", "has_begun_exchange", "is_enrolled_at", "kept_frames_folder", "load_site_task",
          "owned_by_service_account", "require_whole_programme", "retention_months", "server_of",
          "site_tissues", "station_scope"}},
    };
    return list;
}

}  // namespace fulcrum::database::test::reads
