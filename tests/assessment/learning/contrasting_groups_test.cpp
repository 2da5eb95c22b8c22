// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/contrasting_groups.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

double log_density(const GroupSpread& group, double x) {
    const double z = (x - group.mean) / group.deviation;
    return -0.5 * z * z - std::log(group.deviation);
}

TEST(ContrastingGroups, EqualSpreadsGiveTheMidpointAndEqualShares) {
    const auto mark = contrasting_groups({70, 10}, {40, 10});
    ASSERT_TRUE(mark.has_value());
    EXPECT_NEAR(mark->value, 55, 1e-12);
    EXPECT_NEAR(mark->false_positive, 0.066807, 1e-6);
    EXPECT_NEAR(mark->false_negative, 0.066807, 1e-6);
    // The same where a lower value is better.
    const auto lower = contrasting_groups({40, 10}, {70, 10});
    ASSERT_TRUE(lower.has_value());
    EXPECT_NEAR(lower->value, 55, 1e-12);
    EXPECT_NEAR(lower->false_positive, 0.066807, 1e-6);
    EXPECT_NEAR(lower->false_negative, 0.066807, 1e-6);
}

TEST(ContrastingGroups, UnequalSpreadsGiveTheRootBetweenTheMeans) {
    // Worked by hand: N(0, 1) and N(4, 2): 3 x^2 + 8 x - 16 - 8 ln 2 = 0.
    const auto mark = contrasting_groups({0, 1}, {4, 2});
    ASSERT_TRUE(mark.has_value());
    EXPECT_NEAR(mark->value, (-8 + std::sqrt(64 + 12 * (16 + 8 * std::log(2.0)))) / 6, 1e-12);
}

TEST(ContrastingGroups, GroupsThatOverlapGiveNone) {
    EXPECT_FALSE(contrasting_groups({50, 10}, {50, 10}).has_value());
    EXPECT_FALSE(contrasting_groups({50, 1}, {50.5, 30}).has_value());
    EXPECT_FALSE(contrasting_groups({50, 0}, {60, 10}).has_value());
    EXPECT_FALSE(contrasting_groups({50, std::numeric_limits<double>::quiet_NaN()}, {60, 10}).has_value());
    EXPECT_FALSE(contrasting_groups({std::numeric_limits<double>::infinity(), 1}, {60, 10}).has_value());
}

TEST(ContrastingGroups, TheMarkIsWhereTheDensitiesAreEqual) {
    EXPECT_TRUE(rc::check("densities", [] {
        const auto value = [](int low, int high) { return 0.01 * *rc::gen::inRange(low, high); };
        const GroupSpread a{value(-100000, 100000), value(1, 50000)},
            b{value(-100000, 100000), value(1, 50000)};
        const auto mark = contrasting_groups(a, b), other = contrasting_groups(b, a);
        RC_ASSERT(mark.has_value() == other.has_value());
        if (!mark) return;
        RC_ASSERT(mark->value > std::min(a.mean, b.mean) && mark->value < std::max(a.mean, b.mean));
        const double one = log_density(a, mark->value), two = log_density(b, mark->value);
        RC_ASSERT(std::abs(one - two) <= 1e-6 * (1 + std::abs(one)));
        RC_ASSERT(std::abs(mark->false_positive - other->false_negative) < 1e-12);
        RC_ASSERT(mark->false_positive >= 0 && mark->false_positive <= 1);
    }));
}

}  // namespace
}  // namespace fulcrum
