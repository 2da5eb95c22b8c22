// SPDX-License-Identifier: Apache-2.0
// The bare functions against their closed forms.
#include "assessment/metrics/signal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/assessment/metrics/traces.h"

namespace fulcrum {
namespace {

using test::pi;

std::vector<double> gaussian_speed() {
    std::vector<double> speed;
    for (int i = -100; i <= 99; ++i) speed.push_back(std::exp(-5.0 * (i * 0.01) * (i * 0.01)));
    return speed;
}

std::vector<double> minimum_jerk_speed(double amplitude, int samples = 101) {
    std::vector<double> speed;
    for (int i = 0; i < samples; ++i) {
        const double s = static_cast<double>(i) / (samples - 1);
        speed.push_back(amplitude * 30.0 * s * s * (1 - s) * (1 - s));
    }
    return speed;
}

TEST(Sparc, MeetsThePublishedReference) {
    EXPECT_NEAR(sparc(gaussian_speed(), 100.0), -1.41403, 5e-6);
}

TEST(Sparc, OfAMinimumJerkReachWhateverItsAmplitude) {
    EXPECT_NEAR(sparc(minimum_jerk_speed(1.0), 100.0), -1.40583, 5e-6);
    EXPECT_NEAR(sparc(minimum_jerk_speed(1e-3), 100.0), sparc(minimum_jerk_speed(1.0), 100.0), 1e-12);
}

TEST(Sparc, HasNoValueWithoutMotion) {
    EXPECT_TRUE(std::isnan(sparc(std::vector<double>(100, 0.0), 100.0)));
    EXPECT_TRUE(std::isnan(sparc({1.0}, 100.0)));
}

TEST(LogJerk, MeetsThePublishedReference) {
    EXPECT_NEAR(-dimensionless_jerk(gaussian_speed(), 100.0), -335.74684, 5e-6);
    EXPECT_NEAR(ldlj(gaussian_speed(), 100.0), -5.81636, 5e-6);
}

TEST(LogJerk, OfAMinimumJerkReachWhateverItsAmplitude) {
    EXPECT_NEAR(ldlj(minimum_jerk_speed(1.0), 100.0), -5.30163, 5e-6);
    EXPECT_NEAR(ldlj(minimum_jerk_speed(1e-3), 100.0), ldlj(minimum_jerk_speed(1.0), 100.0), 1e-12);
}

TEST(LogJerk, OfNoisySpeedIsRestoredByTheFilter) {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 0.001 * 1.875);  // 0.1 % of the peak
    std::vector<double> speed = minimum_jerk_speed(1.0, 1001);
    for (double& v : speed) v += noise(random);
    EXPECT_NEAR(ldlj(speed, 1000.0), -15.6, 0.2);
    const std::vector<double> smooth = low_pass(speed, 10.0, 1000.0);
    std::vector<double> slow;
    for (std::size_t i = 0; i < smooth.size(); i += 10) slow.push_back(smooth[i]);
    EXPECT_NEAR(ldlj(slow, 100.0), -5.23, 0.03);
}

TEST(Despike, ReplacesSpikesAndKeepsStepsSlopesAndWaves) {
    std::vector<double> wave(1000);
    for (std::size_t i = 0; i < wave.size(); ++i)
        wave[i] = (i >= 500 ? 5.0 : 0.0) +
                  2.0 * std::sin(2 * 3.14159265358979 * 20.0 * static_cast<double>(i) / 1000.0);
    std::vector<double> same = wave;
    EXPECT_EQ(despike(same, 0, same.size(), 1e-3), 0U);
    EXPECT_EQ(same, wave);
    std::vector<double> spiked = wave;
    for (const std::size_t i : {0, 200, 201, 700, 999}) spiked[i] += 20.0;
    EXPECT_EQ(despike(spiked, 0, spiked.size(), 1e-3), 5U);
    for (std::size_t i = 0; i < wave.size(); ++i) EXPECT_NEAR(spiked[i], wave[i], 0.8) << i;
    // Outside the range nothing is touched.
    std::vector<double> outside = wave;
    outside[100] += 20.0;
    EXPECT_EQ(despike(outside, 200, 900, 1e-3), 0U);
    EXPECT_EQ(outside[100], wave[100] + 20.0);
}

TEST(LowPass, HalvesTheAmplitudeAtItsCutoffWithoutDelay) {
    std::vector<double> wave;
    for (int i = 0; i < 4000; ++i) wave.push_back(std::sin(2 * pi * 10.0 * i * 1e-3));
    const std::vector<double> out = low_pass(wave, 10.0, 1000.0);
    ASSERT_EQ(out.size(), wave.size());
    for (std::size_t i = 1500; i < 2500; ++i) ASSERT_NEAR(out[i], 0.5 * wave[i], 1e-6);
}

TEST(LowPass, LeavesAConstantAlone) {
    for (const double x : low_pass(std::vector<double>(50, 3.25), 10.0, 1000.0)) EXPECT_NEAR(x, 3.25, 1e-12);
    EXPECT_EQ(low_pass_held(std::vector<double>(50, 3.25), 10.0, 100.0).size(),
              50U + 2 * hold_samples(100.0));
}

TEST(Peaks, CountMaximaThatAreProminentAndApart) {
    //                              0  1  2  3    4  5  6  7  8    9
    const std::vector<double> x = {0, 5, 0, 3, 2.5, 3, 0, 8, 7.8, 0};
    EXPECT_EQ(find_peaks(x, 1.0, 1),
              (std::vector<std::size_t>{1, 3, 7}));  // the twin at 5 is not another peak
    EXPECT_EQ(find_peaks(x, 4.0, 1), (std::vector<std::size_t>{1, 7}));
    EXPECT_EQ(find_peaks(x, 1.0, 5), (std::vector<std::size_t>{1, 7}));  // 3 lies too near to the higher 7
    EXPECT_EQ(find_peaks({0, 1, 2, 2, 2, 1, 0}, 1.0, 1), (std::vector<std::size_t>{3}));
    EXPECT_TRUE(find_peaks({3, 2, 1, 2, 3}, 0.1, 1).empty());  // ends are no maxima
}

TEST(Paths, OfAHelix) {
    Eigen::Matrix3Xd helix(3, 30001);
    for (Eigen::Index i = 0; i < helix.cols(); ++i) {
        const double angle = 6.0 * pi * static_cast<double>(i) / static_cast<double>(helix.cols() - 1);
        helix.col(i) << 20 * std::cos(angle), 20 * std::sin(angle), 10 * angle / (2 * pi);
    }
    EXPECT_NEAR(path_length(helix), 378.1829, 1e-4);
    EXPECT_NEAR(path_length(helix), 3 * std::hypot(2 * pi * 20, 10.0), 1e-5);
}

TEST(Paths, OfAShaftThatTurns) {
    Eigen::Matrix3Xd axes(3, 101);
    for (Eigen::Index i = 0; i <= 100; ++i)
        axes.col(i) << std::cos(static_cast<double>(i) * 0.01), std::sin(static_cast<double>(i) * 0.01), 0;
    EXPECT_NEAR(angular_path(axes), 1.0, 1e-12);
}

TEST(Ellipsoid, OfKnownDeviations) {
    // The eight corners of a box have exactly these population deviations and no correlation.
    Eigen::Matrix3Xd points(3, 8);
    for (Eigen::Index i = 0; i < 8; ++i)
        points.col(i) << 5 + (i & 1 ? 20 : -20), (i & 2 ? 15 : -15), (i & 4 ? 10 : -10);
    EXPECT_NEAR(ellipsoid_volume(points, 7.8147) / 1000.0, 274.52, 0.005);
    EXPECT_EQ(ellipsoid_volume(Eigen::Matrix3Xd(3, 0), 1.0), 0.0);
    EXPECT_EQ(ellipsoid_volume(Eigen::Matrix3Xd::Ones(3, 5), 1.0), 0.0);
}

TEST(Ellipsoid, OfThreeIncommensurateForces) {
    const Eigen::Index n = 2000000;
    Eigen::Matrix3Xd force(3, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double t = static_cast<double>(i) * 1e-3;
        force.col(i) << 2 * std::sin(t), std::sin(std::sqrt(2.0) * t), 0.5 * std::sin(std::sqrt(3.0) * t);
    }
    EXPECT_NEAR(ellipsoid_volume(force, 1.0), 1.48096, 0.002);
}

TEST(Pearson, OfShiftedSinesIsTheCosineOfTheShift) {
    std::vector<double> left, right;
    for (int i = 0; i < 6000; ++i) {
        left.push_back(1 + std::sin(2 * pi * i / 1000.0));
        right.push_back(1 + std::sin(2 * pi * i / 1000.0 + pi / 3));
    }
    EXPECT_NEAR(pearson(left, right), 0.5, 1e-9);
    EXPECT_TRUE(std::isnan(pearson({1, 1, 1}, {1, 2, 3})));
}

TEST(Integral, OfAHalfSine) {
    std::vector<double> force;
    for (int i = 0; i <= 2000; ++i) force.push_back(3.0 * std::sin(pi * i / 2000.0));
    const double impulse = integral(force, 1e-3);
    EXPECT_NEAR(impulse, 3.81972, 5e-6);
    EXPECT_NEAR(impulse / 2.0, 1.90986, 5e-6);
}

TEST(WindowPower, PutsASineIntoItsBin) {
    std::vector<double> wave;
    for (int i = 0; i < 2500; ++i) wave.push_back(4 + std::sin(2 * pi * 9.0 * i * 1e-3));
    const std::vector<double> power = window_power(wave, 100, 1000.0);
    double all = 0;
    for (const double p : power) all += p;
    EXPECT_GT(power[18] / all, 0.6);  // 9 Hz at 0.5 Hz a bin
    EXPECT_NEAR((power[17] + power[18] + power[19]) / all, 1.0,
                1e-9);  // Hann spreads to the neighbours alone
}

}  // namespace
}  // namespace fulcrum
