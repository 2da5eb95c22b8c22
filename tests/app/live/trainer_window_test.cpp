// SPDX-License-Identifier: GPL-3.0-or-later
// The window with a box trainer, whose serial port a thread of the test serves: damaged lines, and pulling
// its plug, pause the attempt, say what to do and lose nothing.
#include <gtest/gtest.h>

#include "tests/app/program_path.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/fake_trainer.h"

namespace fulcrum::app::program_test {
namespace {

using fulcrum::test::FakeTrainer;
using ui::window_test::keep_picture;
using ui::window_test::wait_for;

/// Before the services are made.
struct PluggedTrainer {
    static std::string daemon() {
        const std::string program = program_path();
        return program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd";
    }
    FakeTrainer trainer{"LR"};
    fulcrum::test::Variable device{"FULCRUM_DEVICE", trainer.specification()};
    fulcrum::test::Variable program{"FULCRUM_HAPTICD", daemon()};
};

class TrainerWindow : public PluggedTrainer, public Window {
  protected:
    bool says(const char* words) {
        return ui::window_test::find<QLabel>(window, "panel_text")->text().contains(QLatin1String(words));
    }
    ui::AttemptPhase phase() { return theatre().session()->phase(); }
};

TEST_F(TrainerWindow, AFaultPausesTheAttemptUntilItHasPassedAndNothingIsLost) {
    if (!FakeTrainer::is_possible()) GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    create_programme_and_trainee();
    start("A2", false);
    const double begun = theatre().session()->snapshot().tools[1].tip.x();
    trainer.move('R', Vector3(0.02, 0, 0.24));
    ASSERT_TRUE(wait_for([&] {
        return std::abs(theatre().session()->snapshot().tools[1].tip.x() - begun) > 2e-3;
    })) << "the trainer moves the instrument";
    for (const bool unplugged : {false, true}) {
        if (unplugged)
            trainer.unplug();
        else
            trainer.mode = FakeTrainer::Mode::wrong_checksum;
        ASSERT_TRUE(wait_for([&] { return phase() == ui::AttemptPhase::device_lost; })) << unplugged;
        if (!unplugged)
            EXPECT_TRUE(wait_for([&] { return says("arrive damaged. Use a shorter cable"); }));
        else
            keep_picture(window, "37-trainer-unplugged");
        trainer.mode = FakeTrainer::Mode::good;
        if (unplugged) trainer.plug();
        ASSERT_TRUE(wait_for([&] { return aligned().back; })) << unplugged;
        ASSERT_TRUE(wait_for([&] { return aligned().in_place; }));
        QTest::keyClick(theatre().view(), Qt::Key_Return);
        ASSERT_TRUE(wait_for([&] { return phase() == ui::AttemptPhase::running; }));
    }
    abandon();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_EQ(attempt.meta.device, "Box");
    EXPECT_EQ(attempt.meta.device_class, DeviceClass::tracked);
    expect_replays(attempt.meta.id);
}

}  // namespace
}  // namespace fulcrum::app::program_test
