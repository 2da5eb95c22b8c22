// SPDX-License-Identifier: Apache-2.0
// Every way to cheat at every task: none passes, and the expert who does not cheat does.
//
// FULCRUM_CHEATS_SEED: the seed of the scenes and of the cheats' noise, instead of the standard one.
// FULCRUM_CHEATS_WHOLE: 1 follows each attempt to its end, also where it can no longer pass.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <sstream>
#include <string>

#include "tests/assessment/attempt/expert_record.h"
#include "tests/assessment/operators/cheat_runner.h"

namespace fulcrum {
namespace {

std::uint64_t seed_of_cheats() {
    const char* asked = std::getenv("FULCRUM_CHEATS_SEED");
    return asked != nullptr ? std::stoull(asked) : test::expert_seed;
}

bool all_whole() {
    const char* asked = std::getenv("FULCRUM_CHEATS_WHOLE");
    return asked != nullptr && std::string(asked) == "1";
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

/// An attempt that was left early has failed for good, or has lost its device, by the product's own score.
void expect_beyond_passing(const test::CheatVerdict& verdict) {
    EXPECT_EQ(test::broken_for_good(verdict.at_best), verdict.decided_by);
    if (verdict.lost_device && verdict.at_best.passed != false) {
        EXPECT_EQ(verdict.at_best.not_scored_because.id(), StatementId::device_was_lost);
    } else {
        EXPECT_EQ(verdict.at_best.passed, false) << verdict.decided_by;
    }
}

TEST_P(CheatsAt, NonePasses) {
    const test::CheatStage stage(GetParam().task);
    const std::uint64_t seed = seed_of_cheats();
    const std::unique_ptr<CheatingRig> rig = make_cheat(*GetParam().cheat, stage.task, stage.scene, seed);
    // One who does nothing is followed to the end of the time limit once.
    const bool whole =
        all_whole() || (GetParam().task == "A2" && GetParam().cheat->name == std::string("nothing"));
    const test::CheatVerdict verdict = test::judge(stage, *rig, seed, whole);
    RecordProperty("simulated_s", std::to_string(verdict.seconds));
    RecordProperty("decided_by", verdict.decided_by);
    EXPECT_NE(verdict.score.passed, true)
        << verdict.seconds << " s, " << row_of(attempt_states, verdict.state).name << ": " << verdict.why();
    EXPECT_LT(verdict.score.points.value_or(0), pass_mark);
    EXPECT_TRUE(rig->has_cheated());
    if (verdict.early) expect_beyond_passing(verdict);
}

TEST(Cheats, WhatEndsAnAttemptEarlyHoldsOfTheWholeOne) {
    const test::CheatStage stage("A1");
    for (const Cheat& cheat : cheats()) {
        const std::string name = cheat.name;
        if (name != "rush" && name != "unplug_and_move") continue;
        SCOPED_TRACE(name);
        const auto verdict = [&](bool whole) {
            const auto rig = make_cheat(cheat, stage.task, stage.scene, test::expert_seed);
            return test::judge(stage, *rig, test::expert_seed, whole);
        };
        const test::CheatVerdict early = verdict(false), whole = verdict(true);
        EXPECT_LT(early.seconds, whole.seconds);
        EXPECT_TRUE(early.early);
        EXPECT_FALSE(whole.early);
        EXPECT_EQ(early.lost_device, name == "unplug_and_move");
        EXPECT_EQ(whole.lost_device, early.lost_device);
        EXPECT_NE(whole.score.passed, true);
        std::istringstream reasons(early.decided_by);
        for (std::string reason; reasons >> reason;)
            EXPECT_NE(whole.why().find(reason), std::string::npos) << reason;
    }
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

TEST_P(Honest, TheSameExpertIsNeverBeyondPassing) {
    const test::CheatStage stage(GetParam());
    const test::ExpertRecord& expert = test::expert_record(GetParam());
    for (const double share : {0.1, 0.5, 0.8, 0.99}) {
        std::vector<TickSample> samples = expert.record.samples;
        samples.resize(static_cast<std::size_t>(share * static_cast<double>(samples.size())));
        const std::uint32_t now = samples.back().tick;
        std::vector<Event> events;
        int goal = 0;
        for (const Event& event : expert.record.events) {
            if (event.tick > now) break;
            events.push_back(event);
            if (event.kind == EventKind::phase_begin) goal = event.detail;
        }
        const std::vector<Event> completed = test::completed_after(
            events, now, test::holds_after(stage.task, goal), stage.scene.tick_period());
        const Score score = test::score_by(stage, stage.lasting, samples, completed, expert.targets);
        EXPECT_EQ(test::broken_for_good(score), "") << share;
    }
}

INSTANTIATE_TEST_SUITE_P(Tasks, Honest, ::testing::ValuesIn(tasks),
                         [](const auto& task) { return std::string(task.param); });

}  // namespace
}  // namespace fulcrum
