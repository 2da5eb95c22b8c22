// SPDX-License-Identifier: GPL-3.0-or-later
// People, sign-in, roles, cohorts. All strings UTF-8. Every call is checked against the access table; writes
// are audited in the same transaction. Errors: AccessDenied, StoreError (not_found, conflict, bad_value),
// SignInRefused.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/rows/person_kind.h"
#include "database/store/store.h"

namespace fulcrum::database {

struct Person {
    std::string id;            ///< UUID
    std::string login;         ///< unique, case ignored; letters, digits, . _ - @; 1 to 64
    std::string display_name;  ///< 1 to 120 characters
    PersonKind kind = PersonKind::real;
    bool active = true;
    std::vector<Role> roles;
    UtcMilliseconds created = 0;
    UtcMilliseconds last_sign_in = 0;  ///< 0 never
    std::string merged_into;  ///< id of the person it belongs to now (person_merge.h); empty: to itself
};

struct Cohort {
    std::string id, name;
    std::vector<std::string> members;    ///< person ids
    std::vector<std::string> educators;  ///< person ids
};

struct CreatedProgramme {
    Session administrator;
    std::string recovery_code;  ///< shown once, stored hashed
};

struct RecentSignIn {
    std::string login, display_name;
    UtcMilliseconds last = 0;
};

inline constexpr int password_minimum_length = 10;  ///< characters
inline constexpr std::int64_t one_time_password_valid_ms = 24LL * 3600 * 1000;
/// After a wrong try a login waits, twice as long each time, but no longer than usual_wait_s until so many
/// wrong tries are remembered; each longest_wait_s without a try takes one off.
inline constexpr double first_wait_s = 5, usual_wait_s = 30, longest_wait_s = 300;
inline constexpr int tries_before_longest_wait = 40;

class People {
  public:
    explicit People(const Store& store) : store_(store) {}

    /// Programme, first administrator and recovery code in one transaction; StoreError conflict once an
    /// administrator exists.
    CreatedProgramme create_programme(const std::string& programme, const std::string& login,
                                      const std::string& display_name, const std::string& password) const;

    /// `role` empty: the first held of trainee, educator, director, administrator. Throws SignInRefused.
    /// Takes about 0.1 s.
    Session sign_in(const std::string& login, const std::string& password,
                    std::optional<Role> role = {}) const;
    /// Of a programme server: the person whose account the connection was made with; the server has checked
    /// the password. Throws SignInRefused role_not_held.
    Session account_session(std::optional<Role> role = {}) const;
    /// The same after asking for the account's password again; sign_in() at a server.
    Session account_session(const std::string& login, const std::string& password,
                            std::optional<Role> role) const;
    /// The same person in another role they hold. Throws AccessDenied.
    Session act_as(const Session& session, Role role) const;
    /// A synthetic person of a demo store in a role they hold; no password. Throws AccessDenied elsewhere.
    Session demo_session(const std::string& login, Role role) const;
    /// Seconds to wait before a try with this login is looked at; 0 if none.
    double sign_in_wait_s(const std::string& login) const;
    /// Last 30 days, newest first; empty when the programme turned the picker off.
    std::vector<RecentSignIn> recent_sign_ins(const Session& station_or_person) const;
    void set_sign_in_picker(const Session& administrator, bool on) const;
    bool sign_in_picker() const;

    /// Returns the session without must_change_password. The old password is asked again (SignInRefused).
    Session change_password(const Session& session, const std::string& old_password,
                            const std::string& new_password) const;
    /// Returns the one-time password, valid 24 h.
    std::string issue_one_time_password(const Session& administrator, const std::string& person_id) const;
    /// For the last administrator only. Returns the next recovery code. Throws SignInRefused.
    std::string recover_administrator(const std::string& login, const std::string& recovery_code,
                                      const std::string& new_password) const;

    struct Created {
        Person person;
        std::string one_time_password;
    };
    Created create(const Session& administrator, const std::string& login, const std::string& display_name,
                   const std::vector<Role>& roles) const;
    void rename(const Session& administrator, const std::string& person_id,
                const std::string& display_name) const;
    /// Of a real person, neither merged nor erased. Whoever is signed in under the old login stays so.
    void set_login(const Session& administrator, const std::string& person_id,
                   const std::string& login) const;
    /// The login that the session's person has now; it may have been changed since the sign-in.
    std::string login_now(const Session& session) const;
    /// A deactivated person cannot sign in; attempts stay. The last administrator cannot be deactivated.
    void set_active(const Session& administrator, const std::string& person_id, bool active) const;
    /// The last administrator keeps the role.
    void set_roles(const Session& administrator, const std::string& person_id,
                   const std::vector<Role>& roles) const;
    /// Finds or makes a synthetic or external person. In a store with a programme a new one has a login that
    /// begins with synthetic- or external-, and StoreError conflict does not say whether another login is
    /// somebody's.
    Person ensure_synthetic(const Session& station, const std::string& login, const std::string& display_name,
                            PersonKind kind = PersonKind::synthetic) const;

    /// The people the session may list (educator: of their cohorts; trainee: themselves), by display name.
    std::vector<Person> list(const Session& session) const;
    std::optional<Person> find(const Session& session,
                               const std::string& person_id) const;  ///< empty: unknown
    /// Of a login that was merged: the person it belongs to now.
    std::optional<Person> find_login(const Session& session, const std::string& login) const;

    std::vector<Cohort> cohorts(const Session& session) const;  ///< those the session may see, by name
    std::optional<Cohort> find_cohort(const Session& session, const std::string& id_or_name) const;
    std::string create_cohort(const Session& director, const std::string& name) const;  ///< returns the id
    void rename_cohort(const Session& director, const std::string& cohort_id, const std::string& name) const;
    void set_members(const Session& director, const std::string& cohort_id,
                     const std::vector<std::string>& person_ids) const;
    void set_educators(const Session& director, const std::string& cohort_id,
                       const std::vector<std::string>& person_ids) const;

    /// While a demo store is being built (StoreError sealed_demo after): roles and a cohort of synthetic
    /// people.
    void set_demo_roles(const Session& station, const std::string& person_id,
                        const std::vector<Role>& roles) const;
    std::string create_demo_cohort(const Session& station, const std::string& name,
                                   const std::vector<std::string>& members,
                                   const std::vector<std::string>& educators) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
