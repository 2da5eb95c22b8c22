// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of store calls, each with a problem and a hint. The command line exits 2 on kinds that the caller
// can correct (is_bad_input), 1 on the others; the window shows problem() and hint().
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "sim_core/numerics/name_table.h"
#include "sim_core/numerics/worded_error.h"

namespace fulcrum::database {

enum class StoreErrorKind {
    missing,       ///< no such file
    exists,        ///< create() where a file already is
    not_a_store,   ///< a file, but not one of ours
    newer_schema,  ///< written by a newer program
    older_schema,  ///< must be migrated, but the store was opened read-only
    read_only,     ///< the file, its folder or the connection cannot be written
    locked,        ///< another program held it for longer than the waiting time
    corrupt,       ///< integrity, checksum or audit chain broken
    disk_full,
    not_found,    ///< no such person, attempt, cohort, comment
    conflict,     ///< login taken, administrator exists, already voided ...
    bad_value,    ///< a value out of its range: empty name, short password, empty reason
    sealed_demo,  ///< the demo store accepts practice only
    unreachable,  ///< the programme server does not answer, or does not let this account in
    failed,       ///< anything else that the database reports, in its words
};

/// what() is one line: `problem; hint`.
class StoreError : public HintedError {
  public:
    StoreError(StoreErrorKind kind, const Sentence& problem, const Sentence& hint)
        : HintedError(Sentence("%1; %2", problem, hint), problem, hint), kind_(kind) {}
    StoreErrorKind kind() const noexcept { return kind_; }
    /// True if the caller gave invalid input (exit 2), false if the store failed (exit 1).
    bool is_bad_input() const noexcept {
        return kind_ != StoreErrorKind::corrupt && kind_ != StoreErrorKind::disk_full &&
               kind_ != StoreErrorKind::locked && kind_ != StoreErrorKind::unreachable &&
               kind_ != StoreErrorKind::failed;
    }

  private:
    StoreErrorKind kind_;
};

/// Why a programme server does not let this program in.
enum class ServerRefusal : std::uint8_t {
    none,      ///< it did not answer, or it is something else
    password,  ///< another one than the account's, or none where the server asks for one
    account,   ///< there is no such account, or it may not sign in
    database,  ///< there is no such database
    rule,      ///< no rule of the server (pg_hba.conf) lets the account in from this machine
};

/// A connection to a programme server that could not be made.
class ConnectError : public StoreError {
  public:
    ConnectError(ServerRefusal why, const Sentence& problem, const Sentence& hint)
        : StoreError(StoreErrorKind::unreachable, problem, hint), why_(why) {}
    ServerRefusal why() const noexcept { return why_; }

  private:
    ServerRefusal why_;
};

/// Why access is denied.
enum class DenialReason : std::uint8_t {
    none,  ///< it is not
    not_in_role,
    demo_practice_only,  ///< the demo is sealed
    server_only_read,    ///< a write at a programme server
    outside_people,      ///< of this role
    own_attempt,
    own_account,
    other_store,            ///< signed in there
    demo_people_elsewhere,  ///< demo people outside the demo store
    demo_only,
    account_inactive,
    role_withdrawn,
    one_time_password,  ///< it has to be changed first
    role_not_held,      ///< `of`: the role
    other_login,
    other_form,
    other_comment,
    program_only,  ///< in a demo store
};
/// In logs; screens have words of their own (ui/language/error_text.cpp).
inline constexpr NameRow<DenialReason> denial_reasons[] = {
    {DenialReason::none, "none", ""},
    {DenialReason::not_in_role, "not_in_role", QT_TRANSLATE_NOOP("errors", "not in this role")},
    {DenialReason::demo_practice_only, "demo_practice_only",
     QT_TRANSLATE_NOOP("errors", "the demo takes practice attempts only")},
    {DenialReason::server_only_read, "server_only_read",
     QT_TRANSLATE_NOOP("errors",
                       "the programme server is only read here; do it at a station, with its own store")},
    {DenialReason::outside_people, "outside_people",
     QT_TRANSLATE_NOOP("errors", "outside this role's people")},
    {DenialReason::own_attempt, "own_attempt",
     QT_TRANSLATE_NOOP("errors", "not allowed on one's own attempt")},
    {DenialReason::own_account, "own_account",
     QT_TRANSLATE_NOOP("errors", "nobody merges an account of their own")},
    {DenialReason::other_store, "other_store", QT_TRANSLATE_NOOP("errors", "signed in to another store")},
    {DenialReason::demo_people_elsewhere, "demo_people_elsewhere",
     QT_TRANSLATE_NOOP("errors", "demo people exist in the demo store only")},
    {DenialReason::demo_only, "demo_only", QT_TRANSLATE_NOOP("errors", "demo stores only")},
    {DenialReason::account_inactive, "account_inactive",
     QT_TRANSLATE_NOOP("errors", "the account is no longer active")},
    {DenialReason::role_withdrawn, "role_withdrawn", QT_TRANSLATE_NOOP("errors", "the role was withdrawn")},
    {DenialReason::one_time_password, "one_time_password",
     QT_TRANSLATE_NOOP("errors", "the one-time password must be changed first")},
    {DenialReason::role_not_held, "role_not_held", QT_TRANSLATE_NOOP("errors", "the role %1 is not held")},
    {DenialReason::other_login, "other_login", QT_TRANSLATE_NOOP("errors", "someone else's login")},
    {DenialReason::other_form, "other_form", QT_TRANSLATE_NOOP("errors", "someone else's form")},
    {DenialReason::other_comment, "other_comment", QT_TRANSLATE_NOOP("errors", "someone else's comment")},
    {DenialReason::program_only, "program_only",
     QT_TRANSLATE_NOOP("errors", "by the program, in a demo store")},
};
static_assert(in_order(denial_reasons), "rows in the enum's order");

/// The access table says no. Nothing was read or written.
class AccessDenied : public WordedError {
  public:
    /// `of`: what the reason is about, where it has a place for it.
    AccessDenied(const std::string& operation, const std::string& role, DenialReason why,
                 const std::string& of = {})
        : WordedError(
              {QT_TRANSLATE_NOOP("errors",
                                 "not allowed: %1 as %2%3; act in a role that may, or ask someone who "
                                 "holds it"),
               operation, role,
               why == DenialReason::none
                   ? Sentence()
                   : Sentence(" (%1)", Sentence(row_of(denial_reasons, why).title, of))}),
          operation_(operation),
          role_(role),
          of_(of),
          why_(why) {}
    /// As in the access table; names for programs, which screens put into words.
    const std::string& operation() const noexcept { return operation_; }
    const std::string& role() const noexcept { return role_; }
    DenialReason why() const noexcept { return why_; }
    const std::string& of() const noexcept { return of_; }

  private:
    std::string operation_, role_, of_;
    DenialReason why_;
};

/// Sign-in refused. Never says whether the login exists.
class SignInRefused : public WordedError {
  public:
    enum class Reason {
        wrong,          ///< login or password wrong
        wait,           ///< too soon after wrong tries; wait_s says how long
        expired,        ///< the one-time password is older than 24 h
        role_not_held,  ///< right password, but the person does not hold the role asked for
    };
    SignInRefused(Reason reason, double wait_s, const Sentence& line)
        : WordedError(line), reason_(reason), wait_s_(wait_s) {}
    Reason reason() const noexcept { return reason_; }
    /// Seconds until the next try is looked at; 0 if at once.
    double wait_s() const noexcept { return wait_s_; }

  private:
    Reason reason_;
    double wait_s_;
};

}  // namespace fulcrum::database
