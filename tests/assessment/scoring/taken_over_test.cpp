// SPDX-License-Identifier: Apache-2.0
// Limits of a task that a site's set takes over: in words, in the set's file, and what is refused there.
#include "assessment/scoring/taken_over.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sim_core/numerics/input_error.h"
#include "tests/assessment/scoring/fixtures.h"

namespace fulcrum {
namespace {

using test::small_site_set;
using test::small_task;

TEST(TakenOverLimits, AreNamedWithTheirValues) {
    TaskDefinition task = small_task();
    task.gates.push_back({"energy_safe", "", "", GateKind::absolute, 80, "training limit", true});
    task.gates.push_back({"lens_contact", "", "", GateKind::absolute, 2, "training limit", true, true});
    EXPECT_EQ(provisional_words(limits_to_take_over(task)),
              "f_max left at most 4.0 N; energy_safe at least 80.0 %; lens_contact less than 2.0");
    EXPECT_EQ(provisional_words(std::vector<ProvisionalLimit>()), "");
    task.gates.push_back({"no_such_metric", "", "", GateKind::absolute, 2, "training limit", true});
    EXPECT_EQ(limits_to_take_over(task).size(), 3U);
}

TEST(TakenOverLimits, ThatTheTaskHasChangedAreNamedWithWhatTheyWere) {
    const BenchmarkSet set = small_site_set();
    TaskDefinition newer = small_task();
    newer.gates[2].limit = 3.0;
    newer.gates.push_back({"f_max", "right", "", GateKind::absolute, 4, "training limit", true});
    const TakenOver limits = taken_over(newer, set);
    EXPECT_TRUE(limits.by_site.empty());
    ASSERT_EQ(limits.left.size(), 2U);
    EXPECT_EQ(limits.left[0].now.limit, 3.0);
    ASSERT_TRUE(limits.left[0].taken_over);
    EXPECT_EQ(limits.left[0].taken_over->limit, 4.0);
    EXPECT_EQ(limits.left[1].now.hand, "right");
    EXPECT_FALSE(limits.left[1].taken_over) << "the set knows nothing of it";
    newer.gates.erase(newer.gates.begin() + 2);
    EXPECT_EQ(taken_over(newer, set).left.size(), 1U) << "a gate that is gone is no limit";
}

/// What is wrong with a set's file; empty: nothing.
std::string set_fault(const nlohmann::json& file) {
    try {
        parse_benchmark(file.dump(), "set.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(TakenOverLimits, SurviveWritingAndReading) {
    BenchmarkSet set = small_site_set();
    set.taken_over[0].limit = 0.1 + 0.2;
    set.taken_over.push_back(set.taken_over[0]);
    set.taken_over[1].hand = "right";
    set.taken_over[1].tissue = "bowel";
    set.taken_over[1].exclusive = true;
    set.taken_over[1].metric_version += 7;  // of a newer program: without effect, and no reason to refuse
    const nlohmann::json file = benchmark_to_json(set);
    EXPECT_EQ(set_fault(file), "");
    const BenchmarkSet back = parse_benchmark(file.dump(2), "set.json");
    EXPECT_EQ(benchmark_to_json(back), file);
    ASSERT_EQ(back.taken_over.size(), 2U);
    EXPECT_EQ(back.taken_over[0].limit, set.taken_over[0].limit);
    EXPECT_TRUE(back.taken_over[1].exclusive);
    set.taken_over.clear();
    EXPECT_FALSE(benchmark_to_json(set).contains("taken_over")) << "older programs read it";
}

TEST(TakenOverLimits, ThatFitNoMetricAreRefusedWithTheirPlace) {
    const nlohmann::json good = benchmark_to_json(small_site_set());
    ASSERT_EQ(set_fault(good), "");
    const auto changed = [&](const char* key, const nlohmann::json& value) {
        nlohmann::json file = good;
        file["taken_over"][0][key] = value;
        return file;
    };
    nlohmann::json of_both = changed("metric", "time"), in_tissue = of_both, twice = good, lacking = good,
                   provisional = good;
    in_tissue["taken_over"][0]["hand"] = nullptr;
    in_tissue["taken_over"][0]["tissue"] = "bowel";
    twice["taken_over"].push_back(good["taken_over"][0]);
    lacking["taken_over"][0].erase("limit");
    provisional["provisional"] = true;
    const std::vector<std::pair<nlohmann::json, std::string>> cases = {
        {changed("metric", "speed"), "(/taken_over/0/metric): unknown metric 'speed'"},
        {changed("hand", nullptr), "(/taken_over/0/hand): 'f_max' is measured for each hand"},
        {changed("hand", "both"), "/taken_over/0/hand"},
        {of_both, "(/taken_over/0/hand): 'time' belongs to no single hand"},
        {in_tissue, "(/taken_over/0/tissue): 'time' has no rows by tissue"},
        {changed("limit", "4"), "/taken_over/0/limit"},
        {changed("unit", "N"), "/taken_over/0"},
        {twice, "(/taken_over/1): the limit of 'f_max' is taken over twice"},
        {lacking, "/taken_over/0"},
        {provisional, "(/taken_over): a provisional set takes over no limits of its task"},
    };
    for (const auto& [file, fault] : cases) {
        const std::string message = set_fault(file);
        EXPECT_NE(message.find(fault), std::string::npos) << message;
        EXPECT_EQ(message.substr(0, 9), "set.json:") << message;
        EXPECT_NE(message.find("; "), std::string::npos) << message << " has no hint";
    }
}

}  // namespace
}  // namespace fulcrum
