// SPDX-License-Identifier: GPL-3.0-or-later
// What was acknowledged to a program that is killed: it enters each deed once the call has returned, into
// memory that outlives it.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum::database::test {

enum class DeedKind : std::uint32_t {
    mark,   ///< a comment sent at a moment; number: of its text
    draft,  ///< written or edited; number: of its text
    draft_sent,
    deletion_begun,  ///< from here on the draft may be gone
    draft_deleted,
    rating_begun,
    rating_answered,  ///< number: of its remark
    rating_handed_in,
    rating_released,
    discard_begun,  ///< from here on the draft of a form may be gone
    rating_discarded,
    attempt_voided,
    attempt_moved,  ///< to another person; object: the copy, other: the attempt
    score_added,
    decided,  ///< a decision on a standing
    comment_read,
    error_reviewed,    ///< number: of its reason
    correction_asked,  ///< object: the attempt; number: of its text
    sent,       ///< units of the table `object` that are on the server: the first `number` of those lacking
    received,   ///< the same at the station
    exchanged,  ///< the whole exchange
};

struct Deed {
    DeedKind kind;
    std::uint32_t number;
    char object[48], other[48];
};

/// In shared memory, of one folder.
class DeedsJournal {
  public:
    static constexpr std::uint32_t room = 8192;
    /// Maps the journal of a folder, made on first use. Ends the program if that fails.
    static DeedsJournal& in(const std::string& folder);

    void clear();
    /// Before the call.
    void begin() { begun.fetch_add(1); }
    /// After it has returned.
    void acknowledge(DeedKind kind, const std::string& object, std::uint32_t number = 0,
                     const std::string& other = {});
    /// Enters a deed that is only about to be done.
    void announce(DeedKind kind, const std::string& object) { enter(kind, object, 0, {}); }
    std::vector<Deed> deeds() const;

    std::atomic<std::uint32_t> ready{0};  ///< children that are about to do what they were started for
    std::atomic<std::uint32_t> begun{0}, acknowledged{0};

  private:
    void enter(DeedKind kind, const std::string& object, std::uint32_t number, const std::string& other);
    std::atomic<std::uint32_t> count_{0};
    Deed deeds_[room];
};

/// Children of main(): they run until they are killed. `number`: seed.
int review_until_killed(const std::string& folder, int number);
/// Exchanges with the server in the file `server` of the folder, again and again.
int exchange_until_killed(const std::string& folder, int number);

/// Until the child has begun and entered so many deeds; false where it ended before.
bool wait_for_deeds(const DeedsJournal& journal, pid_t child, std::uint32_t count);

/// From FULCRUM_KILLS, else a few.
int kills_asked(int usually);

}  // namespace fulcrum::database::test
