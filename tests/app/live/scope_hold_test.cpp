// SPDX-License-Identifier: GPL-3.0-or-later
// A scope that is moved during a pause or a loss is where it was when the attempt continues.
#include "app/live/scope_hold.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

#include "app/live/live_attempt.h"
#include "app/live/sample_tap.h"
#include "sim_core/instrument/mouse_mapping.h"

namespace fulcrum::app {
namespace {

using namespace std::chrono_literals;

DeviceSample scope_at(std::int32_t x, std::int32_t roll = 0, std::int32_t head = 0) {
    DeviceSample scope;
    scope.handle[0] = x;
    scope.handle[1] = 2 * x;
    scope.handle[2] = -1'500'000;
    scope.roll = roll;
    scope.jaw = head;
    return scope;
}

RigSample input_of(const DeviceSample& scope, std::uint32_t flags = 0) {
    RigSample input;
    input.camera = scope;
    input.flags = flags;
    return input;
}

void expect_at(const DeviceSample& scope, std::int32_t x, std::int32_t roll, std::int32_t head) {
    EXPECT_EQ(scope.handle[0], x);
    EXPECT_EQ(scope.handle[1], 2 * x);
    EXPECT_EQ(scope.handle[2], -1'500'000);
    EXPECT_EQ(scope.roll, roll);
    EXPECT_EQ(scope.jaw, head);
}

DeviceSample applied(ScopeHold& hold, const DeviceSample& scope, std::uint32_t flags = 0) {
    RigSample input = input_of(scope, flags);
    hold.apply(input);
    EXPECT_EQ(input.flags, flags);
    EXPECT_EQ(input.camera.present, scope.present);
    EXPECT_EQ(input.camera.buttons, scope.buttons);
    return input.camera;
}

TEST(ScopeHold, ChangesNothingWithoutAPause) {
    ScopeHold hold;
    for (const std::int32_t x : {0, 10, -70'000, 3})
        expect_at(applied(hold, scope_at(x, 5 * x, -x)), x, 5 * x, -x);
}

TEST(ScopeHold, KeepsThePoseInAPauseAndALossAndContinuesFromIt) {
    for (const std::uint32_t flag : {std::uint32_t{rig_paused}, std::uint32_t{rig_device_lost}}) {
        ScopeHold hold;
        applied(hold, scope_at(100, 7, -9));
        for (const std::int32_t x : {100, 4000, 90'000})
            expect_at(applied(hold, scope_at(x, x, x), flag), 100, 7, -9);
        expect_at(applied(hold, scope_at(90'000, 90'000, 90'000)), 100, 7, -9);
        expect_at(applied(hold, scope_at(90'030, 90'001, 90'002)), 130, 8, -7);
        // A second pause adds to the first.
        applied(hold, scope_at(-5'000, 0, 0), flag);
        expect_at(applied(hold, scope_at(-5'000, 0, 0)), 130, 8, -7);
        expect_at(applied(hold, scope_at(-4'990, 0, 0)), 140, 8, -7);
    }
}

TEST(ScopeHold, BeginsWhereItIsAskedTo) {
    ScopeHold hold;
    hold.begin_from(scope_at(600, 60, 6));
    expect_at(applied(hold, scope_at(0)), 600, 60, 6);
    expect_at(applied(hold, scope_at(1)), 601, 60, 6);
    ScopeHold paused;  // in its first tick
    paused.begin_from(scope_at(600, 60, 6));
    expect_at(applied(paused, scope_at(50), rig_paused), 600, 60, 6);
    expect_at(applied(paused, scope_at(80)), 600, 60, 6);
}

TEST(ScopeHold, APauseBeforeTheFirstTickKeepsTheFirstPose) {
    ScopeHold hold;
    expect_at(applied(hold, scope_at(40), rig_paused), 40, 0, 0);
    expect_at(applied(hold, scope_at(90), rig_paused), 40, 0, 0);
    expect_at(applied(hold, scope_at(90)), 40, 0, 0);
}

TEST(ScopeHold, CountsAtTheEndsOfTheirRangeDoNotWrap) {
    constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max(),
                           least = std::numeric_limits<std::int32_t>::min();
    ScopeHold hold;
    DeviceSample scope;
    scope.roll = most;
    applied(hold, scope);
    scope.roll = least;
    applied(hold, scope, rig_paused);
    EXPECT_EQ(applied(hold, scope).roll, -1);  // the offset is the largest that there is
    scope.roll = most;
    EXPECT_EQ(applied(hold, scope).roll, most);
}

/// A scope that the test moves, at the start of A1's.
class MovedScope : public Rig {
  public:
    explicit MovedScope(const Scene& scene)
        : start_(quantise(start_reading(scene.camera->trocar.shaft_length, scene.camera->start_insertion, 0),
                          {})) {}
    void read(std::uint32_t /*tick*/, RigSample& sample) override {
        sample.camera = start_;
        sample.camera.handle[0] += x.load();
    }
    void write_force(Hand /*hand*/, const Vector3& /*force*/) override {}
    bool has_force(Hand /*hand*/) const override { return false; }
    double damping(Hand /*hand*/) const override { return -1; }
    std::atomic<std::int32_t> x{0};

  private:
    DeviceSample start_;
};

template <typename Condition>
bool wait_until_true(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + 60s;
    while (std::chrono::steady_clock::now() < end) {
        if (condition()) return true;
        std::this_thread::sleep_for(2ms);
    }
    return false;
}

TEST(ScopeHold, TheCameraOfALiveAttemptStaysInAPause) {
    LiveRequest request;
    request.loaded = load_task_and_scene("A1");
    const auto rig = std::make_shared<MovedScope>(request.loaded.scene);
    request.rig = rig;
    const auto tap = std::make_shared<SampleTap>();
    request.tap = tap;
    LiveAttempt live(std::move(request));
    live.start();
    ASSERT_TRUE(wait_until_true([&] { return live.phase() == ui::AttemptPhase::running; }));
    const auto newest = [&] {
        TappedSample one;
        tap->newest.read(one);
        return one.sample;
    };
    const auto ticks_pass = [&](std::uint32_t ticks) {
        const std::uint32_t until = newest().tick + ticks;
        return wait_until_true([&] { return newest().tick >= until; });
    };
    const auto camera_x = [&] { return newest().camera.tip[0]; };
    ASSERT_TRUE(ticks_pass(50));
    const std::int32_t first = camera_x();
    rig->x = 30'000;  // 3 mm
    ASSERT_TRUE(ticks_pass(50));
    const std::int32_t moved = camera_x();
    ASSERT_GT(std::abs(moved - first), 1000);

    live.pause();
    ASSERT_TRUE(wait_until_true([&] { return live.phase() == ui::AttemptPhase::paused; }));
    ASSERT_TRUE(ticks_pass(20));
    rig->x = 130'000;
    ASSERT_TRUE(ticks_pass(200));
    EXPECT_EQ(camera_x(), moved);
    live.resume();
    ASSERT_TRUE(wait_until_true([&] { return live.phase() == ui::AttemptPhase::running; }));
    ASSERT_TRUE(ticks_pass(200));
    EXPECT_EQ(camera_x(), moved) << "the view jumped after the pause";
    rig->x = 100'000;
    ASSERT_TRUE(ticks_pass(50));
    EXPECT_NEAR(camera_x(), first, 20) << "it follows its device again";
    live.interrupt();
    live.wait();
}

}  // namespace
}  // namespace fulcrum::app
