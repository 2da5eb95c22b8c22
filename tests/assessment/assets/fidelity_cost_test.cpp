// SPDX-License-Identifier: Apache-2.0
#include "assessment/assets/fidelity_cost.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/world/physics_version.h"
#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

FidelityCosts some_costs(int physics) {
    FidelityCosts costs;
    costs.physics = physics;
    costs.tasks["B1"] = {"standard",
                         {{"fast", 41.5, "f_max", "left", -14.25, 3, 60}, {"fine", 190, "", "", 0, 0, 60}}};
    return costs;
}

/// An assets folder of its own while it lives.
class OwnAssets {
  public:
    OwnAssets() {
        std::filesystem::create_directories(folder_ / "tasks");
        setenv("FULCRUM_ASSETS", folder_.path().c_str(), 1);
    }
    ~OwnAssets() { unsetenv("FULCRUM_ASSETS"); }
    void put(const FidelityCosts& costs) const {
        std::ofstream(folder_ / "fidelity_cost.json") << fidelity_costs_to_json(costs).dump();
    }

  private:
    test::OwnFolder folder_;
};

TEST(FidelityCost, IsReadBackAsWritten) {
    const FidelityCosts read = parse_fidelity_costs(fidelity_costs_to_json(some_costs(3)).dump(), "f.json");
    EXPECT_EQ(read.physics, 3);
    const TaskFidelityCost& task = read.tasks.at("B1");
    EXPECT_EQ(task.cheapest, "standard");
    ASSERT_EQ(task.levels.size(), 2U);
    EXPECT_EQ(task.levels[0].fidelity, "fast");
    EXPECT_EQ(task.levels[0].processor_ms, 41.5);
    EXPECT_EQ(task.levels[0].metric, "f_max");
    EXPECT_EQ(task.levels[0].hand, "left");
    EXPECT_EQ(task.levels[0].shift_percent, -14.25);
    EXPECT_EQ(task.levels[0].verdicts, 3);
    EXPECT_EQ(task.levels[0].attempts, 60);
}

TEST(FidelityCost, RefusesAFileOfAnotherKind) {
    for (const char* text : {"", "[]", "{}", R"({"physics": 1})", R"({"physics": 0, "tasks": {}})",
                             R"({"physics": 1, "tasks": {"A2": {"cheapest": "fast", "levels": []}}})",
                             R"({"physics": 1, "tasks": {"A2": {"cheapest": "fast", "levels": [{}]}}})"})
        EXPECT_THROW(parse_fidelity_costs(text, "f.json"), InputError) << text;
}

TEST(FidelityCost, IsNotMeasuredForAnotherPhysicsVersionOrTask) {
    const OwnAssets assets;
    EXPECT_FALSE(fidelity_cost("B1")) << "no file";
    assets.put(some_costs(physics_version));
    ASSERT_TRUE(fidelity_cost("B1"));
    EXPECT_EQ(fidelity_cost("B1")->levels.size(), 2U);
    EXPECT_FALSE(fidelity_cost("A2"));
    assets.put(some_costs(physics_version + 1));
    EXPECT_FALSE(fidelity_cost("B1"));
}

TEST(FidelityCost, OfTheRepositoryIsOfThisPhysicsAndHasEveryTask) {
    const std::optional<FidelityCosts> costs = fidelity_costs();
    ASSERT_TRUE(costs.has_value()) << "measure again: fulcrum lab fidelity --data assets/fidelity_cost.json";
    for (const std::string& task : task_ids()) {
        ASSERT_EQ(costs->tasks.count(task), 1U) << task;
        for (const FidelityCost& level : costs->tasks.at(task).levels) {
            EXPECT_GE(level.attempts, 12) << task << " " << level.fidelity;
            EXPECT_LE(level.verdicts, level.attempts) << task << " " << level.fidelity;
            EXPECT_GT(level.processor_ms, 0) << task << " " << level.fidelity;
        }
    }
}

}  // namespace
}  // namespace fulcrum
