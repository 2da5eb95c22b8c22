// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/paired_shift.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

std::vector<double> normal_values(Random& random, int count, double mean, double deviation) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(mean + deviation * random.normal());
    return values;
}

TEST(StudentT, AgreesWithTheTable) {
    const std::pair<int, double> rows[] = {{1, 12.706204736}, {2, 4.302652730},   {3, 3.182446305},
                                           {5, 2.570581836},  {10, 2.228138852},  {30, 2.042272456},
                                           {59, 2.000995378}, {1000, 1.962339081}};
    for (const auto& [freedom, expected] : rows)
        EXPECT_NEAR(student_t(freedom, 0.95), expected, 1e-8 * expected) << freedom;
    EXPECT_NEAR(student_t(4, 0.99), 4.604094871, 1e-8);
}

TEST(PairedShift, OfKnownPairs) {
    const auto shift = paired_shift({2, 4, 6}, {1, 2, 3});  // differences 1, 2, 3
    ASSERT_TRUE(shift);
    EXPECT_EQ(shift->pairs, 3);
    EXPECT_DOUBLE_EQ(shift->reference, 2);
    EXPECT_DOUBLE_EQ(shift->shift, 2);
    const double half = 4.302652730 / std::sqrt(3.0);
    EXPECT_NEAR(shift->low, 2 - half, 1e-8);
    EXPECT_NEAR(shift->high, 2 + half, 1e-8);
    EXPECT_FALSE(paired_shift({1}, {1}));
    EXPECT_FALSE(paired_shift({1, 2, 3}, {1, 2}));
}

TEST(PairedShift, OfEqualValuesIsNothingAtAll) {
    const auto shift = paired_shift({0.1, 0.7, 1e9}, {0.1, 0.7, 1e9});
    ASSERT_TRUE(shift);
    EXPECT_EQ(shift->low, 0);
    EXPECT_EQ(shift->high, 0);
}

TEST(PairedShift, IntervalContainsTheTruthNineteenTimesInTwenty) {
    Random random(7);
    constexpr int studies = 4000;
    int contained = 0;
    for (int i = 0; i < studies; ++i) {
        std::vector<double> references = normal_values(random, 8, 10, 3), values = references;
        for (double& value : values) value += 0.4 + random.normal();
        const auto shift = paired_shift(values, references);
        if (shift->low <= 0.4 && 0.4 <= shift->high) ++contained;
    }
    // Four standard errors of a share of 0.95.
    EXPECT_NEAR(contained / static_cast<double>(studies), 0.95, 4 * std::sqrt(0.95 * 0.05 / studies));
}

RC_GTEST_PROP(PairedShiftProperty, MovesScalesAndReversesWithItsValues, (std::uint64_t seed)) {
    Random random(seed);
    const int count = 2 + static_cast<int>(random.below(40));
    const std::vector<double> a = normal_values(random, count, 5, 2), b = normal_values(random, count, 4, 1);
    const auto shift = *paired_shift(a, b), reversed = *paired_shift(b, a);
    RC_ASSERT(shift.low <= shift.shift && shift.shift <= shift.high);
    RC_ASSERT(std::fabs(shift.low + reversed.high) < 1e-12 * (1 + std::fabs(shift.low)));
    const double moved = random.uniform(-3, 3), scale = random.uniform(0.1, 10);
    std::vector<double> further = a, scaled_a = a, scaled_b = b;
    for (std::size_t i = 0; i < a.size(); ++i) {
        further[i] += moved;
        scaled_a[i] *= scale;
        scaled_b[i] *= scale;
    }
    const auto more = *paired_shift(further, b), larger = *paired_shift(scaled_a, scaled_b);
    RC_ASSERT(std::fabs(more.shift - shift.shift - moved) < 1e-10);
    RC_ASSERT(std::fabs((more.high - more.low) - (shift.high - shift.low)) < 1e-9);
    RC_ASSERT(std::fabs(larger.high - scale * shift.high) < 1e-9 * (1 + std::fabs(larger.high)));
}

RC_GTEST_PROP(PairedShiftProperty, DoesNotDependOnTheOrderOfThePairs, (std::uint64_t seed)) {
    Random random(seed);
    const std::vector<double> a = normal_values(random, 12, 5, 2), b = normal_values(random, 12, 4, 1);
    std::vector<double> reversed_a(a.rbegin(), a.rend()), reversed_b(b.rbegin(), b.rend());
    const auto shift = *paired_shift(a, b), again = *paired_shift(reversed_a, reversed_b);
    RC_ASSERT(std::fabs(shift.low - again.low) < 1e-12 && std::fabs(shift.high - again.high) < 1e-12);
}

}  // namespace
}  // namespace fulcrum
