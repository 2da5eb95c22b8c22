// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum curriculum rule, fit, agreement and fulcrum benchmark statistics: the documented keys, and what is
// refused with file, row, column and a hint.
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

class StatisticsCommands : public ::testing::Test {
  protected:
    nlohmann::json run(std::vector<std::string> words) const {
        words.emplace_back("--json");
        std::ostringstream output;
        std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
        int status = 1;
        try {
            status = run_command(words);
        } catch (...) {
            std::cout.rdbuf(before);
            throw;
        }
        std::cout.rdbuf(before);
        EXPECT_EQ(status, 0);
        return nlohmann::json::parse(output.str());
    }
    std::string refusal(const std::vector<std::string>& words) const {
        try {
            run(words);
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    }
    std::string file(const std::string& text, const char* name = "values.csv") {
        const std::string path = (folder_ / name).string();
        std::ofstream(path) << text;
        return path;
    }

    fulcrum::test::OwnFolder folder_;
};

TEST_F(StatisticsCommands, RuleGivesItsOperatingPoint) {
    const nlohmann::json two =
        run({"curriculum", "rule", "--rule", "row:2", "--q", "0.5", "--attempts", "30"});
    EXPECT_NEAR(two["declared"].get<double>(), 0.998, 5e-4);
    EXPECT_EQ(two["median_attempts"], 4);
    const nlohmann::json never = run({"curriculum", "rule", "--rule", "lc-cusum:0.1,0.3,2.5", "--q", "0"});
    EXPECT_EQ(never["declared"], 0);
    EXPECT_TRUE(never["median_attempts"].is_null());
    EXPECT_TRUE(never["mean_attempts_if_declared"].is_null());
    EXPECT_NE(refusal({"curriculum", "rule", "--rule", "best:2", "--q", "0.5"}).find("is not a rule"),
              std::string::npos);
    EXPECT_NE(refusal({"curriculum", "rule", "--rule", "row:2", "--q", "1.5"}).find("--q"),
              std::string::npos);
    EXPECT_NE(refusal({"curriculum", "rule", "--q", "0.5"}).find("--rule"), std::string::npos);
    for (const char* rule : {"row:1", "of:1,1"})
        EXPECT_NE(
            refusal({"curriculum", "rule", "--rule", rule, "--q", "0.5"}).find("asks for passes on two days"),
            std::string::npos)
            << rule;
}

TEST_F(StatisticsCommands, CheckRefusesACurriculumWithARuleThatNobodyCanMeet) {
    std::string text = read_text_file(asset_path("curricula/rectal.json"), 1U << 20U);
    EXPECT_EQ(run_command({"check", file(text, "rectal.json")}), 0);
    const std::string rule = "lc-cusum:0.1,0.3,2.5";
    text.replace(text.find(rule), rule.size(), "row:1");
    EXPECT_EQ(run_command({"check", file(text, "rectal.json")}), 2);
}

TEST_F(StatisticsCommands, FitGivesThreeModels) {
    std::string text = "x,y\n";
    for (int x = 1; x <= 20; ++x) text += std::to_string(x) + "," + std::to_string(10.0 + 50.0 / x) + "\n";
    const nlohmann::json fit = run({"curriculum", "fit", file(text)});
    EXPECT_EQ(fit["best"], "inverse");
    ASSERT_EQ(fit["models"].size(), 3U);
    EXPECT_EQ(fit["models"][1]["name"], "power");
    EXPECT_NEAR(fit["models"][0]["plateau"].get<double>(), 10, 1e-4);
    for (const char* key : {"parameters", "rss", "aicc", "plateau_low", "plateau_high"})
        EXPECT_TRUE(fit["models"][2].contains(key)) << key;
    EXPECT_NE(refusal({"curriculum", "fit", file("x,y\n1,2\n")}).find("too few"), std::string::npos);
    EXPECT_NE(refusal({"curriculum", "fit", file("x,y\n1,2\n3,2\n")}).find(":3: x"), std::string::npos);
    EXPECT_NE(refusal({"curriculum", "fit", file("x,y\n1,two\n")}).find(":2: y: 'two' is not a number"),
              std::string::npos);
    EXPECT_NE(refusal({"curriculum", "fit", file("x,z\n1,2\n")}).find("the column is missing"),
              std::string::npos);
    EXPECT_NE(refusal({"curriculum", "fit", file("")}).find("empty"), std::string::npos);
    EXPECT_NE(refusal({"curriculum", "fit", file("x,y\n1\n")}).find("1 cells"), std::string::npos);
    EXPECT_NE(refusal({"curriculum", "fit", "/nowhere.csv"}).find("cannot be read"), std::string::npos);
}

TEST_F(StatisticsCommands, AgreementNeedsACompleteTable) {
    const std::string complete =
        "target,rater,score\na,x,9\na,y,2\na,z,5\nb,x,6\nb,y,1\nb,z,3\nc,x,8\nc,y,4\nc,z,6\n";
    const nlohmann::json agreement = run({"curriculum", "agreement", file(complete)});
    for (const char* form : {"1,1", "2,1", "3,1", "1,k", "2,k", "3,k"}) {
        const nlohmann::json& one = agreement["icc"][form];
        EXPECT_LE(one["low"].get<double>(), one["value"].get<double>()) << form;
        EXPECT_LE(one["value"].get<double>(), one["high"].get<double>()) << form;
    }
    EXPECT_NEAR(agreement["cronbach_alpha"].get<double>(), agreement["icc"]["3,k"]["value"].get<double>(),
                1e-12);
    EXPECT_NE(refusal({"curriculum", "agreement", file(complete + "d,x,3\n")}).find("no score of d by y"),
              std::string::npos);
    EXPECT_NE(refusal({"curriculum", "agreement", file(complete + "a,x,3\n")}).find("twice"),
              std::string::npos);
    EXPECT_NE(refusal({"curriculum", "agreement", file("target,rater,score\na,x,1\na,y,1\nb,x,1\nb,y,1\n")})
                  .find("all ratings are equal"),
              std::string::npos);
}

TEST_F(StatisticsCommands, BenchmarkStatisticsAreThoseOfASet) {
    const std::string four =
        "expert,value\na,10\na,12\na,14\nb,20\nb,22\nb,24\nc,15\nc,17\nc,19\nd,11\nd,13\nd,15\n";
    const nlohmann::json all = run({"benchmark", "statistics", file(four)});
    EXPECT_NEAR(all["mean"].get<double>(), 16, 1e-12);
    EXPECT_NEAR(all["sd"].get<double>(), 4.8305, 1e-4);
    EXPECT_EQ(all["experts"], 4);
    EXPECT_EQ(all["attempts"], 12);
    std::string eight = "expert,value\n";
    for (const char* value : {"62", "58", "65", "60", "63", "59", "110", "61"})
        eight += "e" + std::string(value) + "," + value + "\n";
    EXPECT_EQ(run({"benchmark", "statistics", file(eight)})["dropped"], nlohmann::json({"e110"}));
    EXPECT_NE(
        refusal({"benchmark", "statistics", "--scale", "ln", file("expert,value\na,0\n")}).find("logarithm"),
        std::string::npos);
    EXPECT_NE(refusal({"benchmark", "statistics", file("expert,value\na,1\n")}).find("fewer than 2"),
              std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app
