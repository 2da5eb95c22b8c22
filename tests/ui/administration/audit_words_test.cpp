// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/audit_words.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/support.h"

namespace fulcrum::ui {
namespace {

/// Every operation that a source of the store's records appends to the audit log.
std::set<std::string> audited_operations() {
    static const std::regex call(R"re(append\([^;]*?"((?:[a-z]+\.[a-z_]+)|sign_in)")re");
    std::set<std::string> names;
    for (const char* folder : {"database/records", "database/store", "database/sync"}) {
        for (const auto& entry : std::filesystem::directory_iterator(fulcrum::test::source_path(folder))) {
            std::stringstream source;
            source << std::ifstream(entry.path()).rdbuf();
            const std::string text = source.str();
            for (std::sregex_iterator found(text.begin(), text.end(), call), end; found != end; ++found)
                names.insert((*found)[1]);
        }
    }
    return names;
}

TEST(AuditWords, EveryAuditedOperationHasWords) {
    const std::set<std::string> names = audited_operations();
    EXPECT_GT(names.size(), 18U);
    for (const std::string& name : names) {
        const QString shown = audit_operation_text(name);
        EXPECT_FALSE(shown.contains('.') || shown.contains('_')) << name;
        const std::size_t point = name.find('.');
        if (point != std::string::npos) {
            EXPECT_TRUE(audit_group_text(name.substr(0, point)).endsWith(": all")) << name;
        }
    }
    EXPECT_EQ(audit_operation_text("attempt.finish"), "Attempt finished");
    EXPECT_EQ(audit_operation_text("later.operation"), "later.operation");
}

}  // namespace
}  // namespace fulcrum::ui
