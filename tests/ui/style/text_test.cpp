// SPDX-License-Identifier: GPL-3.0-or-later
// Values and words as screens show them.
#include "ui/style/text.h"

#include <gtest/gtest.h>

#include "ui/language/language.h"
#include "ui/style/standing_badge.h"

namespace fulcrum::ui {
namespace {

TEST(ShownText, NegativeValuesHaveTheMinusSignEverywhere) {
    EXPECT_EQ(figure(-1.52), "\u22121.52");
    EXPECT_EQ(figure(-0.0001), "0");
    EXPECT_EQ(figure_with_unit(-12.34, "mm").at(0), QChar(0x2212));
    EXPECT_EQ(z_text(-0.9), "\u22120.90");
    EXPECT_EQ(figure_with_unit(5.33, "deg"), "5.33°");
}

TEST(ShownText, PointsOfAColumnHaveOneDecimalInEveryLanguage) {
    EXPECT_EQ(points_figure(97), "97.0");
    EXPECT_EQ(points_figure(51.26), "51.3");
    EXPECT_EQ(points_figure(std::nullopt), "–");
    use_language(Language::german);
    EXPECT_EQ(points_figure(97), "97,0");
    use_language(Language::english);
}

TEST(ShownText, LimitsOfTimeHaveNoTenths) {
    EXPECT_EQ(minutes_text(300), "5\u00a0min");
    EXPECT_EQ(minutes_text(450), "7:30\u00a0min");
    EXPECT_EQ(minutes_text(65), "1:05\u00a0min");
}

TEST(ShownText, SourcesOfLimitsNameNoSeeds) {
    EXPECT_EQ(limit_source_text("synthetic operators, seeds 1000-1999, set 4, 32 experts"),
              "32 simulated experts, benchmark set 4");
    EXPECT_EQ(limit_source_text("synthetic operators, seeds 1-9, set 2, 8 experts, worst counted value"),
              "8 simulated experts, benchmark set 2; the worst value that counts");
    EXPECT_EQ(limit_source_text("Twelve consultants, Leeds, set 7, 12 experts"),
              "12 experts, benchmark set 7 (Twelve consultants, Leeds)");
    EXPECT_EQ(limit_source_text("A margin of 1 mm or less is positive"),
              "A margin of 1 mm or less is positive");
    EXPECT_EQ(limit_source_text("A firm press, on a ball, taken over by experts of this site, set 12"),
              "A firm press, on a ball; taken over with benchmark set 12 (experts of this site)");
    use_language(Language::german);
    EXPECT_EQ(limit_source_text("synthetic operators, seeds 1000-1999, set 4, 32 experts"),
              "32 simulierte Experten, Satz 4");
    EXPECT_EQ(limit_source_text("Training limit of this task: a firm press on a rigid sphere, taken over by "
                                "experts of this site, set 4"),
              asset_text("Training limit of this task: a firm press on a rigid sphere") +
                  "; übernommen mit Satz 4 (Experten dieses Standorts)");
    use_language(Language::english);
}

TEST(ShownText, AStandingIsGreenOnlyWhereNothingIsToBeDone) {
    for (const Standing good :
         {Standing::passed, Standing::awaiting_rating, Standing::proficient, Standing::maintained})
        EXPECT_STREQ(standing_role(good), "good");
    for (const Standing other :
         {Standing::locked, Standing::open, Standing::attempted, Standing::due, Standing::relapsed})
        EXPECT_STRNE(standing_role(other), "good");
}

}  // namespace
}  // namespace fulcrum::ui
