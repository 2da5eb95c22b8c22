// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/random.h"

#include <gtest/gtest.h>

namespace fulcrum {
namespace {

TEST(Random, SameSeedRepeatsAndOtherSeedsDiffer) {
    Random a(7), b(7), c(8), d(7, 1);
    int same_seed = 0, same_stream = 0;
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t value = a.bits();
        EXPECT_EQ(value, b.bits());
        same_seed += value == c.bits() ? 1 : 0;
        same_stream += value == d.bits() ? 1 : 0;
    }
    EXPECT_EQ(same_seed, 0);
    EXPECT_EQ(same_stream, 0);
}

TEST(Random, MomentsOfUniformAndNormal) {
    Random random(1);
    constexpr int n = 200000;
    double sum = 0, squares = 0, uniform = 0, fourth = 0;
    for (int i = 0; i < n; ++i) {
        const double u = random.uniform(), x = random.normal();
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
        uniform += u;
        sum += x;
        squares += x * x;
        fourth += x * x * x * x;
    }
    // Four standard errors each.
    EXPECT_NEAR(uniform / n, 0.5, 4 * 0.2887 / 447.2);
    EXPECT_NEAR(sum / n, 0, 4 / 447.2);
    EXPECT_NEAR(squares / n, 1, 4 * 1.4142 / 447.2);
    EXPECT_NEAR(fourth / n, 3, 4 * 9.8 / 447.2);
}

TEST(Random, BelowCoversItsRangeOnly) {
    Random random(3);
    int seen[7] = {};
    for (int i = 0; i < 7000; ++i) {
        const std::uint32_t k = random.below(7);
        ASSERT_LT(k, 7U);
        ++seen[k];
    }
    for (const int count : seen) EXPECT_GT(count, 800);
}

}  // namespace
}  // namespace fulcrum
