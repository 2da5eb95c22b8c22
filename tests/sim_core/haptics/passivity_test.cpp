// SPDX-License-Identifier: Apache-2.0
// Energy returned to the hand: the passivity controller, and energy across swaps of model and topology.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim_core/haptics/safety.h"
#include "sim_core/haptics/stability.h"
#include "sim_core/numerics/random.h"
#include "tests/sim_core/contact/contact_rig.h"

namespace fulcrum {
namespace {

TEST(PassivityController, HandNeverReceivesMoreEnergyThanItPutIn) {
    int active = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Random random(seed);
        PassivityController controller;
        PassivityObserver observer, alone;
        for (int tick = 0; tick < 500; ++tick) {
            // An active wall: forces of any size and direction, whatever the hand does.
            const Vector3 force(random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-8, 8));
            const Vector3 velocity =
                random.uniform(0, 1) < 0.1
                    ? Vector3(Vector3::Zero())
                    : Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            const Vector3 sent = controller.step(force, velocity, 1e-3);
            EXPECT_LE(sent.norm(), force.norm() * (1 + 1e-12)) << "no force grows";
            observer.step(sent, velocity, 1e-3);
            alone.step(force, velocity, 1e-3);
            ASSERT_LE(observer.given, 1e-12) << "seed " << seed << " tick " << tick;
            ASSERT_GE(controller.stored, 0.0);
        }
        if (alone.highest > 1e-3) ++active;
    }
    EXPECT_GT(active, 150) << "without the controller energy is returned";
}

TEST(PassivityController, DoesNotChangeAPassiveSpring) {
    PassivityController controller;
    double x = 0;
    for (int tick = 0; tick < 2000; ++tick) {
        const double v = 0.05 * std::cos(0.01 * tick);
        x += v * 1e-3;
        const Vector3 force(-300 * std::max(0.0, x) - 0.4 * v, 0, 0);
        bool acted = true;
        const Vector3 sent = controller.step(force, Vector3(v, 0, 0), 1e-3, &acted);
        if (tick > 10) {
            EXPECT_EQ(sent, force) << tick;
            EXPECT_FALSE(acted);
        }
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(controller.step(Vector3(nan, 0, 0), Vector3(1, 0, 0), 1e-3), Vector3(Vector3::Zero()));
    EXPECT_EQ(controller.step(Vector3(1, 0, 0), Vector3(nan, 0, 0), 1e-3), Vector3(Vector3::Zero()));
}

double stored_energy(const ToolContactResult& result) {
    const double stiffness = result.normal.dot(result.stiffness * result.normal);
    const double depth = std::max(0.0, -result.distance);
    return result.touching_surface ? 0.5 * stiffness * depth * depth : 0.0;
}

TEST(SwapEnergy, TopologySwapNeverAddsEnergyAndModelSwapKeepsIt) {
    test::ContactRig rig;
    Random random(31);
    int touched = 0;
    for (int trial = 0; trial < 300; ++trial) {
        rig.state = ToolContactState{};
        rig.result = ToolContactResult{};
        const ToolKinematics tool = rig.tool_at(Vector3(
            0.2 + random.uniform(-0.06, 0.06), random.uniform(-0.008, 0.008), random.uniform(0.010, 0.0184)));
        rig.publish(tool);
        for (int i = 0; i < 200; ++i) rig.touch(tool);  // the footprint's stiffness is at its end
        if (!rig.result.touching_surface) continue;
        ++touched;
        const double before = stored_energy(rig.result);
        const Vector3 force = rig.result.force;
        // The same surface published again: the swap has no effect.
        rig.publish(tool);
        rig.touch(tool);
        EXPECT_NEAR(stored_energy(rig.result), before, 1e-9 * before);
        EXPECT_LT((rig.result.force - force).norm(), 1e-9);
        // A cut removes stiffness and renumbers triangles: remembered ones are invalid.
        rig.publish(tool);
        rig.local->topology_version += 1;
        const double left = random.uniform(0, 1);
        rig.local->patch.contact.stiffness_per_area *= left;
        rig.local->patch.contact.least_stiffness *= left;
        rig.local->patch.contact.most_stiffness *= left;
        double last = before;
        for (int i = 0; i < 50; ++i) {
            rig.touch(tool);
            EXPECT_LE(stored_energy(rig.result), last * (1 + 1e-9));
            last = stored_energy(rig.result);
        }
    }
    EXPECT_GT(touched, 100);
}

// A hand moving at random over models that change at random: with the controller on the sent force, after
// safety, the hand never receives net energy.
TEST(SwapEnergy, EnergyBalanceHoldsAcrossAnySequenceOfSwaps) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        Random random(seed, 5);
        SafetyLimits limits;
        SafetyState safety;
        PassivityController controller;
        PassivityObserver observer;
        double k = 400, rest = 0, old_k = k, old_rest = rest, x = 0.002;
        for (int tick = 0; tick < 1500; ++tick) {
            const double v = random.uniform(-0.3, 0.3);
            x += v * 1e-3;
            SafetyInput input;
            input.model_changed = tick % 5 == 0;
            if (input.model_changed) {
                old_k = k;
                old_rest = rest;
                k = random.uniform(50, 900);
                rest = random.uniform(-0.004, 0.004);
            }
            input.force = Vector3(-k * std::max(0.0, x - rest), 0, 0);
            input.old_force = Vector3(-old_k * std::max(0.0, x - old_rest), 0, 0);
            const SafetyOutput sent = step_safety(limits, input, safety);
            observer.step(controller.step(sent.force, Vector3(v, 0, 0), 1e-3), Vector3(v, 0, 0), 1e-3);
            ASSERT_LE(observer.given, 1e-12) << "seed " << seed << " tick " << tick;
        }
    }
}

}  // namespace
}  // namespace fulcrum
