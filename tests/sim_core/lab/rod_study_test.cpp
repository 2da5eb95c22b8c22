// SPDX-License-Identifier: Apache-2.0
// A single rod from JSON: the format of docs/FORMATS.md.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sim_core/lab/rod_study.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

using nlohmann::json;

json cantilever() {
    return {{"model", "rod"},        {"length_m", 0.4},     {"segments", 32},  {"outer_radius_m", 0.015},
            {"inner_radius_m", 0.0}, {"young_pa", 32300.0}, {"poisson", 0.35}, {"ends", {"clamped", "free"}}};
}

TEST(RodStudy, SmallTipLoadMatchesTheBeamFormula) {
    json study = cantilever();
    study["point_loads"] = json::array({{{"s_m", 0.4}, {"force_n", {0, 0, -1e-5}}}});
    const json result = run_rod_study(study, "study.json");
    const double stiffness = 32300.0 * std::acos(-1.0) / 4 * std::pow(0.015, 4);
    ASSERT_EQ(result["nodes"].size(), 33U);
    EXPECT_EQ(result["twist_rad"].size(), 32U);
    const double expected = -1e-5 * std::pow(0.4, 3) / (3 * stiffness);
    EXPECT_NEAR(result["nodes"][32][2].get<double>(), expected, 1e-3 * std::fabs(expected));
    EXPECT_NEAR(result["reaction_n"][0][2].get<double>(), 1e-5, 1e-10);
    EXPECT_GT(result["energy_j"]["bend"].get<double>(), 0);
    EXPECT_TRUE(result["converged"].get<bool>());
    // One linear solve suffices where the answer is linear.
    study["level"] = "linearised";
    const json linear = run_rod_study(study, "study.json");
    EXPECT_EQ(linear["iterations"], 1);
    EXPECT_NEAR(linear["nodes"][32][2].get<double>(), expected, 1e-3 * std::fabs(expected));
}

TEST(RodStudy, TwistedClampedRodGivesItsTorqueAndHeldRodTurns) {
    json study = cantilever();
    study["ends"] = {"clamped", "held"};
    study["end_twist_rad"] = 2.0;
    const json result = run_rod_study(study, "study.json");
    const double shear = 32300.0 / 2.7, polar = std::acos(-1.0) / 2 * std::pow(0.015, 4);
    const double torque = shear * polar * 2.0 / 0.4;
    EXPECT_NEAR(result["reaction_nm"][1][0].get<double>(), torque, 1e-6 * torque);
    EXPECT_NEAR(result["energy_j"]["twist"].get<double>(), 0.5 * torque * 2.0, 1e-6 * torque);
}

TEST(RodStudy, BadStudiesReportPlaceAndHint) {
    const auto error = [](const json& study) {
        try {
            run_rod_study(study, "study.json");
        } catch (const InputError& e) {
            return std::string(e.what());
        }
        return std::string("accepted");
    };
    const auto with = [](const char* key, const json& value) {
        json study = cantilever();
        study[key] = value;
        return study;
    };
    const auto names = [](const std::string& text, const char* place) {
        return text.find("study.json:") == 0 && text.find(place) != std::string::npos &&
               text.find("; ") != std::string::npos;
    };
    EXPECT_TRUE(names(error(with("segments", 1)), "/segments"));
    EXPECT_TRUE(names(error(with("segments", 2.5)), "/segments"));
    EXPECT_TRUE(names(error(with("length_m", "long")), "/length_m"));
    EXPECT_TRUE(names(error(with("length_m", -1)), "length"));
    EXPECT_TRUE(names(error(with("ends", {"clamped"})), "/ends"));
    EXPECT_TRUE(names(error(with("ends", {"clamped", "glued"})), "/ends/1"));
    EXPECT_TRUE(names(error(with("law", "rubber")), "/law"));
    EXPECT_TRUE(names(error(with("level", "guess")), "/level"));
    EXPECT_TRUE(names(error(with("gravity", {0, 0})), "/gravity"));
    EXPECT_TRUE(names(error(with("point_loads", json::array({{{"s_m", 9}, {"force_n", {0, 0, 1}}}}))),
                      "/point_loads/0/s_m"));
    EXPECT_TRUE(names(error(with("end_twist_rad", 1)), "/ends/1"));
    EXPECT_TRUE(names(error(with("inner_radius_m", 0.02)), "inner radius"));
    EXPECT_TRUE(names(error(json::array()), "object"));
}

}  // namespace
}  // namespace fulcrum
