// SPDX-License-Identifier: Apache-2.0
// Benchmark sets: the file, the builder, the refusal of sets that experts would not pass.
#include "assessment/scoring/benchmark.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "assessment/learning/statistics.h"
#include "sim_core/numerics/input_error.h"
#include "tests/assessment/scoring/fixtures.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

using test::figures;
using test::small_set;
using test::small_task;

std::string complaint(const nlohmann::json& json) {
    try {
        parse_benchmark(json.dump(), "set.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(BenchmarkFile, SurvivesWritingAndReading) {
    BenchmarkSet set = small_set();
    set.levels[0].left_out = {"expert 3"};
    set.levels[1].absolute_limit = -1.9;
    set.levels[1].z_novice.reset();
    set.novices = {{"novice 1", 3, 3}};
    const nlohmann::json json = benchmark_to_json(set);
    const BenchmarkSet back = parse_benchmark(json.dump(1), "set.json");
    EXPECT_EQ(benchmark_to_json(back), json);
    EXPECT_EQ(back.levels[0].left_out, set.levels[0].left_out);
    EXPECT_NE(back.find("sparc", "right", ""), nullptr);
    EXPECT_EQ(back.find("sparc", "left", ""), nullptr);
}

TEST(BenchmarkFile, BrokenInManyWays) {
    const nlohmann::json good = benchmark_to_json(small_set());
    EXPECT_EQ(complaint(good), "");
    const std::vector<std::pair<const char*, nlohmann::json>> cases = {
        {"k missing", good.patch(R"([{"op": "remove", "path": "/k"}])"_json)},
        {"k too large", good.patch(R"([{"op": "replace", "path": "/k", "value": 4}])"_json)},
        {"text for a number",
         good.patch(R"([{"op": "replace", "path": "/levels/0/mean", "value": "4"}])"_json)},
        {"unknown metric",
         good.patch(R"([{"op": "replace", "path": "/levels/0/metric", "value": "speed"}])"_json)},
        {"other unit", good.patch(R"([{"op": "replace", "path": "/levels/0/unit", "value": "ms"}])"_json)},
        {"other version",
         good.patch(R"([{"op": "replace", "path": "/levels/0/metric_version", "value": 9}])"_json)},
        {"other scale", good.patch(R"([{"op": "replace", "path": "/levels/0/scale", "value": "raw"}])"_json)},
        {"no deviation",
         good.patch(R"([{"op": "replace", "path": "/levels/0/deviation", "value": 0}])"_json)},
        {"twice", good.patch(R"([{"op": "copy", "from": "/levels/0", "path": "/levels/1"}])"_json)},
        {"unknown key", good.patch(R"([{"op": "add", "path": "/levels/0/sd", "value": 1}])"_json)},
        {"few experts", good.patch(R"([{"op": "replace", "path": "/experts", "value": []}])"_json)},
        {"a number for what is text or nothing",
         good.patch(R"([{"op": "replace", "path": "/levels/0/tissue", "value": 7}])"_json)},
        {"text for what is a number or nothing",
         good.patch(R"([{"op": "replace", "path": "/levels/0/z_novice", "value": "3"}])"_json)},
        {"device class",
         good.patch(R"([{"op": "replace", "path": "/device_class", "value": "mouse"}])"_json)},
    };
    for (const auto& [name, json] : cases) {
        const std::string message = complaint(json);
        EXPECT_EQ(message.substr(0, 9), "set.json:") << name << ": " << message;
        EXPECT_NE(message.find("; "), std::string::npos) << message;
    }
    EXPECT_THROW(parse_benchmark("{", "set.json"), InputError);
    EXPECT_THROW(load_benchmark("no/such/set.json"), InputError);
}

TEST(ShippedTasks, CanBeGatedAndFitTheirSets) {
    int tasks = 0;
    for (const auto& file : std::filesystem::directory_iterator(test::source_path("assets/tasks"))) {
        const TaskDefinition task = load_task(file.path().string());
        EXPECT_NO_THROW(check_gates(task, file.path().string()));
        ++tasks;
        const std::string path = test::source_path("assets/benchmarks/" + task.id + ".json");
        if (!std::filesystem::exists(path)) continue;  // built by `fulcrum benchmark build`
        const BenchmarkSet set = load_benchmark(path);
        EXPECT_EQ(set.task, task.id);
        EXPECT_EQ(set.task_version, task.version);
        EXPECT_GE(set.expert_pass_share, 0.8) << path;
        EXPECT_LE(set.expert_pass_share, 0.96) << path;
        for (const GateSpec& gate : task.gates) {
            if (gate.kind != GateKind::benchmark) continue;
            EXPECT_NE(set.find(gate.metric, gate.hand, gate.tissue), nullptr)
                << task.id << " " << gate.metric;
        }
    }
    EXPECT_GE(tasks, 2);
}

/// Attempts of persons whose figures scatter around ln time `time`, sparc, force.
std::vector<BenchmarkAttempt> attempts_of(const std::string& kind, int people, double time, double sparc,
                                          unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<BenchmarkAttempt> attempts;
    for (int p = 0; p < people; ++p) {
        const double own_time = time + 0.1 * normal(random), own_sparc = sparc + 0.05 * normal(random);
        for (int a = 0; a < 3; ++a)
            attempts.push_back({kind + std::to_string(p),
                                figures(std::exp(own_time + 0.1 * normal(random)),
                                        own_sparc + 0.05 * normal(random), 1.0, 0),
                                AttemptState::completed,
                                {}});
    }
    return attempts;
}

BenchmarkRequest request_of(unsigned seed) {
    BenchmarkRequest request;
    request.source = "synthetic operators";
    request.experts = attempts_of("expert ", 8, 4.0, -1.5, seed);
    request.novices = attempts_of("novice ", 8, 5.0, -2.0, seed + 1);
    return request;
}

TEST(BenchmarkBuilder, MakesASetThatItsExpertsPass) {
    const TaskDefinition task = small_task();
    const BenchmarkRequest request = request_of(1);
    const BenchmarkBuild build = build_benchmark(task, request);
    ASSERT_TRUE(build.set) << build.refusal.words();
    const BenchmarkSet& set = *build.set;
    EXPECT_NEAR(set.expert_pass_share, 0.875, 0.05);
    EXPECT_GE(set.k, 1.0);
    EXPECT_LE(set.k, 3.0);
    EXPECT_EQ(set.experts.size(), 8U);
    EXPECT_EQ(set.experts[0].attempts, 3);
    ASSERT_EQ(set.levels.size(), 2U);
    EXPECT_EQ(set.levels[0].scale, Scale::ln);
    EXPECT_NEAR(set.levels[0].mean, 4.0, 0.15);
    EXPECT_GT(set.levels[0].z_novice.value_or(0), 3.0);
    EXPECT_GT(set.levels[1].z_novice.value_or(0), 3.0);
    // The experts pass it as a trainee would; the novices do not.
    int experts = 0, novices = 0;
    for (const BenchmarkAttempt& attempt : request.experts)
        experts += score_attempt(ScoreInput{task, attempt.metrics, &set}).passed == true ? 1 : 0;
    for (const BenchmarkAttempt& attempt : request.novices)
        novices += score_attempt(ScoreInput{task, attempt.metrics, &set}).passed == true ? 1 : 0;
    EXPECT_GE(experts, 20);
    EXPECT_LE(novices, 2);
    EXPECT_EQ(benchmark_to_json(parse_benchmark(benchmark_to_json(set).dump(), "set.json")),
              benchmark_to_json(set));
}

TEST(Benchmark, IsNamedAfterItsKey) {
    using D = DeviceClass;
    EXPECT_EQ(benchmark_name({"A2", "standard", D::haptic, "standard"}), "A2");
    EXPECT_EQ(benchmark_name({"A2", "standard", D::mouse_keyboard, "standard"}), "A2-mouse-keyboard");
    EXPECT_EQ(benchmark_name({"B1", "long_jaws", D::tracked, "fast"}), "B1-long_jaws-tracked-fast");
}

TEST(BenchmarkBuilder, NeverAsksForMoreThanPeopleCanRepeat) {
    BenchmarkRequest request = request_of(1);
    request.version = 7;
    for (std::size_t i = 0; i < request.experts.size(); ++i)
        request.experts[i].metrics[0].value = 60 + 0.1 * static_cast<double>(i % 3);  // 0.2 % apart
    const BenchmarkBuild build = build_benchmark(small_task(), request);
    ASSERT_TRUE(build.set) << build.refusal.words();
    EXPECT_EQ(build.set->version, 7);
    EXPECT_EQ(build.set->levels[0].deviation, find_metric("time")->least_deviation);
    EXPECT_GE(build.set->levels[0].deviation, 0.09);
    EXPECT_FALSE(build.set->levels[0].absolute_limit);
    for (const char* metric : {"time", "path_len", "f_max", "sparc"})
        EXPECT_GT(find_metric(metric)->least_deviation, 0) << metric;
}

TEST(BenchmarkBuilder, GivesBothHandsOneLimitWhereTheyDoTheSame) {
    TaskDefinition task = small_task();
    task.gates = {{"path_len", "left", "", GateKind::benchmark, 0, ""},
                  {"path_len", "right", "", GateKind::benchmark, 0, ""}};
    task.metrics = {"path_len"};
    BenchmarkRequest request;
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int p = 0; p < 8; ++p)
        for (int a = 0; a < 3; ++a)
            request.experts.push_back({"expert " + std::to_string(p),
                                       {test::figure("path_len", "left", 600 + 60 * normal(random)),
                                        test::figure("path_len", "right", 800 + 60 * normal(random))},
                                       AttemptState::completed,
                                       {}});
    const auto levels = [&] {
        const BenchmarkBuild build = build_benchmark(task, request);
        EXPECT_TRUE(build.set) << build.refusal.words();
        return build.set ? build.set->levels : std::vector<BenchmarkLevel>(2);
    };
    const std::vector<BenchmarkLevel> apart = levels();
    EXPECT_LT(apart[0].mean, apart[1].mean - 0.2);
    task.hands_alike = true;
    const std::vector<BenchmarkLevel> alike = levels();
    EXPECT_EQ(alike[0].mean, alike[1].mean);
    EXPECT_EQ(alike[0].deviation, alike[1].deviation);
    EXPECT_GT(alike[0].mean, apart[0].mean + 0.05);
    EXPECT_LT(alike[0].mean, apart[1].mean - 0.05);
    EXPECT_GT(alike[0].deviation, apart[0].deviation);
}

TEST(BenchmarkBuilder, TakesTheKWhoseExpertsPassNearestToTheMiddleOfTheBand) {
    const TaskDefinition task = small_task();
    bool below_two = false;
    for (unsigned seed = 1; seed < 40; ++seed) {
        const BenchmarkRequest request = request_of(seed);
        const BenchmarkBuild build = build_benchmark(task, request);
        ASSERT_TRUE(build.set) << build.refusal.words();
        ASSERT_EQ(build.trials.size(), 21U);  // 1.0 to 3.0
        double before = -1, least = 1;
        std::vector<double> nearest;
        for (const BenchmarkTrial& trial : build.trials) {
            EXPECT_GE(trial.pass_share, before);  // a wider gate never lets fewer pass
            before = trial.pass_share;
            least = std::min(least, std::abs(trial.pass_share - 0.875));
        }
        for (const BenchmarkTrial& trial : build.trials)
            if (std::abs(trial.pass_share - 0.875) < least + 1e-9) nearest.push_back(trial.k);
        EXPECT_NEAR(std::abs(build.set->expert_pass_share - 0.875), least, 1e-9);
        EXPECT_EQ(build.set->k, nearest[(nearest.size() - 1) / 2]);
        below_two = below_two || build.set->k < 2;
    }
    EXPECT_TRUE(below_two) << "limits that nearly every expert meets are narrowed";
}

TEST(BenchmarkBuilder, FreshExpertsPassAboutAsOftenAsTheSetSays) {
    const TaskDefinition task = small_task();
    int passed = 0, all = 0;
    for (unsigned seed = 1; seed < 200; seed += 7) {
        BenchmarkRequest request = request_of(seed);
        request.experts = attempts_of("expert ", 32, 4.0, -1.5, seed);
        const BenchmarkBuild build = build_benchmark(task, request);
        ASSERT_TRUE(build.set) << build.refusal.words();
        for (const BenchmarkAttempt& fresh : attempts_of("fresh ", 20, 4.0, -1.5, 5000 + seed)) {
            passed += score_attempt(ScoreInput{task, fresh.metrics, &*build.set}).passed == true ? 1 : 0;
            ++all;
        }
    }
    EXPECT_NEAR(static_cast<double>(passed) / all, 0.875, 0.02);
}

TEST(BenchmarkBuilder, RefusesWhatItsOwnExpertsFail) {
    BenchmarkRequest request = request_of(1);
    for (std::size_t i = 0; i < request.experts.size(); i += 4)
        request.experts[i].metrics[2].value = 5.0;  // above 4 N
    const BenchmarkBuild build = build_benchmark(small_task(), request);
    EXPECT_FALSE(build.set);
    EXPECT_EQ(build.trials.size(), 21U);  // 1.0 to 3.0
    EXPECT_NE(build.refusal.words().find("75.0 %"), std::string::npos) << build.refusal.words();
    bool named = false;
    for (const std::string& line : build.log)
        named = named || line.find("f_max left not met by 6") != std::string::npos;
    EXPECT_TRUE(named);
}

TEST(BenchmarkBuilder, RefusesTooFewExpertsOrAttempts) {
    BenchmarkRequest request = request_of(1);
    request.experts.resize(21);
    EXPECT_EQ(build_benchmark(small_task(), request).refusal.words(), "7 experts where 8 are needed");
    request = request_of(1);
    request.experts.pop_back();
    EXPECT_EQ(build_benchmark(small_task(), request).refusal.words(),
              "expert 7 has 2 counted attempts where 3 are needed");
    request = request_of(1);
    request.familiarisation = 2;
    EXPECT_FALSE(build_benchmark(small_task(), request).set);
    request.minimum_familiarisation = 0;  // operators do not learn
    EXPECT_TRUE(build_benchmark(small_task(), request).set);
    request = request_of(1);
    for (BenchmarkAttempt& attempt : request.experts)
        if (attempt.person > "expert 4")
            attempt.metrics[1] = test::missing("sparc", "right", Absence::not_done);
    EXPECT_NE(build_benchmark(small_task(), request).refusal.words().find("fewer than 6 experts"),
              std::string::npos);
}

TEST(BenchmarkBuilder, ASetOfPeopleTakesOverTheProvisionalLimitsOfItsTask) {
    BenchmarkRequest request = request_of(1);
    EXPECT_TRUE(build_benchmark(small_task(), request).set->taken_over.empty()) << "of synthetic operators";
    request.provisional = false;
    const BenchmarkBuild build = build_benchmark(small_task(), request);
    ASSERT_TRUE(build.set) << build.refusal.words();
    EXPECT_FALSE(build.set->provisional);
    ASSERT_EQ(build.set->taken_over.size(), 1U);
    const ProvisionalLimit& limit = build.set->taken_over[0];
    EXPECT_EQ(limit.metric, "f_max");
    EXPECT_EQ(limit.hand, "left");
    EXPECT_EQ(limit.metric_version, find_metric("f_max")->version);
    EXPECT_EQ(limit.limit, 4.0);
    EXPECT_FALSE(limit.exclusive);
    EXPECT_EQ(benchmark_to_json(parse_benchmark(benchmark_to_json(*build.set).dump(), "set.json")),
              benchmark_to_json(*build.set));
}

TEST(BenchmarkBuilder, ASetOfSimulatedAttemptsIsProvisionalWhateverIsAskedFor) {
    BenchmarkRequest request = request_of(1);
    request.provisional = false;
    for (BenchmarkAttempt& attempt : request.experts) attempt.simulated = true;
    const BenchmarkBuild build = build_benchmark(small_task(), request);
    ASSERT_TRUE(build.set) << build.refusal.words();
    EXPECT_TRUE(build.set->provisional);
    EXPECT_TRUE(build.set->taken_over.empty());
    for (BenchmarkAttempt& attempt : request.experts) attempt.simulated = attempt.person == "expert 7";
    const BenchmarkBuild mixed = build_benchmark(small_task(), request);
    EXPECT_FALSE(mixed.set);
    EXPECT_EQ(mixed.refusal.words(), "the attempts of expert 7 are simulated, those of expert 6 are not");
}

TEST(BenchmarkBuilder, LeavesOutAndLogsAnOutlier) {
    BenchmarkRequest request = request_of(1);
    for (BenchmarkAttempt& attempt : request.experts)
        if (attempt.person == "expert 5") attempt.metrics[0].value = std::exp(5.5);
    const BenchmarkBuild build = build_benchmark(small_task(), request);
    bool logged = false;
    for (const std::string& line : build.log) logged = logged || line.find("time: expert 5 left out") == 0;
    EXPECT_TRUE(logged);
}

TEST(BenchmarkBuilder, CountsAndSteadyFiguresBecomeAbsoluteGates) {
    TaskDefinition task = small_task();
    task.gates = {{"slip", "", "", GateKind::benchmark, 0, ""},
                  {"f_sd", "left", "", GateKind::benchmark, 0, ""}};
    task.metrics = {"slip", "f_sd"};
    BenchmarkRequest request;
    for (int p = 0; p < 8; ++p)
        for (int a = 0; a < 3; ++a)
            request.experts.push_back(
                {"expert " + std::to_string(p),
                 {test::figure("slip", "", (p + a) % 3), test::figure("f_sd", "left", 0.5 + 0.001 * a)},
                 AttemptState::completed,
                 {}});
    const BenchmarkBuild build = build_benchmark(task, request);
    ASSERT_TRUE(build.set) << build.refusal.words();
    EXPECT_EQ(build.set->levels[0].absolute_limit, 2.0);
    EXPECT_NEAR(build.set->levels[1].absolute_limit.value_or(0), 0.502, 1e-12);
    EXPECT_FALSE(build.set->levels[0].z_novice);
    EXPECT_EQ(build.set->k, 2.0);
    EXPECT_EQ(build.set->expert_pass_share, 1.0);
}

}  // namespace
}  // namespace fulcrum
