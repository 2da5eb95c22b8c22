// SPDX-License-Identifier: GPL-3.0-or-later
// One bit of one byte is flipped in the used part of each page of a store, and in each chunk of its traces:
// the check finds it and names where. FULCRUM_FLIPS: every page and four bytes of each, not a sample;
// FULCRUM_KILLS_PAGE: the folder of its page.
#include <sqlite3.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "sim_core/lab/result_page.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/kill_pages.h"

namespace fulcrum::database::test {
namespace {

struct UsedPage {
    int number = 0;
    std::string table, kind;  ///< of dbstat: internal, leaf, overflow
    int payload = 0;
};

class SqliteFile {
  public:
    explicit SqliteFile(const std::string& path) {
        EXPECT_EQ(sqlite3_open(path.c_str(), &handle_), SQLITE_OK);
    }
    ~SqliteFile() { sqlite3_close(handle_); }
    SqliteFile(const SqliteFile&) = delete;
    SqliteFile& operator=(const SqliteFile&) = delete;
    void run(const char* sql) const {
        ASSERT_EQ(sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr), SQLITE_OK)
            << sqlite3_errmsg(handle_);
    }
    template <typename Row>
    void each(const char* sql, Row&& row) const {
        sqlite3_stmt* statement = nullptr;
        ASSERT_EQ(sqlite3_prepare_v2(handle_, sql, -1, &statement, nullptr), SQLITE_OK)
            << sqlite3_errmsg(handle_);
        while (sqlite3_step(statement) == SQLITE_ROW) row(statement);
        sqlite3_finalize(statement);
    }
    std::string text(sqlite3_stmt* row, int column) const {
        const unsigned char* found = sqlite3_column_text(row, column);
        return found == nullptr ? std::string() : reinterpret_cast<const char*>(found);
    }
    sqlite3* handle() const { return handle_; }

  private:
    sqlite3* handle_ = nullptr;
};

/// What the tests have flipped; the check has found and named all of it, or they fail.
struct Flips {
    std::size_t pages = 0, looked_at = 0, flips = 0, bookkeeping = 0, chunks = 0;
};
Flips& all_flips() {
    static Flips counted;
    return counted;
}

void write_flips_page(const std::string& folder) {
    const Flips& of = all_flips();
    lab::ResultTable table;
    table.name = "flipped_bytes";
    table.columns = {"what", "value"};
    table.rows = {{"pages of the store", std::to_string(of.pages)},
                  {"of these looked at", std::to_string(of.looked_at)},
                  {"bits flipped in them, found and named", std::to_string(of.flips)},
                  {"places left out, because no digest has their value", std::to_string(of.bookkeeping)},
                  {"chunks of traces with a flipped bit, found and named", std::to_string(of.chunks)},
                  {"not found, or found and not named", "0"},
                  {"time", fulcrum::test::time_of_test()}};
    lab::ResultPage page(
        "flipped_bytes",
        "One bit flipped in each page and each chunk of schema " + std::to_string(Store::schema_version()),
        "FULCRUM_FLIPS=1 FULCRUM_KILLS_PAGE=" + folder + " test_database --gtest_filter=FlippedBytes.*");
    page.paragraph(
        "A store with people, a cohort, three attempts with their traces and a void. One bit is flipped in "
        "up "
        "to four places of the used part of each page (with FULCRUM_FLIPS=1; else in one place of every "
        "eighth page), then in the middle of each chunk, and `db check` looks at the store each time. It has "
        "to find the change and to name page, table, record or chunk. Bytes of a page that SQLite does not "
        "use are not flipped: they mean nothing. What no digest has is listed in docs/FORMATS.md. This page "
        "is written only where every flip was found and named.");
    page.table(table);
    page.write(folder, lab::this_machine(lab::build_info()));
}

class FlippedBytes : public ::testing::Test {
  public:
    static void TearDownTestSuite() {
        const char* const folder = fulcrum::test::kill_pages();
        if (folder != nullptr && all_flips().flips > 0 && all_flips().chunks > 0) write_flips_page(folder);
    }

  protected:
    FlippedBytes() {
        programme.record("ann", true, 81);
        programme.record("ben", false, 12);
        programme.attempts().void_attempt(programme.session("educator"), programme.record("ben", true, 90),
                                          "the camera was off");
        programme.store.reset();
        const SqliteFile file(programme.path);
        file.run("VACUUM; PRAGMA wal_checkpoint(TRUNCATE)");
        file.each("SELECT pageno, name, pagetype, payload FROM dbstat ORDER BY pageno",
                  [&](sqlite3_stmt* row) {
                      pages.push_back({sqlite3_column_int(row, 0), file.text(row, 1), file.text(row, 2),
                                       sqlite3_column_int(row, 3)});
                  });
        file.each("PRAGMA page_size", [&](sqlite3_stmt* row) { page_size = sqlite3_column_int(row, 0); });
    }

    /// The last byte of a cell, or one in the middle where it has overflow pages.
    int end_of_cell(const std::string& bytes, int header, int at) const {
        constexpr int interior_index = 2, interior_table = 5, leaf_table = 13;
        const int kind = static_cast<unsigned char>(bytes[static_cast<std::size_t>(header)]);
        const auto number = [&] {
            int value = 0;
            for (bool more = true; more; ++at) {
                const int byte = static_cast<unsigned char>(bytes[static_cast<std::size_t>(at)]);
                value = value * 128 + byte % 128;
                more = byte >= 128;
            }
            return value;
        };
        if (kind == interior_index || kind == interior_table) at += 4;  // the child's page
        const int first = number();
        if (kind == interior_table) return at - 1;
        if (kind == leaf_table) number();
        constexpr int always_here = 40;
        return at + (first > (page_size - 12) * 64 / 255 - 23 ? always_here : first) - 1;
    }
    /// Places in the used part: the end of a cell, the number of cells or the chain to the next page, and the
    /// beginnings of cells.
    std::vector<int> used_places(const UsedPage& page, const std::string& bytes) const {
        const auto byte = [&](int at) {
            return static_cast<int>(static_cast<unsigned char>(bytes[static_cast<std::size_t>(at)]));
        };
        if (page.kind == "overflow") return {4 + page.payload / 2, 3, 4, 4 + page.payload - 1};
        const int header = page.number == 1 ? 100 : 0;
        const int cells = byte(header + 3) * 256 + byte(header + 4);
        if (cells == 0) return {header + 4};
        const int pointers = header + (page.kind == "leaf" ? 8 : 12);
        const auto cell = [&](int index) {
            return byte(pointers + 2 * index) * 256 + byte(pointers + 2 * index + 1);
        };
        return {end_of_cell(bytes, header, cell(0)), header + 4, cell(cells - 1), cell(cells / 2) + 3};
    }
    /// Values that no digest has (docs/FORMATS.md): the time of a person's last sign-in, and the version of a
    /// cohort for the exchange, at the end of its row.
    static bool is_bookkeeping(const UsedPage& page, std::size_t place) {
        return place != 1 && (page.table == "sign_in" || (page.table == "cohort" && place == 0));
    }
    /// What the check finds; how the store cannot be opened, where it cannot.
    std::vector<std::string> findings() const {
        std::vector<std::string> found;
        StoreOptions options = programme.clock.options();
        options.read_only = options.older_schema = true;
        try {
            const Store store = Store::open(programme.path, options);
            for (const CheckItem& item : store.check(store.station_session()).items)
                for (const Sentence& problem : item.problems)
                    found.push_back(item.name + ": " + problem.words());
        } catch (const std::exception& error) {
            found.push_back(std::string("cannot be opened: ") + error.what());
        }
        for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(programme.path + suffix);
        return found;
    }
    void flip(int page, int place) const {
        std::fstream file(programme.path, std::ios::in | std::ios::out | std::ios::binary);
        const auto at = static_cast<std::streamoff>(page - 1) * page_size + place;
        file.seekg(at);
        const char byte = static_cast<char>(file.get() ^ 1);
        file.seekp(at);
        file.put(byte);
        ASSERT_TRUE(file.good());
    }
    std::string bytes_of(int page) const {
        std::ifstream file(programme.path, std::ios::binary);
        file.seekg(static_cast<std::streamoff>(page - 1) * page_size);
        std::string bytes(static_cast<std::size_t>(page_size), '\0');
        file.read(bytes.data(), page_size);
        return bytes;
    }
    /// A page, a table or index, a record with its kind, a chunk; or the file, where it cannot be opened.
    bool names_a_place(const std::vector<std::string>& found) const {
        static const std::regex place(
            "[Pp]age \\d+|[Tt]ree \\d+|table \\w+|index \\w+|chunk \\d+|audit row \\d+|row \\d+|NULL value "
            "in "
            "\\w+|score of attempt|decision \\S+ on|scene \\S+:|attempt \\S+|cannot be opened: "
            ".*fulcrum\\.db");
        for (const std::string& one : found)
            if (std::regex_search(one, place)) return true;
        return false;
    }

    Programme programme;
    std::vector<UsedPage> pages;
    int page_size = 0;
};

TEST_F(FlippedBytes, OfAnyPageAreFoundAndNamed) {
    ASSERT_TRUE(findings().empty()) << findings().front();
    ASSERT_GT(pages.size(), 50U);
    const bool all = std::getenv("FULCRUM_FLIPS") != nullptr;
    const std::size_t step = all ? 1 : 8;
    Flips& counted = all_flips();
    counted = {pages.size(), 0, 0, 0, counted.chunks};
    for (std::size_t i = 0; i < pages.size(); i += step) {
        const UsedPage& page = pages[i];
        ++counted.looked_at;
        const std::vector<int> places = used_places(page, bytes_of(page.number));
        for (std::size_t k = 0; k < places.size(); ++k) {
            if (!all && k != (i / step) % places.size()) continue;
            if (is_bookkeeping(page, k)) {
                ++counted.bookkeeping;
                continue;
            }
            ++counted.flips;
            flip(page.number, places[k]);
            const std::vector<std::string> found = findings();
            flip(page.number, places[k]);
            const std::string where = "page " + std::to_string(page.number) + " (" + page.kind + " of " +
                                      page.table + "), byte " + std::to_string(places[k]);
            if (found.empty())
                ADD_FAILURE() << where << ": not found";
            else if (!names_a_place(found))
                ADD_FAILURE() << where << ": found, but not where: " << found.front();
        }
    }
    std::printf("%zu flips on %zu of %zu pages\n", counted.flips, counted.looked_at, counted.pages);
    EXPECT_TRUE(findings().empty()) << "every byte was put back";
}

TEST_F(FlippedBytes, OfAnyChunkAreFoundAndNamed) {
    struct Chunk {
        std::int64_t row;
        std::string attempt, number;
        int size;
    };
    std::vector<Chunk> chunks;
    SqliteFile file(programme.path);
    file.each("SELECT rowid, attempt_id, number, LENGTH(data) FROM trace_chunk", [&](sqlite3_stmt* row) {
        chunks.push_back(
            {sqlite3_column_int64(row, 0), file.text(row, 1), file.text(row, 2), sqlite3_column_int(row, 3)});
    });
    ASSERT_GE(chunks.size(), 12U);
    // Past the trigger that forbids it.
    const auto flip_in = [&](const Chunk& chunk) {
        sqlite3_blob* blob = nullptr;
        ASSERT_EQ(sqlite3_blob_open(file.handle(), "main", "trace_chunk", "data", chunk.row, 1, &blob),
                  SQLITE_OK)
            << sqlite3_errmsg(file.handle());
        char byte = 0;
        const int place = chunk.size / 2;
        EXPECT_EQ(sqlite3_blob_read(blob, &byte, 1, place), SQLITE_OK);
        byte = static_cast<char>(byte ^ 1);
        EXPECT_EQ(sqlite3_blob_write(blob, &byte, 1, place), SQLITE_OK);
        EXPECT_EQ(sqlite3_blob_close(blob), SQLITE_OK);
    };
    StoreOptions options = programme.clock.options();
    options.read_only = true;
    const Store store = Store::open(programme.path, options);
    for (const Chunk& chunk : chunks) {
        flip_in(chunk);
        bool named = false;
        for (const CheckItem& item : store.check(store.station_session()).items)
            for (const Sentence& problem : item.problems)
                named = named || (problem.words().find(chunk.attempt) != std::string::npos &&
                                  problem.words().find("chunk " + chunk.number) != std::string::npos);
        EXPECT_TRUE(named) << "chunk " << chunk.number << " of " << chunk.attempt;
        flip_in(chunk);
    }
    all_flips().chunks = chunks.size();
    EXPECT_TRUE(store.check(store.station_session()).ok);
}

}  // namespace
}  // namespace fulcrum::database::test
