// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/access/access.h"

#include <array>

#include "sim_core/numerics/name_table.h"

namespace fulcrum::database {
namespace {

struct Row {
    Operation operation;
    const char* name;
    Scope trainee, educator, director, administrator, station;
    bool never_own;
    bool writes;       ///< so that a sealed demo refuses it
    bool for_servers;  ///< what a programme server is asked through a Store
};

constexpr Scope none = Scope::none, own = Scope::own, cohort = Scope::cohort, programme = Scope::programme,
                synthetic = Scope::synthetic;

// docs/MANUAL.md, "Roles". Administrators run the accounts and the store and see no scores; the station does
// synthetic work only. What a site says of its tissues is no one's data: whoever performs needs it; setting
// it is the educators', as benchmarks and curricula are.
// clang-format off
constexpr std::array<Row, operation_count> table{{
    //                                                                 trainee    educator   director   administrator station   never own writes for servers
    {Operation::read_sign_in_list,       "read_sign_in_list",          programme, programme, programme, programme, programme, false, false, false},
    {Operation::list_people,             "list_people",                own,       cohort,    programme, programme, synthetic, false, false, true},
    {Operation::manage_people,           "manage_people",              none,      none,      none,      programme, none,      false, true,  false},
    {Operation::manage_roles,            "manage_roles",               none,      none,      none,      programme, none,      false, true,  false},
    {Operation::issue_one_time_password, "issue_one_time_password",    none,      none,      none,      programme, none,      false, true,  false},
    {Operation::change_password,         "change_password",            own,       own,       own,       own,       none,      false, true,  false},
    {Operation::create_synthetic,        "create_synthetic",           none,      none,      none,      none,      synthetic, false, true,  false},
    {Operation::list_cohorts,            "list_cohorts",               own,       cohort,    programme, none,      none,      false, false, true},
    {Operation::manage_cohorts,          "manage_cohorts",             none,      none,      programme, none,      none,      false, true,  false},
    {Operation::perform_attempt,         "perform_attempt",            own,       none,      none,      none,      synthetic, false, false, false},
    {Operation::read_attempt,            "read_attempt",               own,       cohort,    programme, none,      synthetic, false, false, true},
    {Operation::read_trace,              "read_trace",                 own,       cohort,    programme, none,      synthetic, false, false, true},
    {Operation::read_progress,           "read_progress",              own,       cohort,    programme, none,      synthetic, false, false, true},
    {Operation::read_cohort_table,       "read_cohort_table",          none,      cohort,    programme, none,      none,      false, false, true},
    {Operation::score_interrupted,       "score_interrupted",          own,       cohort,    none,      none,      synthetic, false, true,  false},
    {Operation::recompute_score,         "recompute_score",            none,      cohort,    none,      none,      synthetic, false, true,  false},
    {Operation::comment,                 "comment",                    none,      cohort,    none,      none,      none,      false, true,  false},
    {Operation::read_comment,            "read_comment",               own,       cohort,    programme, none,      none,      false, false, true},
    {Operation::mark_comment_read,       "mark_comment_read",          own,       none,      none,      none,      none,      false, true,  false},
    {Operation::void_attempt,            "void_attempt",               none,      cohort,    none,      none,      none,      true,  true,  false},
    {Operation::reassign_attempt,        "reassign_attempt",           none,      cohort,    none,      none,      none,      true,  true,  false},
    {Operation::decide_standing,         "decide_standing",            none,      cohort,    none,      none,      none,      true,  true,  false},
    {Operation::request_correction,      "request_correction",         own,       none,      none,      none,      none,      false, true,  false},
    {Operation::read_requests,           "read_requests",              own,       cohort,    programme, none,      none,      false, false, true},
    {Operation::export_person,           "export_person",              own,       none,      programme, none,      synthetic, false, false, true},
    {Operation::export_cohort,           "export_cohort",              none,      none,      programme, none,      none,      false, false, true},
    {Operation::view_audit,              "view_audit",                 none,      none,      none,      programme, none,      false, false, false},
    {Operation::check_store,             "check_store",                none,      none,      none,      programme, programme, false, false, false},
    {Operation::backup,                  "backup",                     none,      none,      none,      programme, none,      false, false, false},
    {Operation::manage_settings,         "manage_settings",            none,      none,      none,      programme, none,      false, true,  false},
    {Operation::read_tissues,            "read_tissues",               programme, programme, programme, none,      programme, false, false, true},
    {Operation::set_tissues,             "set_tissues",                none,      programme, none,      none,      none,      false, true,  false},
    {Operation::accept_assets,           "accept_assets",              none,      programme, none,      none,      none,      false, true,  false},
    {Operation::rate,                    "rate",                       none,      cohort,    programme, none,      none,      true,  true,  false},
    {Operation::read_ratings,            "read_ratings",               own,       cohort,    programme, none,      none,      false, false, true},
    {Operation::release_ratings,         "release_ratings",            none,      cohort,    programme, none,      none,      true,  true,  false},
    {Operation::set_goal,                "set_goal",                   own,       none,      none,      none,      none,      false, true,  false},
    {Operation::read_goals,              "read_goals",                 own,       cohort,    none,      none,      none,      false, false, true},
    {Operation::import_attempt,          "import_attempt",             none,      cohort,    none,      none,      synthetic, true,  true,  false},
    {Operation::rotate_key,              "rotate_key",                 none,      none,      none,      programme, none,      false, true,  false},
    {Operation::erase_person,            "erase_person",               none,      none,      programme, none,      none,      true,  true,  false},
    {Operation::review_error,            "review_error",               none,      cohort,    none,      none,      none,      true,  true,  false},
    {Operation::export_all,              "export_all",                 none,      none,      programme, none,      none,      false, true,  false},
}};
// clang-format on

constexpr bool in_order() {
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (static_cast<std::size_t>(table[i].operation) != i) return false;
    }
    return true;
}
static_assert(in_order(), "the table's rows follow the enumeration");

constexpr bool servers_are_only_read() {
    for (const Row& one : table) {
        if (one.writes && one.for_servers) return false;
    }
    return true;
}
static_assert(servers_are_only_read(), "whoever writes does it at a station");

const Row& row(Operation operation) {
    return table[static_cast<std::size_t>(operation)];
}

}  // namespace

const char* role_name(Role role) {
    switch (role) {
        case Role::trainee:
            return QT_TRANSLATE_NOOP("errors", "trainee");
        case Role::educator:
            return QT_TRANSLATE_NOOP("errors", "educator");
        case Role::director:
            return QT_TRANSLATE_NOOP("errors", "director");
        case Role::administrator:
            return QT_TRANSLATE_NOOP("errors", "administrator");
        case Role::station:
            return QT_TRANSLATE_NOOP("errors", "station");
    }
    return "";
}

bool parse_role(const std::string& name, Role& role) {
    for (const Role candidate : all_roles) {
        if (candidate != Role::station && name == role_name(candidate)) {
            role = candidate;
            return true;
        }
    }
    return false;
}

const char* scope_name(Scope scope) {
    switch (scope) {
        case Scope::none:
            return "none";
        case Scope::own:
            return "own";
        case Scope::cohort:
            return "cohort";
        case Scope::programme:
            return "programme";
        case Scope::synthetic:
            return "synthetic";
    }
    return "";
}

const char* operation_name(Operation operation) {
    return row(operation).name;
}

Scope scope_of(Role role, Operation operation) {
    const Row& entry = row(operation);
    switch (role) {
        case Role::trainee:
            return entry.trainee;
        case Role::educator:
            return entry.educator;
        case Role::director:
            return entry.director;
        case Role::administrator:
            return entry.administrator;
        case Role::station:
            return entry.station;
    }
    return Scope::none;
}

bool never_own(Operation operation) {
    return row(operation).never_own;
}

bool writes_store(Operation operation) {
    return row(operation).writes;
}

bool is_for_servers(Operation operation) {
    return row(operation).for_servers;
}

bool permits(Role role, Operation operation, const Relation& relation) {
    if (never_own(operation) && relation.own) return false;
    switch (scope_of(role, operation)) {
        case Scope::none:
            return false;
        case Scope::own:
            return relation.own;
        case Scope::cohort:
            return relation.in_cohort;
        case Scope::programme:
            return true;
        case Scope::synthetic:
            return relation.synthetic;
    }
    return false;
}

}  // namespace fulcrum::database
