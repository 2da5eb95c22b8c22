// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of store calls, each with a problem and a hint. The command line exits 2 on kinds that the caller
// can correct (is_bad_input), 1 on the others; the window shows problem() and hint().
#pragma once

#include <stdexcept>
#include <string>

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

/// The access table says no. Nothing was read or written.
class AccessDenied : public WordedError {
  public:
    AccessDenied(const std::string& operation, const std::string& role, const Sentence& why)
        : WordedError(
              {QT_TRANSLATE_NOOP("errors",
                                 "not allowed: %1 as %2%3; act in a role that may, or ask someone who "
                                 "holds it"),
               operation, role, why.empty() ? Sentence() : Sentence(" (%1)", why)}),
          operation_(operation),
          role_(role),
          why_(why.words()) {}
    /// As in the access table; names for programs, which screens put into words.
    const std::string& operation() const noexcept { return operation_; }
    const std::string& role() const noexcept { return role_; }
    const std::string& why() const noexcept { return why_; }

  private:
    std::string operation_, role_, why_;
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
