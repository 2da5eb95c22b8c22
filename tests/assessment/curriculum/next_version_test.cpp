// SPDX-License-Identifier: Apache-2.0
// A new version of the shipped curriculum: only the version and the rules asked for differ, and it can be
// installed next to the old one.
#include "assessment/curriculum/next_version.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

Curriculum newest() {
    return load_versions(asset_path("curricula"), "rectal", task_ids());
}

TEST(NextVersion, ChangesTheVersionAndTheRulesAskedForOnly) {
    const Curriculum from = newest();
    const std::string written = next_version_text(
        from, {{"A2", parse_pass_rule("of:8,10")}, {"C4", parse_pass_rule("lc-cusum:0.05,0.25,3.1")}});
    auto before = nlohmann::json::parse(from.text), after = nlohmann::json::parse(written);
    EXPECT_EQ(after["version"], from.version + 1);
    for (std::size_t i = 0; i < from.tasks.size(); ++i) {
        const std::string& id = from.tasks[i].task;
        const std::string rule = after["tasks"][i]["rule"];
        if (id == "A2") {
            EXPECT_EQ(rule, "of:8,10");
        } else if (id == "C4") {
            EXPECT_EQ(rule, "lc-cusum:0.05,0.25,3.1");
        } else {
            EXPECT_EQ(rule, before["tasks"][i]["rule"]);
        }
        after["tasks"][i].erase("rule");
        before["tasks"][i].erase("rule");
    }
    after.erase("version");
    before.erase("version");
    EXPECT_EQ(after, before);
}

TEST(NextVersion, IsInstalledNextToTheVersionsBeforeIt) {
    const Curriculum from = newest();
    const test::OwnFolder folder;
    for (const auto& file : std::filesystem::directory_iterator(asset_path("curricula")))
        std::filesystem::copy_file(file.path(), folder.path() / file.path().filename());
    std::ofstream(folder.path() / "rectal-3.json")
        << next_version_text(from, {{"B1", parse_pass_rule("row:3")}});
    const Curriculum with = load_versions(folder.path().string(), "rectal", task_ids());
    EXPECT_EQ(with.name(), "rectal@3");
    EXPECT_EQ(with.find("B1")->rule.kind, PassRuleKind::in_a_row);
    EXPECT_EQ(with.find("B1")->rule.k, 3);
    ASSERT_EQ(with.older.size(), 2U);
    EXPECT_EQ(with.older[0].text, from.text) << "the one before is as it was";
}

TEST(NextVersion, RefusesATaskThatIsNotInIt) {
    EXPECT_THROW(next_version_text(newest(), {{"Z9", PassRule()}}), InputError);
    Curriculum made = newest();
    made.text.clear();
    EXPECT_THROW(next_version_text(made, {}), InputError);
}

}  // namespace
}  // namespace fulcrum
