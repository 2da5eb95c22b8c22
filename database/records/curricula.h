// SPDX-License-Identifier: GPL-3.0-or-later
// Which version of the curriculum each person follows: the one that the first attempt names (voided ones and
// those that were reassigned to the person left out), until an educator moves the person to another one. A
// version that somebody follows is never edited: its file stays as it was, and a change is a new version in a
// file of its own.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/curriculum/standing.h"
#include "database/rows/attempt_records.h"
#include "database/store/store.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum::database {

struct FollowedCurriculum {
    std::string name;        ///< "rectal@2"
    std::int64_t since = 0;  ///< UTC ms; 0: from the beginning
    std::string moved_by;    ///< display name; "": nobody, it is the first one
    std::string reason;      ///< of the move
};

/// A version that people follow and that has no file at this station. It may have come with an exchange, from
/// a station that is newer or that keeps what it publishes: no fault of this one.
struct MissingCurriculum {
    std::string name;  ///< "rectal@1001"
    int people = 0;    ///< how many follow it
    Sentence words() const;
};
/// Why nothing can be said of the standing of a person who follows this version.
Sentence not_here_words(const std::string& name);
/// What to do about it.
Sentence not_here_hint();
/// The newest version up to `at` that is not installed; empty: all are. `at`: UTC ms.
std::string missing_in(const std::vector<CurriculumAssignment>& assignments, std::int64_t at);

/// What a move changes in one task.
struct CurriculumChange {
    std::string task;
    TaskStanding before, after;                    ///< on the day of the preview
    bool only_before = false, only_after = false;  ///< the task belongs to one of the two versions
};

/// Whether the attempt, if it is the first of those that do, decides which version its person follows; as
/// FULCRUM_DECIDES in SQL, for people without copies of reassigned attempts.
bool decides_curriculum(const AttemptSummary& attempt);

/// What the attempts of a person say of the version from the beginning.
struct BegunWith {
    std::optional<std::string> curriculum;  ///< named by the first that decides; nothing: there is none
    std::int64_t since = 0;                 ///< UTC ms, when that one began
    bool has_copies = false;                ///< of reassigned attempts: which of them decide is asked
};

class Curricula {
  public:
    explicit Curricula(const Store& store) : store_(store) {}

    /// Oldest first, never empty. A person without such attempts follows `newest`. Moves of an account that
    /// was merged into this one count up to the first attempt or move of this one. Checked as read_progress.
    std::vector<FollowedCurriculum> followed(const Session& session, const std::string& person_id,
                                             const Curriculum& newest) const;
    /// The same for standing_of(). They point into `newest`. A version that is not installed: `newest` in its
    /// place, and CurriculumAssignment::missing names it.
    std::vector<CurriculumAssignment> assignments(const Session& session, const std::string& person_id,
                                                  const Curriculum& newest) const;
    /// The same of every member of a cohort whose attempts were read. `begun_with`: by person. Checked as
    /// read_cohort_table.
    std::map<std::string, std::vector<CurriculumAssignment>> assignments_in(
        const Session& session, const std::string& cohort_id, const Curriculum& newest,
        const std::map<std::string, BegunWith>& begun_with) const;
    /// What one account of the person says by itself, without those that were merged into it or it into.
    /// Checked as read_progress.
    std::vector<CurriculumAssignment> of_account(const Session& session, const std::string& person_id,
                                                 const std::string& account_id,
                                                 const Curriculum& newest) const;
    /// The version that the person follows now: a move whose time lies ahead is not yet in force.
    const Curriculum& in_force(const Session& session, const std::string& person_id,
                               const Curriculum& newest) const;
    /// The version that the person follows, or has followed, and that is not installed; empty: all are. Of
    /// the person's standing nothing can be said then. Checked as read_progress.
    std::string missing(const Session& session, const std::string& person_id, const Curriculum& newest) const;
    /// Throws StoreError where there is one.
    void require_here(const Session& session, const std::string& person_id, const Curriculum& newest) const;
    /// What moving the person to this version would change, the tasks that stay as they are left out.
    /// Changes nothing. Throws AccessDenied, StoreError (no such version, the person's own is not installed).
    std::vector<CurriculumChange> preview(const Session& session, const std::string& person_id,
                                          const Curriculum& newest, const std::string& to) const;
    /// Moves people, except those who follow `to` already. All or nobody. `reason`: 1 to 4,000 characters.
    /// Returns how many were moved. Checked for each person as decide_standing. Throws AccessDenied,
    /// StoreError, as preview() does.
    int move(const Session& educator, const std::vector<std::string>& people, const Curriculum& newest,
             const std::string& to, const std::string& reason) const;
    /// Within the transaction of a decision on a standing: whoever has no move yet stays on the version of
    /// the decision, written as a move to it with the id of the decision. It counts while nothing older of
    /// the person is known: no attempt that decides, no other move. An exchange or a merge may bring one, a
    /// void may take it away again. Checked as decide_standing.
    void keep_version(const Session& educator, const std::string& person_id, const Curriculum& newest,
                      const std::string& decision, const std::string& reason) const;
    /// How many people with such attempts or a move follow each version; somebody who was entered twice is
    /// one, and attempts that name no version are of the one that followed() gives.
    std::map<std::string, int> people(const Curriculum& newest) const;
    /// Throws InputError where the file of a version that somebody follows is not the one that attempts were
    /// made with. Returns those that are not installed: everybody else can work.
    std::vector<MissingCurriculum> check(const Curriculum& newest) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
