// SPDX-License-Identifier: GPL-3.0-or-later
// All that is stored about a person, as a folder for that person.
#include "database/sync/person_data.h"

#include <zlib.h>
#include <QDir>
#include <algorithm>
#include <fstream>

#include "database/records/person_merge.h"
#include "database/sync/erasure.h"
#include "database/sync/station_erasure.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/external_example.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

class PersonalData : public ::testing::Test {
  protected:
    PersonalData() {
        attempt = programme.record("ann", true, 70, "A2", {Programme::slip()});
        programme.record("ben");
        Reviews(*programme.store)
            .write(programme.session("educator"), attempt, 1, "Mind the <left> hand", true);
    }
    PersonDataExport write(const std::string& folder, const std::string& login = "director",
                           const std::string& person = "ann", const StoreProgress& progress = {}) const {
        return export_person_data(*programme.store, programme.session(login), programme.id(person), folder,
                                  progress);
    }
    std::string in(const std::string& name) const {
        return programme.folder.filePath(QString::fromStdString(name)).toStdString();
    }
    static std::string text_of(const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    static int lines_of(const std::string& path) {
        const std::string text = text_of(path);
        return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    }
    static int packed_lines_of(const std::string& path) {
        gzFile file = gzopen(path.c_str(), "rb");
        if (file == nullptr) return -1;
        int lines = 0;
        char buffer[4096];
        for (int got = 0; (got = gzread(file, buffer, sizeof buffer)) > 0;)
            lines += static_cast<int>(std::count(buffer, buffer + got, '\n'));
        gzclose(file);
        return lines;
    }
    Programme programme;
    std::string attempt;
};

TEST_F(PersonalData, HoldsEveryRowOfThePersonAndNobodyElses) {
    const PersonDataExport planned = write("");
    const PersonDataExport done = write(in("ann"));
    EXPECT_EQ(done.traces, 1);
    ASSERT_EQ(planned.rows.size(), done.rows.size());
    std::map<std::string, std::int64_t> rows;
    for (const ErasedRows& one : done.rows) rows[one.table] = one.rows;
    for (const ErasedRows& one : planned.rows) EXPECT_EQ(rows[one.table], one.rows) << one.table;
    // Whatever an erasure would delete is there: a table that is added there is exported too.
    for (const ErasedRows& one : rows_to_erase(programme.store->connection(), programme.id("ann"))) {
        EXPECT_EQ(rows[one.table], one.rows) << one.table;
        EXPECT_EQ(lines_of(in("ann/tables/" + one.table + ".csv")), one.rows + 1) << one.table;
    }
    EXPECT_EQ(rows["person"], 1);
    EXPECT_EQ(rows["attempt"], 1);
    EXPECT_EQ(rows["comment"], 1);
    EXPECT_GT(rows["audit_entry"], 3);
    EXPECT_EQ(packed_lines_of(in("ann/traces/" + attempt + "-samples.csv.gz")), 1001);
    EXPECT_NE(text_of(in("ann/traces/" + attempt + "-events.csv")).find("slip"), std::string::npos);
    std::string all;
    for (const auto& entry : files::recursive_directory_iterator(in("ann"))) {
        if (!entry.is_regular_file()) continue;
        EXPECT_EQ(entry.status().permissions() & files::perms(0077), files::perms::none) << entry.path();
        all += text_of(entry.path().string());
    }
    EXPECT_NE(all.find("Ann Trainee"), std::string::npos);
    EXPECT_NE(all.find("Mind the <left> hand"), std::string::npos);
    EXPECT_EQ(all.find("Ben Trainee"), std::string::npos);
    EXPECT_EQ(all.find("$argon2"), std::string::npos) << "the verifier of the password";
    const std::string index = text_of(in("ann/index.html"));
    EXPECT_NE(index.find("Test programme"), std::string::npos);
    EXPECT_NE(index.find("tables/score.csv"), std::string::npos);
    EXPECT_NE(index.find(attempt + "-samples.csv.gz"), std::string::npos);
}

TEST_F(PersonalData, EveryTableOfAnErasureHasATitle) {
    for (const RowsAbout& one : rows_about_people())
        EXPECT_NE(title_of_table(one.table).words(), one.table) << "give it one in person_data.cpp";
}

TEST_F(PersonalData, IsWrittenByDirectorsOnlyAndTheAuditLogHasIt) {
    for (const char* login : {"administrator", "educator", "ann", "ben"})
        EXPECT_THROW(write(in("x"), login), AccessDenied) << login;
    EXPECT_FALSE(files::exists(in("x")) || files::exists(in("x.part")));
    write(in("x"));
    const auto entries = Audit(*programme.store).entries(programme.session("administrator"));
    EXPECT_EQ(entries.front().operation, "person.export");
    EXPECT_EQ(entries.front().person_id, programme.id("ann"));
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
    EXPECT_EQ(error_kind([&] { write(in("x")); }), StoreErrorKind::exists);
    EXPECT_EQ(error_kind([&] { write(in("none/x")); }), StoreErrorKind::read_only);
    EXPECT_THROW(export_person_data(*programme.store, programme.session("director"), "nobody", in("y")),
                 AccessDenied);
}

TEST_F(PersonalData, HasWhatBelongsToAMergedAccountToo) {
    const std::string second = programme.record("eve");
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("eve"), programme.id("ann"), "one person");
    write(in("ann"));
    EXPECT_EQ(lines_of(in("ann/tables/attempt.csv")), 3);
    EXPECT_EQ(lines_of(in("ann/tables/person.csv")), 3);
    EXPECT_TRUE(files::exists(in("ann/traces/" + second + "-samples.csv.gz")));
}

TEST_F(PersonalData, HasTheRecordingsThatWereImported) {
    const std::string imported = ExternalAttempts(*programme.store)
                                     .add(programme.session("educator"), box_attempt(programme.id("ann")));
    EXPECT_EQ(write("").traces, 2);
    EXPECT_EQ(write(in("ann")).traces, 2);
    EXPECT_EQ(packed_lines_of(in("ann/traces/" + imported + "-trace.csv.gz")), 4);
    EXPECT_NE(text_of(in("ann/index.html")).find("traces/" + imported + "-trace.csv.gz"), std::string::npos);
}

TEST_F(PersonalData, StoppedItLeavesNothing) {
    const PersonDataExport done =
        write(in("x"), "director", "ann", [](double, const std::string&) { return false; });
    EXPECT_TRUE(done.stopped);
    EXPECT_FALSE(files::exists(in("x")) || files::exists(in("x.part")));
    EXPECT_NE(Audit(*programme.store).entries(programme.session("administrator")).front().operation,
              "person.export");
}

TEST_F(PersonalData, ReportsHowFarItIsAndIsStoppedAlsoWhileItOnlyCounts) {
    for (const char* folder : {"", "x"}) {
        const std::string path = *folder == '\0' ? std::string() : in(folder);
        std::vector<double> shares;
        write(path, "director", "ann", [&shares](double share, const std::string&) {
            shares.push_back(share);
            return true;
        });
        ASSERT_GT(shares.size(), 20U) << "at each table";
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end())) << folder;
        EXPECT_GE(shares.front(), 0);
        EXPECT_LT(shares.back(), 1);
    }
    std::size_t asked = 0;
    const PersonDataExport counted =
        write("", "director", "ann", [&asked](double, const std::string&) { return ++asked < 5; });
    EXPECT_TRUE(counted.stopped);
    EXPECT_TRUE(counted.rows.empty());
    EXPECT_EQ(asked, 5U);
}

TEST_F(PersonalData, KilledItLeavesNoFolderThatLooksCompleteAndTheNextTryWorks) {
    if (!can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    programme.store.reset();
    const auto deed = [&] {
        const Store store = Store::open(programme.path, programme.clock.options());
        export_person_data(store, programme.session("director"), programme.id("ann"), in("x"));
    };
    const CutOff whole = cut_off(0, deed);
    ASSERT_EQ(whole.status, 0);
    const auto count = [&] {
        return std::distance(files::recursive_directory_iterator(in("x")),
                             files::recursive_directory_iterator());
    };
    const auto complete = count();
    int kills = 0;
    for (const int point : cut_off_points(whole.changes, 10)) {
        files::remove_all(in("x"));
        const CutOff cut = cut_off(point, deed);
        if (!cut.killed) continue;
        ++kills;
        if (files::exists(in("x"))) {
            EXPECT_EQ(count(), complete) << cut.call;
            files::remove_all(in("x"));
        }
        deed();
        EXPECT_EQ(count(), complete) << cut.call;
        EXPECT_FALSE(files::exists(in("x.part")));
        if (HasFailure()) break;
    }
    EXPECT_GT(kills, 0);
}

}  // namespace
}  // namespace fulcrum::database::test
