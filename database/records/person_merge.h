// SPDX-License-Identifier: GPL-3.0-or-later
// Merging a person who was entered twice (two stations, a list from another system) into the one who stays.
// Nothing that is signed is changed: the doubled person's row names the other one, and what belongs to it is
// read as the other one's from then on (database/rows/same_person.h), also what comes from a station later.
// Cohorts, drafts and what was seen before rating move; the doubled login, its password and its roles end. A
// merge can be undone; what moved stays where it is. Administrators only, and never with an account of their
// own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/records/people.h"

namespace fulcrum::database {

struct MergePlan {
    Person from, into;
    /// How many of each follow, and of those that do not count any more; only those of which there are any.
    struct Count {
        Sentence what;  ///< "attempts", in the reader's words
        std::int64_t count = 0;
    };
    std::vector<Count> counts;
    std::vector<std::string> cohorts;  ///< names of those that `into` joins or teaches
};

class PersonMerge {
  public:
    explicit PersonMerge(const Store& store) : store_(store) {}
    /// Changes nothing. Throws AccessDenied; StoreError bad_value (one person, not real people), conflict
    /// (merged into another one already, roles that the other one does not hold, an attempt that runs),
    /// not_found.
    MergePlan plan(const Session& administrator, const std::string& from, const std::string& into) const;
    /// As planned, in one transaction. `reason`: 1 to 4,000 characters.
    MergePlan merge(const Session& administrator, const std::string& from, const std::string& into,
                    const std::string& reason) const;
    /// What was done under `from` is its own again. The account stays deactivated and without roles, cohorts
    /// and password.
    void undo(const Session& administrator, const std::string& from, const std::string& reason) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
