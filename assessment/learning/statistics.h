// SPDX-License-Identifier: Apache-2.0
// Statistics for benchmarks and comparisons.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum {

/// Precondition: not empty.
double mean_of(const std::vector<double>& values);
/// n-1 in the denominator; 0 for one value.
double sample_deviation(const std::vector<double>& values);
/// Mean of the middle two for an even number. Precondition: not empty.
double median_of(std::vector<double> values);

/// A median with a distribution-free interval from order statistics.
struct MedianInterval {
    double median = 0;
    double low = 0, high = 0;  ///< order statistics number rank_low and n + 1 - rank_low
    int rank_low = 0;          ///< from 1
    double coverage = 0;       ///< exact binomial coverage, >= the requested level
};
/// Narrowest symmetric pair of order statistics that covers the median with at least `level`; none if even
/// the extremes do not (fewer than 6 values at 0.95).
std::optional<MedianInterval> median_interval(std::vector<double> values, double level = 0.95);

/// Area under the ROC curve: the chance that a random member of one group has a higher value than a random
/// member of the other, ties counting one half.
struct RocArea {
    double area = 0;
    double low = 0, high = 0;  ///< 95 % interval
};
/// Chance that a value of `better` exceeds a value of `worse` (Mann-Whitney), with Newcombe's interval
/// (Newcombe 2006, method 5), which keeps its width where the groups are fully
/// apart. None if a group is empty.
std::optional<RocArea> roc_area(const std::vector<double>& better, const std::vector<double>& worse);

/// Intraclass correlation ICC(1,1) (Shrout and Fleiss 1979) of two attempts of each individual: 1 where they
/// agree, about 0 where individuals differ no more than attempts do. None for fewer than 3 pairs, or where
/// all values are equal.
std::optional<double> retest_correlation(const std::vector<std::pair<double, double>>& attempts);

/// The attempts of one expert in one metric, on the metric's scale.
struct ExpertValues {
    std::string expert;
    std::vector<double> values;
};
/// An expert whose mean lay beyond +-1.96 SD of the experts' means.
struct LeftOutExpert {
    std::string expert;
    double mean = 0;
};
struct ExpertBenchmark {
    double mean = 0;             ///< mean of the experts' means
    double deviation = 0;        ///< of a single attempt: sqrt(max(0, s2_means - MSW/r) + MSW)
    double means_deviation = 0;  ///< SD (n-1) of the experts' means
    int experts = 0;             ///< counted
    std::vector<LeftOutExpert> left_out;
};
/// One pass of the outlier rule, then the random-effects estimate; experts without values are not counted.
/// None if fewer than `minimum_experts` are left.
/// Without `outliers` nobody is left out.
std::optional<ExpertBenchmark> expert_benchmark(const std::vector<ExpertValues>& experts,
                                                int minimum_experts = 6, bool outliers = true);

}  // namespace fulcrum
