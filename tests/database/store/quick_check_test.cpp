// SPDX-License-Identifier: GPL-3.0-or-later
// The look at a store when the window starts.
#include "database/store/quick_check.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <fstream>

#include "database/rows/connection.h"
#include "tests/database/large_programme.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/processor_time.h"

namespace fulcrum::database::test {
namespace {

class QuickLook : public ::testing::Test {
  protected:
    QuickLook() {
        programme.record("ann");
        programme.store.reset();
    }
    QuickCheck look(int most_ms = quick_check_ms) const {
        StoreOptions reading;
        reading.read_only = reading.older_schema = true;
        return quick_check(Store::open(programme.path, reading), most_ms);
    }
    void run_sql(const std::string& sql) const {
        sqlite3* handle = nullptr;
        ASSERT_EQ(sqlite3_open(programme.path.c_str(), &handle), SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
            << sqlite3_errmsg(handle);
        sqlite3_close(handle);
    }
    /// The page on which a table's tree begins becomes garbage.
    void damage_root_of(const std::string& table) const {
        std::int64_t page = 0, size = 0;
        {
            Connection connection(programme.path, true, false, 1000);
            Query root(connection, "SELECT rootpage FROM sqlite_master WHERE name = ?");
            root.bind(table);
            ASSERT_TRUE(root.next());
            page = root.integer(0);
            Query bytes(connection, "PRAGMA page_size");
            ASSERT_TRUE(bytes.next());
            size = bytes.integer(0);
        }
        std::fstream file(programme.path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp((page - 1) * size);
        file.write(std::string(512, '\x5a').data(), 512);
    }
    static std::string words(const QuickCheck& found) {
        std::string all;
        for (const Sentence& problem : found.problems) all += problem.words() + "\n";
        return all;
    }
    std::string bytes() const {
        std::ifstream file(programme.path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    Programme programme;
};

TEST_F(QuickLook, FindsNothingInASoundStoreAndReadsEveryTableOfASmallOne) {
    const QuickCheck found = look();
    EXPECT_EQ(words(found), "");
    EXPECT_GT(found.tables, 20);
    EXPECT_TRUE(found.complete());
    EXPECT_NO_THROW(require_quick_check(programme.path));
}

TEST_F(QuickLook, NamesATableWhosePageIsGarbage) {
    for (const char* table : {"person", "score", "trace_chunk"}) {
        const std::string sound = bytes();
        damage_root_of(table);
        EXPECT_NE(words(look()).find(std::string("table ") + table), std::string::npos) << table;
        const std::string damaged = bytes();
        EXPECT_EQ(error_kind([&] { require_quick_check(programme.path); }), StoreErrorKind::corrupt) << table;
        EXPECT_EQ(bytes(), damaged) << "a look changes nothing";
        std::ofstream(programme.path, std::ios::binary) << sound;
    }
    EXPECT_EQ(words(look()), "");
}

TEST_F(QuickLook, FindsATriggerThatIsMissingAndATableThatIsNotOurs) {
    run_sql("DROP TRIGGER audit_signature_is_fixed");
    EXPECT_NE(words(look()).find("audit_signature_is_fixed"), std::string::npos);
    run_sql("CREATE TABLE notes (text TEXT)");
    EXPECT_NE(words(look()).find("notes"), std::string::npos);
}

TEST_F(QuickLook, FindsANewestAuditRowThatWasChanged) {
    run_sql(
        "DROP TRIGGER audit_entry_is_fixed; UPDATE audit_entry SET actor_id = 'somebody' WHERE sequence = "
        "(SELECT MAX(sequence) FROM "
        "audit_entry)");
    EXPECT_NE(words(look()).find("changed after it was written"), std::string::npos) << words(look());
}

TEST_F(QuickLook, TakesTheSmallestTablesFirstAndRecordingsLast) {
    programme.open();
    for (int i = 0; i < 5; ++i) programme.record("ann");
    Connection& connection = programme.store->connection();
    const auto place = [&](const char* name) {
        const std::vector<TableSize> tables = smallest_tables_first(connection);
        const auto found = std::find_if(tables.begin(), tables.end(),
                                        [&](const TableSize& one) { return one.name == name; });
        EXPECT_NE(found, tables.end()) << name;
        return found - tables.begin();
    };
    EXPECT_LT(place("programme"), place("person"));
    EXPECT_LT(place("person"), place("audit_entry"));
    EXPECT_LT(place("score"), place("metric"));
    EXPECT_LT(place("audit_entry"), place("trace_chunk"));
}

TEST_F(QuickLook, BeginsNoTableWhenItsTimeIsOver) {
    damage_root_of("person");
    const QuickCheck found = look(0);
    EXPECT_EQ(found.tables_seen, 0);
    EXPECT_FALSE(found.complete());
    EXPECT_EQ(words(found), "") << "what was not looked at is not said to be damaged";
}

/// Of FULCRUM_REPORT_TRAINEES (20) trainees with FULCRUM_REPORT_ATTEMPTS (26) attempts each. 200 with 300
/// each is the measured size.
class QuickLookLarge : public ::testing::Test {
  protected:
    static int number_of(const char* variable, int usually) {
        return qEnvironmentVariableIsSet(variable) ? qEnvironmentVariableIntValue(variable) : usually;
    }
    /// Scores with twelve metrics, a second's trace and three audit rows for each attempt, as a recorder
    /// makes them.
    void fill(int trainees, int attempts) const {
        Store store = Store::create(path);
        const LargeProgramme made = make_large_programme(store, trainees, attempts, 12, 7);
        const std::string person =
            People(store).ensure_synthetic(store.station_session(), "synthetic-robot", "Robot").id;
        Recorder recorder(path, store.station_session(), example_meta(person));
        Programme::append_second(recorder);
        recorder.finish(example_result(true, 50));
        Connection& connection = store.connection();
        Transaction transaction(connection);
        std::string rule;  // an attempt that has ended takes no more of a trace
        {
            Query row(connection, "SELECT sql FROM sqlite_master WHERE name = 'trace_chunk_of_running'");
            ASSERT_TRUE(row.next());
            rule = row.text(0);
        }
        connection.execute("DROP TRIGGER trace_chunk_of_running");
        Query(
            connection,
            "INSERT INTO trace_chunk (attempt_id, stream, number, first_tick, last_tick, records, checksum, "
            "data) SELECT a.id, c.stream, c.number, c.first_tick, c.last_tick, c.records, c.checksum, "
            "c.data FROM attempt a, trace_chunk c WHERE c.attempt_id = ? AND a.id <> c.attempt_id")
            .bind(recorder.attempt_id())
            .run();
        connection.execute(QString::fromStdString(rule));
        const Audit audit(store);
        for (int i = 0; i < trainees; ++i)
            for (int a = 0; a < 3 * attempts; ++a)
                audit.append(store.station_session(),
                             "trainee-" + std::to_string(1000 + i) + "-" + std::to_string(a / 3),
                             "attempt.practice", R"({"task":"A2","mode":"assessed"})");
        transaction.commit();
    }
    /// What the machine holds of the file in memory is forgotten, where its disk allows that.
    void forget() const {
        const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
        ASSERT_GE(file, 0);
        ::fsync(file);
        ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
        ::close(file);
    }
    const QTemporaryDir folder;
    const std::string path = folder.filePath("large.db").toStdString();
};

TEST_F(QuickLookLarge, TakesAboutASecond) {
    const int trainees = number_of("FULCRUM_REPORT_TRAINEES", 20),
              attempts = number_of("FULCRUM_REPORT_ATTEMPTS", 26);
    fill(trainees, attempts);
    StoreOptions reading;
    reading.read_only = reading.older_schema = true;
    for (const char* state : {"not in memory", "in memory"}) {
        if (std::string(state) == "not in memory") forget();
        const fulcrum::test::ProcessorTime processor;
        const auto start = std::chrono::steady_clock::now();
        const QuickCheck found = quick_check(Store::open(path, reading));
        const double took =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        const double used = processor.milliseconds();
        std::printf(
            "quick look at %d x %d attempts, %.0f MB, %s: %.0f ms, %.0f ms of processor, %d of %d tables\n",
            trainees, attempts, 1e-6 * static_cast<double>(std::filesystem::file_size(path)), state, took,
            used, found.tables_seen, found.tables);
        for (const Sentence& problem : found.problems) ADD_FAILURE() << problem.words();
        EXPECT_LT(used, 2.0 * quick_check_ms);
    }
}

}  // namespace
}  // namespace fulcrum::database::test
