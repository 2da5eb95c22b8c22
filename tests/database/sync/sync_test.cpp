// SPDX-License-Identifier: GPL-3.0-or-later
// Two stations and a programme server: what each ends with.
#include "database/records/standings.h"
#include "database/records/stations.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

TEST_F(Sync, TwoStationsEndWithTheSameAndEveryCheckHolds) {
    const std::string by_a = fill(a);
    a.open();  // closes the attempt that was cut off
    const SyncResult first = sync(a);
    EXPECT_TRUE(first.complete);
    EXPECT_TRUE(first.conflicts.empty());
    EXPECT_GT(first.audit_rows, 0);

    const Station b;
    const SyncResult brought = sync(b);
    EXPECT_EQ(b.store->programme_name(), "Test programme");
    EXPECT_TRUE(std::any_of(brought.counts.begin(), brought.counts.end(),
                            [](const SyncCount& one) { return one.title == "attempts" && one.pulled == 3; }));
    const std::string by_b = b.record("ann", 77);  // with her password: the verifier came too
    sync(b);
    sync(a);
    EXPECT_EQ(rows_at(*a.store), rows_at(*b.store));
    EXPECT_EQ(rows_at(*a.store), rows_on(server, false));

    // Ann sees both attempts at both stations, with the points.
    for (const auto& [store, session] :
         {std::make_pair(a.store.get(), a.session("ann")), std::make_pair(b.store.get(), b.sign_in("ann"))}) {
        const Attempts attempts(*store);
        EXPECT_EQ(attempts.score(session, by_a)->points, 81);
        EXPECT_EQ(attempts.score(session, by_b)->points, 77);
    }
    expect_sound(*a.store);
    expect_sound(*b.store);
    expect_sound(server);

    // The trace is where it was recorded; elsewhere nothing is made of its absence.
    const Session educator = b.sign_in("educator");
    EXPECT_EQ(error_kind([&] { Attempts(*b.store).read_trace(educator, by_a); }), StoreErrorKind::not_found);
    EXPECT_EQ(a.attempts().read_trace(a.session("educator"), by_a).samples.size(), 1000U);
    EXPECT_EQ(a.attempts().interrupted_without_score(a.session("educator")).size(), 1U);
    EXPECT_EQ(Attempts(*b.store).interrupted_without_score(educator).size(), 0U);
}

TEST_F(Sync, AStationKnowsThoseWhoseAttemptsItHas) {
    const Session administrator = a.session("administrator");
    const std::vector<KnownStation> alone = known_stations(*a.store, administrator);
    ASSERT_EQ(alone.size(), 1U);
    EXPECT_TRUE(alone[0].own);
    EXPECT_EQ(alone[0].id, a.store->station_id());
    EXPECT_EQ(alone[0].attempts, 0);
    EXPECT_FALSE(alone[0].key.empty());

    a.record("ann", true, 81);
    sync(a);
    const Station b;
    sync(b);
    b.clock.pass_s(3600);
    b.record("ann", 77);
    b.record("ann", 78);
    sync(b);
    sync(a);
    const std::vector<KnownStation> both = known_stations(*a.store, administrator);
    ASSERT_EQ(both.size(), 2U);
    EXPECT_TRUE(both[0].own) << "this station comes first";
    EXPECT_EQ(both[0].attempts, 1);
    EXPECT_EQ(both[1].id, b.store->station_id());
    EXPECT_EQ(both[1].attempts, 2);
    EXPECT_GE(both[1].newest, *b.clock.time - 60'000);
    EXPECT_GT(both[1].created, 0);
    for (const char* login : {"ann", "educator", "director"})
        EXPECT_THROW(known_stations(*a.store, a.session(login)), AccessDenied) << login;
}

TEST_F(Sync, APersonStandsWhereTheyStandAtBothStationsAndOnTheServer) {
    fill(a);
    a.open();
    sync(a);
    const Station b;
    sync(b);
    b.record("ann", 77);
    b.record("ben", 55);
    const std::string wrong = b.record("ben", 99);
    const Session educator = b.sign_in("educator");
    Attempts(*b.store).void_attempt(educator, wrong, "somebody else's");
    Standings(*b.store).decide(educator, b.sign_in("ben").person_id(), "B1", StandingOverride::Kind::unlocked,
                               "did it elsewhere");
    const Curriculum curriculum = load_curriculum(asset_path("curricula/rectal.json"), task_ids());
    const auto before = standings_in(*a.store, a.session("director"), curriculum);
    EXPECT_NE(before, standings_in(*b.store, b.sign_in("director"), curriculum)) << "not exchanged yet";
    sync(b);
    sync(a);
    const auto after = expect_the_same_standings(b);
    EXPECT_NE(after.at("ann"), before.at("ann"));
    EXPECT_NE(after.at("ben"), before.at("ben"));
    EXPECT_EQ(after.at("eve"), before.at("eve"));
}

TEST_F(Sync, SecondRunTransfersNothing) {
    fill(a);
    a.open();
    EXPECT_GT(sync(a).transferred(), 0);
    const Station b;
    sync(b);
    const SyncResult other = sync(a);  // there is one more station
    EXPECT_EQ(other.transferred(), 1);
    EXPECT_EQ(other.counts.at(0).title, "stations");
    // A sign-in is a row of the audit log, and the only thing that is new.
    for (const SyncResult& again : {sync(a), sync(b), sync(b)}) {
        EXPECT_EQ(again.transferred(), 0);
        EXPECT_EQ(again.erased, 0);
        EXPECT_TRUE(again.conflicts.empty());
        EXPECT_LE(again.audit_rows, 1);
    }
    EXPECT_EQ(sync(a).audit_rows, 0);
}

TEST_F(Sync, SimulatedPeopleAndDraftsStayAtTheStation) {
    const Session station = a.store->station_session();
    const Person expert =
        a.people().ensure_synthetic(station, "synthetic-expert", "Expert", PersonKind::synthetic);
    AttemptMeta meta = example_meta(expert.id);
    meta.device_class = DeviceClass::synthetic;
    Recorder recorder(a.path, station, meta, a.clock.options());
    Programme::append_second(recorder);
    recorder.finish(example_result(true, 90));
    const std::string attempt = a.record("ann");
    const Session& educator = a.session("educator");
    Reviews(*a.store).write(educator, attempt, 0.1, "Not yet.", false);
    const std::string rating =
        Ratings(*a.store).begin(educator, attempt, load_forms(asset_path("forms")).front());
    sync(a);
    Connection connection(server);
    const auto count = [&](const char* sql) {
        Query row(connection, sql);
        return row.next() ? row.integer(0) : -1;
    };
    EXPECT_EQ(count("SELECT COUNT(*) FROM attempt"), 1);
    EXPECT_EQ(count("SELECT COUNT(*) FROM person WHERE kind <> 'real'"), 0);
    EXPECT_EQ(count("SELECT COUNT(*) FROM comment"), 0);
    EXPECT_EQ(count("SELECT COUNT(*) FROM rating"), 0);
}

TEST_F(Sync, ALoginThatWasFreedAndGivenToSomebodyElseIsNoConflict) {
    sync(a);
    const Station b;
    sync(b);
    const Session& at_a = a.session("administrator");
    const auto create = [&](const std::string& login, const std::string& name) {
        return a.people().create(at_a, login, name, {Role::trainee}).person.id;
    };
    const std::string first = create("carl", "Carl the first"), third = create("dora", "Dora");
    sync(a);
    sync(b);
    // Down a row: Dora leaves, Carl gets her login, and somebody new gets his.
    a.people().set_login(at_a, third, "dora.old");
    a.people().set_login(at_a, first, "dora");
    const std::string second = create("carl", "Carl the second");
    for (const SyncResult& one : {sync(a), sync(b)})
        EXPECT_TRUE(one.conflicts.empty()) << one.conflicts.front().words();
    for (const Store* store : {a.store.get(), b.store.get()}) {
        Query all(store->connection(),
                  "SELECT COUNT(*) FROM person WHERE (id = ? AND login = 'dora.old') OR (id = ? AND login = "
                  "'dora') OR (id = ? AND login = 'carl' AND display_name = 'Carl the second')");
        all.bind(third).bind(first).bind(second);
        EXPECT_TRUE(all.next() && all.integer(0) == 3);
        expect_sound(*store);
    }
    EXPECT_EQ(sync(a).transferred() + sync(b).transferred(), 0);
    expect_sound(server);
}

TEST_F(Sync, TwoLoginsThatWereExchangedBetweenTwoSyncsWaitForAThirdOne) {
    sync(a);
    const Station b;
    sync(b);
    const Session& at_a = a.session("administrator");
    const std::string ann = a.id("ann"), ben = a.id("ben");
    a.people().set_login(at_a, ann, "ann.old");
    a.people().set_login(at_a, ben, "ann");
    a.people().set_login(at_a, ann, "ben");
    EXPECT_EQ(sync(a).conflicts.size(), 2U) << "one for each login";
    for (const char* login : {"ann.new", "ben"}) {
        a.people().set_login(at_a, ann, login);
        EXPECT_TRUE(sync(a).conflicts.empty());
        EXPECT_TRUE(sync(b).conflicts.empty());
    }
    Query both(b.store->connection(),
               "SELECT COUNT(*) FROM person WHERE (id = ? AND login = 'ben') OR (id = ? AND login = 'ann')");
    both.bind(ann).bind(ben);
    EXPECT_TRUE(both.next() && both.integer(0) == 2);
    expect_sound(*b.store);
    expect_sound(server);
}

}  // namespace
}  // namespace fulcrum::database::test
