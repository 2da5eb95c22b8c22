// SPDX-License-Identifier: GPL-3.0-or-later
// Stores that older programs wrote, one for each schema version (tests/database/frozen/README.md): each
// becomes one of today with every row it had, also where the migration is killed at any point.
// FULCRUM_CUT_OFF=1 kills before every change to a file; FULCRUM_KILLS_PAGE is the folder of the page.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>

#include "assessment/assets/assets.h"
#include "database/records/goals.h"
#include "database/records/person_merge.h"
#include "database/records/ratings.h"
#include "database/records/standings.h"
#include "database/records/tissues.h"
#include "database/rows/packed_bytes.h"
#include "database/schema/migration.h"
#include "database/store/store_restore.h"
#include "sim_core/lab/result_page.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/external_example.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/kill_pages.h"
#include "tests/support/support.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

std::string frozen_file(int version) {
    char name[64];
    std::snprintf(name, sizeof name, "tests/database/frozen/schema-%02d.db.zst", version);
    return fulcrum::test::source_path(name);
}

std::vector<int> older_versions() {
    std::vector<int> versions;
    for (int version = 1; version < latest_schema_version(); ++version) versions.push_back(version);
    return versions;
}

/// By table, the rows as text; `columns`: those of an older version, by table.
using Columns = std::map<std::string, std::vector<std::string>>;
using Rows = std::map<std::string, std::multiset<std::string>>;

Columns columns_of(Connection& connection) {
    Columns columns;
    Query tables(connection,
                 "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%'");
    while (tables.next()) {
        Query info(connection, "PRAGMA table_info(" + QString::fromStdString(tables.text(0)) + ")");
        while (info.next()) columns[tables.text(0)].push_back(info.text(1));
    }
    return columns;
}

Rows rows_of(Connection& connection, const Columns& columns) {
    Rows rows;
    for (const auto& [table, names] : columns) {
        QString list;
        for (const std::string& name : names)
            list += (list.isEmpty() ? "" : " || '|' || ") + ("quote(" + QString::fromStdString(name) + ")");
        Query query(connection, "SELECT " + list + " FROM " + QString::fromStdString(table));
        while (query.next()) rows[table].insert(query.text(0));
    }
    return rows;
}

/// What changes on purpose: waits after wrong tries begin again (step 10), and what step 8 asks for is done.
Rows as_migrated(Rows rows, int version) {
    constexpr int with_boot_time = 10;
    if (version < with_boot_time) rows.erase("sign_in_wait");
    rows["setting"].erase("'baseline_wanted'|'1'");
    return rows;
}

/// Changes to files that a deed makes, and before how many of them it was killed.
struct Sweep {
    int changes = 0, kills = 0;
};
struct SweepsOfSchema {
    Sweep start, command;
};
std::map<int, SweepsOfSchema>& sweeps() {
    static std::map<int, SweepsOfSchema> by_schema;
    return by_schema;
}

void write_sweep_page(const std::string& folder) {
    lab::ResultTable table;
    table.name = "frozen_stores";
    table.columns = {"schema", "start: changes to files", "killed before", "`db migrate`: changes to files",
                     "killed before"};
    Sweep start, command;
    const auto line = [](const std::string& schema, const Sweep& a, const Sweep& b) {
        return std::vector<std::string>{schema, std::to_string(a.changes), std::to_string(a.kills),
                                        std::to_string(b.changes), std::to_string(b.kills)};
    };
    for (const auto& [schema, of] : sweeps()) {
        table.rows.push_back(line(std::to_string(schema), of.start, of.command));
        for (const auto& [sum, one] :
             {std::make_pair(&start, &of.start), std::make_pair(&command, &of.command)}) {
            sum->changes += one->changes;
            sum->kills += one->kills;
        }
    }
    table.rows.push_back(line("all", start, command));
    lab::ResultPage page(
        "frozen_stores",
        "Stores of every older schema, killed " + std::to_string(start.kills + command.kills) +
            " times while they become one of schema " + std::to_string(latest_schema_version()),
        "FULCRUM_CUT_OFF=1 FULCRUM_KILLS_PAGE=" + folder + " test_database --gtest_filter=*FrozenStore.*");
    page.paragraph(
        "One store of each schema version is kept in the repository (tests/database/frozen). It is migrated "
        "by the start of the program, and by `db migrate`, and a `kill -9` ends the program before a system "
        "call that changes a file; with FULCRUM_CUT_OFF=1 before each of them, one after the other. After "
        "every kill the file is whole, and either the old store or one that the next start completes; the "
        "copy from before the migration is there as soon as anything has changed. The next start then has "
        "every row that the old store had. This page is written only where every check passed. Time: " +
        fulcrum::test::time_of_test() + ".");
    page.table(table);
    page.write(folder, lab::this_machine(lab::build_info()));
}

class FrozenStore : public ::testing::TestWithParam<int> {
  public:
    static void TearDownTestSuite() {
        std::size_t kills = 0;
        for (const auto& [schema, of] : sweeps())
            kills += static_cast<std::size_t>(of.start.kills + of.command.kills);
        if (kills == 0) return;
        if (const char* folder = fulcrum::test::kill_pages()) write_sweep_page(folder);
        fulcrum::test::enter_kills(
            {fulcrum::test::Killed::migrating, kills, "stores with every row after the next start", kills, 0},
            lab::this_machine(lab::build_info()));
    }

  protected:
    FrozenStore() {
        std::ifstream file(frozen_file(GetParam()), std::ios::binary);
        EXPECT_TRUE(file) << frozen_file(GetParam()) << " is missing; see tests/database/frozen/README.md";
        const std::vector<std::uint8_t> packed{std::istreambuf_iterator<char>(file), {}};
        bytes = unpack_bytes(packed);
        put_back();
        Connection connection(path, true, false, 100);
        EXPECT_EQ(read_schema_version(connection), GetParam());
        columns = columns_of(connection);
        before = as_migrated(rows_of(connection, columns), GetParam());
        reading.read_only = reading.older_schema = true;
        migrating.close_interrupted = false;
    }
    void put_back() const {
        for (const auto& entry : files::directory_iterator(folder.path().toStdString()))
            files::remove_all(entry.path());
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        files::permissions(path, files::perms::owner_read | files::perms::owner_write);
    }
    static void expect_sound(const Store& store) {
        for (const CheckItem& item : store.check(store.station_session()).items)
            EXPECT_TRUE(item.ok) << item.name << ": " << item.problems.front().words();
    }
    /// Every row that the frozen store had.
    void expect_all_rows(Connection& connection) const {
        Columns present = columns;
        if (GetParam() < 10) present.erase("sign_in_wait");
        const Rows now = rows_of(connection, present);
        for (const auto& [table, rows] : before) {
            const auto found = now.find(table);
            ASSERT_TRUE(found != now.end()) << table << " is empty";
            EXPECT_TRUE(std::includes(found->second.begin(), found->second.end(), rows.begin(), rows.end()))
                << table << " lost rows";
        }
    }
    /// The file is whole, of the version it says, and one that it may have at this moment.
    void expect_usable(const std::string& file, const std::string& when) const {
        Connection connection(file, false, false, 100);
        Query sound(connection, "PRAGMA integrity_check"), references(connection, "PRAGMA foreign_key_check");
        ASSERT_TRUE(sound.next()) << when;
        EXPECT_EQ(sound.text(0), "ok") << when;
        EXPECT_FALSE(references.next()) << when;
        EXPECT_GE(read_schema_version(connection), GetParam()) << when;
    }
    /// The copy that is kept before the first step: there from the moment that anything changes.
    void expect_copy(const std::string& when) const {
        const std::string copy = path + ".before-v" + std::to_string(latest_schema_version());
        Connection now(path, true, false, 100);
        if (!files::exists(copy)) {
            EXPECT_EQ(read_schema_version(now), GetParam()) << when << ": changed without a copy";
            return;
        }
        Connection kept(copy, true, false, 100);
        EXPECT_EQ(read_schema_version(kept), GetParam()) << when;
        EXPECT_EQ(as_migrated(rows_of(kept, columns), GetParam()), before) << when;
    }
    /// Kills `deed` at some or all of its changes; `after` looks at the files, then the deed is done again.
    Sweep kill_at(int few, const std::function<void()>& deed,
                  const std::function<void(const std::string&)>& after) {
        put_back();
        const CutOff whole = cut_off(0, deed);
        EXPECT_EQ(whole.status, 0);
        Sweep sweep{whole.changes, 0};
        for (const int point : cut_off_points(whole.changes, few)) {
            put_back();
            const CutOff cut = cut_off(point, deed);
            if (!cut.killed) continue;
            ++sweep.kills;
            const std::string when = "schema " + std::to_string(GetParam()) + ", before change " +
                                     std::to_string(point) + " (" + cut.call + ")";
            expect_usable(path, when);
            after(when);
            deed();
            const Store store = Store::open(path, migrating);
            EXPECT_EQ(store.found_schema(), latest_schema_version()) << when;
            expect_all_rows(store.connection());
            if (point % 50 == 1) expect_sound(store);
            if (HasFailure()) break;
        }
        return sweep;
    }

    const TemporaryFoldersInMemory in_memory;
    QTemporaryDir folder;
    const std::string path = folder.filePath("store.db").toStdString();
    StoreOptions reading, migrating;
    std::vector<std::uint8_t> bytes;
    Columns columns;
    Rows before;
};

TEST_P(FrozenStore, BecomesOneOfTodayWithEveryRow) {
    {
        const Store old = Store::open(path, reading);
        EXPECT_EQ(old.found_schema(), GetParam());
        expect_sound(old);
    }
    for (const char* table : {"person", "cohort_member", "audit_entry"})
        EXPECT_FALSE(before[table].empty()) << table;
    EXPECT_EQ(before.count("trace_chunk"), GetParam() >= 2 ? 1U : 0U);
    {
        const Store store = Store::open(path, migrating);
        EXPECT_EQ(store.found_schema(), latest_schema_version());
        expect_all_rows(store.connection());
        expect_sound(store);
    }
    const Store store = Store::open(path);
    EXPECT_EQ(store.interrupted_at_open().size(), GetParam() >= 2 ? 1U : 0U)
        << "the attempt whose program was killed";
    const Session station = store.station_session();
    ExternalAttempt box =
        box_attempt(People(store).ensure_synthetic(station, "external-box", "Box", PersonKind::external).id);
    box.performed = store.now() - 1000;
    const std::string imported = ExternalAttempts(store).add(station, box);
    EXPECT_EQ(ExternalAttempts(store).trace(station, imported), box_trace);
    expect_sound(store);
    store.connection().execute("UPDATE person SET display_name = 'Forged' WHERE login_key = 'ann'");
    EXPECT_FALSE(store.check(store.station_session()).ok) << "edits are found from then on";
}

TEST_P(FrozenStore, AKilledStartKeepsAUsableStoreAndTheNextStartFinishes) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    const Sweep sweep = kill_at(
        3, [this] { Store::open(path, migrating); }, [this](const std::string& when) { expect_copy(when); });
    EXPECT_GT(sweep.kills, 0);
    sweeps()[GetParam()].start = sweep;
    std::printf("schema %d: a start killed at %d changes to files\n", GetParam(), sweep.kills);
}

TEST_P(FrozenStore, AKilledMigrateCommandLeavesTheOldStoreOrTheNewOne) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    const Sweep sweep = kill_at(
        2, [this] { migrate_store(path, migrating); },
        [this](const std::string& when) {
            Connection connection(path, false, false, 100);
            const int found = read_schema_version(connection);
            EXPECT_TRUE(found == GetParam() || found == latest_schema_version())
                << when << ": schema " << found;
        });
    EXPECT_GT(sweep.kills, 0);
    sweeps()[GetParam()].command = sweep;
    std::printf("schema %d: db migrate killed at %d changes to files\n", GetParam(), sweep.kills);
}

INSTANTIATE_TEST_SUITE_P(Schemas, FrozenStore, ::testing::ValuesIn(older_versions()),
                         [](const ::testing::TestParamInfo<int>& info) {
                             return std::to_string(info.param);
                         });

/// A store of today's schema with rows in its tables. FULCRUM_FREEZE=FOLDER writes it there, for the time
/// when there is a newer schema.
TEST(FreezeStore, OfTodaysSchemaIsWholeAndHasRows) {
    Programme programme;
    const Session &educator = programme.session("educator"), &ann = programme.session("ann");
    const std::string first = programme.record("ann"), second = programme.record("ben", false, 30.5);
    const Reviews reviews(*programme.store);
    reviews.mark_read(ann, reviews.write(educator, first, 1.5, "Keep the tip in view", true));
    reviews.write(educator, second, 0.5, "A draft that was not sent", false);
    programme.attempts().void_attempt(educator, programme.record("ann", true, 81.25),
                                      "The wrong trainee was signed in");
    programme.attempts().request_correction(programme.session("ben"), second, "The device froze");
    Tissues(*programme.store).set(educator, "B2", 0, {{"areolar", {{"penetrate_n", 1.25}}}}, "Measured here");
    Standings(*programme.store)
        .decide(educator, programme.id("ben"), "A3", StandingOverride::Kind::unlocked, "Did it elsewhere");
    const std::vector<ObserverForm> forms = load_forms(asset_path("forms"));
    const Ratings ratings(*programme.store);
    const std::string rating = ratings.begin(educator, first, forms.front());
    ratings.answer(educator, rating, FormAnswers(forms.front().items.size(), 3),
                   std::vector<bool>(forms.front().items.size(), true), "steady");
    ratings.hand_in(educator, rating);
    ratings.release(educator, first);
    GoalWish wish;
    wish.target = 3;
    const Goals goals(*programme.store);
    goals.change(ann, goals.set(ann, wish, 20000), wish, 20000);
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("eve"), programme.id("ann"), "entered twice");
    ExternalAttempts(*programme.store).add(educator, box_attempt(programme.id("ben")));
    programme.record_broken("ben");
    const std::string path = programme.path, copy = path + ".frozen";
    {
        StoreOptions options = programme.clock.options();
        options.close_interrupted = false;  // it stays as the killed program left it
        const Store store = Store::open(path, options);
        EXPECT_TRUE(store.check(store.station_session()).ok);
    }
    programme.store.reset();
    {
        Connection connection(path, false, false, 100);
        connection.execute("VACUUM INTO '" + QString::fromStdString(copy) + "'");
    }
    const char* frozen = std::getenv("FULCRUM_FREEZE");
    if (frozen == nullptr) return;
    std::ifstream file(copy, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}},
        packed = pack_bytes(bytes, 19);
    char name[64];
    std::snprintf(name, sizeof name, "/schema-%02d.db.zst", latest_schema_version());
    std::ofstream(frozen + std::string(name), std::ios::binary)
        .write(reinterpret_cast<const char*>(packed.data()), static_cast<std::streamsize>(packed.size()));
}

}  // namespace
}  // namespace fulcrum::database::test
