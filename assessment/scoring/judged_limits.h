// SPDX-License-Identifier: Apache-2.0
// What an attempt will be held against, before it begins: for each gate of a task its limit and the experts'
// range.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/scoring/benchmark.h"
#include "assessment/task/task.h"

namespace fulcrum {

/// A gate before an attempt; values in `unit`.
struct JudgedLimit {
    std::string metric, hand, tissue;
    std::string unit;
    bool higher_is_better = false;
    bool exclusive = false;       ///< a value equal to the limit is beyond it
    std::optional<double> limit;  ///< absent: no set has a level for it
    std::string limit_source;
    std::optional<double> task_limit;  ///< of an absolute gate: the task's own, which a set may narrow
    bool of_set = false;               ///< the set has a level for it
    bool provisional = false;
    Statement absent_because;  ///< why there is no limit
    /// The experts' mean plus and minus their standard deviation, on the metric's scale; absent without a
    /// set, or where their deviation is below the metric's precision.
    std::optional<double> experts_low, experts_high;
};

/// One for each gate, in the task's order. `benchmark` null: none applies, `why_none` says why. A gate of a
/// metric that this program does not know has no limit.
std::vector<JudgedLimit> judged_limits(const TaskDefinition& task, const BenchmarkSet* benchmark,
                                       const Statement& why_none = {});

}  // namespace fulcrum
