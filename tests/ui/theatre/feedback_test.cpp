// SPDX-License-Identifier: GPL-3.0-or-later
// What of an attempt is felt and heard.
#include "ui/theatre/feedback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/ui/screens.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::ui {
namespace {

TEST(FeltAndHeard, RumbleGrowsWithTheForceAndIsStrongBeyondTheLimit) {
    EXPECT_EQ(rumble_of(0, 3).slow, 0);
    EXPECT_EQ(rumble_of(std::nan(""), 3).slow, 0);
    double before = 0;
    for (double force = 0.06; force <= 3; force += 0.1) {
        const RumbleStrength now = rumble_of(force, 3);
        EXPECT_GT(now.slow, before);
        EXPECT_LE(now.slow, 0.5);
        EXPECT_EQ(now.fast, 0) << force;
        before = now.slow;
    }
    EXPECT_EQ(rumble_of(3.1, 3).fast, 1);
    EXPECT_EQ(rumble_of(100, 0).fast, 0) << "no limit, nothing to exceed";
}

class Heard : public ::testing::Test {
  protected:
    const SoundState& at(double left, double right, double limit = 3) {
        display.force[0] = static_cast<float>(left);
        display.force[1] = static_cast<float>(right);
        display.force_limit[0] = display.force_limit[1] = static_cast<float>(limit);
        feedback.follow(&display, &world);
        return feedback.sound();
    }
    TaskDisplay display;
    WorldSnapshot world;
    Feedback feedback;
};

TEST_F(Heard, AContactIsCountedOnceWithItsStrengthUntilTheHandLetsGo) {
    EXPECT_EQ(at(0.04, 0).contacts[0], 0U);
    EXPECT_EQ(at(0.5, 0).contacts[0], 1U);
    EXPECT_NEAR(feedback.sound().strength[0], 0.25, 1e-6);
    EXPECT_EQ(feedback.sound().hard[0], 0U) << "tissue with a limit";
    EXPECT_EQ(at(1.5, 0).contacts[0], 1U) << "still the same";
    EXPECT_EQ(at(0.03, 0).contacts[0], 1U) << "hardly lifted";
    EXPECT_EQ(at(0.06, 0).contacts[0], 1U);
    at(0, 0);
    EXPECT_EQ(at(9, 0, 0).contacts[0], 2U);
    EXPECT_EQ(feedback.sound().strength[0], 1);
    EXPECT_EQ(feedback.sound().hard[0], 1U);
    EXPECT_EQ(feedback.sound().contacts[1], 0U);
}

TEST_F(Heard, ExcessIsTheShareBeyondTheLimitAndNothingWithoutOne) {
    EXPECT_EQ(at(2.9, 0).excess[0], 0);
    EXPECT_NEAR(at(4.5, 0).excess[0], 0.5, 1e-6);
    EXPECT_EQ(at(100, 0, 0).excess[0], 0);
    EXPECT_EQ(at(std::nan(""), std::numeric_limits<double>::infinity()).excess[0], 0);
}

TEST_F(Heard, EnergyAndFastBleedingAreHeardSuctionAndOozingAreNot) {
    FieldView field;
    field.tools[0].active = field.tools[1].active = true;
    field.tools[0].kind = InstrumentKind::suction;
    field.tools[1].kind = InstrumentKind::hook;
    field.outlets.resize(2);
    field.outlets[0].flow = field.outlets[1].flow = 4e-6 / 60;
    world.field.push_back(field);
    at(0, 0);
    EXPECT_EQ(feedback.sound().energy[0], 0U);
    EXPECT_EQ(feedback.sound().energy[1], 1U);
    EXPECT_EQ(feedback.sound().bleeding, 0U) << "8 mL/min";
    world.field[0].outlets[1].flow = 7e-6 / 60;
    EXPECT_EQ(at(0, 0).bleeding, 1U) << "11 mL/min";
}

TEST_F(Heard, APauseIsSilentAndWhatIsTouchedDuringItIsNoNewContact) {
    at(4.5, 0);
    feedback.follow(nullptr, nullptr);
    EXPECT_EQ(feedback.sound().excess[0], 0);
    EXPECT_EQ(feedback.rumble().slow, 0);
    EXPECT_EQ(at(4.5, 0).contacts[0], 1U);
    EXPECT_EQ(feedback.rumble().fast, 1);
}

}  // namespace

namespace window_test {
namespace {

using TheatreHeard = Screens;

TEST_F(TheatreHeard, TooMuchForceIsHeardDuringAnAttemptAndNothingInAPause) {
    open({1024, 768});
    sign_in(Role::trainee);
    theatre([&] {
        auto* page = static_cast<TheatrePage*>(window->current_page());
        ASSERT_TRUE(
            wait_for([&] { return services.heard.contacts[0] == 1 && services.heard.contacts[1] == 1; }));
        EXPECT_EQ(services.heard.excess[0], 0);
        services.control.press_hard = true;
        ASSERT_TRUE(wait_for([&] { return services.heard.excess[0] > 0; }));
        EXPECT_NEAR(services.heard.excess[0], 1.25, 1e-6) << "9 N where 4 N are allowed";
        EXPECT_EQ(services.heard.excess[1], 0);
        page->pause();
        ASSERT_TRUE(wait_for([&] { return services.heard.excess[0] == 0; }));
        EXPECT_EQ(services.heard.contacts[0], 1U);
        click(*window, "panel_resume");
        ASSERT_TRUE(wait_for([&] { return services.heard.excess[0] > 0; }));
    });
    EXPECT_EQ(services.heard.excess[0], 0) << "the attempt was left";
}

}  // namespace
}  // namespace window_test
}  // namespace fulcrum::ui
