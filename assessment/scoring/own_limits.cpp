// SPDX-License-Identifier: Apache-2.0
#include "assessment/scoring/own_limits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/learning/survival.h"

namespace fulcrum {
namespace {

constexpr double same = 1e-9;
constexpr int k_steps = 21;  // tenths from the least to the largest k, both included
static_assert(least_k + 0.1 * (k_steps - 1) > largest_k - 1e-9 &&
              least_k + 0.1 * (k_steps - 1) < largest_k + 1e-9);

double k_at(int step) {
    return (10 * least_k + step) / 10;
}

/// The least step whose k the value meets; k_steps where none does.
int first_step(double z) {
    int step = std::clamp(static_cast<int>(std::ceil(10 * (z - least_k) - 1e-6)), 0, k_steps);
    while (step > 0 && z <= k_at(step - 1)) --step;
    while (step < k_steps && !(z <= k_at(step))) ++step;
    return step;
}

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

/// The levels of each gate, gates in the order of their first levels.
std::vector<std::vector<std::size_t>> levels_by_gate(const std::vector<int>& gate) {
    std::vector<std::vector<std::size_t>> levels;
    std::vector<int> known;
    for (std::size_t level = 0; level < gate.size(); ++level) {
        const auto place = std::find(known.begin(), known.end(), gate[level]) - known.begin();
        if (place == static_cast<std::ptrdiff_t>(known.size())) {
            known.push_back(gate[level]);
            levels.emplace_back();
        }
        levels[static_cast<std::size_t>(place)].push_back(level);
    }
    return levels;
}

/// How many attempts meet everything, with the k of two gates at each pair of steps.
using PairCounts = std::array<std::array<int, k_steps>, k_steps>;

PairCounts count_pairs(const std::vector<JudgedAttempt>& attempts, const std::vector<double>& k,
                       const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
    std::vector<double> others = k;
    for (const auto* levels : {&a, &b})
        for (const std::size_t level : *levels) others[level] = no_limit;
    const auto worst_step = [](const JudgedAttempt& attempt, const std::vector<std::size_t>& levels) {
        int step = 0;
        for (const std::size_t level : levels) step = std::max(step, first_step(attempt.z[level]));
        return static_cast<std::size_t>(step);
    };
    PairCounts counts{};
    for (const JudgedAttempt& attempt : attempts) {
        bool met = attempt.otherwise;
        for (std::size_t i = 0; met && i < others.size(); ++i) met = attempt.z[i] <= others[i];
        if (!met) continue;
        const std::size_t i = worst_step(attempt, a), j = worst_step(attempt, b);
        if (i < k_steps && j < k_steps) ++counts[i][j];
    }
    for (std::size_t i = 0; i < k_steps; ++i)
        for (std::size_t j = 1; j < k_steps; ++j) counts[i][j] += counts[i][j - 1];
    for (std::size_t i = 1; i < k_steps; ++i)
        for (std::size_t j = 0; j < k_steps; ++j) counts[i][j] += counts[i - 1][j];
    return counts;
}

double part_of(int count, const std::vector<JudgedAttempt>& attempts) {
    return attempts.empty() ? 0 : static_cast<double>(count) / static_cast<double>(attempts.size());
}

/// One step of limits_between(): the best change of the k of one or two gates.
class BestChange {
  public:
    BestChange(const std::vector<double>& from, double off_before, double furthest)
        : k(from), off(off_before), from_(from), furthest_(furthest) {}
    std::vector<double> k;
    double off = 0;
    bool better = false;

    void consider(const PassShares& shares, const std::vector<std::size_t>& a, double k_a,
                  const std::vector<std::size_t>& b, double k_b) {
        if (std::abs(shares.experts - experts_middle) > furthest_ + same) return;
        const double tried_off = off_middles(shares);
        if (tried_off >= off + same || (!better && tried_off >= off - same)) return;
        std::vector<double> tried = from_;
        for (const std::size_t level : b) tried[level] = k_b;
        for (const std::size_t level : a) tried[level] = k_a;
        double moved = 0;
        for (std::size_t i = 0; i < tried.size(); ++i) moved += std::abs(tried[i] - from_[i]);
        if (tried_off >= off - same && moved >= moved_ - same) return;
        better = true;
        off = tried_off;
        moved_ = moved;
        k = std::move(tried);
    }

  private:
    std::vector<double> from_;
    double furthest_, moved_ = 0;
};

/// People in the order of their first attempts.
std::vector<int> people_in(const std::vector<JudgedAttempt>& attempts) {
    std::vector<int> people;
    for (const JudgedAttempt& attempt : attempts)
        if (std::find(people.begin(), people.end(), attempt.person) == people.end())
            people.push_back(attempt.person);
    return people;
}

/// The attempts of one part of the people, or of all others.
std::vector<JudgedAttempt> part_of_people(const std::vector<JudgedAttempt>& attempts, int part, bool others) {
    const std::vector<int> people = people_in(attempts);
    std::vector<JudgedAttempt> chosen;
    for (const JudgedAttempt& attempt : attempts) {
        const auto place = std::find(people.begin(), people.end(), attempt.person) - people.begin();
        if ((place % held_out_parts == part) != others) chosen.push_back(attempt);
    }
    return chosen;
}

}  // namespace

bool intermediates_surely_within(int passed, int attempts) {
    const Share share = wilson(passed, attempts);
    return share.low >= intermediates_middle - intermediates_half &&
           share.high <= intermediates_middle + intermediates_half;
}

PassShares pass_shares(const std::vector<JudgedAttempt>& experts,
                       const std::vector<JudgedAttempt>& intermediates, const std::vector<double>& k) {
    return {share_of(experts, k), share_of(intermediates, k)};
}

std::vector<double> limits_between(const std::vector<JudgedAttempt>& experts,
                                   const std::vector<JudgedAttempt>& intermediates,
                                   const std::vector<int>& gate, const std::vector<double>& start) {
    const std::vector<std::vector<std::size_t>> levels = levels_by_gate(gate);
    const PassShares at_start = pass_shares(experts, intermediates, start);
    const double furthest = std::max(0.5 * experts_half, std::abs(at_start.experts - experts_middle));
    std::vector<double> k = start;
    double off = off_middles(at_start);
    for (bool better = true; better;) {
        BestChange best(k, off, furthest);
        for (std::size_t a = 0; a < levels.size(); ++a) {
            for (std::size_t b = a; b < levels.size(); ++b) {
                const PairCounts of_experts = count_pairs(experts, k, levels[a], levels[b]),
                                 of_intermediates = count_pairs(intermediates, k, levels[a], levels[b]);
                for (std::size_t i = 0; i < k_steps; ++i)
                    for (std::size_t j = a == b ? i : 0; j < (a == b ? i + 1 : k_steps); ++j)
                        best.consider({part_of(of_experts[i][j], experts),
                                       part_of(of_intermediates[i][j], intermediates)},
                                      levels[a], k_at(static_cast<int>(i)), levels[b],
                                      k_at(static_cast<int>(j)));
            }
        }
        better = best.better;
        k = best.k;
        off = best.off;
    }
    return k;
}

double level_margin(const std::vector<JudgedAttempt>& experts) {
    return experts.empty() ? 0 : 1 / std::sqrt(static_cast<double>(people_in(experts).size()));
}

std::vector<double> limits_with_margin(const std::vector<JudgedAttempt>& experts,
                                       const std::vector<JudgedAttempt>& intermediates,
                                       const std::vector<int>& gate, const std::vector<double>& start) {
    const double margin = level_margin(experts);
    std::vector<JudgedAttempt> worse = experts;
    for (JudgedAttempt& attempt : worse)
        for (double& z : attempt.z) z += margin;
    return limits_between(worse, intermediates, gate, start);
}

PassShares held_out_shares(const std::vector<JudgedAttempt>& experts,
                           const std::vector<JudgedAttempt>& intermediates, const std::vector<int>& gate,
                           const std::vector<double>& start) {
    PassShares passed;
    for (int part = 0; part < held_out_parts; ++part) {
        const std::vector<JudgedAttempt> left_out[] = {part_of_people(experts, part, false),
                                                       part_of_people(intermediates, part, false)};
        const PassShares shares =
            pass_shares(left_out[0], left_out[1],
                        limits_with_margin(part_of_people(experts, part, true),
                                           part_of_people(intermediates, part, true), gate, start));
        passed.experts += shares.experts * static_cast<double>(left_out[0].size());
        passed.intermediates += shares.intermediates * static_cast<double>(left_out[1].size());
    }
    if (!experts.empty()) passed.experts /= static_cast<double>(experts.size());
    if (!intermediates.empty()) passed.intermediates /= static_cast<double>(intermediates.size());
    return passed;
}

HeldOutLimits limits_for_fresh(const std::vector<JudgedAttempt>& experts,
                               const std::vector<JudgedAttempt>& intermediates, const std::vector<int>& gate,
                               const std::vector<double>& start) {
    HeldOutLimits chosen;
    chosen.k = limits_with_margin(experts, intermediates, gate, start);
    chosen.held_out = held_out_shares(experts, intermediates, gate, start);
    chosen.people = static_cast<int>(people_in(experts).size());
    const Share share =
        wilson(static_cast<int>(std::lround(chosen.held_out.experts * chosen.people)), chosen.people);
    chosen.experts_low = share.low;
    chosen.experts_high = share.high;
    return chosen;
}

}  // namespace fulcrum
