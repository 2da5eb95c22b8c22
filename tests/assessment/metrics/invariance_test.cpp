// SPDX-License-Identifier: Apache-2.0
// What changes and what does not where the same attempt is recorded otherwise.
#include "assessment/metrics/invariance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assessment/attempt/memory_sink.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/registry.h"
#include "assessment/operators/operator.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

RecordedAttempt attempt_of_an_expert(const std::string& id) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/" + id + ".json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    AttemptEngine engine(scene, task, 2001);
    RecordedAttempt attempt;
    const std::vector<TargetSphere>& targets = engine.initial_snapshot().targets;
    const auto rig = make_operator(OperatorLevel::expert, task, scene, 2001);
    MemorySink sink;
    run_headless(engine, *rig, sink);
    std::vector<std::string> labels;
    for (const TissueSpec& tissue : scene.tissues) labels.push_back(tissue.label);
    attempt.trace = trace_from_samples(sink.record.samples, sink.record.events, labels, scene.tick_rate);
    attempt.events = sink.record.events;
    attempt.context = make_metric_context(scene, task, targets);
    return attempt;
}

double of(const MetricChange& change, TraceChange kind) {
    return change.relative[static_cast<std::size_t>(kind)];
}

bool is_force(const std::string& id) {
    const auto& channels = find_metric(id)->channels;
    return std::any_of(channels.begin(), channels.end(), [](Channel c) { return c == Channel::force; });
}

class Invariance : public testing::TestWithParam<const char*> {};

TEST_P(Invariance, FrameAndClockChangeNothing) {
    const std::vector<MetricChange> changes = compare_changes(attempt_of_an_expert(GetParam()));
    ASSERT_GT(changes.size(), 20U);
    for (const MetricChange& change : changes)
        for (const TraceChange kind :
             {TraceChange::turned, TraceChange::mirrored, TraceChange::moved, TraceChange::later})
            EXPECT_LE(of(change, kind), 1e-6) << change.id << " " << change.hand << " "
                                              << trace_changes[static_cast<std::size_t>(kind)].title;
}

TEST_P(Invariance, ASpikeChangesNoForceByMoreThanItsPrecision) {
    const RecordedAttempt attempt = attempt_of_an_expert(GetParam());
    const RecordedAttempt spiked = changed(attempt, TraceChange::spike);
    EXPECT_GE(replaced_force_samples(spiked.trace), replaced_force_samples(attempt.trace) + 2);
    for (const MetricChange& change : compare_changes(attempt))
        EXPECT_LE(of(change, TraceChange::spike), is_force(change.id) ? 1e-3 : 0)
            << change.id << " " << change.hand;
}

TEST_P(Invariance, RateAndNoiseChangeWhatTheTableSays) {
    for (const MetricChange& change : compare_changes(attempt_of_an_expert(GetParam()))) {
        EXPECT_LE(of(change, TraceChange::half_rate), 0.05)
            << change.id << " " << change.hand << " " << change.value;
        EXPECT_LE(of(change, TraceChange::noise), 0.05)
            << change.id << " " << change.hand << " " << change.value;
    }
}

INSTANTIATE_TEST_SUITE_P(Tasks, Invariance, testing::Values("A2", "B2"),
                         [](const auto& task) { return std::string(task.param); });

}  // namespace
}  // namespace fulcrum
