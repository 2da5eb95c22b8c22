// SPDX-License-Identifier: GPL-3.0-or-later
// How long data of trainees are kept: who is due, and that nobody goes by themselves.
#include "database/sync/retention.h"

#include "database/records/person_merge.h"
#include "database/sync/station_erasure.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class Retention : public ::testing::Test {
  protected:
    static constexpr double day = 86400;
    const Session& director() const { return programme.session("director"); }
    std::vector<std::string> due() const {
        std::vector<std::string> logins;
        for (const DuePerson& one : people_due(*programme.store, director())) logins.push_back(one.login);
        return logins;
    }
    Programme programme;
    const KeysOfOneTest own_keys;
};

TEST_F(Retention, ListsTraineesWhoseLastPracticeIsLongerAgoAndNobodyElse) {
    EXPECT_TRUE(due().empty()) << "no end is set";
    programme.clock.pass_s(20 * day);
    programme.record("ann");
    set_retention_months(*programme.store, director(), 2);
    EXPECT_EQ(retention_months(*programme.store), 2);
    EXPECT_TRUE(due().empty());
    programme.clock.pass_s(45 * day);
    EXPECT_EQ(due(), (std::vector<std::string>{"ben", "eve"})) << "educators and others are not due";
    programme.clock.pass_s(20 * day);
    EXPECT_EQ(due(), (std::vector<std::string>{"ben", "eve", "ann"}));
    programme.people().sign_in("ben", password);
    EXPECT_EQ(due(), (std::vector<std::string>{"eve", "ann"})) << "who signs in is here";
    programme.people().set_roles(programme.session("administrator"), programme.id("ann"),
                                 {Role::trainee, Role::educator});
    EXPECT_EQ(due(), std::vector<std::string>{"eve"}) << "who teaches is not due";
    set_retention_months(*programme.store, director(), std::nullopt);
    EXPECT_TRUE(due().empty());
    EXPECT_FALSE(retention_months(*programme.store));
}

TEST_F(Retention, CountsWhatBelongsToAMergedAccount) {
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("eve"), programme.id("ann"), "one person");
    programme.clock.pass_s(80 * day);
    set_retention_months(*programme.store, director(), 2);
    EXPECT_EQ(due(), (std::vector<std::string>{"ann", "ben"}))
        << "the merged account is not listed by itself";
    set_retention_months(*programme.store, director(), 1);
    erase_due(*programme.store, director(), {programme.id("ann")});
    EXPECT_EQ(due(), std::vector<std::string>{"ben"});
}

TEST_F(Retention, IsSetAndUsedByDirectorsOnlyAndAudited) {
    programme.clock.pass_s(80 * day);
    for (const char* login : {"administrator", "educator", "ann"}) {
        EXPECT_THROW(set_retention_months(*programme.store, programme.session(login), 3), AccessDenied);
        EXPECT_THROW(people_due(*programme.store, programme.session(login)), AccessDenied);
        EXPECT_THROW(erase_due(*programme.store, programme.session(login), {}), AccessDenied);
    }
    for (const int months : {0, -1, 601})
        EXPECT_EQ(error_kind([&] { set_retention_months(*programme.store, director(), months); }),
                  StoreErrorKind::bad_value);
    set_retention_months(*programme.store, director(), 3);
    auto newest = Audit(*programme.store).entries(programme.session("administrator")).front();
    EXPECT_EQ(newest.operation, "setting.retention_months");
    set_retention_months(*programme.store, director(), 3);
    EXPECT_EQ(Audit(*programme.store).entries(programme.session("administrator")).front().sequence,
              newest.sequence)
        << "nothing was changed";
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
    programme.store->connection().execute("UPDATE setting SET value = '1' WHERE key = 'retention_months'");
    EXPECT_FALSE(programme.store->check(programme.store->station_session()).ok) << "changed by hand";
}

TEST_F(Retention, ErasesWhoIsListedAndRefusesWhoIsNotDue) {
    programme.record("ann");
    programme.clock.pass_s(80 * day);
    programme.record("ben");
    set_retention_months(*programme.store, director(), 2);
    EXPECT_EQ(error_kind([&] {
                  erase_due(*programme.store, director(), {programme.id("eve"), programme.id("ben")});
              }),
              StoreErrorKind::conflict);
    EXPECT_EQ(due(), (std::vector<std::string>{"ann", "eve"})) << "nobody was erased";
    int calls = 0;
    EXPECT_EQ(erase_due(*programme.store, director(), {programme.id("ann"), programme.id("eve")},
                        [&](double, const std::string&) { return ++calls < 2; })
                  .size(),
              1U);
    EXPECT_EQ(due(), std::vector<std::string>{"eve"}) << "stopped: the other is still due";
    EXPECT_EQ(erase_due(*programme.store, director(), {programme.id("eve")}).size(), 1U);
    EXPECT_TRUE(due().empty());
    Query rows(programme.store->connection(), "SELECT COUNT(*) FROM attempt");
    ASSERT_TRUE(rows.next());
    EXPECT_EQ(rows.integer(0), 1);
    expect_sound(*programme.store);
}

TEST_F(Retention, KilledWhileItErasesWhoIsLeftIsDueAndNobodyIsHalfErased) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    programme.record("ann");
    programme.clock.pass_s(80 * day);
    set_retention_months(*programme.store, director(), 2);
    const std::vector<std::string> ids = {programme.id("ann"), programme.id("ben"), programme.id("eve")};
    programme.store->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
    programme.store.reset();
    const std::string first = programme.path + ".first";
    std::filesystem::copy_file(programme.path, first);
    const auto put_back = [&] {
        for (const char* ending : {"", "-wal", "-shm"}) std::filesystem::remove(programme.path + ending);
        std::filesystem::copy_file(first, programme.path);
    };
    const auto deed = [&] {
        const Store store = Store::open(programme.path, programme.clock.options());
        erase_due(store, director(), ids);
    };
    const CutOff whole = cut_off(0, deed);
    ASSERT_EQ(whole.status, 0);
    int kills = 0;
    for (const int point : cut_off_points(whole.changes, 8)) {
        put_back();
        const CutOff cut = cut_off(point, deed);
        if (!cut.killed) continue;
        ++kills;
        programme.open();
        erase_listed(*programme.store);
        expect_sound(*programme.store);
        std::vector<std::string> left;
        for (const DuePerson& one : people_due(*programme.store, director())) left.push_back(one.id);
        erase_due(*programme.store, director(), left);
        EXPECT_TRUE(due().empty());
        expect_sound(*programme.store);
        programme.store.reset();
        if (HasFailure()) break;
    }
    EXPECT_GT(kills, 0);
}

}  // namespace
}  // namespace fulcrum::database::test
