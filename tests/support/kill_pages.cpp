// SPDX-License-Identifier: Apache-2.0
#include "tests/support/kill_pages.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "sim_core/lab/result_page.h"

namespace fulcrum::test {
namespace {

using nlohmann::json;

/// In the order of Killed.
constexpr const char* activities[] = {
    "performing an attempt",    "writing an attempt", "reviewing", "exchanging with the programme server",
    "migrating an older store", "backing up",         "restoring", "the first start"};
constexpr int added_up = static_cast<int>(Killed::backing_up) + 1;

/// Of the test that runs; after the last one of a suite, of the suite.
std::string name_of_test() {
    const ::testing::UnitTest& run = *::testing::UnitTest::GetInstance();
    if (const ::testing::TestInfo* test = run.current_test_info())
        return std::string(test->test_suite_name()) + "." + test->name();
    const ::testing::TestSuite* suite = run.current_test_suite();
    return suite == nullptr ? std::string() : std::string(suite->name()) + ".*";
}

bool has_failed() {
    const ::testing::UnitTest& run = *::testing::UnitTest::GetInstance();
    if (const ::testing::TestInfo* test = run.current_test_info()) return test->result()->Failed();
    const ::testing::TestSuite* suite = run.current_test_suite();
    return suite != nullptr && suite->Failed();
}

/// What was entered before; a page that cannot be read is made from nothing.
json rows_in(const std::string& folder) {
    std::ifstream file(std::filesystem::path(folder) / "store.json");
    json document = json::parse(file, nullptr, false);
    if (!document.is_object()) document = json::object();
    for (const char* list : {"kills", "shared"})
        if (!document[list].is_array()) document[list] = json::array();
    return document;
}

/// In place of the entry with the same key.
void put(json& list, const char* key, json entry) {
    for (json& one : list)
        if (one[key] == entry[key]) {
            one = std::move(entry);
            return;
        }
    list.push_back(std::move(entry));
}

std::string number(const json& row, const char* key) {
    return std::to_string(row[key].get<std::size_t>());
}
std::string words(const json& row, const char* key) {
    return row[key].get<std::string>();
}

/// Each activity with its tests, and for the first six their sum.
lab::ResultTable table_of_kills(const json& rows) {
    lab::ResultTable table;
    table.columns = {"while", "test", "kills", "looked for", "of these", "lost or damaged", "time", "commit"};
    std::size_t kills = 0, missing = 0;
    for (int activity = 0; activity < static_cast<int>(std::size(activities)); ++activity) {
        if (activity == added_up)
            table.rows.push_back({"**these six together**", "", "**" + std::to_string(kills) + "**", "", "",
                                  "**" + std::to_string(missing) + "**", "", ""});
        bool measured = false;
        for (const json& row : rows) {
            if (row["activity"] != activities[activity]) continue;
            measured = true;
            if (activity < added_up) {
                kills += row["kills"].get<std::size_t>();
                missing += row["missing"].get<std::size_t>();
            }
            table.rows.push_back({activities[activity], "`" + words(row, "test") + "`", number(row, "kills"),
                                  words(row, "checked"), number(row, "found"), number(row, "missing"),
                                  words(row, "time"), words(row, "commit")});
        }
        if (!measured) table.rows.push_back({activities[activity], "", "not measured", "", "", "", "", ""});
    }
    return table;
}

void write_page(const std::string& folder, const json& document, const lab::Machine& machine) {
    lab::ResultPage page("store", "One store, several programs, and programs that are killed",
                         "FULCRUM_KILLS=400 FULCRUM_STORE_ROUNDS=400 FULCRUM_CUT_OFF=1 FULCRUM_KILLS_PAGE=" +
                             folder + " TEST_PROGRAM --gtest_filter=TEST");
    page.paragraph(
        "Each row is entered by its test, at the commit that it names; the page is written again with each. "
        "A *kill* is `kill -9`: at a random time, or (in the sweeps of migrations, backups and restores) "
        "before one system call that changes a file. After the kills the tests look for everything that was "
        "acknowledged "
        "before, and the whole store is checked: pages, references, audit log, checksums and digests. A row "
        "is "
        "written only where every check of its test has passed. The number of kills is that of the long run; "
        "in the suite the same tests kill a few times.");
    page.table(table_of_kills(document["kills"]));
    if (!document["shared"].empty()) {
        page.paragraph(
            "Several processes use one store file at the same time: some through Fulcrum, some through "
            "`sqlite3`. A score is *acknowledged* when the call that stores it has returned. A write is "
            "*refused* when it does not get its turn within the busy timeout of 5 s.");
        lab::ResultTable table;
        table.columns = {"what", "value", "commit"};
        for (const json& row : document["shared"])
            table.rows.push_back({words(row, "what"), words(row, "value"), words(row, "commit")});
        page.table(table);
    }
    page.document(document);
    page.write(folder, machine);
}

}  // namespace

const char* kill_pages() {
    return has_failed() ? nullptr : std::getenv("FULCRUM_KILLS_PAGE");
}

std::string time_of_test() {
    const ::testing::UnitTest& run = *::testing::UnitTest::GetInstance();
    const ::testing::TestInfo* test = run.current_test_info();
    const ::testing::TestSuite* suite = run.current_test_suite();
    if (test == nullptr && suite == nullptr) return "–";
    const std::int64_t begin = test != nullptr ? test->result()->start_timestamp() : suite->start_timestamp();
    const std::int64_t now = std::chrono::duration_cast<std::chrono::milliseconds>(
                                 std::chrono::system_clock::now().time_since_epoch())
                                 .count();
    const std::int64_t seconds = (now - begin) / 1000;
    const std::string minutes = seconds < 60 ? std::string() : std::to_string(seconds / 60) + " min ";
    return minutes + std::to_string(seconds % 60) + " s";
}

void enter_kills(const KillRow& row, const lab::Machine& machine) {
    const char* const folder = kill_pages();
    if (folder == nullptr) return;
    json document = rows_in(folder);
    put(document["kills"], "test",
        {{"activity", activities[static_cast<int>(row.activity)]},
         {"test", name_of_test()},
         {"kills", row.kills},
         {"checked", row.checked},
         {"found", row.found},
         {"missing", row.missing},
         {"time", time_of_test()},
         {"commit", machine.build.commit}});
    write_page(folder, document, machine);
}

void enter_shared_store(const std::string& what, const std::string& value, const lab::Machine& machine) {
    const char* const folder = kill_pages();
    if (folder == nullptr) return;
    json document = rows_in(folder);
    put(document["shared"], "what", {{"what", what}, {"value", value}, {"commit", machine.build.commit}});
    write_page(folder, document, machine);
}

}  // namespace fulcrum::test
