// SPDX-License-Identifier: GPL-3.0-or-later
// After an exchange everybody follows one version at every station and on the server, whichever row came
// first.
#include "database/records/curricula.h"
#include "database/records/standings.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class FollowedVersions : public Sync {
  protected:
    void SetUp() override {
        Sync::SetUp();
        if (IsSkipped()) return;
        sync(a);
        sync(b);
        sync(a);
    }
    void decide(const Store& store, const Session& educator, const char* login,
                const Curriculum& newest_there) const {
        Standings(store).decide(educator, a.id(login), "A1", StandingOverride::Kind::proficient,
                                "examined in theatre", &newest_there);
    }
    /// At both stations and on the server the same; empty where it is not.
    std::string followed_by(const char* login) const {
        const auto at = [&](const Store& store, const Session& educator) {
            const Curricula curricula(store);
            return curricula.followed(educator, a.id(login), newest).back().name;
        };
        const Store central =
            Store::open(grant_at_programme_server(server, "educator").address, a.clock.options());
        const std::string here = at(*a.store, a.session("educator"));
        EXPECT_EQ(at(*b.store, b.sign_in("educator")), here) << login;
        EXPECT_EQ(at(central, People(central).account_session()), here) << login << " on the server";
        EXPECT_EQ(Curricula(*a.store).people(newest), Curricula(*b.store).people(newest));
        return here;
    }
    Station b;
    Curriculum newest = load_versions(asset_path("curricula"), "rectal", task_ids());
};

TEST_F(FollowedVersions, AreThoseBegunWithBeforeADecisionInWhicheverOrderTheyArrive) {
    // Begun at one station, decided at the other one, which does not know of it yet.
    b.record("ann", 70);  // names no version: the first one
    a.clock.pass_s(60);
    decide(*a.store, a.session("educator"), "ann", newest);
    a.record("ben");
    b.clock.pass_s(120);
    decide(*b.store, b.sign_in("educator"), "ben", newest);
    for (int round = 0; round < 2; ++round) sync(a), sync(b);
    EXPECT_EQ(followed_by("ann"), "rectal@1");
    EXPECT_EQ(followed_by("ben"), "rectal@1");
    expect_sound(*a.store);
    expect_sound(*b.store);
    expect_sound(server);
}

TEST_F(FollowedVersions, OfTwoDecisionsAreThatOfTheEarlier) {
    const Curriculum& older = *newest.version_named("rectal@1");
    decide(*b.store, b.sign_in("educator"), "ann", older);
    a.clock.pass_s(60);
    decide(*a.store, a.session("educator"), "ann", newest);
    for (int round = 0; round < 2; ++round) sync(a), sync(b);
    EXPECT_EQ(followed_by("ann"), "rectal@1");
}

}  // namespace
}  // namespace fulcrum::database::test
