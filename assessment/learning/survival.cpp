// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/survival.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double z_95 = 1.959963984540054;

}  // namespace

std::vector<SurvivalStep> survival_curve(std::vector<Observation> people) {
    std::sort(people.begin(), people.end(),
              [](const Observation& a, const Observation& b) { return a.time < b.time; });
    std::vector<SurvivalStep> curve;
    double waiting = 1, variance = 0;  // Greenwood's sum
    for (std::size_t i = 0; i < people.size();) {
        const auto at_risk = static_cast<double>(people.size() - i);
        double reached = 0;
        const double time = people[i].time;
        for (; i < people.size() && people[i].time == time; ++i) reached += people[i].reached ? 1 : 0;
        if (reached == 0) continue;
        waiting *= 1 - reached / at_risk;
        SurvivalStep step{time, waiting, 0, 1};
        if (waiting > 0) {
            variance += reached / (at_risk * (at_risk - reached));
            const double logarithm = std::log(waiting);
            const double half = z_95 * std::sqrt(variance) / std::fabs(logarithm);
            step.low = std::pow(waiting, std::exp(half));
            step.high = std::pow(waiting, std::exp(-half));
        } else if (!curve.empty()) {
            step.high = curve.back().high;  // none is defined at 0: the curve is not above where it was
        }
        curve.push_back(step);
    }
    return curve;
}

SurvivalMedian survival_median(const std::vector<SurvivalStep>& curve) {
    SurvivalMedian result;
    for (const SurvivalStep& step : curve) {
        if (!result.median && step.waiting <= 0.5) result.median = step.time;
        if (!result.low && step.low <= 0.5) result.low = step.time;
        if (!result.high && step.high <= 0.5) result.high = step.time;
    }
    return result;
}

Share wilson(int part, int all) {
    if (all == 0) return {};
    const double n = all, p = part / n, z2 = z_95 * z_95;
    const double centre = (p + z2 / (2 * n)) / (1 + z2 / n);
    const double half = z_95 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
    return {p, std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

}  // namespace fulcrum
