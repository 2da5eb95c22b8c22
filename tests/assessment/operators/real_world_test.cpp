// SPDX-License-Identifier: Apache-2.0
// Operators on the product's own world: they finish the tasks, and the same seed ends in the same state.
#include <gtest/gtest.h>

#include <algorithm>

#include "assessment/attempt/engine.h"
#include "assessment/operators/operator.h"
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

RunOutcome perform(const std::string& id, const char* preset, std::uint64_t seed, EventList& events) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/" + id + ".json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    AttemptEngine engine(scene, task, seed);
    const auto rig = make_operator(preset, task, scene, seed);
    return run_headless(engine, *rig, events);
}

TEST(OperatorOnTheWorld, EveryPresetTouchesAllTargetsAndRepeatsItself) {
    for (const char* preset : {"expert", "intermediate", "novice"}) {
        EventList first, second;
        const RunOutcome a = perform("A2", preset, 2500, first), b = perform("A2", preset, 2500, second);
        EXPECT_EQ(a.end, EventKind::completed) << preset;
        EXPECT_EQ(first.count(EventKind::target_reached), 20) << preset;
        EXPECT_EQ(a.state_hash, b.state_hash) << preset;
        EXPECT_EQ(a.ticks, b.ticks) << preset;
    }
}

TEST(OperatorOnTheWorld, ExpertRunsAndLiftsTheBowelWithoutHarm) {
    EventList events;
    const RunOutcome run = perform("B1", "expert", 2500, events);
    EXPECT_EQ(run.end, EventKind::completed);
    EXPECT_EQ(events.count(EventKind::phase_end), 2);
    EXPECT_GE(events.count(EventKind::grasp), 9) << "60 cm in steps of at most 8 cm, then the lift";
    EXPECT_EQ(events.count(EventKind::perforation), 0);
    EXPECT_EQ(events.count(EventKind::drop), 0);
    EXPECT_LT(events.worst(), 3U) << "no step was thrown away";
}

}  // namespace
}  // namespace fulcrum
