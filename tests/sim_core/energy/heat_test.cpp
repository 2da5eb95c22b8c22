// SPDX-License-Identifier: Apache-2.0
// Heat in tissue patches compared with closed forms: a single patch, a bar between two ends, dose and damage
// at constant temperature; energy balance through boiling; extremes.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/energy/energy_tool.h"
#include "sim_core/energy/heat.h"
#include "tests/support/allocation_count.h"
#include "tests/support/extremes.h"

namespace fulcrum {
namespace {

HeatModel bar(int count, double capacity, double conductance, double perfusion = 0, double water = 0) {
    HeatModel model;
    for (int i = 0; i < count; ++i) model.patches.push_back({capacity, perfusion, water});
    for (int i = 0; i + 1 < count; ++i) model.links.push_back({i, i + 1, conductance});
    return model;
}

struct HeatedBar {
    explicit HeatedBar(HeatModel given)
        : model(std::move(given)),
          state(make_heat_state(model)),
          inputs(make_heat_inputs(model)),
          scratch(make_heat_scratch(model)) {}
    HeatReport step(double dt) { return step_heat(model, inputs, dt, state, scratch); }
    HeatModel model;
    HeatState state;
    HeatInputs inputs;
    HeatScratch scratch;
};

TEST(Heat, SinglePatchFollowsTheExponentialToFirstOrder) {
    // C dT/dt = q - P T: T = q/P (1 - exp(-t P / C)).
    const double capacity = 0.1, perfusion = 0.02, power = 0.5, time = 3;
    double last = 0;
    for (const double dt : {0.02, 0.01, 0.005}) {
        HeatedBar run(bar(1, capacity, 0, perfusion));
        run.inputs.power[0] = power;
        for (int i = 0; i < static_cast<int>(std::lround(time / dt)); ++i) run.step(dt);
        const double exact = power / perfusion * (1 - std::exp(-time * perfusion / capacity));
        const double error = std::abs(run.state.rise[0] - exact) / exact;
        if (last > 0) {
            EXPECT_NEAR(last / error, 2.0, 0.05);
        }
        last = error;
    }
    EXPECT_LT(last, 5e-4);
}

TEST(Heat, SteadyBarMatchesTheDiscreteFin) {
    // Steady conduction with perfusion, power at one end: T_i ~ cosh(m (n - 1/2 - i)), 2 cosh m = 2 + P / G;
    // all heat leaves with blood.
    const int count = 40;
    const double conductance = 0.004, perfusion = 1e-4, power = 0.3;
    HeatedBar run(bar(count, 0.05, conductance, perfusion));
    run.inputs.power[0] = power;
    for (int i = 0; i < 60; ++i) run.step(1e4);
    const double m = std::acosh(1 + 0.5 * perfusion / conductance);
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += perfusion * run.state.rise[static_cast<std::size_t>(i)];
    EXPECT_NEAR(sum, power, 1e-9 * power);
    for (int i = 1; i < count; ++i) {
        const double exact = std::cosh(m * (count - 0.5 - i)) / std::cosh(m * (count - 0.5));
        EXPECT_NEAR(run.state.rise[static_cast<std::size_t>(i)] / run.state.rise[0], exact, 1e-9) << i;
    }
}

TEST(Heat, ModeOfAnInsulatedBarDecaysAtItsRate) {
    // cos(pi (i + 1/2) / n) is an eigenvector of the graph: rate 2 G (1 - cos(pi / n)) / C, by implicit Euler
    // 1 / (1 + rate dt) a step.
    const int count = 16;
    const double capacity = 0.08, conductance = 0.01, dt = 0.05;
    HeatedBar run(bar(count, capacity, conductance));
    const auto mode = [&](int i) { return std::cos(3.14159265358979323846 * (i + 0.5) / count); };
    for (int i = 0; i < count; ++i) run.state.rise[static_cast<std::size_t>(i)] = 10 + 5 * mode(i);
    const int steps = 200;
    for (int i = 0; i < steps; ++i) run.step(dt);
    const double rate = 2 * conductance * (1 - std::cos(3.14159265358979323846 / count)) / capacity;
    const double left = 5 * std::pow(1 + rate * dt, -steps);
    for (int i = 0; i < count; ++i)
        EXPECT_NEAR(run.state.rise[static_cast<std::size_t>(i)], 10 + left * mode(i), 1e-10) << i;
}

TEST(Heat, EnergyIsBalancedThroughBoilingPerfusionAndContact) {
    HeatedBar run(bar(12, 0.1, 0.003, 0.0008, 2e-5));
    run.inputs.power[3] = 20;
    run.inputs.contact[5] = 0.02;
    run.inputs.contact_rise[5] = 160;
    for (int i = 0; i < 2000; ++i) {
        if (i == 800) run.inputs.power[3] = 0;
        run.step(0.005);
        if (i % 100 != 0) continue;
        const double out = stored_heat(run.model, run.state) + run.state.perfused + run.state.boiled;
        EXPECT_NEAR(run.state.given, out, 1e-9 * run.state.given) << i;
    }
    EXPECT_GT(run.state.boiled, 1.0);
    EXPECT_EQ(run.state.water[3], 0.0);  // 45 J of latent heat, 80 J supplied
}

TEST(Heat, TissueStaysAtTheBoilingPointWhileItHasWater) {
    HeatedBar run(bar(1, 0.1, 0, 0, 2e-5));
    run.inputs.power[0] = 20;
    double steam = 0;
    while (run.state.water[0] > 0) {
        steam += run.step(0.005).steam;
        if (run.state.water[0] > 0) {
            ASSERT_LE(run.state.rise[0], 63.0 + 1e-9);
        }
    }
    EXPECT_NEAR(steam, 2e-5, 1e-15);
    for (int i = 0; i < 20; ++i) run.step(0.005);
    EXPECT_GT(run.state.rise[0], 63.0);  // dry: it chars
}

TEST(Heat, DividedLinkDoesNotConduct) {
    HeatedBar run(bar(2, 0.1, 0.01));
    run.state.parted[0] = 1;
    run.inputs.power[0] = 1;
    for (int i = 0; i < 100; ++i) run.step(0.01);
    EXPECT_EQ(run.state.rise[1], 0.0);
    EXPECT_NEAR(run.state.rise[0], 10.0, 1e-9);
}

TEST(Heat, DoseIsSaparetoAndDewey) {
    EXPECT_EQ(dose_rate(37), 0.0);
    EXPECT_EQ(dose_rate(38.999), 0.0);
    EXPECT_NEAR(dose_rate(41), 0.0625, 1e-14);
    EXPECT_NEAR(dose_rate(43), 1.0, 1e-15);
    EXPECT_NEAR(dose_rate(50), 128.0, 1e-10);
    // Held at 46 degrees for 90 s: 8 * 1.5 min.
    HeatedBar run(bar(1, 1e9, 0));
    run.state.rise[0] = 9;
    for (int i = 0; i < 900; ++i) run.step(0.1);
    EXPECT_NEAR(run.state.dose[0], 12.0, 1e-6);
}

TEST(Heat, DamageIsHenriquesAndMoritz) {
    const double at60 = 3.1e98 * std::exp(-6.28e5 / (8.314462618 * 333.15));
    EXPECT_NEAR(damage_rate(60) / at60, 1.0, 1e-9);
    EXPECT_LT(damage_rate(43), 1e-4);
    EXPECT_EQ(damage_rate(1e5), damage_rate(1e6));
    EXPECT_EQ(coagulated_share(0), 0.0);
    EXPECT_NEAR(coagulated_share(1), 0.6321205588285577, 1e-14);
}

TEST(Heat, AllocatesNothingInAStep) {
    HeatedBar run(bar(100, 0.1, 0.003, 0.001, 1e-5));
    run.inputs.power[50] = 25;
    run.step(0.005);
    EXPECT_EQ(test::allocations_in([&] {
                  for (int i = 0; i < 100; ++i) run.step(0.005);
              }),
              0u);
}

TEST(HeatExtremes, StaysFinite) {
    Random random(7);
    for (int trial = 0; trial < test::cases_asked() / 10; ++trial) {
        HeatModel model = bar(2 + static_cast<int>(random.below(20)), test::between(random, 1e-4, 1e3),
                              test::between(random, 1e-8, 1e6), test::between(random, 1e-9, 1e3),
                              test::between(random, 1e-9, 1));
        HeatedBar run(model);
        const double dt = test::between(random, 5e-5, 5e-2);
        for (int i = 0; i < 20; ++i) {
            run.inputs.power[0] = i % 5 == 4 ? test::not_a_length(random) : test::between(random, 1e-3, 1e5);
            run.inputs.contact[1] =
                i % 7 == 6 ? test::not_a_length(random) : test::between(random, 1e-6, 1e3);
            run.inputs.contact_rise[1] = i % 3 == 2 ? test::not_a_length(random) : 300;
            run.step(dt);
        }
        for (std::size_t k = 0; k < run.state.rise.size(); ++k) {
            ASSERT_TRUE(std::isfinite(run.state.rise[k])) << trial;
            ASSERT_GE(run.state.rise[k], -1e-6) << trial;
            ASSERT_TRUE(std::isfinite(run.state.dose[k]) && std::isfinite(run.state.damage[k]) &&
                        run.state.water[k] >= 0)
                << trial;
        }
    }
}

TEST(HeatExtremes, AnHourOfActivationStaysFinite) {
    HeatedBar run(bar(8, 0.14, 0.002, 1e-4, 2.6e-5));
    run.inputs.power[3] = 24;
    for (int i = 0; i < 72000; ++i) run.step(0.05);
    for (const double rise : run.state.rise) ASSERT_TRUE(std::isfinite(rise));
    EXPECT_EQ(run.state.dose[3], dose_limit);
    const double out = stored_heat(run.model, run.state) + run.state.perfused + run.state.boiled;
    EXPECT_NEAR(run.state.given, out, 1e-9 * run.state.given);
    run.step(std::numeric_limits<double>::quiet_NaN());
    run.step(-1);
    EXPECT_TRUE(std::isfinite(run.state.rise[3]));
}

TEST(EnergyTool, BladeHeatsToItsSteadyTemperatureAndCools) {
    const EnergyToolModel shears = harmonic_shears();
    BladeState blade;
    for (int i = 0; i < 20000; ++i) step_blade(shears, true, 0, 0.005, blade);
    EXPECT_NEAR(blade.rise, shears.blade_power / shears.blade_cooling, 1e-6);
    const double hot = blade.rise;
    step_blade(shears, false, 0, 0.005, blade);
    EXPECT_NEAR(blade.rise, hot / (1 + 0.005 * shears.blade_cooling / shears.blade_capacity), 1e-9);
    step_blade(shears, false, std::numeric_limits<double>::infinity(), 0.005, blade);
    EXPECT_TRUE(std::isfinite(blade.rise));
}

TEST(EnergyTool, DivisionNeedsHeatAndIsFasterUnderTension) {
    const EnergyToolModel shears = harmonic_shears();
    EXPECT_EQ(division_rate(shears, 50, 5), 0.0);
    EXPECT_NEAR(division_rate(shears, 100, 0), shears.division_rate, 1e-15);
    EXPECT_NEAR(division_rate(shears, 150, 1), shears.division_rate * (1 + shears.tension_gain), 1e-15);
    EXPECT_NEAR(division_rate(shears, 77.5, 0), 0.5 * shears.division_rate, 1e-15);
    EXPECT_TRUE(std::isfinite(division_rate(shears, 100, 1e300)));
    EXPECT_EQ(division_rate(shears, std::numeric_limits<double>::quiet_NaN(), 1), 0.0);
    EXPECT_EQ(share_under_blood(0), 1.0);
    EXPECT_NEAR(share_under_blood(0.002), 0.5, 1e-15);
}

}  // namespace
}  // namespace fulcrum
