// SPDX-License-Identifier: GPL-3.0-or-later
// A station signs with a new key: old attempts verify, the old key can sign nothing later, and wherever the
// change is cut off, and however many change it at once, the log and the key's file agree.
#include <atomic>
#include <fstream>
#include <thread>

#include "database/records/attempts.h"
#include "database/store/audit.h"
#include "database/store/signing_keys.h"
#include "database/store/station_key.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class KeyRotation : public ::testing::Test {
  protected:
    SigningKey rotate() const {
        return rotate_station_key(*programme.store, programme.session("administrator"), "planned");
    }
    std::string key() const { return Audit(*programme.store).signing_key(); }
    std::vector<SigningKey> keys() const { return signing_keys(programme.store->connection(), station); }
    SignatureCheck check(const std::string& own) const {
        return verify_audit_signatures(programme.store->connection(), own);
    }
    /// With the station's key at hand and without it.
    void expect_signed(const std::string& when = "") const {
        for (const std::string& own : {station, std::string()}) {
            const SignatureCheck found = check(own);
            for (const Sentence& problem : found.problems) ADD_FAILURE() << when << ": " << problem.words();
            EXPECT_TRUE(found.notes.empty()) << when;
        }
    }
    std::vector<std::string> problems(const std::string& own = {}) const {
        return english_of(check(own).problems);
    }
    void deed() const {
        Audit(*programme.store).append(programme.session("station"), station, "test.deed", "{}");
    }
    std::string key_file_now() const { return StationKey::path_of(station); }
    void put_key(const std::string& content) const {
        std::ofstream(StationKey::path_of(station), std::ios::trunc | std::ios::binary) << content;
    }

    Programme programme;  // before the copies of keys: it makes the first
    const KeysOfOneTest own_keys;
    const std::string station = programme.store->station_id(), first = key();
};

TEST_F(KeyRotation, AnAttemptIsSignedByTheKeyThatSignedItsEnd) {
    const Audit audit(*programme.store);
    const std::string before = programme.record("ann");
    const SigningKey made = rotate();
    const std::string after = programme.record("ann");
    EXPECT_EQ(audit.signer_of(before), first);
    EXPECT_EQ(audit.signer_of(after), made.fingerprint);
    EXPECT_NE(first, made.fingerprint);
    EXPECT_EQ(audit.signing_key(), made.fingerprint) << "of the newest row";
    EXPECT_EQ(audit.signer_of("no such attempt"), "");
    rotate();
    const std::string copy =
        Attempts(*programme.store)
            .reassign(programme.session("educator"), before, programme.id("ben"), "wrong name");
    EXPECT_EQ(audit.signer_of(copy), key()) << "the row of the copy";
    EXPECT_EQ(audit.signer_of(before), first);
}

TEST_F(KeyRotation, TheNewKeySignsFromThenOnAndTheOldOneKeepsItsPeriod) {
    const std::string attempt = programme.record("ann");
    const std::string before = content_of(StationKey::path_of(station));
    const SigningKey made = rotate();
    EXPECT_NE(made.fingerprint, first);
    EXPECT_EQ(key(), made.fingerprint) << "what reports print";
    programme.record("ben");
    expect_signed();
    for (const CheckItem& item : programme.store->check(programme.session("station")).items)
        EXPECT_TRUE(item.ok) << item.name;
    const std::vector<SigningKey> all = keys();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].fingerprint, first);
    EXPECT_EQ(all[0].last_row + 1, all[1].first_row);
    EXPECT_FALSE(all[0].announced);
    EXPECT_TRUE(all[1].announced);
    EXPECT_TRUE(leads_to_newest(all, first.substr(0, 16)));
    EXPECT_FALSE(leads_to_newest(all, std::string(32, 'f')));
    EXPECT_NE(content_of(StationKey::path_of(station)), before);
    EXPECT_FALSE(StationKey::prepared(station));
    EXPECT_EQ(StationKey::existing(station)->first_row(), all[1].first_row);
    std::vector<std::string> deeds;
    AuditFilter filter;
    filter.kind = "key";
    for (const AuditEntry& entry :
         Audit(*programme.store).entries(programme.session("administrator"), filter))
        deeds.push_back(entry.operation + " " + entry.role);
    EXPECT_EQ(deeds, (std::vector<std::string>{"key.begin administrator", "key.rotate administrator"}));
    rotate();
    expect_signed();
    EXPECT_TRUE(leads_to_newest(keys(), first));
}

TEST_F(KeyRotation, NeedsAReasonAndAnAdministrator) {
    EXPECT_EQ(
        error_kind([&] { rotate_station_key(*programme.store, programme.session("administrator"), "  "); }),
        StoreErrorKind::bad_value);
    for (const char* login : {"ann", "educator", "director", "station"})
        EXPECT_THROW(rotate_station_key(*programme.store, programme.session(login), "planned"), AccessDenied);
    EXPECT_EQ(key(), first);
    EXPECT_FALSE(StationKey::prepared(station));
}

TEST_F(KeyRotation, AStolenOldKeySignsNothingAfterItsEnd) {
    const std::string stolen = content_of(StationKey::path_of(station));
    const SigningKey made = rotate();
    const std::string present = content_of(StationKey::path_of(station));
    put_key(stolen);
    // An attempt under the old key, dated after its end.
    programme.open();
    programme.record("ann");
    const std::string said =
        "signed by the key " + first + ", which ended with row " + std::to_string(made.first_row - 1);
    const auto says = [&](const std::vector<std::string>& found) {
        return !found.empty() && found[0].find(said) != std::string::npos;
    };
    EXPECT_TRUE(says(problems())) << "on any machine";
    put_key(present);
    EXPECT_FALSE(problems(station).empty()) << "at the station";
    EXPECT_FALSE(leads_to_newest(keys(), made.fingerprint));
}

TEST_F(KeyRotation, ThatFollowsALostKeyIsANoteAndStartsAChainOfItsOwn) {
    rotate();
    std::filesystem::remove(StationKey::path_of(station));
    programme.open();
    deed();
    const SignatureCheck found = check({});
    EXPECT_EQ(english_of(found.problems), std::vector<std::string>());
    ASSERT_EQ(found.notes.size(), 1U);
    EXPECT_FALSE(leads_to_newest(keys(), first)) << "a lost key announces nobody";
    const std::string second = key();
    rotate();
    EXPECT_TRUE(leads_to_newest(keys(), second));
    EXPECT_TRUE(problems(station).empty());
}

TEST_F(KeyRotation, AProgramThatWasOpenSignsWithTheNewKeyToo) {
    const Store other = Store::open(programme.path, programme.clock.options());
    Audit(other).append(programme.session("station"), station, "test.deed", "{}");
    const SigningKey made = rotate();
    Audit(other).append(programme.session("station"), station, "test.deed", "{}");
    EXPECT_EQ(Audit(other).signing_key(), made.fingerprint);
    expect_signed();
}

TEST_F(KeyRotation, ThatIsRolledBackChangesNothing) {
    {
        Transaction undone(programme.store->connection());
        rotate();
    }
    EXPECT_EQ(key(), first);
    deed();
    EXPECT_EQ(key(), first);
    expect_signed();
    const auto left = StationKey::prepared(station);
    ASSERT_TRUE(left);
    EXPECT_EQ(rotate().public_half, left->public_half()) << "the next one takes what was prepared";
    deed();
    expect_signed();
}

TEST_F(KeyRotation, CutOffAnywhereLeavesAKeyThatTheLogAsksFor) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    programme.store->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
    programme.store.reset();
    const std::string bytes = content_of(programme.path), secret = content_of(key_file_now());
    const auto put_back = [&] {
        programme.store.reset();
        for (const char* ending : {"-wal", "-shm"}) std::filesystem::remove(programme.path + ending);
        std::ofstream(programme.path, std::ios::binary | std::ios::trunc) << bytes;
        std::filesystem::remove(key_file_now() + ".next");
        put_key(secret);
    };
    const auto rotation = [&] {
        const Store store = Store::open(programme.path, programme.clock.options());
        rotate_station_key(store, programme.session("administrator"), "planned");
    };
    put_back();
    const CutOff whole = cut_off(0, rotation);
    ASSERT_EQ(whole.status, 0);
    int kills = 0, rotated = 0, finished_later = 0;
    for (const int point : cut_off_points(whole.changes, 12)) {
        put_back();
        const CutOff cut = cut_off(point, rotation);
        if (!cut.killed) continue;
        ++kills;
        const std::string when = "before change " + std::to_string(point) + " (" + cut.call + ")";
        programme.open();
        expect_signed(when + ", read only");
        deed();
        expect_signed(when + ", after a deed");
        rotated += key() == first ? 0 : 1;
        finished_later += key() != first && content_of(key_file_now()) != secret ? 1 : 0;
        rotate();
        deed();
        expect_signed(when + ", rotated again");
        EXPECT_TRUE(leads_to_newest(keys(), first)) << when;
    }
    EXPECT_GT(kills, 3);
    EXPECT_LT(rotated, kills);
    EXPECT_EQ(finished_later, rotated);
    std::printf("key rotation killed before %d of %d changes to files; the log had the new key in %d\n",
                kills, whole.changes, rotated);
}

TEST_F(KeyRotation, ManyAtOnceFollowOneAnother) {
    constexpr int each = 3;
    std::atomic<int> done{0};
    std::vector<std::string> trouble(3);
    const auto at_once = [&](std::size_t number, const std::function<void(const Store&)>& work) {
        return std::thread([&, number, work] {
            try {
                StoreOptions options = programme.clock.options();
                options.busy_timeout_ms = 20000;
                const Store store = Store::open(programme.path, options);
                for (int i = 0; i < each; ++i) work(store);
                ++done;
            } catch (const std::exception& error) {
                trouble[number] = error.what();
            }
        });
    };
    const auto rotating = [&](const Store& store) {
        rotate_station_key(store, programme.session("administrator"), "planned");
    };
    std::thread threads[] = {at_once(0, rotating), at_once(1, rotating), at_once(2, [&](const Store& store) {
                                 for (int i = 0; i < 5; ++i)
                                     Audit(store).append(programme.session("station"), station, "test.deed",
                                                         "{}");
                             })};
    for (std::thread& thread : threads) thread.join();
    for (const std::string& one : trouble) EXPECT_EQ(one, "");
    EXPECT_EQ(keys().size(), 1U + 2 * each);
    deed();
    expect_signed();
    EXPECT_TRUE(leads_to_newest(keys(), first));
}

class SyncedKeys : public Sync {
  protected:
    const KeysOfOneTest own_keys;
};

TEST_F(SyncedKeys, TheServerLearnsTheNewKeyAndFindsTheOldOneAfterItsEnd) {
    a.record("ann");
    sync(a);
    const std::string file = StationKey::path_of(a.store->station_id()), old = content_of(file);
    const SigningKey made = rotate_station_key(*a.store, a.session("administrator"), "planned");
    a.record("ben");
    sync(a);
    Connection connection(server);
    const std::vector<SigningKey> known = signing_keys(connection, a.store->station_id());
    ASSERT_GE(known.size(), 2U);
    EXPECT_EQ(known.back().fingerprint, made.fingerprint);
    EXPECT_TRUE(known.back().announced);
    ServerCheck check = check_programme_server(server);
    EXPECT_EQ(english_of(check.problems), std::vector<std::string>());
    // Whoever has the old key sends an attempt with it.
    const std::string present = content_of(file);
    std::ofstream(file, std::ios::trunc) << old;
    a.open();
    a.record("ann");
    sync(a);
    std::ofstream(file, std::ios::trunc) << present;
    check = check_programme_server(server);
    ASSERT_FALSE(check.problems.empty());
    EXPECT_NE(check.problems[0].words().find("which ended with row"), std::string::npos)
        << check.problems[0].words();
}

}  // namespace
}  // namespace fulcrum::database::test
