// SPDX-License-Identifier: GPL-3.0-or-later
// Who would pass under which limits: stored attempts judged again by other benchmark sets of their own key,
// from the values that were stored with them. Nothing is written.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/scoring/benchmark.h"
#include "assessment/task/task.h"
#include "database/records/attempts.h"
#include "sim_core/scene/cutting_values.h"

namespace fulcrum {

/// Most attempts that are looked at, the newest ones.
inline constexpr int most_tried_attempts = 400;

/// An attempt that counts, as limits judge it.
struct TriedAttempt {
    std::string attempt_id, person_id, person_name;
    std::vector<database::GateRow> gates;        ///< of the score in force
    std::map<std::string, int> metric_versions;  ///< by metric
    bool critical = false;                       ///< a critical error: failed under any limits
    bool completed = true;                       ///< false: abandoned, out of time; failed under any limits
    std::optional<bool> passed;                  ///< in force
    CuttingValues cutting;                       ///< of the tissues in which it was performed
    CuttingValues scene_cutting;  ///< of its scene file: those that a set without any of its own was made in
};

/// The sets of the program's assets for this task, by name, without those that have to be built again
/// (OutdatedSet); files of other tasks are not read. Throws InputError for one that cannot be read.
std::vector<BenchmarkSet> sets_in_force(const std::string& task_id);

/// Counting attempts of real people (in a demonstration programme: of its people) with this key and the
/// task's present version that the session may read, newest first. Throws AccessDenied, StoreError.
std::vector<TriedAttempt> tried_attempts(const database::Store& store, const database::Session& session,
                                         const TaskDefinition& task, const BenchmarkKey& key);

/// Pure. Whether the set was made in the tissue in which the attempt was performed.
bool in_tissue_of(const BenchmarkSet& set, const TriedAttempt& attempt);

/// Pure. Whether the attempt passes with the set's limits in place of those in force; nothing where a gate
/// cannot be judged: the set has no level for it or was made in other tissue, or its metric was measured by
/// another version.
std::optional<bool> passes_under(const TaskDefinition& task, const TriedAttempt& attempt,
                                 const BenchmarkSet& set);

struct TrialCount {
    int attempts = 0, passed = 0, not_judged = 0;
    int people = 0, people_passed = 0;  ///< who made an attempt; who passed at least one
};
TrialCount count_passes(const TaskDefinition& task, const std::vector<TriedAttempt>& attempts,
                        const BenchmarkSet& set);

}  // namespace fulcrum
