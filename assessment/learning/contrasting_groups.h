// SPDX-License-Identifier: Apache-2.0
// Contrasting groups: a pass mark from two groups of known standing, one that should pass and one that should
// not, where their normal densities are equal (docs/METRICS.md).
#pragma once

#include <optional>

namespace fulcrum {

/// A group's mean and standard deviation, on one scale for both groups.
struct GroupSpread {
    double mean = 0, deviation = 0;
};

struct PassMark {
    double value = 0;
    double false_positive = 0;  ///< share of the weaker group on the passing side, 0..1
    double false_negative = 0;  ///< share of the stronger group on the failing side, 0..1
};

/// The value strictly between the means where the densities are equal; the midpoint where the deviations are
/// (relative difference below 1e-9). None where no such value exists: the groups overlap. `stronger` is the
/// group that should pass, whichever mean is larger. Deviations that are not above 0 and finite give none.
std::optional<PassMark> contrasting_groups(const GroupSpread& stronger, const GroupSpread& weaker);

}  // namespace fulcrum
