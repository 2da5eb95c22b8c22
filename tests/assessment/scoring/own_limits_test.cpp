// SPDX-License-Identifier: Apache-2.0
// Limits that heed intermediates: a k for each gate, and absolute limits that a set narrows.
#include "assessment/scoring/own_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "assessment/scoring/judged_limits.h"
#include "sim_core/numerics/input_error.h"
#include "tests/assessment/scoring/fixtures.h"

namespace fulcrum {
namespace {

using test::figure;
using test::small_set;
using test::small_site_set;
using test::small_task;

/// z of each level: normal around the given means.
std::vector<JudgedAttempt> judged(int count, const std::vector<double>& means, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<JudgedAttempt> attempts;
    for (int n = 0; n < count; ++n) {
        JudgedAttempt attempt;
        attempt.otherwise = n % 25 != 0;
        attempt.person = n;
        for (const double mean : means) attempt.z.push_back(mean + normal(random));
        attempts.push_back(attempt);
    }
    return attempts;
}

bool surely_within(double share, int attempts) {
    return intermediates_surely_within(static_cast<int>(std::lround(share * attempts)), attempts);
}

TEST(OwnLimits, AreNarrowWhereIntermediatesDifferAndWideWhereTheyDoNot) {
    const std::vector<JudgedAttempt> experts = judged(96, {0, 0}, 1),
                                     intermediates = judged(40, {2.0, 0.1}, 2);
    const std::vector<double> start = {2.1, 2.1};
    const PassShares before = pass_shares(experts, intermediates, start);
    ASSERT_GT(before.intermediates, 0.4);
    const std::vector<double> k = limits_between(experts, intermediates, {0, 1}, start);
    EXPECT_LT(k[0], k[1]);
    const PassShares after = pass_shares(experts, intermediates, k);
    EXPECT_NEAR(after.intermediates, intermediates_middle, 0.75 * intermediates_half);
    EXPECT_NEAR(after.experts, experts_middle, 0.5 * experts_half + 1e-9);
    for (const double each : k) {
        EXPECT_GE(each, least_k);
        EXPECT_LE(each, largest_k);
        EXPECT_NEAR(each * 10, std::round(each * 10), 1e-9);
    }
}

TEST(OwnLimits, LetIntermediatesPassWhereNoneDid) {
    std::vector<JudgedAttempt> intermediates = judged(40, {1.0, 2.2}, 2);
    const std::vector<JudgedAttempt> experts = judged(96, {0, -1.5}, 1);
    const std::vector<double> start = {1.4, 1.4};
    const PassShares before = pass_shares(experts, intermediates, start);
    const std::vector<double> k = limits_between(experts, intermediates, {0, 1}, start);
    const PassShares after = pass_shares(experts, intermediates, k);
    EXPECT_GT(after.intermediates, before.intermediates);
    EXPECT_GT(k[1], 1.4) << "the gate that only intermediates fail";
    EXPECT_NEAR(after.intermediates, intermediates_middle, 0.75 * intermediates_half);
}

TEST(OwnLimits, UseAnAbsoluteGateOnlyWhereItHelps) {
    const std::vector<JudgedAttempt> experts = judged(96, {0, 0, 0}, 1),
                                     helped = judged(40, {0.3, 0.2, 3.2}, 2),
                                     not_helped = judged(40, {2.6, 0.2, 0}, 2);
    const std::vector<double> start = {2.2, 2.2, no_limit};
    EXPECT_LE(limits_between(experts, helped, {0, 1, 2}, start)[2], largest_k);
    EXPECT_EQ(limits_between(experts, not_helped, {0, 1, 2}, start)[2], no_limit);
}

TEST(OwnLimits, AFewAttemptsAreNotSurelyWithinTheBand) {
    EXPECT_FALSE(intermediates_surely_within(4, 40)) << "10 %, but 4 to 23 % is as likely";
    EXPECT_TRUE(intermediates_surely_within(8, 80));
    EXPECT_TRUE(intermediates_surely_within(23, 80));
    EXPECT_FALSE(intermediates_surely_within(24, 80)) << "30 %, up to 41 %";
    EXPECT_FALSE(intermediates_surely_within(0, 0));
}

TEST(OwnLimits, FitTheAttemptsThatTheyWereChosenOnBetterThanFreshOnes) {
    // Little tells the groups apart, so that which gates are narrow is decided by chance.
    const std::vector<double> means = {0.6, 0.5, 0.6, 0.5, 0.6, 0.5}, start(6, 2.4);
    const std::vector<int> gate = {0, 1, 2, 3, 4, 5};
    double chosen_on = 0, held_out = 0, fresh = 0;
    const int rounds = 8;
    for (unsigned round = 0; round < rounds; ++round) {
        const std::vector<JudgedAttempt> experts = judged(96, std::vector<double>(6, 0.0), 10 * round + 1),
                                         intermediates = judged(40, means, 10 * round + 2),
                                         others = judged(1000, means, 10 * round + 3);
        const HeldOutLimits limits = limits_for_fresh(experts, intermediates, gate, start);
        chosen_on += pass_shares(experts, intermediates, limits.k).intermediates / rounds;
        held_out += limits.held_out.intermediates / rounds;
        fresh += pass_shares(experts, others, limits.k).intermediates / rounds;
    }
    EXPECT_GT(fresh, chosen_on + 0.03);
    EXPECT_LT(std::abs(held_out - fresh), 0.8 * (fresh - chosen_on));
}

/// z of people whose attempts are alike: `alike` is the part of the variance that lies between people.
std::vector<JudgedAttempt> by_people(int people, int attempts, const std::vector<double>& means, double alike,
                                     unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<JudgedAttempt> all;
    for (int person = 0; person < people; ++person) {
        std::vector<double> own = means;
        for (double& mean : own) mean += std::sqrt(alike) * normal(random);
        for (int n = 0; n < attempts; ++n) {
            JudgedAttempt attempt;
            attempt.otherwise = all.size() % 50 != 49;
            attempt.person = person;
            for (const double mean : own) attempt.z.push_back(mean + std::sqrt(1 - alike) * normal(random));
            all.push_back(attempt);
        }
    }
    return all;
}

/// The k for all levels at which the share of experts is nearest to its middle, as the builder begins.
std::vector<double> one_k(const std::vector<JudgedAttempt>& experts, std::size_t levels) {
    std::vector<double> best;
    double least = 2;
    for (int tenths = 10; tenths <= 30; ++tenths) {
        const std::vector<double> k(levels, tenths / 10.0);
        const double off = std::abs(pass_shares(experts, {}, k).experts - experts_middle);
        if (off >= least - 1e-9) continue;
        least = off;
        best = k;
    }
    return best;
}

/// Of 50 sets made of as many attempts as the builder performs, what fresh experts pass.
struct Fresh {
    int used = 0, too_narrow = 0;  ///< limits that are used; of these, those that fail more than 20 %
    double difference = 0;         ///< mean of (share that was reported - share of fresh experts)
};
Fresh fresh_experts(double alike, bool with_margin) {
    const std::vector<int> gate = {0, 1};
    Fresh found;
    const unsigned rounds = 50;
    for (unsigned round = 0; round < rounds; ++round) {
        const auto experts = by_people(32, 3, {0, 0}, alike, 10 * round + 1),
                   intermediates = by_people(60, 1, {2, 0}, alike, 10 * round + 2),
                   fresh = by_people(2000, 1, {0, 0}, alike, 10 * round + 3);
        const std::vector<double> start = one_k(experts, 2);
        const HeldOutLimits limits = limits_for_fresh(experts, intermediates, gate, start);
        const std::vector<double> k =
            with_margin ? limits.k : limits_between(experts, intermediates, gate, start);
        const double share = pass_shares(fresh, {}, k).experts;
        const bool used = !with_margin || limits.sure();
        if (used) ++found.used;
        if (used && share < experts_middle - experts_half) ++found.too_narrow;
        found.difference += (limits.held_out.experts - share) / rounds;
    }
    return found;
}

TEST(OwnLimits, PassFreshExpertsAsOftenAsTheyReport) {
    for (const double alike : {0.5, 0.9}) {
        const Fresh sure = fresh_experts(alike, true);
        EXPECT_GE(sure.used, 30) << "too careful: most sets keep one k";
        EXPECT_LT(std::abs(sure.difference), 0.03) << alike;
        EXPECT_LE(sure.too_narrow, 3) << alike;
    }
    EXPECT_GE(fresh_experts(0.9, false).too_narrow, fresh_experts(0.9, true).too_narrow + 3)
        << "without the margin, limits that are best on a sample fail fresh experts";
}

TEST(OwnLimits, PreferAWideLimitToOneThatIsOnlyJustMet) {
    std::vector<JudgedAttempt> experts, intermediates;
    for (int n = 0; n < 32; ++n) experts.push_back({true, {0.95, n % 8 == 0 ? 3.5 : 0.0}, n});
    // The first level tells more intermediates apart, but experts are close to each limit that does.
    for (int n = 0; n < 60; ++n)
        intermediates.push_back({true, {n < 15 ? 0.5 : 1.15, n < 24 ? 0.5 : 2.9}, n});
    const std::vector<int> gate = {0, 1};
    const std::vector<double> start = {3, 3};
    EXPECT_NEAR(level_margin(experts), 1 / std::sqrt(32.0), 1e-12);
    EXPECT_LT(limits_between(experts, intermediates, gate, start)[0], 1.15);
    const std::vector<double> k = limits_with_margin(experts, intermediates, gate, start);
    EXPECT_GT(k[0], 1.15);
    EXPECT_LT(k[1], 2.9);
    EXPECT_EQ(pass_shares(experts, intermediates, k).experts, 0.875);
    for (JudgedAttempt& attempt : experts) attempt.person = 0;
    EXPECT_EQ(level_margin(experts), 1) << "attempts of one person are no more people";
    EXPECT_EQ(level_margin({}), 0);
}

TEST(OwnLimits, AreNotSureWhereExpertsLeftOutFailThem) {
    HeldOutLimits limits;
    limits.held_out.experts = least_held_out - 0.01;
    EXPECT_FALSE(limits.sure());
    limits.held_out.experts = least_held_out;
    EXPECT_TRUE(limits.sure());
}

TEST(OwnLimits, SayHowSureTheyAreByPeopleAndNotByAttempts) {
    const auto experts = by_people(32, 3, {0, 0}, 0.5, 1), intermediates = by_people(60, 1, {2, 0}, 0.5, 2);
    const HeldOutLimits limits = limits_for_fresh(experts, intermediates, {0, 1}, one_k(experts, 2));
    EXPECT_EQ(limits.people, 32);
    EXPECT_LT(limits.experts_low, limits.held_out.experts);
    EXPECT_GT(limits.experts_high, limits.held_out.experts);
    EXPECT_GT(limits.experts_high - limits.experts_low, 0.15) << "32 people, not 96 attempts";
    EXPECT_FALSE(limits_for_fresh({}, {}, {0}, {2.0}).sure());
    EXPECT_EQ(limits_for_fresh({}, {}, {0}, {2.0}).k, std::vector<double>{2.0});
}

TEST(OwnLimits, LeaveAPersonOutWithAllAttempts) {
    std::vector<JudgedAttempt> experts;
    for (int n = 0; n < 30; ++n) experts.push_back({true, {0.05 + 0.1 * n}, n});
    const std::vector<double> start = {3};
    const auto held_out = [&] { return held_out_shares(experts, {}, {0}, start).experts; };
    EXPECT_LT(held_out(), 1);
    for (JudgedAttempt& attempt : experts) attempt.person = 0;
    EXPECT_EQ(held_out(), 1) << "nobody is left to choose limits on, so they stay";
}

TEST(OwnLimits, AreOneForBothHandsAndStayWhereNothingIsBetter) {
    const std::vector<JudgedAttempt> experts = judged(96, {0, 0, 0}, 1),
                                     intermediates = judged(40, {1.8, 0.1, 0.1}, 2);
    const std::vector<double> k = limits_between(experts, intermediates, {0, 1, 1}, {2.3, 2.3, 2.3});
    EXPECT_EQ(k[1], k[2]);
    EXPECT_EQ(limits_between(experts, intermediates, {0, 1, 1}, k), k);
    EXPECT_EQ(limits_between({}, {}, {0}, {2.0}), std::vector<double>{2.0});
    EXPECT_TRUE(limits_between(experts, intermediates, {}, {}).empty());
}

TEST(OwnLimits, NarrowAnAbsoluteGateAndNeverWidenIt) {
    BenchmarkSet set = small_set();
    BenchmarkLevel force = set.levels[0];
    force.metric = "f_max";
    force.hand = "left";
    force.unit = "N";
    force.metric_version = find_metric("f_max")->version;
    force.mean = std::log(1.0);
    force.deviation = 0.2;
    force.k = 3;
    set.levels.push_back(force);
    const auto passes = [&](double newtons) {
        const std::vector<MetricResult> metrics = {figure("time", "", std::exp(4.0)),
                                                   figure("sparc", "right", -1.5),
                                                   figure("f_max", "left", newtons), figure("drop", "", 0)};
        return score_attempt(ScoreInput{small_task(), metrics, &set}).passed == true;
    };
    EXPECT_TRUE(passes(1.8));
    EXPECT_FALSE(passes(1.9));
    const JudgedLimit shown = judged_limits(small_task(), &set, {})[2];
    EXPECT_NEAR(shown.limit.value_or(0), std::exp(0.6), 1e-12) << "what a crash cannot take back";
    EXPECT_NE(shown.limit_source.find("synthetic operators"), std::string::npos);
    EXPECT_EQ(shown.task_limit, 4.0);
    EXPECT_TRUE(shown.of_set);
    EXPECT_FALSE(judged_limits(small_task(), &set, {})[0].task_limit) << "no limit of the task";
    EXPECT_FALSE(judged_limits(small_task(), nullptr, {})[2].of_set);
    const nlohmann::json json = benchmark_to_json(set);
    EXPECT_EQ(benchmark_to_json(parse_benchmark(json.dump(), "set.json")), json);
    set.levels.back().mean = std::log(3.9);
    EXPECT_TRUE(passes(3.99));
    EXPECT_FALSE(passes(4.01));
    EXPECT_THROW(
        parse_benchmark(json.patch(R"([{"op": "replace", "path": "/levels/2/k", "value": 4}])"_json).dump(),
                        "set.json"),
        InputError);
}

TEST(OwnLimits, OfASiteNarrowALimitThatItTookOver) {
    BenchmarkSet set = small_site_set();
    BenchmarkLevel force = set.levels[0];
    force.metric = "f_max";
    force.hand = "left";
    force.unit = "N";
    force.metric_version = find_metric("f_max")->version;
    force.mean = std::log(1.0);
    set.levels.push_back(force);
    const JudgedLimit narrowed = judged_limits(small_task(), &set, {})[2];
    EXPECT_NEAR(narrowed.limit.value_or(0), std::exp(0.4), 1e-12);
    EXPECT_FALSE(narrowed.provisional);
    EXPECT_EQ(narrowed.limit_source, "experts of this site, set 4, 8 experts");
    set.taken_over.clear();
    EXPECT_TRUE(judged_limits(small_task(), &set, {})[2].provisional) << "the task's limit is part of it";
}

/// Three attempts each of people whose ln time, sparc and ln force scatter around these.
std::vector<BenchmarkAttempt> people(const std::string& kind, int count, double time, double sparc,
                                     double force, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<BenchmarkAttempt> attempts;
    for (int p = 0; p < count; ++p)
        for (int a = 0; a < 3; ++a)
            attempts.push_back(
                {kind + std::to_string(p),
                 {figure("time", "", std::exp(time + 0.15 * normal(random))),
                  figure("sparc", "right", sparc + 0.06 * normal(random)),
                  figure("f_max", "left", std::exp(force + 0.2 * normal(random))), figure("drop", "", 0)},
                 AttemptState::completed,
                 {}});
    return attempts;
}

TEST(OwnLimits, OfTheBuilderTellIntermediatesFromExperts) {
    BenchmarkRequest request;
    request.source = "synthetic operators";
    request.experts = people("expert ", 24, 4.0, -1.5, -0.2, 1);
    const BenchmarkBuild without = build_benchmark(small_task(), request);
    ASSERT_TRUE(without.set) << without.refusal.words();

    // Few pass: the set is the same as without them.
    request.intermediates = people("intermediate ", 16, 4.28, -1.55, 0.4, 2);
    BenchmarkBuild with = build_benchmark(small_task(), request);
    ASSERT_TRUE(with.set) << with.refusal.words();
    EXPECT_TRUE(surely_within(with.set->intermediate_pass_share.value_or(1), 48));
    EXPECT_EQ(with.set->intermediates.size(), 16U);
    with.set->intermediates.clear();
    with.set->intermediate_pass_share.reset();
    EXPECT_EQ(benchmark_to_json(*with.set), benchmark_to_json(*without.set));

    // As quick and smooth as experts, but rough: their force tells them apart.
    request.intermediates = people("intermediate ", 16, 4.05, -1.52, 0.55, 3);
    const BenchmarkBuild rough = build_benchmark(small_task(), request);
    ASSERT_TRUE(rough.set) << rough.refusal.words();
    EXPECT_GT(rough.set->intermediate_pass_share.value_or(0), 0.05);
    EXPECT_LT(rough.set->intermediate_pass_share.value_or(1), 0.4);
    const BenchmarkLevel* force = rough.set->find("f_max", "left", "");
    ASSERT_NE(force, nullptr);
    EXPECT_TRUE(force->k);
    EXPECT_GE(rough.set->expert_pass_share, 0.8);
    EXPECT_LE(rough.set->expert_pass_share, 0.97) << "wide rather than narrow";
    const BenchmarkSet& set = *rough.set;
    EXPECT_EQ(benchmark_to_json(parse_benchmark(benchmark_to_json(set).dump(), "set.json")),
              benchmark_to_json(set));
    int fresh = 0;
    for (const BenchmarkAttempt& attempt : people("fresh ", 40, 4.05, -1.52, 0.55, 99))
        fresh += score_attempt(ScoreInput{small_task(), attempt.metrics, &set}).passed == true ? 1 : 0;
    EXPECT_GT(fresh, 0.05 * 120);
    EXPECT_LT(fresh, 0.4 * 120);
}

}  // namespace
}  // namespace fulcrum
