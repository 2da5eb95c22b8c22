// SPDX-License-Identifier: GPL-3.0-or-later
// Which operations write, and which a programme server answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "database/access/access.h"

namespace fulcrum::database::test {
namespace {

TEST(AccessKinds, WhatReadsIsNoWriteAndServersAreOnlyRead) {
    const auto begins = [](const std::string& name, const std::vector<std::string>& words) {
        return std::any_of(words.begin(), words.end(),
                           [&](const std::string& word) { return name.rfind(word, 0) == 0; });
    };
    for (int i = 0; i < operation_count; ++i) {
        const auto operation = static_cast<Operation>(i);
        const std::string name = operation_name(operation);
        if (begins(name, {"read_", "list_", "view_", "check_"})) {
            EXPECT_FALSE(writes_store(operation)) << name;
        }
        if (begins(name,
                   {"manage_", "set_", "issue_", "void_", "reassign_", "decide_", "import_", "erase_"})) {
            EXPECT_TRUE(writes_store(operation)) << name;
        }
        EXPECT_FALSE(writes_store(operation) && is_for_servers(operation)) << name;
    }
    EXPECT_FALSE(writes_store(Operation::perform_attempt)) << "a sealed demo takes practice";
    EXPECT_TRUE(is_for_servers(Operation::export_cohort));
    EXPECT_FALSE(is_for_servers(Operation::view_audit)) << "that of a station is at the station";
}

}  // namespace
}  // namespace fulcrum::database::test
