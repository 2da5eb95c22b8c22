// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that several operations of the access table stand behind, each in each role and by the station:
// the exit status that a script sees is 0 for whoever may, 2 for everybody else.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/command_line.h"
#include "app/cli/installed_curriculum.h"
#include "app/services/program.h"
#include "database/records/certificates.h"
#include "database/records/standings.h"
#include "database/rows/connection.h"
#include "database/schedules/schedules.h"
#include "tests/app/access_programme.h"
#include "tests/database/postgresql_server.h"
#include "tests/database/station_keys.h"
#include "tests/database/xapi/fake_record_store.h"

namespace fulcrum::app::program_test {
namespace {

namespace files = std::filesystem;

class RoleCommands : public ::testing::Test {
  protected:
    RoleCommands() {
        // Five people with attempts at a task: fewer are not exported for research.
        const People people = programme.people();
        const People::Created made =
            people.create(programme.session("administrator"), "fay", "Fay Trainee", {Role::trainee});
        programme.sessions.emplace("fay",
                                   people.change_password(people.sign_in("fay", made.one_time_password),
                                                          made.one_time_password, database::test::password));
        for (const char* login : {"ben", "fay"}) programme.record(login);
        files::create_directory(in("reports"));
        ReportSchedule weekly;
        weekly.cohort_id = programme.cohort;
        weekly.format = "json";
        weekly.folder = in("reports");
        schedule = Schedules(*programme.store).add(programme.session("director"), weekly);
        programme.store->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
        programme.store.reset();
        files::copy_file(programme.path, in("kept.db"));
        write("password.txt", std::string(database::test::password) + "\n");
        write("lrs.txt", "key:secret\n");
        write("new.csv", "login,name,role,cohort\nmia,Mia Berg,trainee,Spring\n");
        write("known.csv", "login,name,role,cohort\nann,Ann Trainee,trainee,Spring\n");
        nlohmann::json set = nlohmann::json::parse(std::ifstream(asset_path("benchmarks/A2.json")));
        set["version"] = 90;
        write("ours.json", set.dump(2));
    }
    std::string in(const char* name) const {
        return programme.folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    void write(const char* name, const std::string& words) const {
        std::ofstream(in(name)) << words;
        ::chmod(in(name).c_str(), 0600);
    }
    /// The store as it was before the first command.
    void put_back() const {
        for (const char* suffix : {"", "-wal", "-shm"}) files::remove(programme.path + suffix);
        files::copy_file(in("kept.db"), programme.path);
    }
    /// As main() ends; `said` is what was printed. `login`: somebody else of that role.
    int status_of(std::vector<std::string> words, Role role, std::string& said,
                  const char* login = nullptr) const {
        const char* const as = login != nullptr ? login : AccessProgramme::login_of(role);
        if (role != Role::station)
            words.insert(words.end(),
                         {"--as", as, "--role", role_name(role), "--password-file", in("password.txt")});
        words.insert(words.end(), {"--db", programme.path});
        std::ostringstream output;
        std::streambuf* const out = std::cout.rdbuf(output.rdbuf());
        std::streambuf* const err = std::cerr.rdbuf(output.rdbuf());
        const int status = guarded([&] { return run_command(words); });
        std::cout.rdbuf(out);
        std::cerr.rdbuf(err);
        said = output.str();
        return status;
    }

    /// Gil, in "Year 1" and without attempts, completes stage A by decisions. Returns the check code of the
    /// certificate.
    std::string complete_stage_of_gil(const Curriculum& curriculum) const {
        std::string code;
        {
            const Store store = Store::open(programme.path);
            const People people(store);
            const auto enter = [&](Role role) {
                return people.act_as(
                    people.sign_in(AccessProgramme::login_of(role), database::test::password), role);
            };
            const People::Created made =
                people.create(enter(Role::administrator), "gil", "Gil Trainee", {Role::trainee});
            const std::string gil = people
                                        .change_password(people.sign_in("gil", made.one_time_password),
                                                         made.one_time_password, database::test::password)
                                        .person_id();
            people.set_members(enter(Role::director), programme.cohort,
                               {programme.id("ann"), programme.id("ben"), programme.id("educator"), gil});
            const Session educator_session = enter(Role::educator);
            for (const char* task : {"A1", "A2", "A3"})
                Standings(store).decide(educator_session, gil, task, StandingOverride::Kind::proficient,
                                        "examined in theatre", &curriculum);
            for (const Certificate& one : certificates(store, educator_session, gil, curriculum))
                code = one.code;
            store.connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
        }
        files::copy_file(programme.path, in("kept.db"), files::copy_options::overwrite_existing);
        return code;
    }

    AccessProgramme programme;
    const database::test::KeysOfOneTest keys;  // the list of erased people is next to them
    database::test::FakeRecordStore record_store;
    std::string schedule;
};

TEST_F(RoleCommands, EndWithTheStatusThatTheRoleAllows) {
    struct Row {
        std::vector<std::string> words;
        Role may;  ///< the only one
    };
    const std::string older = installed_curriculum().older.front().name();
    std::vector<Row> rows = {
        {{"people", "merge", "eve", "ann", "--reason", "entered twice"}, Role::administrator},
        {{"people", "merge", "eve", "ann", "--dry-run"}, Role::administrator},
        {{"people", "import", in("new.csv")}, Role::administrator},
        {{"people", "import", in("new.csv"), "--dry-run"}, Role::administrator},
        {{"cohort", "import", in("known.csv")}, Role::director},
        {{"curriculum", "move", "--person", "ann", "--to", older, "--reason", "began with it"},
         Role::educator},
        {{"research", "export", "-o", in("research")}, Role::director},
        {{"schedule", "add", "--cohort", "Year 1", "--format", "csv", "--folder", in("reports")},
         Role::director},
        {{"schedule", "list"}, Role::director},
        {{"schedule", "run"}, Role::director},
        {{"schedule", "remove", schedule}, Role::director},
        {{"xapi", "send", "--to", record_store.address(), "--credentials", in("lrs.txt"), "--cohort",
          "Year 1", "--home-page", "https://training.example"},
         Role::director},
        {{"xapi", "list"}, Role::director},
        {{"tissues", "B2", "--set", "areolar.penetrate_n=0.11", "--reason", "as in our patients"},
         Role::educator},
        {{"assets", "accept", in("ours.json"), "--reason", "ours"}, Role::educator},
        {{"db", "restore", in("kept.db")}, Role::administrator},
    };
    // Without PostgreSQL there is no server to exchange with.
    if (auto* const server = database::test::PostgresqlServer::of_this_process(); server != nullptr)
        rows.push_back({{"sync", "--to", server->new_database().text()}, Role::administrator});
    for (const Row& row : rows) {
        for (const Role role : all_roles) {
            put_back();
            std::string said;
            EXPECT_EQ(status_of(row.words, role, said), role == row.may ? 0 : 2)
                << row.words[0] << ' ' << row.words[1] << " as " << role_name(role) << ": " << said;
        }
    }
    EXPECT_FALSE(record_store.statements.empty()) << "the director's";
    // What was refused has written nothing.
    const auto written = [&](const char* folder) {
        return std::distance(files::directory_iterator(in(folder)), files::directory_iterator());
    };
    EXPECT_EQ(written("research"), 5);
    EXPECT_EQ(written("reports"), 1);
}

// A certificate is exported by the person and the director, and verified by whoever may read the progress.
TEST_F(RoleCommands, WriteAndVerifyACertificateForThoseWhoMay) {
    const std::string code = complete_stage_of_gil(installed_curriculum()), paper = in("certificate.pdf");
    ASSERT_FALSE(code.empty());
    const std::vector<std::string> writes = {"certificate", "--person", "gil", "--stage", "A", "-o", paper},
                                   verifies = {"certificate", "--verify", code};
    std::string said;
    const auto expect_written = [&](Role role, const char* login, bool may) {
        put_back();
        files::remove(paper);
        EXPECT_EQ(status_of(writes, role, said, login), may ? 0 : 2) << role_name(role) << ": " << said;
        EXPECT_EQ(files::exists(paper), may) << role_name(role);
    };
    for (const Role role : all_roles) {
        expect_written(role, nullptr, role == Role::director);
        put_back();
        // 1: no certificate of the people whose progress they may read. The station signs nobody in.
        const bool reads = role == Role::educator || role == Role::director;
        EXPECT_EQ(status_of(verifies, role, said), role == Role::station ? 2
                                                   : reads               ? 0
                                                                         : 1)
            << role_name(role) << ": " << said;
        EXPECT_EQ(said.find("Gil Trainee") != std::string::npos, reads) << role_name(role) << ": " << said;
    }
    expect_written(Role::trainee, "gil", true);
    EXPECT_EQ(status_of(verifies, Role::trainee, said, "gil"), 0) << said;
}

}  // namespace
}  // namespace fulcrum::app::program_test
