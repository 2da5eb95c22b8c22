// SPDX-License-Identifier: Apache-2.0
// The shipped curriculum is valid; wrong ones are refused with the place and what to do.
#include "assessment/curriculum/curriculum.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "assessment/learning/relapse_cusum.h"
#include "assessment/task/task.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

nlohmann::json shipped() {
    return nlohmann::json::parse(read_text_file(asset_path("curricula/rectal.json"), 1U << 20U));
}

/// The refusal of a curriculum; empty where it is accepted.
std::string refusal(const nlohmann::json& document) {
    try {
        parse_curriculum(document.dump(1), "test.json", task_ids());
        return {};
    } catch (const InputError& error) {
        EXPECT_FALSE(error.hint().empty());
        return error.place() + ": " + error.problem();
    }
}

TEST(Curriculum, ShippedOneHasInstalledTasksInTheirStagesAndForTheirDevices) {
    const Curriculum curriculum = load_curriculum(asset_path("curricula/rectal.json"), task_ids());
    EXPECT_EQ(curriculum.name(), "rectal@3");
    EXPECT_EQ(curriculum.find("C4")->variants, 2);
    EXPECT_EQ(curriculum.find("A2")->variants, 1) << "where it says nothing";
    for (const CurriculumTask& task : curriculum.tasks) {
        const TaskDefinition definition = load_task(task_file(task.task));
        EXPECT_EQ(definition.stage, task.stage) << task.task;
        for (const DeviceClass one : task.device_classes)
            EXPECT_TRUE(can_be_assessed(definition, one))
                << task.task << " " << row_of(device_classes, one).name;
    }
    EXPECT_TRUE(counts(*curriculum.find("B1"), DeviceClass::synthetic));
    EXPECT_FALSE(counts(*curriculum.find("B1"), DeviceClass::mouse_keyboard));
    EXPECT_FALSE(counts(*curriculum.find("B1"), DeviceClass::external));
}

TEST(Curriculum, EarlierVersionsStayInstalledAndNoneIsThereTwice) {
    const Curriculum newest = load_versions(asset_path("curricula"), "rectal", task_ids());
    EXPECT_EQ(newest.name(), "rectal@3");
    ASSERT_EQ(newest.older.size(), 2U);
    EXPECT_EQ(newest.version_named("rectal@1"), &newest.older[1]);
    EXPECT_EQ(newest.version_named("rectal@1")->find("C4")->variants, 1);
    EXPECT_EQ(newest.version_named("rectal@2"), &newest.older[0]);
    EXPECT_TRUE(newest.version_named("rectal@2")->find("C4")->remedies.empty());
    EXPECT_EQ(newest.version_named("rectal@3"), &newest);
    EXPECT_EQ(newest.version_named("rectal@4"), nullptr);
    EXPECT_EQ(newest.older[1].file, "rectal-1.json");
    EXPECT_FALSE(newest.text.empty());

    const test::OwnFolder folder;
    for (const char* name : {"one.json", "two.json"})
        std::filesystem::copy_file(asset_path("curricula/rectal.json"), folder / name);
    try {
        load_versions(folder.path().string(), "rectal", task_ids());
        FAIL() << "two files with one version";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("has the same version"), std::string::npos) << error.what();
    }
    EXPECT_THROW(load_versions(asset_path("curricula"), "other", task_ids()), InputError);
}

TEST(Curriculum, RefusesWhatCannotBeFollowed) {
    EXPECT_EQ(refusal(shipped()), "");
    auto broken = [](const char* pointer, const nlohmann::json& value) {
        nlohmann::json document = shipped();
        document[nlohmann::json::json_pointer(pointer)] = value;
        return refusal(document);
    };
    EXPECT_EQ(broken("/tasks/3/after", {"B2"}), "");
    nlohmann::json cycle = shipped();
    cycle["tasks"][3]["after"] = {"B2"};
    cycle["tasks"][4]["after"] = {"B3"};
    cycle["tasks"][5]["after"] = {"B1"};
    EXPECT_NE(refusal(cycle).find("would unlock only after itself"), std::string::npos);
    EXPECT_NE(broken("/tasks/1/after", {"A2"}).find("only after itself"), std::string::npos);
    EXPECT_NE(broken("/tasks/0/after", {"C4"}).find("later stage"), std::string::npos);
    EXPECT_NE(broken("/tasks/0/after", {"X9"}).find("not a task of this curriculum"), std::string::npos);
    EXPECT_NE(broken("/tasks/0/task", "X9").find("no task X9 is installed"), std::string::npos);
    EXPECT_NE(broken("/tasks/0/task", "B1").find("listed twice"), std::string::npos);
    EXPECT_NE(broken("/tasks/0/stage", "Z").find("no stage Z"), std::string::npos);
    EXPECT_NE(broken("/stages/1/id", "A").find("listed twice"), std::string::npos);
    for (const char* rule :
         {"row:0", "row:61", "of:5,4", "of:4", "lc-cusum:0.3,0.1,2.5", "lc-cusum:0.1,0.3",
          "lc-cusum:0.1,0.3,0", "best:3", "row:two", "row:", "row:1.5", "lc-cusum:0.1,0.3,nan"})
        EXPECT_NE(broken("/tasks/0/rule", rule), "") << rule;
    EXPECT_NE(broken("/tasks/0/device_classes", {"telepathy"}), "");
    EXPECT_NE(broken("/version", 0), "");
}

TEST(PassRule, IsReadFromItsText) {
    const PassRule row = parse_pass_rule("row:3");
    EXPECT_EQ(row.kind, PassRuleKind::in_a_row);
    EXPECT_EQ(row.k, 3);
    const PassRule of = parse_pass_rule("of:4,5");
    EXPECT_EQ(of.kind, PassRuleKind::k_of_n);
    EXPECT_EQ(of.k, 4);
    EXPECT_EQ(of.n, 5);
    const PassRule cusum = parse_pass_rule("lc-cusum:0.1,0.3,2.5");
    EXPECT_NEAR(lc_cusum_step(cusum, true), 0.251314, 1e-6);
    EXPECT_NEAR(lc_cusum_step(cusum, false), -1.098612, 1e-6);
}

TEST(RelapseCusum, LimitIsTheSmallestHundredthThatAlarmsFewEnough) {
    EXPECT_EQ(relapse_limit, 3.05);
    // By following every sequence of 20 attempts, apart from the program.
    EXPECT_NEAR(relapse_alarm(0.1, 3.05, 20), 0.048853, 1e-6);
    EXPECT_NEAR(relapse_alarm(0.1, 3.04, 20), 0.060712, 1e-6);
    EXPECT_LE(relapse_alarm(relapse_p0, relapse_limit, relapse_attempts), relapse_false_alarms);
    EXPECT_GT(relapse_alarm(relapse_p0, relapse_limit - 0.01, relapse_attempts), relapse_false_alarms);
}

TEST(RelapseCusum, ThreeFailuresInARowAlarmAndStartAgain) {
    RelapseCusum cusum;
    EXPECT_FALSE(cusum.step(true));
    EXPECT_EQ(cusum.sum(), 0);
    EXPECT_FALSE(cusum.step(false));
    EXPECT_NEAR(cusum.sum(), 1.098612, 1e-6);
    EXPECT_FALSE(cusum.step(false));
    EXPECT_TRUE(cusum.step(false));
    EXPECT_EQ(cusum.sum(), 0);
}

}  // namespace
}  // namespace fulcrum
