// SPDX-License-Identifier: Apache-2.0
// Bleeding compared with closed forms: Hagen-Poiseuille, volume as the integral of a clotting flow; the pool
// conserves volume and levels out; smoke follows its exponential; extremes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_core/bleeding/pool.h"
#include "sim_core/bleeding/vessel.h"
#include "tests/support/allocation_count.h"
#include "tests/support/extremes.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;

TEST(Vessel, FlowIsHagenAndPoiseuille) {
    VesselModel vessel;
    vessel.radius = 0.5e-3;
    vessel.feeding_length = 0.2;
    vessel.pressure = 12e3;
    const double whole = pi * std::pow(0.5e-3, 4) * 12e3 / (8 * 3.5e-3 * 0.2);
    EXPECT_NEAR(vessel_flow(vessel, 1), whole, 1e-12 * whole);
    EXPECT_NEAR(vessel_flow(vessel, 0.5), whole / 4, 1e-12 * whole);
    EXPECT_EQ(vessel_flow(vessel, 0), 0.0);
    EXPECT_EQ(vessel_flow(vessel, std::numeric_limits<double>::quiet_NaN()), 0.0);
    EXPECT_EQ(vessel_flow(vessel, 7), vessel_flow(vessel, 1));
}

TEST(Vessel, VolumeIsTheIntegralOfAClottingFlowForAnyStep) {
    VesselModel vessel;
    vessel.clotting_time = 40;
    for (const double dt : {0.05, 0.005, 0.0005}) {
        BleedState state;
        open_vessel(0.8, state);
        const int steps = static_cast<int>(std::lround(10 / dt));
        double sum = 0;
        for (int i = 0; i < steps; ++i) sum += step_bleed(vessel, dt, state);
        const double exact = vessel_flow(vessel, 0.8) * 20 * (1 - std::exp(-0.5));
        EXPECT_NEAR(state.lost, exact, 1e-10 * exact) << dt;
        EXPECT_NEAR(sum, state.lost, 1e-12 * exact) << dt;
    }
}

TEST(Vessel, SealAndClipStopTheFlowAndANewTearReopensIt) {
    const VesselModel vessel;
    BleedState state;
    EXPECT_EQ(bleed_flow(vessel, state), 0.0);
    open_vessel(1, state);
    state.sealed = 0.5;
    EXPECT_NEAR(bleed_flow(vessel, state), vessel_flow(vessel, 0.5), 1e-18);
    open_vessel(0.4, state);  // less than the present opening
    EXPECT_NEAR(open_share(state), 0.5, 1e-15);
    state.sealed = 0.99999;
    EXPECT_EQ(bleed_flow(vessel, state), 0.0);
    open_vessel(0.7, state);  // a new tear
    EXPECT_NEAR(open_share(state), 0.7, 1e-15);
    state.clipped = true;
    EXPECT_EQ(step_bleed(vessel, 1, state), 0.0);
}

PoolModel bed(int columns, int rows, double (*height)(int, int)) {
    PoolModel model;
    model.columns = columns;
    model.rows = rows;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) model.ground.push_back(height(column, row));
    return model;
}

TEST(Pool, ConservesVolumeAndLevelsOut) {
    PoolModel model =
        bed(12, 10, [](int c, int r) { return 2e-4 * ((c - 6) * (c - 6) + (r - 5) * (r - 5)); });
    model.spread_time = 0.08;
    PoolState state = make_pool_state(model);
    pour(model, 0, 0, 20e-6, state);
    for (int i = 0; i < 8000; ++i) {
        step_pool(model, 0.005, state);
        if (i % 500 == 0) {
            EXPECT_NEAR(pooled_volume(model, state), 20e-6, 1e-15) << i;
        }
    }
    EXPECT_EQ(state.depth[0], std::clamp(state.depth[0], 0.0, 1e-4));  // it ran off the corner
    double lowest = 1, highest = -1;
    for (std::size_t i = 0; i < state.depth.size(); ++i) {
        ASSERT_GE(state.depth[i], 0.0);
        if (state.depth[i] < 2e-4) continue;
        lowest = std::min(lowest, model.ground[i] + state.depth[i]);
        highest = std::max(highest, model.ground[i] + state.depth[i]);
    }
    EXPECT_LT(highest - lowest, 2e-5);
}

TEST(Pool, SuctionRemovesBloodWithinReachAndCountsIt) {
    const PoolModel model = bed(10, 10, [](int, int) { return 0.0; });
    PoolState state = make_pool_state(model);
    for (int c = 0; c < 10; ++c) pour(model, c, 5, 1e-6, state);
    EXPECT_NEAR(suck(model, 0.004, 0.044, 0.01, 0.5e-6, state), 0.5e-6, 1e-18);
    EXPECT_NEAR(suck(model, 0.004, 0.044, 0.01, 1, state), 1.5e-6, 1e-12);  // two cells are within reach
    EXPECT_EQ(suck(model, 0.004, 0.004, 0.01, 1e-6, state), 0.0);
    EXPECT_NEAR(state.poured - state.removed, pooled_volume(model, state), 1e-15);
}

TEST(Pool, NeitherAllocatesNorOverflows) {
    const PoolModel model = bed(16, 12, [](int c, int) { return 1e-3 * c; });
    PoolState state = make_pool_state(model);
    EXPECT_EQ(test::allocations_in([&] {
                  pour(model, 3, 3, 1e-5, state);
                  for (int i = 0; i < 50; ++i) step_pool(model, 0.005, state);
                  suck(model, 0.02, 0.02, 0.02, 1e-6, state);
              }),
              0u);
    Random random(3);
    for (int i = 0; i < test::cases_asked(); ++i) {
        const double bad = test::not_a_length(random);
        const double volume = random.below(4) == 0 ? bad : test::between(random, 1e-9, 1e-2);
        if (std::isfinite(volume) && volume < 1)
            pour(model, static_cast<int>(random.below(40)) - 10, 5, volume, state);
        if (!std::isfinite(volume)) pour(model, 2, 2, volume, state);
        step_pool(model, random.below(5) == 0 ? bad : test::between(random, 5e-5, 5e-2), state);
        suck(model, random.below(3) == 0 ? bad : 0.03, 0.04, 0.015, random.below(3) == 0 ? bad : 1e-5, state);
        for (const double depth : state.depth) ASSERT_TRUE(std::isfinite(depth) && depth >= 0) << i;
    }
}

TEST(Smoke, RisesAndClearsExponentially) {
    SmokeModel model;
    SmokeState state;
    const double made = 1e-4;  // kg/s of steam
    for (int i = 0; i < 2000; ++i) step_smoke(model, made * 0.005, false, 0.005, state);
    const double exact = model.aerosol_share * made * model.leak_time * (1 - std::exp(-10 / model.leak_time));
    EXPECT_NEAR(state.mass, exact, 1e-10 * exact);
    const double before = state.mass;
    for (int i = 0; i < 1000; ++i) step_smoke(model, 0, true, 0.005, state);
    const double rate = 1 / model.leak_time + model.suction_flow / model.volume;
    EXPECT_NEAR(state.mass, before * std::exp(-5 * rate), 1e-10 * before);
    EXPECT_NEAR(transmission(model, state),
                std::exp(-model.extinction * state.mass / model.volume * model.path), 1e-14);
    EXPECT_EQ(transmission(model, SmokeState{}), 1.0);
    step_smoke(model, std::numeric_limits<double>::quiet_NaN(), true, 0.05, state);
    step_smoke(model, 1, true, std::numeric_limits<double>::infinity(), state);
    EXPECT_TRUE(std::isfinite(state.mass));
}

}  // namespace
}  // namespace fulcrum
