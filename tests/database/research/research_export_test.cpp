// SPDX-License-Identifier: GPL-3.0-or-later
// The export for research names nobody, shows no exact day, and no count of fewer than five people can be
// read from its tables of counts or computed from them. Rows of single people give smaller ones, and say so.
#include "database/research/research_export.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "database/records/person_merge.h"
#include "database/research/suppression.h"
#include "database/rows/connection.h"
#include "database/sync/server_link.h"
#include "tests/database/programme_fixture.h"
#include "tests/database/station_keys.h"

namespace fulcrum::database {
namespace {

using test::error_kind;
using test::Programme;

CountTable random_table(std::mt19937_64& random) {
    const std::size_t rows = 1 + random() % 5, columns = 1 + random() % 5;
    CountTable table;
    table.counts.assign(rows + 1, std::vector<long long>(columns + 1, 0));
    for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            const auto count = static_cast<long long>(random() % 3 == 0 ? random() % 5 : random() % 40);
            for (const std::size_t down : {r, rows})
                for (const std::size_t across : {c, columns}) table.counts[down][across] += count;
        }
    }
    for (const auto& line : table.counts) table.people.emplace_back(line.begin(), line.end());
    return table;
}

/// Whether the sums of all lines and what is shown give the value of this hidden count.
bool follows(const std::vector<std::vector<std::optional<long long>>>& shown, std::size_t row,
             std::size_t column) {
    std::vector<std::pair<std::size_t, std::size_t>> hidden;
    for (std::size_t r = 0; r < shown.size(); ++r)
        for (std::size_t c = 0; c < shown[r].size(); ++c)
            if (!shown[r][c]) hidden.emplace_back(r, c);
    const auto lines = static_cast<Eigen::Index>(shown.size() + shown[0].size());
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(lines + 1, static_cast<Eigen::Index>(hidden.size()));
    for (std::size_t k = 0; k < hidden.size(); ++k) {
        const auto [r, c] = hidden[k];
        const auto at = static_cast<Eigen::Index>(k);
        // In a row the last count is the sum of the others, and in a column too.
        sums(static_cast<Eigen::Index>(r), at) = c + 1 == shown[r].size() ? -1 : 1;
        sums(static_cast<Eigen::Index>(shown.size() + c), at) = r + 1 == shown.size() ? -1 : 1;
        if (r == row && c == column) sums(lines, at) = 1;
    }
    const auto rank = [](const Eigen::MatrixXd& matrix) {
        return Eigen::FullPivLU<Eigen::MatrixXd>(matrix).rank();
    };
    return rank(sums) == rank(sums.topRows(lines));
}

TEST(Suppression, NoHiddenCountFollowsFromWhatIsShown) {
    std::mt19937_64 random{20261126};
    int hidden = 0, added = 0;
    for (int round = 0; round < 400; ++round) {
        const CountTable table = random_table(random);
        const auto shown = suppress_small(table);
        for (std::size_t r = 0; r < shown.size(); ++r) {
            for (std::size_t c = 0; c < shown[r].size(); ++c) {
                if (shown[r][c]) {
                    EXPECT_GE(*shown[r][c], least_people);
                    EXPECT_EQ(*shown[r][c], table.counts[r][c]);
                    continue;
                }
                ++hidden;
                added += table.counts[r][c] >= least_people ? 1 : 0;
                ASSERT_FALSE(follows(shown, r, c)) << "round " << round << ", row " << r << ", column " << c;
            }
        }
    }
    EXPECT_GT(hidden, 500);
    EXPECT_GT(added, 100) << "counts that would have given a small one away";
}

TEST(Suppression, ShowsATableWithoutSmallCountsWhole) {
    const std::vector<std::vector<long long>> counts = {{6, 7, 13}, {8, 9, 17}, {14, 16, 30}};
    CountTable table{counts, {}};
    for (const auto& line : counts) table.people.emplace_back(line.begin(), line.end());
    const auto whole = suppress_small(table);
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(whole[r][c], counts[r][c]);
    table.people[0][0] = 2;  // many attempts of two people
    const auto safe = suppress_small(table);
    EXPECT_FALSE(safe[0][0]);
    EXPECT_FALSE(follows(safe, 0, 0));
}

class Research : public ::testing::Test {
  protected:
    Research() {
        for (const char* login : {"fay", "gus", "hal", "ida"}) {
            const auto created = programme.people().create(programme.session("administrator"), login,
                                                           std::string("Person ") + login, {Role::trainee});
            const Session first = programme.people().sign_in(login, created.one_time_password);
            programme.sessions.emplace(
                login, programme.people().change_password(first, created.one_time_password, test::password));
        }
    }
    void record(const std::string& login, const std::string& task, DeviceClass devices, bool passed = true) {
        AttemptMeta meta = test::example_meta(programme.id(login), task);
        meta.device_class = devices;
        Recorder recorder(programme.path, programme.session(login), meta, programme.clock.options());
        recorder.finish(test::example_result(passed, 70.123456));
        programme.clock.pass_s(86400);
    }
    void record_all() {
        for (const char* login : everybody) record(login, "A2", DeviceClass::mouse_keyboard, login[0] < 'f');
        for (const char* login : {"ann", "ben"}) record(login, "A2", DeviceClass::haptic);
        for (const char* login : {"ann", "ben", "eve"}) record(login, "B1", DeviceClass::mouse_keyboard);
    }
    static const ResearchTable& table(const ResearchExport& research, const std::string& name) {
        for (const ResearchTable& one : research.tables)
            if (one.name == name) return one;
        throw std::logic_error(name);
    }

    static constexpr const char* everybody[] = {"ann", "ben", "eve", "fay", "gus", "hal", "ida"};
    Programme programme;
    const Session& director = programme.session("director");
};

TEST_F(Research, NamesNobodyAndShowsNoDateAndNoExactValue) {
    record_all();
    const ResearchExport research = research_export(*programme.store, director);
    std::string all;
    for (const ResearchTable& one : research.tables) all += research.csv(one);
    EXPECT_NE(all.find("A2"), std::string::npos);
    std::vector<std::string> secrets = {"2026", "mouse and keyboard", "Year 1", "70.12", "812.5", "12026-"};
    for (const char* sql :
         {"SELECT id FROM person", "SELECT login FROM person", "SELECT display_name FROM person",
          "SELECT id FROM attempt", "SELECT id FROM score", "SELECT id FROM station", "SELECT id FROM cohort",
          "SELECT seed FROM attempt", "SELECT started FROM attempt", "SELECT program_version FROM attempt",
          "SELECT limits FROM attempt"}) {
        Query rows(programme.store->connection(), sql);
        while (rows.next()) {
            secrets.push_back(rows.text(0));
            if (rows.text(0).size() == 36) secrets.push_back(rows.text(0).substr(24));
        }
    }
    for (const std::string& secret : secrets) EXPECT_EQ(all.find(secret), std::string::npos) << secret;
    std::set<std::string> ids;
    for (const auto& row : table(research, "attempts").rows) ids.insert(row[0]);
    const ResearchExport again = research_export(*programme.store, director);
    for (const auto& row : table(again, "attempts").rows) EXPECT_EQ(ids.count(row[0]), 0U) << "drawn again";
    for (const ResearchTable& one : research.tables)
        for (const ResearchColumn& column : one.columns)
            EXPECT_NE(research.dictionary().find(one.name + ".csv," + column.name), std::string::npos);
    EXPECT_EQ(Audit(*programme.store).entries(programme.session("administrator")).front().operation,
              "programme.export_research");
}

TEST_F(Research, PutsSmallGroupsTogetherOrLeavesThemOut) {
    record_all();
    const ResearchExport research = research_export(*programme.store, director);
    EXPECT_EQ(research.people, 7);
    EXPECT_EQ(research.attempts, 9);
    EXPECT_EQ(research.left_out, 3) << "B1 has three people";
    for (const auto& row : table(research, "attempts").rows) {
        EXPECT_EQ(row[2], "A2");
        EXPECT_EQ(row[3], "any") << "two people with a device with force";
    }
    const auto& people = table(research, "people_by_task").rows;
    ASSERT_EQ(people.size(), 1U);
    EXPECT_EQ(people[0][1], "<5 or hidden") << "three passed";
    EXPECT_EQ(people[0][2], "<5 or hidden") << "it would follow from the total";
    EXPECT_EQ(people[0][3], "7");
    // The rows of single people give what that table hides. The dictionary, which is with the files, says so.
    std::set<std::string> passed;
    for (const auto& row : table(research, "attempts").rows)
        if (row[9] == "1") passed.insert(row[0]);
    EXPECT_EQ(passed.size(), 3U);
    for (const char* words :
         {"smaller counts follow from these rows", "hidden counts follow from attempts.csv"})
        EXPECT_NE(research.dictionary().find(words), std::string::npos) << words;
}

TEST_F(Research, LeavesOutWhatWasRecordedElsewhere) {
    record_all();
    for (const char* login : everybody) record(login, "external-by-Fay", DeviceClass::mouse_keyboard);
    const ResearchExport research = research_export(*programme.store, director);
    EXPECT_EQ(research.attempts, 9);
    for (const ResearchTable& one : research.tables)
        EXPECT_EQ(research.csv(one).find("by-Fay"), std::string::npos) << one.name;
}

TEST_F(Research, LeavesOutPracticeThatContinuesAnotherAttempt) {
    record_all();
    for (const char* login : everybody) {
        AttemptMeta meta = test::example_meta(programme.id(login));
        meta.mode = AttemptMode::practice;
        meta.origin.emplace();
        meta.origin->tick = 4200;
        meta.origin->build = "a build";
        meta.origin->state = {1, 2, 3};
        AttemptResult part = test::example_result(true, 70);
        part.score.reset();
        Recorder(programme.path, programme.session(login), meta, programme.clock.options()).finish(part);
    }
    const ResearchExport research = research_export(*programme.store, director);
    EXPECT_EQ(research.attempts, 9);
    EXPECT_EQ(research.left_out, 3);
}

TEST_F(Research, CountsAMergedPersonOnceAndNoSimulatedOrVoidedOne) {
    record_all();
    const Session station = programme.store->station_session();
    const Person synthetic = programme.people().ensure_synthetic(station, "synthetic-1", "Synthetic");
    {
        AttemptMeta meta = test::example_meta(synthetic.id);
        meta.device_class = DeviceClass::synthetic;
        Recorder recorder(programme.path, station, meta, programme.clock.options());
        recorder.finish(test::example_result(true, 70));
    }
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("ida"), programme.id("hal"), "entered twice");
    EXPECT_EQ(research_export(*programme.store, director).people, 6);
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("gus"), programme.id("hal"), "entered twice");
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("fay"), programme.id("hal"), "entered twice");
    EXPECT_EQ(error_kind([&] { research_export(*programme.store, director); }), StoreErrorKind::conflict)
        << "four people are left";
}

TEST_F(Research, IsRefusedAtAStationOfSomeCohorts) {
    record_all();
    const test::KeysOfOneTest keys;
    ServerLink link;  // as an enrolment leaves it
    link.address = ServerAddress::parse("postgresql://station_1@server/fulcrum");
    link.server_id = "server";
    link.password = "secret";
    link.cohorts = {programme.cohort};
    link.finish(programme.store->station_id(), "1");
    EXPECT_EQ(error_kind([&] { research_export(*programme.store, director); }), StoreErrorKind::conflict)
        << "the counts of the other cohorts would be the difference to the whole programme's";
    EXPECT_THROW(research_export(*programme.store, programme.session("educator")), AccessDenied)
        << "says nothing else to others";
    EXPECT_NE(Audit(*programme.store).entries(programme.session("administrator")).front().operation,
              "programme.export_research");
    link.cohorts.clear();
    link.finish(programme.store->station_id(), "2");
    EXPECT_EQ(research_export(*programme.store, director).people, 7) << "it has everybody";
}

TEST_F(Research, AFolderKeepsItsExportWholeWhereAFileOfTheNextCannotBeWritten) {
    record_all();
    const ResearchExport research = research_export(*programme.store, director);
    const std::filesystem::path folder = programme.folder.filePath("research").toStdString();
    std::filesystem::create_directories(folder / "people_by_task.csv");  // no file can have this name
    std::ofstream(folder / "attempts.csv") << "the export before";
    EXPECT_THROW(write_research_files(research, folder.string()), std::system_error);
    std::string kept;
    std::getline(std::ifstream(folder / "attempts.csv"), kept);
    EXPECT_EQ(kept, "the export before");
    const auto names = [&] {
        std::set<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            found.insert(entry.path().filename().string());
        return found;
    };
    EXPECT_EQ(names(), (std::set<std::string>{"attempts.csv", "people_by_task.csv"})) << "nothing is left";
    std::filesystem::remove(folder / "people_by_task.csv");
    EXPECT_EQ(write_research_files(research, folder.string()).size(), 5U);
    EXPECT_EQ(names(), (std::set<std::string>{"attempts.csv", "attempts_by_task.csv", "dictionary.csv",
                                              "metrics.csv", "people_by_task.csv"}));
}

TEST_F(Research, IsTheDirectorsAlone) {
    record_all();
    for (const char* login : {"ann", "educator", "administrator"})
        EXPECT_THROW(research_export(*programme.store, programme.session(login)), AccessDenied) << login;
    EXPECT_THROW(research_export(*programme.store, programme.store->station_session()), AccessDenied);
}

}  // namespace
}  // namespace fulcrum::database
