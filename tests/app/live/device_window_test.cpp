// SPDX-License-Identifier: GPL-3.0-or-later
// The window with a device that fulcrum-hapticd drives: attempts are made with it, and its end pauses them.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <QComboBox>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "tests/app/daemon_processes.h"
#include "tests/app/program_path.h"
#include "tests/app/window_fixture.h"
#include "tests/support/own_folder.h"
#include "ui/review/replay_panel.h"

namespace fulcrum::app::program_test {
namespace {

using ui::AttemptPhase;
using ui::window_test::find;
using ui::window_test::keep_picture;
using ui::window_test::sees;
using ui::window_test::wait_for;

/// Before the services are made.
struct ScriptedDevice {
    explicit ScriptedDevice(bool both_hands = true) {
        std::ofstream(script) << R"({"format": "fulcrum-device-script", "title": "a scripted hand",
            "force": {"damping": 0.5, "peak": 3.3, "continuous": 0.88}, "repeat": true,)"
                              << (both_hands ? left_hand : "") << R"(
            "right": {"path": [{"t": 0, "position": [0, 0, 0]}, {"t": 2, "position": [0.02, 0, 0]},
                               {"t": 4, "position": [0, 0, 0]}]}})";
        setenv("FULCRUM_DEVICE", ("virtual:" + script).c_str(), 1);
        const std::string program = program_path();
        setenv("FULCRUM_HAPTICD", (program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd").c_str(),
               1);
    }
    ~ScriptedDevice() {
        unsetenv("FULCRUM_DEVICE");
        unsetenv("FULCRUM_HAPTICD");
    }
    static constexpr const char* left_hand =
        R"("left": {"path": [{"t": 0, "position": [0, 0, 0]}], "hand": {"mass": 0.2}},)";
    fulcrum::test::OwnFolder own;
    std::string script = (own / "hand.json").string();
};

class DeviceWindow : public ScriptedDevice, public Window {
  protected:
    double right_x() { return theatre().session()->snapshot().tools[1].tip.x(); }
    QString panel() { return find<QLabel>(window, "panel_text")->text(); }
    QString cover() { return theatre().view()->cover().join(QStringLiteral(" / ")); }
    /// Practice of A2, before which the handles are to be brought to the ring.
    void wait_at_the_ring() {
        QSettings().clear();
        QSettings().setValue("begin_at_ring/virtual", true);
        create_programme_and_trainee();
        ui::window_test::click(window, "briefing_A2");
        expect_page("briefing_page");
        ui::window_test::check(window, "mode_practice");
        ui::window_test::click(window, "start_attempt");
        expect_page("theatre_page");
        ASSERT_TRUE(wait_for([&] { return cover().contains("Enter: begin where they are"); }, 20000))
            << static_cast<int>(theatre().session()->phase()) << cover().toStdString();
    }
};

TEST_F(DeviceWindow, TheEndOfTheDeviceProcessPausesAndOfTheDaemonTooWithWhatToDo) {
    create_programme_and_trainee();
    start("A2", false);
    EXPECT_EQ(theatre().session()->assessed(), false);
    EXPECT_TRUE(theatre().session()->health().force_felt[0]);
    EXPECT_EQ(services.device_in_use().clutch, ui::ClutchButton::own);
    const double begun = right_x();
    ASSERT_TRUE(wait_for([&] { return std::abs(right_x() - begun) > 2e-3; })) << "the script moves the hand";
    const pid_t overseer = daemon_child_of(getpid());
    ASSERT_GT(overseer, 0);
    const pid_t device = daemon_child_of(overseer);
    ASSERT_GT(device, 0);

    ASSERT_EQ(kill(device, SIGKILL), 0);
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::device_lost; }));
    ASSERT_TRUE(wait_for([&] { return aligned().back; })) << "the device process is started again";
    EXPECT_NE(daemon_child_of(overseer), device);

    ASSERT_EQ(kill(overseer, SIGKILL), 0);
    ASSERT_TRUE(wait_for([&] { return sees(window, "theatre_panel"); }));
    ASSERT_TRUE(wait_for([&] { return panel().contains("opened again when the next attempt begins"); }))
        << panel().toStdString();
    keep_picture(window, "34-daemon-gone");
    ui::window_test::click(window, "panel_abandon");
    wait_for_debrief();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_EQ(attempt.meta.device, "a scripted hand");
    EXPECT_EQ(attempt.meta.device_class, DeviceClass::haptic);
    EXPECT_EQ(attempt.meta.mode, AttemptMode::practice);
    ASSERT_TRUE(attempt.meta.force_devices[0].has_value());
    EXPECT_EQ(attempt.meta.force_devices[0]->continuous, 0.88);
    ASSERT_TRUE(attempt.meta.rig_use.has_value());
    EXPECT_EQ(attempt.meta.rig_use->stated, 1000);
    EXPECT_GT(attempt.meta.rig_use->measured, 500) << "while it answered";
    EXPECT_LT(attempt.meta.rig_use->measured, 1100);
    EXPECT_EQ(attempt.meta.rig_use->part, (std::array<int, 3>{0, 1, -1}));
    expect_replays(attempt.meta.id);

    home();
    start("A2", false);
    const double again = right_x();
    EXPECT_TRUE(wait_for([&] { return std::abs(right_x() - again) > 2e-3; })) << "the device is opened again";
    abandon();
}

TEST_F(DeviceWindow, AStoppedProcessOfTheDaemonPausesAndNothingIsLost) {
    create_programme_and_trainee();
    start("A2", false);
    const double begun = right_x();
    ASSERT_TRUE(wait_for([&] { return std::abs(right_x() - begun) > 2e-3; }));
    const auto phase = [&] { return theatre().session()->phase(); };
    const pid_t overseer = daemon_child_of(getpid()), device = daemon_child_of(overseer);
    ASSERT_GT(device, 0);
    // The overseer ends a stopped device process and starts another.
    ASSERT_EQ(kill(device, SIGSTOP), 0);
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::device_lost; }, 10000));
    ASSERT_TRUE(wait_for([&] { return aligned().back; }, 10000));
    EXPECT_NE(daemon_child_of(overseer), device);
    ASSERT_TRUE(wait_for([&] { return aligned().in_place; }, 10000)) << "the script comes by";
    QTest::keyClick(theatre().view(), Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }, 10000));

    // Without its overseer a device has no force: the attempt does not go on.
    ASSERT_EQ(kill(overseer, SIGSTOP), 0);
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::device_lost; }, 10000));
    ASSERT_TRUE(wait_for([&] { return panel().contains("which drives the device, does not answer"); }, 10000))
        << panel().toStdString();
    EXPECT_TRUE(panel().contains("check the device's cable and power; the device is opened again"));
    const double stopped = theatre().session()->display().elapsed_s;
    ASSERT_EQ(kill(overseer, SIGCONT), 0);
    ASSERT_TRUE(wait_for([&] { return aligned().back; }, 10000));
    EXPECT_EQ(theatre().session()->display().elapsed_s, stopped);
    ASSERT_EQ(kill(overseer, SIGSTOP), 0);
    ASSERT_TRUE(wait_for([&] { return sees(window, "theatre_panel"); }, 10000));
    ui::window_test::click(window, "panel_abandon");
    wait_for_debrief();
    expect_replays(newest_attempt().meta.id);

    home();
    start("A2", false);
    EXPECT_NE(daemon_child_of(getpid()), overseer) << "one that is stopped is opened again";
    const double again = right_x();
    EXPECT_TRUE(wait_for([&] { return std::abs(right_x() - again) > 2e-3; }, 10000));
    abandon();
}

TEST_F(DeviceWindow, ForceScaleOfTheSettingsIsUsedStoredAndNamedInTheDebrief) {
    QSettings().clear();
    create_programme_and_trainee();
    ui::window_test::click(window, "rail_settings");
    EXPECT_TRUE(find<QLabel>(window, "device_readings")->text().contains("while it is open"));
    auto* scale = find<QComboBox>(window, "force_scale");
    scale->setFocus();
    for (int i = 0; i < 6; ++i) QTest::keyClick(scale, Qt::Key_Up);
    EXPECT_EQ(scale->currentText(), "40 %");
    EXPECT_TRUE(wait_for([&] { return sees(window, "device_virtual"); })) << "the list of the program";
    // Tried without an attempt.
    ui::window_test::bring(*find<QPushButton>(window, "open_device"));
    ui::window_test::click(window, "open_device");
    ASSERT_TRUE(wait_for([&] { return sees(window, "force_test"); }));
    ASSERT_TRUE(wait_for([&] { return shown("device_readings").contains("Right hand: at ("); }));
    EXPECT_TRUE(wait_for([&] { return shown("device_readings").contains("Jitter of the readings: "); }))
        << shown("device_readings").toStdString();
    ui::window_test::bring(*find<QPushButton>(window, "force_test"));
    ui::window_test::click(window, "force_test");
    ASSERT_TRUE(wait_for([&] { return services.force_test().rendered > 0.03; }));
    keep_picture(window, "37-device-test");
    ui::window_test::click(window, "stop_force_test");
    EXPECT_FALSE(services.force_test().runs);
    ASSERT_TRUE(wait_for([&] { return shown("force_test_line").contains("The force is 0"); }));
    home();
    start("A2", false);
    const double begun = right_x();
    ASSERT_TRUE(wait_for([&] { return std::abs(right_x() - begun) > 2e-3; }));
    abandon();
    const database::AttemptSummary attempt = newest_attempt();
    for (const auto& device : attempt.meta.force_devices) {
        ASSERT_TRUE(device.has_value());
        EXPECT_DOUBLE_EQ(device->scale, 0.4);
    }
    EXPECT_TRUE(find<QLabel>(window, "debrief_notes")->text().contains("Device: a scripted hand; "));
    EXPECT_TRUE(find<QLabel>(window, "debrief_notes")->text().contains("readings per second (1000 stated)."));
    EXPECT_TRUE(find<QLabel>(window, "debrief_notes")->text().contains("Force was felt at 40 %."))
        << find<QLabel>(window, "debrief_notes")->text().toStdString();
    expect_replays(attempt.meta.id);
    // The device is open now: its readings are on the page.
    ui::window_test::click(window, "rail_settings");
    EXPECT_TRUE(wait_for([&] {
        const QString shown = find<QLabel>(window, "device_readings")->text();
        return shown.contains("readings per second") && shown.contains("Right hand: at (");
    })) << find<QLabel>(window, "device_readings")->text().toStdString();
    keep_picture(window, "35-devices");
    QSettings().clear();
}

TEST_F(DeviceWindow, AnAttemptWaitsForTheHandleAtTheRingUntilEnter) {
    ASSERT_NO_FATAL_FAILURE(wait_at_the_ring());
    EXPECT_TRUE(theatre().view()->cover().first().contains("move the handle "));
    EXPECT_EQ(theatre().session()->phase(), AttemptPhase::ready) << "nothing is on the clock";
    keep_picture(window, "35-bring-the-handles");
    QTest::keyClick(theatre().view(), Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }));
    EXPECT_FALSE(cover().contains("Enter: begin where they are"));
    abandon();
    QSettings().clear();
}

TEST_F(DeviceWindow, AnAttemptDoesNotBeginByItselfWhileItsDeviceIsAway) {
    ASSERT_NO_FATAL_FAILURE(wait_at_the_ring());
    const auto phase = [&] { return theatre().session()->phase(); };
    const auto begun = [&] { return phase() != AttemptPhase::ready || cover().isEmpty(); };
    const auto asks = [&] { return cover().contains("move the handle "); };
    const pid_t overseer = daemon_child_of(getpid());
    ASSERT_GT(overseer, 0);
    ASSERT_EQ(kill(overseer, SIGSTOP), 0);
    EXPECT_TRUE(wait_for([&] { return cover().contains("hand: does not answer"); }, 10000))
        << cover().toStdString();
    EXPECT_FALSE(wait_for(begun, 1000));
    ASSERT_EQ(kill(overseer, SIGCONT), 0);
    EXPECT_TRUE(wait_for(asks, 10000)) << cover().toStdString();
    QTest::qWait(1000);

    // The device is unplugged: its process ends, and another one is started.
    const pid_t device = daemon_child_of(overseer);
    ASSERT_GT(device, 0);
    ASSERT_EQ(kill(device, SIGKILL), 0);
    EXPECT_FALSE(wait_for(begun, 3000)) << static_cast<int>(phase());
    EXPECT_TRUE(wait_for(asks, 10000)) << cover().toStdString();
    EXPECT_NE(daemon_child_of(overseer), device);
    QTest::keyClick(theatre().view(), Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }));
    abandon();
    QSettings().clear();
}

class OneHandWindow : public ScriptedDevice, public Window {
  protected:
    OneHandWindow() : ScriptedDevice(false) {}
};

TEST_F(OneHandWindow, PracticeFromAMomentGivesTheMouseTheHandThatTheDeviceDoesNotMove) {
    QSettings().clear();
    create_programme_and_trainee();
    start("A2", false);
    EXPECT_EQ(theatre().input()->active_hand(), Hand::left);
    ASSERT_TRUE(wait_for([&] { return theatre().session()->snapshot().tick > 3000; }));
    abandon();
    auto* panel = wait_for_debrief().findChild<ui::ReplayPanel*>();
    ASSERT_NE(panel, nullptr);
    ASSERT_TRUE(wait_for([&] { return panel->shown_time() >= 0; }, 120000));
    auto* slider = find<QSlider>(window, "replay_slider");
    QTest::keyClick(slider, Qt::Key_End);
    for (int i = 0; i < 3; ++i) QTest::keyClick(slider, Qt::Key_PageDown);
    ASSERT_TRUE(wait_for([&] { return std::abs(panel->shown_time() - panel->time()) < 0.02; }, 120000));
    ui::window_test::click(window, "replay_take_over");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }, 120000));
    EXPECT_EQ(theatre().input()->active_hand(), Hand::left);
    abandon();
    QSettings().clear();
}

}  // namespace
}  // namespace fulcrum::app::program_test
