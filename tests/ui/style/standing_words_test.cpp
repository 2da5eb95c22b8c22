// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "ui/style/standing_badge.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

TEST(StandingWords, DoNotPromiseThatPassesOnProvisionalLimitsCompleteACheck) {
    TaskStanding check;
    check.standing = Standing::due;
    EXPECT_EQ(standing_detail(check), "Pass twice on one day to complete the check.");
    check.provisional_with = {DeviceClass::tracked};
    check.firm_with = {DeviceClass::haptic, DeviceClass::mouse_keyboard};
    EXPECT_TRUE(standing_detail(check).startsWith("Pass twice on one day to complete the check. Prov"));
    EXPECT_TRUE(standing_detail(check).endsWith(": " + device_class_text(DeviceClass::haptic) + ", " +
                                                device_class_text(DeviceClass::mouse_keyboard) + "."));
    check.provisional = true;
    EXPECT_FALSE(standing_detail(check).contains("Pass twice"));
    EXPECT_TRUE(standing_detail(check).contains("An educator can decide"));
}

TEST(StandingWords, SayThatAnEducatorDecidedAboutTheProficiency) {
    TaskStanding decided;
    decided.standing = Standing::maintained;
    decided.declared_at = 1'763'600'000'000;
    EXPECT_EQ(standing_name(decided), "maintained");
    EXPECT_EQ(standing_text(decided), "proficient, last check passed");
    decided.by_override = true;
    EXPECT_EQ(standing_name(decided), "maintained (decision)");
    EXPECT_EQ(standing_text(decided), "proficient, last check passed, by decision of an educator");
    TaskStanding unlocked;
    unlocked.standing = Standing::open;
    unlocked.by_override = true;
    EXPECT_EQ(standing_name(unlocked), "open") << "nothing was declared";
}

TEST(StandingWords, DoNotPromiseThatPassesOnProvisionalLimitsRestoreProficiency) {
    TaskStanding lost;
    lost.standing = Standing::relapsed;
    EXPECT_EQ(standing_detail(lost), "Three passes in four attempts restore proficiency.");
    lost.provisional_with = {DeviceClass::tracked};
    lost.firm_with = {DeviceClass::haptic};
    EXPECT_TRUE(standing_detail(lost).endsWith(": " + device_class_text(DeviceClass::haptic) + "."));
    lost.provisional = true;
    EXPECT_FALSE(standing_detail(lost).contains("Three passes"));
    EXPECT_TRUE(standing_detail(lost).contains("An educator can decide"));
}

TEST(StandingWords, AskForOneMorePassWhereThoseFromBeforeAMoveAreEnough) {
    TaskStanding moved;
    moved.standing = Standing::passed;
    moved.progress = 2.0 / 3;
    EXPECT_EQ(standing_detail(moved), "66 % of the way to proficiency");
    moved.one_more_pass = true;
    EXPECT_EQ(standing_detail(moved),
              "You have enough passes for the present rule: the next pass that meets it counts.");
}

TEST(StandingWords, SayWhatHelpsWhereRatingsAreMissing) {
    TaskStanding waits;
    waits.standing = Standing::awaiting_rating;
    waits.raters = 1;
    waits.raters_needed = 2;
    EXPECT_TRUE(standing_detail(waits).contains("1 of 2 ratings are released."));
    waits.rating_late = true;
    EXPECT_TRUE(standing_detail(waits).contains("(1 of 2 are released): the next pass"));
    EXPECT_TRUE(standing_detail(waits).contains("An educator can decide"));
}

TEST(StandingWords, AskForNoPassWhereNobodyCanMeetTheRule) {
    TaskStanding passed;
    passed.standing = Standing::passed;
    passed.one_more_day = true;
    EXPECT_EQ(standing_detail(passed), "Pass once more on another day.");
    passed.never_met = true;
    EXPECT_TRUE(standing_detail(passed).startsWith("Nobody can meet the rule of this task"));
}

}  // namespace
}  // namespace fulcrum::ui
