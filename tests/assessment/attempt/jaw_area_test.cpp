// SPDX-License-Identifier: Apache-2.0
// The jaws' contact area over a whole attempt: one value for each hold, so that no pressure comes from an
// area that was lost.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim_core/scene/perforation.h"
#include "tests/assessment/attempt/expert_record.h"

namespace fulcrum {
namespace {

TEST(JawArea, IsOneValueInEachHoldOfAnAttempt) {
    const std::vector<TickSample>& samples = test::expert_record("C4").record.samples;
    int holds = 0;
    double largest_pressure = 0, largest_force = 0;  // Pa, N
    for (int h = 0; h < hand_count; ++h) {
        std::int32_t area = -1;  // of this hold
        for (const TickSample& sample : samples) {
            const HandSample& hand = sample.hand[h];
            if ((hand.flags & hand_grasping) == 0) {
                area = -1;
                continue;
            }
            if (area < 0) {
                area = hand.jaw_area;
                ++holds;
            }
            ASSERT_EQ(hand.jaw_area, area) << "hand " << h << ", tick " << sample.tick;
            ASSERT_GT(area, 0) << "hand " << h << ", tick " << sample.tick;
            const double force = sample_force_unit * hand.jaw_force;
            largest_force = std::max(largest_force, force);
            largest_pressure = std::max(largest_pressure, force / (sample_area_unit * area));
        }
    }
    EXPECT_GE(holds, 2);
    EXPECT_LE(largest_pressure, 1.001 * largest_force / pinched_area);
    // As measured with instrumented graspers on colon; an area that was lost gave 8,756 kPa.
    EXPECT_LT(largest_pressure, 600e3);
}

}  // namespace
}  // namespace fulcrum
