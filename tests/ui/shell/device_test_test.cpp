// SPDX-License-Identifier: GPL-3.0-or-later
// The test of a device on the page of settings.
#include "ui/shell/device_test.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>

#include "tests/ui/screens.h"
#include "ui/language/language.h"
#include "ui/shell/devices_card.h"
#include "ui/shell/frame_check.h"
#include "ui/shell/workspace_fit.h"
#include "ui/shell/workspace_view.h"
#include "ui/style/appearance.h"

namespace fulcrum::ui::window_test {
namespace {

class DeviceOnThePage : public Screens {
  protected:
    ~DeviceOnThePage() override {
        window.reset();
        apply_text_size(*qApp, 100);
        use_language(Language::english);
    }
    void open_page() {
        open({1280, 800});
        sign_in(Role::trainee);
        go_to("rail_settings");
    }
    void use_controller() {
        services.in_use.kind = "controller";
        services.in_use.title = "game controller";
        services.in_use.device_class = DeviceClass::controller;
        DeviceReadings now;
        now.rate = 250;
        now.controller.emplace();
        now.controller->connected = now.controller->begun[0] = true;
        now.controller->name = "Fake Pad";
        services.readings_when_open = now;
    }
    QString text_of(const char* name) { return find<QLabel>(*window, name)->text(); }
    bool waits_for(const char* label, const char* words) {
        return wait_for([&] { return text_of(label).contains(QString::fromUtf8(words)); }, 5000);
    }
};

TEST_F(DeviceOnThePage, IsOpenedWithoutAnAttemptAndEachDirectionGetsItsMark) {
    use_touch();
    open_page();
    EXPECT_FALSE(sees(*window, "frame_check"));
    bring(*find<QPushButton>(*window, "open_device"));
    click(*window, "open_device");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "frame_check"); }));
    EXPECT_FALSE(sees(*window, "open_device"));
    EXPECT_TRUE(waits_for("device_readings", "1000 readings per second, at most 0.4 ms late"))
        << text_of("device_readings").toStdString();
    EXPECT_TRUE(text_of("device_readings").contains("Jitter of the readings: 0.05 ms"));
    EXPECT_TRUE(text_of("device_readings").contains("Calibration: valid"));
    EXPECT_TRUE(waits_for("frame_marks", "Left hand: – right · – up · – away from you"));
    auto& left = services.readings->held[0].position;
    left = Vector3(0.03, 0.001, 0);
    EXPECT_TRUE(waits_for("frame_marks", "Left hand: ✓ right · – up · – away from you"));
    left = Vector3(0, -0.03, 0);
    EXPECT_TRUE(waits_for("frame_marks", "Left hand: ✓ right · – up")) << "down is not up";
    left = Vector3(0, 0.03, 0);
    EXPECT_TRUE(waits_for("frame_marks", "Left hand: ✓ right · ✓ up · – away"));
    left = Vector3(0, 0, -0.03);
    EXPECT_TRUE(waits_for("frame_marks", "Left hand: ✓ right · ✓ up · ✓ away from you\nRight hand: – right"));
    click(*window, "frame_again");
    EXPECT_TRUE(waits_for("frame_marks", "Left hand: – right · – up · – away from you"));
    services.readings->needs_calibration = true;
    EXPECT_TRUE(waits_for("device_readings", "Calibration: needed"));
}

TEST_F(DeviceOnThePage, TheReachIsDrawnAndFitChoosesTheScaleWithWhichTheTaskIsReached) {
    use_touch();
    services.readings_when_open->held[0].clutch = true;
    services.reach[0] = services.reach[1] =
        WorkspaceBox{Vector3(-0.05, 0, -0.04), Vector3(0.05, 0.05, 0.055)};
    services.readings = services.readings_when_open;
    open_page();
    ASSERT_TRUE(waits_for("reach_lines", "% of the scene is reached from the ring"))
        << text_of("reach_lines").toStdString();
    EXPECT_TRUE(text_of("reach_lines").contains("Left hand: workspace 160 × 120 × 70 mm"));
    EXPECT_TRUE(text_of("reach_lines").contains("73 % of the scene")) << text_of("reach_lines").toStdString();
    EXPECT_TRUE(text_of("clutch_note").startsWith("Clutch: a button of the device."));
    const auto picture = [&] { return find<WorkspaceView>(*window, "workspace_right")->picture(); };
    ASSERT_TRUE(picture().scene.has_value());
    EXPECT_TRUE(picture().scene->size().isApprox(Vector3(0.1, 0.05, 0.095)));
    bring(*find<QPushButton>(*window, "fit_motion"));
    click(*window, "fit_motion");
    EXPECT_EQ(services.motions["touch"], 1.5) << "95 mm deep in 70 mm, with room to spare";
    EXPECT_EQ(find<QComboBox>(*window, "motion_scale")->currentText(), "150 %");
    EXPECT_TRUE(waits_for("reach_lines", "All of the scene is reached from the ring."));
    EXPECT_LT(picture().scene->size().z(), 0.07);
    EXPECT_TRUE(waits_for("reach_lines", "From where the handle is now"));
    services.readings->held[0].position = picture().begin;
    EXPECT_TRUE(waits_for("reach_lines", "The handle is at the ring."));
    EXPECT_TRUE(text_of("reach_lines").contains("The ring is 17 mm down, 5 mm away from you."))
        << text_of("reach_lines").toStdString();
    EXPECT_FALSE(services.at_ring);
    click(*window, "begin_at_ring");
    EXPECT_TRUE(services.at_ring);
    bring(*find<QWidget>(*window, "workspace_left"));
    keep("device-reach");
    services.readings->held[0].workspace.reset();
    services.readings->held[1].workspace.reset();
    EXPECT_TRUE(wait_for([&] { return !sees(*window, "reach_lines"); })) << "no workspace is known";
}

TEST_F(DeviceOnThePage, ACalibrationIsGuidedStepByStepAndSaysWhatWasStored) {
    services.in_use.kind = "joystick";
    services.in_use.title = "HID joystick as an instrument";
    services.in_use.device_class = DeviceClass::tracked;
    services.calibrated = "2026-11-26 10:30";
    open_page();
    EXPECT_EQ(text_of("calibration_when"), "Calibrated last: 2026-11-26 10:30.");
    EXPECT_FALSE(sees(*window, "calibration_next"));
    services.calibrating.steps = 6;
    services.calibrating.what_to_do =
        "Hold the instrument straight away from you, half way in, its jaws "
        "open, and keep it still.";
    services.calibrating.seen = "It moves.";
    bring(*find<QPushButton>(*window, "calibrate"));
    click(*window, "calibrate");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "calibration_next"); }));
    EXPECT_TRUE(text_of("calibration_step").startsWith("Step 2 of 6: Hold the instrument straight"))
        << "the right hand: " << text_of("calibration_step").toStdString();
    EXPECT_EQ(text_of("calibration_seen"), "It moves.");
    EXPECT_FALSE(find<QPushButton>(*window, "calibration_next")->isEnabled());
    EXPECT_FALSE(sees(*window, "calibration_skip"));
    services.calibrating.ready = services.calibrating.can_skip = true;
    services.calibrating.seen = "Seen.";
    ASSERT_TRUE(wait_for([&] { return find<QPushButton>(*window, "calibration_next")->isEnabled(); }));
    bring(*find<QWidget>(*window, "calibration_cancel"));
    keep("device-calibration");
    click(*window, "calibration_next");
    EXPECT_TRUE(text_of("calibration_step").startsWith("Step 3 of 6"));
    click(*window, "calibration_skip");
    EXPECT_TRUE(text_of("calibration_step").startsWith("Step 13 of 6"));
    services.calibrating.runs = false;
    services.calibrating.good = true;
    services.calibrating.result = "Stored.";
    ASSERT_TRUE(wait_for([&] { return sees(*window, "calibration_result"); }));
    EXPECT_EQ(text_of("calibration_result"), "Stored.");
    EXPECT_FALSE(sees(*window, "calibration_next"));
    services.calibrating.steps = 6;
    click(*window, "calibrate");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "calibration_cancel"); }));
    go_to("rail_home");
    EXPECT_FALSE(services.calibrating.runs) << "leaving the page ends it";
}

TEST_F(DeviceOnThePage, TheForceTestIsStoppedByButtonEscapeTroubleAndLeavingThePage) {
    use_touch();
    services.readings = services.readings_when_open;
    open_page();
    ASSERT_TRUE(wait_for([&] { return sees(*window, "force_test"); }));
    const auto begin = [&] {
        ASSERT_TRUE(wait_for([&] { return sees(*window, "force_test"); }));
        bring(*find<QPushButton>(*window, "force_test"));
        click(*window, "force_test");
        ASSERT_TRUE(wait_for([&] { return sees(*window, "stop_force_test"); }));
        EXPECT_TRUE(services.tested.runs);
    };
    begin();
    services.tested.hand = "right";
    services.tested.axis = 1;
    services.tested.asked = services.tested.largest_asked = 0.07;
    services.tested.rendered = 0.06;
    EXPECT_TRUE(waits_for("force_test_line", "Right hand, up: 0.07 N"));
    keep("device-force-test");
    click(*window, "stop_force_test");
    EXPECT_FALSE(services.tested.runs);
    EXPECT_TRUE(
        waits_for("force_test_line", "up to 0.07 N were asked for, up to 0.06 N rendered. The force is 0"));
    begin();
    QTest::keyClick(window->focusWidget(), Qt::Key_Escape);
    EXPECT_FALSE(services.tested.runs);
    begin();
    services.trouble = "The device does not answer.";
    EXPECT_TRUE(wait_for([&] { return !services.tested.runs; }, 3000));
    services.trouble = {};
    ASSERT_TRUE(wait_for([&] { return find<QPushButton>(*window, "force_test")->isEnabled(); }));
    begin();
    go_to("rail_home");
    EXPECT_FALSE(services.tested.runs);
}

TEST_F(DeviceOnThePage, PartsAreAssignedAndNeverTwice) {
    use_touch();
    services.readings = services.readings_when_open;
    open_page();
    ASSERT_TRUE(wait_for([&] { return sees(*window, "slot_left"); }));
    const auto choose = [&](const char* name, int row) {
        auto* list = find<QComboBox>(*window, name);
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Home);
        for (int i = 0; i < row; ++i) QTest::keyClick(list, Qt::Key_Down);
    };
    choose("slot_left", 1);
    EXPECT_EQ(services.parts, (SlotChoice{1, 0, 2})) << "the hands change places";
    EXPECT_EQ(find<QComboBox>(*window, "slot_right")->currentText(), "left device");
    choose("slot_right", 3);
    EXPECT_EQ(services.parts.right, -1);
    choose("slot_scope", 0);
    EXPECT_EQ(services.parts.scope, 0);
    ASSERT_TRUE(sees(*window, "slot_pedal"));
    EXPECT_EQ(find<QComboBox>(*window, "slot_pedal")->currentText(), "button of each hand");
    choose("slot_pedal", 2);
    EXPECT_EQ(services.parts.pedal, 1);
    choose("slot_left", 1);
    EXPECT_EQ(services.parts.pedal, 1) << "stays when parts change";
    choose("slot_pedal", 4);
    EXPECT_EQ(services.parts.pedal, pedal_keys_only);
    choose("motion_scale", 0);
    EXPECT_EQ(services.motion_scale("touch"), 0.5);
    EXPECT_FALSE(sees(*window, "rumble")) << "of controllers only";
}

TEST_F(DeviceOnThePage, OfAControllerSticksAreShownAndNoForce) {
    use_controller();
    services.readings = services.readings_when_open;
    open_page();
    ASSERT_TRUE(wait_for([&] { return sees(*window, "frame_check"); }));
    EXPECT_FALSE(sees(*window, "force_test"));
    EXPECT_FALSE(sees(*window, "slot_left"));
    EXPECT_TRUE(waits_for("device_readings", "Right stick: not in its middle since it was connected"));
    ControllerReadings& pad = *services.readings->controller;
    pad.stick[0][0] = 1;
    pad.trigger[0] = 0.5;
    EXPECT_TRUE(waits_for("device_readings", "Left stick: 100 % to the right, 0 % up, trigger 50 %"));
    EXPECT_TRUE(waits_for("frame_marks", "Left hand: ✓ right · – up"));
    pad.stick[0][0] = 0;
    pad.stick[0][1] = 1;
    pad.buttons = 1U << 9U;
    EXPECT_TRUE(waits_for("frame_marks", "Left hand: ✓ right · – up · ✓ away from you"));
    check(*window, "rumble", false);
    EXPECT_FALSE(services.rumbles);
    pad.connected = false;
    EXPECT_TRUE(waits_for("device_readings", "Fake Pad: not connected"));
}

TEST_F(DeviceOnThePage, ADeviceIsChosenWithAButtonUnlessTheEnvironmentNamesOne) {
    services.devices = {
        {"mouse-keyboard",
         "mouse and keyboard",
         DeviceClass::mouse_keyboard,
         DeviceState::usable,
         {},
         "",
         ""},
        {"controller", "game controller", DeviceClass::controller, DeviceState::usable, {"Fake Pad"}, "", ""},
        {"touch", "3D Systems Touch", DeviceClass::haptic, DeviceState::absent, {}, "w", "t"}};
    open_page();
    ASSERT_TRUE(wait_for([&] { return sees(*window, "device_controller"); }));
    EXPECT_FALSE(sees(*window, "use_controller"));
    services.can_choose = true;
    open_page();
    ASSERT_TRUE(wait_for([&] { return sees(*window, "use_controller"); }));
    EXPECT_FALSE(sees(*window, "use_touch"));
    bring(*find<QPushButton>(*window, "use_controller"));
    click(*window, "use_controller");
    EXPECT_EQ(services.chosen, "controller");
    EXPECT_TRUE(sees(*window, "open_device"));
}

TEST_F(DeviceOnThePage, IsDrawnInBothThemesLanguagesAndLarge) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        for (const bool touch : {true, false}) {
            touch ? use_touch() : use_controller();
            services.readings = services.readings_when_open;
            services.can_choose = true;
            for (const int percent : {100, 200}) {
                close_and_look(theme, theme == Theme::light ? Language::english : Language::german, percent);
                open_page();
                ASSERT_TRUE(wait_for([&] { return sees(*window, "frame_check"); }));
                auto* frame = find<FrameCheck>(*window, "frame_check");
                bring(*frame);
                settle();
                expect_fits("device test");
                EXPECT_GT(expect_whole(QStringLiteral("device test %1").arg(percent),
                                       window->findChild<DevicesCard*>()),
                          8);
                keep(QStringLiteral("device-test-%1-%2").arg(touch ? "touch" : "controller").arg(percent));
                keep_body(
                    *window, *window->current_page(),
                    QStringLiteral("device-%1-%2-%3")
                        .arg(touch ? "touch" : "controller", theme == Theme::light ? "light" : "dark-de")
                        .arg(percent));
            }
        }
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
