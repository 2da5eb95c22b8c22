// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum schedule, people merge, people login and research export, as they are called.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/services/program.h"
#include "tests/app/access_programme.h"

namespace fulcrum::app::program_test {
namespace {

namespace files = std::filesystem;

class ScheduleCommands : public ::testing::Test {
  protected:
    ScheduleCommands() {
        programme.store.reset();
        std::ofstream(path("password.txt")) << database::test::password << '\n';
    }
    std::string path(const char* name) const {
        return programme.folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    nlohmann::json run(std::vector<std::string> words, int wanted, const char* as = "director") const {
        words.insert(words.end(),
                     {"--as", as, "--password-file", path("password.txt"), "--db", programme.path, "--json"});
        std::ostringstream output;
        struct Redirected {
            std::streambuf* before;
            ~Redirected() { std::cout.rdbuf(before); }
        };
        {
            const Redirected redirected{std::cout.rdbuf(output.rdbuf())};
            EXPECT_EQ(run_command(words), wanted);
        }
        return nlohmann::json::parse(output.str().empty() ? "{}" : output.str());
    }
    AccessProgramme programme;
};

TEST_F(ScheduleCommands, WriteWhatIsDueOnceAndSayWhatFailed) {
    const std::string folder = path("reports"), missing = path("missing");
    files::create_directory(folder);
    const std::vector<std::string> add = {"schedule", "add",  "--cohort", "Year 1",
                                          "--format", "json", "--folder"};
    const auto to = [&](const std::string& where) {
        std::vector<std::string> words = add;
        words.push_back(where);
        return words;
    };
    run(to(folder), 0);
    const std::string failing = run(to(missing), 0)["id"];
    const nlohmann::json first = run({"schedule", "run"}, 1);
    ASSERT_EQ(first["written"].size(), 1U);
    ASSERT_EQ(first["failed"].size(), 1U);
    EXPECT_EQ(first["failed"][0]["id"], failing);
    const std::string file = first["written"][0];
    EXPECT_TRUE(nlohmann::json::parse(std::ifstream(file)).is_object());
    const auto time = files::last_write_time(file);
    files::create_directory(missing);
    const nlohmann::json second = run({"schedule", "run"}, 0);
    EXPECT_EQ(second["written"].size(), 1U) << "what failed is tried again";
    EXPECT_EQ(second["current"], 1);
    EXPECT_EQ(files::last_write_time(file), time);
    files::remove(file);
    EXPECT_EQ(run({"schedule", "run"}, 0)["written"][0], file) << "a file that is gone is written again";
    for (const auto& one : run({"schedule", "list"}, 0)["schedules"]) EXPECT_TRUE(one["problem"].is_null());
    run({"schedule", "remove", failing}, 0);
    EXPECT_EQ(run({"schedule", "list"}, 0)["schedules"].size(), 1U);
    std::size_t found = 0;
    for (const auto& entry : files::directory_iterator(folder)) found += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(found, 1U) << "no temporary file is left";
}

TEST_F(ScheduleCommands, MergePeopleWithADryRunAndUndo) {
    const std::vector<std::string> merge = {"people", "merge", "eve", "ann", "--reason", "entered twice"};
    std::vector<std::string> dry = merge;
    dry.push_back("--dry-run");
    EXPECT_TRUE(run(dry, 0, "administrator")["dry_run"]);
    EXPECT_EQ(run(merge, 0, "administrator")["into"]["login"], "ann");
    EXPECT_EQ(run({"people", "unmerge", "eve", "--reason", "no"}, 0, "administrator")["login"], "eve");
}

TEST_F(ScheduleCommands, ChangeALogin) {
    const nlohmann::json changed = run({"people", "login", "eve", "eve.b"}, 0, "administrator");
    EXPECT_EQ(changed["before"], "eve");
    EXPECT_EQ(changed["login"], "eve.b");
    const std::vector<std::string> again = {"people", "login", "eve", "eve.c"};
    EXPECT_THROW(run(again, 0, "administrator"), database::StoreError) << "nobody has this login now";
}

}  // namespace
}  // namespace fulcrum::app::program_test
