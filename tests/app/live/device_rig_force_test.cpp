// SPDX-License-Identifier: GPL-3.0-or-later
// Hands of a device that have force: what takes it from them, and what the device gets.
#include <gtest/gtest.h>

#include <cmath>

#include "assessment/attempt/engine.h"
#include "sim_core/devices/device_table.h"
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
