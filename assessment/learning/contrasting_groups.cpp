// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/contrasting_groups.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

/// Share of a normal distribution below `x`.
double share_below(const GroupSpread& group, double x) {
    return 0.5 * std::erfc(-(x - group.mean) / (group.deviation * std::sqrt(2.0)));
}

/// Where the densities are equal, strictly between the means.
std::optional<double> crossing(const GroupSpread& a, const GroupSpread& b) {
    const double low = std::min(a.mean, b.mean), high = std::max(a.mean, b.mean);
    if (!(low < high)) return std::nullopt;
    if (std::abs(a.deviation - b.deviation) < 1e-9 * a.deviation) return 0.5 * (low + high);
    // (x - m1)^2 / s1^2 + 2 ln s1 = (x - m2)^2 / s2^2 + 2 ln s2, with x measured from the middle of the means
    // so that nothing large cancels.
    const double middle = 0.5 * (low + high), m1 = a.mean - middle, m2 = b.mean - middle;
    const double p1 = 1 / (a.deviation * a.deviation), p2 = 1 / (b.deviation * b.deviation);
    const double square = p1 - p2, half = -(m1 * p1 - m2 * p2),
                 constant = m1 * m1 * p1 - m2 * m2 * p2 + 2 * std::log(a.deviation / b.deviation);
    const double root = half * half - square * constant;
    if (!(root >= 0)) return std::nullopt;
    // Neither root by a difference of nearly equal numbers.
    const double q = -(half + std::copysign(std::sqrt(root), half));
    for (const double x : {q / square, q != 0 ? constant / q : 0.0})
        if (std::isfinite(x) && middle + x > low && middle + x < high) return middle + x;
    return std::nullopt;
}

}  // namespace

std::optional<PassMark> contrasting_groups(const GroupSpread& stronger, const GroupSpread& weaker) {
    for (const GroupSpread* group : {&stronger, &weaker})
        if (!std::isfinite(group->mean) || !std::isfinite(group->deviation) || !(group->deviation > 0))
            return std::nullopt;
    const std::optional<double> mark = crossing(stronger, weaker);
    if (!mark) return std::nullopt;
    PassMark result;
    result.value = *mark;
    const bool higher_is_better = stronger.mean > weaker.mean;
    const double weaker_below = share_below(weaker, *mark), stronger_below = share_below(stronger, *mark);
    result.false_positive = higher_is_better ? 1 - weaker_below : weaker_below;
    result.false_negative = higher_is_better ? stronger_below : 1 - stronger_below;
    return result;
}

}  // namespace fulcrum
