// SPDX-License-Identifier: GPL-3.0-or-later
// A1 through the window, by mouse and keys: the mouse moves the scope, keys turn light post and camera head.
// With FULCRUM_WHOLE_CAMERA set, to its end. FULCRUM_PICTURES=FOLDER stores the screens.
#include "assessment/operators/operator.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/window_fixture.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

class CameraJourney : public Window {
  protected:
    const TaskDisplay& display() { return theatre().session()->display(); }
    bool in_theatre() {
        return window.current_page()->objectName() == QLatin1String("theatre_page") &&
               theatre().session() != nullptr && theatre().session()->phase() == AttemptPhase::running;
    }
    void picture(const QString& name) {
        const QString kept = qEnvironmentVariable("FULCRUM_PICTURES");
        if (!kept.isEmpty()) window.grab().save(QDir(kept).filePath(name + QStringLiteral(".png")));
    }
};

TEST_F(CameraJourney, MouseAndKeysFrameTargets) {
    constexpr int patience = 120000;  // ms; long enough for a slow machine
    create_programme_and_trainee();
    start("A1", false);
    const auto mind =
        make_operator(OperatorLevel::expert, theatre().session()->task(), theatre().session()->scene(), 7);
    MouseHand hand(theatre(), *mind);
    EXPECT_TRUE(
        hand.work_until([&] { return display().framing_faults != 0 && display().moving_seen; }, patience));
    picture(QStringLiteral("camera-on-the-way"));
    EXPECT_TRUE(hand.work_until([&] { return display().hold_progress > 0.3; }, patience));
    picture(QStringLiteral("camera-framed"));
    EXPECT_TRUE(hand.work_until([&] { return display().active_target >= 2; }, patience));
    ASSERT_TRUE(in_theatre());
    EXPECT_GE(display().active_target, 2);
    if (qEnvironmentVariableIsSet("FULCRUM_WHOLE_CAMERA")) {
        EXPECT_TRUE(hand.work_until([&] { return display().goal == 1 && display().goal_progress > 0.2; },
                                    4 * patience));
        picture(QStringLiteral("camera-tip"));
        EXPECT_TRUE(hand.work_until([] { return false; }, 3 * patience));
        wait_for_debrief();
        picture(QStringLiteral("camera-debrief"));
        EXPECT_EQ(newest_attempt().state, AttemptState::completed);
    } else {
        abandon();
    }
    EXPECT_GT(hand.events(), 50);
    expect_replays(newest_attempt().meta.id);
}

}  // namespace
}  // namespace fulcrum::app::program_test
