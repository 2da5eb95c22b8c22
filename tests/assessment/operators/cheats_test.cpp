// SPDX-License-Identifier: Apache-2.0
// Every way to cheat at every task: none passes, and the expert who does not cheat does.
//
// FULCRUM_CHEATS_SEED: the seed of the scenes and of the cheats' noise, instead of the standard one.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>

#include "tests/assessment/attempt/expert_record.h"
#include "tests/assessment/operators/cheat_runner.h"

namespace fulcrum {
namespace {

std::uint64_t seed_of_cheats() {
    const char* asked = std::getenv("FULCRUM_CHEATS_SEED");
    return asked != nullptr ? std::stoull(asked) : test::expert_seed;
}

constexpr const char* tasks[] = {"A1", "A2", "A3", "B1", "B2", "B3", "C4"};

struct Case {
    std::string task;
    const Cheat* cheat = nullptr;
};

std::vector<Case> cases() {
    std::vector<Case> list;
    for (const char* task : tasks) {
        // Not a CheatStage: the list is made whenever this program starts, and a benchmark set that is out of
        // date would then end all of its tests.
        const TaskDefinition definition =
            load_task(test::source_path("assets/tasks/" + std::string(task) + ".json"));
        const Scene scene = load_scene(test::source_path("assets/scenes/" + definition.scene));
        for (const Cheat* cheat : cheats_for(definition, scene)) list.push_back({task, cheat});
    }
    return list;
}

TEST(Cheats, AreTwentyOrMoreAtEveryTask) {
    std::set<std::string> names;
    for (const Cheat& cheat : cheats()) EXPECT_TRUE(names.insert(cheat.name).second) << cheat.name;
    for (const char* task : tasks) {
        const test::CheatStage stage(task);
        EXPECT_GE(cheats_for(stage.task, stage.scene).size(), 20U) << task;
    }
}

class CheatsAt : public ::testing::TestWithParam<Case> {};

TEST_P(CheatsAt, NonePasses) {
    const test::CheatStage stage(GetParam().task);
    const std::uint64_t seed = seed_of_cheats();
    const std::unique_ptr<ObservingRig> rig = make_cheat(*GetParam().cheat, stage.task, stage.scene, seed);
    // One who does nothing is followed to the end of the time limit once.
    const bool whole = GetParam().task == "A2" && GetParam().cheat->name == std::string("nothing");
    const test::CheatVerdict verdict = test::judge(stage, *rig, seed, whole);
    EXPECT_NE(verdict.score.passed, true)
        << verdict.seconds << " s, " << row_of(attempt_states, verdict.state).name << ": " << verdict.why();
    EXPECT_LT(verdict.score.points.value_or(0), pass_mark);
}

std::string case_name(const ::testing::TestParamInfo<Case>& one) {
    return one.param.task + "_" + one.param.cheat->name;
}
INSTANTIATE_TEST_SUITE_P(Tasks, CheatsAt, ::testing::ValuesIn(cases()), case_name);

class Honest : public ::testing::TestWithParam<const char*> {};

TEST_P(Honest, TheSameExpertPassesWithoutCheating) {
    const test::CheatStage stage(GetParam());
    const test::ExpertRecord& expert = test::expert_record(GetParam());
    test::CheatVerdict verdict;
    verdict.score = test::score_so_far(stage, expert.record, expert.targets);
    EXPECT_EQ(verdict.score.passed, true) << verdict.why();
    EXPECT_GE(verdict.score.points.value_or(0), pass_mark);
}
INSTANTIATE_TEST_SUITE_P(Tasks, Honest, ::testing::ValuesIn(tasks),
                         [](const auto& task) { return std::string(task.param); });

}  // namespace
}  // namespace fulcrum
