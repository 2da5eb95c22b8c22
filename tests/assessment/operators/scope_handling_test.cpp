// SPDX-License-Identifier: Apache-2.0
// Synthetic operators who hold the scope (A1): what experts and novices do differently.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "assessment/attempt/memory_sink.h"
#include "assessment/operators/device_model.h"
#include "assessment/operators/operator.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

struct Performed {
    std::vector<Event> events;
    double seconds = 0;
    bool completed = false;
    int count(EventKind kind) const {
        return static_cast<int>(std::count_if(events.begin(), events.end(),
                                              [&](const Event& event) { return event.kind == kind; }));
    }
};

Performed perform(OperatorLevel preset, std::uint64_t seed, DeviceClass device = DeviceClass::synthetic) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A1.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    AttemptEngine engine(scene, task, seed);
    const auto rig = through_device(make_operator(preset, task, scene, seed), device, scene, seed);
    MemorySink sink;
    const RunOutcome outcome = run_headless(engine, *rig, sink);
    return {sink.record.events, outcome.ticks * scene.tick_period(), outcome.end == EventKind::completed};
}

/// Performed at the first call with this seed.
const Performed& expert_of(std::uint64_t seed) {
    static std::map<std::uint64_t, Performed> made;
    const auto found = made.find(seed);
    if (found != made.end()) return found->second;
    return made.emplace(seed, perform(OperatorLevel::expert, seed)).first->second;
}

TEST(ScopeHandling, ExpertsFrameEveryTargetAndSeldomTouchOne) {
    int contacts = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Performed& one = expert_of(seed);
        EXPECT_TRUE(one.completed) << seed;
        EXPECT_EQ(one.count(EventKind::target_reached), 13) << seed;
        EXPECT_LE(one.count(EventKind::lens_contact), 2) << seed;
        contacts += one.count(EventKind::lens_contact);
    }
    EXPECT_LE(contacts, 10);
}

TEST(ScopeHandling, NovicesTakeLongerAndLoseTheTip) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const Performed novice = perform(OperatorLevel::novice, seed);
        const Performed& expert = expert_of(seed);
        EXPECT_TRUE(novice.completed) << seed;
        EXPECT_GT(novice.seconds, 1.3 * expert.seconds) << seed;
        const auto lost = [](const Performed& one) {
            double sum = 0;
            for (const Event& event : one.events)
                if (event.kind == EventKind::target_lost) sum += event.value;
            return sum;
        };
        EXPECT_GT(lost(novice), lost(expert)) << seed;
    }
}

// Without instruments no tick waits for a model of the world: the replay once made all ticks before the first
// step, and what waited grew with the attempt.
TEST(ScopeHandling, ReplayMakesEachStepWithItsTicks) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A1.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    AttemptEngine engine(scene, task, 3);
    const auto rig = make_operator(OperatorLevel::expert, task, scene, 3);
    MemorySink sink;
    const RunOutcome outcome = run_headless(engine, *rig, sink);
    AttemptEngine whole(scene, task, 3);
    const ReplayOutcome replay = replay_record(whole, sink.record);
    EXPECT_TRUE(replay.identical);
    EXPECT_EQ(replay.state_hash, outcome.state_hash);
    AttemptEngine begun(scene, task, 3);
    const ReplayOutcome first =
        replay_record(begun, sink.record, true, [](const WorldSnapshot&) { return false; });
    EXPECT_EQ(first.samples.size(), static_cast<std::size_t>(scene.ticks_per_step));
}

TEST(ScopeHandling, MouseAloneIsEnough) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
        EXPECT_TRUE(perform(OperatorLevel::expert, seed, DeviceClass::mouse_keyboard).completed) << seed;
}

}  // namespace
}  // namespace fulcrum
