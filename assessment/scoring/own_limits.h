// SPDX-License-Identifier: Apache-2.0
// Where one k for all gates lets too many or too few intermediates pass, each gate gets a k of its own.
#pragma once

#include <vector>

namespace fulcrum {

/// What decides whether an attempt passes.
struct JudgedAttempt {
    bool otherwise = false;  ///< everything is met apart from the levels below
    std::vector<double> z;   ///< of each level, in the set's order
    int person = 0;          ///< attempts of one person are left out together
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

/// Whether the share of intermediates is within its band, and surely so: with Wilson's 95 % interval.
bool intermediates_surely_within(int passed, int attempts);

PassShares pass_shares(const std::vector<JudgedAttempt>& experts,
                       const std::vector<JudgedAttempt>& intermediates, const std::vector<double>& k);

/// A k for each level, from `start`: the change of the k of one or two gates that brings the shares of both
/// groups nearest to the middles of their bands, each distance in half widths of its band, again and again
/// until none does. Of equally good changes the smallest. The share of experts does not leave the inner half
/// of its band. Levels with the same number in `gate` keep one k. Pure.
std::vector<double> limits_between(const std::vector<JudgedAttempt>& experts,
                                   const std::vector<JudgedAttempt>& intermediates,
                                   const std::vector<int>& gate, const std::vector<double>& start);

/// How far a level may be off, in standard deviations: its mean is known from so many people only, so its
/// standard error is at most 1 / sqrt(people). 0 for nobody.
double level_margin(const std::vector<JudgedAttempt>& experts);

/// limits_between() with the attempts of experts worse by level_margin() at every level. A limit through the
/// middle of what experts do loses many of them to that, a wide one few, so that of two limits that are as
/// good on these attempts the wide one is chosen. Pure.
std::vector<double> limits_with_margin(const std::vector<JudgedAttempt>& experts,
                                       const std::vector<JudgedAttempt>& intermediates,
                                       const std::vector<int>& gate, const std::vector<double>& start);

/// The shares that pass limits in whose choice they had no part: people are divided into `held_out_parts`
/// parts, and each part is judged by limits_with_margin() of the others.
inline constexpr int held_out_parts = 5;
PassShares held_out_shares(const std::vector<JudgedAttempt>& experts,
                           const std::vector<JudgedAttempt>& intermediates, const std::vector<int>& gate,
                           const std::vector<double>& start);

/// The least share of experts left out of the choice that limits of their own may pass.
inline constexpr double least_held_out = experts_middle - 0.5 * experts_half;

struct HeldOutLimits {
    std::vector<double> k;
    PassShares held_out;  ///< what is to be expected of fresh attempts
    int people = 0;       ///< experts
    /// Wilson's 95 % interval of held_out.experts, with people and not attempts as its number: attempts of
    /// one person are alike.
    double experts_low = 0, experts_high = 1;
    bool sure() const { return held_out.experts >= least_held_out; }
};
/// limits_with_margin() and what they are worth. The held-out shares have no part in the choice, so that they
/// are not better than those of fresh attempts for having been chosen. Pure.
HeldOutLimits limits_for_fresh(const std::vector<JudgedAttempt>& experts,
                               const std::vector<JudgedAttempt>& intermediates, const std::vector<int>& gate,
                               const std::vector<double>& start);

}  // namespace fulcrum
