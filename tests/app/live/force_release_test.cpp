// SPDX-License-Identifier: GPL-3.0-or-later
// However an attempt ends while something is pressed, the force falls at the slew limit.
#include "app/live/force_release.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "app/live/live_attempt.h"
#include "app/live/real_time.h"
#include "assessment/operators/cheats.h"
#include "tests/support/allocation_count.h"
#include "tests/support/force_device.h"

namespace fulcrum::app::program_test {
namespace {

using namespace std::chrono_literals;

/// Keeps what it is given.
class ReleasedHands : public Rig {
  public:
    ReleasedHands() {
        for (auto& one : forces) one.reserve(2000);
        times.reserve(2000);
        torques.reserve(2000);
    }
    void read(std::uint32_t /*tick*/, RigSample& /*sample*/) override {}
    void write_force(Hand hand, const Vector3& force) override {
        forces[static_cast<std::size_t>(hand)].push_back(force);
        if (hand == Hand::left) times.push_back(now_ns());
    }
    void write_torque(Hand hand, double torque) override {
        if (hand == Hand::right) torques.push_back(torque);
    }
    bool has_force(Hand /*hand*/) const override { return true; }
    double damping(Hand /*hand*/) const override { return 1; }
    std::optional<ForceOutput> force_output(Hand /*hand*/) const override {
        ForceOutput output = fulcrum::test::ideal_device();
        output.slew = slew;
        return output;
    }

    double slew = std::numeric_limits<double>::infinity();
    std::array<std::vector<Vector3>, hand_count> forces;
    std::vector<double> torques;
    std::vector<std::int64_t> times;
};

TEST(ForceRelease, FallsToNothingWithinTheSlewLimit) {
    Scene scene;  // 0.3 N each ms
    TickOutput last;
    last.device_force[0] = Vector3(1, -2, 2);
    last.device_force[1] = Vector3(0, 0, 0.5);
    last.device_torque[1] = 0.02;
    ReleasedHands rig;
    const std::int64_t begun = now_ns();
    EXPECT_EQ(fulcrum::test::allocations_in([&] { release_forces(rig, last, scene); }), 0U);
    for (const Hand hand : {Hand::left, Hand::right}) {
        const std::vector<Vector3>& sent = rig.forces[static_cast<std::size_t>(hand)];
        Vector3 before = last.device_force[static_cast<int>(hand)];
        EXPECT_GE(sent.size(), 10U);
        EXPECT_LE(sent.size(), 12U);
        for (const Vector3& force : sent) {
            EXPECT_LE((force - before).norm(), 0.3 * (1 + 1e-9));
            EXPECT_LE(force.norm(), before.norm() + 1e-12);
            EXPECT_LT(force.cross(last.device_force[static_cast<int>(hand)]).norm(), 1e-12);
            before = force;
        }
        EXPECT_EQ(before, Vector3(Vector3::Zero()));
    }
    double torque = 0.02;
    for (const double next : rig.torques) {
        EXPECT_LE(std::abs(next - torque), 0.003 * (1 + 1e-9));
        torque = next;
    }
    EXPECT_EQ(torque, 0);
    std::int64_t before = begun;
    for (const std::int64_t time : rig.times) {
        EXPECT_GE(time - before, 1'000'000) << "not several at once";
        before = time;
    }
}

TEST(ForceRelease, OfNothingIsOneZeroAndOfAVerySlowSlewLimitASecond) {
    Scene scene;
    ReleasedHands rig;
    release_forces(rig, TickOutput{}, scene);
    ASSERT_EQ(rig.forces[0].size(), 1U);
    EXPECT_EQ(rig.forces[0].front(), Vector3(Vector3::Zero()));
    TickOutput last;
    last.device_force[0] = Vector3(3, 0, 0);
    EXPECT_EQ(periods_to_release(rig, last, scene), 10);
    scene.slew_limit = 0.01;
    EXPECT_EQ(periods_to_release(rig, last, scene), scene.tick_rate);
    last.device_force[0] = Vector3::Zero();
    last.device_torque[0] = 0.02;
    scene.slew_limit = 300;
    EXPECT_EQ(periods_to_release(rig, last, scene), 7) << "3 N mm each ms";
    last.device_torque[0] = 0;
    last.device_force[0] = Vector3(3, 0, 0);
    rig.slew = 150;
    EXPECT_EQ(periods_to_release(rig, last, scene), 20) << "the device's own limit";
}

/// An operator who presses too hard, with a device with force in the left hand; that hand rests as soon as
/// it feels 2 N.
class RestsOnceItPresses : public ObservingRig {
  public:
    explicit RestsOnceItPresses(std::unique_ptr<ObservingRig> rig) : rig_(std::move(rig)) {}
    void read(std::uint32_t tick, RigSample& sample) override {
        if (!presses.load())
            rig_->read(tick, last_);
        else
            last_.flags = 0;
        sample = last_;
    }
    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        rig_->observe(world, display);
    }
    void write_force(Hand hand, const Vector3& force) override {
        if (hand != Hand::left) return;
        newest[count++ % newest.size()] = force;
        if (force.norm() > 2) presses = true;
    }
    bool has_force(Hand hand) const override { return hand == Hand::left; }
    double damping(Hand hand) const override { return has_force(hand) ? 1 : -1; }
    std::optional<ForceOutput> force_output(Hand hand) const override {
        if (!has_force(hand)) return std::nullopt;
        return fulcrum::test::ideal_device();
    }

    std::atomic<bool> presses{false};
    std::array<Vector3, 64> newest;  // haptic thread
    std::size_t count = 0;

  private:
    std::unique_ptr<ObservingRig> rig_;
    RigSample last_;
};

TEST(ForceRelease, OfAnAttemptThatEndsWhileSomethingIsPressed) {
    LiveRequest request;
    request.loaded = load_task_and_scene("A2");
    const Cheat* heavy = nullptr;
    for (const Cheat& one : cheats())
        if (std::string(one.name) == "heavy") heavy = &one;
    ASSERT_NE(heavy, nullptr);
    const double step = request.loaded.scene.slew_limit * request.loaded.scene.tick_period();
    const auto rig = std::make_shared<RestsOnceItPresses>(
        make_cheat(*heavy, request.loaded.task, request.loaded.scene, 2001));
    request.rig = rig;
    LiveAttempt live(std::move(request));
    live.start();
    const auto end = std::chrono::steady_clock::now() + 240s;  // on a machine that has much else to do
    while (!rig->presses.load() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(2ms);
    ASSERT_TRUE(rig->presses.load());
    live.interrupt();
    live.wait();
    ASSERT_GE(rig->count, rig->newest.size());
    std::vector<Vector3> sent;
    for (std::size_t i = 0; i < rig->newest.size(); ++i)
        sent.push_back(rig->newest[(rig->count + i) % rig->newest.size()]);
    EXPECT_EQ(sent.back(), Vector3(Vector3::Zero()));
    for (std::size_t i = sent.size() - 4; i < sent.size(); ++i)
        EXPECT_LE((sent[i] - sent[i - 1]).norm(), step + 1e-9) << i;
    EXPECT_GT(sent[sent.size() - 4].norm(), 0.5 * step) << "something was pressed until then";
}

}  // namespace
}  // namespace fulcrum::app::program_test
