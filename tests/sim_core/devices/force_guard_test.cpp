// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/force_guard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

constexpr std::int64_t ms = 1'000'000;

ForceGuardLimits desk_limits() {
    ForceGuardLimits limits;
    limits.peak = 3.3;
    limits.torque = 0.1;
    return limits;
}

/// A guard with a program that sends 1 N every millisecond.
struct Guarded {
    ForceGuard guard{desk_limits()};
    ForceCommand command;
    std::int64_t now = 5'000'000'000;
    std::uint64_t connection = 1;
    bool overseen = true, sends = true;

    Guarded() { command.force[0] = 1; }
    ForceGuard::Sent tick() {
        now += ms;
        if (sends) ++command.sequence;
        return guard.step(now, &command, connection, overseen);
    }
    ForceGuard::Sent ticks(int count) {
        ForceGuard::Sent sent;
        for (int i = 0; i < count; ++i) sent = tick();
        return sent;
    }
};

TEST(ForceGuard, ForceRisesOnlyAfterSteadyCommands) {
    Guarded at;
    EXPECT_EQ(at.ticks(195).force, Vector3::Zero());
    EXPECT_EQ(at.ticks(1).off, ForceOff::starting);
    double before = 0;
    for (int i = 0; i < 310; ++i) {
        const double now = at.tick().force.x();
        EXPECT_LE(now - before, 1.0 / 300 + 1e-9);
        EXPECT_GE(now, before);
        before = now;
    }
    EXPECT_EQ(at.tick().force, Vector3(1, 0, 0));
    EXPECT_EQ(at.tick().off, ForceOff::none);
}

TEST(ForceGuard, SilenceIsNoticedWithin20MillisecondsWhateverTheCommandSaysOfItsTime) {
    Guarded at;
    at.ticks(600);
    at.sends = false;
    at.command.time = std::numeric_limits<std::int64_t>::max();  // not believed
    for (int i = 0; i < 20; ++i) EXPECT_EQ(at.tick().force.x(), 1);
    const auto sent = at.tick();
    EXPECT_EQ(sent.off, ForceOff::silent);
    EXPECT_EQ(sent.force, Vector3::Zero());
    at.sends = true;
    EXPECT_EQ(at.ticks(190).force, Vector3::Zero()) << "force comes back slowly";
}

TEST(ForceGuard, EveryLieSwitchesTheForceOffAtOnce) {
    const double inf = std::numeric_limits<double>::infinity();
    struct Lie {
        double force, torque;
        ForceOff off;
    };
    for (const Lie& lie : {Lie{NAN, 0, ForceOff::not_finite}, Lie{inf, 0, ForceOff::not_finite},
                           Lie{1, NAN, ForceOff::not_finite}, Lie{3.4, 0, ForceOff::too_large},
                           Lie{-1e300, 0, ForceOff::too_large}, Lie{1, 0.2, ForceOff::too_large}}) {
        Guarded at;
        at.ticks(600);
        at.command.force[0] = lie.force;
        at.command.torque = lie.torque;
        auto sent = at.tick();
        EXPECT_EQ(sent.off, lie.off);
        EXPECT_EQ(sent.force, Vector3::Zero());
        EXPECT_EQ(sent.torque, 0);
        at.command.force[0] = 1;
        at.command.torque = 0;
        EXPECT_EQ(at.ticks(190).force, Vector3::Zero());
        EXPECT_EQ(at.ticks(400).force.x(), 1);
    }
}

TEST(ForceGuard, AnOldSequenceIsALie) {
    Guarded at;
    at.ticks(600);
    at.command.sequence -= 2;
    EXPECT_EQ(at.tick().off, ForceOff::sequence_back);
}

TEST(ForceGuard, WithoutProgramOrOverseerThereIsNoForce) {
    Guarded at;
    at.ticks(600);
    at.overseen = false;
    EXPECT_EQ(at.tick().off, ForceOff::overseer_stopped);
    at.overseen = true;
    at.ticks(600);
    at.connection = 0;
    EXPECT_EQ(at.tick().off, ForceOff::no_program);
    at.connection = 2;
    at.command.sequence = 0;  // another program counts from its own beginning
    EXPECT_EQ(at.tick().off, ForceOff::starting);
}

TEST(ForceGuard, ADeviceWithoutForceGetsNone) {
    ForceGuard guard;
    ForceCommand command;
    for (int i = 1; i < 600; ++i) {
        command.sequence = static_cast<std::uint64_t>(i);
        command.force[0] = 0.5;
        EXPECT_EQ(guard.step(i * ms, &command, 1, true).force, Vector3::Zero());
    }
}

TEST(ForceGuard, IsFiniteAndWithinThePeakForEveryInputAndAllocatesNothing) {
    std::mt19937_64 random(7);
    ForceGuard guard(desk_limits());
    const std::uint64_t before = test::allocation_count();
    for (int i = 0; i < 200000; ++i) {
        ForceCommand command;
        std::uint64_t words[sizeof(ForceCommand) / 8];
        for (auto& word : words) word = random();
        std::memcpy(static_cast<void*>(&command), words, sizeof command);
        const auto now = static_cast<std::int64_t>(random());
        const auto sent =
            guard.step(random() % 4 == 0 ? now : i * ms, &command, random() % 3, random() % 8 != 0);
        ASSERT_TRUE(sent.force.allFinite());
        ASSERT_LE(sent.force.norm(), 3.3 + 1e-9);
        ASSERT_LE(std::abs(sent.torque), 0.1);
    }
    EXPECT_EQ(test::allocation_count(), before);
}

}  // namespace
}  // namespace fulcrum
