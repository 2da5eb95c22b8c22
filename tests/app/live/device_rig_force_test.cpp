// SPDX-License-Identifier: GPL-3.0-or-later
// Hands of a device that have force: what takes it from them, and what the device gets.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace fulcrum::app::program_test
