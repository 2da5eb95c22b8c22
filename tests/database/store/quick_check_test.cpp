// SPDX-License-Identifier: GPL-3.0-or-later
// The look at a store when the window starts.
#include "database/store/quick_check.h"

#include <sqlite3.h>

#include <fstream>

#include "database/rows/connection.h"
#include "tests/database/programme_fixture.h"

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

TEST_F(QuickLook, BeginsNoTableWhenItsTimeIsOver) {
    damage_root_of("person");
    const QuickCheck found = look(0);
    EXPECT_EQ(found.tables_seen, 0);
    EXPECT_FALSE(found.complete());
    EXPECT_EQ(words(found), "") << "what was not looked at is not said to be damaged";
}

}  // namespace
}  // namespace fulcrum::database::test
