// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QtGlobal>
#include <atomic>
#include <cmath>
#include <thread>

#include "assessment/task/asked_hand.h"
#include "tests/support/allocation_count.h"
#include "tests/support/support.h"
#include "ui/theatre/mouse_keyboard_input.h"

namespace fulcrum::ui {
namespace {

Scene scene() {
    return load_scene(fulcrum::test::source_path("assets/scenes/a2_targets.json"));
}

/// Lets the rig reach its target: one second of ticks.
RigSample settle(Rig& rig, std::uint32_t ticks = 1000) {
    RigSample sample;
    for (std::uint32_t tick = 1; tick <= ticks; ++tick) rig.read(tick, sample);
    return sample;
}

Vector3 tip(const Scene& scene, Hand hand, const RigSample& sample) {
    const InstrumentModel model = make_instrument(*scene.instrument(hand), 1e-3);
    return tool_pose(model, sample.hand[static_cast<int>(hand)]).tip;
}

TEST(MouseKeyboard, StartsWhereTheSceneSays) {
    const Scene targets = scene();
    MouseKeyboardInput input(targets);
    const RigSample sample = settle(*input.rig(), 1);
    for (const InstrumentSpec& spec : targets.instruments) {
        const DeviceSample& hand = sample.hand[static_cast<int>(spec.hand)];
        EXPECT_EQ(hand.present, 1);
        EXPECT_EQ(hand.faulty, 0);
        EXPECT_NEAR(hand.handle[2] * device_length_unit, -(spec.trocar.shaft_length - spec.start_insertion),
                    2e-7);
    }
}

// A2 asks for the left hand first; the mouse moved the right one.
TEST(MouseKeyboard, BeginsWithTheHandOfTheFirstGoal) {
    const Scene targets = scene();
    MouseKeyboardInput input(targets);
    const TaskDefinition a2 = load_task(fulcrum::test::source_path("assets/tasks/A2.json"));
    ASSERT_EQ(asked_hand(a2.goals.front()), Hand::left);
    input.take_hand(*asked_hand(a2.goals.front()));
    EXPECT_EQ(input.active_hand(), Hand::left);
    const TaskDefinition b1 = load_task(fulcrum::test::source_path("assets/tasks/B1.json"));
    EXPECT_FALSE(asked_hand(b1.goals.front()).has_value());
}

Vector3 lens(const Scene& scene, const RigSample& sample) {
    return scope_pose(make_scope(*scene.camera), sample.camera).position;
}

TEST(MouseKeyboard, MouseMovesTheScopeWhereItIsTheOnlyInstrument) {
    const Scene cups = load_scene(fulcrum::test::source_path("assets/scenes/a1_camera.json"));
    MouseKeyboardInput input(cups);
    const RigSample first = settle(*input.rig(), 1);
    const Quaternion view = scope_pose(make_scope(*cups.camera), first.camera).orientation;
    input.move_mouse({40, 0});
    input.advance(0);
    const RigSample moved = settle(*input.rig());
    const Vector3 step = view.conjugate() * (lens(cups, moved) - lens(cups, first));
    EXPECT_LT(step.x(), -1e-3);  // the lens goes the other way
    EXPECT_LT(std::abs(step.y()), 0.1 * std::abs(step.x()));
    input.turn_wheel(2);
    input.advance(0);
    const RigSample deeper = settle(*input.rig());
    EXPECT_NEAR((lens(cups, deeper) - lens(cups, moved)).norm(), 2 * metres_per_notch, 1e-5);
    input.move_mouse({50, 0}, MouseKeyboardInput::MouseUse::turn);
    input.move_mouse({-25, 0}, MouseKeyboardInput::MouseUse::turn_head);
    input.advance(0);
    const RigSample turned = settle(*input.rig());
    EXPECT_NEAR(turned.camera.roll * device_angle_unit, 0.4, 1e-4);
    EXPECT_NEAR(turned.camera.jaw * device_angle_unit, 0.2, 1e-4);
    EXPECT_LT((lens(cups, turned) - lens(cups, deeper)).norm(), 1e-6);
    for (const DeviceSample& hand : turned.hand) EXPECT_EQ(hand.handle[2], first.hand[0].handle[2]);
    EXPECT_TRUE(input.help_lines().join(QString()).contains(QStringLiteral("camera head")));
}

TEST(MouseKeyboard, KeysTurnTheCameraHeadInEveryScene) {
    for (const char* name : {"a1_camera", "a2_targets"}) {
        const Scene any =
            load_scene(fulcrum::test::source_path(std::string("assets/scenes/") + name + ".json"));
        MouseKeyboardInput input(any);
        EXPECT_TRUE(input.press_key(Qt::Key_Comma));
        input.advance(0.5);
        EXPECT_NEAR(settle(*input.rig()).camera.jaw * device_angle_unit, 0.9, 1e-3) << name;
        input.release_key(Qt::Key_Comma);
        EXPECT_TRUE(input.press_key(Qt::Key_Period));
        input.advance(0.5);
        EXPECT_NEAR(settle(*input.rig()).camera.jaw * device_angle_unit, 0, 1e-3) << name;
        input.release_key(Qt::Key_Period);
    }
}

TEST(MouseKeyboard, AKeyThatIsLetGoIsLetGoWhateverShiftMakesOfItsName) {
    const Scene targets = scene();
    MouseKeyboardInput input(targets);
    const auto turned = [&input] {
        const double before = input.targets().camera.jaw;
        input.advance(0.1);
        return input.targets().camera.jaw != before;
    };
    constexpr quint32 period = 60, comma = 59;
    EXPECT_TRUE(input.press_key(Qt::Key_Period, period));
    EXPECT_TRUE(turned());
    input.release_key(Qt::Key_Greater, period);
    EXPECT_FALSE(turned());
    EXPECT_FALSE(input.press_key(Qt::Key_Greater, period)) << "no key of this map";
    EXPECT_TRUE(input.press_key(Qt::Key_Comma, comma));
    input.release_key(Qt::Key_Period, period);
    EXPECT_TRUE(turned()) << "the other key is still held";
    input.release_all();
    EXPECT_FALSE(turned());
    EXPECT_TRUE(input.press_key(Qt::Key_Comma));
    input.release_key(Qt::Key_Comma, comma);
    EXPECT_FALSE(turned()) << "by its name, where no code is known";
}

TEST(MouseKeyboard, PedalAndExchangeAreButtonsOfTheActiveHandWhileHeld) {
    const Scene bands = load_scene(fulcrum::test::source_path("assets/scenes/b3_bands.json"));
    MouseKeyboardInput input(bands);
    ASSERT_EQ(input.active_hand(), Hand::right);
    EXPECT_TRUE(input.press_key(Qt::Key_B));
    input.advance(0);
    RigSample sample = settle(*input.rig(), 1);
    EXPECT_EQ(sample.hand[1].buttons & (button_energy | button_exchange), button_energy);
    EXPECT_EQ(sample.hand[0].buttons & button_energy, 0);
    input.release_key(Qt::Key_B);
    EXPECT_TRUE(input.press_key(Qt::Key_T));
    input.advance(0);
    sample = settle(*input.rig(), 1);
    EXPECT_EQ(sample.hand[1].buttons & (button_energy | button_exchange), button_exchange);
    input.release_all();
    input.advance(0);
    EXPECT_EQ(settle(*input.rig(), 1).hand[1].buttons & (button_energy | button_exchange), 0);
}

TEST(MouseKeyboard, TheTipMovesOppositeToTheMouse) {
    const Scene targets = scene();
    MouseKeyboardInput input(targets);
    DeviceSample start;
    start.handle[2] = -static_cast<std::int32_t>(
        (targets.camera->trocar.shaft_length - targets.camera->start_insertion) / device_length_unit);
    const Quaternion view = scope_pose(make_scope(*targets.camera), start).orientation;
    input.set_camera(view);
    const Vector3 before = tip(targets, Hand::right, settle(*input.rig()));
    input.move_mouse({80, 0});
    input.advance(0);
    const Vector3 moved = view.inverse() * (tip(targets, Hand::right, settle(*input.rig())) - before);
    EXPECT_LT(moved.x(), -0.003);
    EXPECT_GT(std::abs(moved.x()), std::abs(moved.y()));
}

TEST(MouseKeyboard, TheWheelMovesTheTipAlongItsShaftAndNotTheOtherHand) {
    const Scene targets = scene();
    MouseKeyboardInput input(targets);
    const RigSample before = settle(*input.rig());
    input.turn_wheel(5);
    input.advance(0);
    const RigSample after = settle(*input.rig());
    EXPECT_NEAR((tip(targets, Hand::right, after) - tip(targets, Hand::right, before)).norm(), 0.02, 1e-4);
    EXPECT_NEAR((tip(targets, Hand::left, after) - tip(targets, Hand::left, before)).norm(), 0, 1e-6);
    input.switch_hand();
    EXPECT_EQ(input.active_hand(), Hand::left);
}

TEST(MouseKeyboard, KeysMoveBothHandsAtOnceAndJawsLatch) {
    const Scene targets = scene();
    MouseKeyboardInput input(targets);
    const RigSample before = settle(*input.rig());
    for (const int key : {Qt::Key_A, Qt::Key_L}) EXPECT_TRUE(input.press_key(key));
    EXPECT_FALSE(input.press_key(Qt::Key_Z));
    input.advance(0.1);
    EXPECT_TRUE(input.press_key(Qt::Key_X));
    input.advance(0);
    RigSample after = settle(*input.rig());
    EXPECT_GT((tip(targets, Hand::left, after) - tip(targets, Hand::left, before)).norm(), 1e-3);
    EXPECT_GT((tip(targets, Hand::right, after) - tip(targets, Hand::right, before)).norm(), 1e-3);
    EXPECT_TRUE(input.jaws_closed(Hand::left));
    EXPECT_FALSE(input.jaws_closed(Hand::right));
    EXPECT_GT(after.hand[0].grip, 0);
    EXPECT_EQ(after.hand[1].grip, 0);
    input.release_all();
    input.advance(1.0);
    const RigSample still = settle(*input.rig());
    EXPECT_NEAR((tip(targets, Hand::left, still) - tip(targets, Hand::left, after)).norm(), 0, 1e-6);
}

TEST(MouseKeyboard, FollowsSmoothlyWithoutJumpsOrAllocations) {
    const Scene targets = scene();
    MouseKeyboardInput input(targets);
    std::shared_ptr<Rig> rig = input.rig();
    RigSample sample;
    rig->read(0, sample);
    input.move_mouse({400, -300});
    input.turn_wheel(-8);
    input.advance(0);
    const std::size_t before = fulcrum::test::allocation_count();
    Vector3 last = tip(targets, Hand::right, sample);
    double fastest = 0;
    for (std::uint32_t tick = 1; tick < 500; ++tick) {
        rig->read(tick, sample);
        const Vector3 now = tip(targets, Hand::right, sample);
        fastest = std::max(fastest, (now - last).norm() / 1e-3);
        last = now;
        EXPECT_EQ(sample.hand[1].faulty, 0);
    }
    EXPECT_EQ(fulcrum::test::allocation_count(), before);
    EXPECT_LT(fastest, 4.0);
}

TEST(MouseKeyboard, NeverLeavesTheTrocarsCone) {
    const Scene targets = scene();
    MouseKeyboardInput input(targets);
    for (int i = 0; i < 200; ++i) input.move_mouse({997.0 * std::cos(i), 911.0 * std::sin(1.7 * i)});
    input.turn_wheel(-1000);
    input.advance(0);
    const Vector3 out = input.targets().hand[1].handle;
    EXPECT_TRUE(out.allFinite());
    EXPECT_LT(out.z(), 0);
    const double shaft = targets.instrument(Hand::right)->trocar.shaft_length;
    EXPECT_LE(out.norm(), shaft);
    input.turn_wheel(1000);
    EXPECT_GE(input.targets().hand[1].handle.norm(), handle_clearance);
}

TEST(MouseKeyboard, ReportsALostDevice) {
    const Scene targets = scene();
    MouseKeyboardInput input(targets);
    input.set_connected(false);
    EXPECT_EQ(settle(*input.rig(), 5).hand[0].present, 0);
    input.set_connected(true);
    EXPECT_EQ(settle(*input.rig(), 5).hand[0].present, 1);
}

TEST(MouseKeyboard, HandsOverBetweenThreads) {
    const Scene targets = scene();
    MouseKeyboardInput input(targets);
    std::shared_ptr<Rig> rig = input.rig();
    std::atomic<bool> stop{false};
    std::atomic<std::uint32_t> faults{0}, ticks{0};
    std::thread haptic([&] {
        RigSample sample;
        while (!stop.load()) {
            rig->read(ticks.fetch_add(1), sample);
            if (sample.hand[1].faulty != 0) faults.fetch_add(1);
        }
    });
    for (int i = 0; i < 2000 || ticks.load() < 1000; ++i) {
        input.move_mouse({std::sin(i * 0.1) * 5, std::cos(i * 0.1) * 5});
        input.advance(0.001);
    }
    stop.store(true);
    haptic.join();
    EXPECT_EQ(faults.load(), 0U);
}

}  // namespace
}  // namespace fulcrum::ui
