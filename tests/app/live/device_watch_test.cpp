// SPDX-License-Identifier: GPL-3.0-or-later
// When a device counts as lost, when as back, and when the trainee may resume.
#include "app/live/device_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "assessment/attempt/engine.h"
#include "database/scoring/loaded_task.h"
#include "sim_core/haptics/loop.h"
#include "sim_core/instrument/instrument.h"
#include "ui/language/language.h"
#include "ui/style/text.h"

namespace fulcrum::app {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Two hands and a scope with readings set by the test.
struct Bench {
    DeviceWatch watch;
    DeviceReading reading[3];
    DeviceSample last[3];
    std::uint32_t tick = 0;
    bool paused = false;

    Bench() {
        for (DeviceReading& one : reading) one.handle = Vector3(0, 0, -0.15);
    }
    std::uint32_t step(bool resume = false) {
        RigSample sample;
        sample.tick = ++tick;
        for (int i = 0; i < 3; ++i) last[i] = quantise(reading[i], last[i]);
        sample.hand[0] = last[0];
        sample.hand[1] = last[1];
        sample.camera = last[2];
        return watch.tick(sample, paused, resume);
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i) step();
    }
    void lose_by_silence() {
        steps(10);
        reading[0].present = false;
        steps(60);
        reading[0].present = true;
    }
};

TEST(DeviceWatch, LosesADeviceAtOnceWhenItsReadingIsNotANumberOrJumps) {
    for (int device = 0; device < 3; ++device) {
        for (const double reading :
             {nan, std::numeric_limits<double>::infinity(), 1.0}) {  // the last: a jump of a metre
            Bench bench;
            bench.steps(10);
            EXPECT_FALSE(bench.watch.lost());
            bench.reading[device].handle.x() = reading;
            EXPECT_EQ(bench.step(), std::uint32_t{rig_device_lost});
            EXPECT_EQ(bench.watch.trouble(), DeviceTrouble::impossible_reading);
            EXPECT_EQ(bench.watch.culprit(), device);
        }
    }
}

TEST(DeviceWatch, LosesASilentDeviceAfterMoreThanFiftyTicks) {
    Bench bench;
    bench.steps(10);
    bench.reading[1].present = false;
    for (int i = 0; i < 50; ++i) ASSERT_EQ(bench.step(), 0U) << i;
    EXPECT_EQ(bench.step(), std::uint32_t{rig_device_lost});
    EXPECT_EQ(bench.watch.trouble(), DeviceTrouble::silent);
    EXPECT_EQ(bench.watch.culprit(), 1);
    Bench blink;
    blink.steps(10);
    for (int round = 0; round < 20; ++round) {
        blink.reading[1].present = round % 2 == 0;
        blink.steps(40);
        ASSERT_FALSE(blink.watch.lost());
    }
}

TEST(DeviceWatch, ResumesOnlyWithinFiveMillimetresAndTenDegrees) {
    struct Case {
        double millimetres, degrees;
        bool in_place;
    };
    for (const Case& c : {Case{0, 0, true}, Case{4.9, 0, true}, Case{5.1, 0, false}, Case{0, 9.9, true},
                          Case{0, 10.1, false}, Case{0, -9.9, true}, Case{4, 9, true}, Case{6, 3, false}}) {
        Bench bench;
        bench.lose_by_silence();
        ASSERT_TRUE(bench.watch.lost());
        bench.reading[0].handle.z() -= c.millimetres * 1e-3;  // along the shaft: changes no angle
        bench.reading[0].roll += c.degrees * 3.14159265358979 / 180;
        EXPECT_EQ(bench.step(true), std::uint32_t{rig_device_lost})
            << "back only after enough usable readings";
        bench.steps(120);
        ASSERT_TRUE(bench.watch.back());
        EXPECT_NEAR(bench.watch.alignment(Hand::left).distance, c.millimetres * 1e-3, 2e-7);
        EXPECT_NEAR(bench.watch.alignment(Hand::left).angle, std::abs(c.degrees) * 3.14159265358979 / 180,
                    2e-6);
        EXPECT_EQ(bench.watch.in_place(), c.in_place) << c.millimetres << " mm, " << c.degrees << " degrees";
        EXPECT_EQ(bench.step(true), c.in_place ? 0U : std::uint32_t{rig_device_lost});
        EXPECT_EQ(bench.watch.went_on(), c.in_place);
        EXPECT_EQ(bench.watch.lost(), !c.in_place);
    }
}

TEST(DeviceWatch, CountsTheShaftsDirectionAsAngle) {
    Bench bench;
    for (DeviceReading& one : bench.reading)
        one.handle = Vector3(0, 0, -0.02);  // so short that 4 mm across are more than 10 degrees
    bench.lose_by_silence();
    bench.reading[1].handle.x() = 4e-3;
    bench.steps(120);
    EXPECT_NEAR(bench.watch.alignment(Hand::right).angle, std::atan2(4.0, 20.0), 1e-4);
    EXPECT_FALSE(bench.watch.in_place());
}

TEST(DeviceWatch, RequiresTheSamePoseWhateverTheClutchOffset) {
    Bench bench;
    bench.steps(10);
    bench.paused = true;
    bench.steps(10);
    bench.reading[0].handle.x() += 0.03;  // moved during the pause: the clutch takes the new pose
    bench.steps(10);
    bench.paused = false;
    bench.steps(10);
    EXPECT_FALSE(bench.watch.lost());
    EXPECT_LT(bench.watch.alignment(Hand::left).distance, 1e-7);
    bench.lose_by_silence();
    bench.steps(120);
    EXPECT_TRUE(bench.watch.in_place()) << "the clutch offset is not a misalignment";
    bench.reading[0].handle.x() -= 0.03;
    bench.steps(5);
    EXPECT_NEAR(bench.watch.alignment(Hand::left).distance, 0.03, 2e-7);
}

TEST(DeviceWatch, AttemptFromAMomentHasItsInstrumentsWhereTheyWereThen) {
    DeviceReading there;
    there.handle = Vector3(0.03, 0.01, -0.12);
    there.roll = 0.4;
    const DeviceSample held = quantise(there, {});
    Bench bench;
    bench.watch.begin_from(held, held);
    bench.lose_by_silence();
    bench.steps(120);
    ASSERT_TRUE(bench.watch.back());
    const HandAlignment& left = bench.watch.alignment(Hand::left);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(left.device.handle[i], held.handle[i]) << i;
    EXPECT_EQ(left.device.roll, held.roll);
    EXPECT_EQ(left.distance, 0);
    EXPECT_TRUE(bench.watch.in_place());
    bench.reading[0].handle.x() += 0.02;
    bench.step();
    EXPECT_EQ(left.device.handle[0], held.handle[0] + 200000) << "from there it follows the device";
    EXPECT_NEAR(left.distance, 0.02, 2e-7);
}

// The ghosts of a lost device are drawn where its instruments will be.
TEST(DeviceWatch, HasTheClutchOfTheLoopInAnAttemptFromAMoment) {
    const LoadedTask loaded = load_task_and_scene("A2");
    AttemptEngine engine(loaded.scene, loaded.task, 7);
    engine.begin_here();
    DeviceWatch watch;
    watch.begin_from(engine.loop().held(Hand::left), engine.loop().held(Hand::right));
    RigSample input;
    for (DeviceSample& hand : input.hand) hand.handle[2] = -1'200'000;  // wherever the device is
    for (int i = 0; i < 10; ++i) {
        input.tick = engine.next_tick();
        for (DeviceSample& hand : input.hand) hand.handle[0] += 20'000;  // 2 mm
        watch.tick(input, false, false);
        const TickSample sample = engine.tick(input).sample;
        for (int h = 0; h < hand_count; ++h) {
            const auto hand = static_cast<Hand>(h);
            const InstrumentSpec& spec = *loaded.scene.instrument(hand);
            const Vector3 tip =
                tool_pose(make_instrument(spec, loaded.scene.tick_period()), watch.alignment(hand).device)
                    .tip;
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(sample.hand[h].tip[axis] * sample_length_unit, tip[axis], 1e-6) << i;
        }
    }
}

TEST(DeviceWatch, ExpiresAfterAMinuteAndNotBefore) {
    Bench bench;
    bench.steps(10);
    bench.reading[0].present = false;
    bench.steps(51);
    ASSERT_TRUE(bench.watch.lost());
    bench.steps(59999);
    EXPECT_FALSE(bench.watch.expired());
    bench.step();
    EXPECT_TRUE(bench.watch.expired());
}

TEST(DeviceWatch, SaysInTheReadersLanguageWhichDeviceIsLost) {
    EXPECT_NE(loss_of(DeviceTrouble::silent, 0).words().find("The left hand's device does not answer."),
              std::string::npos);
    ui::use_language(ui::Language::german);
    const std::string jump = ui::sentence_text(loss_of(DeviceTrouble::impossible_reading, 2)).toStdString();
    const std::string silence = ui::sentence_text(loss_of(DeviceTrouble::silent, 1)).toStdString();
    ui::use_language(ui::Language::english);
    EXPECT_EQ(jump.find("Das Gerät der Optik lieferte einen unmöglichen Messwert"), 0U) << jump;
    EXPECT_EQ(silence.find("Das Gerät der rechten Hand antwortet nicht. Die Kraft wurde auf null gesenkt"),
              0U)
        << silence;
}

}  // namespace
}  // namespace fulcrum::app
