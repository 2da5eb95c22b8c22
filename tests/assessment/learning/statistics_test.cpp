// SPDX-License-Identifier: Apache-2.0
// The worked examples of docs/METRICS.md, and order statistics against exact binomials.
#include "assessment/learning/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fulcrum {
namespace {

TEST(ExpertBenchmark, TheWorkedExample) {
    const auto benchmark = expert_benchmark(
        {{"a", {10, 12, 14}}, {"b", {20, 22, 24}}, {"c", {15, 17, 19}}, {"d", {11, 13, 15}}}, 4);
    ASSERT_TRUE(benchmark);
    EXPECT_NEAR(benchmark->mean, 16.0, 1e-12);
    EXPECT_NEAR(benchmark->deviation, 4.8305, 5e-5);
    EXPECT_EQ(benchmark->experts, 4);
    EXPECT_TRUE(benchmark->left_out.empty());
}

TEST(ExpertBenchmark, LeavesOneExpertOutInOnePass) {
    std::vector<ExpertValues> experts;
    for (const double mean : {62, 58, 65, 60, 63, 59, 110, 61})
        experts.push_back({"expert " + std::to_string(static_cast<int>(mean)), {mean, mean, mean}});
    const auto benchmark = expert_benchmark(experts);
    ASSERT_TRUE(benchmark);
    ASSERT_EQ(benchmark->left_out.size(), 1U);
    EXPECT_EQ(benchmark->left_out[0].expert, "expert 110");
    EXPECT_EQ(benchmark->left_out[0].mean, 110.0);
    EXPECT_NEAR(benchmark->mean, 61.143, 5e-4);
    EXPECT_NEAR(benchmark->means_deviation, 2.410, 5e-4);
    EXPECT_NEAR(benchmark->deviation, 2.410, 5e-4);  // no spread within experts
    EXPECT_EQ(benchmark->experts, 7);
    const auto all = expert_benchmark(experts, 6, false);
    ASSERT_TRUE(all);
    EXPECT_TRUE(all->left_out.empty());
    EXPECT_EQ(all->experts, 8);
}

TEST(ExpertBenchmark, NeedsSixExperts) {
    std::vector<ExpertValues> experts;
    for (int i = 0; i < 6; ++i) experts.push_back({std::to_string(i), {10.0 + i, 11.0 + i}});
    EXPECT_TRUE(expert_benchmark(experts));
    experts[5].values.clear();
    EXPECT_FALSE(expert_benchmark(experts));
    EXPECT_FALSE(expert_benchmark({}));
}

TEST(ExpertBenchmark, UsesTheHarmonicMeanOfUnequalNumbers) {
    // Means 10 and 20, within-expert mean square 2, attempts 2 and 4: r = 8/3, s2 = 50.
    const auto benchmark =
        expert_benchmark({{"a", {9, 11}}, {"b", {20 - std::sqrt(2.0), 20 + std::sqrt(2.0), 20, 20}}}, 2);
    ASSERT_TRUE(benchmark);
    const double mean_square = (2.0 + 4.0) / 4.0;
    EXPECT_NEAR(benchmark->deviation, std::sqrt(50.0 - mean_square * 3.0 / 8.0 + mean_square), 1e-12);
}

TEST(ExpertBenchmark, IsNeverBelowTheSpreadWithinExperts) {
    const auto benchmark = expert_benchmark({{"a", {0, 10}}, {"b", {0.1, 10.1}}}, 2);
    ASSERT_TRUE(benchmark);
    EXPECT_NEAR(benchmark->deviation, std::sqrt(50.0), 1e-9);
}

TEST(Median, OfOddAndEvenNumbers) {
    EXPECT_EQ(median_of({3, 1, 2}), 2.0);
    EXPECT_EQ(median_of({4, 1, 3, 2}), 2.5);
    EXPECT_EQ(median_of({7}), 7.0);
}

TEST(MedianInterval, OfTwentyValuesIsTheSixthToTheFifteenth) {
    std::vector<double> values;
    for (int i = 20; i >= 1; --i) values.push_back(i);
    const auto interval = median_interval(values);
    ASSERT_TRUE(interval);
    EXPECT_EQ(interval->rank_low, 6);
    EXPECT_EQ(interval->low, 6.0);
    EXPECT_EQ(interval->high, 15.0);
    EXPECT_EQ(interval->median, 10.5);
    // 1 - 2 P(B <= 5), B binomial(20, 1/2) = 1 - 2 * 21700 / 2^20
    EXPECT_NEAR(interval->coverage, 1.0 - 2.0 * 21700.0 / 1048576.0, 1e-12);
}

TEST(MedianInterval, NeedsSixValues) {
    EXPECT_FALSE(median_interval({1, 2, 3, 4, 5}));
    const auto six = median_interval({1, 2, 3, 4, 5, 6});
    ASSERT_TRUE(six);
    EXPECT_EQ(six->low, 1.0);
    EXPECT_EQ(six->high, 6.0);
    EXPECT_NEAR(six->coverage, 1.0 - 2.0 / 64.0, 1e-12);
    EXPECT_FALSE(median_interval({}));
}

TEST(MedianInterval, CoversAsOftenAsStated) {
    std::mt19937 random(11);
    std::exponential_distribution<double> draw(1.0);
    int covered = 0;
    constexpr int trials = 4000;
    for (int k = 0; k < trials; ++k) {
        std::vector<double> values;
        for (int i = 0; i < 20; ++i) values.push_back(draw(random));
        const auto interval = median_interval(values);
        covered += interval->low <= std::log(2.0) && std::log(2.0) <= interval->high ? 1 : 0;
    }
    EXPECT_NEAR(covered / static_cast<double>(trials), 0.9586, 0.012);
}

/// Ratings 1 to 5 with how often each was given.
std::vector<double> ratings(const std::vector<int>& counts) {
    std::vector<double> values;
    for (std::size_t i = 0; i < counts.size(); ++i)
        values.insert(values.end(), static_cast<std::size_t>(counts[i]), static_cast<double>(i + 1));
    return values;
}

TEST(RocArea, OfHanleyAndMcNeilsImagesIsThePublishedOne) {
    // Radiology 1982; 143: 29-36, table I: 51 abnormal and 58 normal CT images; area 0.893.
    const auto area = roc_area(ratings({3, 2, 2, 11, 33}), ratings({33, 6, 6, 11, 2}));
    ASSERT_TRUE(area);
    EXPECT_NEAR(area->area, 0.893, 5e-4);
    EXPECT_NEAR(area->area, 2642.0 / (51.0 * 58.0), 1e-12);
    // Newcombe's method 5, solved by an independent program.
    EXPECT_NEAR(area->low, 0.811688, 1e-6);
    EXPECT_NEAR(area->high, 0.940006, 1e-6);
}

TEST(RocArea, IsTheChanceOfAPairAndCountsTiesByHalf) {
    EXPECT_EQ(roc_area({3, 4}, {1, 2})->area, 1.0);
    EXPECT_EQ(roc_area({1, 2}, {3, 4})->area, 0.0);
    EXPECT_EQ(roc_area({1, 2}, {1, 2})->area, 0.5);
    EXPECT_EQ(roc_area({0, 0, 5}, {0, 0})->area, 4.0 / 6.0);
    EXPECT_FALSE(roc_area({}, {1}));
    EXPECT_FALSE(roc_area({1}, {}));
}

TEST(RocArea, KeepsAnIntervalWhereTheGroupsAreFullyApart) {
    std::vector<double> high(60, 2.0), low(60, 1.0);
    const auto area = roc_area(high, low);
    EXPECT_EQ(area->high, 1.0);
    EXPECT_NEAR(area->low, 0.967095, 1e-6);
    const auto reversed = roc_area(low, high);
    EXPECT_EQ(reversed->low, 0.0);
    EXPECT_NEAR(reversed->high, 1.0 - 0.967095, 1e-6);
}

TEST(RocArea, IntervalCoversAsOftenAsStated) {
    // Normal groups sqrt(2) apart: the area is Phi(1) = 0.8413447.
    std::mt19937 random(12);
    std::normal_distribution<double> draw;
    int covered = 0;
    constexpr int trials = 2000;
    for (int k = 0; k < trials; ++k) {
        std::vector<double> better, worse;
        for (int i = 0; i < 20; ++i) {
            better.push_back(draw(random) + std::sqrt(2.0));
            worse.push_back(draw(random));
        }
        const auto area = roc_area(better, worse);
        covered += area->low <= 0.8413447 && 0.8413447 <= area->high ? 1 : 0;
    }
    EXPECT_NEAR(covered / static_cast<double>(trials), 0.95, 0.02);
}

TEST(RetestCorrelation, IsOneForEqualAttemptsAndFollowsItsClosedForm) {
    EXPECT_DOUBLE_EQ(*retest_correlation({{1, 1}, {2, 2}, {4, 4}}), 1);
    // Means 2, 3, 4: MSB = 2 * 1; differences of 2: MSW = 2; (2 - 2) / (2 + 2).
    EXPECT_DOUBLE_EQ(*retest_correlation({{1, 3}, {4, 2}, {3, 5}}), 0);
    // Equal means: nothing but the scatter of attempts.
    EXPECT_DOUBLE_EQ(*retest_correlation({{1, 3}, {3, 1}, {1, 3}}), -1);
    EXPECT_FALSE(retest_correlation({{1, 2}, {2, 3}}));
    EXPECT_FALSE(retest_correlation({{5, 5}, {5, 5}, {5, 5}}));
}

}  // namespace
}  // namespace fulcrum
