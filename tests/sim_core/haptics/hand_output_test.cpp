// SPDX-License-Identifier: Apache-2.0
// What the device of a hand gets of the loads on its instrument.
#include "sim_core/haptics/hand_output.h"

#include <gtest/gtest.h>

#include <limits>

#include "sim_core/contact/contact_response.h"
#include "sim_core/numerics/random.h"
#include "tests/support/force_device.h"

namespace fulcrum {
namespace {

const Vector3 outside(0, 0, 0.1);  // m, handle from the trocar

HandOutput output_to(const ForceOutput& device, bool passivity_control = false) {
    SafetyLimits limits;
    limits.ramp_ticks = 0;
    HandOutput output(limits, passivity_control);
    output.set_device(device);
    return output;
}

/// The force after the slew of the start.
HandForce settled(HandOutput& output, const HandTick& tick) {
    HandForce sent;
    for (int i = 0; i < 50; ++i) sent = output.step(tick);
    return sent;
}

/// A contact at the tip, `insertion` m beyond the trocar; velocity of the tool against the tissue.
HandTick contact_at(double insertion, const Vector3& normal, double stiffness, double damping, double depth,
                    const Vector3& velocity) {
    ContactResponse response;
    response.stiffness = stiffness;
    response.damping = damping;
    response.friction = 0;
    HandTick tick;
    tick.handle = tick.device = outside;
    tick.load.add(Vector3(0, 0, -insertion), response.force_on_tissue(depth, normal, velocity),
                  response.spring_force(depth, normal), stiffness * normal * normal.transpose(),
                  damping * Matrix3::Identity());
    return tick;
}

TEST(HandOutput, SendsWhatVirtualWorkGives) {
    Random random(3);
    const auto any = [&](double size) {
        return Vector3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
    };
    for (int trial = 0; trial < 200; ++trial) {
        HandOutput output = output_to(test::ideal_device());
        HandTick tick;
        tick.handle = any(0.1) + Vector3(0, 0, 0.15);
        ToolLoad on_tool;
        for (int k = 0; k < 3; ++k) {
            const Vector3 arm = any(0.2), force = any(0.5);
            tick.load.add(arm, force, 0.5 * force, Matrix3::Identity(), Matrix3::Identity());
            on_tool.add(arm, -force);
        }
        const HandLoad expected = load_at_hand(tick.handle, on_tool);
        if (expected.force.norm() > 9) continue;
        const HandForce sent = settled(output, tick);
        EXPECT_NEAR((sent.force - expected.force).norm(), 0, 1e-12);
        EXPECT_FALSE(sent.limited);
    }
}

TEST(HandOutput, SendsNothingWithoutADevice) {
    HandOutput output;
    const HandTick tick = contact_at(0.2, Vector3::UnitX(), 800, 0.4, 0.002, Vector3::Zero());
    EXPECT_EQ(output.step(tick).force, Vector3(Vector3::Zero()));
    ForceOutput unusable;
    unusable.damping = std::numeric_limits<double>::quiet_NaN();
    output.set_device(unusable);
    EXPECT_FALSE(output.has_device());
    EXPECT_EQ(output.step(tick).force, Vector3(Vector3::Zero()));
}

// Before, Eq. 8 raised its event and the force stayed what it was.
TEST(HandOutput, RendersTheReducedDamping) {
    ForceOutput device;
    device.damping = 0.5;
    const auto sent_at = [&](double speed) {
        HandOutput output = output_to(device);
        return settled(output, contact_at(0.1, Vector3::UnitX(), 400, 0.4, 0.002, Vector3(-speed, 0, 0)));
    };
    // Lever 1: K 400 at the hand, so b = 0.4 leaves 0.4 - 400 T / 2 = 0.2 for B.
    const HandForce still = sent_at(0), fast = sent_at(0.1);
    EXPECT_TRUE(still.limited);
    EXPECT_NEAR(still.force.x(), -0.8, 1e-12) << "K is not reduced";
    EXPECT_NEAR((fast.force - still.force).x(), -0.2 * 0.1, 3e-5);
    device.damping = 2;
    EXPECT_NEAR((sent_at(0.1).force - sent_at(0).force).x(), -0.4 * 0.1, 1e-12) << "enough b: all of B";
}

TEST(HandOutput, LargestEigenvalueAtTheHandCounts) {
    ForceOutput device;
    device.damping = 0.5;
    const double bound = 2 * 0.8 * device.damping / 1e-3;
    // Lever 2 across the shaft: four times the stiffness of the tissue, in any direction across.
    for (const Vector3& normal : {Vector3(Vector3::UnitX()), Vector3(Vector3(1, 1, 0).normalized())}) {
        HandOutput output = output_to(device);
        const HandForce sent = settled(output, contact_at(0.2, normal, 300, 0, 0.001, Vector3::Zero()));
        EXPECT_TRUE(sent.limited);
        EXPECT_NEAR(sent.stiffness, bound, 2e-3 * bound);
        // The hand moves by half of the depth: K of the bound, along the same direction.
        EXPECT_NEAR((sent.force + bound * 0.0005 * normal).norm(), 0, 2e-3 * bound * 0.0005);
    }
    // Against the tip there is no lever.
    HandOutput output = output_to(device);
    EXPECT_FALSE(output.step(contact_at(0.2, Vector3::UnitZ(), 300, 0, 0.001, Vector3::Zero())).limited);
    // The greatest stiffness that the maker states is a limit too.
    device.stiffness = 100;
    HandOutput soft = output_to(device);
    const HandForce sent = settled(soft, contact_at(0.2, Vector3::UnitZ(), 300, 0, 0.001, Vector3::Zero()));
    EXPECT_NEAR(sent.force.z(), 0.1, 1e-12);
    EXPECT_TRUE(sent.limited);
}

TEST(HandOutput, ScalesAndStaysWithinTheDevice) {
    ForceOutput device = test::ideal_device();
    device.scale = 0.4;
    HandOutput scaled = output_to(device);
    const HandTick push = contact_at(0.1, Vector3::UnitZ(), 500, 0, 0.002, Vector3::Zero());
    EXPECT_NEAR(settled(scaled, push).force.z(), 0.4, 1e-12);
    device = test::desk_device();
    device.damping = 1e6;
    HandOutput output = output_to(device);
    const HandTick strong = contact_at(0.1, Vector3::UnitZ(), 500, 0, 0.02, Vector3::Zero());
    HandForce sent = settled(output, strong);
    EXPECT_NEAR(sent.force.z(), 3.3, 1e-3) << "the peak";
    EXPECT_NE(sent.flags & safety_clamped, 0);
    double last = sent.force.z();
    for (int tick = 0; tick < 60000; ++tick) {
        sent = output.step(strong);
        ASSERT_LE(std::abs(sent.force.z() - last), 0.3) << tick;
        last = sent.force.z();
    }
    EXPECT_NEAR(last, 0.88, 0.005) << "what the motors hold";
    // A minute without load and the peak is there again.
    for (int tick = 0; tick < 60000; ++tick)
        output.step(HandTick{outside, outside, {}, {}, false, 0, true, 0});
    double most = 0;
    for (int tick = 0; tick < 20; ++tick) most = std::max(most, output.step(strong).force.z());
    EXPECT_NEAR(most, 3.3, 1e-2);
}

TEST(HandOutput, PairsTheForceWithTheMotionOfTheHand) {
    HandOutput output = output_to(test::ideal_device(), true);
    // An active tissue pushes the tip to -x, so the hand to +x, where it moves: none of the energy is its
    // own.
    HandTick tick = contact_at(0.2, Vector3::UnitX(), 0, 0, 0, Vector3::Zero());
    tick.load = SplitLoad{};
    tick.load.add(Vector3(0, 0, -0.2), Vector3(1, 0, 0), Vector3(1, 0, 0), Matrix3::Identity(),
                  Matrix3::Zero());
    double given = 0;
    for (int i = 0; i < 50; ++i) {
        tick.device.x() += 1e-4;
        const HandForce sent = output.step(tick);
        EXPECT_GE(sent.force.x(), -1e-12);
        if (i > 0) given += sent.force.x() * 1e-4;
    }
    EXPECT_LE(given, 1e-9);
    // Against the push the hand feels all of it.
    for (int i = 0; i < 50; ++i) {
        tick.device.x() -= 1e-4;
        output.step(tick);
    }
    EXPECT_NEAR(output.step(tick).force.x(), 2, 1e-9);
}

TEST(HandOutput, IsFiniteAndSmallForAnyInput) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), huge = 1e300;
    for (const double bad : {nan, huge, -huge, 0.0}) {
        HandOutput output = output_to(test::desk_device());
        for (int i = 0; i < 20; ++i) {
            HandTick tick = contact_at(0.2, Vector3::UnitX(), 800, 0.4, 0.002, Vector3::Zero());
            if (i % 4 == 1) tick.handle = Vector3(0, 0, bad);
            if (i % 4 == 2)
                tick.load.add(Vector3(bad, 0, 0), Vector3(0, bad, 0), Vector3(0, 0, bad),
                              bad * Matrix3::Identity(), bad * Matrix3::Identity());
            if (i % 4 == 3) tick.device.x() = bad;
            tick.model_changed = i % 3 == 0;
            const HandForce sent = output.step(tick);
            ASSERT_TRUE(sent.force.allFinite()) << bad << " " << i;
            ASSERT_LE(sent.force.norm(), 3.3 * (1 + 1e-12));
            ASSERT_TRUE(std::isfinite(sent.torque));
        }
    }
}

// With the limits of the product: at the start, after a loss or a pause, and as new.
TEST(HandOutput, RisesOverTheRampWheneverItBegins) {
    ForceOutput device = test::ideal_device();
    device.torque = 0.05;
    HandTick tick = contact_at(0.2, Vector3::UnitZ(), 500, 0, 0.002, Vector3::Zero());
    tick.load.add(Vector3(0.05, 0, -0.2), Vector3(0, 0.4, 0), Vector3(0, 0.4, 0), Matrix3::Zero(),
                  Matrix3::Zero());
    HandOutput whole = output_to(device);
    const HandForce model = settled(whole, tick);
    ASSERT_GT(model.force.norm(), 1 - 1e-9);
    ASSERT_GT(model.torque, 0.01);
    const std::uint32_t ramp = SafetyLimits().ramp_ticks;
    ASSERT_GT(ramp, 100U);
    HandOutput output;
    output.set_device(device);
    const auto expect_ramp = [&](const char* when) {
        HandForce last;
        for (std::uint32_t n = 1; n <= ramp; ++n) {
            const HandForce sent = output.step(tick);
            const double share = n / static_cast<double>(ramp);
            ASSERT_LE(sent.force.norm(), share * model.force.norm() + 1e-9) << when << ", tick " << n;
            ASSERT_LE(sent.torque, share * model.torque + 1e-9) << when << ", tick " << n;
            ASSERT_GE(sent.force.norm(), last.force.norm() - 1e-12) << when << ", tick " << n;
            last = sent;
        }
        EXPECT_NEAR((output.step(tick).force - model.force).norm(), 0, 1e-9) << when;
    };
    expect_ramp("at the start");
    tick.connected = false;
    for (int i = 0; i < 50; ++i) output.step(tick);
    ASSERT_EQ(output.step(tick).force, Vector3(Vector3::Zero()));
    tick.connected = true;
    expect_ramp("connected again");
    output.restart();
    expect_ramp("as new");
}

TEST(HandOutput, FallsAtTheSlewLimitWhenTheDeviceIsLostUnderLoad) {
    ForceOutput device = test::ideal_device();
    device.torque = 0.05;
    HandOutput output = output_to(device);
    HandTick tick = contact_at(0.2, Vector3::UnitZ(), 500, 0, 0.01, Vector3::Zero());
    tick.load.add(Vector3(0.05, 0, -0.2), Vector3(0, 0.4, 0), Vector3(0, 0.4, 0), Matrix3::Zero(),
                  Matrix3::Zero());
    HandForce sent;
    for (int i = 0; i < 40; ++i) sent = output.step(tick);
    EXPECT_NEAR(sent.force.z(), 5, 1e-9);
    EXPECT_NEAR(sent.torque, 0.02, 1e-9);
    tick.connected = false;
    for (int i = 0; i < 25; ++i) {
        const HandForce next = output.step(tick);
        ASSERT_LE((next.force - sent.force).norm(), 0.3 * (1 + 1e-9));
        ASSERT_LE(next.force.norm(), sent.force.norm() + 1e-12);
        ASSERT_LE(std::abs(next.torque), std::abs(sent.torque) + 1e-12);
        sent = next;
    }
    EXPECT_EQ(sent.force, Vector3(Vector3::Zero()));
    EXPECT_EQ(sent.torque, 0);
}

}  // namespace
}  // namespace fulcrum
