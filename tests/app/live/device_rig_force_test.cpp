// SPDX-License-Identifier: GPL-3.0-or-later
// Hands of a device that have force: what takes it from them, and what the device gets.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>

#include "app/live/device_watch.h"
#include "assessment/attempt/engine.h"
#include "sim_core/devices/device_table.h"
#include "sim_core/haptics/hand_output.h"
#include "sim_core/haptics/loop.h"
#include "sim_core/instrument/mouse_mapping.h"
#include "sim_core/rigid/targets.h"
#include "sim_core/world/world.h"
#include "tests/app/live/rig_on_pages.h"

namespace fulcrum::app::program_test {
namespace {

// The device process switches both motors off: before, the attempt continued without force.
TEST(DeviceRig, AHandWithForceIsAbsentWhileTheDeviceHasAFaultOfAnyHand) {
    OnPages at;
    at.facts.force[1] = at.facts.force[0];
    at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                         at.others, SlotUse{-1, 1, scope_slot}, 1);
    const auto present = [&at] {
        at.publish();
        at.read();
        return at.sample.hand[1].present == 1;
    };
    EXPECT_TRUE(present()) << "before the first report";
    // Of the left hand, which mouse and keyboard move.
    at.state->fault.write({static_cast<std::uint64_t>(DeviceFault::switched_off), 1});
    EXPECT_FALSE(present());
    EXPECT_EQ(at.sample.hand[1].faulty, 0);
    at.state->fault.write({});
    EXPECT_TRUE(present());
}

TEST(DeviceRig, AHandWithoutForceStaysWhenAnotherHandHasAFault) {
    OnPages at;  // the right hand has no force
    at.state->fault.write({static_cast<std::uint64_t>(DeviceFault::switched_off), 1});
    at.publish();
    at.read();
    EXPECT_EQ(at.sample.hand[0].present, 0);
    EXPECT_EQ(at.sample.hand[1].present, 1);
}

// The limit was taken at the instrument only: at 200 % the hand got twice as much.
TEST(DeviceRig, WithAnotherScaleOfTheMovementTheForceChangesWithinTheSlewLimitAtTheDevice) {
    for (const double motion : {0.5, 1.0, 2.0}) {
        OnPages at;
        SlotUse use;
        use.motion = motion;
        at.facts.force[0]->damping = 1e6;
        at.facts.force[0]->continuous = 3.3;
        at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                             at.others, use, 1);
        const double step = at.scene.slew_limit * at.scene.tick_period();
        SafetyLimits limits;
        limits.slew = at.scene.slew_limit;
        limits.ramp_ticks = 0;
        HandOutput output(limits);
        output.set_device(at.rig->force_output(Hand::left));
        HandTick tick;
        tick.handle = tick.device = Vector3(0, 0, 0.1);
        const Vector3 force(0, 0, -10);  // of the instrument on what it touches, at the tip
        tick.load.add(Vector3(0, 0, -0.1), force, force, 500.0 * Matrix3::Identity(), Matrix3::Zero());
        const auto on_device = [&] {
            at.rig->write_force(Hand::left, output.step(tick).force);
            ForceCommand sent;
            EXPECT_TRUE(at.command->command[0].read(sent));
            return Vector3(sent.force[0], sent.force[1], sent.force[2]);
        };
        Vector3 before = Vector3::Zero();
        for (int i = 0; i < 60; ++i) {
            const Vector3 now = on_device();
            ASSERT_LE((now - before).norm(), step * (1 + 1e-9)) << motion << " " << i;
            before = now;
        }
        EXPECT_NEAR(before.norm(), 3.3, 0.05) << "the peak";
        tick.connected = false;
        for (int i = 0; i < 60; ++i) {
            const Vector3 now = on_device();
            ASSERT_LE((now - before).norm(), step * (1 + 1e-9)) << motion << " " << i;
            before = now;
        }
        EXPECT_EQ(before, Vector3(Vector3::Zero())) << motion;
    }
}

TEST(DeviceRig, ACommandHasForceAndTorqueOfOneTick) {
    OnPages at;
    at.facts.force[0]->torque = 0.05;
    at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                         at.others, SlotUse{}, 1);
    ForceCommand sent;
    TickOutput output;
    output.device_force[0] = Vector3(0, 1, 0);
    output.device_torque[0] = 0.02;
    write_forces(*at.rig, output);
    ASSERT_TRUE(at.command->command[0].read(sent));
    EXPECT_EQ(sent.torque, 0.02) << "before, it came with the next force";
    EXPECT_NEAR(std::hypot(std::hypot(sent.force[0], sent.force[1]), sent.force[2]), 1, 1e-12);
    write_forces(*at.rig, TickOutput{});
    ASSERT_TRUE(at.command->command[0].read(sent));
    EXPECT_EQ(sent.torque, 0) << "nothing is left at the end";
}

/// What the haptic and the world thread do at a tick, with the left device on the pages of a test.
struct LoopOnPages : OnPages {
    explicit LoopOnPages(std::uint64_t seed) : world(scene, seed), loop(scene, world) {
        facts.force[0]->continuous = 0.88;
        rig = std::make_unique<DeviceRig>(nullptr, *state.get(), *command.get(), facts, scene, others,
                                          SlotUse{}, 1);
        loop.set_device(Hand::left, rig->force_output(Hand::left));
    }
    /// N, the command that the device process finds after it.
    double run() {
        rig->read(++tick, sample);
        RigSample input = sample;
        input.camera = start_sample(scene.camera->trocar, scene.camera->start_insertion);
        input.flags |= watch.tick(sample, false, false);
        const TickOutput& output = outputs[(tick - 1) % outputs.size()] = loop.tick(input);
        write_forces(*rig, output);
        if (tick % outputs.size() == 0) {
            world.step(outputs.data(), outputs.size());
            loop.adopt(world.local_models());
        }
        ForceCommand sent;
        EXPECT_TRUE(command->command[0].read(sent));
        return Vector3(sent.force[0], sent.force[1], sent.force[2]).norm();
    }
    World world;
    HapticLoop loop;
    DeviceWatch watch;
    std::vector<TickOutput> outputs = std::vector<TickOutput>(5);
};

// As a device process whose memory is damaged would leave it: versions of the values included.
TEST(DeviceRig, GarbageOverTheWholePageOfTheDeviceTakesTheForceWithin50TicksAndPauses) {
    constexpr std::uint64_t seed = 7;
    for (const char* const garbage : {"random words", "zeros", "ones"}) {
        LoopOnPages at(seed);
        ASSERT_EQ(at.scene.ticks_per_step, 5);
        const InstrumentSpec& spec = *at.scene.instrument(Hand::left);
        const Trocar trocar = make_trocar(spec.trocar);
        const TargetSphere sphere = place_targets(*at.scene.targets, seed).front();
        const Vector3 out = (trocar.position - sphere.centre).normalized();
        const Vector3 tip = sphere.centre + (sphere.radius + spec.tip_radius - 0.0015) * out;
        const Vector3 place =
            DeviceRig::turned(handle_for_tip(trocar, tip) -
                              start_reading(spec.trocar.shaft_length, spec.start_insertion, 0).handle);
        double force = 0;
        for (int i = 0; i <= 800; ++i) {
            const double share = std::min(1.0, i / 400.0);
            for (int axis = 0; axis < 3; ++axis) at.pose[0].position[axis] = share * place[axis];
            at.publish();
            ++at.state->overseer_time;
            force = at.run();
        }
        ASSERT_GT(force, 0.1) << "it presses";
        ASSERT_FALSE(at.watch.lost());
        auto* const words = reinterpret_cast<std::atomic<std::uint64_t>*>(at.state.get());
        std::mt19937_64 random(11);
        int last_force = 0;
        for (int i = 1; i <= 100; ++i) {
            for (std::size_t w = 0; w < sizeof(StatePage) / sizeof *words; ++w)
                words[w].store(*garbage == 'r' ? random() : *garbage == 'z' ? 0 : ~std::uint64_t{0});
            if (at.run() != 0) last_force = i;
        }
        EXPECT_LT(last_force, 50) << garbage;
        EXPECT_TRUE(at.watch.lost()) << garbage << ": the attempt pauses";
    }
}

}  // namespace
}  // namespace fulcrum::app::program_test
