// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/connection.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

class AuditChain : public ::testing::Test {
  protected:
    void tamper(const char* sql) {
        Connection& connection = programme.store->connection();
        connection.execute(
            "DROP TRIGGER IF EXISTS audit_entry_is_fixed; DROP TRIGGER IF EXISTS audit_entry_stays");
        connection.execute("PRAGMA foreign_keys = OFF");
        connection.execute(sql);
        connection.execute("PRAGMA foreign_keys = ON");
    }
    std::vector<std::string> problems() const { return Audit(*programme.store).verify(); }
    Programme programme;
};

TEST_F(AuditChain, HoldsAndGrowsWithEveryDeed) {
    const Audit audit(*programme.store);
    EXPECT_TRUE(audit.verify().empty());
    const std::string before = audit.head();
    const std::int64_t count = audit.count();
    EXPECT_GT(count, 10);
    programme.people().rename(programme.session("administrator"), programme.id("ann"), "Ann Married");
    EXPECT_EQ(audit.count(), count + 1);
    EXPECT_NE(audit.head(), before);
    EXPECT_EQ(audit.head().size(), 64U);
    const auto entries = audit.entries(programme.session("administrator"), 2);
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].operation, "person.rename");
    EXPECT_EQ(entries[0].actor_name, "Ada Min");
    EXPECT_EQ(entries[0].object_id, programme.id("ann"));
    EXPECT_EQ(entries[0].previous_hash, entries[1].hash);
    EXPECT_NE(entries[0].payload.find("Ann Married"), std::string::npos);
    EXPECT_TRUE(audit.verify().empty());
}

TEST_F(AuditChain, NamesAChangedRow) {
    for (const char* sql : {"UPDATE audit_entry SET time = time + 1 WHERE sequence = 4",
                            "UPDATE audit_entry SET actor_id = 'x' WHERE sequence = 4",
                            "UPDATE audit_entry SET object_id = 'x' WHERE sequence = 4",
                            "UPDATE audit_entry SET operation = 'sign_in' || operation WHERE sequence = 4",
                            "UPDATE audit_entry SET digest = zeroblob(32) WHERE sequence = 4",
                            "UPDATE audit_entry SET hash = zeroblob(32) WHERE sequence = 4",
                            "UPDATE audit_entry SET previous_hash = zeroblob(32) WHERE sequence = 4",
                            "UPDATE audit_payload SET payload = '{}x' WHERE sequence = 4",
                            "UPDATE audit_payload SET salt = zeroblob(32) WHERE sequence = 4"}) {
        Transaction undone(programme.store->connection());
        programme.store->connection().execute("DROP TRIGGER audit_entry_is_fixed");
        programme.store->connection().execute(sql);
        const auto found = problems();
        ASSERT_FALSE(found.empty()) << sql;
        EXPECT_NE(found[0].find('4'), std::string::npos) << found[0];
    }
    EXPECT_TRUE(problems().empty());
}

TEST_F(AuditChain, NamesAMissingRow) {
    tamper("DELETE FROM audit_payload WHERE sequence = 5; DELETE FROM audit_entry WHERE sequence = 5");
    const auto found = problems();
    ASSERT_FALSE(found.empty());
    EXPECT_NE(found[0].find("missing"), std::string::npos);
    EXPECT_FALSE(programme.store->check(programme.session("station")).ok);
}

TEST_F(AuditChain, SwappedRowsAreNoticed) {
    tamper(
        "UPDATE audit_payload SET sequence = -1 WHERE sequence = 2; UPDATE audit_payload SET sequence = 2 "
        "WHERE sequence = 3;"
        "UPDATE audit_payload SET sequence = 3 WHERE sequence = -1");
    EXPECT_EQ(problems().size(), 2U);
}

TEST_F(AuditChain, AnErasedPayloadReadsErasedAndTheChainHolds) {
    tamper("DELETE FROM audit_payload WHERE sequence = 3");
    EXPECT_TRUE(problems().empty());
    for (const AuditEntry& entry : Audit(*programme.store).entries(programme.session("administrator"))) {
        EXPECT_EQ(entry.payload == "payload erased", entry.sequence == 3) << entry.sequence;
    }
}

TEST_F(AuditChain, TellsNoScores) {
    programme.record("ann", true, 73.25);
    for (const AuditEntry& entry : Audit(*programme.store).entries(programme.session("administrator"))) {
        EXPECT_EQ(entry.payload.find("73.25"), std::string::npos);
        EXPECT_EQ(entry.payload.find("passed"), std::string::npos);
    }
}

TEST_F(AuditChain, ARolledBackDeedLeavesNoRow) {
    const std::int64_t count = Audit(*programme.store).count();
    EXPECT_THROW(programme.people().set_members(programme.session("director"), programme.cohort,
                                                {programme.id("ann"), "nobody"}),
                 StoreError);
    EXPECT_EQ(Audit(*programme.store).count(), count);
    EXPECT_EQ(programme.people().find_cohort(programme.session("director"), "Year 1")->members.size(), 2U);
}

}  // namespace
}  // namespace fulcrum::database::test
