// SPDX-License-Identifier: GPL-3.0-or-later
// The first steps of the theatre, done to their end in B3, which asks for all of them, with each kind of
// device: mouse and keyboard, two mice, a game controller, and the fakes of what fulcrum-hapticd reads. What
// a device cannot do is done with the keys that its lines name.
#include <gtest/gtest.h>

#include <QSettings>

#include "tests/app/taught_devices.h"
#include "tests/support/fake_trainer.h"

namespace fulcrum::app::program_test {
namespace {

using ui::HandDeed;

class FirstStepsWith : public ::testing::WithParamInterface<std::string>, public TaughtWindow {
  protected:
    FirstStepsWith() : TaughtWindow(make_taught(GetParam())) {}
};

TEST_P(FirstStepsWith, AreDoneToTheirEnd) {
    if (GetParam() == "Trainer" && !fulcrum::test::FakeTrainer::is_possible())
        GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    QSettings().clear();
    create_programme_and_trainee();
    start("B3", false);
    for (const HandDeed deed : {HandDeed::moved, HandDeed::inserted, HandDeed::rolled, HandDeed::jaws_closed,
                                HandDeed::pedal, HandDeed::exchanged, HandDeed::scope_moved})
        EXPECT_TRUE(ui::needed_deeds(theatre().session()->scene(), false).test(ui::bit_of(deed)));
    ASSERT_NO_FATAL_FAILURE(do_first_steps());
    EXPECT_EQ(QSettings().allKeys().filter("learnt/").size(), 1);
    abandon();
    EXPECT_EQ(newest_attempt().state, AttemptState::abandoned);
}

INSTANTIATE_TEST_SUITE_P(Devices, FirstStepsWith,
                         ::testing::Values("Mouse", "TwoMice", "Controller", "Touch", "ForceDimension",
                                           "Haply", "SpaceMouse", "Tracker", "Trainer", "Joystick"),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace fulcrum::app::program_test
