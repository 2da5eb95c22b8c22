// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fulcrum {

double mean_of(const std::vector<double>& values) {
    assert(!values.empty());
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double sample_deviation(const std::vector<double>& values) {
    if (values.size() < 2) return 0;
    const double mean = mean_of(values);
    double square = 0;
    for (const double value : values) square += (value - mean) * (value - mean);
    return std::sqrt(square / static_cast<double>(values.size() - 1));
}

double median_of(std::vector<double> values) {
    assert(!values.empty());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

std::optional<MedianInterval> median_interval(std::vector<double> values, double level) {
    const auto n = static_cast<int>(values.size());
    if (n == 0) return std::nullopt;
    std::sort(values.begin(), values.end());
    // The interval from rank r to n + 1 - r misses the median with probability 2 P(B <= r - 1), B binomial(n,
    // 1/2).
    double term = std::pow(0.5, n), tail = 0;
    std::optional<MedianInterval> best;
    for (int r = 1; 2 * r <= n; ++r) {
        tail += term;
        const double coverage = 1.0 - 2.0 * tail;
        if (coverage < level) break;
        best = MedianInterval{median_of(values), values[static_cast<std::size_t>(r - 1)],
                              values[static_cast<std::size_t>(n - r)], r, coverage};
        term *= static_cast<double>(n - r + 1) / r;
    }
    return best;
}

std::optional<RocArea> roc_area(const std::vector<double>& better, const std::vector<double>& worse) {
    if (better.empty() || worse.empty()) return std::nullopt;
    double wins = 0;
    for (const double b : better)
        for (const double w : worse) wins += b > w ? 1.0 : b == w ? 0.5 : 0.0;
    const double pairs = static_cast<double>(better.size()) * static_cast<double>(worse.size());
    const double area = wins / pairs;
    const double others = 0.5 * static_cast<double>(better.size() + worse.size()) - 1.0;
    // Hanley and McNeil's variance for two exponential distributions, at the bound itself instead of at the
    // estimate, with both group sizes in its terms replaced by their mean.
    const auto beyond = [&](double bound) {
        const double variance =
            bound * (1 - bound) * (1 + others * ((1 - bound) / (2 - bound) + bound / (1 + bound))) / pairs;
        constexpr double z = 1.959963984540054;
        return std::abs(area - bound) > z * std::sqrt(variance);
    };
    const auto bound_from = [&](double outside) {
        double inside = area;
        for (int i = 0; i < 100; ++i) {
            const double middle = 0.5 * (outside + inside);
            (beyond(middle) ? outside : inside) = middle;
        }
        return 0.5 * (outside + inside);
    };
    return RocArea{area, bound_from(0), bound_from(1)};
}

std::optional<ExpertBenchmark> expert_benchmark(const std::vector<ExpertValues>& experts, int minimum_experts,
                                                bool outliers) {
    std::vector<const ExpertValues*> counted;
    std::vector<double> means;
    for (const ExpertValues& expert : experts) {
        if (expert.values.empty()) continue;
        counted.push_back(&expert);
        means.push_back(mean_of(expert.values));
    }
    if (counted.empty()) return std::nullopt;
    ExpertBenchmark out;
    const double centre = mean_of(means), reach = 1.96 * sample_deviation(means);
    std::vector<const ExpertValues*> kept;
    std::vector<double> kept_means;
    for (std::size_t i = 0; i < counted.size(); ++i) {
        if (outliers && std::abs(means[i] - centre) > reach && reach > 0) {
            out.left_out.push_back({counted[i]->expert, means[i]});
        } else {
            kept.push_back(counted[i]);
            kept_means.push_back(means[i]);
        }
    }
    if (static_cast<int>(kept.size()) < minimum_experts) return std::nullopt;
    double within = 0, within_freedom = 0, inverse_attempts = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        for (const double value : kept[i]->values)
            within += (value - kept_means[i]) * (value - kept_means[i]);
        within_freedom += static_cast<double>(kept[i]->values.size() - 1);
        inverse_attempts += 1.0 / static_cast<double>(kept[i]->values.size());
    }
    const double mean_square = within_freedom > 0 ? within / within_freedom : 0.0;
    const double attempts = static_cast<double>(kept.size()) / inverse_attempts;  // harmonic mean
    out.experts = static_cast<int>(kept.size());
    out.mean = mean_of(kept_means);
    out.means_deviation = sample_deviation(kept_means);
    const double between = out.means_deviation * out.means_deviation - mean_square / attempts;
    out.deviation = std::sqrt(std::max(0.0, between) + mean_square);
    return out;
}

std::optional<double> retest_correlation(const std::vector<std::pair<double, double>>& attempts) {
    if (attempts.size() < 3) return std::nullopt;
    std::vector<double> means;
    double within = 0;
    for (const auto& [first, second] : attempts) {
        means.push_back(0.5 * (first + second));
        within += 0.5 * (first - second) * (first - second);
    }
    within /= static_cast<double>(attempts.size());
    const double deviation = sample_deviation(means), between = 2 * deviation * deviation;
    if (!(between + within > 0)) return std::nullopt;
    return (between - within) / (between + within);
}

}  // namespace fulcrum
