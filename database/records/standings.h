// SPDX-License-Identifier: GPL-3.0-or-later
// What a person's record says for a curriculum: the attempts that count, voids, the decisions of
// educators, and released ratings. assessment/curriculum makes the standing of it; nothing else is stored.
#pragma once

#include <string>
#include <vector>

#include "assessment/curriculum/standing.h"
#include "database/rows/attempt_records.h"
#include "database/store/override_rows.h"
#include "database/store/store.h"

namespace fulcrum::database {

class Standings {
  public:
    explicit Standings(const Store& store) : store_(store) {}

    /// Checked as read_progress. The person follows the versions of `curriculum` that Curricula gives; it
    /// must outlive the record. `with_limits` false: of many people, where nobody asks whether a check can be
    /// completed.
    PersonRecord record(const Session& session, const std::string& person_id, const Curriculum& curriculum,
                        bool with_limits = true) const;
    /// Of a person, newest first, also those that do not count (OverrideRow::own). Checked as read_progress.
    std::vector<OverrideRow> overrides(const Session& session, const std::string& person_id) const;
    /// Unlocks a task for a person or declares the person proficient in it. Never for oneself. `reason`: 1 to
    /// 4,000 characters. `newest`: a decision that changes nothing is refused, one on a task that is not of
    /// the person's version, and one on a person whose version is not installed; whoever has no move stays on
    /// the version followed, also should the attempts be voided (null: nothing of it is asked or settled).
    /// Throws AccessDenied, StoreError. Returns the id.
    std::string decide(const Session& educator, const std::string& person_id, const std::string& task_id,
                       StandingOverride::Kind kind, const std::string& reason,
                       const Curriculum* newest = nullptr) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
