// SPDX-License-Identifier: Apache-2.0
// An attempt that begins with a state of another one, as part-task practice and taking over do.
#include "assessment/attempt/engine_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "assessment/attempt/memory_sink.h"
#include "assessment/operators/operator.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/state_archive.h"
#include "tests/support/force_device.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

struct PartTask {
    TaskDefinition task = load_task(test::source_path("assets/tasks/B2.json"));
    Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
};

/// The state of the engine in which expert 7 has come to goal 1; the first test leaves it for the others.
std::optional<std::vector<std::uint8_t>> state_at_the_goal;

void bring_to_the_goal(AttemptEngine& engine, const PartTask& part) {
    if (!state_at_the_goal) {
        AttemptEngine performed(part.scene, part.task, 7);
        const auto expert = make_operator(OperatorLevel::expert, part.task, part.scene, 7);
        ASSERT_TRUE(perform_to_goal(performed, *expert, 1, [] { return true; }));
        state_at_the_goal = engine_state(performed);
    }
    restore_engine(engine, *state_at_the_goal);
}

TEST(BegunAtAGoal, RunsOnReplaysFromItsOwnStateAndStartsItsClockAgain) {
    const PartTask part;
    AttemptEngine engine(part.scene, part.task, 7);
    const auto expert = make_operator(OperatorLevel::expert, part.task, part.scene, 7);
    ASSERT_TRUE(perform_to_goal(engine, *expert, 1, [] { return true; }));
    state_at_the_goal = engine_state(engine);
    EXPECT_EQ(engine.display().goal, 1);
    const double before = engine.display().elapsed_s;
    EXPECT_GT(before, 1);
    engine.begin_here();
    EXPECT_EQ(engine.display().goal, 1);
    EXPECT_EQ(engine.display().elapsed_s, 0);
    EXPECT_EQ(engine.initial_snapshot().tick + 1, engine.next_tick());
    const std::uint32_t first = engine.next_tick();
    const std::vector<std::uint8_t> state = engine_state(engine);

    MemorySink sink;
    const RunOutcome outcome = run_headless(engine, *expert, sink);
    EXPECT_EQ(outcome.end, EventKind::completed);
    const std::vector<Event>& events = sink.record.events;
    ASSERT_GE(events.size(), 2U);
    EXPECT_EQ(events[0].kind, EventKind::attempt_begin);
    EXPECT_EQ(events[0].tick, first);
    EXPECT_EQ(events[1].kind, EventKind::phase_begin);
    EXPECT_EQ(events[1].detail, 1);
    EXPECT_TRUE(std::any_of(events.begin(), events.end(),
                            [](const Event& event) { return event.kind == EventKind::first_movement; }));

    AttemptEngine again(part.scene, part.task, 7);
    restore_engine(again, state);
    EXPECT_EQ(again.next_tick(), first);
    EXPECT_EQ(again.initial_snapshot().tick + 1, first);
    const ReplayOutcome replay = replay_record(again, sink.record);
    EXPECT_TRUE(replay.identical) << replay.first_divergence_s;
    EXPECT_EQ(replay.state_hash, outcome.state_hash);
    EXPECT_EQ(replay.events.size(), events.size());
    AttemptEngine fresh(part.scene, part.task, 7);
    int steps = 0;
    const auto first_second = [&](const WorldSnapshot&) { return ++steps < 200; };
    EXPECT_FALSE(replay_record(fresh, sink.record, false, first_second).identical) << "the state matters";
}

TEST(BegunAtAGoal, InstrumentsStayWhereTheyAreWhereverTheDevicesAre) {
    const PartTask part;
    AttemptEngine engine(part.scene, part.task, 7);
    ASSERT_NO_FATAL_FAILURE(bring_to_the_goal(engine, part));
    engine.begin_here();
    const Vector3 tip = engine.initial_snapshot().tools[1].tip;
    RigSample input = engine.loop().last_input();
    for (int i = 0; i < 10; ++i) {
        input.tick = engine.next_tick();
        for (DeviceSample& hand : input.hand) hand.handle[0] = 300000;  // 3 cm to the side
        const TickSample sample = engine.tick(input).sample;
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(sample.hand[1].tip[axis] * sample_length_unit, tip[axis], 1e-4) << i;
    }
}

TEST(BegunAtAGoal, TheForceOnTheHandsGrowsFromZero) {
    const PartTask part;
    AttemptEngine engine(part.scene, part.task, 7);
    ASSERT_NO_FATAL_FAILURE(bring_to_the_goal(engine, part));
    engine.begin_here();
    engine.use_devices({test::desk_device(), test::desk_device()});
    RigSample input = engine.loop().last_input();
    double first = 0, later = 0, tissue = 0;
    for (int i = 0; i < 40; ++i) {  // before the model, which no step renews here, is too old
        input.tick = engine.next_tick();
        const TickOutput& output = engine.tick(input);
        const double felt = std::max(output.device_force[0].norm(), output.device_force[1].norm());
        if (i == 0) first = felt;
        later = std::max(later, felt);
        for (const HandSample& hand : output.sample.hand) {
            const Vector3 force(hand.force[0], hand.force[1], hand.force[2]);
            tissue = std::max(tissue, force.norm() * sample_force_unit);
        }
    }
    ASSERT_GT(tissue, 0.2) << "the flap is held under traction";
    EXPECT_LT(first, 0.05);
    EXPECT_GT(later, first);
}

TEST(BegunAtAGoal, WhereItIsStoppedOrThereIsNoSuchGoal) {
    PartTask part;
    part.task.time_limit_s = 1;  // the attempt ends soon without the goal
    AttemptEngine engine(part.scene, part.task, 7);
    const auto expert = make_operator(OperatorLevel::expert, part.task, part.scene, 7);
    int steps = 0;
    EXPECT_FALSE(perform_to_goal(engine, *expert, 1, [&] { return ++steps < 10; }));
    EXPECT_EQ(steps, 10);
    EXPECT_THROW(perform_to_goal(engine, *expert, 99, [] { return true; }), InputError);
    std::vector<std::uint8_t> state = engine_state(engine);
    state.resize(state.size() / 2);
    AttemptEngine again(part.scene, part.task, 7);
    EXPECT_THROW(restore_engine(again, state), StateArchiveError);
}

}  // namespace
}  // namespace fulcrum
