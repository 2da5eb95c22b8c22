// SPDX-License-Identifier: Apache-2.0
// The hand study as `fulcrum lab run` calls it.
#include "sim_core/lab/hand_study.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "sim_core/lab/studies.h"
#include "sim_core/numerics/types.h"
#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

nlohmann::json run_hand(const std::string& text) {
    return lab::run_hand_study(JsonDocument::parse(text, "hand.json"));
}

Vector3 hand_force_of(const nlohmann::json& result, std::size_t number) {
    const auto& f = result["cases"][number]["hand_force"];
    return {f[0].get<double>(), f[1].get<double>(), f[2].get<double>()};
}

TEST(HandStudy, CarriesLoadsThroughTheTrocar) {
    const nlohmann::json result = run_hand(R"({"model": "hand", "trocar": [0.1, 0.2, 0.3], "cases": [
        {"handle": [0.1, 0.2, 0.4], "loads": [{"at": [0.1, 0.2, 0.1], "force": [1, 0, 2]}]},
        {"handle": [0.1, 0.2, 0.4], "loads": [{"at": [0.1, 0.2, 0.1], "force": [1, 0, 0]},
                                              {"at": [0.1, 0.2, 0.2], "force": [0, 4, 0]}]},
        {"handle": [0.2, 0.2, 0.3], "loads": []}]})");
    ASSERT_EQ(result["cases"].size(), 3U);
    EXPECT_NEAR((hand_force_of(result, 0) - Vector3(-2, 0, 2)).norm(), 0, 1e-14);
    EXPECT_NEAR((hand_force_of(result, 1) - Vector3(-2, -4, 0)).norm(), 0, 1e-14);
    EXPECT_EQ(hand_force_of(result, 2), Vector3(Vector3::Zero()));
}

TEST(HandStudy, IsAmongTheStudies) {
    const test::OwnFolder folder;
    const std::string path = (folder / "hand.json").string();
    std::ofstream(path) << R"({"model": "hand", "trocar": [0, 0, 0], "cases": [{"handle": [0, 0, 0.1],
        "loads": [{"at": [0, 0, -0.3], "force": [0, 1, 0]}]}]})";
    EXPECT_NEAR((hand_force_of(lab::run_study(path), 0) - Vector3(0, -3, 0)).norm(), 0, 1e-14);
    std::ofstream(path) << R"({"model": "hand", "trocar": [0, 0, 0], "cases": [], "handles": []})";
    EXPECT_THROW(lab::run_study(path), InputError);
}

TEST(HandStudy, RefusesBadInputWithPlaceAndHint) {
    struct Row {
        const char* text;
        const char* place;
    };
    const Row rows[] = {
        {R"({"model": "hand", "cases": []})", "trocar"},
        {R"({"model": "hand", "trocar": [0, 0], "cases": []})", "/trocar"},
        {R"({"model": "hand", "trocar": [0, 0, "a"], "cases": []})", "/trocar/2"},
        {R"({"model": "hand", "trocar": [0, 0, 0]})", "cases"},
        {R"({"model": "hand", "trocar": [0, 0, 0], "cases": {}})", "/cases"},
        {R"({"model": "hand", "trocar": [0, 0, 0], "cases": [3]})", "/cases/0"},
        {R"({"model": "hand", "trocar": [0, 0, 0], "cases": [{"loads": []}]})", "handle"},
        {R"({"model": "hand", "trocar": [0, 0, 0], "cases": [{"handle": [0, 0, 0.1]}]})", "loads"},
        {R"({"model": "hand", "trocar": [0, 0, 0], "cases": [{"handle": [0, 0, 0], "loads": []}]})",
         "/cases/0/handle"},
        {R"({"model": "hand", "trocar": [0, 0, 0], "cases": [{"handle": [0, 0, 90], "loads": []}]})",
         "/cases/0/handle/2"},
        {R"({"model": "hand", "trocar": [0, 0, 0], "cases": [{"handle": [0, 0, 1], "loads": [{"at": [0, 0, 0]}]}]})",
         "/cases/0/loads/0"},
        {R"({"model": "hand", "trocar": [0, 0, 0], "cases": [{"handle": [0, 0, 1], "load": [], "loads": []}]})",
         "/cases/0/load"},
        {R"({"model": "hand", "trocar": [0, 0, 0], "cases": [{"handle": [0, 0, 1],
            "loads": [{"at": [0, 0, 0], "force": [1e300, 0, 0]}]}]})",
         "/cases/0/loads/0/force/0"},
    };
    for (const Row& row : rows) {
        try {
            run_hand(row.text);
            ADD_FAILURE() << row.text;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(row.place), std::string::npos) << error.what();
            EXPECT_FALSE(error.hint().empty()) << row.text;
        }
    }
}

}  // namespace
}  // namespace fulcrum
