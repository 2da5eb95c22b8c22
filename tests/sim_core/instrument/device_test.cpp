// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "sim_core/instrument/device.h"

namespace fulcrum {
namespace {

TEST(Device, QuantisesToCounts) {
    DeviceReading reading;
    reading.handle = Vector3(0.01, -0.02, -0.15);
    reading.roll = 0.5;
    reading.grip = 1.2346;
    const DeviceSample sample = quantise(reading, DeviceSample{});
    EXPECT_EQ(sample.handle[0], 100000);
    EXPECT_EQ(sample.handle[2], -1500000);
    EXPECT_EQ(sample.roll, 500000);
    EXPECT_EQ(sample.grip, 1235);
    EXPECT_EQ(sample.faulty, 0);
}

TEST(Device, KeepsTheLastGoodPoseOnNanInfinityAndJump) {
    DeviceReading good;
    good.handle = Vector3(0, 0, -0.15);
    const DeviceSample before = quantise(good, DeviceSample{});
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1.0}) {
        DeviceReading reading = good;
        reading.handle.x() = bad;
        const DeviceSample sample = quantise(reading, before);
        EXPECT_EQ(sample.faulty, 1) << bad;
        EXPECT_EQ(sample.handle[0], before.handle[0]);
    }
}

}  // namespace
}  // namespace fulcrum
