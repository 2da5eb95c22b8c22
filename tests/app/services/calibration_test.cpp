// SPDX-License-Identifier: GPL-3.0-or-later
// Guided calibrations through the real daemon and fakes of the devices, and the commands that show them.
#include "app/services/calibration.h"

#include <gtest/gtest.h>

#include <QProcess>
#include <QSettings>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/services/devices.h"
#include "sim_core/controllers/joystick_mapping.h"
#include "sim_core/devices/device_table.h"
#include "sim_core/numerics/input_error.h"
#include "tests/app/program_path.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_sdl.h"
#include "tests/fakes/fake_touch.h"
#include "tests/support/built.h"
#include "tests/support/fake_trainer.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

using fulcrum::test::FakePage;
using fulcrum::test::until;
using fulcrum::test::Variable;

class Calibrated : public ::testing::Test {
  protected:
    Calibrated() { QSettings().clear(); }
    ~Calibrated() override {
        QSettings().clear();
        std::remove(joystick_file().c_str());
    }
    static std::string daemon_of_the_build() {
        const std::string program = program_path();
        return program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd";
    }
    static bool ready(GuidedCalibration& calibration) {
        return until([&] { return calibration.look().ready; });
    }
    Variable daemon{"FULCRUM_HAPTICD", daemon_of_the_build()};
};

TEST_F(Calibrated, WhatCanBeIsADeviceOfTheTableAndTheOthersNeedNone) {
    int kinds = 0;
    for (const DeviceRow& row : device_table) {
        if (can_calibrate(row.name)) {
            ++kinds;
        } else {
            EXPECT_FALSE(calibrates_hands(row.name)) << row.name;
            EXPECT_THROW(begin_calibration(row.name, 0, nullptr), InputError) << row.name;
        }
    }
    EXPECT_EQ(kinds, 6) << "a kind of calibration.cpp is none of the table";
}

TEST_F(Calibrated, AJoystickBecomesAnInstrumentOfTheHandThatWasCalibrated) {
    FakePage<fulcrum::test::FakeSdlPage> page("FAKE_SDL_PAGE");
    const Variable library("FULCRUM_LIBSDL2", fulcrum::test::fake_library("libSDL2.so"));
    fulcrum::test::FakeSdlController& stick = page->controller[0];
    stick.plugged = 1;
    stick.known = 0;
    EXPECT_EQ(with_calibration("joystick"), "joystick") << "not calibrated";
    {
        const auto calibration = begin_calibration("joystick", 0, nullptr);
        ASSERT_TRUE(ready(*calibration));
        calibration->next();
        for (const int axis : {3, 0, 1}) {  // pitch, yaw, insertion
            EXPECT_FALSE(calibration->look().ready);
            calibration->next();
            for (const int at : {-30000, 30000}) {
                stick.axis[axis] = at;
                const int seen = calibration->look().step;
                EXPECT_TRUE(until([&] {
                    calibration->look();
                    return calibration->look().ready == (at > 0) && calibration->look().step == seen;
                })) << axis;
                usleep(30000);
                calibration->look();
            }
            ASSERT_TRUE(ready(*calibration)) << axis;
            calibration->next();
        }
        for (int i = 0; i < 2; ++i) {
            EXPECT_TRUE(calibration->look().can_skip);
            calibration->skip();
        }
        const ui::CalibrationState end = calibration->look();
        EXPECT_FALSE(end.runs);
        EXPECT_TRUE(end.good) << end.result.words();
        EXPECT_NE(end.result.words().find("valid for this joystick until its sensors are moved"),
                  std::string::npos);
    }
    EXPECT_FALSE(calibrated_at("joystick").empty());
    const JoystickMapping mapping = read_joystick_mapping(joystick_file());
    EXPECT_TRUE(mapping.part[0].used());
    EXPECT_FALSE(mapping.part[1].used());
    EXPECT_EQ(mapping.part[0].motion[0].axis, 3);
    Devices devices("joystick");
    devices.open_now();
    EXPECT_EQ(devices.in_use().device_class, DeviceClass::tracked);
    EXPECT_EQ(devices.in_use().practice_only, ui::PracticeOnly::no);
    EXPECT_TRUE(devices.in_use().drives[0]);
    EXPECT_FALSE(devices.in_use().drives[1]) << "mouse and keyboard move the other hand";
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(Calibrated, ATouchIsCalibratedInItsInkwellAndTheReadingIsChecked) {
    FakePage<fulcrum::test::FakeTouchPage> page("FAKE_TOUCH_PAGE");
    const Variable library("FULCRUM_LIBHD", fulcrum::test::fake_library("libHD.so"));
    page->device[1].calibration = 0x5002;  // by hand: the stylus is not in the inkwell
    const auto calibration = begin_calibration("touch", 1, nullptr);
    ASSERT_TRUE(until(
        [&] { return calibration->look().seen.words() == "The device reports that it is not calibrated."; }));
    calibration->next();
    EXPECT_EQ(calibration->look().step, 1) << "it goes on only where the device is calibrated";
    page->device[1].calibration = 0x5001;
    ASSERT_TRUE(ready(*calibration));
    EXPECT_GE(page->device[1].updates, 1U);
    calibration->next();
    EXPECT_EQ(calibration->look().step, 2);
    ASSERT_TRUE(ready(*calibration)) << "it is held still";
    calibration->next();
    EXPECT_TRUE(calibration->look().good);
    EXPECT_FALSE(calibrated_at("touch").empty());
}

TEST_F(Calibrated, TheZeroOfATrainerIsStoredForItsHandAndUsedWhenItIsOpened) {
    if (!fulcrum::test::FakeTrainer::is_possible())
        GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    fulcrum::test::FakeTrainer trainer("LR");
    const Vector3 crooked(0.05, -0.03, 0.24);  // of the handle, from the pivot
    trainer.move('L', crooked);
    EXPECT_THROW(begin_calibration("mouse-keyboard", 0, nullptr), InputError);
    {
        const auto calibration = begin_calibration(trainer.specification(), 0, nullptr);
        ASSERT_TRUE(ready(*calibration));
        calibration->next();
        EXPECT_TRUE(calibration->look().good);
    }
    const std::string whole = with_calibration(trainer.specification());
    EXPECT_NE(whole.find(",zero-left="), std::string::npos) << whole;
    EXPECT_EQ(whole.find("zero-right"), std::string::npos) << whole;
    const DaemonClient client(hapticd_program(), whole);
    DevicePose pose;
    ASSERT_TRUE(until([&] {
        client.state().pose[0].read(pose);
        return pose.present == 1 && std::abs(pose.position[0]) < 1e-3;
    })) << pose.position[0];
    EXPECT_NEAR(pose.position[1], 0, 1e-3);
    EXPECT_NEAR(pose.position[2], crooked.norm(), 1e-3) << "as deep as it was";
    EXPECT_THROW(DaemonClient(hapticd_program(), trainer.specification() + ",zero-left=1;2"), InputError);
    EXPECT_THROW(DaemonClient(hapticd_program(), trainer.specification() + ",zero-left=1;2;x"), InputError);
    EXPECT_THROW(DaemonClient(hapticd_program(), trainer.specification() + ",zero-left=9999;2;3"),
                 InputError);
}

TEST_F(Calibrated, AWornControllerReachesItsEndsAgain) {
    FakePage<fulcrum::test::FakeSdlPage> page("FAKE_SDL_PAGE");
    const Variable library("FULCRUM_LIBSDL2", fulcrum::test::fake_library("libSDL2.so"));
    fulcrum::test::FakeSdlController& pad = page->controller[0];
    pad.plugged = 1;
    {
        const auto calibration = begin_calibration("controller", 0, nullptr);
        for (const int at : {-26000, 24000}) {
            const std::uint64_t seen = page->updates;
            for (int axis = 0; axis < 6; ++axis) pad.axis[axis] = axis < 4 ? at : std::abs(at);
            ASSERT_TRUE(until([&] { return page->updates > seen + 3; }));
            calibration->look();
        }
        ASSERT_TRUE(ready(*calibration));
        calibration->next();
        EXPECT_FALSE(calibration->look().ready) << "a stick is held";
        for (auto& axis : pad.axis) axis = 0;
        ASSERT_TRUE(ready(*calibration));
        calibration->next();
        EXPECT_TRUE(calibration->look().good);
    }
    const ControllerRanges ranges = controller_ranges();
    EXPECT_NEAR(ranges.stick[0][0][0], -26000 / 32767.0, 1e-3);
    const auto worn = GameController::open({}, ranges);
    pad.axis[0] = -26000;
    pad.axis[2] = 24000;
    pad.axis[4] = 26000;
    ASSERT_TRUE(until([&] { return worn->readings().stick[1][0] > 0.999; }));
    EXPECT_NEAR(worn->readings().stick[0][0], -1, 1e-3);
    EXPECT_NEAR(worn->readings().trigger[0], 1, 1e-3);
    EXPECT_NEAR(worn->readings().raw_stick[0][0], -26000 / 32767.0, 1e-9);
    QSettings().setValue("controller/ranges", "0 0 0 0 0 0 0 0 0 0");
    EXPECT_EQ(controller_ranges().trigger[0], 1) << "a range that nobody measured is not used";
}

class DevicesCommand : public Calibrated {
  protected:
    DevicesCommand() {
        std::ofstream(script)
            << R"({"format": "fulcrum-device-script", "title": "a hand", "force": {"peak": 3.3},
            "workspace": [-0.08, -0.06, -0.035, 0.08, 0.06, 0.035],
            "left": {"path": [{"t": 0, "position": [0, 0, 0]}, {"t": 0.3, "position": [0.02, 0, -0.01]}]}})";
    }
    int run(const QStringList& arguments) {
        QProcess process;
        process.start(QString::fromStdString(program_path()), arguments);
        process.closeWriteChannel();
        EXPECT_TRUE(process.waitForFinished(30000));
        output = process.readAllStandardOutput();
        error = process.readAllStandardError();
        return process.exitCode();
    }
    fulcrum::test::OwnFolder folder;
    const std::string script = (folder.path() / "hand.json").string();
    const Variable settings{"XDG_CONFIG_HOME", folder.path().string()};
    QByteArray output, error;
};

TEST_F(DevicesCommand, TestsAVirtualDeviceAsThePageDoes) {
    const QString device = QStringLiteral("virtual:") + QString::fromStdString(script);
    ASSERT_EQ(run({"devices", "--test", device, "--seconds", "1", "--force", "--json"}), 0)
        << error.toStdString();
    const auto document = nlohmann::json::parse(output.toStdString());
    EXPECT_EQ(document.at("device").at("title"), "a hand");
    EXPECT_EQ(document.at("device_class"), "haptic");
    EXPECT_EQ(document.at("device").at("workspace").at(0).at("most_m").at(2), 0.035);
    EXPECT_TRUE(document.at("device").at("workspace").at(1).is_null());
    EXPECT_EQ(document.at("device").at("clutch").at(0), true);
    EXPECT_EQ(document.at("needs_calibration"), false);
    EXPECT_GT(document.at("rate_hz").get<double>(), 100);
    EXPECT_GT(document.at("jitter_us").at("p99_9").get<double>(), 0);
    EXPECT_GT(document.at("force_rendered_n").get<double>(), 0.05);
    EXPECT_LE(document.at("force_rendered_n").get<double>(), 0.31);
    EXPECT_EQ(document.at("use").at("motion_scale"), 1.0);
    EXPECT_EQ(document.at("use").at("right"), 1);
    EXPECT_EQ(document.at("poses").at("left").at("present"), true);
    EXPECT_TRUE(document.at("frame_check").contains("left"));
    EXPECT_EQ(run({"devices", "--test", device, "--seconds", "1"}), 0);
    EXPECT_TRUE(output.contains("left: workspace 160 x 120 x 70 mm (across, up, deep)"))
        << output.toStdString();
    EXPECT_TRUE(output.contains("0 mm to the left")) << output.toStdString();
    EXPECT_EQ(run({"devices", "--test", "virtual:/nowhere.json"}), 2);
    EXPECT_TRUE(error.contains("/nowhere.json")) << error.toStdString();
}

TEST_F(DevicesCommand, ListsCalibrationAndRulesAndRefusesToCalibrateWhatNeedsNone) {
    ASSERT_EQ(run({"devices", "--json"}), 0);
    bool controller = false;
    const auto document = nlohmann::json::parse(output.toStdString());
    for (const auto& device : document.at("devices")) {
        const std::string kind = device.at("kind");
        EXPECT_EQ(device.at("calibration").is_null(), !can_calibrate(kind)) << kind;
        if (kind == "controller") controller = device.at("udev_rules").size() == 1;
    }
    EXPECT_TRUE(controller);
    EXPECT_EQ(run({"devices", "--calibrate", "space-mouse"}), 2);
    EXPECT_TRUE(error.contains("nothing to calibrate")) << error.toStdString();
    EXPECT_EQ(run({"devices", "--hand", "left"}), 2);
    EXPECT_EQ(run({"devices", "--calibrate", "touch", "--hand", "foot"}), 2);
}

TEST_F(DevicesCommand, CalibratesInTheTerminalAndStoresNothingWhereTheInputEnds) {
    FakePage<fulcrum::test::FakeTouchPage> page("FAKE_TOUCH_PAGE");
    const Variable library("FULCRUM_LIBHD", fulcrum::test::fake_library("libHD.so"));
    EXPECT_EQ(run({"devices", "--calibrate", "touch"}), 1);
    EXPECT_TRUE(output.contains("1/2  Put the stylus into the inkwell")) << output.toStdString();
    EXPECT_TRUE(output.contains("nothing is stored")) << output.toStdString();
    QProcess process;
    process.start(QString::fromStdString(program_path()), {"devices", "--calibrate", "touch", "--json"});
    for (int i = 0; i < 200 && !process.waitForFinished(50); ++i) process.write("\n");
    ASSERT_EQ(process.state(), QProcess::NotRunning);
    EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    const auto result = nlohmann::json::parse(process.readAllStandardOutput().toStdString());
    EXPECT_EQ(result.at("stored"), true);
    EXPECT_EQ(result.at("steps_done"), 2);
    EXPECT_TRUE(result.at("hand").is_null());
    EXPECT_EQ(run({"devices"}), 0);
    EXPECT_TRUE(output.contains("calibrated: 20")) << output.toStdString();
}

}  // namespace
}  // namespace fulcrum::app::program_test
