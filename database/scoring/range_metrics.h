// SPDX-License-Identifier: GPL-3.0-or-later
// The metrics of a part of an attempt: the same function as for a whole one, given the samples and events of
// that part alone.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "assessment/metrics/metric.h"
#include "assessment/task/task.h"
#include "database/rows/trace_codec.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// How much of a record is in memory at a time. The rows are the same.
enum class RangePasses {
    by_length,  ///< at once up to a quarter of an hour
    at_once,
    hand_by_hand,  ///< one hand, and the columns that a group of metrics reads
};

struct RangeOptions {
    RangePasses passes = RangePasses::by_length;
    std::function<bool()> stop = {};  ///< true: nobody wants the rows any more; there are none then
};

/// Of the samples and events in [from, to] (s). What began before `from` (a grasp, a cut) counts with what
/// happens of it afterwards only; what the whole attempt leaves behind (its specimen) has no value here. The
/// metrics that the task shows, in the registry's order. A packed record is read a chunk at a time. Pure, any
/// thread. Throws std::invalid_argument.
std::vector<MetricResult> metrics_of_range(const Scene& scene, const TaskDefinition& task, std::uint64_t seed,
                                           const database::Trace& trace, double from, double to,
                                           const RangeOptions& options = {});

}  // namespace fulcrum
