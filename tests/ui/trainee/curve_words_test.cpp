// SPDX-License-Identifier: GPL-3.0-or-later
// What a learning curve says in words.
#include "ui/trainee/curve_words.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fulcrum::ui {
namespace {

std::vector<CurveValue> improving(int attempts, double plateau) {
    std::vector<CurveValue> values;
    for (int i = 0; i < attempts; ++i)
        values.push_back({2 * i + 1, plateau + 60 * std::exp(-0.3 * i) + (i % 2 == 0 ? 1.0 : -1.0)});
    return values;
}

/// With plain spaces between numbers and units.
QString words_of(const LearningCurve& curve) {
    return QString(curve.words).simplified().replace(QChar(0x202f), ' ').replace(QChar(0x00a0), ' ');
}

TEST(LearningCurveWords, FewAttemptsGiveNoCurve) {
    const LearningCurve curve = learning_curve(improving(7, 30), 40.0, true, "mm");
    EXPECT_TRUE(curve.line.empty());
    EXPECT_EQ(curve.words, "A learning curve is shown from 8 completed attempts on.");
    EXPECT_TRUE(learning_curve({}, 40.0, true, "mm").words.isEmpty());
}

TEST(LearningCurveWords, SaysWhereItLevelsOffAndWhetherTheLimitIsMet) {
    const LearningCurve met = learning_curve(improving(30, 30), 40.0, true, "mm");
    ASSERT_EQ(met.line.size(), 30U);
    EXPECT_EQ(met.line[4].first, 9) << "numbered as the chart numbers the attempts";
    ASSERT_TRUE(met.plateau_low && met.plateau_high);
    EXPECT_NEAR(*met.plateau_low, 30, 1);
    EXPECT_TRUE(words_of(met).startsWith("The curve levels off at 30")) << met.words.toStdString();
    EXPECT_TRUE(words_of(met).contains("has met the limit of 40 mm since attempt 13"))
        << "the seventh of those that were completed: " << met.words.toStdString();
    const LearningCurve never = learning_curve(improving(30, 30), 20.0, true, "mm");
    EXPECT_TRUE(words_of(never).contains("does not meet the limit of 20 mm")) << never.words.toStdString();
    EXPECT_FALSE(learning_curve(improving(30, 30), {}, true, "mm").words.contains("limit"));
}

TEST(LearningCurveWords, ACurveThatGotWorseNoLongerMeetsTheLimit) {
    std::vector<CurveValue> rising, falling;  // from 2 N towards 4.5 N, and its mirror image
    for (int i = 0; i < 20; ++i) {
        const double value = 4.5 - 2.5 * std::exp(-0.4 * i) + (i % 2 == 0 ? 0.05 : -0.05);
        rising.push_back({2 * i + 1, value});
        falling.push_back({2 * i + 1, 5 - value});
    }
    for (const LearningCurve& curve :
         {learning_curve(rising, 3.0, true, "N"), learning_curve(falling, 2.0, false, "N")}) {
        EXPECT_FALSE(words_of(curve).contains("has met the limit")) << curve.words.toStdString();
        EXPECT_TRUE(words_of(curve).contains("Since attempt 5 it no longer meets the limit of"))
            << "the third of those that were completed: " << curve.words.toStdString();
    }
    EXPECT_TRUE(words_of(learning_curve(rising, 3.0, true, "N")).contains("the limit of 3"));
    // One that got worse and still meets the limit has met it all along.
    EXPECT_TRUE(words_of(learning_curve(rising, 6.0, true, "N")).contains("has met the limit of 6"));
}

TEST(LearningCurveWords, SaysWhenTheLimitWouldBeMet) {
    std::vector<CurveValue> slow;
    for (int i = 0; i < 12; ++i) slow.push_back({i + 1, 100.0 - 2.5 * i + (i % 2 == 0 ? 0.4 : -0.4)});
    const LearningCurve curve = learning_curve(slow, 60.0, true, "s");
    EXPECT_TRUE(words_of(curve).startsWith("The curve has not levelled off yet."))
        << curve.words.toStdString();
    EXPECT_TRUE(words_of(curve).contains("It would meet the limit of 60 s at attempt"))
        << curve.words.toStdString();
    EXPECT_FALSE(curve.plateau_low.has_value());
}

TEST(LearningCurveWords, NumberTheAttemptsToComeAfterTheLastOneOfTheChart) {
    std::vector<CurveValue> slow;  // every other attempt was not completed; the last one is number 23
    std::vector<double> measured;
    for (int i = 0; i < 12; ++i) {
        slow.push_back({2 * i + 1, 100.0 - 2.5 * i + (i % 2 == 0 ? 0.4 : -0.4)});
        measured.push_back(slow.back().value);
    }
    const CurveFit fit = best_curve(fit_curves(measured));
    const AttemptsToLimit met = attempts_to_limit(measured, fit, 60.0, true);
    ASSERT_TRUE(met.attempts.has_value());
    ASSERT_GT(*met.attempts, 12);
    const LearningCurve curve = learning_curve(slow, 60.0, true, "s");
    EXPECT_TRUE(words_of(curve).contains(QString("at attempt %1 (").arg(23 + *met.attempts - 12)))
        << curve.words.toStdString();
}

TEST(LearningCurveWords, NameNoPlateauAboveTheHighestPossibleValue) {
    std::vector<CurveValue> rising;  // towards 104, as a fit through points of 97 to 99 may be
    for (int n = 1; n <= 30; ++n) rising.push_back({n, 104 - 60 / std::sqrt(n) + (n % 2 == 0 ? 0.3 : -0.3)});
    EXPECT_FALSE(learning_curve(rising, {}, false, "").words.contains("levels off at 100 "));
    const LearningCurve curve = learning_curve(rising, {}, false, "", 100);
    EXPECT_TRUE(curve.words.contains("levels off at 100 (")) << curve.words.toStdString();
    ASSERT_TRUE(curve.plateau_high);
    EXPECT_LE(*curve.plateau_high, 100);
}

}  // namespace
}  // namespace fulcrum::ui
