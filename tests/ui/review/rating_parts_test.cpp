// SPDX-License-Identifier: GPL-3.0-or-later
// Ratings in words, the choice of an item and the profile of several raters, each by itself.
#include <gtest/gtest.h>

#include <QRadioButton>

#include "assessment/assets/assets.h"
#include "database/records/ratings.h"
#include "tests/ui/hands.h"
#include "ui/reports/rating_words.h"
#include "ui/review/item_choice.h"
#include "ui/review/rating_profile.h"
#include "ui/style/palette.h"

namespace fulcrum::ui::window_test {
namespace {

TEST(RatingWords, SumsLevelsAndDifferences) {
    const ObserverForm goals = load_form(asset_path("forms/goals.json"));
    EXPECT_EQ(rating_sum_text(goals, {4, 3, 2, 5, 3}), "17 of 25");
    EXPECT_EQ(rating_sum_text(goals, FormAnswers(5)), "–");
    EXPECT_EQ(rating_spread_text(goals, {{4, 3, 2, 5, 3}}), "");
    EXPECT_EQ(rating_spread_text(goals, {{4, 3, 2, 5, 3}, {4, 3, 2, 5, 3}}),
              "The raters gave the same ratings.");
    EXPECT_EQ(rating_spread_text(goals, {FormAnswers(5), {4, 3, 2, 5, 3}}), "");
    database::FormAgreement agreement{"goals@1", "GOALS", 8, 4, 2, Correlation{0.8, 0.3, 0.95}};
    EXPECT_EQ(rater_agreement_text(agreement),
              "Agreement of raters with GOALS: poor to excellent. ICC(2,1) 0.80, 95 % interval 0.30 to 0.95 "
              "(2 raters, 4 attempts).");
    agreement.icc = Correlation{0.8, 0.76, 0.85};
    EXPECT_TRUE(rater_agreement_text(agreement).startsWith("Agreement of raters with GOALS: good. "));
    agreement.icc.reset();
    EXPECT_TRUE(rater_agreement_text(agreement).contains("all their ratings are equal"));
}

TEST(RatingItems, AWideScaleOfASiteFitsThePageAndIsChosenByMouse) {
    FormItem item;
    item.id = "precision";
    item.title = "Precision";
    item.lowest = 0;
    item.highest = 100;
    for (const int rating : {0, 10, 20, 40, 60, 80, 100})
        item.anchors.push_back(
            {rating, "What is seen at " + std::to_string(rating) + " of a hundred points"});
    ItemChoice choice(item, true);
    EXPECT_LT(choice.minimumSizeHint().width(), 730) << "a card at 1024 pixels";
    choice.resize(730, choice.sizeHint().height());
    choice.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&choice));
    EXPECT_FALSE(choice.answered());
    QTest::mouseClick(find<QRadioButton>(choice, "rate_precision_57"), Qt::LeftButton);
    EXPECT_EQ(choice.answer(), 57);
    choice.set_answer(100, true);
    EXPECT_EQ(choice.answer(), 100);
}

TEST(RatingProfiles, RatingsRunFromLeftToRightAndItemsDownwards) {
    const ObserverForm goals = load_form(asset_path("forms/goals.json"));
    RatingProfile profile(goals, {{"Ed", 0, {4, 3, 2, 5, 3}}, {"Ida", 1, {5, 4, 4, 4, std::nullopt}}});
    profile.resize(600, profile.minimumSizeHint().height());
    EXPECT_LT(profile.place_of(0, 1).x(), profile.place_of(0, 5).x());
    EXPECT_LT(profile.place_of(0, 1).y(), profile.place_of(4, 1).y());
    EXPECT_NEAR(profile.place_of(0, 3).x(), (profile.place_of(0, 1).x() + profile.place_of(0, 5).x()) / 2,
                1e-9);
    EXPECT_LT(profile.place_of(4, 1).y(), profile.height());
    EXPECT_TRUE(profile.accessibleDescription().endsWith("Autonomy: Ed 3 of 5, Ida not seen"));
    // A mark is painted where its rating is.
    const QImage picture = profile.grab().toImage();
    const QPointF at = profile.place_of(3, 5), other = profile.place_of(3, 1);
    EXPECT_EQ(picture.pixelColor(QPoint(int(at.x()), int(at.y()) - 4)), colours().left_hand);
    EXPECT_NE(picture.pixelColor(QPoint(int(other.x()), int(other.y()) - 4)), colours().left_hand);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
