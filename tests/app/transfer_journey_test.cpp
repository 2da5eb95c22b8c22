// SPDX-License-Identifier: GPL-3.0-or-later
// A3 through the window, by mouse and keys: rings are handed over in real time. With FULCRUM_WHOLE_TRANSFER
// all six go there and back (minutes). FULCRUM_PICTURES=FOLDER stores the screens.
#include "assessment/operators/operator.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/window_fixture.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

class TransferJourney : public Window {
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

TEST_F(TransferJourney, MouseAndKeysHandARingOver) {
    constexpr int patience = 180000;  // ms; long enough for a slow machine
    create_programme_and_trainee();
    start("A3", false);
    const auto mind =
        make_operator(OperatorLevel::expert, theatre().session()->task(), theatre().session()->scene(), 7);
    MouseHand hand(theatre(), *mind);
    EXPECT_TRUE(hand.work_until([&] { return display().rings_placed != 0; }, patience));
    ASSERT_TRUE(in_theatre());
    EXPECT_NE(display().rings_placed, 0U);
    picture(QStringLiteral("transfer-one-ring"));
    if (qEnvironmentVariableIsSet("FULCRUM_WHOLE_TRANSFER")) {
        EXPECT_TRUE(hand.work_until([&] { return display().goal == 1 && display().rings_placed != 0; },
                                    3 * patience));
        picture(QStringLiteral("transfer-way-back"));
        EXPECT_TRUE(hand.work_until([] { return false; }, 3 * patience));
        wait_for_debrief();
        picture(QStringLiteral("transfer-debrief"));
        EXPECT_EQ(newest_attempt().state, AttemptState::completed);
    } else {
        abandon();
    }
    EXPECT_GT(hand.events(), 100);
    expect_replays(newest_attempt().meta.id);
}

}  // namespace
}  // namespace fulcrum::app::program_test
