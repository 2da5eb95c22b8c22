// SPDX-License-Identifier: GPL-3.0-or-later
// Who may do what to whom: one operation x role x scope table (docs/MANUAL.md), asked by every store method
// and by the window to decide what to show. The window's look is a courtesy; the store's check is the rule.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum::database {

/// Stored by name. `station` is no person's role: it is the command line without --as, and the program before
/// anyone signed in.
enum class Role : std::uint8_t { trainee, educator, director, administrator, station };
inline constexpr Role all_roles[] = {Role::trainee, Role::educator, Role::director, Role::administrator,
                                     Role::station};
const char* role_name(Role role);
/// False if `name` is no person's role.
bool parse_role(const std::string& name, Role& role);

enum class Scope : std::uint8_t {
    none,
    own,        ///< the actor's own data
    cohort,     ///< people of the cohorts assigned to the actor as educator, or those cohorts
    programme,  ///< everyone
    synthetic,  ///< people marked synthetic or external only
};
const char* scope_name(Scope scope);

enum class Operation : std::uint8_t {
    read_sign_in_list,  ///< who signed in here in the last 30 days
    list_people,        ///< logins, names, roles; no scores
    manage_people,      ///< create, rename, deactivate accounts
    manage_roles,       ///< grant and withdraw roles
    issue_one_time_password,
    change_password,   ///< one's own
    create_synthetic,  ///< people marked synthetic or external
    list_cohorts,      ///< names, members
    manage_cohorts,    ///< create, rename, assign members and educators
    perform_attempt,
    read_attempt,  ///< summaries, scores, gates, metrics
    read_trace,    ///< samples, events, replay
    read_progress,
    read_cohort_table,
    score_interrupted,  ///< the first score of an attempt that was interrupted
    recompute_score,    ///< adds a row next to the one in force
    comment,            ///< write and send
    read_comment,
    mark_comment_read,
    void_attempt,        ///< never one's own
    reassign_attempt,    ///< never one's own, nor to oneself
    decide_standing,     ///< unlock a task or declare someone proficient; never oneself
    request_correction,  ///< ask an educator to void or reassign
    read_requests,       ///< the corrections asked for
    export_person,       ///< reports of one person
    export_cohort,
    view_audit,
    check_store,  ///< integrity, checksums, audit chain; reads no personal data
    backup,
    manage_settings,  ///< programme name, sign-in picker on or off
    read_tissues,     ///< what the site says of a task's tissues
    set_tissues,
    accept_assets,    ///< scenes, tasks, benchmark sets and curricula of the site for assessed attempts
    rate,             ///< fill in and hand in an observer form; never of one's own attempt
    read_ratings,     ///< forms that were handed in; trainees: those that were released
    release_ratings,  ///< show the trainee the forms that were handed in; never of one's own attempt
    set_goal,         ///< set, change or drop a personal goal
    read_goals,
    import_attempt,  ///< store a trace that was recorded elsewhere; never one's own
    rotate_key,      ///< the station signs with a new key from then on
    erase_person,    ///< delete all that is stored of a person; never oneself
    review_error,    ///< confirm or strike an error that the program recorded; never one of one's own
    export_all,      ///< a copy of all that is stored about a person, for that person
};
inline constexpr int operation_count = 43;
const char* operation_name(Operation operation);

/// The relation of an operation's subject to the actor.
struct Relation {
    bool own = false;        ///< the subject is the actor
    bool in_cohort = false;  ///< the subject is, or is in, a cohort assigned to the actor as educator
    bool synthetic = false;  ///< the subject is marked synthetic or external
};

/// The table.
Scope scope_of(Role role, Operation operation);
/// True for operations that nobody may do to their own attempt, whatever the scope.
bool never_own(Operation operation);
/// What a sealed demo store still takes is practice (the recorder checks the mode): it refuses these.
bool writes_store(Operation operation);
/// What a programme server is asked through a Store. Whoever wants to write does it at a station, and what
/// concerns the server itself is the business of `fulcrum server`.
bool is_for_servers(Operation operation);
/// The rule: the scope covers the relation and never_own is respected. Pure.
bool permits(Role role, Operation operation, const Relation& relation);

/// What an operation is about. Programme-wide operations (backup, audit) have no subject. Without a subject
/// an operation of narrower scope is allowed if the role may do it at all; the call then leaves out, or
/// refuses, what lies outside the scope.
struct Subject {
    enum class Kind : std::uint8_t { none, person, cohort };
    Kind kind = Kind::none;
    std::string id;  ///< UUID
    static Subject nothing() { return {}; }
    static Subject person(std::string id) { return {Kind::person, std::move(id)}; }
    static Subject cohort(std::string id) { return {Kind::cohort, std::move(id)}; }
};

/// Someone acting in one role at this station. Made only by the store (sign-in, station, demo); copyable, any
/// thread. The store looks the role up again at every call, so a withdrawn role or a deactivated person ends
/// every session at once.
class Session {
  public:
    const std::string& person_id() const noexcept { return person_id_; }  ///< empty for the station
    const std::string& login() const noexcept { return login_; }          ///< "station" for the station
    const std::string& display_name() const noexcept { return display_name_; }
    Role role() const noexcept { return role_; }
    const std::vector<Role>& roles() const noexcept { return roles_; }  ///< all roles held, to choose from
    const std::string& station_id() const noexcept { return station_id_; }
    /// Signed in with a one-time password: nothing but change_password is allowed until it is changed.
    bool must_change_password() const noexcept { return must_change_password_; }
    bool is_station() const noexcept { return role_ == Role::station; }
    /// A synthetic person of a demo store.
    bool is_demo() const noexcept { return demo_; }

  private:
    friend class Store;
    friend struct SessionMaker;  // this floor's own, database/access/session_maker.h
    Session() = default;
    std::string person_id_, login_, display_name_, station_id_;
    Role role_ = Role::station;
    std::vector<Role> roles_;
    bool must_change_password_ = false;
    bool demo_ = false;
};

}  // namespace fulcrum::database
