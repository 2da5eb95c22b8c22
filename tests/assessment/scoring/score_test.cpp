// SPDX-License-Identifier: Apache-2.0
// Gates, passed / failed / not scored, points.
#include "assessment/scoring/score.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/numerics/input_error.h"
#include "tests/assessment/scoring/fixtures.h"

namespace fulcrum {
namespace {

using test::figure;
using test::figures;
using test::missing;
using test::small_set;
using test::small_task;

Score score_of(const std::vector<MetricResult>& metrics, AttemptState state = AttemptState::completed,
               std::vector<CriticalError> errors = {}, bool moved = true) {
    static const TaskDefinition task = small_task();
    static const BenchmarkSet set = small_set();
    ScoreInput input{task, metrics, &set, state, moved, std::move(errors)};
    return score_attempt(input);
}

const CriticalError perforation{"perforation", "left", "bowel", 43.0};

TEST(Score, PassesWhenEveryGateIsMet) {
    const Score score = score_of(figures(std::exp(4.2), -1.6, 3.0, 1));
    EXPECT_EQ(score.passed, true);
    EXPECT_TRUE(score.provisional);
    EXPECT_TRUE(score.not_scored_because.empty());
    ASSERT_EQ(score.gates.size(), 4U);
    EXPECT_NEAR(*score.gates[0].z, 1.0, 1e-12);
    EXPECT_NEAR(*score.gates[0].limit, std::exp(4.4), 1e-9);
    EXPECT_NEAR(*score.gates[0].points, 75.0, 1e-9);
    EXPECT_NEAR(*score.gates[1].z, 1.0, 1e-9);  // higher is better: lower is worse
    EXPECT_NEAR(*score.gates[1].limit, -1.7, 1e-12);
    EXPECT_FALSE(score.gates[2].z);
    EXPECT_FALSE(score.gates[2].points);
    EXPECT_TRUE(score.gates[2].provisional);
    EXPECT_FALSE(score.gates[3].provisional);
    EXPECT_NEAR(*score.points, 75.0, 1e-9);
}

TEST(Score, IsNonCompensatory) {
    EXPECT_EQ(score_of(figures(std::exp(4.41), -1.0, 0.1, 0)).passed, false);
    EXPECT_EQ(score_of(figures(std::exp(4.40) * 0.9999, -1.0, 0.1, 0)).passed, true);
    EXPECT_EQ(score_of(figures(1, -1.0, 4.01, 0)).passed, false);
    EXPECT_EQ(score_of(figures(1, -1.0, 0.1, 2)).passed, false);
}

TEST(Score, PointsAreClampedAndMeantOverBenchmarkGates) {
    EXPECT_NEAR(*score_of(figures(1, -0.5, 1, 0)).points, 100.0, 1e-9);
    EXPECT_NEAR(*score_of(figures(1e4, -9, 1, 0)).points, 0.0, 1e-9);
    EXPECT_NEAR(*score_of(figures(std::exp(4.4), -1.5, 1, 0)).points, (50.0 + 100.0) / 2, 1e-9);
}

TEST(Score, CriticalErrorsFailWithZeroPoints) {
    const Score score = score_of(figures(1, -1.0, 0.1, 0), AttemptState::completed, {perforation});
    EXPECT_EQ(score.passed, false);
    EXPECT_EQ(score.points, 0.0);
}

TEST(Score, AbsentBecauseNotDoneFailsAbsentOtherwiseIsNotScored) {
    std::vector<MetricResult> metrics = figures(50, -1.5, 1, 0);
    metrics[0] = missing("time", "", Absence::not_done);
    EXPECT_EQ(score_of(metrics).passed, false);
    metrics[0] = missing("time", "", Absence::not_measured);
    const Score score = score_of(metrics);
    EXPECT_FALSE(score.passed);
    EXPECT_FALSE(score.points);
    EXPECT_EQ(words_of(score.not_scored_because), "Time: not recorded: left.fx");
    metrics = figures(50, -1.5, 1, 0);
    metrics[1] = missing("sparc", "right", Absence::not_done);  // its descriptor says: not scored
    EXPECT_FALSE(score_of(metrics).passed);
    metrics[2] = figure("f_max", "left", 9);  // a gate that is not met fails whatever else is unknown
    EXPECT_EQ(score_of(metrics).passed, false);
}

TEST(Score, WithoutABenchmarkIsNotScored) {
    const TaskDefinition task = small_task();
    const std::vector<MetricResult> metrics = figures(50, -1.5, 1, 0);
    const Score score = score_attempt(ScoreInput{task, metrics});
    EXPECT_FALSE(score.passed);
    EXPECT_EQ(score.not_scored_because.statement("because")->id(), StatementId::no_benchmark);
    EXPECT_EQ(score.gates[2].passed, true);  // absolute gates need none
}

TEST(Score, AbandonedAndTimedOutFailOnceTheAttemptCounts) {
    for (const AttemptState state : {AttemptState::abandoned, AttemptState::timed_out}) {
        const Score score = score_of(figures(1, -1, 0.1, 0), state);
        EXPECT_EQ(score.passed, false);
        EXPECT_FALSE(score.points);
        EXPECT_FALSE(score_of(figures(1, -1, 0.1, 0), state, {}, false).passed);
    }
}

// Half an attempt has a short path: that is no z of -28.
TEST(Score, APartOfAnAttemptIsNeverBetterThanTheExperts) {
    for (const AttemptState state :
         {AttemptState::abandoned, AttemptState::timed_out, AttemptState::interrupted}) {
        const Score score = score_of(figures(1, -1, 0.1, 0), state);
        EXPECT_FALSE(score.gates[0].z) << *score.gates[0].z;
        EXPECT_FALSE(score.gates[0].points);
    }
    const Score worse = score_of(figures(std::exp(5.0), -1, 0.1, 0), AttemptState::abandoned);
    EXPECT_NEAR(worse.gates[0].z.value_or(0), 5.0, 1e-9);
    EXPECT_TRUE(score_of(figures(1, -1, 0.1, 0)).gates[0].z);
}

TEST(Score, InterruptedCountsOnlyWhatIsBrokenForGood) {
    EXPECT_FALSE(score_of(figures(1, -1, 0.1, 0), AttemptState::interrupted).passed);
    EXPECT_EQ(score_of(figures(1, -1, 4.5, 0), AttemptState::interrupted).passed, false);
    EXPECT_EQ(score_of(figures(1, -1, 0.1, 2), AttemptState::interrupted).passed, false);
    EXPECT_FALSE(score_of(figures(1e5, -9, 0.1, 0), AttemptState::interrupted)
                     .passed);  // benchmark gates do not count
    EXPECT_EQ(score_of(figures(1, -1, 0.1, 0), AttemptState::interrupted, {perforation}).passed, false);
}

TEST(Score, SimulatorFaultIsNeverScored) {
    const Score score = score_of(figures(1, -1, 9, 0), AttemptState::failed_simulation, {perforation});
    EXPECT_FALSE(score.passed);
    EXPECT_FALSE(score.points);
    EXPECT_EQ(score.not_scored_because.id(), StatementId::simulator_failed);
}

TEST(Score, AbsoluteLevelsOfASetTakeNoZ) {
    const TaskDefinition task = small_task();
    BenchmarkSet set = small_set();
    set.levels[0].absolute_limit = 60.0;
    const std::vector<MetricResult> good = figures(60, -1.5, 1, 0), bad = figures(60.1, -1.5, 1, 0);
    const Score score = score_attempt(ScoreInput{task, good, &set});
    EXPECT_EQ(score.passed, true);
    EXPECT_EQ(score.gates[0].kind, GateKind::absolute);
    EXPECT_FALSE(score.gates[0].z);
    EXPECT_EQ(score_attempt(ScoreInput{task, bad, &set}).passed, false);
}

TEST(Score, NoPointsWhereNovicesAreAsGoodAsExperts) {
    const TaskDefinition task = small_task();
    BenchmarkSet set = small_set();
    set.levels[0].z_novice = 0.5;
    set.levels[1].z_novice.reset();
    const std::vector<MetricResult> metrics = figures(50, -1.5, 1, 0);
    EXPECT_FALSE(score_attempt(ScoreInput{task, metrics, &set}).points);
}

TEST(Record, StatesAndCriticalErrorsComeFromEvents) {
    const auto event = [](std::uint32_t tick, EventKind kind, int hand = 255, int detail = 0,
                          int tissue = -1) {
        Event e;
        e.tick = tick;
        e.kind = kind;
        e.hand = static_cast<std::uint8_t>(hand);
        e.detail = detail;
        e.tissue = static_cast<std::int8_t>(tissue);
        return e;
    };
    EXPECT_EQ(attempt_state({}), AttemptState::interrupted);
    EXPECT_EQ(attempt_state({event(9, EventKind::completed)}), AttemptState::completed);
    EXPECT_EQ(attempt_state({event(9, EventKind::timed_out)}), AttemptState::timed_out);
    EXPECT_EQ(attempt_state({event(9, EventKind::abandoned)}), AttemptState::abandoned);
    EXPECT_EQ(attempt_state({event(8, EventKind::simulator_fault), event(9, EventKind::interrupted)}),
              AttemptState::failed_simulation);
    const std::vector<Event> events = {
        event(0, EventKind::phase_begin, 255, 0), event(5000, EventKind::phase_end, 255, 0),
        event(5000, EventKind::phase_begin, 255, 1), event(7000, EventKind::perforation, 1, 3, 0),
        event(9000, EventKind::completed)};
    std::vector<TickSample> samples(10000);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i].tick = static_cast<std::uint32_t>(i);
    const Trace trace = trace_from_samples(samples, events, {"bowel"});
    const TaskDefinition task = small_task();
    const auto errors = critical_errors(task, events, trace);
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].hand, "right");
    EXPECT_EQ(errors[0].tissue, "bowel");
    EXPECT_DOUBLE_EQ(errors[0].time_s, 7.0);
    const auto phases = phases_of(task, events, trace);
    ASSERT_EQ(phases.size(), 2U);
    EXPECT_DOUBLE_EQ(phases[0].interval.end, 5.0);
    EXPECT_EQ(phases[1].name, "Run the bowel");
    EXPECT_DOUBLE_EQ(phases[1].interval.end, 9.0);
    const std::vector<MetricResult> metrics = figures(50, -1.5, 1, 0);
    const BenchmarkSet set = small_set();
    const Score score = score_attempt(task, trace, events, metrics, &set);
    EXPECT_EQ(score.passed, false);
    EXPECT_NE(words_of(score.advice)
                  .find("Right hand, in 'Run the bowel': critical error, perforation (bowel) at 0:07"),
              std::string::npos)
        << words_of(score.advice);
}

TEST(CheckGates, RefusesWhatCannotBeGated) {
    EXPECT_NO_THROW(check_gates(small_task(), "t.json"));
    const auto refused = [](const GateSpec& gate) {
        TaskDefinition task = small_task();
        task.gates = {gate};
        try {
            check_gates(task, "t.json");
        } catch (const InputError& error) {
            return error.place();
        }
        return std::string();
    };
    EXPECT_EQ(refused({"nothing", "", "", GateKind::absolute, 1, "x"}), "/gates/0/metric");
    EXPECT_EQ(refused({"n_moves", "left", "", GateKind::absolute, 1, "x"}), "/gates/0/metric");
    EXPECT_EQ(refused({"path_len", "", "", GateKind::absolute, 1, "x"}), "/gates/0/hand");
    EXPECT_EQ(refused({"time", "left", "", GateKind::absolute, 1, "x"}), "/gates/0/hand");
    EXPECT_EQ(refused({"time", "", "bowel", GateKind::absolute, 1, "x"}), "/gates/0/tissue");
    EXPECT_EQ(refused({"slip", "", "", GateKind::absolute, 1, "x"}), "");
    TaskDefinition task = small_task();
    task.gates.assign(7, {"path_len", "left", "", GateKind::benchmark, 0, ""});
    EXPECT_THROW(check_gates(task, "t.json"), InputError);
}

TEST(GatesJson, HasTheKeysOfTheContract) {
    const Score score = score_of(figures(50, -1.5, 1, 0));
    const nlohmann::json rows = gates_to_json(score.gates);
    for (const char* key : {"metric", "hand", "tissue", "kind", "value", "unit", "limit", "limit_source", "z",
                            "passed", "provisional"})
        for (const auto& row : rows) EXPECT_TRUE(row.contains(key)) << key;
    EXPECT_TRUE(rows[0].at("hand").is_null());
    EXPECT_TRUE(rows[2].at("z").is_null());
    EXPECT_EQ(critical_errors_to_json({perforation})[0].at("event"), "perforation");
}

}  // namespace
}  // namespace fulcrum
