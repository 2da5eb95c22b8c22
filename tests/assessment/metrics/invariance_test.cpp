// SPDX-License-Identifier: Apache-2.0
// What changes and what does not where the same attempt is recorded otherwise.
#include "assessment/metrics/invariance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/registry.h"
#include "tests/assessment/attempt/expert_record.h"

namespace fulcrum {
namespace {

RecordedAttempt attempt_of_an_expert(const std::string& id) {
    const test::ExpertRecord& expert = test::expert_record(id);
    std::vector<std::string> labels;
    for (const TissueSpec& tissue : expert.scene.tissues) labels.push_back(tissue.label);
    RecordedAttempt attempt;
    attempt.trace =
        trace_from_samples(expert.record.samples, expert.record.events, labels, expert.scene.tick_rate);
    attempt.events = expert.record.events;
    attempt.context = make_metric_context(expert.scene, expert.task, expert.targets);
    return attempt;
}

/// Of a task, computed once in a process.
const std::vector<MetricChange>& changes_of_an_expert(const std::string& id) {
    static std::map<std::string, std::vector<MetricChange>> known;
    auto found = known.find(id);
    if (found == known.end()) found = known.emplace(id, compare_changes(attempt_of_an_expert(id))).first;
    return found->second;
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
    const std::vector<MetricChange>& changes = changes_of_an_expert(GetParam());
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
    for (const MetricChange& change : changes_of_an_expert(GetParam()))
        EXPECT_LE(of(change, TraceChange::spike), is_force(change.id) ? 1e-3 : 0)
            << change.id << " " << change.hand;
}

TEST_P(Invariance, RateAndNoiseChangeWhatTheTableSays) {
    for (const MetricChange& change : changes_of_an_expert(GetParam())) {
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
