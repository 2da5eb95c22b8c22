// SPDX-License-Identifier: Apache-2.0
// Eq. 8, and the wider bound of the device alone compared with a simulation.
#include "sim_core/haptics/stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr double period = 1e-3;

TEST(Passivity, PassiveValuesAreUnchanged) {
    const PassivityCheck check = check_passivity(400, 0.2, 0.5, period);
    EXPECT_TRUE(check.passive);
    EXPECT_FALSE(check.limited);
    EXPECT_EQ(check.stiffness, 400);
    EXPECT_EQ(check.damping, 0.2);
}

TEST(Passivity, DampingIsReducedFirst) {
    // K < 2 (b - |B|) / T: 800 fails with B = 0.2, holds with B below 0.1.
    const PassivityCheck check = check_passivity(800, 0.2, 0.5, period);
    EXPECT_FALSE(check.passive);
    EXPECT_TRUE(check.limited);
    EXPECT_EQ(check.stiffness, 800);
    EXPECT_LT(check.damping, 0.1);
    EXPECT_GT(check.damping, 0.099);
    EXPECT_LT(check.stiffness, passive_stiffness(check.damping, 0.5, period));
}

TEST(Passivity, StiffnessIsReducedSecond) {
    const PassivityCheck check = check_passivity(1500, 0.2, 0.5, period);
    EXPECT_TRUE(check.limited);
    EXPECT_EQ(check.damping, 0);
    EXPECT_LT(check.stiffness, 1000);
    EXPECT_GT(check.stiffness, 998);
}

TEST(Passivity, NeverBelowZeroAndAlwaysWithinTheBound) {
    Random random(6);
    for (int trial = 0; trial < 10000; ++trial) {
        const double b = random.uniform(0, 2), k = random.uniform(0, 5000), damping = random.uniform(0, 3);
        const PassivityCheck check = check_passivity(k, damping, b, period);
        EXPECT_GE(check.stiffness, 0);
        EXPECT_GE(check.damping, 0);
        EXPECT_LE(check.stiffness, k);
        EXPECT_LE(check.damping, damping);
        EXPECT_TRUE(check.stiffness < passive_stiffness(check.damping, b, period) || check.stiffness <= 0);
        EXPECT_EQ(check.passive, k < 2 * (b - damping) / period);
        EXPECT_EQ(check.limited, !check.passive && (k > check.stiffness || damping > check.damping));
    }
    const PassivityCheck nothing = check_passivity(300, 0.1, 0, period);
    EXPECT_EQ(nothing.stiffness, 0);
    EXPECT_EQ(nothing.damping, 0);
}

TEST(Passivity, DeviceWithoutForceIsNotChecked) {
    const PassivityCheck check = check_passivity(1e5, 10, -1, period);
    EXPECT_FALSE(check.applicable);
    EXPECT_FALSE(check.limited);
    EXPECT_EQ(check.stiffness, 1e5);
    EXPECT_EQ(check.damping, 10);
}

TEST(Passivity, NonFiniteValuesBecomeZero) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, std::numeric_limits<double>::infinity()}) {
        const PassivityCheck check = check_passivity(bad, 0.1, 0.5, period);
        EXPECT_TRUE(check.limited);
        EXPECT_EQ(check.stiffness, 0);
        EXPECT_EQ(check_passivity(100, bad, 0.5, period).damping, 0);
    }
}

// A device of mass m and damping b at a virtual wall of K and B, sampled and held at T, integrated finely in
// between.
bool simulated_stable(double stiffness, double damping, double device_damping) {
    const double mass = 0.1;
    double x = 0.001, v = 0, last = x;
    constexpr int parts = 20;
    double late_peak = 0, early_peak = 0;
    for (int tick = 0; tick < 6000; ++tick) {
        const double force = -stiffness * x - damping * (x - last) / period;
        last = x;
        for (int part = 0; part < parts; ++part) {
            const double h = period / parts;
            const double before = v;
            v += h * (force - device_damping * v) / mass;
            x += 0.5 * h * (before + v);
        }
        if (tick > 1000 && tick < 2000) early_peak = std::max(early_peak, std::abs(x));
        if (tick > 5000) late_peak = std::max(late_peak, std::abs(x));
    }
    return late_peak < early_peak;
}

TEST(Passivity, PassiveModelsAreStableOnASimulatedDevice) {
    for (const double damping : {0.0, 0.1, 0.3}) {
        const double bound = passive_stiffness(damping, 0.5, period);
        EXPECT_TRUE(simulated_stable(0.98 * bound, damping, 0.5)) << damping;
    }
    // Without damping of the model the two bounds coincide, and beyond them the device is unstable.
    EXPECT_FALSE(simulated_stable(1.05 * passive_stiffness(0, 0.5, period), 0, 0.5));
    EXPECT_NEAR(stable_stiffness(0, 0.5, period, 0), passive_stiffness(0, 0.5, period), 1e-9);
    EXPECT_GT(stable_stiffness(0.4, 0.5, period, 0), passive_stiffness(0.4, 0.5, period));
}

TEST(PassivityObserver, CountsEnergyGivenToTheHand) {
    PassivityObserver observer;
    // Into a spring and out again, held force: what comes out late is a little more than what went in.
    double x = 0;
    for (int tick = 0; tick < 200; ++tick) {
        const double v = tick < 100 ? 0.1 : -0.1;
        observer.step(Vector3(-500 * x, 0, 0), Vector3(v, 0, 0), period);
        x += v * period;
    }
    EXPECT_NEAR(observer.given, 500 * 0.01 * 0.1 * period, 1e-5);
    EXPECT_GE(observer.highest, observer.given);
}

}  // namespace
}  // namespace fulcrum
