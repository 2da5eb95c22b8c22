// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/task.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "assessment/scoring/score.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/scene/scene.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

std::string task_text(const std::string& name) {
    return read_text_file(test::source_path("assets/tasks/" + name), 1U << 20U);
}

TEST(Task, EveryTaskFitsItsScene) {
    for (const std::string& id : test::task_ids()) {
        const TaskDefinition task = load_task(test::source_path("assets/tasks/" + id + ".json"));
        EXPECT_EQ(task.id, id);
        EXPECT_NO_THROW(check_gates(task, id));
        const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
        for (const GateSpec& gate : task.gates) {
            EXPECT_TRUE(gate.tissue.empty() || scene.tissue_index(gate.tissue) >= 0) << gate.tissue;
            EXPECT_NE(gate.kind == GateKind::absolute, gate.limit_source.empty()) << gate.metric;
            EXPECT_TRUE(gate.kind == GateKind::absolute || !gate.provisional) << gate.metric;
        }
        for (const Goal& goal : task.goals) {
            const std::optional<GoalFault> fault = goal_fault(goal, scene);
            EXPECT_FALSE(fault.has_value()) << id << ": " << (fault ? fault->problem.words() : std::string());
        }
    }
}

TEST(Task, BowelHandlingAgreesWithTheCurriculum) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/B1.json"));
    ASSERT_EQ(task.goals.size(), 2U);
    EXPECT_EQ(task.goals[0].kind, GoalKind::run_bowel);
    EXPECT_NEAR(task.goals[0].length_m, 0.6, 1e-12);
    EXPECT_EQ(task.goals[1].kind, GoalKind::lift_and_hold);
    EXPECT_NEAR(task.goals[1].hold_s, 30, 1e-12);
    const auto gate = [&](const std::string& metric) {
        return std::find_if(task.gates.begin(), task.gates.end(),
                            [&](const GateSpec& g) { return g.metric == metric; });
    };
    ASSERT_NE(gate("grasp_ftp"), task.gates.end());
    EXPECT_NEAR(gate("grasp_ftp")->limit, 300, 1e-12);
    ASSERT_NE(gate("perforation"), task.gates.end());
    EXPECT_NEAR(gate("perforation")->limit, 0, 1e-12);
}

TEST(Task, PlaneCuttingAgreesWithTheCurriculum) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/B2.json"));
    ASSERT_EQ(task.goals.size(), 3U);
    EXPECT_EQ(task.goals[0].kind, GoalKind::take_tension);
    EXPECT_EQ(task.goals[1].kind, GoalKind::divide_line);
    EXPECT_NEAR(task.goals[1].length_m, 0.1, 1e-12);
    EXPECT_EQ(task.goals[1].traction_low_n_m, task.goals[0].traction_low_n_m);
    EXPECT_EQ(task.goals[1].traction_high_n_m, task.goals[0].traction_high_n_m);
    EXPECT_EQ(task.goals[2].kind, GoalKind::let_go);
    for (const char* metric : {"traction_eff", "plane_dev", "cut_dev"})
        EXPECT_TRUE(std::any_of(task.gates.begin(), task.gates.end(), [&](const GateSpec& gate) {
            return gate.metric == metric;
        })) << metric;
}

// The text about the limit has no effect.
TEST(Task, ALimitIsProvisionalWhereTheTaskSaysSo) {
    const std::string source = "\"limit_source\": \"";
    std::string text = task_text("A2.json");
    EXPECT_TRUE(parse_task(text, "A2.json").gates.back().provisional);
    for (std::size_t at = text.find(source); at != std::string::npos; at = text.find(source, at + 40))
        text.insert(at + source.size(), "nothing provisional: ");
    for (std::size_t at; (at = text.find("\"provisional\": true")) != std::string::npos;)
        text.replace(at, 19, "\"provisional\": false");
    EXPECT_FALSE(parse_task(text, "A2.json").gates.back().provisional);
}

TEST(Task, EveryGoalTypeNamesKeysOfTheSchema) {
    const std::string schema =
        read_text_file(test::source_path("assets/schemas/task.schema.json"), 1U << 20U);
    for (const GoalType& type : goal_types) {
        for (const GoalKey& key : type.keys) {
            if (key.name == nullptr) continue;
            const std::string property = std::string("\"") + key.name + "\": {";
            EXPECT_NE(schema.find(property), std::string::npos) << type.name << " " << key.name;
        }
    }
}

struct BrokenTask {
    const char* name;
    const char* what;
    const char* with;
    const char* wrong;
    const char* hint;
};

class BrokenTaskFile : public testing::TestWithParam<BrokenTask> {};

TEST_P(BrokenTaskFile, NamesFilePlaceAndHint) {
    const BrokenTask& broken = GetParam();
    std::string text = task_text("B1.json");
    const std::size_t at = text.find(broken.what);
    ASSERT_NE(at, std::string::npos) << "the asset no longer holds " << broken.what;
    text.replace(at, std::string(broken.what).size(), broken.with);
    try {
        parse_task(text, "broken.json");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.file(), "broken.json");
        EXPECT_GT(std::atoi(error.place().c_str()), 0) << "a line: " << error.what();
        EXPECT_NE(error.problem().find(broken.wrong), std::string::npos) << error.what();
        EXPECT_NE(error.hint().find(broken.hint), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(
    Tasks, BrokenTaskFile,
    testing::Values(
        BrokenTask{"not_json", "\"id\": \"B1\",", "\"id\": B1,", "not valid JSON", "correct the text"},
        BrokenTask{"typo", "\"time_limit_s\"", "\"time_limit\"", "unknown key \"time_limit\"",
                   "did you mean \"time_limit_s\"?"},
        BrokenTask{"no_time_limit", "\"time_limit_s\": 600,", "", "the key \"time_limit_s\" is missing",
                   "add it"},
        BrokenTask{"goal_kind", "\"kind\": \"run_bowel\"", "\"kind\": \"run\"", "unknown name \"run\"",
                   "run_bowel"},
        BrokenTask{"device_class", "\"haptic\"", "\"joystick\"", "not one of those allowed", "haptic"},
        BrokenTask{"goal_needs_height", "\"height_m\": 0.03,", "", "needs \"height_m\"",
                   "above the resting height"},
        BrokenTask{"run_too_long", "\"length_m\": 0.6", "\"length_m\": 0.7", "between from_m and to_m",
                   "ask for less"},
        BrokenTask{"steps_reversed", "\"minimum_step_m\": 0.02", "\"minimum_step_m\": 0.2",
                   "not below maximum_step_m", "shortest"},
        BrokenTask{"gate_not_shown", "{\"metric\": \"time\", \"kind\"", "{\"metric\": \"tme\", \"kind\"",
                   "\"tme\" is not among", "correct its id"},
        BrokenTask{"gate_without_source", "\"limit\": 300,", "", "without limit and limit_source",
                   "add both"},
        BrokenTask{"benchmark_with_limit", "{\"metric\": \"time\", \"kind\": \"benchmark\"}",
                   "{\"metric\": \"time\", \"kind\": \"benchmark\", \"limit\": 60}", "a limit of its own",
                   "benchmark set gives it"},
        BrokenTask{"scene_path", "\"scene\": \"b1_bowel.json\"", "\"scene\": \"../b1_bowel.json\"",
                   "not the name of a scene file", "assets/scenes"},
        BrokenTask{"step_not_text", "\"Then grasp the middle", "7, \"Then grasp the middle", "type",
                   "a text"}),
    [](const testing::TestParamInfo<BrokenTask>& broken) { return std::string(broken.param.name); });

}  // namespace
}  // namespace fulcrum
