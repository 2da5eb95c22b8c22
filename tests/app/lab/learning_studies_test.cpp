// SPDX-License-Identifier: GPL-3.0-or-later
// `fulcrum lab run` with the models rule, curve, cusum and agreement.
#include "app/lab/learning_studies.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

class LearningStudies : public ::testing::Test {
  protected:
    nlohmann::json run(const nlohmann::json& study) const {
        const std::string path = (folder_ / "study.json").string();
        std::ofstream(path) << study.dump(1);
        return lab::run_study(path, learning_studies());
    }
    std::string refusal(const nlohmann::json& study) const {
        try {
            run(study);
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    }
    fulcrum::test::OwnFolder folder_;
};

TEST_F(LearningStudies, RuleGivesAListForEveryChance) {
    const nlohmann::json result = run({{"model", "rule"},
                                       {"rule", {{"kind", "in_a_row"}, {"k", 2}}},
                                       {"q", {0.0, 0.5, 1.0}},
                                       {"attempts", 30}});
    EXPECT_EQ(result["declared"][0], 0);
    EXPECT_NEAR(result["declared"][1].get<double>(), 0.998, 5e-4);
    EXPECT_EQ(result["median_attempts"], nlohmann::json({nullptr, 4, 2}));
    EXPECT_TRUE(result["mean_attempts_if_declared"][0].is_null());
    const nlohmann::json cusum = run({{"model", "rule"},
                                      {"rule", {{"kind", "lc_cusum"}, {"p0", 0.1}, {"p1", 0.3}, {"h", 2.5}}},
                                      {"q", {1.0}},
                                      {"attempts", 60}});
    EXPECT_EQ(cusum["median_attempts"][0], 10);
    EXPECT_NE(refusal({{"model", "rule"}, {"rule", {{"kind", "luck"}}}, {"q", {0.5}}, {"attempts", 3}})
                  .find("/rule/kind"),
              std::string::npos);
    EXPECT_NE(refusal({{"model", "rule"},
                       {"rule", {{"kind", "k_of_n"}, {"k", 5}, {"n", 4}}},
                       {"q", {0.5}},
                       {"attempts", 3}})
                  .find("K is larger than N"),
              std::string::npos);
    EXPECT_NE(
        refusal(
            {{"model", "rule"}, {"rule", {{"kind", "in_a_row"}, {"k", 2}}}, {"q", {1.5}}, {"attempts", 3}})
            .find("/q/0"),
        std::string::npos);
}

TEST_F(LearningStudies, CurveFitsAndRefusesFewValues) {
    nlohmann::json values = nlohmann::json::array();
    for (int x = 1; x <= 12; ++x) values.push_back(5 + 40.0 / x);
    const nlohmann::json result = run({{"model", "curve"}, {"values", values}});
    EXPECT_EQ(result["best"], "inverse");
    EXPECT_NEAR(result["models"][0]["plateau"].get<double>(), 5, 1e-6);
    EXPECT_NE(refusal({{"model", "curve"}, {"values", {1, 2, 3}}}).find("too few"), std::string::npos);
    EXPECT_NE(refusal({{"model", "curve"}, {"values", {1, "two"}}}).find("/values/1"), std::string::npos);
}

TEST_F(LearningStudies, CusumFollowsItsSteps) {
    const nlohmann::json result = run({{"model", "cusum"},
                                       {"outcomes", {true, true, false, false, false}},
                                       {"p0", 0.1},
                                       {"p1", 0.3},
                                       {"h", 0.5}});
    EXPECT_NEAR(result["sum"][1].get<double>(), 0.502629, 1e-6);
    EXPECT_EQ(result["sum"][2], 0);
    EXPECT_EQ(result["declared_at"], 2);
    EXPECT_EQ(result["relapse_alarms"], nlohmann::json({5}));
    EXPECT_NE(refusal({{"model", "cusum"}, {"outcomes", {1, 0}}, {"p0", 0.1}, {"p1", 0.3}, {"h", 2.5}})
                  .find("true or false"),
              std::string::npos);
}

TEST_F(LearningStudies, AgreementOfATable) {
    const nlohmann::json result =
        run({{"model", "agreement"}, {"ratings", {{9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}}}});
    EXPECT_LE(result["icc"]["2,1"]["low"].get<double>(), result["icc"]["2,1"]["value"].get<double>());
    EXPECT_NE(refusal({{"model", "agreement"}, {"ratings", {{1, 2}, {2}}}}).find("a rating is missing"),
              std::string::npos);
    EXPECT_NE(
        refusal({{"model", "agreement"}, {"ratings", {{1, 2}, {2, 3}}}, {"extra", 1}}).find("unknown key"),
        std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app
