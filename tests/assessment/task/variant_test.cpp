// SPDX-License-Identifier: Apache-2.0
// Variants of a task: every task of the curriculum has three that fit its goals and have a set to be compared
// with; the one practised least comes next; wrong lists are refused; an expert completes each.
#include "assessment/task/variant.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "assessment/assets/assets.h"
#include "assessment/attempt/memory_sink.h"
#include "assessment/curriculum/curriculum.h"
#include "assessment/operators/operator.h"
#include "assessment/scoring/benchmark.h"
#include "assessment/scoring/score.h"
#include "assessment/task/task.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/scene/scene.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

TEST(Variants, EveryTaskOfTheCurriculumHasThreeThatFitItsGoals) {
    const Curriculum curriculum = load_curriculum(asset_path("curricula/rectal.json"), task_ids());
    for (const CurriculumTask& entry : curriculum.tasks) {
        const TaskDefinition task = load_task(task_file(entry.task));
        EXPECT_GE(task.variants.size(), 3U) << entry.task;
        EXPECT_LE(entry.variants, static_cast<int>(task.variants.size())) << entry.task;
        std::set<std::string> titles;
        for (const TaskVariant& variant : task.variants) {
            const Scene scene = load_scene(asset_path("scenes/" + variant.scene));
            EXPECT_EQ(scene.variant, variant.id) << variant.scene;
            EXPECT_TRUE(titles.insert(variant.title).second) << variant.title;
            for (const Goal& goal : task.goals) {
                const std::optional<GoalFault> fault = goal_fault(goal, scene);
                EXPECT_FALSE(fault.has_value()) << entry.task << " " << variant.id << ": "
                                                << (fault ? fault->problem.words() : std::string());
            }
            const BenchmarkKey key{task.id, variant.family, DeviceClass::haptic, "standard"};
            EXPECT_TRUE(std::filesystem::exists(asset_path("benchmarks/" + benchmark_name(key) + ".json")))
                << entry.task << " " << variant.id << " has no set";
        }
    }
}

TEST(Variants, TheOnePractisedLeastComesNext) {
    const TaskDefinition task = load_task(task_file("C4"));
    EXPECT_EQ(next_variant(task, {}), "standard");
    EXPECT_EQ(next_variant(task, {{"standard", 1}}), "narrow");
    EXPECT_EQ(next_variant(task, {{"standard", 1}, {"narrow", 1}}), "wide");
    EXPECT_EQ(next_variant(task, {{"standard", 2}, {"narrow", 1}, {"wide", 1}}), "narrow");
    EXPECT_EQ(next_variant(task, {{"standard", 3}, {"narrow", 3}, {"wide", 3}, {"other", 0}}), "standard");
    EXPECT_EQ(next_variant(TaskDefinition(), {}), "standard") << "a task that lists none";
}

TEST(Variants, FamilyOfAVariantThatIsGoneIsItself) {
    const TaskDefinition task = load_task(task_file("A2"));
    EXPECT_EQ(variant_family(task, "deep"), "standard");
    EXPECT_EQ(variant_family(task, "gone"), "gone");
    EXPECT_EQ(require_variant(task, "").id, "standard");
    try {
        require_variant(task, "gone");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "has no variant \"gone\"");
        EXPECT_EQ(error.hint(), "choose one of these: standard, deep, trocars_right");
    }
}

TEST(Variants, ListsThatCannotBeUsedAreRefusedWithThePlace) {
    const auto refusal = [](const nlohmann::json& variants) -> std::string {
        nlohmann::json document = nlohmann::json::parse(read_text_file(task_file("A2"), 1U << 20U));
        document["variants"] = variants;
        try {
            parse_task(document.dump(1), "A2.json");
            return "accepted";
        } catch (const InputError& error) {
            EXPECT_FALSE(error.hint().empty());
            const std::string place = error.place();  // "146 (/variants/0)"
            const std::size_t begin = place.find('(') + 1;
            return place.substr(begin, place.find(')') - begin);
        }
    };
    using nlohmann::json;
    const json standard = {{"id", "standard"}, {"title", "Standard"}, {"scene", "a2_targets.json"}};
    const json deep = {{"id", "deep"}, {"title", "Deep"}, {"scene", "a2_targets_deep.json"}};
    json of_itself = deep, of_nobody = deep,
         of_a_member = {{"id", "x"}, {"title", "X"}, {"scene", "x.json"}, {"family", "deep"}};
    of_itself["family"] = "deep";
    of_nobody["family"] = "other";
    json of_standard = deep;
    of_standard["family"] = "standard";
    EXPECT_EQ(refusal({standard, deep}), "accepted");
    EXPECT_EQ(refusal({standard, of_itself}), "accepted");
    EXPECT_EQ(refusal({deep, standard}), "/variants/0");
    EXPECT_EQ(refusal({standard, deep, deep}), "/variants/2");
    EXPECT_EQ(refusal({standard, of_nobody}), "/variants/1/family");
    EXPECT_EQ(refusal({standard, of_standard, of_a_member}), "/variants/2/family")
        << "a family has a set of its own";
    json elsewhere = deep;
    elsewhere["scene"] = "../secret.json";
    EXPECT_EQ(refusal({standard, elsewhere}), "/variants/1/scene");
}

/// Every variant of the tasks that take a few seconds of processor time; the standard ones are covered by
/// other tests.
TEST(VariantsOfShortTasks, AreCompletedByAnExpert) {
    for (const char* id : {"A1", "A2", "B2"}) {
        const TaskDefinition task = load_task(task_file(id));
        for (const TaskVariant& variant : task.variants) {
            if (variant.id == standard_variant) continue;
            const Scene scene = load_scene(asset_path("scenes/" + variant.scene));
            AttemptEngine engine(scene, task, 2001);
            const auto rig = make_operator(OperatorLevel::expert, task, scene, 2001);
            MemorySink sink;
            run_headless(engine, *rig, sink);
            EXPECT_EQ(attempt_state(sink.record.events), AttemptState::completed) << id << " " << variant.id;
        }
    }
}

}  // namespace
}  // namespace fulcrum
