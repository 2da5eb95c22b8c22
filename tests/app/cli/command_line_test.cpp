// SPDX-License-Identifier: GPL-3.0-or-later
// Every command that reads or writes people's data, for every role and every kind of person: allowed or
// refused as in docs/MANUAL.md, scope included. The commands run in this process by the call that main()
// makes.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>

#include "app/services/program.h"
#include "database/rows/connection.h"
#include "sim_core/numerics/input_error.h"
#include "tests/app/access_programme.h"
#include "tests/app/program_path.h"
#include "tests/database/station_keys.h"

namespace fulcrum::app::program_test {
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
        out.close();
        keep();
    }
    /// A copy of the store, restored between cells.
    void keep() {
        QFile::remove(QString::fromStdString(file("kept.db")));
        const Store store = Store::open(programme.path);
        store.backup(programme.asker(Role::administrator), file("kept.db"));
    }
    void restore() {
        for (const char* suffix : {"", "-wal", "-shm"})
            QFile::remove(QString::fromStdString(programme.path + suffix));
        ASSERT_TRUE(
            QFile::copy(QString::fromStdString(file("kept.db")), QString::fromStdString(programme.path)));
    }
    std::size_t scores(const Target& target) {
        const Store store = Store::open(programme.path);
        return Attempts(store).scores(programme.asker(Role::director), target.attempt).size();
    }
    std::string file(const std::string& name) const {
        return programme.folder.filePath(QString::fromStdString(name)).toStdString();
    }
    std::vector<std::string> as(Role role) const {
        if (role == Role::station) return {};
        return {"--as",       AccessProgramme::login_of(role), "--role", role_name(role), "--password-file",
                password_file};
    }
    /// True: succeeded. False: access refused. Any other outcome fails the test.
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
        } catch (const UsageError& error) {  // commands that the station may not use require --as
            EXPECT_NE(std::string(error.what()).find("--as"), std::string::npos)
                << cell << ": " << error.what();
        } catch (const InputError& error) {  // the message must not reveal whether a person exists whom the
                                             // asker may not list
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

TEST_F(CommandLine, SendsTheAttemptOfARealPersonOverOpenIgtLink) {
    QStringList words = {"igtl",        "serve", QString::fromStdString(programme.ann.attempt), "--address",
                         "127.0.0.1:0", "--db",  QString::fromStdString(programme.path)};
    for (const std::string& word : as(Role::educator)) words << QString::fromStdString(word);
    QProcess serve;
    serve.setProcessChannelMode(QProcess::MergedChannels);
    serve.start(program_path(), words);
    ASSERT_TRUE(serve.waitForStarted());
    QByteArray said;
    while (!said.contains(" as soon as") && serve.waitForReadyRead(20000)) said += serve.readAll();
    EXPECT_TRUE(said.contains(" as soon as")) << said.toStdString();
    serve.terminate();
    ASSERT_TRUE(serve.waitForFinished(20000));
    EXPECT_EQ(serve.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(serve.exitCode(), 0) << said.toStdString();
}

TEST_F(CommandLine, ReportsPeopleAndCohortsAsTheTableSays) {
    for (const Role role : all_roles) {
        for (const Target* target : {&programme.ann, &programme.eve, &programme.synthetic}) {
            const std::string path = file("person.json");
            const std::string name = cell(Operation::export_person, role, *target);
            // The station may read synthetic people, but a report needs a person who signs in.
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
        const QDir folder(QString::fromStdString(file(std::string("backups-") + role_name(role))));
        ASSERT_TRUE(folder.mkpath("."));
        EXPECT_EQ(allowed({"db", "backup", folder.path().toStdString(), "--keep", "3"}, role, backup),
                  expected)
            << backup;
        EXPECT_EQ(folder.entryList({"fulcrum-*.db"}, QDir::Files).size(), expected ? 1 : 0) << backup;
    }
}

TEST_F(CommandLine, ChangesLoginsAsTheTableSays) {
    for (const Role role : all_roles) {
        const std::string name = cell(Operation::manage_people, role, programme.ann);
        EXPECT_EQ(allowed({"people", "login", programme.ann.login, "Ann"}, role, name),
                  expected_allowed(Operation::manage_people, role, programme.relation(role, programme.ann)))
            << name;
    }
}

TEST_F(CommandLine, ErasesPeopleAsTheTableSays) {
    for (const Role role : all_roles)
        for (const Target* target : {&programme.ann, &programme.eve}) {
            const std::string name = cell(Operation::erase_person, role, *target);
            EXPECT_EQ(allowed({"people", "erase", target->login, "--dry-run"}, role, name),
                      expected_allowed(Operation::erase_person, role, programme.relation(role, *target)))
                << name;
        }
}

TEST_F(CommandLine, ExportsAllOfAPersonAndSetsTheTimeForKeepingDataAsTheTableSays) {
    int number = 0;
    for (const Role role : all_roles) {
        for (const Target* target : {&programme.ann, &programme.eve}) {
            const std::string name = cell(Operation::export_all, role, *target);
            const bool expected =
                expected_allowed(Operation::export_all, role, programme.relation(role, *target));
            EXPECT_EQ(allowed({"people", "export", target->login, "--dry-run"}, role, name), expected)
                << name;
            const std::string folder = file("export-" + std::to_string(++number));
            EXPECT_EQ(allowed({"people", "export", target->login, "-o", folder}, role, name), expected)
                << name;
            EXPECT_EQ(QFile::exists(QString::fromStdString(folder + "/index.html")), expected) << name;
        }
        const std::string name = std::string("retention as ") + role_name(role);
        const bool may = expected_allowed(Operation::erase_person, role, {});
        EXPECT_EQ(allowed({"people", "retention"}, role, name), may) << name;
        EXPECT_EQ(allowed({"people", "retention", "--months", "24"}, role, name), may) << name;
    }
}

TEST_F(CommandLine, CopiesADamagedStoreAsTheTableSays) {
    for (const Role role : all_roles) {
        const std::string copy = file(std::string("copy-") + role_name(role) + ".db"),
                          name = std::string("backup --damaged as ") + role_name(role);
        const bool expected = expected_allowed(Operation::backup, role, {});
        EXPECT_EQ(allowed({"db", "backup", copy, "--damaged"}, role, name), expected) << name;
        EXPECT_FALSE(QFile::exists(QString::fromStdString(copy)));
        EXPECT_EQ(QFile::exists(QString::fromStdString(
                      file(std::string("copy-") + role_name(role) + "-unverified.db"))),
                  expected)
            << name;
    }
}

TEST_F(CommandLine, ChangesTheStationsKeyAsTheTableSays) {
    const database::test::KeysOfOneTest keys;
    for (const Role role : all_roles) {
        const std::string name = std::string("rotate_key as ") + role_name(role);
        EXPECT_EQ(allowed({"db", "rotate-key", "--reason", "planned"}, role, name),
                  expected_allowed(Operation::rotate_key, role, {}))
            << name;
    }
    EXPECT_TRUE(allowed({"db", "keys"}, Role::station, "keys"));
    EXPECT_TRUE(allowed({"db", "check"}, Role::station, "check"));
}

TEST_F(CommandLine, ShowsTheAuditLogAsTheTableSays) {
    for (const Role role : all_roles) {
        const std::string name = std::string("view_audit as ") + role_name(role);
        EXPECT_EQ(allowed({"db", "audit"}, role, name), expected_allowed(Operation::view_audit, role, {}))
            << name;
    }
}

TEST_F(CommandLine, RecomputesScoresAsTheTableSays) {
    for (const Role role : all_roles) {
        for (const Target* target : {&programme.ann, &programme.eve, &programme.synthetic}) {
            const std::string name = cell(Operation::recompute_score, role, *target);
            const bool expected =
                expected_allowed(Operation::recompute_score, role, programme.relation(role, *target));
            EXPECT_EQ(scores(*target), 1U) << name;
            EXPECT_EQ(allowed({"db", "recompute", "--person", target->login}, role, name), expected) << name;
            EXPECT_EQ(scores(*target), expected ? 2U : 1U) << name;
            restore();
        }
    }
}

TEST_F(CommandLine, RecomputingTwiceAddsOneScoreAndKeepsTheScoreInForce) {
    const std::string cell = "as the educator";
    ASSERT_TRUE(allowed({"db", "recompute"}, Role::educator, cell));
    ASSERT_TRUE(allowed({"db", "recompute"}, Role::educator, cell));
    const Store store = Store::open(programme.path);
    const Attempts attempts(store);
    for (const Target* target : {&programme.ann, &programme.own}) {
        const auto all = attempts.scores(programme.asker(Role::director), target->attempt);
        ASSERT_EQ(all.size(), 2U) << target->login;
        EXPECT_TRUE(all[0].in_force);
        EXPECT_EQ(all[0].points, 60);
        EXPECT_FALSE(all[1].in_force);
        EXPECT_NE(all[1].limits, all[0].limits);
        EXPECT_GT(all[1].metrics.size(), all[0].metrics.size());
    }
    EXPECT_EQ(attempts.scores(programme.asker(Role::director), programme.eve.attempt).size(), 1U);
    EXPECT_TRUE(store.check(store.station_session()).ok);
}

TEST_F(CommandLine, ScoresInterruptedAttemptsAsTheTableSays) {
    const Target* targets[] = {&programme.ann, &programme.eve, &programme.own, &programme.synthetic};
    std::map<std::string, std::string> interrupted;
    for (const Target* target : targets) {
        const Session& performer = target == &programme.ann   ? programme.session("ann")
                                   : target == &programme.eve ? programme.session("eve")
                                   : target == &programme.own ? *programme.teacher
                                                              : programme.session("station");
        AttemptMeta meta = example_meta(target->person);
        if (target == &programme.synthetic) meta.device_class = DeviceClass::synthetic;
        Recorder recorder(programme.path, performer, meta, programme.clock.options());
        Programme::append_second(recorder);
        recorder.flush();
        interrupted[target->login] = recorder.attempt_id();
    }
    Store::open(programme.path);  // the next start closes them
    keep();
    for (const Role role : all_roles) {
        const std::string name = std::string("score_interrupted as ") + role_name(role);
        EXPECT_EQ(allowed({"db", "score"}, role, name),
                  expected_scope(Operation::score_interrupted, role) != Scope::none)
            << name;
        {
            const Store store = Store::open(programme.path);
            const Attempts attempts(store);
            for (const Target* target : targets) {
                const bool expected =
                    expected_allowed(Operation::score_interrupted, role, programme.relation(role, *target));
                const Session& reader = programme.asker(Role::director);
                EXPECT_EQ(attempts.scores(reader, interrupted[target->login]).size(), expected ? 1U : 0U)
                    << cell(Operation::score_interrupted, role, *target);
            }
        }
        restore();
    }
}

TEST_F(CommandLine, ScoringExitsWithOneIfAnAttemptCannotBeScored) {
    {
        Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.ann.person, "Z9"),
                          programme.clock.options());
        Programme::append_second(recorder);
        recorder.flush();
    }
    std::vector<std::string> words = {"db", "score", "--json", "--db", programme.path};
    for (const std::string& word : as(Role::educator)) words.push_back(word);
    std::ostringstream output;
    std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
    const int status = run_command(words);
    std::cout.rdbuf(before);
    EXPECT_EQ(status, 1);
    const auto document = nlohmann::json::parse(output.str());
    ASSERT_EQ(document["scored"].size(), 1U) << output.str();
    EXPECT_TRUE(document["scored"][0]["passed"].is_null());
    EXPECT_NE(document["scored"][0]["because"].get<std::string>().find("Z9"), std::string::npos);
}

TEST_F(CommandLine, WrongInputNamesThePlaceAndTheHint) {
    const std::vector<std::vector<std::string>> wrong = {
        {"db", "audit", "--from", "yesterday"},
        {"db", "audit", "--from", "2026-02-30"},
        {"db", "audit", "--until", "2026-11-21T25:00:00Z"},
        {"db", "audit", "--from", "2026-11-21", "--until", "2026-11-20"},
        {"db", "audit", "--limit", "0"},
        {"db", "audit", "--limit", "many"},
        {"db", "audit", "--kind", "attempt.voided"},
        {"db", "audit", "--person", "nobody"},
        {"db", "audit", "extra"},
        {"db", "audit", "--format", "pdf"},
        {"db", "audit", "--role", "king"},
        {"db", "check", "--kind", "attempt"},
        {"db", "backup"},
        {"db", "backup", programme.path},
        {"db", "backup", programme.path, "--keep", "2"},
        {"db", "backup", "--keep", "0", "folder"},
        {"db", "backup", "--keep", "all", "folder"},
    };
    for (const std::vector<std::string>& words : wrong) {
        std::vector<std::string> all = words;
        if (std::find(words.begin(), words.end(), "--role") == words.end())
            all.insert(all.end(), {"--role", "administrator"});
        all.insert(all.end(),
                   {"--as", "administrator", "--password-file", password_file, "--db", programme.path});
        std::string said;
        try {
            run_command(all);
        } catch (const std::exception& error) {
            said = error.what();
        }
        EXPECT_NE(said.find(';'), std::string::npos) << words[1] << ' ' << words.back() << ": " << said;
        const std::string place = words.size() > 2 ? words[2] : words[1];
        EXPECT_NE(said.find(place), std::string::npos) << said;
    }
    EXPECT_THROW(run_command({"db", "recompute", "--person", "nobody", "--db", programme.path}), InputError);
    EXPECT_THROW(run_command({"db", "recompute", "extra", "--db", programme.path}), UsageError);
    EXPECT_THROW(run_command({"db", "score", "--limit", "3", "--db", programme.path}), UsageError);
    EXPECT_THROW(run_command({"db", "audit", "--db", programme.path}), UsageError);
    EXPECT_THROW(run_command({"db", "--json"}), UsageError);
}

TEST_F(CommandLine, AQuickCheckRefusesWhatItDoesNotLookAt) {
    const std::string digits(16, '0');
    const std::pair<const char*, std::string> options[] = {{"--against", digits},
                                                           {"--key", digits},
                                                           {"--simulate", "1"},
                                                           {"--seed", "1"},
                                                           {"--as", "ann"},
                                                           {"--role", "administrator"},
                                                           {"--password-file", password_file}};
    for (const auto& [option, value] : options)
        EXPECT_THROW(run_command({"db", "check", "--quick", option, value, "--db", programme.path}),
                     UsageError)
            << option;
    EXPECT_TRUE(allowed({"db", "check", "--quick"}, Role::station, "quick check"));
}

TEST_F(CommandLine, AuditLogExitsWithOneIfItsChainIsBroken) {
    {
        const Store store = Store::open(programme.path);
        store.connection().execute("DROP TRIGGER audit_entry_is_fixed");
        store.connection().execute("UPDATE audit_entry SET time = time + 1 WHERE sequence = 4");
    }
    std::ostringstream output;
    std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
    std::vector<std::string> words = {"db",  "audit",  "--kind", "attempt",     "--person",
                                      "eve", "--json", "--db",   programme.path};
    for (const std::string& word : as(Role::administrator)) words.push_back(word);
    const int status = run_command(words);
    std::cout.rdbuf(before);
    EXPECT_EQ(status, 1);
    const auto document = nlohmann::json::parse(output.str());
    EXPECT_FALSE(document["chain"]["ok"].get<bool>());
    EXPECT_NE(document["chain"]["problems"][0].get<std::string>().find("audit row 4"), std::string::npos);
    ASSERT_EQ(document["entries"].size(), 3U);
    for (const auto& entry : document["entries"]) {
        EXPECT_EQ(entry["person_name"], "Eve Elsewhere");
        EXPECT_EQ(entry["role"], "trainee");
        const bool begins = entry["operation"] == "attempt.begin";  // says nothing of how it went
        EXPECT_EQ(entry["payload"].get<std::string>().find("withheld") == std::string::npos, begins);
    }
    EXPECT_EQ(document["entries"][0]["operation"], "attempt.request_correction");
    EXPECT_EQ(document["entries"][1]["operation"], "attempt.finish");
    EXPECT_EQ(document["entries"][2]["operation"], "attempt.begin");
}

TEST_F(CommandLine, ReadsExpertsForABenchmarkAsTheTableSays) {
    for (const Role role : all_roles) {
        for (const Target* target : {&programme.ann, &programme.eve}) {
            const std::string name = cell(Operation::read_attempt, role, *target);
            const bool expected =
                role != Role::station &&
                expected_allowed(Operation::read_attempt, role, programme.relation(role, *target));
            // One attempt is too few for a benchmark: status 1 for those who may read it, refusal for all
            // others.
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
    // create_synthetic and perform_attempt belong to the station; no option gives them to a person.
    std::ostringstream output;
    std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
    // The answer does not say whether somebody has the login.
    const auto refusal = [&](const std::string& login) {
        try {
            run_command({"perform", "A2", "--person", login, "--db", programme.path});
        } catch (const StoreError& error) {
            EXPECT_TRUE(error.is_bad_input());
            std::string words = error.what();
            return words.replace(words.find(login), login.size(), "LOGIN");
        }
        return std::string("performed");
    };
    EXPECT_EQ(refusal("ann"), refusal("nobody"));
    EXPECT_NE(refusal("ann"), "performed");
    for (const Role role : people_roles) {
        std::vector<std::string> words = {"perform", "A2", "--db", programme.path};
        for (const std::string& word : as(role)) words.push_back(word);
        EXPECT_THROW(run_command(words), UsageError) << role_name(role);
    }
    EXPECT_EQ(run_command({"perform", "A2", "--operator", "expert", "--seed", "5", "--person", "synthetic-2",
                           "--db", programme.path}),
              0);
    std::cout.rdbuf(before);
}

}  // namespace
}  // namespace fulcrum::app::program_test
