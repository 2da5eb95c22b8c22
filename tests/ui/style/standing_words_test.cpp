// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "ui/style/standing_badge.h"

namespace fulcrum::ui {
namespace {

TEST(StandingWords, DoNotPromiseThatPassesOnProvisionalLimitsCompleteACheck) {
    TaskStanding check;
    check.standing = Standing::due;
    EXPECT_EQ(standing_detail(check), "Two passes on one day complete it.");
    check.provisional = true;
    EXPECT_FALSE(standing_detail(check).contains("Two passes"));
    EXPECT_TRUE(standing_detail(check).contains("ask your educator"));
}

}  // namespace
}  // namespace fulcrum::ui
