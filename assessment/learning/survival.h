// SPDX-License-Identifier: Apache-2.0
// Time or attempts to proficiency of people of whom some are not there yet: the median of Kaplan and Meier
// 1958. And shares of people with Wilson's interval (Wilson 1927).
#pragma once

#include <optional>
#include <vector>

namespace fulcrum {

struct Observation {
    double time = 0;      ///< to the event, or to the last look
    bool reached = true;  ///< false: not there yet at that time
};
struct SurvivalStep {
    double time = 0, waiting = 1;  ///< share that is not there yet after `time`
    double low = 0, high = 1;  ///< 95 %, log-log; where nobody waits any more 0 and that of the step before
};
/// A step for each time at which someone got there. Times >= 0.
std::vector<SurvivalStep> survival_curve(std::vector<Observation> people);

struct SurvivalMedian {
    std::optional<double> median, low, high;  ///< none: beyond what was observed
};
/// First time at which at most half wait; its interval from those of the curve (log-log).
SurvivalMedian survival_median(const std::vector<SurvivalStep>& curve);

struct Share {
    double share = 0, low = 0, high = 1;
};
/// Share with Wilson's 95 % interval; 0 to 1 for nobody. 0 <= part <= all.
Share wilson(int part, int all);

}  // namespace fulcrum
