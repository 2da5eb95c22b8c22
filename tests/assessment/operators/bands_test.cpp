// SPDX-License-Identifier: Apache-2.0
// Operators at B3: they complete it, the record replays bit for bit, and better skill gives better results.
#include <gtest/gtest.h>

#include "assessment/attempt/memory_sink.h"
#include "assessment/metrics/metric.h"
#include "assessment/trace/trace.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

struct Performed {
    MemorySink sink;
    RunOutcome outcome;
    std::vector<MetricResult> metrics;
    double value(const char* id, const char* hand = "") const {
        const MetricResult* row = find_result(metrics, id, hand, "");
        return row != nullptr && row->value ? *row->value : -1;
    }
};

TaskDefinition b3() {
    return load_task(test::source_path("assets/tasks/B3.json"));
}
Scene bands() {
    return load_scene(test::source_path("assets/scenes/b3_bands.json"));
}

void perform(OperatorLevel preset, std::uint64_t seed, Performed& performed) {
    const TaskDefinition task = b3();
    const Scene scene = bands();
    AttemptEngine engine(scene, task, seed);
    const auto rig = make_operator(preset, task, scene, seed);
    performed.outcome = run_headless(engine, *rig, performed.sink);
    std::vector<std::string> labels;
    for (const TissueSpec& tissue : scene.tissues) labels.push_back(tissue.label);
    const AttemptRecord& record = performed.sink.record;
    const Trace trace = trace_from_samples(record.samples, record.events, labels, scene.tick_rate);
    MetricContext context;
    context.metrics = {"time",         "energy_safe",   "energy_time", "bleed_ml",
                       "lateral_heat", "vessel_injury", "nerve_injury"};
    performed.metrics = compute_metrics(trace, record.events, context);
}

TEST(BandOperators, AnExpertCompletesB3AndItsRecordReplaysBitForBit) {
    Performed expert;
    perform(OperatorLevel::expert, 3, expert);
    EXPECT_EQ(expert.outcome.end, EventKind::completed);
    int divided = 0, bled = 0, stopped = 0;
    for (const Event& event : expert.sink.record.events) {
        divided += event.kind == EventKind::band_divided ? 1 : 0;
        bled += event.kind == EventKind::bleed_begin ? 1 : 0;
        stopped += event.kind == EventKind::bleed_end ? 1 : 0;
    }
    EXPECT_EQ(divided, 10);
    EXPECT_GE(bled, 3);
    EXPECT_EQ(stopped, bled);
    EXPECT_EQ(expert.value("vessel_injury"), 0.0);
    EXPECT_EQ(expert.value("nerve_injury"), 0.0);
    EXPECT_GE(expert.value("energy_safe"), 80.0);
    EXPECT_GT(expert.value("bleed_ml"), 0.1);

    AttemptEngine again(bands(), b3(), 3);
    const ReplayOutcome replay = replay_record(again, expert.sink.record);
    EXPECT_TRUE(replay.identical) << replay.first_divergence_s;
    EXPECT_EQ(replay.state_hash, expert.outcome.state_hash);
    ASSERT_EQ(replay.events.size(), expert.sink.record.events.size());
    for (std::size_t i = 0; i < replay.events.size(); ++i) {
        EXPECT_EQ(replay.events[i].kind, expert.sink.record.events[i].kind);
        EXPECT_EQ(replay.events[i].value, expert.sink.record.events[i].value);
    }
}

TEST(BandOperators, NeedBothHandsAndOneKindOfGoal) {
    Scene scene = bands();
    scene.instruments.pop_back();
    EXPECT_THROW(make_operator(OperatorLevel::expert, b3(), scene, 1), InputError);
    TaskDefinition task = b3();
    task.goals.push_back(Goal());
    EXPECT_THROW(make_operator(OperatorLevel::expert, task, bands(), 1), InputError);
}

}  // namespace
}  // namespace fulcrum
