// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of `fulcrum lab fidelity` for studies whose truth is known, and the command from its attempts
// to its page.
#include <gtest/gtest.h>

#include <QProcess>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/lab/fidelity_page.h"
#include "database/scoring/fidelity_now.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/random.h"
#include "sim_core/world/physics_version.h"
#include "tests/app/program_path.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

constexpr FidelityLevel all_levels[] = {FidelityLevel::fast, FidelityLevel::standard, FidelityLevel::fine};

/// What the attempts of a study made by hand differ in from those at fine.
struct Difference {
    double fast = 0, standard = 0;  ///< of the gated metric, percent
    double noise = 0;               ///< standard deviation of a difference, percent
    int flips = 0;                  ///< verdicts at standard, replayed
};

FidelityStudy study_with(const Difference& difference, int seeds = 30) {
    FidelityStudy study;
    study.physics = 5;
    study.commit = "abc";
    study.tasks.push_back({"B1", "B1@1", "standard", 1, {{"f_max", "left", "", 0}, {"drop", "", "", 1}}});
    Random random(3);
    const double costs[] = {1, 2, 8};  // ms of processor time for a simulated second
    for (int seed = 0; seed < seeds; ++seed) {
        const double at_fine = 4 + random.normal();
        for (const Pairing pairing : {Pairing::performed, Pairing::replayed}) {
            for (const FidelityLevel level : all_levels) {
                ObservedAttempt one;
                one.task = "B1";
                one.operator_level = OperatorLevel::expert;
                one.seed = static_cast<std::uint64_t>(seed);
                one.pairing = pairing;
                one.fidelity = level;
                one.passed = true;
                one.simulated_s = 10;
                one.processor_s = 0.01 * costs[static_cast<int>(level)];
                const double percent = level == FidelityLevel::fast       ? difference.fast
                                       : level == FidelityLevel::standard ? difference.standard
                                                                          : 0;
                const double noise =
                    level == FidelityLevel::fine ? 0 : difference.noise * random.normal() / 100;
                one.values = {{"f_max left", at_fine + 4 * (percent / 100 + noise)},
                              {"drop", 0},
                              {"sparc left", -1.5},
                              {"points", 80}};
                if (pairing == Pairing::replayed && level == FidelityLevel::standard &&
                    seed < difference.flips)
                    one.passed = false;
                study.attempts.push_back(one);
            }
        }
    }
    return study;
}

TaskAnswer answer_of(const FidelityStudy& study) {
    const std::vector<TaskAnswer> answers = fidelity_answers(study);
    EXPECT_EQ(answers.size(), 1U);
    return answers.at(0);
}

TEST(FidelityAnswer, FindsAnArtificialShiftAndNamesTheCheapestLevelWithoutOne) {
    const TaskAnswer answer = answer_of(study_with({-3, 1, 0.5, 0}));
    ASSERT_EQ(answer.levels.size(), 3U);
    const MetricShift* worst = answer.levels[0].performed.worst();
    ASSERT_NE(worst, nullptr);
    EXPECT_EQ(worst->metric, "f_max");
    EXPECT_EQ(worst->hand, "left");
    EXPECT_NEAR(worst->percent(), -3, 0.4);
    EXPECT_LT(worst->high(), -2);
    EXPECT_EQ(answer.levels[0].holding(), Holding::moves);
    EXPECT_EQ(answer.levels[1].holding(), Holding::holds);
    EXPECT_EQ(answer.cheapest, FidelityLevel::standard);
    EXPECT_NEAR(answer.levels[2].processor_ms, 8, 1e-9);
    EXPECT_FALSE(answer.identical());
}

TEST(FidelityAnswer, NamesTheCheapestWhereBothHold) {
    EXPECT_EQ(answer_of(study_with({0.5, 0.5, 0.5, 0})).cheapest, FidelityLevel::fast);
}

TEST(FidelityAnswer, DoesNotDecideOnWideIntervals) {
    const TaskAnswer answer = answer_of(study_with({0, 0, 12, 0}, 12));
    for (const LevelAnswer* level : {&answer.levels[0], &answer.levels[1]})
        EXPECT_NE(level->holding(), Holding::holds);
    EXPECT_EQ(answer.cheapest, FidelityLevel::fine);
    const TaskAnswer calm = answer_of(study_with({1.9, 1.9, 1, 0}));
    EXPECT_EQ(calm.levels[0].performed.holding() == Holding::holds, false);
}

TEST(FidelityAnswer, OneVerdictThatChangesIsEnough) {
    const TaskAnswer answer = answer_of(study_with({5, 0.5, 0.5, 1}));
    EXPECT_EQ(answer.levels[1].performed.holding(), Holding::holds);
    EXPECT_EQ(answer.levels[1].replayed.holding(), Holding::moves);
    EXPECT_EQ(answer.levels[1].replayed.flips, std::vector<std::uint64_t>{0});
    EXPECT_EQ(answer.cheapest, FidelityLevel::fine);
    // What is not gated decides nothing.
    FidelityStudy study = study_with({0.5, 0.5, 0.5, 0});
    for (ObservedAttempt& one : study.attempts)
        if (one.fidelity == FidelityLevel::fast) one.values["sparc left"] = -9;
    EXPECT_EQ(answer_of(study).cheapest, FidelityLevel::fast);
}

TEST(FidelityAnswer, KeepsTheScenesOwnWhereNothingDepends) {
    const TaskAnswer answer = answer_of(study_with({}));
    EXPECT_TRUE(answer.identical());
    EXPECT_EQ(answer.cheapest, FidelityLevel::standard);
}

TEST(FidelityAnswer, CountsAreOfTheLimitOrOfOneAtLeast) {
    FidelityStudy study = study_with({});
    for (ObservedAttempt& one : study.attempts)
        if (one.fidelity == FidelityLevel::fast && one.seed == 0) one.values["drop"] = 1;
    const std::vector<MetricShift> shifts = answer_of(study).levels[0].performed.shifts;
    const auto drop = std::find_if(shifts.begin(), shifts.end(),
                                   [](const MetricShift& row) { return row.metric == "drop"; });
    ASSERT_NE(drop, shifts.end());
    EXPECT_NEAR(drop->percent(), 100.0 / 30, 1e-9);
}

TEST(FidelityAnswer, CountsValuesWithoutAPair) {
    FidelityStudy study = study_with({});
    study.attempts[0].values.erase("f_max left");  // performed at fast
    const TaskAnswer answer = answer_of(study);
    const MetricShift* worst = answer.levels[0].performed.worst();
    ASSERT_NE(worst, nullptr);
    EXPECT_EQ(
        answer.levels[0].performed.shifts.front().one_sided + answer.levels[0].performed.shifts[1].one_sided,
        1);
    EXPECT_FALSE(answer.identical());
}

TEST(FidelityAnswer, SurvivesItsFile) {
    const FidelityStudy study = study_with({-3, 1, 0.5, 2});
    const nlohmann::json document = to_json(study);
    const FidelityStudy read = fidelity_study_of(nlohmann::json::parse(document.dump()), "f");
    EXPECT_EQ(to_json(read), document);
    EXPECT_EQ(fidelity_page(read, fidelity_answers(read)).text({}),
              fidelity_page(study, fidelity_answers(study)).text({}));
    nlohmann::json older = document;
    older["tasks"][0].erase("metrics");
    EXPECT_TRUE(fidelity_study_of(older, "f").tasks[0].metrics.empty());
    EXPECT_THROW(fidelity_study_of(nlohmann::json::array(), "f"), InputError);
    EXPECT_THROW(fidelity_study_of(nlohmann::json(), "f"), InputError);
}

TEST(FidelityAnswer, IsWhatBriefingsSay) {
    FidelityStudy study = study_with({-3, 1, 0.5, 0});
    study.tasks[0].metrics = {{"f_max", 7}};
    const FidelityCosts costs = costs_of(fidelity_answers(study), study);
    const TaskFidelityCost& task = costs.tasks.at("B1");
    EXPECT_EQ(task.physics, 5);
    EXPECT_EQ(task.commit, "abc");
    EXPECT_EQ(task.limits, "B1@1");
    EXPECT_EQ(task.metrics.at("f_max"), 7) << "of the study, not of the program that reads it";
    EXPECT_EQ(task.cheapest, "standard");
    EXPECT_EQ(task.levels[0].metric, "f_max");
    EXPECT_NEAR(task.levels[0].shift_percent, -3, 0.4);
    EXPECT_EQ(task.levels[2].metric, "");
}

/// `fulcrum lab fidelity` as a person calls it.
class FidelityCommand : public ::testing::Test {
  protected:
    nlohmann::json json_of(const char* name) const {
        std::ifstream file(folder_ / name);
        return nlohmann::json::parse(file);
    }
    std::string text_of(const std::filesystem::path& name) const {
        std::ifstream file(folder_ / name);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void expect_success(QStringList words) const {
        QProcess process;
        process.setWorkingDirectory(QString::fromStdString(folder_.path().string()));
        process.start(program_path(), QStringList{"lab", "fidelity"} + words);
        ASSERT_TRUE(process.waitForFinished(300000));
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    }
    test::OwnFolder folder_;
};

TEST_F(FidelityCommand, MeasuresTwoTasksAndFindsAShiftThatIsPutIn) {
    expect_success({"--seeds", "2", "--tasks", "A1,A2", "--output", "page", "--data", "cost.json"});
    nlohmann::json record = json_of("page/fidelity_score.json");
    EXPECT_EQ(record["attempts"].size(), 2U * 2U * 7U);
    const FidelityCosts costs = parse_fidelity_costs(text_of("cost.json"), "cost.json");
    EXPECT_EQ(costs.tasks.size(), 2U);
    for (const LevelAnswer& level : answer_of([&] {
                                        FidelityStudy one = fidelity_study_of(record, "page");
                                        one.tasks.resize(1);
                                        return one;
                                    }())
                                        .levels)
        EXPECT_GT(level.processor_ms, 0);

    // The page is made again from its record, byte for byte.
    expect_success({"--from", "page/fidelity_score.json", "--output", "again"});
    EXPECT_EQ(text_of("page/fidelity_score.md"), text_of("again/fidelity_score.md"));
    EXPECT_EQ(text_of("page/fidelity_score.svg"), text_of("again/fidelity_score.svg"));

    for (nlohmann::json& attempt : record["attempts"]) {
        if (attempt["task"] != "A2" || attempt["fidelity"] != "fast") continue;
        double& time = attempt["values"]["time"].get_ref<double&>();
        time *= 1.05;
    }
    std::ofstream(folder_ / "shifted.json") << record.dump();
    expect_success({"--from", "shifted.json", "--output", "shifted"});
    const auto row_of_a2 = [&](const char* page) {
        const std::string text = text_of(page);
        const std::size_t at = text.find("| A2 | 2 | fast |");
        return text.substr(at, text.find('\n', at) - at);
    };
    EXPECT_NE(row_of_a2("page/fidelity_score.md").find("| none moves | 0 of 2 | yes |"), std::string::npos)
        << row_of_a2("page/fidelity_score.md");
    const std::string shifted = row_of_a2("shifted/fidelity_score.md");
    EXPECT_NE(shifted.find("| time "), std::string::npos) << shifted;
    EXPECT_EQ(shifted.substr(shifted.size() - 6), "| no |") << shifted;
    EXPECT_NE(text_of("shifted/fidelity_score.md").find("- A2: **standard** is enough."), std::string::npos);
}

// A new task is measured alone.
TEST_F(FidelityCommand, GivesTheSameAttemptsEveryTimeAndKeepsTheCostsOfOtherTasks) {
    FidelityCosts before;
    before.tasks["B9"] = {
        "fast", {{"fast", 41.5, "f_max", "left", -14.25, 3, 60}}, "abc", physics_version - 1, "", {}};
    std::ofstream(folder_ / "cost.json") << fidelity_costs_to_json(before).dump();
    for (const char* name : {"one", "two"}) {
        expect_success({"--seeds", "2", "--tasks", "A2", "--output", name, "--data", "cost.json"});
        const FidelityCosts costs = parse_fidelity_costs(text_of("cost.json"), "cost.json");
        ASSERT_EQ(costs.tasks.size(), 2U);
        EXPECT_EQ(costs.tasks.at("B9").cheapest, "fast");
        EXPECT_EQ(costs.tasks.at("B9").physics, physics_version - 1) << "each keeps its own";
        EXPECT_EQ(costs.tasks.at("A2").levels.size(), 3U);
        EXPECT_EQ(costs.tasks.at("A2").physics, physics_version);
        EXPECT_TRUE(measured_as_now(costs.tasks.at("A2"), "A2"));
    }
    nlohmann::json one = json_of("one/fidelity_score.json"), two = json_of("two/fidelity_score.json");
    for (nlohmann::json* record : {&one, &two})
        for (nlohmann::json& attempt : (*record)["attempts"]) attempt.erase("processor_s");
    EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace fulcrum::app
