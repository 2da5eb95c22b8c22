// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/device_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>

#include "sim_core/instrument/mouse_mapping.h"
#include "tests/app/live/rig_on_pages.h"
#include "tests/support/allocation_count.h"

namespace fulcrum::app::program_test {
namespace {

TEST(DeviceRig, IsAbsentWhileTheOverseerGivesNoSignOfItself) {
    OnPages at;
    const auto present_after = [&at](int ticks) {
        for (int i = 0; i < ticks; ++i) {
            at.publish();
            at.read();
        }
        return at.sample.hand[0].present == 1 && at.sample.hand[1].present == 1;
    };
    EXPECT_TRUE(present_after(200));
    at.overseen = false;
    EXPECT_TRUE(present_after(50));
    EXPECT_FALSE(present_after(60)) << "although the device is read";
    at.overseen = true;
    EXPECT_TRUE(present_after(1));
}

TEST(DeviceRig, BeginsAtTheStartOfTheSceneAndFollowsTheDeviceInTheFrameOfTheHandle) {
    OnPages at;
    at.pose[0].position[0] = 0.05;
    at.publish();
    at.read();
    const InstrumentSpec& spec = *at.scene.instrument(Hand::left);
    const Vector3 start = start_reading(spec.trocar.shaft_length, spec.start_insertion, 0).handle;
    EXPECT_LT((at.handle(0) - start).norm(), 1e-6);
    at.pose[0].position[0] += 0.01;
    at.pose[0].position[1] += 0.02;
    at.pose[0].position[2] -= 0.03;  // away from the person
    at.publish();
    at.read();
    EXPECT_LT((at.handle(0) - start - Vector3(-0.01, 0.02, 0.03)).norm(), 1e-6);
    EXPECT_EQ(at.sample.camera.handle[0], 77) << "the device has no scope: the other rig moves it";
    EXPECT_FALSE(at.rig->has_force(Hand::right));
    EXPECT_EQ(at.rig->force_output(Hand::left)->scale, 0.4);
}

TEST(DeviceRig, ForceOnTheDeviceDoesTheWorkThatItDoesOnTheHandle) {
    OnPages at;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    const Trocar trocar = make_trocar(at.scene.instrument(Hand::left)->trocar);
    for (int i = 0; i < 100; ++i) {
        const Vector3 force(any(random), any(random), any(random)),
            moved(any(random), any(random), any(random));
        at.rig->write_force(Hand::left, force);
        ForceCommand sent;
        ASSERT_TRUE(at.command->command[0].read(sent));
        const Vector3 on_device(sent.force[0], sent.force[1], sent.force[2]);
        const Vector3 on_handle = trocar.rotation * DeviceRig::turned(moved);
        EXPECT_NEAR(on_device.dot(moved), force.dot(on_handle), 1e-12);
    }
}

TEST(DeviceRig, WithAnotherScaleOfTheMovementTheWorkIsTheSameOnBothSides) {
    for (const double motion : {0.5, 2.0}) {
        OnPages at;
        SlotUse use;
        use.motion = motion;
        at.facts.force[0]->continuous = 0.88;
        at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                             at.others, use, 0.4);
        at.publish();
        at.read();
        const Vector3 before = at.handle(0);
        at.pose[0].position[1] += 0.02;
        at.publish();
        at.read();
        const Vector3 moved = at.handle(0) - before;
        EXPECT_LT((moved - Vector3(0, 0.02 * motion, 0)).norm(), 1e-6);
        const Vector3 force(0.3, -0.2, 0.7);
        at.rig->write_force(Hand::left, force);
        ForceCommand sent;
        ASSERT_TRUE(at.command->command[0].read(sent));
        const Trocar trocar = make_trocar(at.scene.instrument(Hand::left)->trocar);
        EXPECT_NEAR(sent.force[1] * 0.02, force.dot(trocar.rotation * moved), 1e-7);
        // Seen from the instrument, damping and limits are those of the device's motors.
        const ForceOutput seen = *at.rig->force_output(Hand::left);
        EXPECT_NEAR(seen.damping, 0.5 / (motion * motion), 1e-12);
        EXPECT_NEAR(seen.peak * motion, 3.3, 1e-12);
        EXPECT_TRUE(is_usable(seen));
    }
}

TEST(DeviceRig, PartsOfTheDeviceMoveWhatTheyAreAssignedTo) {
    OnPages at;
    at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                         at.others, SlotUse{1, -1, 0, 1}, 1);
    at.pose[1].buttons = 0;
    at.publish();
    at.read();
    const Vector3 before = at.handle(0);
    at.pose[1].position[1] += 0.01;
    at.publish();
    at.read();
    EXPECT_NEAR((at.handle(0) - before).norm(), 0.01, 1e-6) << "the right part moves the left instrument";
    EXPECT_EQ(at.sample.hand[1].handle[0], 77) << "mouse and keyboard";
    EXPECT_NE(at.sample.camera.handle[2], 0) << "the left part moves the scope";
    EXPECT_FALSE(at.rig->has_force(Hand::left)) << "the right part renders none";
}

TEST(DeviceRig, ThePedalIsTheButtonThatAPersonChose) {
    OnPages at;
    const auto pedals = [&at](int pedal) {
        SlotUse use;
        use.right = -1;  // mouse and keyboard
        use.pedal = pedal;
        at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                             at.others, use, 1);
        at.publish();
        at.read();
        const auto pressed = [&at](int hand) { return (at.sample.hand[hand].buttons & button_energy) != 0; };
        return std::pair(pressed(0), pressed(1));
    };
    at.pose[0].buttons = button_energy;
    at.pose[1].buttons = 0;
    EXPECT_EQ(pedals(-2), std::pair(true, false)) << "each hand has its own";
    EXPECT_EQ(pedals(-1), std::pair(false, false)) << "keys only";
    EXPECT_EQ(pedals(0), std::pair(true, true)) << "one pedal for both hands";
    EXPECT_EQ(pedals(1), std::pair(false, false)) << "the button of the left part is none";
    at.pose[1].buttons = button_energy;
    EXPECT_EQ(pedals(1), std::pair(true, true));
    at.pose[1].present = 0;
    EXPECT_EQ(pedals(1), std::pair(false, false)) << "it does not answer";
    EXPECT_EQ(pedals(2), std::pair(false, false)) << "the device has no third part";
}

// The page keeps the last reading of a device process that has ended.
TEST(DeviceRig, APedalThatDoesNotAnswerIsNotPressed) {
    OnPages at;
    // Mouse and keyboard for both hands and the scope.
    at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                         at.others, SlotUse{-1, -1, -1, 1, 0}, 1);
    const auto pressed_after = [&at](int ticks, bool published) {
        for (int i = 0; i < ticks; ++i) {
            if (published) at.publish();
            at.read();
        }
        const bool left = (at.sample.hand[0].buttons & button_energy) != 0;
        EXPECT_EQ(left, (at.sample.hand[1].buttons & button_energy) != 0);
        return left;
    };
    EXPECT_FALSE(pressed_after(1, false)) << "before the first reading";
    at.pose[0].buttons = button_energy;
    EXPECT_TRUE(pressed_after(1, true));
    EXPECT_TRUE(pressed_after(5, false)) << "two clocks of 1 kHz";
    EXPECT_FALSE(pressed_after(5, false));
    EXPECT_TRUE(pressed_after(1, true)) << "it answers again";
    at.overseen = false;
    EXPECT_TRUE(pressed_after(50, true));
    EXPECT_FALSE(pressed_after(100, true)) << "nobody would switch the device off";
    at.overseen = true;
    EXPECT_TRUE(pressed_after(1, true));
}

TEST(DeviceRig, WhileTheClutchIsPressedTheInstrumentStaysAndThenFollowsFromThere) {
    OnPages at;
    at.publish();
    at.read();
    at.pose[0].position[0] = 0.02;
    at.publish();
    at.read();
    const Vector3 before = at.handle(0);
    at.pose[0].buttons = button_clutch;
    at.publish();
    at.read();
    EXPECT_EQ(at.sample.hand[0].buttons & button_clutch, button_clutch)
        << "an input, so that replays have it";
    at.pose[0].position[0] = -0.25;  // further than a reading may jump
    at.pose[0].roll = 1;
    at.publish();
    at.read();
    EXPECT_EQ(at.handle(0), before);
    EXPECT_EQ(at.sample.hand[0].roll, 0);
    // Not a number, or no answer, does not end it.
    at.pose[0].position[0] = std::numeric_limits<double>::quiet_NaN();
    at.pose[0].buttons = 0;
    at.publish();
    at.read();
    EXPECT_EQ(at.sample.hand[0].faulty, 1);
    at.pose[0].position[0] = -0.25;
    at.pose[0].present = 0;
    at.publish();
    at.read();
    EXPECT_EQ(at.handle(0), before);
    at.pose[0].present = 1;
    at.publish();
    at.read();
    EXPECT_EQ(at.handle(0), before) << "released: it goes on from there";
    EXPECT_EQ(at.sample.hand[0].faulty, 0);
    at.pose[0].position[0] = -0.24;
    at.pose[0].roll = 1.25;
    at.publish();
    at.read();
    EXPECT_NEAR((at.handle(0) - before - DeviceRig::turned(Vector3(0.01, 0, 0))).norm(), 0, 2e-7);
    EXPECT_NEAR(device_angle_unit * at.sample.hand[0].roll, 0.25, 2e-6);
}

TEST(DeviceRig, TheButtonForEnergyIsTheClutchWhereItIsNotThePedal) {
    OnPages at;
    at.pose[0].buttons = button_energy;
    for (const int pedal : {-2, -1, 0, 1}) {
        SlotUse use;
        use.pedal = pedal;
        at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                             at.others, use, 1);
        at.publish();
        at.read();
        const bool clutched = (at.sample.hand[0].buttons & button_clutch) != 0;
        EXPECT_EQ(clutched, pedal == -1 || pedal == 1) << pedal;
        EXPECT_FALSE(clutched && (at.sample.hand[0].buttons & button_energy) != 0) << "one use at a time";
    }
}

TEST(DeviceRig, ADeviceThatSendsNothingNewDidNotAnswer) {
    OnPages at;
    at.read();
    EXPECT_EQ(at.sample.hand[0].present, 0) << "before the first reading";
    at.publish();
    for (int i = 0; i < 6; ++i) {
        at.read();
        EXPECT_EQ(at.sample.hand[0].present, 1) << i;
    }
    at.read();
    EXPECT_EQ(at.sample.hand[0].present, 0);
    at.publish();
    at.read();
    EXPECT_EQ(at.sample.hand[0].present, 1);
    at.pose[0].present = 0;
    at.publish();
    at.read();
    EXPECT_EQ(at.sample.hand[0].present, 0);
}

TEST(DeviceRig, UntilADeviceAnswersItsInstrumentIsWhereItBegins) {
    OnPages at;
    at.facts.slot[2] = true;
    at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                         at.others, SlotUse{}, 1);
    const auto same_handle = [](const DeviceSample& a, const DeviceSample& b) {
        return std::equal(std::begin(a.handle), std::end(a.handle), std::begin(b.handle));
    };
    const CameraSpec& scope = *at.scene.camera;
    DeviceSample begins[device_slots];
    for (int h = 0; h < hand_count; ++h) {
        const InstrumentSpec& spec = *at.scene.instrument(static_cast<Hand>(h));
        begins[h] = quantise(
            start_reading(spec.trocar.shaft_length, spec.start_insertion, spec.jaw_opening * open_jaw_share),
            {});
    }
    begins[scope_slot] = quantise(start_reading(scope.trocar.shaft_length, scope.start_insertion, 0), {});
    const DeviceSample* const part[device_slots] = {&at.sample.hand[0], &at.sample.hand[1],
                                                    &at.sample.camera};
    at.read();
    for (int i = 0; i < device_slots; ++i) {
        EXPECT_EQ(part[i]->present, 0) << i;
        EXPECT_TRUE(same_handle(*part[i], begins[i])) << i << ": " << part[i]->handle[2];
        EXPECT_EQ(part[i]->jaw, begins[i].jaw) << i;
    }
    for (DevicePose& one : at.pose) one.position[1] = 0.05;  // wherever the device is
    at.publish();
    at.read();
    for (int i = 0; i < device_slots; ++i) {
        EXPECT_EQ(part[i]->present, 1) << i;
        EXPECT_EQ(part[i]->faulty, 0) << i;
        EXPECT_TRUE(same_handle(*part[i], begins[i])) << i << ": no jump";
    }
}

TEST(DeviceRig, ReadingsThatAreNotNumbersAndJumpsAreFaultyAndKeepThePose) {
    for (int fault = 0; fault < 4; ++fault) {
        OnPages at;
        at.publish();
        at.read();
        const Vector3 before = at.handle(0);
        if (fault == 0) at.pose[0].position[1] = NAN;
        if (fault == 1) at.pose[0].position[1] = 5;
        if (fault == 2) at.pose[0].roll = INFINITY;
        if (fault == 3) at.pose[0].jaw = NAN;
        at.publish();
        at.read();
        EXPECT_EQ(at.sample.hand[0].faulty, 1) << fault;
        EXPECT_EQ(at.handle(0), before);
    }
}

TEST(DeviceRig, ADeviceThatWasAwayForLongMayBeTakenUpAnywhere) {
    for (const bool not_a_number : {false, true})
        for (const int ticks : {10, 50, 51, 60}) {
            OnPages at;
            at.publish();
            at.read();
            const Vector3 before = at.handle(0);
            for (int i = 0; i < ticks; ++i) {
                at.pose[0].present = not_a_number ? 1 : 0;
                at.pose[0].position[0] = not_a_number ? NAN : 0.25;
                at.publish();
                at.read();
                EXPECT_EQ(at.handle(0), before);
            }
            at.pose[0].present = 1;
            at.pose[0].position[0] = 0.25;  // further than a reading may jump
            at.publish();
            at.read();
            const bool lost = ticks > 50;
            EXPECT_EQ(at.sample.hand[0].faulty, lost ? 0 : 1) << ticks;
            const Vector3 moved = DeviceRig::turned(Vector3(lost ? 0.25 : 0, 0, 0));
            EXPECT_LT((at.handle(0) - before - moved).norm(), 1e-6) << ticks;
            EXPECT_EQ(at.sample.hand[1].faulty, 0);
            if (!lost) continue;
            at.pose[0].position[0] = 0;
            at.publish();
            at.read();
            EXPECT_EQ(at.sample.hand[0].faulty, 1) << "from here on it cannot jump";
        }
}

TEST(DeviceRig, JawsCloseByTheirAngleOrByTheButton) {
    OnPages at;
    at.publish();
    at.read();
    EXPECT_GT(at.sample.hand[0].jaw, 0);
    EXPECT_EQ(at.sample.hand[0].grip, 0);
    at.pose[0].buttons = button_primary;
    at.pose[1].jaw = 0;
    at.publish();
    at.read();
    for (const DeviceSample& hand : at.sample.hand) {
        EXPECT_EQ(hand.jaw, 0);
        EXPECT_GT(hand.grip, 0);
        EXPECT_EQ(hand.buttons & button_primary, button_primary);
    }
}

// A tracker may have no jaws, a Falcon no roll, no device with a scope a camera head.
TEST(DeviceRig, KeysWorkWithADeviceForWhatItCannotDo) {
    OnPages at;
    at.facts.slot[2] = true;
    at.rig = std::make_unique<DeviceRig>(nullptr, *at.state.get(), *at.command.get(), at.facts, at.scene,
                                         at.others, SlotUse{}, 1);
    at.pose[0].roll = 0.25;
    at.others->roll = 400'000;
    at.publish();
    at.read();
    EXPECT_EQ(at.sample.hand[0].roll, 0) << "from where both began";
    EXPECT_GT(at.sample.hand[0].jaw, 0);
    at.pose[0].roll = 0.35;
    at.others->roll = 600'000;
    at.others->head = -300'000;
    at.others->keys = button_energy | button_exchange | button_primary;
    at.publish();
    at.read();
    EXPECT_EQ(at.sample.hand[0].buttons, button_energy | button_exchange | button_primary);
    EXPECT_EQ(at.sample.hand[0].jaw, 0);
    EXPECT_GT(at.sample.hand[0].grip, 0);
    EXPECT_EQ(at.sample.hand[0].roll, 300'000) << "0.1 by the device, 0.2 by keys";
    EXPECT_EQ(at.sample.camera.jaw, -300'000);
    at.others->roll = std::numeric_limits<std::int32_t>::max();
    at.publish();
    at.read();
    EXPECT_GT(at.sample.hand[0].roll, 2'000'000'000) << "no overflow";
    at.others->keys = button_none;
    at.publish();
    at.read();
    EXPECT_EQ(at.sample.hand[0].buttons, button_none);
}

// As after *Practise from here*: the other rig has the jaws closed from its first tick on.
TEST(DeviceRig, JawsThatHeldAtTheStartAreTheDevicesOnceItHasClosedItsOwn) {
    OnPages at;
    const auto with_jaws_at = [&at](double share) {
        at.pose[0].jaw = share;
        at.publish();
        at.read();
        return at.sample.hand[0];
    };
    at.others->keys = button_primary;
    for (int i = 0; i < 3; ++i) {
        const DeviceSample holds = with_jaws_at(1);
        EXPECT_EQ(holds.jaw, 0) << "although those of the device are open";
        EXPECT_GT(holds.grip, 0);
        EXPECT_EQ(holds.buttons, button_primary);
    }
    EXPECT_EQ(with_jaws_at(0).jaw, 0);
    const DeviceSample opened = with_jaws_at(1);
    EXPECT_GT(opened.jaw, 0);
    EXPECT_EQ(opened.grip, 0);
    EXPECT_EQ(opened.buttons, button_none);
    at.others->keys = button_primary | button_energy;
    EXPECT_EQ(with_jaws_at(1).buttons, button_energy) << "the other keys work";
    at.others->keys = button_none;
    EXPECT_GT(with_jaws_at(1).jaw, 0);
    at.others->keys = button_primary;
    EXPECT_EQ(with_jaws_at(1).jaw, 0) << "the key is pressed again";
    EXPECT_EQ(with_jaws_at(0).jaw, 0);
    EXPECT_EQ(with_jaws_at(1).jaw, 0) << "and closes them whatever the device does";
}

TEST(DeviceRig, TicksAllocateNothing) {
    OnPages at;
    at.publish();
    at.read();
    EXPECT_EQ(fulcrum::test::allocations_in([&] {
                  for (int i = 0; i < 1000; ++i) {
                      at.publish();
                      at.read();
                      at.rig->write_force(Hand::left, Vector3(1, 0, 0));
                      at.rig->write_torque(Hand::left, 0.1);
                  }
              }),
              0U);
}

}  // namespace
}  // namespace fulcrum::app::program_test
