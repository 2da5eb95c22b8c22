// SPDX-License-Identifier: Apache-2.0
// Statistics of a curriculum against published values, exact cases and simulation.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>

#include <chrono>
#include <cmath>
#include <optional>
#include <random>

#include "assessment/learning/agreement.h"
#include "assessment/learning/learning_curve.h"
#include "assessment/learning/pass_rule.h"
#include "assessment/learning/survival.h"

namespace fulcrum {
namespace {

/// Shares of `people` that meet the rule within `attempts`, by playing it.
OperatingPoint simulated(const PassRule& rule, double q, int attempts, int people) {
    std::mt19937_64 random(7);
    std::bernoulli_distribution pass(q);
    std::vector<int> met_at(static_cast<std::size_t>(attempts) + 1, 0);
    for (int person = 0; person < people; ++person) {
        double sum = 0;
        unsigned bits = 0;
        int run = 0;
        for (int t = 1; t <= attempts; ++t) {
            const bool passed = pass(random);
            bool met = false;
            if (rule.kind == PassRuleKind::lc_cusum) {
                sum = std::max(0.0, sum + lc_cusum_step(rule, passed));
                met = sum >= rule.h;
            } else if (rule.kind == PassRuleKind::in_a_row) {
                run = passed ? run + 1 : 0;
                met = run >= rule.k;
            } else {
                bits = ((bits << 1U) | (passed ? 1U : 0U)) & ((1U << static_cast<unsigned>(rule.n)) - 1U);
                met = __builtin_popcount(bits) >= rule.k;
            }
            if (met) {
                ++met_at[static_cast<std::size_t>(t)];
                break;
            }
        }
    }
    OperatingPoint point;
    double moment = 0, count = 0;
    for (int t = 1; t <= attempts; ++t) {
        count += met_at[static_cast<std::size_t>(t)];
        moment += t * met_at[static_cast<std::size_t>(t)];
    }
    point.declared = count / people;
    if (count > 0) point.mean_attempts_if_declared = moment / count;
    return point;
}

TEST(OperatingCurve, AgreesWithAMillionSimulatedTrainees) {
    for (const char* text : {"row:2", "lc-cusum:0.1,0.3,2.5", "of:4,5"}) {
        const PassRule rule = parse_pass_rule(text);
        for (const double q : {0.5, 0.8}) {
            const OperatingPoint exact = operating_point(rule, q, 30),
                                 played = simulated(rule, q, 30, 1'000'000);
            EXPECT_NEAR(exact.declared, played.declared, 0.002) << text << " " << q;
            if (played.declared > 0.01) {
                EXPECT_NEAR(*exact.mean_attempts_if_declared, *played.mean_attempts_if_declared,
                            40 / std::sqrt(played.declared * 1e6))
                    << text << " " << q;
            }
        }
    }
}

TEST(OperatingCurve, HasItsClosedForms) {
    // Two in a row within 30 at one half: 1 - F(32) / 2^30 with Fibonacci numbers.
    const OperatingPoint two = operating_point(parse_pass_rule("row:2"), 0.5, 30);
    EXPECT_NEAR(two.declared, 1 - 2178309.0 / 1073741824.0, 1e-12);
    EXPECT_NEAR(two.declared, 0.998, 5e-4);
    EXPECT_EQ(*two.median_attempts, 4) << "8 of the 16 sequences of four have two in a row";
    const OperatingPoint once = operating_point(parse_pass_rule("row:1"), 0.3, 10);
    EXPECT_NEAR(once.declared, 1 - std::pow(0.7, 10), 1e-12);  // 0.97
    EXPECT_EQ(operating_point(parse_pass_rule("row:3"), 0, 30).declared, 0);
    EXPECT_FALSE(operating_point(parse_pass_rule("row:3"), 0, 30).median_attempts.has_value());
    EXPECT_FALSE(operating_point(parse_pass_rule("row:3"), 0, 30).mean_attempts_if_declared.has_value());
    // Ten passes at 0.251314 are the fewest that reach 2.5.
    const OperatingPoint sure = operating_point(parse_pass_rule("lc-cusum:0.1,0.3,2.5"), 1, 30);
    EXPECT_EQ(*sure.median_attempts, 10);
    EXPECT_EQ(operating_point(parse_pass_rule("of:4,5"), 1, 30).median_attempts, 4)
        << "met before five attempts";
}

TEST(OperatingCurve, EndsAtThePointAndNeverFalls) {
    for (const char* text : {"row:3", "of:4,5", "of:8,16", "lc-cusum:0.1,0.3,2.5"}) {
        const PassRule rule = parse_pass_rule(text);
        const std::vector<double> curve = operating_curve(rule, 0.7, 40);
        ASSERT_EQ(curve.size(), 40U);
        EXPECT_TRUE(std::is_sorted(curve.begin(), curve.end())) << text;
        for (const int attempts : {1, 7, 40})
            EXPECT_EQ(curve[static_cast<std::size_t>(attempts - 1)],
                      operating_point(rule, 0.7, attempts).declared)
                << text;
        EXPECT_EQ(pass_rule_text(rule), text) << "the text of a rule is read as the rule";
    }
}

TEST(OperatingCurve, TakesLessThan50Milliseconds) {
    for (const char* text : {"row:2", "lc-cusum:0.1,0.3,2.5", "of:4,5"}) {
        const PassRule rule = parse_pass_rule(text);
        const std::clock_t begin = std::clock();
        operating_point(rule, 0.7, 30);
        EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 0.05) << text;
    }
}

RC_GTEST_PROP(OperatingCurveProperty, RisesWithSkillAndWithAttempts, ()) {
    const PassRule rule = parse_pass_rule(
        *rc::gen::element<std::string>("row:3", "of:3,4", "lc-cusum:0.1,0.3,2.5", "lc-cusum:0.05,0.2,1.5"));
    const double q = 0.01 * *rc::gen::inRange(0, 100);
    const int attempts = *rc::gen::inRange(1, 40);
    const double here = operating_point(rule, q, attempts).declared;
    RC_ASSERT(operating_point(rule, q + 0.01, attempts).declared >= here - 1e-12);
    RC_ASSERT(operating_point(rule, q, attempts + 1).declared >= here - 1e-12);
    RC_ASSERT(here >= 0 && here <= 1 + 1e-12);
}

std::vector<double> curve(double plateau, double first, double rate, bool power, int n, double noise) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    std::vector<double> values;
    for (int x = 1; x <= n; ++x)
        values.push_back(plateau +
                         (first - plateau) * (power ? std::pow(x, -rate) : std::exp(-rate * (x - 1))) +
                         noise * normal(random));
    return values;
}

TEST(LearningCurve, GivesTheSameIntervalsWhenTheyAreAskedForLater) {
    const std::vector<double> values = curve(20, 90, 0.8, true, 12, 3);
    const std::vector<CurveFit> whole = fit_curves(values), fits = fit_curves(values, false);
    ASSERT_EQ(fits.size(), whole.size());
    for (std::size_t i = 0; i < fits.size(); ++i) {
        EXPECT_EQ(fits[i].plateau, whole[i].plateau);
        EXPECT_EQ(fits[i].aicc, whole[i].aicc);
        EXPECT_FALSE(fits[i].plateau_low || fits[i].plateau_high);
        EXPECT_EQ(plateau_end(values, fits[i], PlateauEnd::low), whole[i].plateau_low);
        EXPECT_EQ(plateau_end(values, fits[i], PlateauEnd::high), whole[i].plateau_high);
    }
}

TEST(LearningCurve, RecoversTheParametersOfExactCurves) {
    const std::vector<CurveFit> power = fit_curves(curve(20, 90, 0.8, true, 40, 0));
    ASSERT_EQ(power.size(), 3U);
    EXPECT_EQ(best_curve(power).model, CurveModel::power);
    EXPECT_NEAR(best_curve(power).plateau, 20, 1e-4);
    EXPECT_NEAR(best_curve(power).first, 90, 1e-4);
    EXPECT_NEAR(best_curve(power).rate, 0.8, 1e-5);
    const std::vector<CurveFit> exponential = fit_curves(curve(35, 100, 0.2, false, 40, 0));
    EXPECT_EQ(best_curve(exponential).model, CurveModel::exponential);
    EXPECT_NEAR(best_curve(exponential).plateau, 35, 1e-4);
    EXPECT_NEAR(best_curve(exponential).rate, 0.2, 1e-5);
    const std::vector<CurveFit> inverse = fit_curves(curve(10, 60, 1, true, 20, 0));
    EXPECT_EQ(best_curve(inverse).model, CurveModel::inverse) << "the same curve with one parameter less";
    EXPECT_NEAR(inverse[0].at(5), 20, 1e-9);
}

TEST(LearningCurve, AiccIsThatOfItsFormula) {
    const std::vector<double> values = curve(20, 90, 0.8, true, 12, 3);
    const CurveFit fit = fit_curves(values)[1];
    const double n = 12, k = 4;
    EXPECT_NEAR(fit.aicc, n * std::log(fit.rss / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1), 1e-9);
}

TEST(LearningCurve, PlateauIntervalCoversTheTruthAndIsOpenWhereItIsNotVisible) {
    int covered = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        std::vector<double> values;
        for (int x = 1; x <= 40; ++x)
            values.push_back(30 + 60 * std::exp(-0.25 * (x - 1)) + 4 * normal(random));
        // The intervals of the other two models take most of the time.
        const CurveFit fit = fit_curves(values, false)[2];
        const std::optional<double> low = plateau_end(values, fit, PlateauEnd::low),
                                    high = plateau_end(values, fit, PlateauEnd::high);
        ASSERT_TRUE(low && high) << seed;
        covered += *low <= 30 && 30 <= *high ? 1 : 0;
    }
    EXPECT_GE(covered, 180) << "of 200 at 95 %";
    const CurveFit straight = fit_curves({100, 98, 97, 95, 94, 92, 91, 89, 88, 86})[2];
    EXPECT_FALSE(straight.plateau_low.has_value()) << "still improving by the same step";
    EXPECT_TRUE(fit_curves({5, 4, 3, 2, 1, 1, 1}).empty()) << "fewer than 8 attempts";
}

TEST(LearningCurve, AttemptsToALimit) {
    const std::vector<double> values = curve(30, 90, 0.25, false, 40, 2);
    const CurveFit fit = fit_curves(values)[2];
    const AttemptsToLimit met = attempts_to_limit(values, fit, 40, true);
    // 30 + 60 exp(-0.25 (x - 1)) = 40 at x = 8.2
    ASSERT_TRUE(met.attempts && met.low && met.high);
    EXPECT_NEAR(*met.attempts, 9, 1);
    EXPECT_LE(*met.low, *met.attempts);
    EXPECT_GE(*met.high, *met.attempts);
    const AttemptsToLimit never = attempts_to_limit(values, fit, 10, true);
    EXPECT_FALSE(never.attempts.has_value());
    EXPECT_FALSE(never.high.has_value());
    EXPECT_EQ(*attempts_to_limit(values, fit, 20, false).attempts, 1) << "higher is better: met at once";
}

/// y = a + b/x is linear in a and b, so that the ends of the profile interval of a have a closed form.
TEST(LearningCurve, PlateauIntervalOfTheInverseCurveIsThatOfItsClosedForm) {
    const std::vector<double> values = {98, 66, 52, 49, 43, 44, 39, 41, 36, 38, 37, 35};
    const double n = 12, limit = 37;
    double u = 0, uu = 0, y = 0, uy = 0;
    for (int x = 1; x <= 12; ++x) {
        const double value = values[static_cast<std::size_t>(x - 1)];
        u += 1.0 / x;
        uu += 1.0 / x / x;
        y += value;
        uy += value / x;
    }
    const double b = (uy - u * y / n) / (uu - u * u / n), a = (y - b * u) / n;
    double rss = 0;
    for (int x = 1; x <= 12; ++x) rss += std::pow(values[static_cast<std::size_t>(x - 1)] - a - b / x, 2);
    const double half = std::sqrt(rss * std::expm1(3.841458820694124 / n) / (n - u * u / uu));
    const CurveFit fit = fit_curves(values)[0];
    ASSERT_EQ(fit.model, CurveModel::inverse);
    EXPECT_NEAR(fit.plateau, a, 1e-4);
    ASSERT_TRUE(fit.plateau_low && fit.plateau_high);
    EXPECT_NEAR(*fit.plateau_low, a - half, 1e-4);
    EXPECT_NEAR(*fit.plateau_high, a + half, 1e-4);
    // With the plateau at an end, b follows; the first whole attempt at or below the limit.
    const auto first_at = [&](double plateau) {
        return static_cast<int>(std::ceil((uy - plateau * u) / uu / (limit - plateau)));
    };
    const AttemptsToLimit met = attempts_to_limit(values, fit, limit, true);
    EXPECT_EQ(met.attempts, static_cast<int>(std::ceil(b / (limit - a))));
    EXPECT_EQ(met.low, first_at(a - half));
    EXPECT_EQ(met.high, first_at(a + half));
    EXPECT_LT(*met.low, *met.high);
}

TEST(LearningCurve, EqualAndHugeValuesGiveFiniteFits) {
    for (const std::vector<double>& values : {std::vector<double>(10, 5.0), std::vector<double>(10, 0.0),
                                              curve(1e12, 3e12, 0.3, false, 10, 1e10)}) {
        for (const CurveFit& fit : fit_curves(values)) {
            EXPECT_TRUE(std::isfinite(fit.aicc) && std::isfinite(fit.plateau) && std::isfinite(fit.rss));
            EXPECT_NEAR(fit.at(10), values[9], 1e-6 + 0.2 * std::fabs(values[9]));
        }
    }
}

// Shrout and Fleiss 1979, table 2: six targets, four judges; their table 4 has 0.17, 0.29, 0.71, 0.44, 0.62,
// 0.91.
const std::vector<std::vector<double>> judges = {{9, 2, 5, 8}, {6, 1, 3, 2},  {8, 4, 6, 8},
                                                 {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};

TEST(Agreement, GivesTheSixFormsOfShroutAndFleiss) {
    const IntraclassCorrelations icc = intraclass_correlations(judges);
    EXPECT_NEAR(icc.one_1.value, 0.165742, 1e-6);
    EXPECT_NEAR(icc.two_1.value, 0.289764, 1e-6);
    EXPECT_NEAR(icc.three_1.value, 0.714841, 1e-6);
    EXPECT_NEAR(icc.one_k.value, 0.442797, 1e-6);
    EXPECT_NEAR(icc.two_k.value, 0.620051, 1e-6);
    EXPECT_NEAR(icc.three_k.value, 0.909316, 1e-6);
    // Intervals by the formulas of Shrout and Fleiss (1979) and of McGraw and Wong (1996), with quantiles of
    // F from a numerical integral.
    const auto expect = [](const Correlation& found, double low, double high) {
        EXPECT_NEAR(found.low, low, 1e-4);
        EXPECT_NEAR(found.high, high, 1e-4);
    };
    expect(icc.one_1, -0.132932, 0.722560);
    expect(icc.two_1, 0.018787, 0.761084);
    expect(icc.three_1, 0.342465, 0.945858);
    expect(icc.one_k, -0.884442, 0.912415);
    expect(icc.two_k, 0.071137, 0.927232);
    expect(icc.three_k, 0.675675, 0.985892);
}

TEST(Agreement, AlphaIsThatOfItsDefinition) {
    double items = 0;
    const double k = 4;
    const auto variance = [](const std::vector<double>& values) {
        double mean = 0, sum = 0;
        for (const double v : values) mean += v / static_cast<double>(values.size());
        for (const double v : values) sum += (v - mean) * (v - mean);
        return sum / static_cast<double>(values.size() - 1);
    };
    std::vector<double> totals;
    for (const auto& row : judges) totals.push_back(row[0] + row[1] + row[2] + row[3]);
    for (std::size_t j = 0; j < 4; ++j) {
        std::vector<double> item;
        for (const auto& row : judges) item.push_back(row[j]);
        items += variance(item);
    }
    EXPECT_NEAR(cronbach_alpha(judges), k / (k - 1) * (1 - items / variance(totals)), 1e-12);
    // It is the consistency of the mean of the judges, published as 0.91 (Shrout and Fleiss 1979, table 4).
    EXPECT_NEAR(cronbach_alpha(judges), 0.909316, 1e-6);
}

TEST(Agreement, RefusesWhatIsNotATableAndKeepsNegativeValues) {
    EXPECT_THROW(intraclass_correlations({{1, 2}}), std::invalid_argument);
    EXPECT_THROW(intraclass_correlations({{1}, {2}}), std::invalid_argument);
    EXPECT_THROW(intraclass_correlations({{1, 2}, {2}}), std::invalid_argument);
    EXPECT_THROW(intraclass_correlations({{1, 1}, {1, 1}}), std::invalid_argument);
    EXPECT_THROW(intraclass_correlations({{1, NAN}, {1, 2}}), std::invalid_argument);
    EXPECT_LT(intraclass_correlations({{1, 5}, {5, 1}, {1, 4}, {4, 1}}).one_1.value, 0);
    const IntraclassCorrelations same = intraclass_correlations({{1, 1}, {2, 2}, {5, 5}});
    EXPECT_NEAR(same.two_1.value, 1, 1e-9);
    EXPECT_TRUE(std::isfinite(same.two_1.low) && std::isfinite(same.three_k.high));
}

TEST(Agreement, QuantilesOfF) {
    // Published tables of the F distribution.
    EXPECT_NEAR(f_quantile(0.95, 5, 10), 3.3258, 1e-4);
    EXPECT_NEAR(f_quantile(0.975, 5, 18), 3.3820, 1e-4);
    EXPECT_NEAR(f_quantile(0.99, 1, 1), 4052.18, 0.01);
    EXPECT_NEAR(f_quantile(0.5, 7, 7), 1, 1e-9);
}

// Freireich and others 1963: weeks of remission under 6-mercaptopurine; median 23, log-log interval from 13.
TEST(Survival, MedianOfTheRemissionData) {
    std::vector<Observation> people;
    for (const double time : {6, 6, 6, 7, 10, 13, 16, 22, 23}) people.push_back({time, true});
    for (const double time : {6, 9, 10, 11, 17, 19, 20, 25, 32, 32, 34, 35})
        people.push_back({static_cast<double>(time), false});
    const std::vector<SurvivalStep> steps = survival_curve(people);
    ASSERT_EQ(steps.size(), 7U);
    EXPECT_NEAR(steps[0].waiting, 0.857143, 1e-6);
    EXPECT_NEAR(steps[3].waiting, 0.690196, 1e-6);
    EXPECT_NEAR(steps[6].waiting, 0.448179, 1e-6);
    const SurvivalMedian median = survival_median(steps);
    EXPECT_EQ(median.median, 23);
    EXPECT_EQ(median.low, 13);
    EXPECT_FALSE(median.high.has_value());
    EXPECT_TRUE(survival_curve({}).empty());
    EXPECT_FALSE(survival_median({}).median.has_value());
}

TEST(Survival, TheMedianOfAFewHasNoUpperEnd) {
    const SurvivalMedian one = survival_median(survival_curve({Observation{5, true}}));
    EXPECT_EQ(one.median, 5);
    EXPECT_EQ(one.low, 5);
    EXPECT_FALSE(one.high.has_value()) << "no interval is defined where the curve is 0";
    const std::vector<SurvivalStep> two = survival_curve({Observation{5, true}, Observation{8, true}});
    ASSERT_EQ(two.size(), 2U);
    EXPECT_EQ(two[1].waiting, 0);
    EXPECT_EQ(two[1].low, 0);
    EXPECT_EQ(two[1].high, two[0].high);
    EXPECT_FALSE(survival_median(two).high.has_value());
    // Of 21 the interval ends before the last one is there.
    std::vector<Observation> people;
    for (int i = 1; i <= 21; ++i) people.push_back({static_cast<double>(i), true});
    const SurvivalMedian many = survival_median(survival_curve(people));
    EXPECT_EQ(many.median, 11);
    ASSERT_TRUE(many.high.has_value());
    EXPECT_LT(*many.high, 21);
}

TEST(Survival, WilsonIntervals) {
    // Newcombe 1998, table I, method 3: 81 of 263 and 0 of 20.
    EXPECT_NEAR(wilson(81, 263).low, 0.2553, 1e-4);
    EXPECT_NEAR(wilson(81, 263).high, 0.3662, 1e-4);
    EXPECT_NEAR(wilson(0, 20).high, 0.1611, 1e-4);
    EXPECT_EQ(wilson(0, 20).low, 0);
    EXPECT_EQ(wilson(0, 0).high, 1);
}

}  // namespace
}  // namespace fulcrum
