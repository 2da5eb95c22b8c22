// SPDX-License-Identifier: Apache-2.0
// The simulated device at the product's own contact: its stability boundary, and passivity within Eq. 8.
#include "sim_core/lab/stability_map.h"

#include <gtest/gtest.h>

#include "sim_core/haptics/stability.h"

namespace fulcrum {
namespace {

class Grades : public testing::TestWithParam<FilterMode> {};

TEST_P(Grades, DeviceAloneBecomesUnstableAtTheTheoreticalLimit) {
    lab::DeviceAtContact contact(GetParam());
    // Computed from the sampled loop's characteristic polynomial (docs/THEORY.md, section 6).
    const double computed[] = {1001, 1796, 2976};
    int i = 0;
    for (const double damping : {0.0, 0.4, 1.0}) {
        const double found = contact.boundary(damping);
        EXPECT_NEAR(found, computed[i], 0.02 * computed[i]) << damping;
        EXPECT_NEAR(found, stable_stiffness(damping, 0.5, 1e-3, 0), 0.1 * found) << damping;
        ++i;
    }
}

TEST_P(Grades, PointsInsideEquation8ArePassiveAndStableWithAnyHand) {
    lab::DeviceAtContact contact(GetParam());
    for (const double damping : {0.0, 0.2, 0.4}) {
        const double bound = passive_stiffness(damping, 0.5, 1e-3);
        for (const double share : {0.3, 0.9}) {
            const lab::DeviceRun run = contact.run(share * bound, damping, true);
            EXPECT_NEAR(run.stiffness, share * bound, 1e-6 * bound);
            EXPECT_TRUE(run.stable) << damping << " " << share;
            EXPECT_TRUE(run.passive) << damping << " " << share << " returned " << run.returned;
        }
        // Beyond it some hand can extract energy.
        const lab::DeviceRun beyond = contact.run(1.1 * bound, damping, true);
        EXPECT_FALSE(beyond.passive) << damping;
    }
}

TEST(DeviceAtContact, DelayAndCoarseEncoderShiftTheBoundary) {
    lab::SimulatedDevice device;
    device.delay_ticks = 1;
    lab::DeviceAtContact late(FilterMode::adaptive, device);
    EXPECT_NEAR(late.boundary(0), stable_stiffness(0, 0.5, 1e-3, 1e-3),
                0.1 * stable_stiffness(0, 0.5, 1e-3, 1e-3));
    device.delay_ticks = 0;
    device.encoder_step = 5e-6;
    lab::DeviceAtContact coarse(FilterMode::adaptive, device);
    EXPECT_NEAR(coarse.boundary(0), 1001, 100);
}

INSTANTIATE_TEST_SUITE_P(Filter, Grades,
                         testing::Values(FilterMode::grade_0, FilterMode::grade_1, FilterMode::grade_2));

}  // namespace
}  // namespace fulcrum
