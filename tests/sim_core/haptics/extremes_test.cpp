// SPDX-License-Identifier: Apache-2.0
// The extremes of docs/QUALITY.md for the haptic loop, generated: devices at the ends of their counts, jumps
// of a metre, pauses, losses and faults at random, ten turns of roll, models that come late or never, with
// the world stepping at the same time. The force to a hand is finite, within the limit, and slewed on a loss;
// the world stays finite, failed steps are reported, and the same inputs give the same bits.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "sim_core/haptics/loop.h"
#include "sim_core/world/world.h"
#include "tests/support/extremes.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr int ticks_a_case = 5;

struct Outcome {
    int forced = 0, held = 0, declared = 0;
    double largest = 0;
    std::uint64_t bits = 1469598103934665603ULL;
};

std::int32_t any_count(Random& random) {
    const std::int32_t ends[] = {0, 1, -1, std::numeric_limits<std::int32_t>::max(),
                                 std::numeric_limits<std::int32_t>::min()};
    return random.below(2) == 0 ? ends[random.below(5)] : static_cast<std::int32_t>(random.bits());
}

DeviceSample extreme_device(Random& random, const TrocarSpec& trocar, const Vector3& aim,
                            const DeviceSample& before) {
    DeviceSample device = before;
    const auto kind = random.below(40);
    if (kind == 0) {
        for (std::int32_t& count : device.handle) count = any_count(random);
    } else if (kind == 1) {
        device.roll = any_count(random);
        device.jaw = any_count(random);
        device.grip = any_count(random);
    } else if (kind == 2) {
        DeviceReading reading;
        reading.handle = Vector3(0, 0, -0.2) + test::inside_unit_box(random);
        reading.handle[static_cast<int>(random.below(3))] = test::not_a_length(random);
        device = quantise(reading, before);
        EXPECT_NE(device.faulty, 0);
    } else if (kind == 3) {
        device.present = 0;
    } else if (kind == 4) {  // ten turns
        device.roll = static_cast<std::int32_t>(62831853 * random.uniform(-1, 1));
    } else {
        const Trocar pivot = make_trocar(trocar);
        // Into the scene's objects, from any pose.
        const Vector3 tip = aim + 0.01 * test::inside_unit_box(random);
        const Vector3 handle = handle_for_tip(pivot, tip) / device_length_unit;
        for (int k = 0; k < 3; ++k) device.handle[k] = static_cast<std::int32_t>(std::lround(handle[k]));
        device.present = 1;
        device.jaw = random.below(2) == 0 ? 0 : 1000000;
        device.grip = static_cast<std::int32_t>(random.below(20000));
    }
    return device;
}

/// None, or one with any values, usable or not.
std::optional<ForceOutput> any_device(Random& random) {
    if (random.below(4) == 0) return std::nullopt;
    ForceOutput device;
    device.damping = random.below(8) == 0 ? test::not_a_length(random) : test::between(random, 1e-6, 1e3);
    device.peak = random.below(8) == 0 ? 0.0 : test::between(random, 1e-3, 100);
    device.continuous = device.peak * random.uniform(0, 1);
    device.torque = random.below(2) == 0 ? 0.0 : 0.1;
    device.scale = random.below(8) == 0 ? test::not_a_length(random) : test::between(random, 1e-3, 10);
    return device;
}

void run(const Scene& scene, int cases, std::uint64_t stream, Outcome& outcome) {
    World world(scene, 1);
    HapticLoop loop(scene, world);
    Random random(stream, 35);
    std::vector<TickOutput> outputs(ticks_a_case);
    DeviceSample device[hand_count];
    Vector3 sent[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    for (const InstrumentSpec& spec : scene.instruments)
        device[static_cast<int>(spec.hand)] = start_sample(spec.trocar, spec.start_insertion);
    const WorldSnapshot& shown = world.snapshot();
    const auto aim = [&]() -> Vector3 {
        const auto pick = [&](std::size_t count) { return random.below(static_cast<std::uint32_t>(count)); };
        return shown.bowel.nodes.empty() ? shown.targets[pick(shown.targets.size())].centre
                                         : shown.bowel.nodes[pick(shown.bowel.nodes.size())];
    };
    std::uint32_t tick = 0;
    for (int number = 0; number < cases; ++number) {
        SCOPED_TRACE(number);
        for (const InstrumentSpec& spec : scene.instruments) {
            if (number == 0) loop.set_device(spec.hand, any_device(random));
        }
        for (TickOutput& output : outputs) {
            RigSample input;
            input.tick = ++tick;
            if (number % 100 == 99) input.flags |= rig_paused;
            if (random.below(400) == 0) input.flags |= rig_device_lost;
            for (const InstrumentSpec& spec : scene.instruments) {
                const int hand = static_cast<int>(spec.hand);
                if (random.below(6) == 0)
                    device[hand] = extreme_device(random, spec.trocar, aim(), device[hand]);
                input.hand[hand] = device[hand];
            }
            if (scene.camera)
                input.camera =
                    extreme_device(random, scene.camera->trocar, aim(),
                                   start_sample(scene.camera->trocar, scene.camera->start_insertion));
            output = loop.tick(input);
            const bool on_hold = (input.flags & (rig_paused | rig_device_lost)) != 0U;
            for (int hand = 0; hand < hand_count; ++hand) {
                const Vector3& force = output.device_force[hand];
                ASSERT_TRUE(force.allFinite());
                ASSERT_LE(force.norm(), scene.force_limit * (1 + 1e-12));
                ASSERT_LE(std::abs(output.device_torque[hand]), 0.1);
                if (on_hold || input.hand[hand].present == 0) {
                    ASSERT_LE((force - sent[hand]).norm(),
                              scene.slew_limit * scene.tick_period() * (1 + 1e-6))
                        << "on a loss";
                    ++outcome.held;
                }
                ASSERT_TRUE(output.contact[hand].tool.tip.allFinite() &&
                            output.contact[hand].tool.tip_velocity.allFinite());
                outcome.forced += force.norm() > 0 ? 1 : 0;
                outcome.largest = std::max(outcome.largest, force.norm());
                sent[hand] = force;
                for (const std::int32_t count : output.sample.hand[hand].device_force)
                    outcome.bits = (outcome.bits ^ static_cast<std::uint32_t>(count)) * 1099511628211ULL;
            }
        }
        const StepRecord record = world.step(outputs.data(), outputs.size());
        outcome.declared += record.outcome != 0 ? 1 : 0;
        outcome.bits = (outcome.bits ^ record.state_hash) * 1099511628211ULL;
        for (const Vector3& node : world.snapshot().bowel.nodes) ASSERT_TRUE(node.allFinite());
        if (random.below(4) != 0) loop.adopt(world.local_models());  // or late, or not at all
    }
}

TEST(HapticLoopExtremes, SentForceIsFiniteLimitedAndSlewedForAnyInput) {
    for (const char* name : {"a2_targets", "b1_bowel"}) {
        Scene scene = load_scene(test::source_path(std::string("assets/scenes/") + name + ".json"));
        scene.fidelity.rod_iterations = 4;
        Outcome outcome;
        const int cases = test::cases_asked() / 2;
        constexpr int devices = 10;
        for (std::uint64_t stream = 1; stream <= devices; ++stream)
            run(scene, cases / devices, 10 + stream, outcome);
        std::printf("%s: %d forces sent, %.1f N at most; %d held hands; %d steps said that they gave way\n",
                    name, outcome.forced, outcome.largest, outcome.held, outcome.declared);
        EXPECT_GT(outcome.forced, cases / 10);
        EXPECT_GT(outcome.held, cases / 10);
        Outcome first, second;
        run(scene, cases / 20, 2, first);
        run(scene, cases / 20, 2, second);
        EXPECT_EQ(first.bits, second.bits);
    }
}

}  // namespace
}  // namespace fulcrum
