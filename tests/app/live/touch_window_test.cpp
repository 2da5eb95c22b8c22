// SPDX-License-Identifier: GPL-3.0-or-later
// The window with a 3D Systems Touch, whose library is a fake that the test scripts: readings that are not
// possible, hands that are used or not, and a device that rests.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <cmath>
#include <limits>

#include "assessment/attempt/scene_reach.h"
#include "sim_core/instrument/instrument.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/posed_hand.h"
#include "tests/app/program_path.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_touch.h"
#include "tests/support/built.h"
#include "ui/shell/idle_watch.h"
#include "ui/theatre/begin_place.h"

namespace fulcrum::app::program_test {
namespace {

using ui::AttemptPhase;
using ui::window_test::find;
using ui::window_test::keep_picture;
using ui::window_test::sees;
using ui::window_test::wait_for;

/// Before the services are made.
struct FakeTouch {
    static std::string daemon() {
        const std::string program = program_path();
        return program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd";
    }
    fulcrum::test::FakePage<fulcrum::test::FakeTouchPage> page{"FAKE_TOUCH_PAGE"};
    fulcrum::test::Variable library{"FULCRUM_LIBHD", fulcrum::test::fake_library("libHD.so")};
    fulcrum::test::Variable device{"FULCRUM_DEVICE", "touch:Left Device,Right Device"};
    fulcrum::test::Variable program{"FULCRUM_HAPTICD", daemon()};
};

class TouchWindow : public FakeTouch, public Window {
  protected:
    QString panel() { return find<QLabel>(window, "panel_text")->text(); }
    AttemptPhase phase() { return theatre().session()->phase(); }
    QString cover() { return theatre().view()->cover().join(QStringLiteral(" / ")); }
    double force(int hand) {
        double most = 0;
        for (const auto& f : page->device[hand].force) most = std::max(most, std::abs(f.load()));
        return most;
    }
};

// Faults that the library reports: fault_window_test.cpp.
TEST_F(TouchWindow, AReadingThatIsNotPossiblePausesTheAttemptWithForceZeroUntilItIsPossibleAgain) {
    create_programme_and_trainee();
    start("A2", false);
    EXPECT_TRUE(theatre().session()->health().force_felt[0] && theatre().session()->health().force_felt[1]);
    // Its button for energy is the clutch where it is not the pedal: the first steps name it.
    EXPECT_EQ(services.device_in_use().clutch, ui::ClutchButton::none);
    for (const int pedal : {ui::pedal_keys_only, 0}) {
        services.set_slot_choice("touch", {0, 1, -1, pedal});
        EXPECT_EQ(services.device_in_use().clutch, ui::ClutchButton::energy);
        EXPECT_EQ(services.device_in_use().pedal, pedal);
    }
    services.set_slot_choice("touch", {0, -1, -1, 0});
    EXPECT_EQ(services.device_in_use().clutch, ui::ClutchButton::none) << "the only hand's is the pedal";
    services.set_slot_choice("touch", {});
    const auto mind = make_pointing_mind(theatre().session()->scene(), 1e-3);
    PosedHand hand(theatre(), *mind, [this](int h, const Vector3& position) {
        for (int axis = 0; axis < 3; ++axis) page->device[h].position[axis] = 1e3 * position[axis];
    });
    ASSERT_TRUE(hand.work_until([&] { return force(0) > 0.05; }, 20000));
    std::atomic<double>& x = page->device[0].position[0];
    for (const bool jumps : {false, true}) {
        SCOPED_TRACE(jumps);
        ASSERT_TRUE(wait_for([&] { return force(0) > 0.05; }, 10000));
        const double before = x;
        const std::int64_t begin = monotonic_ns();
        x = jumps ? before + 1000 : std::numeric_limits<double>::quiet_NaN();  // mm
        while ((force(0) != 0 || force(1) != 0) && monotonic_ns() - begin < 1'000'000'000) usleep(200);
        EXPECT_LE(monotonic_ns() - begin, 50'000'000) << "until the force is 0";
        ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::device_lost; }));
        ASSERT_TRUE(wait_for([&] { return sees(window, "theatre_panel"); }));
        EXPECT_TRUE(panel().contains("The left hand's device gave an impossible reading"))
            << panel().toStdString();
        EXPECT_TRUE(panel().contains("Reconnect the device")) << panel().toStdString();
        if (jumps) keep_picture(window, "36-touch-jumped");
        x = before;
        ASSERT_TRUE(wait_for([&] { return aligned().back; })) << panel().toStdString();
        ASSERT_TRUE(wait_for([&] { return aligned().in_place; })) << aligned().hand[0].distance;
        EXPECT_EQ(force(0), 0) << "until the person resumes";
        QTest::keyClick(theatre().view(), Qt::Key_Return);
        ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }));
    }
    ASSERT_TRUE(wait_for([&] { return force(0) > 0.05; }, 10000)) << "the force comes back";
    abandon();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_EQ(attempt.meta.device, "3D Systems Touch");
    EXPECT_EQ(attempt.meta.device_class, DeviceClass::haptic);
    ASSERT_TRUE(attempt.meta.force_devices[1].has_value());
    EXPECT_EQ(attempt.meta.force_devices[1]->peak, 3.3);
    expect_replays(attempt.meta.id);
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(TouchWindow, ConnectAndTryItOnThePageOfSettingsSaysWhyTheDeviceDoesNotOpenAndWhatToDo) {
    create_programme_and_trainee();
    ui::window_test::click(window, "rail_settings");
    const auto tried = [&] {
        ui::window_test::bring(*find<QPushButton>(window, "open_device"));
        ui::window_test::click(window, "open_device");
    };
    page->init_errors = 1000;
    struct Case {
        std::uint32_t firmware, error;
        const char* words;
    };
    for (const Case& one :
         {Case{1, 0x0302,
               "3D Systems Touch:Left Device: the maker's driver reports 0x0302 Firmware version is not "
               "supported; update the firmware of the device with its maker's program"},
          Case{0, 0x0600, "the maker's driver reports 0x0600; install the licence of OpenHaptics"}}) {
        page->old_firmware = one.firmware;
        page->init_error = one.error;
        tried();
        EXPECT_TRUE(wait_for([&] { return shown("message_text").contains(one.words); }, 10000))
            << shown("message_text").toStdString();
        EXPECT_TRUE(sees(window, "open_device")) << "it can be tried again";
    }
    page->init_errors = 0;
    tried();
    EXPECT_TRUE(wait_for([&] { return shown("device_readings").contains("readings per second"); }, 10000));
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(TouchWindow, AnAttemptThatBeginsWithoutAnAnswerResumesWhereItsInstrumentsBegin) {
    create_programme_and_trainee();
    ui::window_test::click(window, "briefing_A2");
    expect_page("briefing_page");
    ui::window_test::check(window, "mode_practice");
    ui::window_test::click(window, "start_attempt");
    // The device is open, the scene is still being built.
    page->device[1].tick_error = 0x0200;
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::device_lost; }, 120000));
    const Scene& scene = theatre().session()->scene();
    const InstrumentSpec& spec = *scene.instrument(Hand::right);
    const Vector3 start =
        tool_pose(make_instrument(spec, scene.tick_period()), start_sample(spec.trocar, spec.start_insertion))
            .tip;
    const auto tip = [&] { return theatre().session()->snapshot().tools[1].tip; };
    const std::uint32_t lost_at = theatre().session()->health().ticks;
    ASSERT_TRUE(wait_for([&] { return theatre().session()->snapshot().tick >= lost_at; }));
    EXPECT_LT((tip() - start).norm(), 1e-4) << tip().transpose() << ", not " << start.transpose();
    page->device[1].tick_error = 0;
    ASSERT_TRUE(wait_for([&] { return aligned().back; })) << panel().toStdString();
    ASSERT_TRUE(wait_for([&] { return aligned().in_place; }, 10000)) << aligned().hand[1].distance;
    QTest::keyClick(theatre().view(), Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }));
    ASSERT_TRUE(wait_for([&] { return theatre().session()->health().ticks > lost_at + 300; }));
    EXPECT_LT((tip() - start).norm(), 1e-3) << "it does not jump";
    abandon();
    expect_replays(newest_attempt().meta.id);
}

// Before, the attempt began and lost its device at once.
TEST_F(TouchWindow, AnAttemptWaitsAtTheRingWhileAHandThatNothingUsesTakesTheForceFromTheOther) {
    struct Usual {
        ServicesWithRig& of;
        ~Usual() {
            of.set_slot_choice("touch", {});
            of.set_begins_at_ring("touch", false);
        }
    };
    const Usual usual{services};
    services.set_slot_choice("touch", {-1, 1, -1});
    services.set_begins_at_ring("touch", true);
    page->device[0].calibration = 0x5002;  // needs a hand
    page->device[1].position[0] = 75;      // mm, away from the ring
    create_programme_and_trainee();
    ui::window_test::click(window, "briefing_A2");
    expect_page("briefing_page");
    ui::window_test::check(window, "mode_practice");
    ui::window_test::click(window, "start_attempt");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return cover().contains("Right hand: "); })) << cover().toStdString();
    EXPECT_TRUE(wait_for([&] { return cover().contains("no force, because the device has a fault"); }, 10000))
        << cover().toStdString();
    EXPECT_FALSE(cover().contains("Left hand: ")) << cover().toStdString();
    keep_picture(window, "36-no-force-at-the-ring");

    const auto readings = services.device_readings();
    ASSERT_TRUE(readings.has_value());
    const auto* const slot = ui::slot_of_hand(*readings, services.slot_choice("touch"), 1);
    ASSERT_NE(slot, nullptr);
    EXPECT_TRUE(slot->present) << "it answers";
    const SceneReach reach = scene_reach(theatre().session()->scene(), theatre().session()->snapshot());
    ASSERT_TRUE(reach[1].has_value());
    const Vector3 ring = place_to_begin(*slot->workspace, *reach[1], services.motion_scale("touch"));
    for (int axis = 0; axis < 3; ++axis) page->device[1].position[axis] = 1e3 * ring[axis];
    EXPECT_FALSE(wait_for([&] { return phase() != AttemptPhase::ready; }, 1000));

    page->device[0].calibration = 0x5000;
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }, 20000)) << cover().toStdString();
    EXPECT_TRUE(wait_for([&] { return theatre().session()->health().ticks > 300; }, 20000));
    EXPECT_EQ(phase(), AttemptPhase::running) << panel().toStdString();
    abandon();
}

TEST_F(TouchWindow, AnAttemptInWhichNoPartOfTheDeviceMovesAnythingIsOneByMouse) {
    struct Usual {
        ServicesWithRig& of;
        ~Usual() { of.set_slot_choice("touch", {}); }
    };
    const Usual usual{services};
    create_programme_and_trainee();
    EXPECT_EQ(services.device_in_use().device_class, DeviceClass::haptic);
    services.set_slot_choice("touch", {-1, -1, -1});
    EXPECT_EQ(services.device_in_use().device_class, DeviceClass::mouse_keyboard) << "before it is open";
    start("A2", true);
    EXPECT_FALSE(theatre().session()->health().force_felt[0]);
    EXPECT_EQ(services.device_in_use().kind, "touch") << "its settings are still those of the page";
    move_hands(10);
    abandon();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_EQ(attempt.meta.mode, AttemptMode::assessed);
    EXPECT_EQ(attempt.meta.device_class, DeviceClass::mouse_keyboard);
    EXPECT_EQ(attempt.meta.device, "mouse and keyboard");
    EXPECT_FALSE(attempt.meta.force_devices[0].has_value());
    ASSERT_TRUE(attempt.meta.rig_use.has_value());
    EXPECT_EQ(attempt.meta.rig_use->stated, 0) << "the rate of the device is not that of the mouse";
    expect_replays(attempt.meta.id);
    // B1 is assessed with haptic and tracked devices.
    emit window.context().attempt_wanted(QStringLiteral("B1"), true, 0, false);
    ASSERT_TRUE(wait_for([&] { return sees(window, "message_text"); }));
    EXPECT_TRUE(shown("message_text").contains("are not assessed")) << shown("message_text").toStdString();
    expect_page("debrief_page");
}

TEST_F(TouchWindow, ATaskOfTheScopeAloneIsOneByMouse) {
    create_programme_and_trainee();
    start("A1", true);
    EXPECT_EQ(services.device_in_use().device_class, DeviceClass::haptic) << "it is open, for other tasks";
    abandon();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_EQ(attempt.meta.mode, AttemptMode::assessed);
    EXPECT_EQ(attempt.meta.device_class, DeviceClass::mouse_keyboard);
    EXPECT_EQ(attempt.meta.device, "mouse and keyboard");
    ASSERT_TRUE(attempt.meta.rig_use.has_value());
    EXPECT_EQ(attempt.meta.rig_use->stated, 0);
    // The page of the task says so too; that of a task of the hands names the device.
    emit window.context().briefing_wanted(QStringLiteral("A1"));
    expect_page("briefing_page");
    EXPECT_TRUE(shown("mode_note").contains("You hold the scope with mouse and keyboard"))
        << shown("mode_note").toStdString();
    emit window.context().briefing_wanted(QStringLiteral("A2"));
    EXPECT_TRUE(shown("mode_note").contains("You work with: ")) << shown("mode_note").toStdString();
}

TEST_F(TouchWindow, LocksWhenTheDeviceRestsAndNotWhileAHandMovesIt) {
    create_programme_and_trainee();
    start("A2", false);
    constexpr int idle_ms = 1500;
    auto* idle = window.findChild<ui::IdleWatch*>();
    ASSERT_NE(idle, nullptr);
    idle->lock_after(idle_ms);
    QElapsedTimer clock;
    clock.start();
    ASSERT_TRUE(wait_for([&] {
        page->device[1].position[0] = std::fmod(page->device[1].position[0] + 1, 40);
        return sees(window, "unlock") || clock.elapsed() > 3 * idle_ms;
    }));
    EXPECT_FALSE(sees(window, "unlock")) << "no mouse, no key: the device is used";
    EXPECT_EQ(phase(), AttemptPhase::running);
    EXPECT_TRUE(wait_for([&] { return sees(window, "unlock"); })) << "nobody is there";
    EXPECT_NE(phase(), AttemptPhase::running);
}

}  // namespace
}  // namespace fulcrum::app::program_test
