// SPDX-License-Identifier: GPL-3.0-or-later
// A value of the page of validity has the version of the metric that it was measured with.
#include "app/lab/validity.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "assessment/metrics/registry.h"
#include "sim_core/scene/json_document.h"
#include "tests/support/own_folder.h"
#include "tests/support/support.h"

namespace fulcrum::app {
namespace {

using nlohmann::json;

json row_of_metric(const char* metric, const json& version, const json& values) {
    return {{"metric", metric},  {"hand", json()},   {"auc", 0.9},        {"retest", json()},
            {"separates", true}, {"values", values}, {"version", version}};
}

std::string page_of(const std::vector<json>& metrics) {
    const test::OwnFolder folder;
    const json gate = {{"metric", "f_max"}, {"hand", "left"}, {"failed", {0, 1, 2}}, {"safety", ""}};
    std::ofstream(folder / "operators_B9.json")
        << json{{"metrics", metrics}, {"gates", json::array({gate})}, {"seeds", 60}, {"passed", {50, 10, 0}}};
    std::ofstream(folder / "lab_invariance.json") << json{{"metrics", json::object()}};
    return validity_page(folder.path().string()).page.text({});
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(ValidityPage, SaysWhichValuesAreOfAnotherVersion) {
    const int time = find_metric("time")->version, force = find_metric("f_max")->version;
    const std::string page =
        page_of({row_of_metric("time", time, {60, 60, 60}), row_of_metric("f_max", force + 1, {1, 60, 58}),
                 row_of_metric("idle", json(), json())});
    EXPECT_TRUE(contains(page, "| `time` (v" + std::to_string(time) + ") |")) << page;
    const std::string measured = "measured with v" + std::to_string(force + 1);
    EXPECT_TRUE(contains(page, "| `f_max` (v" + std::to_string(force) + "; B9: " + measured + ") |")) << page;
    EXPECT_TRUE(contains(page, "; B9: version not recorded) |")) << page;
    EXPECT_TRUE(contains(page, "| 0.9 [1 and 58 values] |")) << "an AUC of few values: " << page;
    EXPECT_TRUE(contains(page, "| B9 | f_max | left | 0 | 1 | 2 | 60 |  | " + measured + " |")) << page;
}

TEST(ValidityPage, OfTheOldResultsSaysThatVersionsAreNotRecorded) {
    json old = row_of_metric("f_max", json(), json());
    old.erase("version");
    old.erase("values");
    EXPECT_TRUE(contains(page_of({old}), "B9: version not recorded"));
}

/// The first cells of the rows on metrics, and the rows on gates.
std::set<std::string> versions_on(const std::string& page) {
    std::set<std::string> found;
    bool gates = false;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, 3, "## ") == 0) gates = line == "## Gates";
        if (line.compare(0, 3, "| `") == 0) found.insert(line.substr(0, line.find(" |", 3)));
        if (gates && line.compare(0, 2, "| ") == 0) found.insert(line);
    }
    return found;
}

// The versions are those of the registry, or the page says which values are of another one.
TEST(ValidityPage, OfTheRepositoryHasTheVersionsOfTheKeptPages) {
    const std::string kept = read_text_file(test::source_path("docs/VALIDITY.md"), 1U << 20U);
    const std::string now = validity_page(test::source_path("docs/results")).page.text({});
    EXPECT_GT(versions_on(kept).size(), 100U);
    EXPECT_EQ(versions_on(kept), versions_on(now))
        << "make it again: fulcrum-lab lab validity docs/results --output docs";
}

}  // namespace
}  // namespace fulcrum::app
