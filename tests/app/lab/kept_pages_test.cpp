// SPDX-License-Identifier: GPL-3.0-or-later
// What people read in docs/results is enough to write the page of validity again.
#include "app/lab/kept_pages.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/lab/operators.h"
#include "assessment/metrics/invariance.h"
#include "sim_core/lab/machine.h"
#include "sim_core/lab/result_page.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"
#include "tests/support/support.h"

namespace fulcrum::app {
namespace {

constexpr const char* page =
    "# B9: experts, intermediates, novices, 40 seeds from 2000\n\n"
    "AUC: chance ... Of what follows.\n\n"
    "| metric | hand | better | AUC | 95 % interval | separates | retest | expert | intermediate | novice |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
    "| time |  | lower | 0.97 | 0.9 to 1 | yes | 0.92 | 70 (66 to 74) | 92 | 143 |\n"
    "| idle | left | lower | 0.597 | 0.494 to 0.691 | context |  | 8 | 9 | 9 |\n"
    "| lens_contact |  | lower | absent |  | **no** | -0.056 | absent | absent | 0 |\n\n"
    "## Gates\n\n"
    "| gate | hand | experts failed | intermediates failed | novices failed | fails 1 novice in 10, or is "
    "kept "
    "because |\n"
    "| --- | --- | --- | --- | --- | --- |\n"
    "| f_max | left | 0 | 9 | 38 | yes |\n"
    "| drop |  | 1 | 2 | 3 | bowel let fall |\n"
    "| slip |  | 0 | 0 | 0 | no, and no reason is given |\n\n"
    "Of 40 experts, intermediates and novices, completed: 40, 39, 38; passed: 36, 9, 0. Replayed.\n";

TEST(KeptPages, GiveTheResultsOfOperatorsAgain) {
    const nlohmann::json read = read_operators_page(page, "operators_B9.md");
    ASSERT_EQ(read["metrics"].size(), 3U);
    EXPECT_EQ(read["metrics"][0]["auc"], 0.97);
    EXPECT_TRUE(read["metrics"][0]["hand"].is_null());
    EXPECT_EQ(read["metrics"][0]["separates"], true);
    EXPECT_EQ(read["metrics"][1]["hand"], "left");
    EXPECT_TRUE(read["metrics"][1]["separates"].is_null()) << "it describes";
    EXPECT_TRUE(read["metrics"][1]["retest"].is_null());
    EXPECT_TRUE(read["metrics"][2]["auc"].is_null());
    EXPECT_EQ(read["metrics"][2]["separates"], false);
    EXPECT_EQ(read["metrics"][2]["retest"], -0.056);
    ASSERT_EQ(read["gates"].size(), 3U);
    EXPECT_EQ(read["gates"][0]["failed"], nlohmann::json({0, 9, 38}));
    EXPECT_EQ(read["gates"][0]["safety"], "");
    EXPECT_EQ(read["gates"][1]["safety"], "bowel let fall");
    EXPECT_EQ(read["gates"][2]["safety"], "");
    EXPECT_EQ(read["seeds"], 40);
    EXPECT_EQ(read["passed"], nlohmann::json({36, 9, 0}));
}

// Pages from before versions were printed have neither them nor the numbers of values.
TEST(KeptPages, GiveTheVersionsAndNumbersOfValuesWhereTheyHaveThem) {
    const nlohmann::json before = read_operators_page(page, "operators_B9.md");
    EXPECT_TRUE(before["metrics"][0]["version"].is_null());
    EXPECT_TRUE(before["metrics"][0]["values"].is_null());
    std::string text = page;
    const auto append = [&text](const std::string& row, const std::string& cells) {
        const std::size_t at = text.find(row);
        ASSERT_NE(at, std::string::npos) << row;
        text.insert(text.find('\n', at), cells);
    };
    append("| metric | hand |", " values | version |");
    append("| --- | --- | --- | --- | --- | --- | --- |", " --- | --- |");
    append("| time |", " 40, 40, 38 | 2 |");
    append("| idle | left", " 40, 39, 1 | 1 |");
    append("| lens_contact |", " 0, 0, 3 | 1 |");
    const nlohmann::json read = read_operators_page(text, "operators_B9.md");
    EXPECT_EQ(read["metrics"][0]["version"], 2);
    EXPECT_EQ(read["metrics"][0]["values"], nlohmann::json({40, 40, 38}));
    EXPECT_EQ(read["metrics"][1]["values"], nlohmann::json({40, 39, 1}));
    EXPECT_EQ(read["metrics"][1]["auc"], 0.597);

    std::string header = "| metric |", line = "| f_sd |";
    for (const auto& change : trace_changes) {
        header += std::string(" ") + change.title + " |";
        line += " 0.5 % |";
    }
    EXPECT_TRUE(
        read_invariance_page(header + "\n" + line + "\n", "i.md")["metrics"]["f_sd"]["version"].is_null());
    const nlohmann::json changes = read_invariance_page(header + " version |\n" + line + " 3 |\n", "i.md");
    EXPECT_EQ(changes["metrics"]["f_sd"]["version"], 3);
    EXPECT_EQ(changes["metrics"]["f_sd"]["noise"], 0.005);
}

TEST(KeptPages, OfAnotherFormAreRefused) {
    EXPECT_THROW(read_operators_page("# nothing\n", "x.md"), InputError);
    EXPECT_THROW(read_invariance_page(page, "x.md"), InputError);
    std::string cut = page;
    cut.replace(cut.find("| 9 | 38 | yes |"), 16, "| yes |");
    EXPECT_THROW(read_operators_page(cut, "x.md"), InputError);
    cut = page;
    cut.erase(cut.find("; passed: "));
    EXPECT_THROW(read_operators_page(cut, "x.md"), InputError);
}

TEST(KeptPages, OfTheRepositoryAreRead) {
    const auto content = [](const std::string& path) {
        std::stringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    };
    for (const char* task : {"A1", "A2", "A3", "B1", "B2", "B3", "C4"}) {
        const std::string path = test::source_path("docs/results/operators_" + std::string(task) + ".md");
        const nlohmann::json read = read_operators_page(content(path), path);
        EXPECT_GE(read["seeds"].get<int>(), 30) << task;
        EXPECT_EQ(read["passed"].size(), 3U) << task;
        EXPECT_GE(read["gates"].size(), 5U) << task;
    }
    const std::string path = test::source_path("docs/results/lab_invariance.md");
    const nlohmann::json read = read_invariance_page(content(path), path);
    EXPECT_EQ(read["metrics"]["time"]["half_rate"], 0.0);
    EXPECT_GT(read["metrics"]["ldlj"]["noise"].get<double>(), 0.0);
}

TEST(PassesByDevice, AreWrittenAsAPageWithItsDocument) {
    const test::OwnFolder folder;
    // B0 is judged the same way with every device: nobody performs for this.
    const Measured measured = measure_passes({"B0"}, 6);
    EXPECT_GE(measured.page.write(folder.path().string(), lab::this_machine(lab::build_info())).size(), 2U);
    EXPECT_TRUE(measured.document.contains("passes"));
}

}  // namespace
}  // namespace fulcrum::app
