// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts in the real window: their start, a faulty device, and the score of an interrupted attempt.
#include "app/live/performance.h"
#include "database/records/recorder.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/window_fixture.h"
#include "ui/shell/idle_watch.h"
#include "ui/theatre/key_map.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

// No time counts while the scene is prepared: the first tick follows the first picture, and movements before
// it do not count. If the trainee leaves during preparation, no attempt is stored.
TEST_F(Window, TimerStartsWhenTheSceneIsPreparedAndShown) {
    create_programme_and_trainee();
    const auto begin = [&] {
        click(window, "briefing_B1");
        expect_page("briefing_page");
        click(window, "start_attempt");
        expect_page("theatre_page");
    };
    begin();
    ASSERT_FALSE(theatre().view()->is_loaded());
    QTest::keyClick(theatre().view(), Qt::Key_Escape);
    expect_page("briefing_page");
    EXPECT_TRUE(database::Attempts(*services.store()).list(window.context().session()).empty());
    home();
    begin();
    TheatreView* view = theatre().view();
    QTest::keyPress(view, Qt::Key_D);  // hands move before the start
    int before = 0;
    while (theatre().session()->phase() != AttemptPhase::running) {
        ASSERT_EQ(theatre().session()->health().ticks, 0U);
        QTest::mouseMove(view, view->rect().center() + QPoint(before % 40, 0));
        QTest::qWait(10);
        ASSERT_LT(++before, 12000);
    }
    EXPECT_GT(before, 2);
    EXPECT_TRUE(view->is_loaded());
    EXPECT_GT(view->pictures(), 0);
    QTest::keyRelease(view, Qt::Key_D);
    QTest::qWait(400);
    EXPECT_FALSE(theatre().session()->display().moving_seen) << "movement before the start does not count";
    abandon();
    EXPECT_EQ(newest_attempt().state, AttemptState::abandoned);
}

// The three device faults (not a number, a jump of a metre, silence), each while a sphere is pressed.
TEST_F(Window, FaultyDeviceRampsForceToZeroPausesAndResumesAsPracticeFromTheSamePose) {
    services.spoils_devices = true;
    create_programme_and_trainee();
    start("A2", true);
    EXPECT_TRUE(theatre().session()->assessed());
    const auto mind = make_pointing_mind(theatre().session()->scene(), 2.5e-3);
    MouseHand hand(theatre(), *mind);
    SpoiltRig& rig = *services.rig;
    for (const auto fault :
         {SpoiltRig::Fault::not_a_number, SpoiltRig::Fault::jump, SpoiltRig::Fault::silence}) {
        // Wait until the hand presses and has stopped: it moves to the mouse's target even without its
        // device. Then all filters settle, because the displacement of the device is measured from this
        // pose; a target that was held long enough during that time is gone, and the next one is pressed.
        do {
            ASSERT_TRUE(hand.work_until(
                [&] {
                    const HandTargets& wanted = theatre().input()->targets();
                    return rig.sent(Hand::left) > 0.2 && rig.behind(Hand::left, wanted) < 2e-3 &&
                           rig.behind(Hand::right, wanted) < 2e-3;
                },
                150000));
            ASSERT_TRUE(wait_for([&] {
                const HandTargets& wanted = theatre().input()->targets();
                return rig.behind(Hand::left, wanted) < 1e-5 && rig.behind(Hand::right, wanted) < 1e-5;
            }));
        } while (rig.sent(Hand::left) < 0.15);
        rig.spoil(fault);
        ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::device_lost; }));
        ASSERT_TRUE(wait_for([&] { return rig.sent(Hand::left) == 0; }));
        ASSERT_TRUE(wait_for([&] { return sees(window, "theatre_panel"); }));
        const std::string message = theatre().session()->message().words();
        EXPECT_NE(message.find("The left hand's device"), std::string::npos) << message;
        EXPECT_NE(message.find(fault == SpoiltRig::Fault::silence ? "does not answer" : "impossible reading"),
                  std::string::npos)
            << message;
        keep_picture(window, "30-device-lost");
        if (fault == SpoiltRig::Fault::silence) rig.displace(0.012);  // displaced outwards by 12 mm
        rig.spoil(SpoiltRig::Fault::none);
        ASSERT_TRUE(wait_for([&] { return aligned().back; }));
        ASSERT_TRUE(wait_for([&] { return !sees(window, "theatre_panel"); }));
        if (fault == SpoiltRig::Fault::silence) {
            EXPECT_FALSE(aligned().in_place);
            EXPECT_NEAR(aligned().hand[0].distance, 0.012, 1e-4);
            keep_picture(window, "31-device-back-beside-its-ghost");
            QTest::keyClick(theatre().view(), Qt::Key_Return);
            QTest::qWait(150);
            EXPECT_EQ(theatre().session()->phase(), AttemptPhase::device_lost)
                << "at 12 mm the attempt must not resume";
            EXPECT_EQ(theatre().input()->active_hand(), Hand::left);
            turn_wheel(*theatre().view(),
                       3 * 120);  // three notches inwards: onto the ghost of the instrument
        }
        ASSERT_TRUE(wait_for([&] { return aligned().in_place; }));
        keep_picture(window, "32-device-in-place");
        QTest::keyClick(theatre().view(), Qt::Key_Return);
        ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }));
        // Whether something had failed the attempt before the fault is computed on a thread of its own.
        ASSERT_TRUE(wait_for([&] { return theatre().session()->became_practice(); }));
        EXPECT_FALSE(theatre().session()->assessed());
    }
    keep_picture(window, "33-goes-on-as-practice");
    abandon();
    EXPECT_TRUE(shown("debrief_about").contains("practice")) << shown("debrief_about").toStdString();

    // Nothing is lost, and the record contains every change.
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_EQ(attempt.meta.mode, AttemptMode::practice);
    EXPECT_FALSE(attempt.counting);
    EXPECT_EQ(attempt.state, AttemptState::abandoned);
    expect_replays(attempt.meta.id);
    const database::Trace trace =
        database::Attempts(*services.store()).read_trace(window.context().session(), attempt.meta.id);
    int lost = 0, back = 0;
    for (const Event& event : trace.events) {
        lost += event.kind == EventKind::device_lost ? 1 : 0;
        back += event.kind == EventKind::device_back ? 1 : 0;
    }
    EXPECT_EQ(lost, 3);
    EXPECT_EQ(back, 3);
    int ramps = 0;
    const auto force = [&](std::size_t i) {
        const auto& f = trace.samples[i].hand[0].device_force;
        return std::sqrt(1.0 * f[0] * f[0] + 1.0 * f[1] * f[1] + 1.0 * f[2] * f[2]) * sample_force_unit;
    };
    for (std::size_t i = 1; i < trace.samples.size(); ++i) {
        const bool held = (trace.samples[i].rig_flags & rig_device_lost) != 0;
        if (held) {  // falls by at most 300 N/s, never rises, and is zero after 20 ms (the time for 6 N)
            EXPECT_LE(force(i), force(i - 1) + 1e-3) << i;
            EXPECT_GE(force(i), force(i - 1) - 0.301 - 2e-3) << i;
            EXPECT_EQ(trace.samples[i].hand[0].tip[0], trace.samples[i - 1].hand[0].tip[0]);
        }
        // The last force before the fault: in the tick of the fault it may have fallen by 0.3 N already.
        if (held && (trace.samples[i - 1].rig_flags & rig_device_lost) == 0 && force(i - 1) > 0.1) ++ramps;
        if (i > 20 && held && (trace.samples[i - 20].rig_flags & rig_device_lost) != 0) {
            EXPECT_EQ(force(i), 0) << i;
        }
    }
    EXPECT_GE(ramps, 1) << "no force was pressed at the moment of any fault";
}

// After a crash an attempt is still marked as running; the next start marks it as interrupted, and the
// sign-in scores it.
TEST_F(Window, InterruptedAttemptIsScoredAtTheNextSignInAndShownOnHome) {
    create_programme_and_trainee();
    std::string whole, broken;
    for (const bool breaks : {false, true}) {
        const LoadedTask loaded = load_task_and_scene("A2");
        database::AttemptMeta meta =
            attempt_meta(loaded, 31, AttemptMode::assessed, DeviceClass::mouse_keyboard, "mouse and keyboard",
                         limits_for(loaded.task, loaded.scene, DeviceClass::mouse_keyboard));
        meta.person_id = window.context().session().person_id();
        database::Recorder recorder(services.store_path(false), window.context().session(), meta);
        (breaks ? broken : whole) = recorder.attempt_id();
        const auto rig = make_operator(OperatorLevel::novice, loaded.task, loaded.scene, 31);
        AttemptEngine engine(loaded.scene, loaded.task, 31);
        RecordingSink sink(recorder);
        run_headless(engine, *rig, sink, [](double simulated) { return simulated < 8; });
        sink.rethrow();
        if (breaks) {  // a force beyond the task's absolute limit of 4 N in the recorded part
            TickSample press = sink.record.samples.back();
            RigSample input = sink.record.inputs.back();
            for (int i = 0; i < 50; ++i) {
                press.tick = ++input.tick;
                press.hand[0].force[2] = 9000;
                press.hand[0].tissue = 0;
                recorder.append(input);
                recorder.append(press);
            }
        }
        recorder.flush();
    }  // without finish(): as after a power cut
    switch_user();
    window.start();  // the program starts again on the same store
    expect_page("sign_in_page");
    sign_in("tara", "tara's password");
    expect_page("home_page");
    ASSERT_TRUE(wait_for([&] { return sees(window, "interrupted_attempt"); }, 30000));
    QStringList lines;
    for (auto* button : window.findChildren<QAbstractButton*>("interrupted_attempt")) {
        if (button->isVisible()) lines << button->text();
    }
    keep_picture(window, "34-home-after-an-interruption");
    ASSERT_EQ(lines.size(), 2);
    EXPECT_TRUE(lines.join(' ').contains("does not count")) << lines.join('\n').toStdString();
    EXPECT_TRUE(lines.join(' ').contains("failed")) << lines.join('\n').toStdString();
    const database::Attempts attempts(*services.store());
    const database::Session& tara = window.context().session();
    EXPECT_FALSE(attempts.read(tara, whole).passed.has_value());
    EXPECT_FALSE(attempts.read(tara, whole).counting);
    EXPECT_EQ(attempts.read(tara, broken).passed, std::optional<bool>(false));
    EXPECT_TRUE(attempts.read(tara, broken).counting);
    EXPECT_TRUE(attempts.interrupted_without_score(tara).empty());
    click(window, "interrupted_attempt");
    wait_for_debrief();
}

/// The lock page is shown; afterwards what is behind it.
void unlock_as_tara(MainWindow& window) {
    type(window, "unlock_password", "tara's password");
    click(window, "unlock");
    EXPECT_TRUE(wait_for([&] { return !sees(window, "unlock"); }));
}

TEST_F(Window, TheTheatreHasTheKeyboardAfterUnlocking) {
    create_programme_and_trainee();
    auto* idle = window.findChild<IdleWatch*>();
    ASSERT_NE(idle, nullptr);
    const auto runs = [&] { return theatre().session()->phase() == AttemptPhase::running; };
    click(window, "briefing_A2");
    expect_page("briefing_page");
    click(window, "watch_demonstration");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for(runs));
    emit idle->lock();
    EXPECT_EQ(theatre().session()->phase(), AttemptPhase::paused);
    unlock_as_tara(window);
    ASSERT_TRUE(wait_for(runs)) << "the demonstration continues";
    ASSERT_NE(window.focusWidget(), nullptr);
    QTest::keyClick(window.focusWidget(), Qt::Key_Escape);
    expect_page("briefing_page");
    home();
    start("A2", false);
    emit idle->lock();
    unlock_as_tara(window);
    EXPECT_EQ(theatre().session()->phase(), AttemptPhase::paused);
    ASSERT_NE(window.focusWidget(), nullptr);
    EXPECT_EQ(window.focusWidget()->objectName().toStdString(), "panel_resume");
    QTest::keyClick(window.focusWidget(), Qt::Key_Space);
    ASSERT_TRUE(wait_for(runs));
    abandon();
}

TEST_F(Window, TheLockSaysOfWhatItClosedWhetherItIsStored) {
    create_programme_and_trainee();
    auto* idle = window.findChild<IdleWatch*>();
    ASSERT_NE(idle, nullptr);
    const auto phase = [&] { return theatre().session()->phase(); };
    const auto stored = [&] {
        return database::Attempts(*services.store()).list(window.context().session()).size();
    };
    const auto close_and_go_home = [&](const char* notice) {
        emit idle->close_attempt();
        EXPECT_EQ(shown("lock_notice").toStdString(), notice);
        EXPECT_FALSE(theatre().is_running());
        unlock_as_tara(window);
        ASSERT_NE(window.focusWidget(), nullptr);
        QTest::keyClick(window.focusWidget(), Qt::Key_Space);  // Home
        expect_page("home_page");
    };
    const auto open_briefing = [&] {
        click(window, "briefing_A2");
        expect_page("briefing_page");
        check(window, "mode_practice");
    };
    open_briefing();
    click(window, "start_attempt");
    ASSERT_EQ(window.current_page()->objectName().toStdString(), "theatre_page");
    emit idle->lock();  // the scene is still being built
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::ready; }));
    QTest::qWait(200);
    ASSERT_EQ(phase(), AttemptPhase::ready) << "nothing begins behind the lock";
    close_and_go_home("The attempt had not begun; nothing was stored.");
    open_briefing();
    click(window, "watch_demonstration");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }));
    emit idle->lock();
    close_and_go_home("The demonstration was closed; nothing was stored.");
    EXPECT_EQ(stored(), 0U);
    start("A2", false);
    emit idle->lock();
    close_and_go_home("The attempt was closed as interrupted and stored.");
    ASSERT_EQ(stored(), 1U);
    EXPECT_EQ(newest_attempt().state, AttemptState::interrupted);
}

TEST_F(Window, DemonstrationByAnExpertIsNotStored) {
    create_programme_and_trainee();
    click(window, "briefing_A2");
    expect_page("briefing_page");
    click(window, "watch_demonstration");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for(
        [&] { return theatre().session() != nullptr && theatre().session()->display().elapsed_s > 1.0; },
        60000));
    keep_picture(window, "35-demonstration");
    QTest::keyClick(theatre().view(), Qt::Key_Escape);
    expect_page("briefing_page");
    EXPECT_TRUE(database::Attempts(*services.store()).list(window.context().session()).empty());
}

// Who watches learns with the keys that the next attempt has.
TEST_F(Window, DemonstrationShowsAndHeedsTheKeysOfThePerson) {
    create_programme_and_trainee();
    const std::string person = window.context().session().person_id();
    KeyMap keys = KeyMap::standard(true);
    keys.assign(KeyAction::sound, Qt::Key_F9);
    keys.keep_for(person);
    click(window, "briefing_A2");
    expect_page("briefing_page");
    click(window, "watch_demonstration");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }));
    EXPECT_TRUE(find<QAbstractButton>(window, "theatre_sound")->text().contains("F9"));
    EXPECT_TRUE(sees(window, "theatre_help"));
    QTest::keyClick(theatre().view(), Qt::Key_F1);
    const QString help = theatre().view()->cover().join('\n');
    EXPECT_TRUE(help.contains("Right button\tcloses the jaws while held")) << help.toStdString();
    EXPECT_TRUE(help.contains("F9\tsound off, on")) << help.toStdString();
    QTest::keyClick(theatre().view(), Qt::Key_F1);
    EXPECT_TRUE(theatre().view()->cover().isEmpty());
    const bool sounds = services.sound_choice().wanted;
    QTest::keyClick(theatre().view(), Qt::Key_F2);
    EXPECT_EQ(services.sound_choice().wanted, sounds) << "no key of this person";
    QTest::keyClick(theatre().view(), Qt::Key_F9);
    EXPECT_NE(services.sound_choice().wanted, sounds);
    QTest::keyClick(theatre().view(), Qt::Key_F9);
    QTest::keyClick(theatre().view(), Qt::Key_Escape);
    expect_page("briefing_page");
    services.choose_device("two-mice");  // are opened by an attempt only
    click(window, "watch_demonstration");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }));
    EXPECT_FALSE(sees(window, "theatre_help"));
    QTest::keyClick(theatre().view(), Qt::Key_F1);
    EXPECT_TRUE(theatre().view()->cover().isEmpty()) << "these are not the keys of the next attempt";
    QTest::keyClick(theatre().view(), Qt::Key_Escape);
    expect_page("briefing_page");
    services.choose_device("mouse-keyboard");
    KeyMap::standard(false).keep_for(person);
}

}  // namespace
}  // namespace fulcrum::app::program_test
