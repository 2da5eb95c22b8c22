// SPDX-License-Identifier: Apache-2.0
// Where an attempt stood still.
#pragma once

#include <algorithm>

#include "assessment/metrics/analysis.h"

namespace fulcrum {

/// Evidence of a duration: its longest stretch without progress towards a goal, pauses not counted.
inline TimeInterval longest_wait(const Analysis& analysis, double begin, double end) {
    TimeInterval longest{begin, begin};
    double since = begin, longest_running = 0;
    const auto until = [&](double t) {
        const double running = running_time(analysis.trace(), since, t);
        if (running > longest_running) {
            longest = {since, t};
            longest_running = running;
        }
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
