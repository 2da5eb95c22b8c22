// SPDX-License-Identifier: Apache-2.0
// How much a quantity changes between two conditions, from pairs of values that belong together.
#pragma once

#include <optional>
#include <vector>

namespace fulcrum {

/// Quantile t of Student's distribution with P(|T| <= t) = level. `freedom` >= 1, 0 < level < 1; accurate to
/// 1e-9 of the value.
double student_t(int freedom, double level);

/// Mean of the differences with its 95 % t interval.
struct PairedShift {
    int pairs = 0;
    double reference = 0;  ///< mean of the reference values
    double size = 0;       ///< mean of their absolute values
    double shift = 0;      ///< mean of value - reference
    double low = 0, high = 0;
};
/// Pair i: values[i] and references[i]; both have the same length. None with fewer than 2 pairs.
std::optional<PairedShift> paired_shift(const std::vector<double>& values,
                                        const std::vector<double>& references);

}  // namespace fulcrum
