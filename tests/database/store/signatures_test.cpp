// SPDX-License-Identifier: GPL-3.0-or-later
// Who has the store alone cannot sign what he writes into it: re-signing, stripping and replaying signatures
// are found.
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "database/store/audit.h"
#include "database/store/signing_keys.h"
#include "database/store/station_key.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

std::vector<std::string> problems_of(const std::string& path) {
    StoreOptions options;
    options.read_only = true;
    const Store store = Store::open(path, options);
    for (const CheckItem& item : store.check(store.station_session()).items)
        if (item.name == "signatures") return english_of(item.problems);
    return {"not looked at"};
}

std::string first_of(const std::vector<std::string>& problems) {
    return problems.empty() ? "" : problems.front();
}

/// Deletes the triggers, as somebody with the file can.
void edit(const std::string& path, const std::string& sql) {
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
    std::string triggers;
    sqlite3_exec(
        handle, "SELECT name FROM sqlite_master WHERE type = 'trigger'",
        [](void* all, int, char** values, char**) {
            *static_cast<std::string*>(all) += "DROP TRIGGER " + std::string(values[0]) + ";";
            return 0;
        },
        &triggers, nullptr);
    sqlite3_exec(handle, triggers.c_str(), nullptr, nullptr, nullptr);
    EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(handle);
    sqlite3_close(handle);
}

/// The stores of one process share a station, so its key is put back.
struct Made {
    Made() {
        std::ifstream file(key_file);
        content.assign(std::istreambuf_iterator<char>(file), {});
    }
    ~Made() { std::ofstream(key_file, std::ios::trunc) << content; }
    Made(const Made&) = delete;
    Made& operator=(const Made&) = delete;
    Programme programme;
    std::string station = programme.store->station_id();
    std::string key_file = StationKey::path_of(station), content;
    /// The store is closed and complete in its file.
    void close() {
        programme.store->connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
        programme.store.reset();
    }
};

TEST(Signatures, AreMadeForEachRowByTheKeyOfTheStation) {
    Made made;
    const Audit audit(*made.programme.store);
    const SignatureCheck check = verify_audit_signatures(made.programme.store->connection(), made.station);
    EXPECT_TRUE(check.problems.empty());
    EXPECT_TRUE(check.notes.empty());
    EXPECT_EQ(check.count, audit.count());
    EXPECT_GT(check.count, 5);
    const auto key = StationKey::existing(made.station);
    ASSERT_TRUE(key);
    EXPECT_EQ(key->first_row(), 1);
    EXPECT_EQ(audit.signing_key(), key_fingerprint(key->public_half()));
    struct stat status {};
    ASSERT_EQ(::stat(made.key_file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST(Signatures, OfAnotherKeyAreFoundWhereTheStationsKeyIs) {
    Made made;
    made.close();
    // The forger has a key of his own and signs all rows again, the edited one among them.
    const Bytes seed = random_bytes(32);
    qputenv("FULCRUM_STATION_KEYS", made.programme.folder.filePath("forger").toLocal8Bit());
    const StationKey forged = StationKey::of(made.station, 1);
    qputenv("FULCRUM_STATION_KEYS",
            QFile::encodeName(QFileInfo(QString::fromStdString(made.key_file)).path()));
    {
        const Store store = Store::open(made.programme.path, {});
        Connection& connection = store.connection();
        connection.execute("DROP TRIGGER audit_signature_stays");
        Query(connection, "DELETE FROM audit_signature").run();
        Query(connection, "INSERT INTO station_key (station_id, public_half) VALUES (?, ?)")
            .bind(made.station)
            .bind(forged.public_half())
            .run();
        std::vector<std::pair<std::int64_t, Bytes>> hashes;
        {
            Query rows(connection, "SELECT sequence, hash FROM audit_entry");
            while (rows.next()) hashes.emplace_back(rows.integer(0), rows.bytes(1));
        }
        for (const auto& [sequence, hash] : hashes)
            Query(connection,
                  "INSERT INTO audit_signature (station_id, sequence, public_half, signature) VALUES (?, ?, "
                  "?, ?)")
                .bind(made.station)
                .bind(sequence)
                .bind(forged.public_half())
                .bind(forged.sign(hash))
                .run();
    }
    EXPECT_NE(first_of(problems_of(made.programme.path))
                  .find("audit row 1: signed by the key " + key_fingerprint(forged.public_half())),
              std::string::npos)
        << first_of(problems_of(made.programme.path));
}

TEST(Signatures, ThatWereRemovedAreMissed) {
    Made made;
    made.close();
    const std::string& path = made.programme.path;
    EXPECT_EQ(first_of(problems_of(path)), "");
    const QTemporaryDir folder;
    const std::string copy = folder.filePath("copy.db").toStdString();
    std::filesystem::copy_file(path, copy);
    edit(copy, "DELETE FROM audit_signature WHERE sequence = 3");
    EXPECT_EQ(first_of(problems_of(copy)), "audit row 3: not signed");
    edit(copy, "DELETE FROM audit_signature");
    EXPECT_EQ(first_of(problems_of(copy)), "audit row 1: not signed");
    // On a machine without the key, a log without any signature looks like one from before there were keys.
    std::filesystem::rename(made.key_file, made.key_file + ".away");
    EXPECT_EQ(first_of(problems_of(copy)), "");
}

TEST(Signatures, OfOneRowDoNotFitAnother) {
    Made made;
    made.close();
    edit(made.programme.path,
         "UPDATE audit_signature SET signature = (SELECT signature FROM audit_signature WHERE sequence = 2) "
         "WHERE sequence = 3");
    EXPECT_EQ(first_of(problems_of(made.programme.path)), "audit row 3: its signature does not fit");
}

TEST(Signatures, BeginWithTheRowThatIsWrittenNextWhereThereIsNoKey) {
    Made made;
    made.close();
    // The store is taken to another machine, whose station has no key of it.
    std::filesystem::remove(made.key_file);
    Store store = Store::open(made.programme.path, made.programme.clock.options());
    const std::int64_t before = Audit(store).count();
    Audit(store).append(store.station_session(), made.station, "test.deed", "{}");
    const auto key = StationKey::existing(made.station);
    ASSERT_TRUE(key);
    EXPECT_EQ(key->first_row(), before + 1);
    const SignatureCheck check = verify_audit_signatures(store.connection(), made.station);
    EXPECT_EQ(first_of(english_of(check.problems)), "");
    EXPECT_EQ(check.count, before + 1);
    ASSERT_EQ(check.notes.size(), 1U) << "a lost key is named";
    EXPECT_NE(
        check.notes[0].words().find("audit row " + std::to_string(before + 1) + ": from here on the key"),
        std::string::npos)
        << check.notes[0].words();
}

TEST(Signatures, AreRefusedToAnotherAccountWithoutTheKeyOfTheOwner) {
    if (::geteuid() != 0) GTEST_SKIP() << "only the superuser gives files away";
    Made made;
    made.close();
    const std::string& path = made.programme.path;
    ASSERT_EQ(::chown(path.c_str(), 120, 120), 0);
    const auto append = [&] {
        const Store store = Store::open(path, made.programme.clock.options());
        Audit(store).append(store.station_session(), made.station, "test.deed", "{}");
    };
    const auto refused = [&] {
        std::string said;
        try {
            append();
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), StoreErrorKind::failed);
            said = error.what();
        }
        EXPECT_NE(said.find("belongs to the account"), std::string::npos) << said;
        EXPECT_NE(said.find("FULCRUM_STATION_KEYS"), std::string::npos) << said;
    };
    const QByteArray usual = qgetenv("FULCRUM_STATION_KEYS");
    const QTemporaryDir other_keys;
    qputenv("FULCRUM_STATION_KEYS", other_keys.path().toLocal8Bit());
    refused();
    EXPECT_TRUE(QDir(other_keys.path()).isEmpty()) << "no key was made";
    StationKey::of(made.station, 1);  // this account has a key of that station, which is not the one in use
    refused();
    qputenv("FULCRUM_STATION_KEYS", usual);
    append();
    EXPECT_EQ(first_of(problems_of(path)), "");
}

TEST(Signatures, AreRefusedWhereTheKeyIsDamagedOrItsFolderCannotBeMade) {
    Made made;
    made.close();
    std::ofstream(made.key_file, std::ios::trunc)
        << "Fulcrum station key 1: keep it secret, keep a copy\nfrom row 1\nabc\n";
    {
        const Store store = Store::open(made.programme.path, {});
        EXPECT_THROW(Audit(store).append(store.station_session(), made.station, "test.deed", "{}"),
                     StoreError);
        const std::int64_t rows = Audit(store).count();
        EXPECT_GT(rows, 0);
        EXPECT_TRUE(Audit(store).verify().empty());
    }
    const QByteArray usual = qgetenv("FULCRUM_STATION_KEYS");
    qputenv("FULCRUM_STATION_KEYS", "/proc/keys/of/stations");
    {
        const Store store = Store::open(made.programme.path, {});
        try {
            Audit(store).append(store.station_session(), made.station, "test.deed", "{}");
            ADD_FAILURE() << "written without a signature";
        } catch (const StoreError& error) {
            EXPECT_NE(std::string(error.what()).find("FULCRUM_STATION_KEYS"), std::string::npos)
                << error.what();
        }
    }
    qputenv("FULCRUM_STATION_KEYS", usual);
}

}  // namespace
}  // namespace fulcrum::database::test
