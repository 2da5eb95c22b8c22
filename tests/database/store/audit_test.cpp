// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "database/rows/connection.h"
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
    static AuditFilter newest(int limit) {
        AuditFilter filter;
        filter.limit = limit;
        return filter;
    }
    std::vector<std::string> problems() const { return english_of(Audit(*programme.store).verify()); }
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
    const auto entries = audit.entries(programme.session("administrator"), newest(2));
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
    const Session& administrator = programme.session("administrator");
    Audit(*programme.store)
        .erase_payloads(administrator, {3}, "the person left",
                        {{RecordKind::person, programme.id("director")}});
    EXPECT_TRUE(problems().empty());
    for (const AuditEntry& entry : Audit(*programme.store).entries(programme.session("administrator"))) {
        EXPECT_EQ(entry.payload == "payload erased", entry.sequence == 3) << entry.sequence;
    }
}

TEST_F(AuditChain, APayloadThatIsGoneWithoutAnErasureIsNamed) {
    tamper("DELETE FROM audit_payload WHERE sequence IN (3, 5)");
    Audit(*programme.store).erase_payloads(programme.session("administrator"), {5}, "the person left", {});
    ASSERT_EQ(problems().size(), 1U);
    EXPECT_NE(problems()[0].find("audit row 3: its payload is gone"), std::string::npos);
    EXPECT_FALSE(programme.store->check(programme.session("station")).ok);
}

TEST_F(AuditChain, ContainsNoScores) {
    programme.record("ann", true, 73.25);
    for (const AuditEntry& entry : Audit(*programme.store).entries(programme.session("administrator"))) {
        EXPECT_EQ(entry.payload.find("73.25"), std::string::npos);
        EXPECT_EQ(entry.payload.find("passed"), std::string::npos);
    }
}

TEST_F(AuditChain, FindsByPersonKindAndPeriodAPageAtATime) {
    const Session& administrator = programme.session("administrator");
    const std::string attempt = programme.record("ann");
    programme.clock.pass_s(3600);
    programme.attempts().request_correction(programme.session("ann"), attempt, "this was not me");
    programme.clock.pass_s(3600);
    programme.attempts().void_attempt(programme.session("educator"), attempt, "a slip of the tongue");
    const Audit audit(*programme.store);
    const auto operations = [&](const AuditFilter& filter) {
        std::vector<std::string> list;
        for (const AuditEntry& entry : audit.entries(administrator, filter)) list.push_back(entry.operation);
        return list;
    };
    AuditFilter of_ann;
    of_ann.person_id = programme.id("ann");
    of_ann.kind = "attempt";
    const std::vector<std::string> about = {"attempt.void", "attempt.request_correction", "attempt.finish",
                                            "attempt.begin"};
    EXPECT_EQ(operations(of_ann), about) << "done by her, and to what is hers";
    of_ann.kind = "attempt.void";
    EXPECT_EQ(operations(of_ann), std::vector<std::string>{"attempt.void"});
    of_ann.kind = "attem";
    EXPECT_TRUE(operations(of_ann).empty()) << "a group is a whole word";
    AuditFilter hour;
    hour.from = noon + 3600 * 1000;
    hour.until = noon + 7200 * 1000;
    EXPECT_EQ(operations(hour), std::vector<std::string>{"attempt.request_correction"});
    AuditFilter page = newest(3);
    std::int64_t expected = audit.count();
    while (expected > 0) {
        const auto entries = audit.entries(administrator, page);
        ASSERT_FALSE(entries.empty());
        for (const AuditEntry& entry : entries) EXPECT_EQ(entry.sequence, expected--);
        page.before_sequence = entries.back().sequence;
    }
    EXPECT_TRUE(audit.entries(administrator, page).empty());
}

TEST_F(AuditChain, NamesPersonRoleAndSubjectAndWithholdsCommentsOnAttempts) {
    const Session& administrator = programme.session("administrator");
    const std::string attempt = programme.record("ann");
    programme.attempts().request_correction(programme.session("ann"), attempt, "this was not me");
    const std::string comment =
        Reviews(*programme.store).write(programme.session("educator"), attempt, 1, "Look here.", true);
    programme.attempts().void_attempt(programme.session("educator"), attempt, "a slip of the tongue");
    const Audit audit(*programme.store);
    const auto entries = audit.entries(administrator);
    for (const AuditEntry& entry : entries) {
        for (const char* words : {"this was not me", "a slip of the tongue", "Look here.", "completed"})
            EXPECT_EQ(entry.payload.find(words), std::string::npos) << entry.operation << entry.payload;
    }
    EXPECT_EQ(entries[0].operation, "attempt.void");
    EXPECT_EQ(entries[0].actor_name, "Edu Cator");
    EXPECT_EQ(entries[0].role, "educator");
    EXPECT_EQ(entries[0].person_name, "Ann Trainee");
    EXPECT_NE(entries[0].payload.find("withheld"), std::string::npos);
    EXPECT_EQ(entries[1].object_id, comment);
    EXPECT_EQ(entries[1].person_name, "Ann Trainee") << "whose attempt it is about";
    EXPECT_EQ(entries[2].role, "trainee");
    EXPECT_EQ(entries.back().operation, "store.create");
    EXPECT_EQ(entries.back().role, "station");
    for (const char* login : {"ann", "educator", "director", "station"}) {
        EXPECT_THROW(audit.entries(programme.session(login)), AccessDenied);
        EXPECT_THROW(audit.kinds(programme.session(login)), AccessDenied);
    }
    const auto kinds = audit.kinds(administrator);
    EXPECT_TRUE(std::is_sorted(kinds.begin(), kinds.end()));
    EXPECT_NE(std::find(kinds.begin(), kinds.end(), "attempt.void"), kinds.end());
}

TEST_F(AuditChain, APayloadThatIsNotARecordReadsUnreadable) {
    tamper("UPDATE audit_payload SET payload = 'reason: secret' WHERE sequence = 3");
    for (const AuditEntry& entry : Audit(*programme.store).entries(programme.session("administrator")))
        EXPECT_EQ(entry.payload == "unreadable", entry.sequence == 3) << entry.sequence;
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
