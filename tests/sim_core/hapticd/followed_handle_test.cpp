// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/followed_handle.h"

#include <gtest/gtest.h>

namespace fulcrum::hapticd {
namespace {

constexpr std::int64_t tick = 1'000'000;  // ns

TEST(FollowedHandle, ReachesEachPoseInAStraightLineOverTheTimeBetweenTwo) {
    FollowedHandle handle;
    EXPECT_FALSE(handle.seen() || handle.fresh(tick));
    std::int64_t now = 1000 * tick;
    handle.take({Vector3(1, 0, 0), 0}, now);
    EXPECT_EQ(handle.at(now).position.x(), 1) << "the first is where it begins";
    handle.take({Vector3(1, 0, 0), 0}, now += 20 * tick);
    handle.at(now);
    handle.take({Vector3(2, 0, 0), 6}, now += 20 * tick);
    EXPECT_NEAR(handle.at(now + 10 * tick).position.x(), 1.5, 1e-12);
    EXPECT_NEAR(handle.at(now + 20 * tick).position.x(), 2, 1e-12);
    EXPECT_NEAR(handle.at(now + 90 * tick).position.x(), 2, 1e-12) << "no further";
    EXPECT_NEAR(handle.at(now + 90 * tick).roll, 6 - 2 * 3.14159265358979, 1e-12) << "the nearest turn";
    EXPECT_TRUE(handle.fresh(now + 100 * tick));
    EXPECT_FALSE(handle.fresh(now + 101 * tick));
}

TEST(FollowedHandle, TheTrackersOwnClockSaysHowLongThatIs) {
    FollowedHandle handle;
    std::int64_t now = 1000 * tick;
    handle.take({}, now);
    handle.at(now);
    // Two poses arrive late and close together, 40 ms apart by their own clock.
    handle.take({Vector3::Zero(), 0}, now += 70 * tick, 40 * tick);
    handle.at(now);
    handle.take({Vector3(1, 0, 0), 0}, now += 10 * tick, 40 * tick);
    EXPECT_NEAR(handle.at(now + 20 * tick).position.x(), 0.5, 1e-12);
}

}  // namespace
}  // namespace fulcrum::hapticd
