// SPDX-License-Identifier: GPL-3.0-or-later
// Which stored attempts of experts limits are made of.
#include "database/scoring/expert_attempts.h"

#include <gtest/gtest.h>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "assessment/scoring/taken_over.h"
#include "tests/database/expert_values.h"
#include "tests/database/large_programme.h"
#include "tests/support/own_folder.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr int surgeons = 10, attempts_of_surgeon = 6;

/// Of every gate: a value at `z` of the set. Those of the metric `older` are of the version before the
/// program's.
void measure_gates(const TaskDefinition& task, const BenchmarkSet& set, double z, const std::string& older,
                   database::ScoreRow& score) {
    score.gates.clear();
    score.metrics.clear();
    for (const GateSpec& spec : task.gates) {
        const MetricDescriptor& about = *find_metric(spec.metric);
        const BenchmarkLevel* level = set.find(spec.metric, spec.hand, spec.tissue);
        database::MetricRow row;
        row.id = spec.metric;
        row.version = spec.metric == older ? about.version - 1 : about.version;
        row.hand = spec.hand;
        row.tissue = spec.tissue;
        row.value = about.direction == Direction::higher ? spec.limit : 0;
        if (spec.kind == GateKind::benchmark && level != nullptr) row.value = limit_of(about, *level, z);
        row.unit = about.unit;
        row.direction = about.direction;
        score.metrics.push_back(row);
    }
}

database::Session educator_of(const database::Store& store, const database::test::LargeProgramme& programme) {
    const database::People people(store);
    const auto administrator = people.sign_in("administrator", "correct horse battery");
    const auto made = people.create(administrator, "ed", "Ed Educator", {database::Role::educator});
    const database::Session educator = people.change_password(people.sign_in("ed", made.one_time_password),
                                                              made.one_time_password, "a long password");
    people.set_educators(programme.director, programme.cohort, {educator.person_id()});
    return educator;
}

TEST(ExpertAttempts, LimitsAreMadeOfValuesOfThePresentVersionsOnly) {
    const test::OwnFolder folder;
    const database::Store store = database::Store::create((folder / "fulcrum.db").string());
    const LoadedTask loaded = load_task_and_scene("A2");
    const BenchmarkSet set = load_benchmark(test::source_path("assets/benchmarks/A2.json"));
    ASSERT_FALSE(set.levels.empty());
    const std::string older = set.levels.front().metric;
    const auto programme = database::test::make_large_programme(
        store, surgeons, attempts_of_surgeon, 1, 7, {"A2"},
        [&](database::ScoreRow& score, Random& random) {
            measure_gates(loaded.task, set, random.uniform(-0.7, 0.7), older, score);
        },
        loaded.task.version);
    const database::Session educator = educator_of(store, programme);
    const std::vector<ExpertCandidate> experts =
        expert_candidates(store, educator, loaded.task, {"A2", "standard", DeviceClass::haptic, "standard"});
    ASSERT_EQ(experts.size(), static_cast<std::size_t>(surgeons));
    const auto counted = [&] {
        return expert_attempts(store, educator, loaded, DeviceClass::haptic, experts).value();
    };
    EXPECT_TRUE(counted().empty());
    const BenchmarkBuild build =
        build_benchmark(loaded.task, expert_request(loaded, DeviceClass::haptic, 99, counted()));
    EXPECT_FALSE(build.set.has_value());
    EXPECT_FALSE(build.refusal.empty());

    // Recomputed: the score in force stays the older one, the one next to it counts.
    const database::Attempts attempts(store);
    database::AttemptFilter filter;
    filter.task_id = "A2";
    filter.limit = 2 * surgeons * attempts_of_surgeon;
    for (const database::AttemptSummary& summary : attempts.list(educator, filter)) {
        database::ScoreRow score = attempts.score(educator, summary.meta.id).value();
        for (database::MetricRow& row : score.metrics) row.version = find_metric(row.id)->version;
        attempts.add_score(educator, summary.meta.id, score);
    }
    const std::vector<BenchmarkAttempt> again = counted();
    EXPECT_EQ(again.size(),
              static_cast<std::size_t>(surgeons * (attempts_of_surgeon - familiarisation_attempts)));
    for (const BenchmarkAttempt& attempt : again)
        for (const MetricResult& metric : attempt.metrics)
            EXPECT_EQ(metric.version, find_metric(metric.id)->version) << metric.id;
}

TEST(ExpertAttempts, OfSimulatedPeopleMakeAProvisionalSetThatTakesOverNothing) {
    const test::OwnFolder folder;
    const database::Store store = database::Store::create((folder / "fulcrum.db").string());
    const LoadedTask loaded = load_task_and_scene("A2");
    const BenchmarkSet set = load_benchmark(test::source_path("assets/benchmarks/A2.json"));
    const auto programme = database::test::make_large_programme(
        store, surgeons, attempts_of_surgeon, 1, 7, {"A2"},
        [&](database::ScoreRow& score, Random& random) {
            database::test::write_expert_values(loaded.task, set, random.uniform(-0.7, 0.7), score);
        },
        loaded.task.version);
    const database::Session educator = educator_of(store, programme);
    const std::vector<ExpertCandidate> experts =
        expert_candidates(store, educator, loaded.task, {"A2", "standard", DeviceClass::haptic, "standard"});
    ASSERT_EQ(experts.size(), static_cast<std::size_t>(surgeons));
    const auto build = [&] {
        return build_benchmark(
            loaded.task,
            expert_request(loaded, DeviceClass::haptic, 99,
                           expert_attempts(store, educator, loaded, DeviceClass::haptic, experts).value()));
    };
    const BenchmarkBuild of_people = build();
    ASSERT_TRUE(of_people.set) << of_people.refusal.words();
    EXPECT_FALSE(of_people.set->provisional);
    EXPECT_EQ(of_people.set->source, "experts of this site");
    EXPECT_EQ(provisional_words(of_people.set->taken_over),
              provisional_words(limits_to_take_over(loaded.task)));

    store.connection().execute("UPDATE person SET kind = 'synthetic' WHERE login = 'trainee1004'");
    const BenchmarkBuild mixed = build();
    EXPECT_FALSE(mixed.set);
    EXPECT_NE(mixed.refusal.words().find("trainee1004 are simulated"), std::string::npos)
        << mixed.refusal.words();

    store.connection().execute("UPDATE person SET kind = 'synthetic' WHERE login LIKE 'trainee%'");
    const BenchmarkBuild simulated = build();
    ASSERT_TRUE(simulated.set) << simulated.refusal.words();
    EXPECT_TRUE(simulated.set->provisional);
    EXPECT_TRUE(simulated.set->taken_over.empty());
    EXPECT_EQ(simulated.set->source.rfind("synthetic operators", 0), 0U) << simulated.set->source;

    // Whoever is named for it, an operator performed it.
    store.connection().execute("UPDATE person SET kind = 'real' WHERE login LIKE 'trainee%'");
    EXPECT_FALSE(build().set.value().provisional);
    store.connection().execute("DROP TRIGGER attempt_is_fixed");
    store.connection().execute("UPDATE attempt SET operator_name = 'expert'");
    EXPECT_TRUE(build().set.value().provisional);
}

}  // namespace
}  // namespace fulcrum
