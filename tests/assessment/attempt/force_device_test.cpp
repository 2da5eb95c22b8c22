// SPDX-License-Identifier: Apache-2.0
// Attempts with a device that renders force: stored values make a replay send the same forces, the reduction
// by Eq. 8 is an event, and the record of the tissue is that of an attempt without a device.
#include <gtest/gtest.h>

#include <algorithm>

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
    void read(std::uint32_t tick, RigSample& sample) override { rig_->read(tick, sample); }
    void write_force(Hand hand, const Vector3& force) override {
        if (hand == Hand::left) largest = std::max(largest, force.norm());
    }
    bool has_force(Hand hand) const override { return hand == Hand::left && device_.has_value(); }
    double damping(Hand hand) const override { return has_force(hand) ? device_->damping : -1; }
    std::optional<ForceOutput> force_output(Hand hand) const override {
        return hand == Hand::left ? device_ : std::nullopt;
    }
    double largest = 0;  ///< N

  private:
    std::unique_ptr<ObservingRig> rig_;
    std::optional<ForceOutput> device_;
};

struct PerformedWithDevice {
    TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    MemorySink sink;
    RunOutcome outcome;
    double largest = 0;

    explicit PerformedWithDevice(const std::optional<ForceOutput>& device) {
        AttemptEngine engine(scene, task, 3);
        WithDevice rig(make_operator(OperatorLevel::novice, task, scene, 3), device);
        outcome = run_headless(engine, rig, sink, [](double time) { return time < 15; });
        sink.record.devices = devices_of(rig);
        largest = rig.largest;
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
