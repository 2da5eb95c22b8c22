// SPDX-License-Identifier: Apache-2.0
// Operators through a model of mouse and keyboard do what the window lets a person do, and no more.
#include "assessment/operators/device_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/numerics/input_error.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

/// Wants both hands 30 mm aside at once, the jaws half closed.
class Impatient : public ObservingRig {
  public:
    explicit Impatient(const Scene& scene) {
        for (const InstrumentSpec& spec : scene.instruments) {
            DeviceReading wish;
            wish.handle = Vector3(0.03, 0, -(spec.trocar.shaft_length - spec.start_insertion));
            wish.jaw = 0.5 * spec.jaw_opening;
            DeviceSample& hand = wish_.hand[static_cast<std::size_t>(spec.hand)];
            hand = quantise(wish, hand);
        }
    }
    void observe(const WorldSnapshot&, const TaskDisplay&) noexcept override {}
    void read(std::uint32_t, RigSample& sample) override { sample = wish_; }
    void write_force(Hand, const Vector3&) override {}
    bool has_force(Hand) const override { return true; }
    double damping(Hand) const override { return -1; }

  private:
    RigSample wish_;
};

TEST(MouseModel, MovesOneHandAtATimeAndFeelsNothing) {
    const Scene scene = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    const auto mouse = through_device(std::make_unique<Impatient>(scene), DeviceClass::mouse_keyboard, scene);
    EXPECT_FALSE(mouse->has_force(Hand::left));
    RigSample sample;
    std::int32_t before[hand_count] = {0, 0}, start[hand_count] = {0, 0};
    int together = 0, moved[hand_count] = {0, 0};
    for (std::uint32_t tick = 0; tick < 3000; ++tick) {
        mouse->read(tick, sample);
        bool moves[hand_count];
        for (int h = 0; h < hand_count; ++h) {
            if (tick == 0) start[h] = before[h] = sample.hand[h].handle[0];
            moves[h] = std::abs(sample.hand[h].handle[0] - before[h]) > 100;  // 10 um a tick
            moved[h] += moves[h] ? 1 : 0;
            before[h] = sample.hand[h].handle[0];
        }
        together += moves[0] && moves[1] ? 1 : 0;
    }
    EXPECT_EQ(together, 0);
    for (int h = 0; h < hand_count; ++h) {
        EXPECT_GT(moved[h], 5);
        EXPECT_NEAR((sample.hand[h].handle[0] - start[h]) * device_length_unit, 0.03, 1e-3) << h;
    }
}

TEST(MouseModel, LeavesAFreeHandAsItIsAndKnowsNoOtherDevice) {
    const Scene scene = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    auto hands = std::make_unique<Impatient>(scene);
    const ObservingRig* same = hands.get();
    EXPECT_EQ(through_device(std::move(hands), DeviceClass::haptic, scene).get(), same);
    for (const DeviceClass unknown : {DeviceClass::controller, DeviceClass::tracked}) {
        EXPECT_FALSE(has_device_model(unknown));
        EXPECT_THROW(through_device(std::make_unique<Impatient>(scene), unknown, scene), InputError);
    }
}

}  // namespace
}  // namespace fulcrum
