// SPDX-License-Identifier: Apache-2.0
// What changes and what does not where the same attempt is recorded otherwise.
#include "assessment/metrics/invariance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <set>

#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/registry.h"
#include "tests/assessment/attempt/expert_record.h"

namespace fulcrum {
namespace {

RecordedAttempt attempt_of_an_expert(const std::string& id) {
    const test::ExpertRecord& expert = test::expert_record(id);
    const Scene& scene = expert.scene;
    std::vector<std::string> labels;
    for (const TissueSpec& tissue : scene.tissues) labels.push_back(tissue.label);
    RecordedAttempt attempt;
    attempt.trace = trace_from_samples(
        expert.record.samples, expert.record.events, labels, scene.tick_rate,
        {scene.instrument(Hand::left) != nullptr, scene.instrument(Hand::right) != nullptr});
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

class Invariance : public testing::TestWithParam<std::string> {
  protected:
    /// Each row of metrics moves by what the table of the page allows.
    static void expect_what_is_allowed(TraceChange kind) {
        for (const MetricChange& change : changes_of_an_expert(GetParam())) {
            const AllowedChange& allowed = allowed_change(kind, change.id);
            EXPECT_LE(of(change, kind), allowed.most)
                << change.id << " " << change.hand << " " << change.tissue << ", " << change.value << ", "
                << trace_changes[static_cast<std::size_t>(kind)].title << ": " << allowed.why;
        }
    }
};

TEST_P(Invariance, FrameAndClockChangeWhatTheTableAllows) {
    ASSERT_GE(changes_of_an_expert(GetParam()).size(), 6U);
    for (const TraceChange kind :
         {TraceChange::turned, TraceChange::mirrored, TraceChange::moved, TraceChange::later})
        expect_what_is_allowed(kind);
}

TEST_P(Invariance, ASpikeChangesNoForceByMoreThanItsPrecision) {
    const RecordedAttempt attempt = attempt_of_an_expert(GetParam());
    const RecordedAttempt spiked = changed(attempt, TraceChange::spike);
    std::size_t hands = 0;
    for (const HandTrace& hand : attempt.trace.hand) hands += hand.fx.empty() ? 0 : 1;
    EXPECT_GE(replaced_force_samples(spiked.trace), replaced_force_samples(attempt.trace) + hands);
    expect_what_is_allowed(TraceChange::spike);
}

TEST_P(Invariance, RateAndNoiseChangeWhatTheTableAllows) {
    expect_what_is_allowed(TraceChange::half_rate);
    expect_what_is_allowed(TraceChange::noise);
}

INSTANTIATE_TEST_SUITE_P(Tasks, Invariance, testing::ValuesIn(test::task_ids()),
                         [](const auto& task) { return task.param; });

TEST(AllowedChanges, CoverEveryMetricAndEveryChangeOnce) {
    for (const NameRow<TraceChange>& change : trace_changes) {
        std::size_t others = 0;
        std::set<std::string> named;
        for (const AllowedChange& row : allowed_changes()) {
            if (row.change != change.kind) continue;
            others += row.metrics.empty() ? 1 : 0;
            EXPECT_STRNE(row.why, "") << change.name;
            for (const std::string& metric : row.metrics) {
                EXPECT_NE(find_metric(metric), nullptr) << metric;
                EXPECT_TRUE(named.insert(metric).second) << metric << " twice, " << change.name;
            }
        }
        EXPECT_EQ(others, 1U) << change.name;
    }
    EXPECT_EQ(allowed_change(TraceChange::turned, "f_sd").most, 0.01);
    EXPECT_EQ(allowed_change(TraceChange::turned, "path_len").most, 1e-6);
    EXPECT_EQ(allowed_change(TraceChange::spike, "grasp_max").most, 0);
}

// An image that turns with the patient shows the target at the same place.
TEST(ChangedTrace, HasTheScopeTurnedAndMirroredWithIt) {
    RecordedAttempt attempt;
    attempt.trace.t = {0, 0.001};
    CameraTrace& camera = attempt.trace.camera;
    camera.px = {0.01, 0.02};
    camera.py = {0.03, 0.03};
    camera.pz = {0.10, 0.11};
    const Quaternion pose(Eigen::AngleAxisd(0.7, Vector3(0.2, 1, 0.4).normalized()));
    camera.qw.assign(2, pose.w());
    camera.qx.assign(2, pose.x());
    camera.qy.assign(2, pose.y());
    camera.qz.assign(2, pose.z());
    attempt.context.targets.push_back({});
    attempt.context.targets.front().centre = Vector3(0.05, -0.02, 0.01);
    const auto seen = [](const RecordedAttempt& one) {
        const CameraTrace& at = one.trace.camera;
        const Quaternion turn(at.qw[1], at.qx[1], at.qy[1], at.qz[1]);
        return Vector3(turn.conjugate() *
                       (one.context.targets.front().centre - Vector3(at.px[1], at.py[1], at.pz[1])));
    };
    const Vector3 before = seen(attempt), turned = seen(changed(attempt, TraceChange::turned)),
                  mirrored = seen(changed(attempt, TraceChange::mirrored));
    EXPECT_LE((turned - before).norm(), 1e-12);
    EXPECT_LE((mirrored - Vector3(-before.x(), before.y(), before.z())).norm(), 1e-12);
}

}  // namespace
}  // namespace fulcrum
