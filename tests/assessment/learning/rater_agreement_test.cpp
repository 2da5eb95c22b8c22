// SPDX-License-Identifier: Apache-2.0
// The largest complete table of raters and targets, against a search over all pairs of groups; its agreement,
// against Shrout and Fleiss's example.
#include "assessment/learning/rater_agreement.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace fulcrum {
namespace {

std::vector<RaterScore> shrout_and_fleiss() {
    const std::vector<std::vector<double>> table = {{9, 2, 5, 8}, {6, 1, 3, 2},  {8, 4, 6, 8},
                                                    {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};
    std::vector<RaterScore> scores;
    for (std::size_t i = 0; i < table.size(); ++i)
        for (std::size_t j = 0; j < 4; ++j)
            scores.push_back({"target " + std::to_string(i), "rater " + std::to_string(j), table[i][j]});
    return scores;
}

TEST(RaterAgreement, CompleteTableIsTakenWholeAndGivesThePublishedValue) {
    const RatingTable table = largest_complete_table(shrout_and_fleiss());
    ASSERT_EQ(table.targets.size(), 6U);
    ASSERT_EQ(table.raters.size(), 4U);
    const std::optional<Correlation> icc = agreement_of(table);
    ASSERT_TRUE(icc);
    EXPECT_NEAR(icc->value, 0.29, 0.005);  // ICC(2,1) of the example
    EXPECT_LT(icc->low, icc->value);
    EXPECT_GT(icc->high, icc->value);
}

TEST(RaterAgreement, RaterWhoRatedLittleIsLeftOutRatherThanMostTargets) {
    std::vector<RaterScore> scores = shrout_and_fleiss();
    scores.push_back({"target 0", "rater 9", 3});
    scores.push_back({"target 1", "rater 9", 4});
    scores.push_back({"target 7", "rater 0", 4});
    const RatingTable table = largest_complete_table(scores);
    EXPECT_EQ(table.raters.size(), 4U);
    EXPECT_EQ(table.targets.size(), 6U);
}

TEST(RaterAgreement, NeedsTwoRatersTwoTargetsAndADifference) {
    EXPECT_FALSE(agreement_of(largest_complete_table({})));
    EXPECT_FALSE(agreement_of(largest_complete_table({{"a", "x", 1}, {"a", "y", 2}})));
    EXPECT_FALSE(agreement_of(largest_complete_table({{"a", "x", 1}, {"b", "x", 2}})));
    EXPECT_FALSE(agreement_of(largest_complete_table({{"a", "x", 1}, {"b", "y", 2}})));
    EXPECT_FALSE(
        agreement_of(largest_complete_table({{"a", "x", 3}, {"a", "y", 3}, {"b", "x", 3}, {"b", "y", 3}})));
    const auto same =
        agreement_of(largest_complete_table({{"a", "x", 3}, {"a", "y", 3}, {"b", "x", 5}, {"b", "y", 5}}));
    ASSERT_TRUE(same);
    EXPECT_NEAR(same->value, 1, 1e-6);
}

TEST(RaterAgreement, LastScoreOfARaterCounts) {
    const RatingTable table =
        largest_complete_table({{"a", "x", 1}, {"a", "y", 2}, {"b", "x", 3}, {"b", "y", 4}, {"a", "x", 5}});
    EXPECT_EQ(table.scores, (std::vector<std::vector<double>>{{5, 2}, {3, 4}}));
}

TEST(RaterAgreement, OfManyRatersThoseWithFewestRatingsAreLeftOut) {
    std::vector<RaterScore> scores;
    for (int rater = 0; rater < 20; ++rater)
        for (int target = 0; target < 2 + rater; ++target)
            scores.push_back({std::to_string(100 + target), std::to_string(100 + rater), 1.0 * target});
    const RatingTable table = largest_complete_table(scores);
    EXPECT_FALSE(table.raters.empty());
    EXPECT_GE(table.raters.front(), "108");
}

TEST(RaterAgreement, LevelsAreThoseOfKooAndLi) {
    EXPECT_EQ(agreement_level(-0.2), AgreementLevel::poor);
    EXPECT_EQ(agreement_level(0.4999), AgreementLevel::poor);
    EXPECT_EQ(agreement_level(0.5), AgreementLevel::moderate);
    EXPECT_EQ(agreement_level(0.75), AgreementLevel::good);
    EXPECT_EQ(agreement_level(0.9), AgreementLevel::excellent);
}

TEST(RaterAgreement, NoCompleteTableIsLargerAndEveryCellIsAScoreThatWasGiven) {
    rc::check([] {
        const int raters = *rc::gen::inRange(1, 6), targets = *rc::gen::inRange(1, 7);
        std::vector<RaterScore> scores;
        std::vector<unsigned> rated;
        for (int t = 0; t < targets; ++t) {
            rated.push_back(*rc::gen::inRange(0U, 1U << static_cast<unsigned>(raters)));
            for (int r = 0; r < raters; ++r)
                if ((rated.back() >> static_cast<unsigned>(r) & 1U) != 0)
                    scores.push_back({std::string(1, static_cast<char>('a' + t)),
                                      std::string(1, static_cast<char>('p' + r)), 10.0 * t + r});
        }
        std::size_t most = 0;
        for (unsigned group = 1; group < 1U << static_cast<unsigned>(raters); ++group) {
            std::size_t people = 0, complete = 0;
            for (int r = 0; r < raters; ++r) people += group >> static_cast<unsigned>(r) & 1U;
            for (const unsigned by : rated) complete += (by & group) == group ? 1 : 0;
            if (people >= 2 && complete >= 2) most = std::max(most, people * complete);
        }
        const RatingTable table = largest_complete_table(scores);
        RC_ASSERT(table.raters.size() * table.targets.size() == most);
        for (std::size_t i = 0; i < table.targets.size(); ++i)
            for (std::size_t j = 0; j < table.raters.size(); ++j)
                RC_ASSERT(table.scores[i][j] ==
                          10.0 * (table.targets[i][0] - 'a') + (table.raters[j][0] - 'p'));
    });
}

}  // namespace
}  // namespace fulcrum
