// SPDX-License-Identifier: GPL-3.0-or-later
// A server that writes its messages in another language: what it refuses is found by its codes.
#include "database/rows/server_refusal.h"
#include "database/sync/enrolment.h"
#include "database/sync/enrolment_token.h"
#include "database/sync/server_enrolment.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

TEST(ServerRefusals, AreReadFromTheCodesOfAnyLanguage) {
    const std::pair<const char*, ServerRefusal> messages[] = {
        {"connection to server on socket \"/s\" failed: FATAL:  28P01: password authentication failed for "
         "user \"x\"\nLOCATION:  auth_failed, auth.c:337\n",
         ServerRefusal::password},
        {"Verbindung zum Server auf Socket »/s« fehlgeschlagen: FATAL:  28P01: Passwort-Authentifizierung "
         "für Benutzer »x« fehlgeschlagen\nORT:  auth_failed, auth.c:337\n",
         ServerRefusal::password},
        {"FATAL:  28000: Rolle »x« existiert nicht\nORT:  InitializeSessionUserId, miscinit.c:509\n",
         ServerRefusal::account},
        {"FATAL:  28000: kein pg_hba.conf-Eintrag für Host »::1«\nORT:  ClientAuthentication, auth.c:530\n",
         ServerRefusal::rule},
        {"FATAL:  3D000: la base de données « x » n'existe pas\nEMPLACEMENT : InitPostgres, "
         "postinit.c:1005\n",
         ServerRefusal::database},
        {"FATAL:  53300: sorry, too many clients already\nLOCATION:  InitProcess, proc.c:361\n",
         ServerRefusal::none},
        {"connection to server on socket \"/nowhere/.s.PGSQL.5432\" failed: No such file or directory",
         ServerRefusal::none},
        {"FATAL:  28P0", ServerRefusal::none},
        {"", ServerRefusal::none},
    };
    for (const auto& [message, why] : messages) EXPECT_EQ(refusal_in(message), why) << message;
}

class ServerLanguages : public Sync {
  protected:
    void SetUp() override {
        Sync::SetUp();
        if (!server.host.empty()) PostgresqlServer::of_this_process()->write_german(true);
    }
    void TearDown() override {
        if (!server.host.empty()) PostgresqlServer::of_this_process()->write_german(false);
    }
    static ServerRefusal refusal(const ServerAddress& at, const std::string& with, std::string& said) {
        try {
            const Connection connection(at, false, with);
            ADD_FAILURE() << "not refused: " << at.text();
        } catch (const ConnectError& error) {
            said = error.what();
            return error.why();
        }
        return ServerRefusal::none;
    }
    const KeysOfOneTest keys;
};

TEST_F(ServerLanguages, ARefusalIsKnownByItsCodeAndSaysWhatToDo) {
    std::string said;
    EXPECT_EQ(refusal(PostgresqlServer::as(server, "nobody"), {}, said), ServerRefusal::account);
    EXPECT_NE(said.find("name the account"), std::string::npos) << said;
    ServerAddress elsewhere = server;
    elsewhere.database = "nothing";
    EXPECT_EQ(refusal(elsewhere, {}, said), ServerRefusal::database);
    EXPECT_NE(said.find("createdb"), std::string::npos) << said;
    elsewhere.host = "/nowhere";
    EXPECT_EQ(refusal(elsewhere, {}, said), ServerRefusal::none);
    EXPECT_NE(said.find("nothing is lost"), std::string::npos) << said;
    EXPECT_EQ(refusal(PostgresqlServer::as(server, "station"), "wrong", said), ServerRefusal::password);
    EXPECT_NE(said.find("pgpass"), std::string::npos) << said;
    if (said.find("password authentication failed") != std::string::npos)
        GTEST_SKIP() << "the German messages of PostgreSQL are not installed";
}

TEST_F(ServerLanguages, AWrongPasswordAtTheLockIsAWrongPassword) {
    sync(a);
    const ServerAddress director =
        ServerAddress::parse(grant_at_programme_server(server, "director").address);
    const std::string account = '"' + a.id("director") + '"';
    // The tests' server asks members of this group for their password.
    PostgresqlServer::of_this_process()->execute(
        server, "ALTER ROLE " + account + " PASSWORD 'the right one'; GRANT fulcrum_enrol TO " + account);
    qputenv("PGPASSWORD", "the right one");
    const Store store = Store::open(director.text(), a.clock.options());
    EXPECT_EQ(People(store).sign_in("Director", "the right one").login(), "director");
    try {
        People(store).sign_in("Director", "another one");
        ADD_FAILURE() << "not refused";
    } catch (const SignInRefused& refused) {
        EXPECT_EQ(refused.reason(), SignInRefused::Reason::wrong);
    } catch (const StoreError& error) {
        ADD_FAILURE() << error.what();
    }
    qunsetenv("PGPASSWORD");
    // Accounts are the server's, also those of the tests that follow.
    PostgresqlServer::of_this_process()->execute(server, "REVOKE fulcrum_enrol FROM " + account);
}

TEST_F(ServerLanguages, ATokenThatTheServerDoesNotKnowIsRefusedAsSuch) {
    const std::string made = make_enrolment_token(server, "lab", {}, usual_token_h).text;
    EnrolmentToken guessed = EnrolmentToken::parse(made);
    guessed.secret = std::string(20, 'a');  // the account is there, with another password
    EnrolmentToken elsewhere = guessed;
    elsewhere.id = "0123456789";  // no such account
    for (const EnrolmentToken& token : {guessed, elsewhere}) {
        try {
            enrol_station(*a.store, a.session("administrator"), server, token.text());
            ADD_FAILURE() << "not refused";
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), StoreErrorKind::conflict) << error.what();
            EXPECT_NE(std::string(error.what()).find("does not know this token"), std::string::npos)
                << error.what();
        }
    }
    EXPECT_FALSE(enrol_station(*a.store, a.session("administrator"), server, made).address.user.empty());
}

}  // namespace
}  // namespace fulcrum::database::test
