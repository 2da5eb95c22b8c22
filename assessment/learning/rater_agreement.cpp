// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/rater_agreement.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>

namespace fulcrum {
namespace {

/// The raters who may enter the table, by name.
std::vector<std::string> raters_of(const std::map<std::string, std::map<std::string, double>>& by_target) {
    std::map<std::string, int> counts;
    for (const auto& [target, scores] : by_target)
        for (const auto& [rater, score] : scores) ++counts[rater];
    std::vector<std::string> raters;
    for (const auto& [rater, count] : counts) raters.push_back(rater);
    std::stable_sort(raters.begin(), raters.end(),
                     [&](const std::string& a, const std::string& b) { return counts[a] > counts[b]; });
    if (raters.size() > most_raters) raters.resize(most_raters);
    std::sort(raters.begin(), raters.end());
    return raters;
}

}  // namespace

RatingTable largest_complete_table(const std::vector<RaterScore>& scores) {
    std::map<std::string, std::map<std::string, double>> by_target;
    for (const RaterScore& one : scores) by_target[one.target][one.rater] = one.score;
    const std::vector<std::string> raters = raters_of(by_target);

    // A target as the set of the raters who rated it, a bit each, the first by name highest: of two equal
    // groups the one with the greater number comes first.
    std::vector<std::uint32_t> rated;
    for (const auto& [target, by_rater] : by_target) {
        std::uint32_t bits = 0;
        for (const std::string& rater : raters)
            bits = bits * 2 + static_cast<std::uint32_t>(by_rater.count(rater));
        rated.push_back(bits);
    }
    std::uint32_t best = 0;
    std::size_t best_cells = 0, best_targets = 0;
    for (std::uint32_t group = (1U << raters.size()) - 1; group > 0; --group) {
        std::size_t people = 0;
        for (std::uint32_t bits = group; bits != 0; bits &= bits - 1) ++people;
        const auto targets = static_cast<std::size_t>(std::count_if(
            rated.begin(), rated.end(), [&](std::uint32_t bits) { return (bits & group) == group; }));
        if (people < 2 || targets < 2) continue;
        const std::size_t cells = people * targets;
        if (cells > best_cells || (cells == best_cells && targets > best_targets)) {
            best = group;
            best_cells = cells;
            best_targets = targets;
        }
    }
    RatingTable table;
    for (std::size_t i = 0; i < raters.size(); ++i)
        if ((best >> (raters.size() - 1 - i) & 1U) != 0) table.raters.push_back(raters[i]);
    if (table.raters.empty()) return table;
    for (const auto& [target, by_rater] : by_target) {
        const bool complete =
            std::all_of(table.raters.begin(), table.raters.end(),
                        [&, &row = by_rater](const std::string& rater) { return row.count(rater) > 0; });
        if (!complete) continue;
        table.targets.push_back(target);
        std::vector<double> row;
        for (const std::string& rater : table.raters) row.push_back(by_rater.at(rater));
        table.scores.push_back(std::move(row));
    }
    return table;
}

std::optional<Correlation> agreement_of(const RatingTable& table) {
    if (table.scores.empty()) return std::nullopt;
    std::set<double> different;
    for (const std::vector<double>& row : table.scores) different.insert(row.begin(), row.end());
    if (different.size() < 2) return std::nullopt;
    return intraclass_correlations(table.scores).two_1;
}

AgreementLevel agreement_level(double icc) {
    if (icc < 0.5) return AgreementLevel::poor;
    if (icc < 0.75) return AgreementLevel::moderate;
    return icc < 0.9 ? AgreementLevel::good : AgreementLevel::excellent;
}

}  // namespace fulcrum
