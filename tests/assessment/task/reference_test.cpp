// SPDX-License-Identifier: Apache-2.0
// The table of goal kinds in docs/TASKS.md is that of the code. FULCRUM_WRITE_REFERENCES=1 writes it.
#include <gtest/gtest.h>

#include <string>

#include "assessment/task/goal_type.h"
#include "tests/support/generated.h"

namespace fulcrum {
namespace {

const char* site_text(GoalSite site) {
    switch (site) {
        case GoalSite::targets:
            return "targets";
        case GoalSite::bowel:
            return "bowel";
        case GoalSite::sheet:
            return "sheet or septa";
        case GoalSite::bands:
            return "bands";
        case GoalSite::objects:
            return "objects";
        case GoalSite::camera_targets:
            return "camera_targets";
    }
    return "";
}

TEST(References, GoalKindsAreThoseOfTheTable) {
    std::string text = "| kind | title | works on | keys |\n| --- | --- | --- | --- |\n";
    for (const GoalType& type : goal_types) {
        std::string keys;
        for (const GoalKey& key : type.keys)
            if (key.name != nullptr)
                keys += std::string(keys.empty() ? "" : "; ") + "`" + key.name + "` " + key.meaning;
        text += std::string("| `") + type.name + "` | " + type.title + " | " + site_text(type.site) + " | " +
                test::in_cell(keys) + " |\n";
    }
    test::expect_generated("TASKS.md", "goals", text);
}

}  // namespace
}  // namespace fulcrum
