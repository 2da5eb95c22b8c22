// SPDX-License-Identifier: Apache-2.0
// Operators through a model of a device do what the device lets a person do, and no more.
#include "assessment/operators/device_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/instrument/mouse_mapping.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

/// Wants both hands 30 mm aside at once, the jaws half closed.
class Impatient : public ObservingRig {
  public:
    explicit Impatient(const Scene& scene, const Vector3& aside = Vector3(0.03, 0, 0)) {
        for (const InstrumentSpec& spec : scene.instruments) {
            DeviceReading wish;
            wish.handle = aside - (spec.trocar.shaft_length - spec.start_insertion) * Vector3::UnitZ();
            wish.jaw = 0.5 * spec.jaw_opening;
            DeviceSample& hand = wish_.hand[static_cast<std::size_t>(spec.hand)];
            hand = quantise(wish, hand);
        }
        if (scene.camera)
            wish_.camera = quantise(
                start_reading(scene.camera->trocar.shaft_length, scene.camera->start_insertion, 0), {});
    }
    void observe(const WorldSnapshot&, const TaskDisplay&) noexcept override {}
    void read(std::uint32_t, RigSample& sample) override { sample = wish_; }
    void write_force(Hand, const Vector3&) override {}
    bool has_force(Hand) const override { return true; }
    double damping(Hand) const override { return -1; }
    RigSample& wish() { return wish_; }

  private:
    RigSample wish_;
};

TEST(MouseModel, MovesOneHandAtATimeAndFeelsNothing) {
    const Scene scene = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    const auto mouse =
        through_device(std::make_unique<Impatient>(scene), DeviceClass::mouse_keyboard, scene, 1);
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

TEST(DeviceModels, LeaveAFreeHandAsItIsAndKnowNoUnknownDevice) {
    const Scene scene = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    for (const DeviceClass free : {DeviceClass::haptic, DeviceClass::synthetic}) {
        auto hands = std::make_unique<Impatient>(scene);
        const ObservingRig* same = hands.get();
        EXPECT_EQ(through_device(std::move(hands), free, scene, 1).get(), same);
    }
    EXPECT_FALSE(has_device_model(DeviceClass::external));
    EXPECT_THROW(through_device(std::make_unique<Impatient>(scene), DeviceClass::external, scene, 1),
                 InputError);
}

double across(const DeviceSample& sample) {
    return device_length_unit * std::hypot(sample.handle[0], sample.handle[1]);
}
double outside(const DeviceSample& sample) {
    return device_length_unit * std::hypot(sample.handle[0], sample.handle[1], sample.handle[2]);
}

TEST(TrackedModel, ComesLateWithNoiseAndMeasuresNoFingers) {
    const Scene scene = load_scene(test::source_path("assets/scenes/b1_bowel.json"));
    auto hands = std::make_unique<Impatient>(scene);
    Impatient& impatient = *hands;
    for (DeviceSample& hand : impatient.wish().hand) {
        hand.jaw = 0;
        hand.grip = 1234;
    }
    const auto tracked = through_device(std::move(hands), DeviceClass::tracked, scene, 7);
    EXPECT_FALSE(tracked->has_force(Hand::left));
    RigSample sample;
    std::uint32_t arrived = 0;
    double sum = 0, squares = 0;
    constexpr int rest = 4000;
    for (std::uint32_t tick = 0; tick < 1000 + rest; ++tick) {
        tracked->read(tick, sample);
        if (arrived == 0 && across(sample.hand[0]) > 0.001) arrived = tick;
        if (tick < 1000) continue;
        const double x = device_length_unit * sample.hand[0].handle[0];
        sum += x;
        squares += (x - 0.03) * (x - 0.03);
    }
    EXPECT_GE(arrived, 17U) << "two frames of 120 Hz";
    EXPECT_LE(arrived, 40U);
    EXPECT_NEAR(sum / rest, 0.03, 5e-6) << "it arrives";
    const double noise = std::sqrt(squares / rest);
    EXPECT_GT(noise, 5e-6) << "the pose is not exact";
    EXPECT_LT(noise, 50e-6) << "but smoothed";
    EXPECT_NEAR(device_force_unit * sample.hand[0].grip, scene.instruments[0].grip_force, 1e-3);
}

// B3's experts never held a band with the shears, and so never divided one, before shears counted as jaws.
TEST(DeviceModels, ClosedShearsPressAndScissorsCut) {
    for (const DeviceClass kind : {DeviceClass::tracked, DeviceClass::mouse_keyboard}) {
        for (const auto& [name, presses] : {std::pair{"b3_bands.json", true}, {"b2_plane.json", false}}) {
            const Scene scene = load_scene(test::source_path("assets/scenes/" + std::string(name)));
            auto hands = std::make_unique<Impatient>(scene, Vector3::Zero());
            for (DeviceSample& hand : hands->wish().hand) hand.jaw = 0;
            const auto rig = through_device(std::move(hands), kind, scene, 7);
            RigSample sample;
            bool pressed = false;  // with the mouse one hand after the other
            for (std::uint32_t tick = 0; tick < 1500; ++tick) {
                rig->read(tick, sample);
                pressed = pressed || sample.hand[1].grip > 0;
            }
            EXPECT_EQ(pressed, presses) << name << ' ' << row_of(device_classes, kind).name;
        }
    }
}

TEST(TrackedModel, IsTheSameForTheSameAttemptOnly) {
    const Scene scene = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    const auto pose_after = [&](std::uint64_t attempt) {
        const auto rig =
            through_device(std::make_unique<Impatient>(scene), DeviceClass::tracked, scene, attempt);
        RigSample sample;
        for (std::uint32_t tick = 0; tick < 200; ++tick) rig->read(tick, sample);
        return sample.hand[1].handle[0];
    };
    EXPECT_EQ(pose_after(3), pose_after(3));
    EXPECT_NE(pose_after(3), pose_after(4));
}

TEST(ControllerModel, MovesBothHandsNoFasterThanItsSticksAndEitherAcrossOrAlong) {
    const Scene scene = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    const auto pad = through_device(std::make_unique<Impatient>(scene, Vector3(0.03, 0.02, 0.03)),
                                    DeviceClass::controller, scene, 5);
    EXPECT_FALSE(pad->has_force(Hand::right));
    RigSample sample;
    double was_across[hand_count] = {0, 0}, was_outside[hand_count] = {0, 0};
    int together = 0;
    double fastest = 0;
    bool never_both = true;
    for (std::uint32_t tick = 0; tick < 4000; ++tick) {
        pad->read(tick, sample);
        bool moves[hand_count];
        for (int h = 0; h < hand_count; ++h) {
            const double a = across(sample.hand[h]), o = outside(sample.hand[h]);
            const double sideways = tick == 0 ? 0 : std::abs(a - was_across[h]),
                         inwards = tick == 0 ? 0 : std::abs(o - was_outside[h]);
            moves[h] = sideways > 1e-5;
            fastest = std::max({fastest, sideways * 1000, inwards * 1000});
            // Along the shaft the part across it shrinks in proportion; the low-passes mix for a moment.
            if (inwards > 4e-5 && sideways > 1.5 * inwards * a / o + 4e-5) never_both = false;
            was_across[h] = a;
            was_outside[h] = o;
        }
        together += moves[0] && moves[1] ? 1 : 0;
    }
    EXPECT_GT(together, 50) << "a thumb for each hand";
    EXPECT_TRUE(never_both);
    EXPECT_GT(fastest, 0.05);
    EXPECT_LT(fastest, 0.13) << "m/s";
    for (int h = 0; h < hand_count; ++h) {
        const DeviceSample& hand = sample.hand[h];
        EXPECT_NEAR(hand.handle[0] * device_length_unit, 0.03, 1e-3) << h;
        EXPECT_NEAR(hand.handle[1] * device_length_unit, 0.02, 1e-3) << h;
    }
}

TEST(ControllerModel, TriggerClosesThenPresses) {
    const Scene scene = load_scene(test::source_path("assets/scenes/b1_bowel.json"));
    const InstrumentSpec& spec = scene.instruments[0];
    for (const double grip : {0.0, 2.0, 4.0}) {
        auto hands = std::make_unique<Impatient>(scene, Vector3::Zero());
        for (DeviceSample& hand : hands->wish().hand) {
            hand.jaw = static_cast<std::int32_t>(std::lround(0.5 * spec.jaw_opening / device_angle_unit));
            hand.grip = static_cast<std::int32_t>(std::lround(grip / device_force_unit));
        }
        const auto pad = through_device(std::move(hands), DeviceClass::controller, scene, 5);
        RigSample sample;
        for (std::uint32_t tick = 0; tick < 1000; ++tick) pad->read(tick, sample);
        const double step = spec.grip_force / (0.3 * 255);
        EXPECT_NEAR(device_force_unit * sample.hand[0].grip, grip, 0.5 * step + 1e-3) << grip;
        EXPECT_NEAR(device_angle_unit * sample.hand[0].jaw, grip > 0 ? 0 : 0.5 * spec.jaw_opening,
                    0.01 * spec.jaw_opening)
            << grip;
    }
}

}  // namespace
}  // namespace fulcrum
