// SPDX-License-Identifier: Apache-2.0
// Gates, passed / failed / not scored, points.
#include "assessment/scoring/score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "assessment/scoring/gate_rules.h"
#include "sim_core/numerics/input_error.h"
#include "tests/assessment/scoring/fixtures.h"

namespace fulcrum {
namespace {

using test::figure;
using test::figures;
using test::missing;
using test::small_set;
using test::small_site_set;
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
    EXPECT_NEAR(*score.points, 60 + 0.4 * 75.0, 1e-9);
}

TEST(Score, IsNonCompensatory) {
    EXPECT_EQ(score_of(figures(std::exp(4.41), -1.0, 0.1, 0)).passed, false);
    EXPECT_EQ(score_of(figures(std::exp(4.40) * 0.9999, -1.0, 0.1, 0)).passed, true);
    EXPECT_EQ(score_of(figures(1, -1.0, 4.01, 0)).passed, false);
    EXPECT_EQ(score_of(figures(1, -1.0, 0.1, 2)).passed, false);
}

TEST(Score, PointsAreTheMeanOfTheBenchmarkGatesOnTheVerdictsSideOfThePassMark) {
    EXPECT_NEAR(*score_of(figures(1, -0.5, 1, 0)).points, 100.0, 1e-9);
    EXPECT_NEAR(*score_of(figures(1e4, -9, 1, 0)).points, 0.0, 1e-9);
    EXPECT_NEAR(*score_of(figures(std::exp(4.3), -1.5, 1, 0)).points, 60 + 0.4 * (62.5 + 100.0) / 2, 1e-9);
    // All benchmark gates at their best, an absolute one missed: the points do not say otherwise.
    const Score failed = score_of(figures(1, -0.5, 9, 0));
    EXPECT_EQ(failed.passed, false);
    EXPECT_NEAR(*failed.points, 59.0, 1e-9);
}

TEST(Score, PointsNeverContradictTheVerdict) {
    int passed = 0, failed = 0;
    for (double time = 3.6; time < 5.2; time += 0.02)
        for (double smoothness = -2.4; smoothness < -1.2; smoothness += 0.05)
            for (const double force : {1.0, 3.99, 4.01}) {
                const Score score = score_of(figures(std::exp(time), smoothness, force, 0));
                ASSERT_TRUE(score.passed && score.points);
                (*score.passed ? passed : failed) += 1;
                EXPECT_EQ(*score.passed, *score.points >= pass_mark) << *score.points;
            }
    EXPECT_GT(passed, 100);
    EXPECT_GT(failed, 100);
}

TEST(Score, AGateThatWasNotDoneCountsWithZeroPoints) {
    std::vector<MetricResult> metrics = figures(1, -0.5, 1, 0);
    metrics[0] = missing("time", "", Absence::not_done);
    const Score score = score_of(metrics);
    EXPECT_EQ(score.passed, false);
    EXPECT_EQ(score.gates[0].points, 0.0);
    EXPECT_NEAR(*score.points, 0.59 * (0 + 100) / 2, 1e-9);
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
    metrics[1] = missing("sparc", "right", Absence::not_done);  // never rested, or never moved
    EXPECT_EQ(score_of(metrics).passed, false);
    metrics[1] = missing("sparc", "right", Absence::not_measured);
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
    }
}

// Nothing done in all the time there was is failed; left before anything was done is not.
TEST(Score, WithoutAnyMovementOnlyTimeRunsOut) {
    EXPECT_EQ(score_of(figures(1, -1, 0.1, 0), AttemptState::timed_out, {}, false).passed, false);
    const Score left = score_of(figures(1, -1, 0.1, 0), AttemptState::abandoned, {}, false);
    EXPECT_FALSE(left.passed);
    EXPECT_EQ(left.not_scored_because.id(), StatementId::ended_before_moving);
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

// A crash, a lost device, a simulator fault: what was broken before stays broken.
TEST(Score, WhatIsBrokenForGoodStaysFailedHoweverTheAttemptIsCutOff) {
    for (const AttemptState state : {AttemptState::interrupted, AttemptState::failed_simulation}) {
        SCOPED_TRACE(row_of(attempt_states, state).name);
        EXPECT_FALSE(score_of(figures(1, -1, 0.1, 0), state).passed);
        EXPECT_EQ(score_of(figures(1, -1, 4.5, 0), state).passed, false);    // force, absolute
        EXPECT_EQ(score_of(figures(1, -1, 0.1, 2), state).passed, false);    // a count, absolute
        EXPECT_EQ(score_of(figures(1e5, -1, 0.1, 0), state).passed, false);  // time, benchmark
        EXPECT_FALSE(score_of(figures(1, -9, 0.1, 0), state).passed);        // could have become better
        EXPECT_EQ(score_of(figures(1, -1, 0.1, 0), state, {perforation}).passed, false);
        EXPECT_FALSE(score_of(figures(1, -1, 4.5, 0), state).points);
    }
    EXPECT_EQ(score_of(figures(1, -1, 0.1, 0), AttemptState::interrupted).not_scored_because.id(),
              StatementId::attempt_interrupted);
    EXPECT_EQ(score_of(figures(1, -1, 0.1, 0), AttemptState::failed_simulation).not_scored_because.id(),
              StatementId::simulator_failed);
}

TEST(Score, WhatIsNotDoneYetDoesNotFailAnAttemptThatIsCutOff) {
    // A part too short for a metric: not done when the attempt has been carried to its end, open before.
    TaskDefinition task = small_task();
    task.gates.push_back({"ldlj", "right", "", GateKind::absolute, -6.7, "training limit", true});
    const BenchmarkSet set = small_set();
    std::vector<MetricResult> early = figures(1, -1, 0.1, 0);
    early[1] = test::missing("sparc", "right", Absence::not_done);
    early.push_back(test::missing("ldlj", "right", Absence::not_done));
    const auto verdict = [&](AttemptState state, bool device_lost) {
        ScoreInput input{task, early, &set, state};
        input.device_lost = device_lost;
        return score_attempt(input).passed;
    };
    EXPECT_FALSE(verdict(AttemptState::interrupted, false));  // no verdict
    EXPECT_FALSE(verdict(AttemptState::failed_simulation, false));
    EXPECT_FALSE(verdict(AttemptState::interrupted, true));
    EXPECT_FALSE(verdict(AttemptState::completed, true));
    EXPECT_EQ(verdict(AttemptState::completed, false), false);  // failed
    early.front().value = 1e5;                                  // s: broken for good
    EXPECT_EQ(verdict(AttemptState::interrupted, true), false);
}

TEST(Score, ALostDeviceTakesBackNothingAndGivesNoPass) {
    const TaskDefinition task = small_task();
    const BenchmarkSet set = small_set();
    const auto verdict = [&](const std::vector<MetricResult>& metrics, std::vector<CriticalError> errors) {
        ScoreInput input{task, metrics, &set};
        input.device_lost = true;
        input.critical_errors = std::move(errors);
        return score_attempt(input);
    };
    const std::vector<MetricResult> good = figures(50, -1, 0.1, 0), forced = figures(50, -1, 4.5, 0);
    EXPECT_FALSE(verdict(good, {}).passed);
    EXPECT_EQ(verdict(good, {}).not_scored_because.id(), StatementId::device_was_lost);
    EXPECT_EQ(verdict(forced, {}).passed, false);
    EXPECT_EQ(verdict(good, {perforation}).passed, false);
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

TEST(Score, IsFirmWithASetOfTheSiteThatTookTheTasksLimitsOver) {
    const std::vector<MetricResult> metrics = figures(std::exp(4.2), -1.6, 3.0, 1);
    const auto judged = [&](const TaskDefinition& task, const BenchmarkSet& set) {
        Score score = score_attempt(ScoreInput{task, metrics, &set});
        EXPECT_EQ(score.passed, true);
        return score;
    };
    const TaskDefinition task = small_task();
    const BenchmarkSet site = small_site_set();
    ASSERT_EQ(site.taken_over.size(), 1U) << "the limit on drops is not provisional";
    const Score firm = judged(task, site);
    EXPECT_FALSE(firm.provisional);
    EXPECT_FALSE(firm.gates[2].provisional);
    EXPECT_EQ(firm.gates[2].limit, 4.0);
    EXPECT_EQ(firm.gates[2].limit_source, "training limit, taken over by experts of this site, set 4");
    EXPECT_EQ(firm.gates[3].limit_source, task.gates[3].limit_source);

    // A newer program: another limit, or the same of another kind or of other values.
    TaskDefinition newer = task;
    newer.gates[2].limit = 3.5;
    EXPECT_TRUE(judged(newer, site).provisional);
    EXPECT_EQ(judged(newer, site).gates[2].limit, 3.5) << "the task's limit applies";
    EXPECT_EQ(judged(newer, site).gates[2].limit_source, "training limit");
    newer.gates[2].limit = 4.5;
    EXPECT_TRUE(judged(newer, site).provisional);
    newer.gates[2].limit = 4.0;
    newer.gates[2].exclusive = true;
    EXPECT_TRUE(judged(newer, site).provisional);
    newer.gates[2].exclusive = newer.gates[2].provisional = false;
    EXPECT_FALSE(judged(newer, site).provisional);
    EXPECT_EQ(judged(newer, site).gates[2].limit_source, "training limit")
        << "published: nobody's to take over";
    BenchmarkSet other = site;
    ++other.taken_over[0].metric_version;
    EXPECT_TRUE(judged(task, other).provisional);
    other = site;
    other.taken_over[0].hand = "right";
    EXPECT_TRUE(judged(task, other).provisional);
    other = site;
    other.taken_over.clear();
    EXPECT_TRUE(judged(task, other).provisional) << "a set from before limits were taken over";
    other = site;
    other.provisional = true;
    EXPECT_TRUE(judged(task, other).gates[2].provisional);
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

TEST(Gates, AnExclusiveLimitIsNotPassedAtTheLimit) {
    GateSpec spec;
    spec.metric = "crm_mm";
    spec.kind = GateKind::absolute;
    spec.limit = 1;
    spec.limit_source = "a source";
    const auto passes = [&](double value) {
        MetricResult result;
        result.id = spec.metric;
        result.value = value;
        return judge_gate(spec, {result}, nullptr).passed;
    };
    EXPECT_EQ(passes(1.0), true);
    spec.exclusive = true;
    EXPECT_EQ(passes(1.0), false);
    EXPECT_EQ(passes(1.0 + 1e-9), false);
    EXPECT_EQ(passes(1.001), true);
    EXPECT_EQ(passes(0.9), false);
}

}  // namespace
}  // namespace fulcrum
