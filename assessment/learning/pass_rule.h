// SPDX-License-Identifier: Apache-2.0
// When a trainee is proficient in a task, as a rule on the sequence of passed and failed attempts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim_core/numerics/sentence.h"

namespace fulcrum {

enum class PassRuleKind : std::uint8_t {
    in_a_row,  ///< k passes in a row
    k_of_n,    ///< k passes among the last n attempts; may be met before n attempts
    lc_cusum   ///< learning-curve cumulative sum (Biau and Porcher 2010)
};

/// p0: acceptable share of failures; p1: unacceptable share, 0 < p0 < p1 < 1; h > 0: limit of the sum.
struct PassRule {
    PassRuleKind kind = PassRuleKind::in_a_row;
    int k = 2, n = 2;
    double p0 = 0.1, p1 = 0.3, h = 2.5;
};

/// "row:K", "of:K,N" or "lc-cusum:P0,P1,H", 1 <= K <= 60, N <= 16. Throws InputError.
PassRule parse_pass_rule(const std::string& text);
/// The text that parse_pass_rule() reads as the rule; numbers with at most six digits.
std::string pass_rule_text(const PassRule& rule);
/// The fewest attempts that a rule has to look at for its passes to be on two local dates and on `variants`
/// variants.
int least_window(int variants);
/// Whether the attempts that the rule looks at are that many; LC-CUSUM looks at as many as there are. Nobody
/// ever meets one that looks at fewer.
bool can_be_met(const PassRule& rule, int variants);
struct PassRuleProblem {
    Sentence problem, hint;
};
/// Why nobody can ever meet the rule; none where it can be met.
std::optional<PassRuleProblem> why_never_met(const PassRule& rule, int variants);
/// What an attempt adds to the sum of LC-CUSUM: ln((1 - p0)/(1 - p1)) for a pass, ln(p0/p1) for a failure.
/// The sum starts at 0 and never falls below it.
double lc_cusum_step(const PassRule& rule, bool passed);

/// What a rule does to trainees who pass each attempt with the same chance. T: the attempt at which the rule
/// is met.
struct OperatingPoint {
    double declared = 0;                              ///< chance that T <= attempts
    std::optional<double> mean_attempts_if_declared;  ///< E[T | T <= attempts]; none if that never happens
    std::optional<int> median_attempts;  ///< least t with P(T <= t) >= 1/2; none beyond `attempts`
};
/// Exact, by dynamic programming on whole-number states. `q`: chance of a pass, 0 to 1; `attempts` 1 to 1000.
/// Learning and the condition of two days are left out.
OperatingPoint operating_point(const PassRule& rule, double q, int attempts);
/// Chance that T <= t for t = 1 to `attempts`; as operating_point().
std::vector<double> operating_curve(const PassRule& rule, double q, int attempts);

}  // namespace fulcrum
