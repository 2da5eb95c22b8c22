// SPDX-License-Identifier: GPL-3.0-or-later
// How an attempt begins in the real window, what a spoilt device does to it, and what an interrupted one
// comes to.
#include "app/live/performance.h"
#include "database/records/recorder.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/window_fixture.h"

namespace fulcrum::app::test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::test;

// However long the scene takes to prepare, nothing is on the clock meanwhile: the first tick comes after the
// first picture, and hands that moved before it are no movement of the attempt. Who leaves while it prepares
// leaves no attempt behind.
TEST_F(Window, TheClockBeginsWhenTheSceneIsPreparedAndShown) {
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
    QTest::keyPress(view, Qt::Key_D);  // impatient hands
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
    EXPECT_FALSE(theatre().session()->display().moving_seen)
        << "what moved before the beginning counts for nothing";
    abandon();
    EXPECT_EQ(newest_attempt().state, "abandoned");
}

// Must show 7 through the real window: no number, a jump of a metre, silence, each while a sphere is pressed.
TEST_F(Window, ASpoiltDeviceLosesItsForceByARampPausesAndGoesOnAsPracticeFromWhereItWas) {
    services.spoils_devices = true;
    create_programme_and_trainee();
    start("A2", true);
    EXPECT_TRUE(theatre().session()->assessed());
    const auto mind = make_pointing_mind(theatre().session()->scene(), 2.5e-3);
    MouseHand hand(theatre(), *mind);
    SpoiltRig& rig = *services.rig;
    for (const auto fault :
         {SpoiltRig::Fault::not_a_number, SpoiltRig::Fault::jump, SpoiltRig::Fault::silence}) {
        // Pressing, and no longer on the way anywhere: a hand goes to where the mouse was, device or no
        // device.
        ASSERT_TRUE(hand.work_until(
            [&] {
                const HandTargets& wanted = theatre().input()->targets();
                return rig.sent(Hand::left) > 0.6 && rig.behind(Hand::left, wanted) < 2e-3 &&
                       rig.behind(Hand::right, wanted) < 2e-3;
            },
            150000));
        // At rest to the last of its filters: where the device is put down is measured against it.
        ASSERT_TRUE(wait_for([&] {
            const HandTargets& wanted = theatre().input()->targets();
            return rig.behind(Hand::left, wanted) < 1e-5 && rig.behind(Hand::right, wanted) < 1e-5;
        }));
        rig.spoil(fault);
        ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::device_lost; }));
        ASSERT_TRUE(wait_for([&] { return rig.sent(Hand::left) == 0; }));
        ASSERT_TRUE(wait_for([&] { return sees(window, "theatre_panel"); }));
        const std::string message = theatre().session()->message();
        EXPECT_NE(message.find("The left hand's device"), std::string::npos) << message;
        EXPECT_NE(message.find(fault == SpoiltRig::Fault::silence ? "does not answer" : "impossible reading"),
                  std::string::npos)
            << message;
        keep_picture(window, "30-device-lost");
        if (fault == SpoiltRig::Fault::silence) rig.displace(0.012);  // put down 12 mm further out
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
                << "12 mm away nothing takes hold";
            EXPECT_EQ(theatre().input()->active_hand(), Hand::left);
            turn_wheel(*theatre().view(), 3 * 120);  // three notches further in: onto its ghost
        }
        ASSERT_TRUE(wait_for([&] { return aligned().in_place; }));
        keep_picture(window, "32-device-in-place");
        QTest::keyClick(theatre().view(), Qt::Key_Return);
        ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }));
        EXPECT_FALSE(theatre().session()->assessed());
        EXPECT_TRUE(theatre().session()->became_practice());
    }
    keep_picture(window, "33-goes-on-as-practice");
    abandon();
    EXPECT_TRUE(shown("debrief_about").contains("practice")) << shown("debrief_about").toStdString();

    // Nothing is lost, and the record says all of it.
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_EQ(attempt.meta.mode, "practice");
    EXPECT_FALSE(attempt.counting);
    EXPECT_EQ(attempt.state, "abandoned");
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
        if (held) {  // 300 N/s at most, never up again, and zero after the 20 ms that 6 N may take
            EXPECT_LE(force(i), force(i - 1) + 1e-3) << i;
            EXPECT_GE(force(i), force(i - 1) - 0.301 - 2e-3) << i;
            EXPECT_EQ(trace.samples[i].hand[0].tip[0], trace.samples[i - 1].hand[0].tip[0]);
        }
        if (held && (trace.samples[i - 1].rig_flags & rig_device_lost) == 0 && force(i) > 0.1) ++ramps;
        if (i > 20 && held && (trace.samples[i - 20].rig_flags & rig_device_lost) != 0) {
            EXPECT_EQ(force(i), 0) << i;
        }
    }
    EXPECT_GE(ramps, 1) << "a press that ends of itself in the moment of the fault leaves nothing to ramp";
}

// What a crash leaves behind: running in the store, interrupted when it is opened next, scored at the
// sign-in.
TEST_F(Window, WhatWasInterruptedIsScoredAtTheNextSignInAndShownOnHome) {
    create_programme_and_trainee();
    std::string whole, broken;
    for (const bool breaks : {false, true}) {
        const LoadedTask loaded = load_task_and_scene("A2");
        const auto benchmark = benchmark_in_force("A2");
        database::AttemptMeta meta = attempt_meta(loaded, 31, "assessed", "mouse-keyboard",
                                                  "mouse and keyboard", benchmark ? &*benchmark : nullptr);
        meta.person_id = window.context().session().person_id();
        database::Recorder recorder(services.store_path(false), window.context().session(), meta);
        (breaks ? broken : whole) = recorder.attempt_id();
        const auto rig = make_operator("novice", loaded.task, loaded.scene, 31);
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
    }  // without finish(): as if the power had gone
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

TEST_F(Window, AnExpertDemonstratesAndLeavesNothing) {
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

}  // namespace
}  // namespace fulcrum::app::test
