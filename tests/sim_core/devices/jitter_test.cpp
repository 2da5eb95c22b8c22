// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/jitter.h"

#include <gtest/gtest.h>

namespace fulcrum {
namespace {

TEST(Jitter, IsTheDeviationFromThePeriodAndForgetsWhatIsLongAgo) {
    Jitter jitter(1'000'000);
    EXPECT_EQ(jitter.seconds(), 0);
    std::int64_t now = 5'000'000'000;
    const auto run = [&](int ticks, std::int64_t early, std::int64_t late) {
        for (int i = 0; i < ticks; ++i) jitter.came(now += 1'000'000 + (i % 2 == 0 ? late : -early));
        return jitter.seconds();
    };
    EXPECT_EQ(run(500, 0, 0), 0);
    EXPECT_NEAR(run(8000, 200'000, 200'000), 2e-4, 1e-6);
    EXPECT_LT(run(10'000, 0, 0), 2e-6);
    jitter.came(now += 101'000'000);  // once late by 100 ms: 100 ms / sqrt(1000)
    EXPECT_NEAR(jitter.seconds(), 3.16e-3, 1e-4);
}

}  // namespace
}  // namespace fulcrum
