// SPDX-License-Identifier: Apache-2.0
// Elementary functions against long double ones (64-bit mantissa): error in units in the last place.
#include "sim_core/numerics/functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>

namespace fulcrum {
namespace {

double error_in_ulp(double value, long double reference) {
    const double rounded = static_cast<double>(reference);
    const double unit = std::nextafter(std::fabs(rounded), INFINITY) - std::fabs(rounded);
    return static_cast<double>(std::fabs(static_cast<long double>(value) - reference) /
                               static_cast<long double>(unit));
}

double worst(const std::function<double(double)>& function,
             const std::function<long double(long double)>& reference, double low, double high,
             bool logarithmic = false) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(low, high);
    double largest = 0;
    for (int i = 0; i < 200000; ++i) {
        const double x = logarithmic ? std::pow(10.0, uniform(random)) : uniform(random);
        largest = std::max(largest, error_in_ulp(function(x), reference(static_cast<long double>(x))));
    }
    return largest;
}

TEST(Functions, SineAndCosineWithinTwoUlp) {
    const auto s = [](long double x) { return std::sin(x); };
    const auto c = [](long double x) { return std::cos(x); };
    EXPECT_LT(worst(math::sin, s, -4, 4), 1.0);
    EXPECT_LT(worst(math::cos, c, -4, 4), 1.0);
    EXPECT_LT(worst(math::sin, s, -1e6, 1e6), 1.0);
    EXPECT_LT(worst(math::cos, c, -1e6, 1e6), 1.0);
    EXPECT_LT(worst(math::sin, s, -12, 0, true), 1.0);
    EXPECT_LT(worst(
                  math::tan, [](long double x) { return std::tan(x); }, -1.5, 1.5),
              2.0);
}

TEST(Functions, SineIsAccurateNearMultiplesOfPi) {
    for (int k = 1; k < 300000; k += 37) {
        const double x = 3.141592653589793 * k;
        EXPECT_LT(error_in_ulp(math::sin(x), std::sin(static_cast<long double>(x))), 2.0) << k;
    }
}

TEST(Functions, ExponentialAndLogarithmWithinTwoUlp) {
    EXPECT_LT(worst(
                  math::exp, [](long double x) { return std::exp(x); }, -700, 700),
              1.0);
    EXPECT_LT(worst(
                  math::exp, [](long double x) { return std::exp(x); }, -1, 1),
              1.0);
    EXPECT_LT(worst(
                  math::log, [](long double x) { return std::log(x); }, -300, 300, true),
              1.0);
    EXPECT_LT(worst(
                  math::log, [](long double x) { return std::log(x); }, 0.5, 2.0),
              1.5);
}

TEST(Functions, ArcsWithinTwoUlp) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> angle(-3.14159265, 3.14159265), size(-5, 5);
    double largest = 0;
    for (int i = 0; i < 300000; ++i) {
        const double r = std::pow(10.0, size(random)), a = angle(random);
        const double y = r * std::sin(a), x = r * std::cos(a);
        largest = std::max(largest, error_in_ulp(math::atan2(y, x), std::atan2(static_cast<long double>(y),
                                                                               static_cast<long double>(x))));
    }
    EXPECT_LT(largest, 1.5);
    EXPECT_LT(worst(
                  math::asin, [](long double x) { return std::asin(x); }, -1, 1),
              2.0);
    EXPECT_LT(worst(
                  math::acos, [](long double x) { return std::acos(x); }, -1, 1),
              2.0);
}

TEST(Functions, SpecialValues) {
    const double infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(math::sin(infinity)) && std::isnan(math::cos(nan)) && std::isnan(math::exp(nan)));
    EXPECT_EQ(math::exp(710.0), infinity);
    EXPECT_EQ(math::exp(-746.0), 0.0);
    EXPECT_EQ(math::exp(0.0), 1.0);
    EXPECT_EQ(math::log(0.0), -infinity);
    EXPECT_TRUE(std::isnan(math::log(-1.0)));
    EXPECT_EQ(math::log(1.0), 0.0);
    const double pi = std::acos(-1.0);
    EXPECT_EQ(math::atan2(0.0, -1.0), pi);
    EXPECT_EQ(math::atan2(1.0, 0.0), pi / 2);
    EXPECT_EQ(math::atan2(-1.0, 0.0), -pi / 2);
    EXPECT_EQ(math::atan2(0.0, 1.0), 0.0);
    EXPECT_DOUBLE_EQ(math::atan2(infinity, infinity), pi / 4);
    EXPECT_DOUBLE_EQ(math::atan2(1e-310, 1e-310), pi / 4);
    EXPECT_EQ(math::atan2(1.0, infinity), 0.0);
    EXPECT_EQ(math::acos(2.0), 0.0);
    EXPECT_EQ(math::asin(-2.0), -pi / 2);
    EXPECT_DOUBLE_EQ(math::hypot3(1e200, 1e200, 0), std::sqrt(2.0) * 1e200);
    EXPECT_DOUBLE_EQ(math::hypot3(1, 2, 2), 3.0);
    EXPECT_EQ(math::hypot3(0, 0, 0), 0.0);
}

}  // namespace
}  // namespace fulcrum
