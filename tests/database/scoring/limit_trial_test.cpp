// SPDX-License-Identifier: GPL-3.0-or-later
// Stored values judged again by other sets: what changes, and what no set can take back.
#include "database/scoring/limit_trial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "assessment/assets/assets.h"
#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "database/scoring/scoring.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/scene/standard_names.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

/// An attempt in the scene's tissue whose benchmark gates are all `z` expert deviations worse than the
/// experts' mean, and whose other gates are met.
struct Trial {
    std::string name = "A2";
    TaskDefinition task = load_task(test::source_path("assets/tasks/" + name + ".json"));
    BenchmarkSet set = load_benchmark(test::source_path("assets/benchmarks/" + name + ".json"));
    TriedAttempt attempt(double z) const {
        TriedAttempt made;
        made.person_id = "p" + std::to_string(z);
        made.cutting = made.scene_cutting = cutting_of_file(task, std::string(standard_variant));
        for (const GateSpec& spec : task.gates) {
            database::GateRow gate;
            gate.metric = spec.metric;
            gate.hand = spec.hand;
            gate.tissue = spec.tissue;
            gate.kind = spec.kind;
            gate.passed = true;
            if (spec.kind == GateKind::benchmark) {
                const BenchmarkLevel& level = *set.find(spec.metric, spec.hand, spec.tissue);
                made.metric_versions[spec.metric] = level.metric_version;
                gate.value = limit_of(*find_metric(spec.metric), level, z);
            }
            made.gates.push_back(gate);
        }
        return made;
    }
    /// One of Ann's with all gates met. `scene`: as it was used; empty: kept by no record.
    void record(const database::test::Programme& programme, AttemptState state,
                const std::string& scene = "") const {
        database::AttemptMeta meta = database::test::example_meta(programme.id("ann"), name);
        meta.task_version = task.version;
        meta.device_class = set.device_class;
        meta.scene = task.scene;
        meta.scene_text = scene;
        database::Recorder recorder(programme.path, programme.session("ann"), meta,
                                    programme.clock.options());
        database::test::Programme::append_second(recorder);
        database::AttemptResult result = database::test::example_result(false, 0);
        result.state = state;
        result.score->gates = attempt(0).gates;
        result.score->metrics.clear();
        for (const database::GateRow& gate : result.score->gates) {
            if (!gate.value) continue;
            database::MetricRow row;
            row.id = gate.metric;
            row.version = find_metric(gate.metric)->version;
            row.hand = gate.hand;
            row.tissue = gate.tissue;
            row.value = gate.value;
            row.unit = find_metric(gate.metric)->unit;
            result.score->metrics.push_back(row);
        }
        recorder.finish(result);
    }
};

TEST(LimitTrial, AWiderSetPassesWhatANarrowerFails) {
    const Trial trial;
    BenchmarkSet narrow = trial.set, wide = trial.set;
    narrow.k = 1;
    wide.k = 3;
    const TriedAttempt attempt = trial.attempt(2);
    EXPECT_EQ(passes_under(trial.task, attempt, narrow), false);
    EXPECT_EQ(passes_under(trial.task, attempt, wide), true);
    const std::vector<TriedAttempt> attempts = {trial.attempt(0.5), attempt, trial.attempt(2.5),
                                                trial.attempt(4)};
    const TrialCount few = count_passes(trial.task, attempts, narrow),
                     many = count_passes(trial.task, attempts, wide);
    EXPECT_EQ(few.passed, 1);
    EXPECT_EQ(many.passed, 3);
    EXPECT_EQ(many.attempts, 4);
    EXPECT_EQ(many.people, 4);
    EXPECT_EQ(many.people_passed, 3);
}

TEST(LimitTrial, WhatIsBrokenUnderAnyLimitsStaysFailed) {
    const Trial trial;
    BenchmarkSet wide = trial.set;
    wide.k = 3;
    TriedAttempt critical = trial.attempt(0);
    critical.critical = true;
    EXPECT_EQ(passes_under(trial.task, critical, wide), false);
    TriedAttempt absolute = trial.attempt(0), not_done = trial.attempt(0);
    bool has_absolute = false;
    for (database::GateRow& gate : absolute.gates) {
        if (gate.kind != GateKind::absolute || has_absolute) continue;
        has_absolute = true;
        gate.passed = false;
    }
    ASSERT_TRUE(has_absolute);
    EXPECT_EQ(passes_under(trial.task, absolute, wide), false);
    for (database::GateRow& gate : not_done.gates) {
        if (gate.kind != GateKind::benchmark) continue;
        gate.value.reset();
        gate.passed = false;
    }
    EXPECT_EQ(passes_under(trial.task, not_done, wide), false);
}

TEST(LimitTrial, WhatWasAbandonedOrRanOutOfTimePassesUnderNoLimits) {
    const Trial trial;
    TriedAttempt attempt = trial.attempt(0);
    EXPECT_EQ(passes_under(trial.task, attempt, trial.set), true);
    attempt.completed = false;
    EXPECT_EQ(passes_under(trial.task, attempt, trial.set), false);

    const database::test::Programme programme;
    for (const AttemptState state :
         {AttemptState::completed, AttemptState::abandoned, AttemptState::timed_out})
        trial.record(programme, state);
    const std::vector<TriedAttempt> tried =
        tried_attempts(*programme.store, programme.session("director"), trial.task, trial.set.key());
    ASSERT_EQ(tried.size(), 3U);
    const TrialCount count = count_passes(trial.task, tried, trial.set);
    EXPECT_EQ(count.passed, 1) << "the one that was completed";
    EXPECT_EQ(count.not_judged, 0);
}

TEST(LimitTrial, ASetNarrowsAnAbsoluteLimitAndAnotherDoesNot) {
    const Trial trial;
    BenchmarkSet narrow = trial.set;
    BenchmarkLevel force = narrow.levels[0];
    force.metric = "f_max";
    force.hand = "left";
    force.unit = "N";
    force.metric_version = find_metric("f_max")->version;
    force.mean = std::log(1.0);
    force.deviation = 0.2;
    force.k = 3;
    narrow.levels.push_back(force);
    const auto pushed = [&](double newtons, bool met) {
        TriedAttempt made = trial.attempt(0);
        made.metric_versions["f_max"] = force.metric_version;
        for (database::GateRow& gate : made.gates) {
            if (gate.metric != "f_max" || gate.hand != "left") continue;
            gate.value = newtons;
            gate.passed = met;
        }
        return made;
    };
    EXPECT_EQ(passes_under(trial.task, pushed(1.8, true), narrow), true);
    EXPECT_EQ(passes_under(trial.task, pushed(1.9, true), narrow), false);
    // Failed by the narrower limit that was in force, within the task's own.
    EXPECT_EQ(passes_under(trial.task, pushed(1.9, false), trial.set), true);
    EXPECT_EQ(passes_under(trial.task, pushed(4.1, false), trial.set), false);
    TriedAttempt older = pushed(1.8, true);
    older.metric_versions["f_max"] = force.metric_version - 1;
    EXPECT_EQ(passes_under(trial.task, older, narrow), std::nullopt);
    EXPECT_EQ(passes_under(trial.task, older, trial.set), true);
}

TEST(LimitTrial, WhatCannotBeJudgedIsNotAPass) {
    const Trial trial;
    TriedAttempt attempt = trial.attempt(0);
    EXPECT_EQ(passes_under(trial.task, attempt, trial.set), true);
    TriedAttempt older = attempt;
    for (auto& [metric, version] : older.metric_versions) --version;
    EXPECT_FALSE(passes_under(trial.task, older, trial.set).has_value());
    BenchmarkSet without = trial.set;
    without.levels.clear();
    EXPECT_FALSE(passes_under(trial.task, attempt, without).has_value());
    attempt.gates.clear();
    EXPECT_FALSE(passes_under(trial.task, attempt, trial.set).has_value());
    EXPECT_EQ(count_passes(trial.task, {attempt}, trial.set).not_judged, 1);
}

TEST(LimitTrial, AnAttemptInOtherTissueIsNotJudged) {
    const Trial trial{"B2"};
    ASSERT_FALSE(trial.set.cutting.empty());
    TriedAttempt attempt = trial.attempt(0);
    EXPECT_EQ(passes_under(trial.task, attempt, trial.set), true);
    attempt.cutting["areolar"]["penetrate_n"] = 0.11;
    EXPECT_EQ(passes_under(trial.task, attempt, trial.set), std::nullopt);
    EXPECT_EQ(count_passes(trial.task, {attempt}, trial.set).not_judged, 1);
    BenchmarkSet of_scene = trial.set, of_site = trial.set;
    of_scene.cutting.clear();
    of_site.cutting = attempt.cutting;
    EXPECT_EQ(passes_under(trial.task, attempt, of_scene), std::nullopt);
    EXPECT_EQ(passes_under(trial.task, trial.attempt(0), of_scene), true);
    EXPECT_EQ(passes_under(trial.task, attempt, of_site), true);
    EXPECT_EQ(passes_under(trial.task, trial.attempt(0), of_site), std::nullopt);
    // What fails by a limit of the task itself fails in any tissue.
    for (database::GateRow& gate : attempt.gates)
        if (gate.kind == GateKind::absolute) gate.passed = false;
    EXPECT_EQ(passes_under(trial.task, attempt, trial.set), false);
}

TEST(LimitTrial, TheTissueOfAnAttemptIsThatOfItsRecord) {
    const Trial trial{"B2"};
    const std::string file = asset_path("scenes/" + trial.task.scene);
    const std::string text = read_text_file(file, JsonLimits().bytes);
    const std::string tough = with_cutting_values(text, file, {{"areolar", {{"penetrate_n", 0.11}}}});
    const database::test::Programme programme;
    for (const std::string& scene : {std::string(), text, tough, tough})
        trial.record(programme, AttemptState::completed, scene);
    const std::vector<TriedAttempt> tried =
        tried_attempts(*programme.store, programme.session("director"), trial.task, trial.set.key());
    ASSERT_EQ(tried.size(), 4U);
    const TrialCount count = count_passes(trial.task, tried, trial.set);
    EXPECT_EQ(count.passed, 2);
    EXPECT_EQ(count.not_judged, 2);
    BenchmarkSet built_here = trial.set;
    built_here.cutting["areolar"]["penetrate_n"] = 0.11;
    EXPECT_EQ(count_passes(trial.task, tried, built_here).passed, 2);
}

TEST(LimitTrial, AnAttemptWhoseSceneCannotBeReadIsLeftOut) {
    const Trial trial{"B2"};
    const std::string text = read_text_file(asset_path("scenes/" + trial.task.scene), JsonLimits().bytes);
    const std::string older = "{\"id\": \"older\"}";
    const database::test::Programme programme;
    for (const std::string& scene : {text, older, older})
        trial.record(programme, AttemptState::completed, scene);
    const std::vector<TriedAttempt> tried =
        tried_attempts(*programme.store, programme.session("director"), trial.task, trial.set.key());
    ASSERT_EQ(tried.size(), 1U);
    EXPECT_EQ(count_passes(trial.task, tried, trial.set).passed, 1);
}

TEST(LimitTrial, FindsTheSetsOfATaskAndNoOthers) {
    const std::vector<BenchmarkSet> sets = sets_in_force("A2");
    ASSERT_GE(sets.size(), 2U);
    for (const BenchmarkSet& set : sets) EXPECT_EQ(set.task, "A2");
    EXPECT_TRUE(sets_in_force("Z9").empty());
}

}  // namespace
}  // namespace fulcrum
