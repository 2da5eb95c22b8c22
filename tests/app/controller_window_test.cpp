// SPDX-License-Identifier: GPL-3.0-or-later
// The window with a game controller, whose library is a fake that the test scripts. Whole tasks:
// hands_at_work_test.cpp.
#include <gtest/gtest.h>

#include <QPainter>
#include <QProcess>
#include <QSettings>
#include <nlohmann/json.hpp>

#include "assessment/operators/operator.h"
#include "sim_core/controllers/sdl_library.h"
#include "sim_core/instrument/mouse_mapping.h"
#include "tests/app/controller_hand.h"
#include "tests/app/program_path.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/built.h"
#include "tests/ui/painted_words.h"
#include "ui/shell/idle_watch.h"

namespace fulcrum::app::program_test {
namespace {

using namespace controllers;
using ui::AttemptPhase;
using ui::window_test::find;
using ui::window_test::keep_picture;
using ui::window_test::sees;
using ui::window_test::wait_for;

/// Before the services are made.
struct FakeController {
    FakeController() { page->controller[0].plugged = 1; }
    fulcrum::test::FakePage<fulcrum::test::FakeSdlPage> page{"FAKE_SDL_PAGE"};
    fulcrum::test::Variable library{"FULCRUM_LIBSDL2", fulcrum::test::fake_library("libSDL2.so")};
    fulcrum::test::Variable device{"FULCRUM_DEVICE", "controller"};
};

class ControllerWindow : public FakeController, public Window {
  protected:
    fulcrum::test::FakeSdlController& pad() { return page->controller[0]; }
    const ui::HandTargets& targets() { return theatre().input()->targets(); }
    AttemptPhase phase() { return theatre().session()->phase(); }
    void press(SdlButton button) {
        pad().buttons = 1U << static_cast<unsigned>(button);
        QTest::qWait(60);
        pad().buttons = 0;
        QTest::qWait(60);
    }
    /// Rumble is an intensity: no newtons are felt with it.
    void expect_not_felt_on_the_screen() {
        ui::window_test::WordsDevice device(theatre().view()->size());
        QPainter painter(&device);
        ui::paint_hud(painter, theatre().view()->rect(), theatre().view()->hud());
        painter.end();
        QString words;
        for (const ui::window_test::PaintedWords& painted : device.words())
            words += painted.words + QLatin1Char('\n');
        EXPECT_TRUE(words.contains("force is shown, not felt")) << words.toStdString();
    }
    void expect_not_felt_in_the_debrief() {
        const QString notes = shown("debrief_notes");
        EXPECT_TRUE(notes.contains("Force was not felt: this device cannot render it. It was shown as bars."))
            << notes.toStdString();
        EXPECT_FALSE(notes.contains("Force was felt")) << notes.toStdString();
        EXPECT_FALSE(newest_attempt().meta.force_devices[0].has_value());
        EXPECT_FALSE(newest_attempt().meta.force_devices[1].has_value());
    }
    void expect_stored(AttemptState state) {
        const database::AttemptSummary attempt = newest_attempt();
        EXPECT_EQ(attempt.state, state);
        EXPECT_EQ(attempt.meta.device, "Fake Pad");
        EXPECT_EQ(attempt.meta.device_class, DeviceClass::controller);
        expect_replays(attempt.meta.id);
        EXPECT_EQ(page->misuse, 0U);
    }
};

TEST_F(ControllerWindow, EachStickMovesItsHandAndAnUnpluggedControllerPausesTheAttempt) {
    QSettings().clear();
    window.resize(1024, 768);
    create_programme_and_trainee();
    start("A2", false);
    const ui::HandTargets before = targets();
    pad().axis[axis_left_x] = 32767;
    ASSERT_TRUE(wait_for([&] { return (targets().hand[0].handle - before.hand[0].handle).norm() > 12e-3; }));
    pad().axis[axis_left_x] = 0;
    EXPECT_EQ(targets().hand[1].handle, before.hand[1].handle) << "the hand that is not touched stays";
    pad().buttons = 1U << button_right_shoulder;
    pad().axis[axis_right_y] = -32768;
    ASSERT_TRUE(wait_for([&] {
        return targets().hand[1].handle.norm() < before.hand[1].handle.norm() - 8e-3;
    })) << "in";
    // To the end of the shaft's range and not further.
    ASSERT_TRUE(wait_for([&] {
        const double now = targets().hand[1].handle.norm();
        QTest::qWait(300);
        return targets().hand[1].handle.norm() == now;
    }));
    EXPECT_GT(targets().hand[1].handle.norm(), handle_clearance);
    pad().axis[axis_right_y] = 0;
    pad().buttons = 0;

    pad().axis[axis_right_x] = -20000;
    const auto did = [&](ui::HandDeed deed) { return theatre().deeds().test(ui::bit_of(deed)); };
    ASSERT_TRUE(wait_for([&] { return did(ui::HandDeed::moved); })) << "both hands moved";
    pad().axis[axis_right_x] = 0;
    EXPECT_TRUE(sees(window, "theatre_keys")) << "the controller is new to this person";
    keep_picture(window, "59-controller-first-steps");
    pad().axis[axis_right_trigger] = 13000;
    ASSERT_TRUE(wait_for([&] { return targets().hand[1].jaw < 0.6 * targets().hand[0].jaw; }));
    EXPECT_GT(targets().hand[1].jaw, 0) << "jaws follow the trigger";
    EXPECT_EQ(targets().hand[1].grip, 0);
    pad().axis[axis_right_trigger] = 32767;
    ASSERT_TRUE(wait_for([&] { return targets().hand[1].jaw == 0 && targets().hand[1].grip > 7; }));
    press(button_left_stick);
    ASSERT_TRUE(wait_for([&] { return targets().hand[0].jaw == 0; })) << "stays closed";
    EXPECT_FALSE(did(ui::HandDeed::jaws_closed)) << "a probe has no jaws";
    EXPECT_EQ(theatre().deeds().count(), 2U);
    pad().buttons = 1U << button_pad_left;
    ASSERT_TRUE(wait_for([&] { return did(ui::HandDeed::scope_moved); }));
    pad().buttons = 0;
    ASSERT_TRUE(wait_for([&] { return !sees(window, "theatre_keys"); })) << "everything was tried";
    EXPECT_EQ(QSettings().allKeys().filter("learnt/").size(), 1);
    QTest::keyClick(theatre().view(), Qt::Key_F1);
    keep_picture(window, "60-controller-help");
    QTest::keyClick(theatre().view(), Qt::Key_F1);
    press(button_start);
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::paused; }));
    press(button_start);
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }));

    pad().plugged = 0;
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::device_lost; }));
    ASSERT_TRUE(wait_for([&] { return sees(window, "theatre_panel"); }));
    EXPECT_TRUE(
        find<QLabel>(window, "panel_text")->text().contains("Fake Pad is not connected. Connect it again"))
        << find<QLabel>(window, "panel_text")->text().toStdString();
    keep_picture(window, "61-controller-unplugged");
    pad().axis[axis_right_trigger] = 0;
    pad().plugged = 1;
    ASSERT_TRUE(wait_for([&] { return aligned().in_place; }));
    press(button_start);
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }));
    QTest::qWait(200);
    EXPECT_EQ(targets().hand[1].jaw, 0) << "what was held when the controller was lost is still held";
    press(button_right_stick);
    ASSERT_TRUE(wait_for([&] { return targets().hand[1].jaw > 0; }));
    abandon();
    expect_stored(AttemptState::abandoned);
}

TEST_F(ControllerWindow, StartDoesNothingWhileTheWindowIsLocked) {
    create_programme_and_trainee();
    start("A2", false);
    auto* idle = window.findChild<ui::IdleWatch*>();
    ASSERT_NE(idle, nullptr);
    idle->lock_after(300);
    ASSERT_TRUE(wait_for([&] { return sees(window, "unlock"); }));
    EXPECT_EQ(phase(), AttemptPhase::paused);
    idle->lock_after(ui::IdleWatch::lock_after_ms);
    press(button_start);
    QTest::qWait(200);
    EXPECT_EQ(phase(), AttemptPhase::paused);
    EXPECT_TRUE(sees(window, "unlock"));
    ui::window_test::type(window, "unlock_password", "tara's password");
    ui::window_test::click(window, "unlock");
    ASSERT_TRUE(wait_for([&] { return !sees(window, "unlock"); }));
    QTest::qWait(200);
    EXPECT_EQ(phase(), AttemptPhase::paused) << "the press before is not kept";
    press(button_start);
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }));
    abandon();
    expect_stored(AttemptState::abandoned);
}

class ControllerCommand : public FakeController, public ::testing::Test {
  protected:
    /// Exit status; standard output and error are kept.
    int run(const QStringList& arguments) {
        QProcess process;
        process.start(QString::fromStdString(program_path()), arguments);
        EXPECT_TRUE(process.waitForFinished(30000));
        output = process.readAllStandardOutput();
        error = process.readAllStandardError();
        return process.exitCode();
    }
    QByteArray output, error;
};

TEST_F(ControllerCommand, TestsAControllerWithoutAWindow) {
    page->controller[0].axis[axis_left_x] = 16000;
    page->controller[0].axis[axis_right_trigger] = 32767;
    page->controller[0].buttons = 1U << button_east;
    ASSERT_EQ(run({"devices", "--test", "controller", "--seconds", "2", "--rumble", "--json"}), 0)
        << error.toStdString();
    const auto document = nlohmann::json::parse(output.toStdString());
    EXPECT_EQ(document.at("device").at("title"), "Fake Pad");
    EXPECT_EQ(document.at("device_class"), "controller");
    EXPECT_GT(document.at("rate_hz").get<double>(), 100);
    EXPECT_LT(document.at("rate_hz").get<double>(), 260);
    EXPECT_NEAR(document.at("left").at("to_the_right").at(1).get<double>(), 0.488, 0.01);
    EXPECT_EQ(document.at("left").at("stick_was_in_middle"), false);
    EXPECT_EQ(document.at("right").at("trigger").at(1), 1.0);
    EXPECT_EQ(document.at("buttons"), nlohmann::json::array({"east"}));
    EXPECT_EQ(document.at("rumbled"), true);
    EXPECT_GE(page->controller[0].rumbles, 5U);
    EXPECT_EQ(run({"devices", "--test", "controller", "--force"}), 2);
    EXPECT_TRUE(error.contains("use --rumble")) << error.toStdString();
    EXPECT_EQ(run({"devices", "--test", "controller:Other"}), 2);
    EXPECT_TRUE(error.contains("none of the name Other is connected")) << error.toStdString();
    EXPECT_EQ(run({"devices"}), 0);
    EXPECT_TRUE(output.contains("game controller: can be used\n    Fake Pad")) << output.toStdString();
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(ControllerWindow, OneThatCannotBeOpenedSaysWhyAndNothingBegins) {
    create_programme_and_trainee();
    pad().plugged = 0;
    ui::window_test::click(window, "briefing_A2");
    expect_page("briefing_page");
    ui::window_test::click(window, "start_attempt");
    ASSERT_TRUE(wait_for([&] { return sees(window, "message_text"); }));
    EXPECT_TRUE(shown("message_text").contains("none is connected")) << shown("message_text").toStdString();
    expect_page("briefing_page");
    pad().plugged = 1;
    ui::window_test::click(window, "start_attempt");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }, 120000));
    abandon();
}

TEST_F(ControllerWindow, AnExpertWorksBySticksAndTriggersAndContactIsFeltAndHeard) {
    services.hears = true;
    create_programme_and_trainee();
    for (const char* task : {"A2", "B1"}) {
        fulcrum::test::FakeSound& sound = page->sound;
        start(task, false);
        ASSERT_TRUE(wait_for([&] { return sound.plays == 1U; }));
        sound.heard_at = 0;
        pad().felt_at = 0;
        const auto mind = make_operator(OperatorLevel::expert, theatre().session()->task(),
                                        theatre().session()->scene(), 7);
        FakePad face(pad());
        ControllerHand hand(theatre(), *mind, face);
        const bool a2 = *task == 'A';
        // How soon: feedback_latency_test.cpp.
        const auto done = [&] {
            return pad().felt_at != 0 && sound.heard_at != 0 && theatre().view()->pale_at() != 0 &&
                   (!a2 || theatre().session()->display().goal_progress > 0.05);
        };
        ASSERT_TRUE(hand.work_until(done, 240000)) << task;
        EXPECT_GT(hand.events(), 50);
        expect_not_felt_on_the_screen();
        keep_picture(window, QStringLiteral("62-controller-") + QLatin1String(task));
        abandon();
        expect_not_felt_in_the_debrief();
        expect_stored(AttemptState::abandoned);
        EXPECT_EQ(sound.outside, 0U);
        home();
    }
    services.choose_sound({false, 0.5});
    EXPECT_EQ(page->sound.open, 0U) << "off: the device is closed at once";
}

}  // namespace
}  // namespace fulcrum::app::program_test
