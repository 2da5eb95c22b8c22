// SPDX-License-Identifier: GPL-3.0-or-later
// Every command that reads or writes people's data, as every role, on every kind of person: allowed or
// refused as platform.md says, scope included.   The commands run in this process by the call that main()
// makes.
#include <gtest/gtest.h>

#include <QFile>
#include <iostream>
#include <sstream>

#include "app/commands.h"
#include "sim_core/numerics/input_error.h"
#include "tests/app/access/access_programme.h"

namespace fulcrum::app::test {
namespace {

constexpr Role people_roles[] = {Role::trainee, Role::educator, Role::director, Role::administrator};

class CommandLine : public ::testing::Test {
  protected:
    CommandLine() {
        programme.store.reset();
        password_file = file("password.txt");
        QFile out(QString::fromStdString(password_file));
        EXPECT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(database::test::password);
    }
    std::string file(const std::string& name) const {
        return programme.folder.filePath(QString::fromStdString(name)).toStdString();
    }
    std::vector<std::string> as(Role role) const {
        if (role == Role::station) return {};
        return {"--as",       AccessProgramme::login_of(role), "--role", role_name(role), "--password-file",
                password_file};
    }
    /// True: done. False: refused for who asks. Anything else fails the test.
    bool allowed(std::vector<std::string> words, Role role, const std::string& cell) const {
        for (const std::string& word : as(role)) words.push_back(word);
        words.insert(words.end(), {"--db", programme.path});
        std::ostringstream output;
        std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
        bool done = false;
        try {
            const int status = run_command(words);
            EXPECT_EQ(status, 0) << cell;
            done = true;
        } catch (const AccessDenied& error) {
            EXPECT_NE(std::string(error.what()).find(';'), std::string::npos) << cell;
        } catch (const UsageError& error) {  // commands that the station may not give ask for --as
            EXPECT_NE(std::string(error.what()).find("--as"), std::string::npos)
                << cell << ": " << error.what();
        } catch (const InputError& error) {  // who may not list a person learns no more than that
            EXPECT_NE(std::string(error.what()).find("may read"), std::string::npos)
                << cell << ": " << error.what();
        }
        std::cout.rdbuf(before);
        return done;
    }
    static std::string cell(Operation operation, Role role, const Target& target) {
        return std::string(operation_name(operation)) + " as " + role_name(role) + " on " + target.login;
    }

    AccessProgramme programme;
    std::string password_file;
};

TEST_F(CommandLine, ReplaysAttemptsAsTheTableSays) {
    int done = 0, refused = 0;
    for (const Role role : all_roles) {
        for (const Target* target : {&programme.ann, &programme.eve, &programme.synthetic}) {
            const bool expected =
                expected_allowed(Operation::read_trace, role, programme.relation(role, *target));
            const std::string name = cell(Operation::read_trace, role, *target);
            EXPECT_EQ(allowed({"replay", target->attempt}, role, name), expected) << name;
            ++(expected ? done : refused);
        }
    }
    EXPECT_EQ(done, 1 + 1 + 3 + 0 + 1);
    EXPECT_EQ(refused, 9);
}

TEST_F(CommandLine, ReportsPeopleAndCohortsAsTheTableSays) {
    for (const Role role : all_roles) {
        for (const Target* target : {&programme.ann, &programme.eve, &programme.synthetic}) {
            const std::string path = file("person.json");
            const std::string name = cell(Operation::export_person, role, *target);
            // The station has the right to synthetic people, and no report without somebody who asks for it.
            const bool expected =
                role != Role::station &&
                expected_allowed(Operation::export_person, role, programme.relation(role, *target));
            EXPECT_EQ(
                allowed({"report", "--person", target->login, "--format", "json", "-o", path}, role, name),
                expected)
                << name;
            EXPECT_EQ(QFile::remove(QString::fromStdString(path)), expected) << name;
        }
        for (const Target* target : {&programme.ann, &programme.eve}) {
            const std::string path = file("cohort.json");
            const std::string name = cell(Operation::export_cohort, role, *target);
            const bool expected = expected_allowed(Operation::export_cohort, role,
                                                   AccessProgramme::cohort_relation(role, *target));
            EXPECT_EQ(
                allowed({"report", "--cohort", target->cohort, "--format", "json", "-o", path}, role, name),
                expected)
                << name;
            EXPECT_EQ(QFile::remove(QString::fromStdString(path)), expected) << name;
        }
    }
}

TEST_F(CommandLine, ChecksAndBacksUpTheStoreAsTheTableSays) {
    for (const Role role : all_roles) {
        const std::string check = std::string("check_store as ") + role_name(role);
        EXPECT_EQ(allowed({"db", "check"}, role, check), expected_allowed(Operation::check_store, role, {}))
            << check;
        const std::string backup = std::string("backup as ") + role_name(role);
        const std::string path = file(std::string("copy-") + role_name(role) + ".db");
        const bool expected = expected_allowed(Operation::backup, role, {});
        EXPECT_EQ(allowed({"db", "backup", path}, role, backup), expected) << backup;
        EXPECT_EQ(QFile::exists(QString::fromStdString(path)), expected) << backup;
    }
}

TEST_F(CommandLine, ReadsExpertsForABenchmarkAsTheTableSays) {
    for (const Role role : all_roles) {
        for (const Target* target : {&programme.ann, &programme.eve}) {
            const std::string name = cell(Operation::read_attempt, role, *target);
            const bool expected =
                role != Role::station &&
                expected_allowed(Operation::read_attempt, role, programme.relation(role, *target));
            // One attempt makes no benchmark: who may read it is told so (status 1), who may not is refused.
            std::vector<std::string> words = {"benchmark", "build", "A2", "--experts", target->login};
            for (const std::string& word : as(role)) words.push_back(word);
            words.insert(words.end(), {"--db", programme.path, "--json"});
            std::ostringstream output;
            std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
            bool read = false;
            try {
                EXPECT_EQ(run_command(words), 1) << name;
                read = true;
            } catch (const AccessDenied&) {
            } catch (const UsageError&) {
                EXPECT_EQ(role, Role::station) << name;
            } catch (const InputError& error) {
                EXPECT_NE(std::string(error.what()).find(target->login), std::string::npos) << name;
            }
            std::cout.rdbuf(before);
            EXPECT_EQ(read, expected) << name;
        }
    }
}

TEST_F(CommandLine, PerformsForSyntheticPeopleOnly) {
    // create_synthetic and perform_attempt: the station's alone; no option lets a person in a role use it.
    std::ostringstream output;
    std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
    EXPECT_THROW(run_command({"perform", "A2", "--person", "ann", "--db", programme.path}), UsageError);
    for (const Role role : people_roles) {
        std::vector<std::string> words = {"perform", "A2", "--db", programme.path};
        for (const std::string& word : as(role)) words.push_back(word);
        EXPECT_THROW(run_command(words), UsageError) << role_name(role);
    }
    EXPECT_EQ(run_command({"perform", "A2", "--operator", "expert", "--seed", "5", "--person", "robot-2",
                           "--db", programme.path}),
              0);
    std::cout.rdbuf(before);
}

}  // namespace
}  // namespace fulcrum::app::test
