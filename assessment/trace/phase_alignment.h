// SPDX-License-Identifier: Apache-2.0
// Two attempts at one task on one time axis: the moments at which both met a goal lie on each other, and time
// runs evenly between them. From it the band of many attempts over the time of one. Pure; any thread.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "sim_core/telemetry/event.h"

namespace fulcrum {

/// When the parts of an attempt ended, s since it began.
struct PhaseMoments {
    double begin = 0;  ///< first movement; 0 without one
    double end = 0;    ///< of the record
    bool completed = false;
    int first_goal = 0;         ///< index of the goal that it began in: practice begins in any
    std::map<int, double> met;  ///< by goal (its index): when it was met
};
PhaseMoments phase_moments(const std::vector<Event>& events, double tick_period, double end);

/// From the time of one attempt to that of another and back. Never falls. The first moment of both is the
/// first movement; where one of them began in a later goal, the moment at which the other had met all goals
/// before that one, if it did. Beyond the first and the last moment that both have, time runs as fast in
/// both, and stays within each record.
class PhaseMap {
  public:
    PhaseMap() = default;
    PhaseMap(const PhaseMoments& first, const PhaseMoments& second);
    double to_second(double t) const;
    double to_first(double t) const;
    /// Goals that both met, in the order in which the first attempt met them.
    const std::vector<int>& common_goals() const { return goals_; }
    /// The goal whose beginning is the first moment of both; 0: it is the first movement.
    int first_goal() const { return first_goal_; }

  private:
    static double mapped(const std::vector<double>& from, const std::vector<double>& to, double t,
                         double end);
    std::vector<double> first_, second_;  ///< s, rising; of the same moments
    std::vector<int> goals_;
    int first_goal_ = 0;
    double first_end_ = 0, second_end_ = 0;
};

/// Values of the second attempt over its own time, which rises: their mean in each of `cells` equal parts of
/// [0, end] of the first one's time; NaN beyond the record of the second and where it has no values. A part
/// that is shorter than the time between two samples has the latest sample, if that is at most 0.1 s old.
std::vector<float> aligned_means(const PhaseMap& map, double end, std::size_t cells,
                                 const std::vector<double>& time, const std::vector<float>& value);

/// Median and quartiles (linear between the two nearest values).
struct Spread {
    double low = 0, middle = 0, high = 0;
    std::size_t count = 0;  ///< values that it is of
};
/// Of the values that are numbers; all NaN without any.
Spread spread_of(std::vector<double> values);

struct BandPoint {
    double time = 0;  ///< s, middle of the part
    Spread spread;
};
/// Of each part in which at least `least` of the attempts have a value. Each of them: aligned_means() with
/// the same `end` and the same number of parts.
std::vector<BandPoint> band_of(const std::vector<std::vector<float>>& attempts, double end,
                               std::size_t least);

}  // namespace fulcrum
