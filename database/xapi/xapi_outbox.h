// SPDX-License-Identifier: GPL-3.0-or-later
// Statements that this station sends to a learning record store: what waits, what is done, and what somebody
// has to look at. A statement is known by its UUID: it is queued once for each address, however often it is
// made, and is sent with that id until the record store has it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/store/store.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum::database {

enum class OutboxState : std::uint8_t {
    waiting,
    done,        ///< the record store has it
    quarantined  ///< refused, or the record store has another statement with this id: never sent again
};
inline constexpr NameRow<OutboxState> outbox_states[] = {{OutboxState::waiting, "waiting", ""},
                                                         {OutboxState::done, "done", ""},
                                                         {OutboxState::quarantined, "quarantined", ""}};
static_assert(in_order(outbox_states));

struct OutboxStatement {
    std::string id, person_id;
    std::string attempt_id;  ///< where it is about one: in the store the person is that of the attempt's row
    std::string text;        ///< JSON
    OutboxState state = OutboxState::waiting;
    int tries = 0;                           ///< that failed
    std::int64_t next_try = 0, changed = 0;  ///< UTC ms
    std::string problem;                     ///< why it is quarantined, or what the last try said
};

/// At one address.
struct OutboxCounts {
    std::string endpoint;
    int waiting = 0, done = 0, quarantined = 0;
    std::int64_t next_try = 0;  ///< UTC ms, the earliest of those that wait; 0: one is due, or none waits
};

/// The wait after so many failures: a minute, doubled each time, at most twelve hours.
std::int64_t outbox_wait_ms(int tries);

/// Checked as export_cohort: what leaves the programme is the director's.
class XapiOutbox {
  public:
    XapiOutbox(const Store& store, const Session& session, std::string endpoint);

    /// Those with an id that is there already are left as they are, those of an erased person or attempt are
    /// left out. One about an attempt of a merged account is that account's, and goes when it is erased, also
    /// after the merge was undone; one that an older program queued for the other account is given back.
    /// All or none; returns how many are new.
    int add(const std::vector<OutboxStatement>& statements) const;
    /// The first one that waits and whose time has come. One that was put off at a time that has not come
    /// yet, by a clock that was ahead, is due.
    std::optional<OutboxStatement> next() const;
    void finish(const std::string& id) const;
    void quarantine(const std::string& id, const std::string& problem) const;
    /// After a failure; `wait_ms`: at least so long.
    void postpone(const std::string& id, const std::string& problem, std::int64_t wait_ms = 0) const;
    /// What is quarantined waits again, after somebody has looked at it. Returns how many.
    int release() const;
    OutboxCounts counts() const;
    std::vector<OutboxStatement> quarantined() const;

  private:
    void set_state(const std::string& id, OutboxState state, const std::string& problem) const;
    const Store& store_;
    std::string endpoint_;
};

/// Of every address, by address.
std::vector<OutboxCounts> outbox_counts(const Store& store, const Session& session);

}  // namespace fulcrum::database
