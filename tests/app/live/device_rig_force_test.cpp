// SPDX-License-Identifier: GPL-3.0-or-later
// Hands of a device that have force: what takes it from them, and what the device gets.
#include <gtest/gtest.h>

#include <cmath>

#include "assessment/attempt/engine.h"
#include "sim_core/devices/device_table.h"
#include "sim_core/haptics/hand_output.h"
#include "tests/app/live/rig_on_pages.h"

namespace fulcrum::app::program_test {
namespace {

// The device process switches both motors off: before, the attempt continued without force.
TEST(DeviceRig, AHandWithForceIsAbsentWhileTheDeviceHasAFaultOfAnyHand) {
    OnPages at;
    at.facts.force[1] = at.facts.force[0];
    at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                         at.others, SlotUse{-1, 1, scope_slot}, 1);
    const auto present = [&at] {
        at.publish();
        at.read();
        return at.sample.hand[1].present == 1;
    };
    EXPECT_TRUE(present()) << "before the first report";
    // Of the left hand, which mouse and keyboard move.
    at.state->fault.write({static_cast<std::uint64_t>(DeviceFault::switched_off), 1});
    EXPECT_FALSE(present());
    EXPECT_EQ(at.sample.hand[1].faulty, 0);
    at.state->fault.write({});
    EXPECT_TRUE(present());
}

TEST(DeviceRig, AHandWithoutForceStaysWhenAnotherHandHasAFault) {
    OnPages at;  // the right hand has no force
    at.state->fault.write({static_cast<std::uint64_t>(DeviceFault::switched_off), 1});
    at.publish();
    at.read();
    EXPECT_EQ(at.sample.hand[0].present, 0);
    EXPECT_EQ(at.sample.hand[1].present, 1);
}

// The limit was taken at the instrument only: at 200 % the hand got twice as much.
TEST(DeviceRig, WithAnotherScaleOfTheMovementTheForceChangesWithinTheSlewLimitAtTheDevice) {
    for (const double motion : {0.5, 1.0, 2.0}) {
        OnPages at;
        SlotUse use;
        use.motion = motion;
        at.facts.force[0]->damping = 1e6;
        at.facts.force[0]->continuous = 3.3;
        at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                             at.others, use, 1);
        const double step = at.scene.slew_limit * at.scene.tick_period();
        SafetyLimits limits;
        limits.slew = at.scene.slew_limit;
        limits.ramp_ticks = 0;
        HandOutput output(limits);
        output.set_device(at.rig->force_output(Hand::left));
        HandTick tick;
        tick.handle = tick.device = Vector3(0, 0, 0.1);
        const Vector3 force(0, 0, -10);  // of the instrument on what it touches, at the tip
        tick.load.add(Vector3(0, 0, -0.1), force, force, 500.0 * Matrix3::Identity(), Matrix3::Zero());
        const auto on_device = [&] {
            at.rig->write_force(Hand::left, output.step(tick).force);
            ForceCommand sent;
            EXPECT_TRUE(at.command->command[0].read(sent));
            return Vector3(sent.force[0], sent.force[1], sent.force[2]);
        };
        Vector3 before = Vector3::Zero();
        for (int i = 0; i < 60; ++i) {
            const Vector3 now = on_device();
            ASSERT_LE((now - before).norm(), step * (1 + 1e-9)) << motion << " " << i;
            before = now;
        }
        EXPECT_NEAR(before.norm(), 3.3, 0.05) << "the peak";
        tick.connected = false;
        for (int i = 0; i < 60; ++i) {
            const Vector3 now = on_device();
            ASSERT_LE((now - before).norm(), step * (1 + 1e-9)) << motion << " " << i;
            before = now;
        }
        EXPECT_EQ(before, Vector3(Vector3::Zero())) << motion;
    }
}

TEST(DeviceRig, ACommandHasForceAndTorqueOfOneTick) {
    OnPages at;
    at.facts.force[0]->torque = 0.05;
    at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                         at.others, SlotUse{}, 1);
    ForceCommand sent;
    TickOutput output;
    output.device_force[0] = Vector3(0, 1, 0);
    output.device_torque[0] = 0.02;
    write_forces(*at.rig, output);
    ASSERT_TRUE(at.command->command[0].read(sent));
    EXPECT_EQ(sent.torque, 0.02) << "before, it came with the next force";
    EXPECT_NEAR(std::hypot(std::hypot(sent.force[0], sent.force[1]), sent.force[2]), 1, 1e-12);
    write_forces(*at.rig, TickOutput{});
    ASSERT_TRUE(at.command->command[0].read(sent));
    EXPECT_EQ(sent.torque, 0) << "nothing is left at the end";
}

}  // namespace
}  // namespace fulcrum::app::program_test
