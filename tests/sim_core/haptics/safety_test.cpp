// SPDX-License-Identifier: Apache-2.0
#include "sim_core/haptics/safety.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim_core/numerics/random.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double slew_a_tick = 0.3 + 1e-9;

SafetyInput force_of(const Vector3& force) {
    SafetyInput input;
    input.force = force;
    return input;
}

// A hand past its start ramp under a steady force.
SafetyState settled(const SafetyLimits& limits, const Vector3& force) {
    SafetyState state;
    for (int tick = 0; tick < 1000; ++tick) step_safety(limits, force_of(force), state);
    return state;
}

TEST(ClampForce, KeepsTheDirection) {
    bool clamped = false;
    const Vector3 force(30, -40, 0);
    const Vector3 result = clamp_force(force, 10, &clamped);
    EXPECT_TRUE(clamped);
    EXPECT_NEAR((result - Vector3(6, -8, 0)).norm(), 0, 1e-12);
    EXPECT_EQ(clamp_force(Vector3(1, 2, 2), 10, &clamped), Vector3(1, 2, 2));
    EXPECT_FALSE(clamped);
    EXPECT_NEAR(clamp_force(Vector3(1e300, 1e300, 0), 10).norm(), 10, 1e-9);
    EXPECT_EQ(clamp_force(Vector3(nan, 1, 1), 10), Vector3::Zero());
    EXPECT_EQ(clamp_force(Vector3(1, infinite, 1), 10), Vector3::Zero());
}

TEST(Safety, StartsWithARamp) {
    const SafetyLimits limits;
    SafetyState state;
    double last = 0;
    for (std::uint32_t tick = 0; tick < limits.ramp_ticks; ++tick) {
        const SafetyOutput output = step_safety(limits, force_of({8, 0, 0}), state);
        EXPECT_LE(output.force.norm() - last, slew_a_tick);
        EXPECT_GE(output.force.norm(), last - 1e-12);
        EXPECT_NE(output.flags & safety_ramping, 0);
        last = output.force.norm();
    }
    EXPECT_NEAR(step_safety(limits, force_of({8, 0, 0}), state).force.x(), 8.0, 1e-12);
}

TEST(Safety, ForceOfAMovingHandIsClampedButNotSlowed) {
    const SafetyLimits limits;
    SafetyState state = settled(limits, Vector3::Zero());
    const SafetyOutput hit = step_safety(limits, force_of({0, 9, 0}), state);
    EXPECT_EQ(hit.force, Vector3(0, 9, 0));
    const SafetyOutput hard = step_safety(limits, force_of({0, 600, 800}), state);
    EXPECT_NEAR((hard.force - Vector3(0, 6, 8)).norm(), 0, 1e-12);
    EXPECT_NE(hard.flags & safety_clamped, 0);
}

TEST(Safety, ModelSwapIsBumplessAndDecaysAtTheSlewRate) {
    const SafetyLimits limits;
    SafetyState state = settled(limits, {4, 0, 0});
    SafetyInput swap = force_of({1, 0, 0});
    swap.model_changed = true;
    swap.old_force = Vector3(4, 0, 0);
    Vector3 last(4, 0, 0);
    int ticks = 0;
    for (; ticks < 100; ++ticks) {
        const SafetyOutput output = step_safety(limits, swap, state);
        EXPECT_LE((output.force - last).norm(), slew_a_tick);
        last = output.force;
        swap.model_changed = false;
        if ((output.flags & safety_slewed) == 0) break;
    }
    EXPECT_EQ(ticks, 9);  // 3 N at 0.3 N a tick: nine ticks of decay, gone in the tenth
    EXPECT_EQ(last, Vector3(1, 0, 0));
}

TEST(Safety, RepeatedSwapsStayContinuous) {
    const SafetyLimits limits;
    SafetyState state = settled(limits, {2, 0, 0});
    Random random(4);
    Vector3 model(2, 0, 0), last = state.sent;
    for (int tick = 0; tick < 4000; ++tick) {
        SafetyInput input = force_of(model);
        if (tick % 5 == 0) {
            input.old_force = model;
            model = Vector3(random.normal(0, 6), random.normal(0, 6), random.normal(0, 6));
            input.force = model;
            input.model_changed = true;
        }
        const SafetyOutput output = step_safety(limits, input, state);
        ASSERT_LE((output.force - last).norm(), slew_a_tick) << tick;
        ASSERT_LE(output.force.norm(), limits.force + 1e-9);
        last = output.force;
    }
}

// A contact that flips from tick to tick like a hand chattering on an edge, combined with the hand's own
// motion.
TEST(Safety, UnexplainedChangeDecaysAtTheSlewRateMinusTheMotionsShare) {
    const SafetyLimits limits;
    SafetyState state = settled(limits, {4, 0, 0});
    SafetyInput input = force_of({4, 0, 0});
    input.explained = 0;
    Vector3 last(4, 0, 0), model(4, 0, 0);
    Random random(5);
    for (int tick = 0; tick < 3000; ++tick) {
        const double own = random.uniform(0, 0.25);
        if (tick % 3 == 0) model = Vector3(random.uniform(-4, 4), random.uniform(-4, 4), 0);
        if (tick % 3 != 0) model += own * Vector3(random.normal(0, 1), random.normal(0, 1), 0).normalized();
        input.force = model;
        input.explained = own;
        const SafetyOutput output = step_safety(limits, input, state);
        ASSERT_LE((output.force - last).norm(), slew_a_tick) << tick;
        last = output.force;
    }
    input.explained = 0;
    for (int tick = 0; tick < 40; ++tick) last = step_safety(limits, input, state).force;
    EXPECT_NEAR((last - model).norm(), 0, 1e-12) << "the difference has decayed";
    // The change due to motion passes immediately.
    input.force = model + Vector3(0, 0, 2);
    input.explained = 2 * (1 + 1e-12);
    EXPECT_NEAR((step_safety(limits, input, state).force - input.force).norm(), 0, 1e-9);
}

TEST(Safety, LossAgeAndNanSlewToZeroAndReturnByRamp) {
    const SafetyLimits limits;
    for (int cause = 0; cause < 3; ++cause) {
        SafetyState state = settled(limits, {0, 0, 7});
        SafetyInput bad = force_of({0, 0, 7});
        if (cause == 0) bad.connected = false;
        if (cause == 1) bad.model_age = limits.age_limit + 1;
        if (cause == 2) bad.force.y() = nan;
        Vector3 last(0, 0, 7);
        int ticks = 0;
        while (last.norm() > 0 && ticks < 1000) {
            const SafetyOutput output = step_safety(limits, bad, state);
            ASSERT_TRUE(output.force.allFinite());
            EXPECT_LE((output.force - last).norm(), slew_a_tick);
            EXPECT_LT(output.force.norm(), last.norm());
            last = output.force;
            ++ticks;
        }
        EXPECT_EQ(ticks, 24);  // 7 N at 0.3 N a tick
        for (int tick = 0; tick < 400; ++tick) {
            const SafetyOutput output = step_safety(limits, force_of({0, 0, 7}), state);
            EXPECT_LE((output.force - last).norm(), slew_a_tick);
            last = output.force;
        }
        EXPECT_NEAR(last.z(), 7.0, 1e-12);
    }
}

TEST(Safety, FlagsGiveTheReason) {
    const SafetyLimits limits;
    SafetyState state = settled(limits, {1, 0, 0});
    SafetyInput input = force_of({1, 0, 0});
    EXPECT_EQ(step_safety(limits, input, state).flags, 0);
    input.model_age = 41;
    EXPECT_NE(step_safety(limits, input, state).flags & safety_stale, 0);
    input.model_age = 0;
    input.force.x() = infinite;
    EXPECT_NE(step_safety(limits, input, state).flags & safety_not_finite, 0);
    SafetyLimits without_age = limits;
    without_age.age_limit = 0;
    SafetyInput old = force_of({1, 0, 0});
    old.model_age = 1000000;
    EXPECT_EQ(step_safety(without_age, old, state).flags & safety_stale, 0);
}

TEST(Safety, ForceIsFiniteAndWithinTheLimitForAnyInput) {
    const SafetyLimits limits;
    SafetyState state;
    Random random(17);
    const double odd[] = {nan, infinite, -infinite, 0.0, -0.0, 1e308, -1e308, 1e-320, 1e13, 3.0, -8.0};
    bool was_live = false;
    Vector3 last = Vector3::Zero();
    for (int tick = 0; tick < 20000; ++tick) {
        SafetyInput input;
        for (int i = 0; i < 3; ++i) {
            input.force[i] = random.below(4) == 0 ? odd[random.below(11)] : random.normal(0, 5);
            input.old_force[i] = random.below(4) == 0 ? odd[random.below(11)] : random.normal(0, 5);
        }
        input.model_changed = random.below(3) == 0;
        input.connected = random.below(10) != 0;
        input.model_age = random.below(60);
        const SafetyOutput output = step_safety(limits, input, state);
        ASSERT_TRUE(output.force.allFinite()) << tick;
        ASSERT_LE(output.force.norm(), limits.force * (1 + 1e-12)) << tick;
        if (!state.live || !was_live) {
            ASSERT_LE((output.force - last).norm(), slew_a_tick) << tick;
        }
        was_live = state.live;
        last = output.force;
    }
}

TEST(Safety, TickDoesNotAllocate) {
    const SafetyLimits limits;
    SafetyState state;
    EXPECT_EQ(test::allocations_in([&] {
                  for (int tick = 0; tick < 100; ++tick) step_safety(limits, force_of({1, 2, 3}), state);
              }),
              0U);
}

}  // namespace
}  // namespace fulcrum
