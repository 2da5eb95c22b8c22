// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum db check --against: a head that was printed elsewhere finds an older copy in the store's place, and
// a log that the holder of the station's key wrote again. Nothing else in the check finds either.
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/services/program.h"
#include "database/rows/connection.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::app::program_test {
namespace {

class KnownHead : public ::testing::Test {
  protected:
    KnownHead() { std::ofstream(password_file) << database::test::password << '\n'; }
    void rename_ann(const char* name) const {
        programme.people().rename(administrator, programme.id("ann"), name);
    }
    std::string head() const { return database::Audit(*programme.store).head(); }
    /// The answer of `db check --against`.
    nlohmann::json check(const std::string& known, int wanted) const {
        std::ostringstream output;
        std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
        EXPECT_EQ(run_command({"db", "check", "--db", programme.path, "--against", known, "--simulate", "0",
                               "--json"}),
                  wanted);
        std::cout.rdbuf(before);
        return nlohmann::json::parse(output.str());
    }
    /// Exit status 1 for this head, and no other finding.
    void expect_missed(const std::string& known) const {
        const nlohmann::json report = check(known, 1);
        EXPECT_FALSE(report["ok"]);
        for (const nlohmann::json& item : report["items"])
            EXPECT_EQ(item["ok"], item["name"] != "known head") << item;
        const nlohmann::json& last = report["items"].back();
        ASSERT_EQ(last["problems"].size(), 1U);
        EXPECT_EQ(last["problems"][0], "no audit row has the head " + known +
                                           ": the store was rewritten, or an older copy is in its place");
    }

    database::test::Programme programme;
    const database::Session administrator = programme.session("administrator");
    const std::string password_file = programme.folder.filePath("password.txt").toStdString();
};

TEST_F(KnownHead, FindsAnOlderCopyInTheStoresPlace) {
    const std::string backup = programme.folder.filePath("backup.db").toStdString();
    const std::string earlier = head();
    programme.store->backup(administrator, backup);
    rename_ann("Ann Married");
    const std::string printed = head();
    programme.store.reset();
    EXPECT_TRUE(check(printed, 0)["ok"]);
    ASSERT_EQ(run_command({"db", "restore", backup, "--db", programme.path, "--as", "administrator", "--role",
                           "administrator", "--password-file", password_file}),
              0);
    expect_missed(printed);
    EXPECT_TRUE(check(earlier, 0)["ok"]) << "what the backup has is known";
}

TEST_F(KnownHead, FindsALogThatTheHolderOfTheKeyWroteAgain) {
    const std::int64_t before = database::Audit(*programme.store).count();
    for (const char* name : {"Ann One", "Ann Two", "Ann Three"}) rename_ann(name);
    const std::string printed = head();
    EXPECT_TRUE(check(printed.substr(0, 16), 0)["ok"]);
    database::Connection& connection = programme.store->connection();
    std::vector<std::string> triggers;
    {
        database::Query rows(connection,
                             "SELECT sql FROM sqlite_master WHERE name IN ('audit_entry_stays', "
                             "'audit_signature_stays')");
        while (rows.next()) triggers.push_back(rows.text(0));
    }
    ASSERT_EQ(triggers.size(), 2U);
    for (const char* sql : {"DROP TRIGGER audit_entry_stays", "DROP TRIGGER audit_signature_stays"})
        connection.execute(sql);
    for (const char* table : {"audit_payload", "audit_signature", "audit_entry"})
        database::Query(connection, QStringLiteral("DELETE FROM %1 WHERE sequence > ?").arg(table))
            .bind(before)
            .run();
    for (const std::string& trigger : triggers) connection.execute(QString::fromStdString(trigger));
    database::Audit(*programme.store)
        .append(administrator, programme.id("ann"), "person.rename", "{}",
                {{database::RecordKind::person, programme.id("ann")}});
    expect_missed(printed);
    EXPECT_TRUE(check(head(), 0)["ok"]) << "the log is whole and signed by the station's key";
}

}  // namespace
}  // namespace fulcrum::app::program_test
