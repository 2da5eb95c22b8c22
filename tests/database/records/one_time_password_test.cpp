// SPDX-License-Identifier: GPL-3.0-or-later
// Which one-time passwords are this station's own: how long its machine has run counts for these alone.
#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

/// What an exchange brings of a password that another station issued at this moment.
void receive_password(const Programme& programme, const std::string& person, const std::string& verifier) {
    Query(programme.store->connection(),
          "UPDATE credential SET verifier = ?, one_time = 1, boot = 'another machine', boot_ms = 0 WHERE "
          "person_id = ?")
        .bind(verifier)
        .bind(person)
        .run();
    Audit(*programme.store)
        .append(programme.store->station_session(), programme.store->station_id(), "sync.receive", "{}",
                {{RecordKind::person, person}});
}

void expect_expired(const Programme& programme, const std::string& code) {
    try {
        programme.people().sign_in("ann", code);
        ADD_FAILURE() << "not refused";
    } catch (const SignInRefused& refused) {
        EXPECT_EQ(refused.reason(), SignInRefused::Reason::expired);
    }
}

TEST(OneTimePassword, IsKnownAsTheOneIssuedHereByTheRowThatNamesIt) {
    Programme programme;
    constexpr double over_a_day_s = 25 * 3600;
    const std::string ann = programme.id("ann"), elsewhere = "issued elsewhere";
    const std::string here =
        programme.people().issue_one_time_password(programme.session("administrator"), ann);
    std::string verifier;
    {
        Query row(programme.store->connection(), "SELECT verifier FROM credential WHERE person_id = ?");
        row.bind(ann);
        ASSERT_TRUE(row.next());
        verifier = row.text(0);
    }
    const auto log = Audit(*programme.store).entries(programme.session("administrator"));
    EXPECT_EQ(log.front().payload, "{}") << "nothing of it is shown";
    // Another station issues one within the same seconds; how long this machine has run says nothing of it.
    receive_password(programme, ann, make_verifier(elsewhere));
    programme.clock.since_boot->ms += static_cast<std::int64_t>(over_a_day_s * 1000);
    EXPECT_NO_THROW(programme.people().sign_in("ann", elsewhere));
    // The first one comes back with the account: it is older than a day by this machine, whatever the clock.
    receive_password(programme, ann, verifier);
    expect_expired(programme, here);
}

TEST(OneTimePassword, IssuedByAnOlderProgramIsThisStationsUntilTheAccountComesFromElsewhere) {
    Programme programme;
    const std::string ann = programme.id("ann");
    const std::string code =
        programme.people().issue_one_time_password(programme.session("administrator"), ann);
    programme.store->connection().execute(
        "UPDATE audit_payload SET payload = replace(payload, '\"verifier\"', '\"before\"')");
    EXPECT_NO_THROW(programme.people().sign_in("ann", code));
    programme.clock.since_boot->ms += 25LL * 3600 * 1000;
    expect_expired(programme, code);
}

}  // namespace
}  // namespace fulcrum::database::test
