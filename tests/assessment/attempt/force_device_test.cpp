// SPDX-License-Identifier: Apache-2.0
// Attempts with a device that renders force: stored values make a replay send the same forces, the reduction
// by Eq. 8 is an event, and the record of the tissue is that of an attempt without a device.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assessment/attempt/memory_sink.h"
#include "assessment/operators/operator.h"
#include "tests/support/force_device.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

/// An expert whose left hand holds a device with force.
class WithDevice : public ObservingRig {
  public:
    explicit WithDevice(std::unique_ptr<ObservingRig> rig, std::optional<ForceOutput> device)
        : rig_(std::move(rig)), device_(device) {}
    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        rig_->observe(world, display);
    }
    void read(std::uint32_t tick, RigSample& sample) override {
        rig_->read(tick, sample);
        clutched_ = tick >= clutch_from && tick < clutch_to;
        if (clutched_) sample.hand[0].buttons |= button_clutch;
    }
    void write_force(Hand hand, const Vector3& force) override {
        if (hand != Hand::left) return;
        largest = std::max(largest, force.norm());
        if (clutched_) with_clutch = force.norm();
    }
    bool has_force(Hand hand) const override { return hand == Hand::left && device_.has_value(); }
    double damping(Hand hand) const override { return has_force(hand) ? device_->damping : -1; }
    std::optional<ForceOutput> force_output(Hand hand) const override {
        return hand == Hand::left ? device_ : std::nullopt;
    }
    double largest = 0;      ///< N
    double with_clutch = 0;  ///< N, the last one
    std::uint32_t clutch_from = 0, clutch_to = 0;

  private:
    bool clutched_ = false;
    std::unique_ptr<ObservingRig> rig_;
    std::optional<ForceOutput> device_;
};

struct PerformedWithDevice {
    TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    MemorySink sink;
    RunOutcome outcome;
    double largest = 0;

    double with_clutch = 0;

    explicit PerformedWithDevice(const std::optional<ForceOutput>& device, std::uint32_t clutch_from = 0,
                                 std::uint32_t clutch_to = 0) {
        AttemptEngine engine(scene, task, 3);
        WithDevice rig(make_operator(OperatorLevel::novice, task, scene, 3), device);
        rig.clutch_from = clutch_from;
        rig.clutch_to = clutch_to;
        outcome = run_headless(engine, rig, sink, [](double time) { return time < 15; });
        sink.record.devices = devices_of(rig);
        largest = rig.largest;
        with_clutch = rig.with_clutch;
    }
};

TEST(ForceDevice, ReplaysWithTheStoredDeviceAndNotWithAnother) {
    ForceOutput device = test::desk_device();
    device.scale = 0.4;
    PerformedWithDevice performed(device);
    ASSERT_GT(performed.largest, 0.05) << "something was touched";
    const auto replayed = [&](const ForceDevices& devices) {
        AttemptRecord record = performed.sink.record;
        record.devices = devices;
        AttemptEngine engine(performed.scene, performed.task, 3);
        return replay_record(engine, record);
    };
    const ReplayOutcome same = replayed(performed.sink.record.devices);
    EXPECT_TRUE(same.identical) << same.first_divergence_s;
    ForceDevices other = performed.sink.record.devices;
    other[0]->scale = 0.5;
    EXPECT_FALSE(replayed(other).identical) << "the force scale is part of what was sent";
    EXPECT_TRUE(replayed({}).identical)
        << "without a device the channel is not compared: older records hold the tip's";
    const auto limited = [](const std::vector<Event>& events) {
        return std::count_if(events.begin(), events.end(),
                             [](const Event& e) { return e.kind == EventKind::stability_limited; });
    };
    EXPECT_GT(limited(performed.sink.record.events), 0)
        << "a target of 600 N/m at the lever is too stiff for b 0.5";
    EXPECT_EQ(limited(same.events), limited(performed.sink.record.events));
}

TEST(ForceDevice, WhileTheClutchIsPressedNothingIsFeltAndAReplayHasItToo) {
    const PerformedWithDevice without(test::desk_device());
    // From a tick with force on.
    std::uint32_t from = 0;
    for (const TickSample& sample : without.sink.record.samples) {
        const auto& sent = sample.hand[0].device_force;
        if (std::abs(sent[0]) + std::abs(sent[1]) + std::abs(sent[2]) < 50) continue;
        from = sample.tick;
        break;
    }
    ASSERT_GT(from, 0U) << "something was felt";
    const PerformedWithDevice performed(test::desk_device(), from, from + 100);
    EXPECT_EQ(performed.with_clutch, 0) << "within 100 ms";
    EXPECT_EQ(performed.outcome.state_hash, without.outcome.state_hash) << "what is touched stays as it was";
    AttemptEngine engine(performed.scene, performed.task, 3);
    const ReplayOutcome replayed = replay_record(engine, performed.sink.record);
    EXPECT_TRUE(replayed.identical) << replayed.first_divergence_s;
}

TEST(ForceDevice, LeavesStateAndTissueAsTheyAreWithoutOne) {
    const PerformedWithDevice with(test::desk_device()), without(std::nullopt);
    EXPECT_EQ(with.outcome.state_hash, without.outcome.state_hash);
    const std::vector<TickSample>&a = with.sink.record.samples, &b = without.sink.record.samples;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_TRUE(std::equal(a[i].hand[0].force, a[i].hand[0].force + 3, b[i].hand[0].force)) << i;
        ASSERT_TRUE(std::equal(a[i].hand[0].torque, a[i].hand[0].torque + 3, b[i].hand[0].torque)) << i;
        for (const std::int32_t count : b[i].hand[0].device_force) ASSERT_EQ(count, 0) << i;
    }
}

}  // namespace
}  // namespace fulcrum
