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

}  // namespace
}  // namespace fulcrum::ui
