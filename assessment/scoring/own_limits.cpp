// SPDX-License-Identifier: Apache-2.0
#include "assessment/scoring/own_limits.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double same = 1e-9;
constexpr int k_steps = 20;  // tenths between the least and the largest k
static_assert(least_k + 0.1 * k_steps > largest_k - 1e-9 && least_k + 0.1 * k_steps < largest_k + 1e-9);

double share_of(const std::vector<JudgedAttempt>& attempts, const std::vector<double>& k) {
    if (attempts.empty()) return 0;
    const auto passes = [&](const JudgedAttempt& attempt) {
        for (std::size_t i = 0; i < k.size(); ++i)
            if (!(attempt.z[i] <= k[i])) return false;
        return attempt.otherwise;
    };
    return static_cast<double>(std::count_if(attempts.begin(), attempts.end(), passes)) /
           static_cast<double>(attempts.size());
}

/// Sum of the squared distances from the middles of both bands, in half widths.
double off_middles(const PassShares& shares) {
    const double experts = (shares.experts - experts_middle) / experts_half,
                 intermediates = (shares.intermediates - intermediates_middle) / intermediates_half;
    return experts * experts + intermediates * intermediates;
}

struct Choice {
    std::vector<double> k;
    double off = 0, moved = 0;  ///< off_middles(); how far k is from where this step began
};

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum;
}

/// Whether this is the first level of its gate.
bool is_first(const std::vector<int>& gate, std::size_t level) {
    const auto first = std::find(gate.begin(), gate.end(), gate[level]);
    return first - gate.begin() == static_cast<std::ptrdiff_t>(level);
}

/// `k` with the gate of a level at step i of k_steps.
std::vector<double> changed(std::vector<double> k, const std::vector<int>& gate, std::size_t level, int i) {
    for (std::size_t other = 0; other < gate.size(); ++other)
        if (gate[other] == gate[level]) k[other] = (10 * least_k + i) / 10;
    return k;
}

}  // namespace

bool intermediates_well_within(double share) {
    return std::abs(share - intermediates_middle) <= well_within * intermediates_half;
}

PassShares pass_shares(const std::vector<JudgedAttempt>& experts,
                       const std::vector<JudgedAttempt>& intermediates, const std::vector<double>& k) {
    return {share_of(experts, k), share_of(intermediates, k)};
}

std::vector<double> limits_between(const std::vector<JudgedAttempt>& experts,
                                   const std::vector<JudgedAttempt>& intermediates,
                                   const std::vector<int>& gate, const std::vector<double>& start) {
    const double expert_share = pass_shares(experts, intermediates, start).experts;
    const double furthest = std::max(0.5 * experts_half, std::abs(expert_share - experts_middle));
    Choice chosen{start, off_middles(pass_shares(experts, intermediates, start)), 0};
    for (bool better = true; better;) {
        better = false;
        const std::vector<double> from = chosen.k;
        chosen.moved = 0;
        const auto consider = [&](const std::vector<double>& k) {
            const PassShares shares = pass_shares(experts, intermediates, k);
            if (std::abs(shares.experts - experts_middle) > furthest + same) return;
            const Choice tried{k, off_middles(shares), distance(k, from)};
            const bool nearer = tried.off < chosen.off - same;
            const bool as_near = better && tried.off < chosen.off + same && tried.moved < chosen.moved - same;
            if (!nearer && !as_near) return;
            better = true;
            chosen = tried;
        };
        for (std::size_t a = 0; a < gate.size(); ++a) {
            for (std::size_t b = a; b < gate.size(); ++b) {
                if (!is_first(gate, a) || !is_first(gate, b)) continue;
                for (int i = 0; i <= k_steps; ++i)
                    for (int j = a == b ? k_steps : 0; j <= k_steps; ++j)
                        consider(changed(changed(from, gate, b, j), gate, a, i));
            }
        }
    }
    return chosen.k;
}

}  // namespace fulcrum
