// SPDX-License-Identifier: GPL-3.0-or-later
// What the debrief says of the force that was felt.
#include <gtest/gtest.h>

#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

TEST(FeltText, NamesTheShareOfTheForceWhereADeviceRenderedOne) {
    ForceDevices devices;
    EXPECT_EQ(felt_text(devices), QString());
    ForceOutput output;
    output.scale = 0.4;
    devices[0] = output;
    EXPECT_EQ(felt_text(devices), "Force was felt at 40 %, by the left hand only.");
    devices[1] = output;
    EXPECT_EQ(felt_text(devices), "Force was felt at 40 %.");
    devices[1]->scale = 0.625;
    EXPECT_EQ(felt_text(devices), "Force was felt at 40 % by the left hand and at 63 % by the right.");
    devices[0].reset();
    EXPECT_EQ(felt_text(devices), "Force was felt at 63 %, by the right hand only.");
}

TEST(FeltText, NamesTheDeviceItsRateAndHowItWasSetUp) {
    RigUse use;
    EXPECT_EQ(rig_text("a pen", use), "Device: a pen.");
    use.stated = 1000;
    EXPECT_EQ(rig_text("a pen", use), "Device: a pen; 1000 readings per second stated.");
    use.measured = 987.6;
    use.motion = 1.5;
    use.part = {1, 0, -1};
    EXPECT_EQ(rig_text("a pen", use),
              "Device: a pen; 988 readings per second (1000 stated); movement of the instrument 150 %; left "
              "and right device swapped.");
}

}  // namespace
}  // namespace fulcrum::ui
