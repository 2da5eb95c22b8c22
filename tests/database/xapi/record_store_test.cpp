// SPDX-License-Identifier: GPL-3.0-or-later
// Sending to a record store that answers 200, 409, 400, an error, or nothing: what is done, what waits and
// for how long, what somebody has to look at; and killed in the middle nothing is lost or sent under another
// id.
#include "database/xapi/record_store.h"

#include <gtest/gtest.h>
#include <signal.h>

#include "database/records/person_merge.h"
#include "database/sync/erasure.h"
#include "sim_core/numerics/input_error.h"
#include "tests/database/processes.h"
#include "tests/database/programme_fixture.h"
#include "tests/database/xapi/fake_record_store.h"

namespace fulcrum::database::test {
namespace {

std::string example_id(int number) {
    const std::string digits = std::to_string(number);
    return "6f1f3bd0-0000-4000-8000-" + std::string(12 - digits.size(), '0') + digits;
}
std::string example_statement(int number, double scaled = 0.5) {
    return R"({"id": ")" + example_id(number) +
           R"(", "actor": {"account": {"homePage": "https://training.example", "name": "p"}}, "verb": {"id": )"
           R"("http://adlnet.gov/expapi/verbs/passed", "display": {"en-US": "passed"}}, "result": {"score": )"
           R"({"scaled": )" +
           std::to_string(scaled) + R"(}}, "timestamp": "2026-11-25T10:00:00Z", "version": "1.0.3"})";
}

class RecordStoreTest : public ::testing::Test {
  protected:
    void add(int count, int from = 0) {
        std::vector<OutboxStatement> statements;
        for (int i = from; i < from + count; ++i) {
            OutboxStatement one;
            one.id = example_id(i);
            one.person_id = programme.id("ann");
            one.text = example_statement(i);
            statements.push_back(one);
        }
        outbox().add(statements);
    }
    XapiOutbox outbox() const {
        return XapiOutbox(*programme.store, programme.session("director"), lrs.address());
    }
    SendResult send(int timeout_ms = 300) const {
        RecordStore record_store(lrs.address(), "key:secret", timeout_ms);
        return send_waiting(outbox(), record_store);
    }
    Programme programme;
    FakeRecordStore lrs;
};

TEST_F(RecordStoreTest, TakesWhatWaitsOnceWithVersionAndCredentials) {
    add(3);
    add(3);  // the same ids
    EXPECT_EQ(outbox().counts().waiting, 3);
    const SendResult result = send();
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.sent, 3);
    ASSERT_EQ(lrs.requests.size(), 3U);
    for (const HttpRequest& request : lrs.requests) {
        EXPECT_EQ(request.method, "POST");
        EXPECT_EQ(request.target, "/xapi/statements");
        EXPECT_EQ(request.headers.at("x-experience-api-version"), "1.0.3");
        EXPECT_EQ(request.headers.at("authorization"), "Basic a2V5OnNlY3JldA==");
    }
    EXPECT_EQ(lrs.statements.at(example_id(1)), example_statement(1)) << "byte for byte";
    EXPECT_EQ(outbox().counts().done, 3);
    add(4);
    EXPECT_EQ(send().sent, 1) << "what is done is not sent again";
    EXPECT_EQ(lrs.requests.size(), 4U);
}

TEST_F(RecordStoreTest, ThatHasTheStatementAlreadyIsDoneIfItIsTheSame) {
    add(2);
    // It writes times in another way, adds members and other words, and has the second one with another
    // score.
    lrs.statements[example_id(0)] =
        R"({"stored": "2026-11-25T10:00:01.123Z", "authority": {"name": "lrs"}, "id": ")" + example_id(0) +
        R"(", "actor": {"objectType": "Agent", "account": {"name": "p", "homePage": )"
        R"("https://training.example"}}, "verb": {"id": "http://adlnet.gov/expapi/verbs/passed", "display": )"
        R"({"en-US": "has passed"}}, "result": {"score": {"scaled": 0.5}}, "timestamp": )"
        R"("2026-11-25T10:00:00.000Z", "version": "1.0.0"})";
    lrs.statements[example_id(1)] = example_statement(1, 0.75);
    const SendResult result = send();
    EXPECT_EQ(result.known, 1);
    EXPECT_EQ(result.quarantined, 1);
    ASSERT_EQ(outbox().quarantined().size(), 1U);
    EXPECT_EQ(outbox().quarantined()[0].id, example_id(1));
    EXPECT_NE(outbox().quarantined()[0].problem.find("another statement"), std::string::npos);
    EXPECT_EQ(send().sent + send().quarantined, 0) << "never sent again";
    EXPECT_EQ(outbox().release(), 1) << "somebody has looked at it";
    lrs.statements.erase(example_id(1));
    EXPECT_EQ(send().sent, 1);
}

TEST_F(RecordStoreTest, ThatRefusesAStatementQuarantinesThatOneOnly) {
    add(3);
    lrs.instead = [](const HttpRequest& request) {
        return request.body.find(example_id(1)) != std::string::npos ? 400 : 0;
    };
    lrs.words = "score.scaled is out of range";
    const SendResult result = send();
    EXPECT_EQ(result.sent, 2);
    EXPECT_EQ(result.quarantined, 1);
    EXPECT_EQ(outbox().quarantined().at(0).problem, "HTTP 400: score.scaled is out of range");
}

TEST_F(RecordStoreTest, ThatDoesNotAnswerIsAskedAgainAfterGrowingWaits) {
    add(5);
    lrs.instead = [](const HttpRequest&) { return -1; };
    SendResult result = send(100);
    EXPECT_EQ(result.postponed, 3) << "after three failures in a row it is left for now";
    EXPECT_FALSE(result.complete);
    EXPECT_EQ(outbox().counts().waiting, 5);
    EXPECT_EQ(outbox().next()->id, example_id(3)) << "the others were not tried yet";
    lrs.instead = [](const HttpRequest&) { return 0; };
    EXPECT_EQ(send().sent, 2);
    EXPECT_FALSE(outbox().next()) << "the first three wait for a minute";
    programme.clock.pass_s(59);
    EXPECT_FALSE(outbox().next());
    programme.clock.pass_s(1);
    lrs.instead = [](const HttpRequest&) { return 503; };
    EXPECT_EQ(send().postponed, 3);
    programme.clock.pass_s(60);
    EXPECT_FALSE(outbox().next()) << "two minutes after the second failure";
    programme.clock.pass_s(60);
    ASSERT_TRUE(outbox().next());
    EXPECT_EQ(outbox().next()->tries, 2);
    EXPECT_NE(outbox().next()->problem.find("503"), std::string::npos);
    lrs.instead = [](const HttpRequest&) { return -3; };  // cut off
    EXPECT_EQ(send().postponed, 3);
    programme.clock.pass_s(240);
    lrs.instead = [](const HttpRequest&) { return 0; };
    EXPECT_EQ(send().sent, 3);
    EXPECT_EQ(outbox().counts().done, 5);
    EXPECT_EQ(outbox_wait_ms(1), 60'000);
    EXPECT_EQ(outbox_wait_ms(4), 480'000);
    EXPECT_EQ(outbox_wait_ms(1000), 12 * 3'600'000);
}

TEST_F(RecordStoreTest, IsAskedAgainInTimeAlsoWhereTheClockWasAhead) {
    constexpr double year_s = 365 * 86400.0;
    programme.clock.set_forward_s(year_s);
    add(1);
    lrs.instead = [](const HttpRequest&) { return 503; };
    EXPECT_EQ(send().postponed, 1);
    EXPECT_GT(outbox().counts().next_try, noon);
    EXPECT_FALSE(outbox().next());
    programme.clock.set_forward_s(-year_s);
    EXPECT_EQ(outbox().counts().next_try, 0) << "due";
    EXPECT_EQ(outbox_counts(*programme.store, programme.session("director")).at(0).next_try, 0);
    EXPECT_EQ(send().postponed, 1);
    EXPECT_EQ(outbox().counts().next_try, noon + outbox_wait_ms(2)) << "by the clock that was put right";
    EXPECT_FALSE(outbox().next());
    programme.clock.pass_s(120);
    lrs.instead = [](const HttpRequest&) { return 0; };
    EXPECT_EQ(send().sent, 1);
}

TEST_F(RecordStoreTest, ThatAsksForLessIsLeftUntilItSays) {
    add(2);
    lrs.instead = [](const HttpRequest&) { return 429; };
    lrs.extra = "Retry-After: 600\r\n";
    EXPECT_EQ(send().postponed, 1);
    lrs.instead = [](const HttpRequest&) { return 0; };
    lrs.extra.clear();
    EXPECT_EQ(send().sent, 1) << "other attempt";
    programme.clock.pass_s(599);
    EXPECT_EQ(send().sent, 0);
    programme.clock.pass_s(1);
    EXPECT_EQ(send().sent, 1);
}

TEST_F(RecordStoreTest, AnAnswerThatWasLostIsAskedForByTheSameId) {
    add(1);
    lrs.instead = [](const HttpRequest&) { return -2; };  // taken, but the answer never comes
    EXPECT_EQ(send(100).postponed, 1);
    programme.clock.pass_s(60);
    lrs.instead = [](const HttpRequest&) { return 0; };
    EXPECT_EQ(send().known, 1);
    EXPECT_EQ(lrs.statements.size(), 1U);
}

TEST_F(RecordStoreTest, ThatRefusesTheCredentialsStopsWithoutAWait) {
    add(2);
    for (const int status : {401, 403}) {
        lrs.instead = [=](const HttpRequest&) { return status; };
        EXPECT_EQ(error_kind([&] { send(); }), StoreErrorKind::failed);
        EXPECT_EQ(outbox().next()->tries, 0);
    }
    lrs.instead = [](const HttpRequest&) { return 302; };
    lrs.extra = "Location: http://127.0.0.1:1/elsewhere\r\n";
    EXPECT_EQ(send().postponed, 2) << "credentials do not follow to another address";
}

TEST_F(RecordStoreTest, CanBeStoppedBetweenTwoStatements) {
    add(4);
    RecordStore record_store(lrs.address(), "", 300);
    int asked = 0;
    const SendResult result = send_waiting(outbox(), record_store, [&] { return ++asked > 2; });
    EXPECT_EQ(result.sent, 2);
    EXPECT_FALSE(result.complete);
    EXPECT_EQ(outbox().counts().waiting, 2);
    EXPECT_EQ(lrs.requests[0].headers.count("authorization"), 0U);
}

TEST_F(RecordStoreTest, IsTheDirectorsToUseAndItsAddressIsOneOfTheWeb) {
    for (const char* login : {"ann", "educator", "administrator", "station"}) {
        EXPECT_THROW(XapiOutbox(*programme.store, programme.session(login), lrs.address()), AccessDenied)
            << login;
        EXPECT_THROW(outbox_counts(*programme.store, programme.session(login)), AccessDenied) << login;
    }
    for (const char* wrong : {"", "lrs", "ftp://lrs.example/xapi", "http://lrs.example/xapi",
                              "https://key:secret@lrs.example/xapi", "https://lrs.example/xapi?a=b",
                              "https://", "http://127.0.0.1.evil.example/"})
        EXPECT_THROW(record_store_address(wrong), InputError) << wrong;
    EXPECT_EQ(record_store_address("https://lrs.example/xapi/"), "https://lrs.example/xapi");
    EXPECT_EQ(record_store_address("http://localhost:8080/xapi"), "http://localhost:8080/xapi");
    add(1);
    const std::vector<OutboxCounts> counts = outbox_counts(*programme.store, programme.session("director"));
    ASSERT_EQ(counts.size(), 1U);
    EXPECT_EQ(counts[0].endpoint, lrs.address());
    EXPECT_EQ(counts[0].waiting, 1);
}

TEST_F(RecordStoreTest, IsSentNothingOfAPersonWhoWasErased) {
    add(2);
    send();
    add(2, 2);
    ASSERT_TRUE(erase_at_station(*programme.store, programme.id("ann"), programme.store->station_session(),
                                 "asked for it"));
    EXPECT_EQ(outbox().counts().waiting + outbox().counts().done, 0);
    EXPECT_EQ(send().sent, 0);
    EXPECT_EQ(lrs.requests.size(), 2U);
}

TEST_F(RecordStoreTest, IsSentNothingOfAPersonWhoWasErasedAfterAMergeByMistakeWasUndone) {
    const std::string bens = programme.record("ben");
    const PersonMerge merge(*programme.store);
    const Session& administrator = programme.session("administrator");
    merge.merge(administrator, programme.id("ben"), programme.id("ann"), "entered twice");
    OutboxStatement one;
    one.id = example_id(0);
    one.person_id = programme.id("ann");  // whose attempt it is while they are merged
    one.attempt_id = bens;
    one.text = example_statement(0);
    EXPECT_EQ(outbox().add({one}), 1);
    merge.undo(administrator, programme.id("ben"), "another person after all");
    ASSERT_TRUE(erase_at_station(*programme.store, programme.id("ben"), programme.store->station_session(),
                                 "asked for it"));
    EXPECT_EQ(outbox().counts().waiting, 0);
    EXPECT_EQ(outbox().add({one}), 0) << "the attempt is gone";
    EXPECT_EQ(send().sent, 0);
}

TEST_F(RecordStoreTest, AStatementThatAnOlderProgramQueuedForTheOtherAccountOfAMergeGoesBackToItsOwner) {
    const std::string bens = programme.record("ben");
    OutboxStatement one;
    one.id = example_id(0);
    one.person_id = programme.id("ann");
    one.text = example_statement(0);
    EXPECT_EQ(outbox().add({one}), 1);  // without its attempt, as before
    one.person_id = programme.id("ben");
    one.attempt_id = bens;
    EXPECT_EQ(outbox().add({one}), 0);
    EXPECT_EQ(outbox().counts().waiting, 1);
    ASSERT_TRUE(erase_at_station(*programme.store, programme.id("ben"), programme.store->station_session(),
                                 "asked for it"));
    EXPECT_EQ(outbox().counts().waiting, 0);
    EXPECT_EQ(send().sent, 0);
}

TEST_F(RecordStoreTest, QueuesNothingOfAPersonWhoWasErasedWhileTheStatementsWereMade) {
    std::vector<OutboxStatement> statements;
    for (const char* login : {"ann", "ben"}) {
        OutboxStatement one;
        const int number = static_cast<int>(statements.size());
        one.id = example_id(number);
        one.person_id = programme.id(login);
        one.text = example_statement(number);
        statements.push_back(one);
    }
    ASSERT_TRUE(erase_at_station(*programme.store, programme.id("ann"), programme.store->station_session(),
                                 "asked for it"));
    EXPECT_EQ(outbox().add(statements), 1);
    EXPECT_EQ(outbox().counts().waiting, 1);
    const auto next = outbox().next();
    ASSERT_TRUE(next);
    EXPECT_EQ(next->person_id, programme.id("ben"));
}

TEST_F(RecordStoreTest, KilledAnywhereNothingIsLostOrSentUnderAnotherId) {
    constexpr int statements = 40;
    add(statements);
    const std::string folder = programme.folder.path().toStdString();
    programme.store.reset();
    int killed = 0;
    for (int round = 0; round < 12; ++round) {
        // Before the statement is taken, or after it and before the answer.
        const bool taken = round % 2 == 0;
        int left = 1 + round % 4;
        pid_t child = start_child("xapi", folder, lrs.port());
        lrs.instead = [&](const HttpRequest& request) {
            if (request.method != "POST" || --left > 0) return 0;
            ::kill(child, SIGKILL);
            return taken ? -2 : -1;
        };
        while (is_running(child)) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
        if (left <= 0) ++killed;
    }
    EXPECT_EQ(killed, 12);
    programme.open();
    EXPECT_EQ(outbox().counts().waiting + outbox().counts().done, statements);
    lrs.instead = [](const HttpRequest&) { return 0; };
    const SendResult result = send();
    EXPECT_TRUE(result.complete);
    EXPECT_GT(result.known + result.sent, 0);
    EXPECT_EQ(outbox().counts().done, statements);
    ASSERT_EQ(lrs.statements.size(), static_cast<std::size_t>(statements));
    for (int i = 0; i < statements; ++i)
        EXPECT_EQ(lrs.statements.at(example_id(i)), example_statement(i)) << i;
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
}

}  // namespace
}  // namespace fulcrum::database::test
