// SPDX-License-Identifier: Apache-2.0
// One sentence: the right gate, the right words, always the same.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/assessment/scoring/fixtures.h"
#include "tests/support/german_locale.h"

namespace fulcrum {
namespace {

using test::figures;
using test::small_set;
using test::small_task;

std::string advice_of(const std::vector<MetricResult>& metrics, std::vector<CriticalError> errors = {},
                      AttemptState state = AttemptState::completed) {
    const TaskDefinition task = small_task();
    const BenchmarkSet set = small_set();
    ScoreInput input{task, metrics, &set, state, true, std::move(errors)};
    input.phases = {{"Find the start", {0, 5}}, {"Run the bowel", {5, 60}}};
    const Score score = score_attempt(input);
    EXPECT_EQ(score_attempt(input).advice, score.advice);
    return words_of(score.advice);
}

TEST(Advice, CriticalErrorFirst) {
    EXPECT_EQ(advice_of(figures(500, -9, 9, 9), {{"perforation", "left", "bowel", 43.2}}),
              "Left hand, in 'Run the bowel': critical error, perforation (bowel) at 0:43; keep the tips in "
              "view and never "
              "push against resistance.");
}

TEST(Advice, ThenTheAbsoluteGateFurthestBeyondItsLimit) {
    EXPECT_EQ(advice_of(figures(500, -9, 6, 0)),
              "Left hand, in 'Run the bowel': the force rose to 6.0 N, above the limit of 4.0 N (50 % over); "
              "approach slowly, and stop when the tissue no longer yields.");
    EXPECT_EQ(advice_of(figures(500, -9, 6, 3)),
              "In 'Run the bowel': 3 objects were dropped, above the limit of 1 (far outside); release it "
              "only when "
              "the object rests.");
}

TEST(Advice, NamesTheWorseOfTwoValuesBelowZero) {
    TaskDefinition task = small_task();
    task.metrics.push_back("ldlj");
    std::vector<MetricResult> metrics = figures(50, -1.5, 1, 0);
    for (const auto& [hand, value] : {std::pair("left", -7.0), std::pair("right", -9.0)}) {
        task.gates.push_back({"ldlj", hand, "", GateKind::absolute, -6.4, "training limit", true});
        metrics.push_back(test::figure("ldlj", hand, value));
    }
    const BenchmarkSet set = small_set();
    const ScoreInput input{task, metrics, &set, AttemptState::completed};
    const std::string words = words_of(score_attempt(input).advice);
    EXPECT_EQ(words.rfind("Right hand", 0), 0U) << words;
}

TEST(Advice, ThenTheBenchmarkGateFurthestFromTheExperts) {
    EXPECT_EQ(advice_of(figures(std::exp(4.6), -1.9, 1, 0)),
              "Right hand, in 'Run the bowel': movements were made of many corrections: smoothness -1.90, "
              "below the required -1.70 (4.0 standard deviations from the experts); start each move slowly "
              "and let it "
              "run out in one "
              "stroke.");
}

TEST(Advice, NeverSaysMoreThanFarOutside) {
    const std::string time = advice_of(figures(std::exp(9), -1.5, 1, 0));
    EXPECT_NE(time.find("(far outside)"), std::string::npos) << time;
    EXPECT_EQ(time.find("standard deviations"), std::string::npos) << time;
    const std::string force = advice_of(figures(50, -1.5, 60, 0));
    EXPECT_NE(force.find("(far outside)"), std::string::npos) << force;
    EXPECT_EQ(force.find('%'), std::string::npos) << force;
}

TEST(Advice, OfATaskTakesThePlaceOfTheMetrics) {
    TaskDefinition task = small_task();
    for (GateSpec& gate : task.gates)
        if (gate.metric == "f_max") gate.advice = "stop as soon as the sphere is lit";
    const BenchmarkSet set = small_set();
    const std::vector<MetricResult> metrics = figures(50, -1.5, 6, 0);
    const Score score = score_attempt(ScoreInput{task, metrics, &set});
    EXPECT_NE(words_of(score.advice).find("(50 % over); stop as soon as the sphere is lit."),
              std::string::npos)
        << words_of(score.advice);
    // What a store keeps reads the same.
    EXPECT_EQ(words_of(statement_of(stored_text(score.advice))), words_of(score.advice));
}

TEST(Advice, OfAPassNamesTheNarrowestGate) {
    EXPECT_EQ(
        advice_of(figures(std::exp(4.0), -1.65, 1, 0)),
        "All gates are met. Closest to its limit: Smoothness (SPARC), right hand (-1.65, limit -1.70). To "
        "improve: start each move slowly and let it run out in one stroke.");
}

TEST(Advice, OfWhatHasNoFigure) {
    std::vector<MetricResult> metrics = figures(50, -1.5, 1, 0);
    metrics[0] = test::missing("time", "", Absence::not_done);
    EXPECT_EQ(advice_of(metrics).substr(0, 47), "Time has no value because nothing was grasped; ");
    metrics[0] = test::missing("time", "", Absence::not_measured);
    EXPECT_EQ(advice_of(metrics), "Not scored: Time: not recorded: left.fx.");
    EXPECT_EQ(advice_of(figures(50, -1.5, 1, 0), {}, AttemptState::abandoned),
              "The attempt was abandoned before the last step was completed. Carry the next one through to "
              "the end.");
}

// A force that was never made is no fault of an attempt that was given up: the sentence is about giving up.
TEST(Advice, OfAnAttemptThatWasNotCarriedToItsEndNamesNoAbsentFigure) {
    for (const AttemptState state :
         {AttemptState::abandoned, AttemptState::timed_out, AttemptState::interrupted}) {
        std::vector<MetricResult> metrics = figures(50, -1.5, 1, 0);
        for (MetricResult& metric : metrics)
            if (metric.id == "f_max") metric = test::missing("f_max", metric.hand, Absence::not_done);
        const std::string advice = advice_of(metrics, {}, state);
        EXPECT_EQ(advice.find("has no value"), std::string::npos) << advice;
        const char* about = state == AttemptState::abandoned   ? "The attempt was abandoned"
                            : state == AttemptState::timed_out ? "The time ran out"
                                                               : "Not scored: the attempt was interrupted";
        EXPECT_EQ(advice.find(about), 0U) << advice;
    }
    // What was done badly before giving up is still the first thing to say.
    EXPECT_NE(advice_of(figures(50, -1.5, 9, 0), {}, AttemptState::abandoned).find("the force rose to 9.0 N"),
              std::string::npos);
}

TEST(Advice, WritesNumbersWithAPointInEveryLocale) {
    const test::GermanLocale german;
    ASSERT_TRUE(german.in_force()) << "localedef cannot make de_DE: install the package locales";
    const std::string advice = advice_of(figures(50, -1.5, 9.5, 0));
    EXPECT_NE(advice.find("the force rose to 9.5 N"), std::string::npos) << advice;
}

TEST(Advice, EveryMetricMakesASentenceWithoutLeftOverMarks) {
    for (const Metric& metric : metric_registry()) {
        const MetricDescriptor& d = metric.descriptor;
        if (d.direction == Direction::context) continue;
        TaskDefinition task = small_task();
        const std::string hand = d.hands == Hands::each ? "left" : "";
        task.gates = {
            {d.id, hand, "", GateKind::absolute, d.direction == Direction::lower ? 1.0 : 3.0, "test"}};
        const std::vector<MetricResult> metrics = {test::figure(d.id, hand, 2.0)};
        const Score score = score_attempt(ScoreInput{task, metrics});
        EXPECT_EQ(score.passed, false) << d.id;
        const std::string advice = words_of(score.advice);
        EXPECT_EQ(advice.find('{'), std::string::npos) << advice;
        EXPECT_EQ(advice.back(), '.') << advice;
        EXPECT_NE(advice.find(d.advice_remedy), std::string::npos);
    }
}

}  // namespace
}  // namespace fulcrum
