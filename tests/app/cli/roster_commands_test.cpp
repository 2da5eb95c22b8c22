// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum people import and cohort import, as they are called: dry run, passwords in a file, repeated.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QFile>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/services/program.h"
#include "tests/app/access_programme.h"

namespace fulcrum::app::program_test {
namespace {

class RosterCommands : public ::testing::Test {
  protected:
    RosterCommands() {
        programme.store.reset();
        std::ofstream(path("password.txt")) << database::test::password << '\n';
        std::ofstream(path("list.csv")) << "login,name,role,cohort\nmia,Mia Berg,trainee,Spring\n"
                                           "tea,\"Cher, =Tea\",educator,Spring\n";
    }
    std::string path(const char* name) const {
        return programme.folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    nlohmann::json run(std::vector<std::string> words, Role role, int wanted) const {
        words.insert(words.end(),
                     {"--as", AccessProgramme::login_of(role), "--role", role_name(role), "--password-file",
                      path("password.txt"), "--db", programme.path, "--json"});
        std::ostringstream output;
        struct Redirected {
            std::streambuf* before;
            ~Redirected() { std::cout.rdbuf(before); }
        };
        {
            const Redirected redirected{std::cout.rdbuf(output.rdbuf())};
            EXPECT_EQ(run_command(words), wanted);
        }
        return nlohmann::json::parse(output.str());
    }
    AccessProgramme programme;
};

TEST_F(RosterCommands, ImportPeopleThenCohorts) {
    const nlohmann::json dry =
        run({"people", "import", path("list.csv"), "--dry-run"}, Role::administrator, 0);
    EXPECT_TRUE(dry["dry_run"]);
    EXPECT_EQ(dry["people"][0]["what"], "create");
    const nlohmann::json early = run({"cohort", "import", path("list.csv"), "--dry-run"}, Role::director, 1);
    EXPECT_EQ(early["cohorts"][0]["missing"], nlohmann::json::parse(R"(["mia", "tea"])")) << "nobody yet";

    const nlohmann::json made =
        run({"people", "import", path("list.csv"), "--passwords", path("new.csv")}, Role::administrator, 0);
    EXPECT_EQ(made["people"][1]["what"], "create");
    EXPECT_TRUE(made["people"][1]["one_time_password"].is_null()) << "only in the file";
    struct stat facts = {};
    ASSERT_EQ(::stat(path("new.csv").c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, 0600U) << "nobody else can read it";
    std::ifstream in(path("new.csv"));
    const std::string written{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    EXPECT_EQ(written.rfind("login,name,one_time_password\nmia,Mia Berg,", 0), 0U) << written;
    EXPECT_NE(written.find("tea,\"Cher, =Tea\","), std::string::npos) << written;

    EXPECT_THROW(
        run({"people", "import", path("list.csv"), "--passwords", path("new.csv")}, Role::administrator, 0),
        std::exception)
        << "a file that is there is not replaced";
    const nlohmann::json cohort = run({"cohort", "import", path("list.csv")}, Role::director, 0);
    EXPECT_TRUE(cohort["cohorts"][0]["created"]);
    const nlohmann::json again = run({"cohort", "import", path("list.csv")}, Role::director, 0);
    EXPECT_FALSE(again["cohorts"][0]["created"]);
    EXPECT_TRUE(again["cohorts"][0]["members"].empty());
    EXPECT_EQ(run({"people", "import", path("list.csv")}, Role::administrator, 0)["people"][0]["what"],
              "nothing");
}

TEST_F(RosterCommands, AreForAdministratorAndDirectorOnly) {
    EXPECT_THROW(run({"people", "import", path("list.csv"), "--dry-run"}, Role::director, 0),
                 database::AccessDenied);
    EXPECT_THROW(run({"cohort", "import", path("list.csv"), "--dry-run"}, Role::administrator, 0),
                 database::AccessDenied);
}

}  // namespace
}  // namespace fulcrum::app::program_test
