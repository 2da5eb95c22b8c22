// SPDX-License-Identifier: Apache-2.0
// The page that adds up the kills of all tests (tests/support/kill_pages.h): rows of other tests stay, a row
// of the same test is replaced, and the six activities are added up.
#include "tests/support/kill_pages.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

class KillPages : public ::testing::Test {
  protected:
    static void SetUpTestSuite() { folder = std::make_unique<test::OwnFolder>(); }
    static void TearDownTestSuite() { folder.reset(); }
    KillPages() {
        if (const char* asked = std::getenv("FULCRUM_KILLS_PAGE")) before = asked;
        setenv("FULCRUM_KILLS_PAGE", folder->path().c_str(), 1);
        machine.build.commit = "0123abcd";
    }
    ~KillPages() override {
        before.empty() ? unsetenv("FULCRUM_KILLS_PAGE") : setenv("FULCRUM_KILLS_PAGE", before.c_str(), 1);
    }
    static std::string page() {
        std::ifstream file(*folder / "store.md");
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }
    static bool says(const std::string& words) { return page().find(words) != std::string::npos; }

    static std::unique_ptr<test::OwnFolder> folder;  // of both tests
    lab::Machine machine;
    std::string before;
};
std::unique_ptr<test::OwnFolder> KillPages::folder;

TEST_F(KillPages, HaveTheNewestRowOfEachTest) {
    test::enter_kills({test::Killed::reviewing, 7, "actions", 30, 1}, machine);
    test::enter_kills({test::Killed::reviewing, 20, "actions", 90, 0}, machine);
    EXPECT_TRUE(says("| reviewing | `KillPages.HaveTheNewestRowOfEachTest` | 20 | actions | 90 | 0 |"))
        << page();
    EXPECT_FALSE(says("| 7 |")) << page();
    EXPECT_TRUE(says("| 0123abcd |"));
    EXPECT_TRUE(says("| migrating an older store |  | not measured |"));
    EXPECT_TRUE(says("| **these six together** |  | **20** |"));
}

TEST_F(KillPages, AddUpTheRowsOfAllTests) {
    test::enter_kills({test::Killed::migrating, 400, "stores", 400, 0}, machine);
    EXPECT_TRUE(says("`KillPages.AddUpTheRowsOfAllTests` | 400 |")) << page();
    const bool both = says("`KillPages.HaveTheNewestRowOfEachTest`");  // where it ran before
    EXPECT_TRUE(
        says(both ? "| **these six together** |  | **420** |" : "| **these six together** |  | **400** |"))
        << page();
    test::enter_shared_store("2 programs", "16 scores", machine);
    EXPECT_TRUE(says("| 2 programs | 16 scores | 0123abcd |")) << page();
    EXPECT_TRUE(says("`KillPages.AddUpTheRowsOfAllTests` | 400 |")) << "the other table stays";
}

}  // namespace
}  // namespace fulcrum
