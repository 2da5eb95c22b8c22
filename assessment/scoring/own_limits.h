// SPDX-License-Identifier: Apache-2.0
// Where one k for all gates lets too many or too few intermediates pass, each gate gets a k of its own.
#pragma once

#include <vector>

namespace fulcrum {

/// What decides whether an attempt passes.
struct JudgedAttempt {
    bool otherwise = false;  ///< everything is met apart from the levels below
    std::vector<double> z;   ///< of each level, in the set's order
};

/// Shares of attempts that pass.
struct PassShares {
    double experts = 0, intermediates = 0;
};

inline constexpr double least_k = 1, largest_k = 3;
inline constexpr double no_limit = 1e9;  ///< a k that every value meets
/// The bands in which fresh attempts are expected to pass: experts 80 to 95 %, intermediates 5 to 40 %.
inline constexpr double experts_middle = 0.875, experts_half = 0.075;
inline constexpr double intermediates_middle = 0.225, intermediates_half = 0.175;
/// A share counted on some dozens of attempts counts as within its band up to this part of its half width.
inline constexpr double well_within = 0.75;

/// Whether the share of intermediates is well within its band.
bool intermediates_well_within(double share);

PassShares pass_shares(const std::vector<JudgedAttempt>& experts,
                       const std::vector<JudgedAttempt>& intermediates, const std::vector<double>& k);

/// A k for each level, from `start`: the change of the k of one or two gates that brings both shares nearest
/// to the middles of their bands, each distance in half widths of its band, again and again until none does.
/// Of equally good changes the smallest. The share of experts does not leave the inner half of its band.
/// Levels with the same number in `gate` keep one k. Pure.
std::vector<double> limits_between(const std::vector<JudgedAttempt>& experts,
                                   const std::vector<JudgedAttempt>& intermediates,
                                   const std::vector<int>& gate, const std::vector<double>& start);

}  // namespace fulcrum
