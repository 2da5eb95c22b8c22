// SPDX-License-Identifier: Apache-2.0
// A simulated hand presses wall, bowel, sheet and bands through the lever: it settles and gets back no
// energy.
#include "sim_core/lab/hand_lever.h"

#include <gtest/gtest.h>

#include "sim_core/lab/stability_rooms.h"

namespace fulcrum {
namespace {

constexpr double insertions[] = {0.05, 0.25, 0.5, 0.75, 0.95};
constexpr double tilts[] = {0, 0.8, 1.5707963267948966};  // across the shaft, oblique, against the tip

class HandsAtTheLever : public testing::TestWithParam<double> {};

void expect_sound(lab::HandAtLever& lever, lab::LeverTissue tissue, double insertion, double rate) {
    for (const double tilt : tilts) {
        for (const double mass : {0.05, 0.5}) {
            for (const bool arm : {false, true}) {
                lab::LeverCase at;
                at.tissue = tissue;
                at.insertion = insertion;
                at.tilt = tilt;
                lab::LeverHand hand;
                hand.mass = mass;
                hand.arm = arm;
                hand.period = 1 / rate;
                const lab::LeverRun run = lever.run(at, hand);
                EXPECT_TRUE(run.sound())
                    << name_of(tissue) << " at " << insertion << ", tilt " << tilt << ", " << mass
                    << " kg, arm " << arm << ", " << rate << " Hz: bounded " << run.bounded << ", settles "
                    << run.settles << " (swing of the first third " << 1e6 * run.early << " um, of the last "
                    << 1e6 * run.late << " um, in " << run.seconds << " s), got back " << run.returned
                    << " J of " << run.put_in;
                EXPECT_GT(run.put_in, 0) << "something is pressed";
                EXPECT_GT(run.force, 1e-3);
                EXPECT_LE(run.force, hand.device.peak * (1 + 1e-9));
            }
        }
    }
}

TEST_P(HandsAtTheLever, SettleAndGetNoEnergyAtEveryInsertion) {
    lab::HandAtLever lever;
    for (const lab::LeverTissue tissue : lab::lever_tissues) {
        for (const double insertion : insertions) expect_sound(lever, tissue, insertion, GetParam());
    }
}

INSTANTIATE_TEST_SUITE_P(Rates, HandsAtTheLever, testing::Values(1000.0, 1200.0), [](const auto& instance) {
    return "At" + std::to_string(static_cast<int>(instance.param)) + "Hz";
});

// The test of the test: as it was before, the force across the shaft has the wrong sign, and every hand runs
// away.
TEST(HandAtLever, WithTheForceOfTheTipTheHandRunsAway) {
    lab::HandAtLever lever;
    for (const lab::LeverTissue tissue : lab::lever_tissues) {
        for (const double insertion : insertions) {
            for (const double mass : {0.05, 0.5}) {
                lab::LeverCase at;
                at.tissue = tissue;
                at.insertion = insertion;
                lab::LeverHand hand;
                hand.mass = mass;
                hand.tip_force = true;
                const lab::LeverRun run = lever.run(at, hand);
                EXPECT_FALSE(run.sound()) << name_of(tissue) << " at " << insertion << ", " << mass << " kg";
                EXPECT_FALSE(run.bounded) << name_of(tissue) << " at " << insertion << ", " << mass << " kg";
                if (insertion < 0.2) continue;  // where an arm holds more than the tip gives
                hand.arm = true;
                EXPECT_FALSE(lever.run(at, hand).sound())
                    << name_of(tissue) << " at " << insertion << ", " << mass << " kg, with an arm";
            }
        }
    }
}

// The test of the test: just below the bound of stability a hand is bounded and gets back no energy, and its
// swing becomes smaller, but far too slowly.
TEST(HandAtLever, ASwingThatHardlyBecomesSmallerHasNotSettled) {
    lab::HandAtLever lever;
    lab::LeverCase at;
    at.damping = 0;
    at.stiffness = 990;  // of 1000 N/m, K T/2 = b, with the lever 1
    lab::LeverHand hand;
    hand.mass = 0.5;
    hand.device.damping = 1e7;  // Eq. 8 never acts
    const lab::LeverRun run = lever.run(at, hand);
    EXPECT_TRUE(run.finite && run.bounded && run.passive());
    EXPECT_LT(run.late, 0.9 * run.early);
    EXPECT_FALSE(run.settles) << 1e6 * run.early << " um, " << 1e6 * run.late << " um";
}

// Without Eq. 8 (a device that claims any damping) a stiff wall at a deep insertion is not stable.
TEST(HandAtLever, NeedsEquation8AtTheHand) {
    lab::HandAtLever lever;
    lab::LeverCase at;
    at.insertion = 0.75;
    lab::LeverHand hand;
    EXPECT_TRUE(lever.run(at, hand).sound());
    EXPECT_TRUE(lever.run(at, hand).limited);
    hand.device.damping = 1e6;
    EXPECT_FALSE(lever.run(at, hand).sound());
}

TEST(LeverMaps, AreStableAtEveryInsertionAsSentAndFollowTheTheoryAsTheModelIs) {
    const std::vector<lab::StabilityMap> maps = lab::lever_stability();
    ASSERT_EQ(maps.size(), 5U);
    for (std::size_t m = 1; m < maps.size(); ++m) {
        EXPECT_EQ(maps[m].axes[0].values.front(), 0.05);
        EXPECT_NEAR(maps[m].axes[0].values.back(), 0.95, 1e-9);
        for (const lab::StabilityCell& cell : maps[m].cells)
            EXPECT_EQ(cell.outcome, lab::StabilityOutcome::stable)
                << maps[m].title << ": " << cell.at[0] << ", " << cell.at[1] << " N/m";
    }
    int below = 0, above = 0;
    for (const lab::StabilityCell& cell : maps[0].cells) {
        if (cell.at[0] > 0.8) continue;  // B l^2 T / m is not small: the bound is no reference there
        const double lever = cell.at[0] / (1 - cell.at[0]);
        const double bound = stable_stiffness(0.4, 0.5 / (lever * lever), 1e-3, 0);
        below += cell.at[1] < 0.5 * bound ? 1 : 0;
        above += cell.at[1] > 2 * bound ? 1 : 0;
        const bool stable = cell.outcome == lab::StabilityOutcome::stable;
        EXPECT_TRUE(stable || cell.at[1] >= 0.5 * bound) << cell.at[0] << ", " << cell.at[1] << " N/m";
        EXPECT_TRUE(!stable || cell.at[1] <= 2 * bound) << cell.at[0] << ", " << cell.at[1] << " N/m";
    }
    EXPECT_GT(below, 20);
    EXPECT_GT(above, 5);
}

}  // namespace
}  // namespace fulcrum
