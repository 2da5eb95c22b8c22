// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/paired_shift.h"

#include <cmath>

#include "assessment/learning/statistics.h"

namespace fulcrum {
namespace {

/// P(|T| <= t): the finite sums for whole degrees of freedom (Abramowitz and Stegun 26.7.3 and 26.7.4).
double share_within(double t, int freedom) {
    const double angle = std::atan(t / std::sqrt(static_cast<double>(freedom)));
    const double cosine2 = std::cos(angle) * std::cos(angle);
    double sum = 0, term = freedom % 2 == 1 ? std::cos(angle) : 1;
    for (int k = freedom % 2 == 1 ? 1 : 0; k <= freedom - 2; k += 2) {
        sum += term;
        term *= cosine2 * (k + 1) / (k + 2);
    }
    constexpr double two_over_pi = 0.63661977236758134;
    return freedom % 2 == 1 ? two_over_pi * (angle + std::sin(angle) * sum) : std::sin(angle) * sum;
}

}  // namespace

double student_t(int freedom, double level) {
    double low = 0, high = 1;
    while (share_within(high, freedom) < level) high *= 2;
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (low + high);
        (share_within(middle, freedom) < level ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::optional<PairedShift> paired_shift(const std::vector<double>& values,
                                        const std::vector<double>& references) {
    const std::size_t n = references.size();
    if (n < 2 || values.size() != n) return std::nullopt;
    std::vector<double> differences, sizes;
    for (std::size_t i = 0; i < n; ++i) {
        differences.push_back(values[i] - references[i]);
        sizes.push_back(std::fabs(references[i]));
    }
    PairedShift shift;
    shift.pairs = static_cast<int>(n);
    shift.reference = mean_of(references);
    shift.size = mean_of(sizes);
    shift.shift = mean_of(differences);
    const double half =
        student_t(shift.pairs - 1, 0.95) * sample_deviation(differences) / std::sqrt(static_cast<double>(n));
    shift.low = shift.shift - half;
    shift.high = shift.shift + half;
    return shift;
}

}  // namespace fulcrum
