// SPDX-License-Identifier: Apache-2.0
// Where an attempt stood still.
#pragma once

#include <algorithm>

#include "assessment/metrics/analysis.h"

namespace fulcrum {

/// Evidence of a duration: its longest stretch without progress towards a goal.
inline TimeInterval longest_wait(const Analysis& analysis, double begin, double end) {
    TimeInterval longest{begin, begin};
    double since = begin;
    const auto until = [&](double t) {
        if (t - since > longest.end - longest.begin) longest = {since, t};
        since = std::max(since, t);
    };
    for (const Event& event : analysis.events()) {
        const bool progress = event.kind == EventKind::goal_progress ||
                              event.kind == EventKind::target_reached || event.kind == EventKind::phase_end;
        const double t = analysis.trace().time_of(event);
        if (progress && t > begin && t < end) until(t);
    }
    until(end);
    return longest;
}

}  // namespace fulcrum
