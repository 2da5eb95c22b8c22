// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/servo_backend.h"

#include <gtest/gtest.h>

namespace fulcrum::hapticd {
namespace {

constexpr std::int64_t servo_ms = 1'000'000;

/// Reads on a clock of the test, with a new reading every so many ms.
class ClockedServo : public ServoBackend {
  public:
    ClockedServo() { facts_.slot[1] = true; }
    /// ms in which the hand was absent.
    int absent_in(int milliseconds, int every) {
        int absent = 0;
        for (int ms = 0; ms < milliseconds; ++ms, now_ += servo_ms) {
            if (since_++ % every == 0) publish(1, {});
            DevicePose poses[device_slots];
            read(now_, poses);
            absent += poses[1].present == 1 ? 0 : 1;
        }
        return absent;
    }

  private:
    std::int64_t now_ = 1000 * servo_ms;
    int since_ = 0;
};

TEST(ServoBackend, OneThatFallsBehindAgainAndAgainIsAbsentUntilItKeepsUp) {
    ClockedServo servo;
    EXPECT_EQ(servo.absent_in(400, 15), 0) << "slow, but within the limit";
    const int at_first = servo.absent_in(60, 30);
    EXPECT_GT(at_first, 5);
    EXPECT_LT(at_first, 60) << "the first silence ends with its answer";
    EXPECT_EQ(servo.absent_in(300, 30), 300) << "present and absent in turn would pause no attempt";
    EXPECT_FALSE(servo.lost());
    EXPECT_GT(servo.absent_in(230, 1), 150);
    EXPECT_EQ(servo.absent_in(200, 1), 0) << "it keeps up";
    EXPECT_EQ(servo.fault().fault, 0U);
    servo.absent_in(1500, 30);
    EXPECT_TRUE(servo.lost()) << "a second of it: opened again";
}

TEST(ServoBackend, OneLongReadingAloneIsASilenceForItsLengthOnly) {
    ClockedServo servo;
    servo.absent_in(100, 1);
    EXPECT_LT(servo.absent_in(31, 31), 12);
    EXPECT_EQ(servo.absent_in(300, 1), 0);
}

}  // namespace
}  // namespace fulcrum::hapticd
