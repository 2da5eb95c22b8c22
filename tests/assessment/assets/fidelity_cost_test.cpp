// SPDX-License-Identifier: Apache-2.0
#include "assessment/assets/fidelity_cost.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/world/physics_version.h"
#include "tests/support/own_folder.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

FidelityCosts some_costs(int physics) {
    FidelityCosts costs;
    costs.tasks["B1"] = {"standard",
                         {{"fast", 41.5, "f_max", "left", -14.25, 3, 60}, {"fine", 190, "", "", 0, 0, 60}},
                         "abc",
                         physics,
                         "B1-provisional@4",
                         {{"f_max", 2}, {"time", 1}}};
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
    const TaskFidelityCost& task = read.tasks.at("B1");
    EXPECT_EQ(task.commit, "abc");
    EXPECT_EQ(task.physics, 3);
    EXPECT_EQ(task.limits, "B1-provisional@4");
    EXPECT_EQ(task.metrics, (std::map<std::string, int>{{"f_max", 2}, {"time", 1}}));
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
    for (const char* text : {"", "[]", "{}", R"({"physics": 1, "tasks": {}})",
                             R"({"tasks": {"A2": {"cheapest": "fast", "levels": []}}})",
                             R"({"tasks": {"A2": {"cheapest": "fast", "levels": [{}]}}})"})
        EXPECT_THROW(parse_fidelity_costs(text, "f.json"), InputError) << text;
    for (const char* key : {"commit", "physics", "limits", "metrics"}) {
        nlohmann::json document = fidelity_costs_to_json(some_costs(3));
        document["tasks"]["B1"].erase(key);
        EXPECT_THROW(parse_fidelity_costs(document.dump(), "f.json"), InputError) << key;
    }
}

TEST(FidelityCost, IsReadWithWhatItWasMeasuredWith) {
    const OwnAssets assets;
    EXPECT_FALSE(fidelity_cost("B1")) << "no file";
    assets.put(some_costs(physics_version));
    ASSERT_TRUE(fidelity_cost("B1"));
    EXPECT_EQ(fidelity_cost("B1")->levels.size(), 2U);
    EXPECT_TRUE(fidelity_cost("B1")->of_this_physics());
    EXPECT_FALSE(fidelity_cost("A2"));
    assets.put(some_costs(physics_version - 1));
    ASSERT_TRUE(fidelity_cost("B1")) << "kept, and the reader says that it is of another simulation";
    EXPECT_FALSE(fidelity_cost("B1")->of_this_physics());
}

TEST(FidelityCost, OfTheRepositoryHasEveryTaskAndWhatItWasMeasuredWith) {
    const std::optional<FidelityCosts> costs = fidelity_costs();
    ASSERT_TRUE(costs.has_value()) << "measure again: fulcrum lab fidelity --data assets/fidelity_cost.json";
    for (const std::string& task : task_ids()) {
        ASSERT_EQ(costs->tasks.count(task), 1U) << task;
        EXPECT_GE(costs->tasks.at(task).commit.size(), 7U) << task;
        EXPECT_FALSE(costs->tasks.at(task).metrics.empty()) << task;
        for (const FidelityCost& level : costs->tasks.at(task).levels) {
            EXPECT_GE(level.attempts, 12) << task << " " << level.fidelity;
            EXPECT_LE(level.verdicts, level.attempts) << task << " " << level.fidelity;
            EXPECT_GT(level.processor_ms, 0) << task << " " << level.fidelity;
        }
    }
}

/// The line of a text that has `mark`; empty: none has.
std::string line_with(const std::string& text, const std::string& mark) {
    const std::size_t at = text.find(mark);
    if (at == std::string::npos) return {};
    const std::size_t begin = text.rfind('\n', at) + 1;
    return text.substr(begin, text.find('\n', at) - begin);
}

// Values that were measured with physics 2 were named values of physics 4 by a change of one number. A page
// of the same measurement says which program made it.
TEST(FidelityCost, OfTheRepositoryIsOfTheProgramThatMadeItsPage) {
    const std::optional<FidelityCosts> costs = fidelity_costs();
    ASSERT_TRUE(costs.has_value());
    int compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_path("docs/results"))) {
        const std::string name = entry.path().filename().string();
        if (name.compare(0, 14, "fidelity_score") != 0 || entry.path().extension() != ".md") continue;
        const std::string page = read_text_file(entry.path().string(), 1U << 24U);
        const std::string origin = line_with(page, "The attempts were simulated by the program at commit ");
        for (const auto& [task, cost] : costs->tasks) {
            const std::size_t section = page.find("## " + task + ": every metric");
            if (section == std::string::npos) continue;
            ++compared;
            EXPECT_NE(origin.find("at commit " + cost.commit), std::string::npos) << name << " " << task;
            EXPECT_NE(origin.find("physics version " + std::to_string(cost.physics) + "."), std::string::npos)
                << name << " " << task;
            const std::string judged = line_with(page.substr(section), ", limits ");
            EXPECT_NE(judged.find(", limits " + (cost.limits.empty() ? "none" : cost.limits) + ", " +
                                  std::to_string(cost.levels.front().attempts) + " seeds"),
                      std::string::npos)
                << name << " " << task << ": " << judged;
        }
    }
    EXPECT_GE(compared, 7) << "each task but A1, whose page was not kept";
}

}  // namespace
}  // namespace fulcrum
