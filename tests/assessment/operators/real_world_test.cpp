// SPDX-License-Identifier: Apache-2.0
// Operators in the real world model: they complete the tasks, and the same seed gives the same final state.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "assessment/attempt/memory_sink.h"
#include "assessment/learning/statistics.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/operators/operator.h"
#include "assessment/task/specimen_plan.h"
#include "sim_core/scene/fidelity.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

class EventList : public AttemptSink {
  public:
    void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
    void on_step(const StepRecord& step) noexcept override { worst_ = std::max(worst_, step.outcome); }
    void on_event(const Event& event) noexcept override { events_.push_back(event); }
    int count(EventKind kind) const {
        return static_cast<int>(
            std::count_if(events_.begin(), events_.end(), [&](const Event& e) { return e.kind == kind; }));
    }
    std::uint32_t worst() const { return worst_; }

  private:
    std::vector<Event> events_;
    std::uint32_t worst_ = 0;
};

RunOutcome perform(const std::string& id, OperatorLevel preset, std::uint64_t seed, EventList& events,
                   const char* fidelity = nullptr) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/" + id + ".json"));
    Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    if (fidelity != nullptr) scene.fidelity = named_fidelity(fidelity);
    AttemptEngine engine(scene, task, seed);
    const auto rig = make_operator(preset, task, scene, seed);
    return run_headless(engine, *rig, events);
}

TEST(OperatorOnTheWorld, EveryPresetTouchesAllTargetsAndRepeatsItself) {
    for (const auto& [preset, name, title] : operator_levels) {
        EventList first, second;
        const RunOutcome a = perform("A2", preset, 2500, first), b = perform("A2", preset, 2500, second);
        EXPECT_EQ(a.end, EventKind::completed) << name;
        EXPECT_EQ(first.count(EventKind::target_reached), 20) << name;
        EXPECT_EQ(a.state_hash, b.state_hash) << name;
        EXPECT_EQ(a.ticks, b.ticks) << name;
    }
}

class Recording : public AttemptSink {
  public:
    void on_tick(const RigSample& /*input*/, const TickSample& sample) noexcept override {
        samples.push_back(sample);
    }
    void on_step(const StepRecord& /*step*/) noexcept override {}
    void on_event(const Event& event) noexcept override { events.push_back(event); }
    std::vector<TickSample> samples;
    std::vector<Event> events;
};

// Six seeds here; the twenty that docs/results shows are run by `fulcrum lab operators`.
TEST(OperatorOnTheWorld, ExpertsAndNovicesVaryAndAreSeparated) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    std::vector<std::string> tissues;
    for (const TissueSpec& tissue : scene.tissues) tissues.push_back(tissue.label);
    MetricContext context = make_metric_context(scene, task, {});
    context.metrics = {"time", "path_len", "f_max", "sparc", "ldlj"};
    std::map<std::string, std::vector<double>> values[2];
    constexpr OperatorLevel presets[] = {OperatorLevel::expert, OperatorLevel::novice};
    for (int p = 0; p < 2; ++p) {
        for (std::uint64_t seed = 2000; seed < 2006; ++seed) {
            AttemptEngine engine(scene, task, seed);
            const auto rig = make_operator(presets[p], task, scene, seed);
            Recording record;
            run_headless(engine, *rig, record);
            const Trace trace = trace_from_samples(record.samples, record.events, tissues, scene.tick_rate);
            for (const MetricResult& row : compute_metrics(trace, record.events, context)) {
                if (!row.tissue.empty()) continue;
                // A novice may have too few pauses between movements: smoothness is then absent with a
                // reason.
                if (row.value) values[p][row.id + ' ' + row.hand].push_back(*row.value);
            }
        }
    }
    for (const auto& [name, expert] : values[0]) {
        const std::vector<double>& novice = values[1][name];
        EXPECT_EQ(expert.size(), 6U) << name;
        EXPECT_GE(novice.size(), 5U) << name;
        const auto a = median_interval(expert, 0.9), b = median_interval(novice, 0.9);
        ASSERT_TRUE(a && b) << name;
        if (name.rfind("ldlj", 0) == 0) continue;
        EXPECT_TRUE(a->high < b->low || b->high < a->low)
            << name << ": " << a->low << " to " << a->high << ", " << b->low << " to " << b->high;
        if (name != "time ") continue;
        EXPECT_GT(a->high, 1.15 * a->low) << "experts keep paces of their own";
        EXPECT_GT(b->high, 1.2 * b->low) << "and novices more so";
    }
}

TEST(OperatorOnTheWorld, ExpertRunsAndLiftsTheBowelWithoutHarm) {
    EventList events;
    const RunOutcome run = perform("B1", OperatorLevel::expert, 2500, events);
    EXPECT_EQ(run.end, EventKind::completed);
    EXPECT_EQ(events.count(EventKind::phase_end), 2);
    EXPECT_GE(events.count(EventKind::grasp), 9) << "60 cm in steps of at most 8 cm, then the lift";
    EXPECT_EQ(events.count(EventKind::perforation), 0);
    EXPECT_EQ(events.count(EventKind::drop), 0);
    EXPECT_LT(events.worst(), 3U) << "no step was thrown away";
}

// One linear solve and one projection per step: grasped tissue stays in the jaws.
TEST(OperatorOnTheWorld, ExpertRunsTheBowelAtTheFastFidelity) {
    EventList events;
    EXPECT_EQ(perform("B1", OperatorLevel::expert, 2500, events, "fast").end, EventKind::completed);
    EXPECT_GE(events.count(EventKind::grasp), 9);
    EXPECT_EQ(events.count(EventKind::perforation), 0);
    EXPECT_EQ(events.count(EventKind::drop), 0);
    EXPECT_LT(events.worst(), 3U);
}

TEST(OperatorOnTheWorld, ExpertPullsAndCutsTheSheetAndTheCutReplaysBitForBit) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/B2.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    AttemptEngine engine(scene, task, 2500);
    const auto rig = make_operator(OperatorLevel::expert, task, scene, 2500);
    MemorySink sink;
    const RunOutcome run = run_headless(engine, *rig, sink, [](double t) { return t < 12; });
    const auto count = [&](EventKind kind) {
        return std::count_if(sink.record.events.begin(), sink.record.events.end(),
                             [&](const Event& event) { return event.kind == kind; });
    };
    EXPECT_GE(count(EventKind::grasp), 1);
    EXPECT_GE(count(EventKind::cut_begin), 1);
    EXPECT_GE(count(EventKind::cut_advance), 10);
    EXPECT_EQ(count(EventKind::cut_advance), count(EventKind::cut_traction));
    EXPECT_EQ(count(EventKind::simulator_fault), 0);
    EXPECT_GT(engine.display().cut_divided_m, 0.002);
    const bool cutting =
        std::any_of(sink.record.samples.begin(), sink.record.samples.end(),
                    [](const TickSample& sample) { return (sample.hand[1].flags & hand_cutting) != 0; });
    EXPECT_TRUE(cutting) << "the tick says when a blade is in tissue";
    AttemptEngine again(scene, task, 2500);
    const ReplayOutcome replay = replay_record(again, sink.record);
    EXPECT_TRUE(replay.identical) << replay.first_divergence_s;
    EXPECT_EQ(replay.state_hash, run.state_hash);
}

// The first of four levels; whole attempts of twenty seeds are in docs/results.
TEST(OperatorOnTheWorld, ExpertLiftsTheRectumAndDividesInThePlane) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/C4.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    AttemptEngine engine(scene, task, 2500);
    const auto rig = make_operator(OperatorLevel::expert, task, scene, 2500);
    MemorySink sink;
    run_headless(engine, *rig, sink,
                 [&](double t) { return t < 20 && engine.display().cut_divided_m < 0.02; });
    const auto count = [&](EventKind kind) {
        return std::count_if(sink.record.events.begin(), sink.record.events.end(),
                             [&](const Event& event) { return event.kind == kind; });
    };
    EXPECT_GE(count(EventKind::grasp), 1) << "the rectum is held";
    EXPECT_GE(count(EventKind::phase_end), 1) << "and was put under tension";
    EXPECT_GE(engine.display().cut_divided_m, 0.02);
    EXPECT_EQ(
        count(EventKind::perforation) + count(EventKind::vessel_injury) + count(EventKind::nerve_injury), 0);
    EXPECT_EQ(count(EventKind::simulator_fault), 0);
    // With energy, in the tissue that is divided, and short.
    const auto on_ticks =
        std::count_if(sink.record.samples.begin(), sink.record.samples.end(),
                      [](const TickSample& sample) { return (sample.hand[1].flags & hand_energy) != 0; });
    EXPECT_GE(count(EventKind::activation_end), 1);
    const double on = static_cast<double>(on_ticks) * scene.tick_period();
    EXPECT_GT(on, 0.3);
    EXPECT_LT(on, 1.5 * static_cast<double>(count(EventKind::activation_begin)));
    const PathologyReport report = pathology_report(cut_strokes(sink.record.events, scene.tick_period(), 20),
                                                    make_specimen_plan(scene, task).value());
    EXPECT_EQ(report.reasons.at(0), GradeReason::undivided)
        << "after 20 mm of the line there is no grade yet";
    EXPECT_LE(report.deepest_defect, deep_defect);
    EXPECT_LT(report.plane.median.value(), 0.0015);
}

}  // namespace
}  // namespace fulcrum
