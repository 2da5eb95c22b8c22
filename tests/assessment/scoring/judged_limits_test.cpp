// SPDX-License-Identifier: Apache-2.0
// The limits of a task before an attempt are those that its score is made with.
#include "assessment/scoring/judged_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "assessment/scoring/score.h"
#include "assessment/scoring/taken_over.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

TEST(JudgedLimits, AreThoseOfTheScore) {
    for (const char* id : {"A1", "A2", "A3", "B1", "B2", "B3", "C4"}) {
        const TaskDefinition task = load_task(test::source_path(std::string("assets/tasks/") + id + ".json"));
        const BenchmarkSet set =
            load_benchmark(test::source_path(std::string("assets/benchmarks/") + id + ".json"));
        const std::vector<MetricResult> none;
        ScoreInput input{task, none};
        input.benchmark = &set;
        const Score score = score_attempt(input);
        const std::vector<JudgedLimit> limits = judged_limits(task, &set);
        ASSERT_EQ(limits.size(), task.gates.size()) << id;
        ASSERT_EQ(score.gates.size(), task.gates.size()) << id;
        for (std::size_t i = 0; i < limits.size(); ++i) {
            EXPECT_EQ(limits[i].limit, score.gates[i].limit) << id << ' ' << limits[i].metric;
            EXPECT_EQ(limits[i].limit_source, score.gates[i].limit_source);
            EXPECT_EQ(limits[i].provisional, score.gates[i].provisional);
            EXPECT_TRUE(limits[i].limit) << id << ' ' << limits[i].metric;
        }
    }
}

TEST(JudgedLimits, ExpertsRangeIsOneDeviationOnTheMetricsScale) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    const BenchmarkSet set = load_benchmark(test::source_path("assets/benchmarks/A2.json"));
    const std::vector<JudgedLimit> limits = judged_limits(task, &set);
    ASSERT_EQ(limits[0].metric, "time");
    const BenchmarkLevel& level = *set.find("time", "", "");
    ASSERT_EQ(level.scale, Scale::ln);
    EXPECT_NEAR(*limits[0].experts_low, std::exp(level.mean - level.deviation), 1e-9);
    EXPECT_NEAR(*limits[0].experts_high, std::exp(level.mean + level.deviation), 1e-9);
    EXPECT_LT(*limits[0].experts_high, *limits[0].limit) << "the limit is k deviations away";
    EXPECT_FALSE(limits[0].higher_is_better);
}

TEST(JudgedLimits, AreAllFirmWithASetOfTheSiteThatTookTheTasksLimitsOver) {
    for (const char* id : {"A1", "A2", "A3", "B1", "B2", "B3", "C4"}) {
        const TaskDefinition task = load_task(test::source_path(std::string("assets/tasks/") + id + ".json"));
        BenchmarkSet set =
            load_benchmark(test::source_path(std::string("assets/benchmarks/") + id + ".json"));
        const auto provisional = [&] {
            std::size_t count = 0;
            for (const JudgedLimit& limit : judged_limits(task, &set)) count += limit.provisional ? 1U : 0U;
            return count;
        };
        EXPECT_TRUE(set.taken_over.empty()) << id << " is delivered";
        EXPECT_TRUE(taken_over(task, set).by_site.empty());
        set.provisional = false;
        set.source = "experts of this site";
        const std::vector<ProvisionalLimit> limits = limits_to_take_over(task);
        EXPECT_EQ(provisional(), limits.size()) << id;
        EXPECT_EQ(taken_over(task, set).left.size(), limits.size());
        set.taken_over = limits;
        EXPECT_EQ(provisional(), 0U) << id;
        EXPECT_TRUE(taken_over(task, set).left.empty());
        EXPECT_EQ(taken_over(task, set).by_site.size(), limits.size());
        const BenchmarkSet back = parse_benchmark(benchmark_to_json(set).dump(), "set.json");
        EXPECT_TRUE(taken_over(task, back).left.empty()) << "a file keeps every digit of a limit";
    }
}

TEST(JudgedLimits, WithoutASetBenchmarkGatesSayWhyAndAbsoluteOnesKeepTheirLimit) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    const std::vector<JudgedLimit> limits = judged_limits(task, nullptr);
    for (const JudgedLimit& one : limits) {
        EXPECT_EQ(one.limit.has_value(), one.absent_because.empty()) << one.metric;
        EXPECT_FALSE(one.experts_low);
    }
    EXPECT_FALSE(limits[0].limit);
    EXPECT_EQ(limits[5].metric, "f_max");
    EXPECT_EQ(limits[5].limit, 4.0);
    TaskDefinition odd = task;
    odd.gates[0].metric = "no_such_metric";
    EXPECT_FALSE(judged_limits(odd, nullptr)[0].limit);
    EXPECT_FALSE(judged_limits(odd, nullptr)[0].absent_because.empty());
}

}  // namespace
}  // namespace fulcrum
