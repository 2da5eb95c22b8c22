// SPDX-License-Identifier: Apache-2.0
// Game controllers through the real loading of a library: a fake of SDL 2 with every fault, and SDL 2 itself
// with a virtual controller.
#include "sim_core/controllers/game_controller.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "sim_core/controllers/sdl_library.h"
#include "sim_core/controllers/stick_response.h"
#include "sim_core/numerics/input_error.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_sdl.h"
#include "tests/support/built.h"
#include "tests/support/german_locale.h"

#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>

namespace fulcrum {
namespace {

using namespace controllers;
using test::FakePage;
using test::FakeSdlPage;
using test::until;
using test::Variable;

class GameControllers : public ::testing::Test {
  protected:
    GameControllers() {
        page->controller[0].plugged = 1;
        std::snprintf(page->controller[0].name, sizeof page->controller[0].name, "Left Pad");
        std::snprintf(page->controller[1].name, sizeof page->controller[1].name, "Right Pad");
    }
    ~GameControllers() override { EXPECT_EQ(page->misuse, 0U) << "calls that SDL does not allow"; }
    void press(SdlButton button, bool down = true) {
        const std::uint32_t bit = 1U << static_cast<unsigned>(button);
        page->controller[0].buttons =
            down ? page->controller[0].buttons | bit : page->controller[0].buttons & ~bit;
    }
    void settle() {
        const std::uint64_t now = page->updates;
        ASSERT_TRUE(until([&] { return page->updates > now + 3; }));
    }
    /// What opening says.
    static std::string refusal(const std::string& name = {}) {
        try {
            GameController::open(name);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }

    FakePage<FakeSdlPage> page{"FAKE_SDL_PAGE"};
    Variable library{"FULCRUM_LIBSDL2", test::fake_library("libSDL2.so")};
};

TEST_F(GameControllers, SticksAddUpTheTimeAtTheSpeedThatTheyAskFor) {
    const auto pad = GameController::open();
    EXPECT_EQ(pad->name(), "Left Pad");
    settle();
    pad->take();
    page->controller[0].axis[axis_left_x] = 32767;
    page->controller[0].axis[axis_right_y] = -32768;  // up, and one step further than down
    const std::int64_t begin = monotonic_ns();
    double right = 0, up = 0;
    while (monotonic_ns() < begin + 500'000'000) {
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
        const ControllerMotion motion = pad->take();
        EXPECT_TRUE(motion.connected);
        right += motion.across[0][0];
        up += motion.across[1][1];
        EXPECT_EQ(motion.across[0][1], 0);
        EXPECT_EQ(motion.across[1][0], 0);
    }
    const double lasted = 1e-9 * static_cast<double>(monotonic_ns() - begin);
    EXPECT_NEAR(right, lasted, 0.06) << "full speed";
    EXPECT_NEAR(up, right, 0.02);
    page->controller[0].axis[axis_left_x] = page->controller[0].axis[axis_right_y] = 0;
    settle();
    pad->take();
    settle();
    EXPECT_FALSE(pad->take().used) << "a hand that is not touched stays";
}

TEST_F(GameControllers, TheMiddleOfAStickIsNoMovementAndASmallTiltASmallOne) {
    EXPECT_EQ(stick_speed(0.15), 0);
    EXPECT_EQ(stick_speed(-1), 0);
    EXPECT_EQ(stick_speed(std::nan("")), 0);
    EXPECT_DOUBLE_EQ(stick_speed(1), 1);
    EXPECT_DOUBLE_EQ(stick_speed(1.4), 1) << "a diagonal of a square stick";
    EXPECT_LT(stick_speed(0.3), 0.05);
    for (double pushed = 0; pushed < 1; pushed += 0.01)
        EXPECT_LE(stick_speed(pushed), stick_speed(pushed + 0.01));
    const auto pad = GameController::open();
    settle();
    pad->take();
    page->controller[0].axis[axis_left_x] = 4600;  // 14 %: worn out
    settle();
    EXPECT_FALSE(pad->take().used);
}

TEST_F(GameControllers, ShoulderButtonsTurnAStickIntoInsertionAndRollAndPadAndButtonsDoTheRest) {
    const auto pad = GameController::open();
    settle();
    press(button_right_shoulder);
    page->controller[0].axis[axis_right_y] = -30000;
    page->controller[0].axis[axis_right_x] = 9000;
    settle();
    pad->take();
    settle();
    ControllerMotion motion = pad->take();
    EXPECT_GT(motion.along[1], 0) << "away from the person is in";
    EXPECT_EQ(motion.turned[1], 0) << "one at a time";
    EXPECT_EQ(motion.across[1][1], 0);
    page->controller[0].axis[axis_right_y] = 0;
    page->controller[0].axis[axis_right_x] = -30000;
    press(button_west);
    press(button_south);
    press(button_pad_left);
    page->controller[0].axis[axis_left_trigger] = 32767;
    settle();
    pad->take();
    settle();
    motion = pad->take();
    EXPECT_LT(motion.turned[1], 0);
    EXPECT_LT(motion.scope[0], 0);
    EXPECT_TRUE(motion.pedal[0] && !motion.pedal[1] && motion.exchange);
    EXPECT_EQ(motion.trigger[0], 1);
    EXPECT_EQ(motion.trigger[1], 0);
    press(button_north);
    settle();
    pad->take();
    settle();
    motion = pad->take();
    EXPECT_LT(motion.scope_turned, 0);
    EXPECT_EQ(motion.scope[0], 0);
    EXPECT_EQ(motion.latches[1], 0);
    for (int i = 0; i < 2; ++i) {
        press(button_right_stick);
        press(button_start);
        settle();
        press(button_right_stick, false);
        press(button_start, false);
        settle();
    }
    motion = pad->take();
    EXPECT_EQ(motion.latches[1], 2) << "presses are counted, however short";
    EXPECT_EQ(motion.starts, 2);
}

TEST_F(GameControllers, AnUnpluggedOneIsReportedAndFoundAgainByItsNameAndNothingStaysHeld) {
    const auto pad = GameController::open();
    settle();
    page->controller[0].axis[axis_left_x] = 32767;
    press(button_west);
    settle();
    page->controller[1].plugged = 1;  // another one is not this one
    page->controller[0].plugged = 0;
    ASSERT_TRUE(until([&] { return !pad->take().connected; }));
    const ControllerMotion gone = pad->take();
    EXPECT_FALSE(gone.pedal[0] || gone.used);
    EXPECT_EQ(gone.across[0][0], 0);
    EXPECT_NE(pad->trouble().words().find("Left Pad is not connected. Connect it again"), std::string::npos);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    EXPECT_EQ(page->controller[1].open, 0U);
    page->controller[0].plugged = 1;
    ASSERT_TRUE(until([&] { return pad->take().connected; }));
    settle();
    pad->take();
    settle();
    EXPECT_EQ(pad->take().across[0][0], 0) << "a stick that is still pushed moves nothing";
    EXPECT_NE(pad->trouble().words().find("not in its middle"), std::string::npos);
    page->controller[0].axis[axis_left_x] = 0;
    settle();
    EXPECT_TRUE(pad->trouble().empty());
    page->controller[0].axis[axis_left_x] = 32767;
    settle();
    EXPECT_GT(pad->take().across[0][0], 0);
}

TEST_F(GameControllers, RumbleIsRepeatedWhileItIsAskedForAndEndsWithTheAsker) {
    auto& seen = page->controller[0];
    const auto pad = GameController::open();
    settle();
    pad->rumble(0.5, 1);
    ASSERT_TRUE(until([&] { return seen.slow == 32768U && seen.fast == 65535U; }));
    EXPECT_GT(seen.rumble_ms, 50U);
    EXPECT_LT(seen.rumble_ms, 100U) << "ends soon where the program dies";
    ASSERT_TRUE(until([&] { return seen.rumbles >= 4U; })) << "pads that stop after 50 ms";
    ASSERT_TRUE(until([&] { return seen.slow == 0U && seen.fast == 0U; })) << "nobody asked again";
    pad->rumble(1, 0);
    ASSERT_TRUE(until([&] { return seen.slow > 0U; }));
    pad->rumble(0, 0);
    ASSERT_TRUE(until([&] { return seen.slow == 0U; }));
    pad->rumble(std::nan(""), 1e9);
    ASSERT_TRUE(until([&] { return seen.fast == 65535U; }));
    EXPECT_EQ(seen.slow, 0U);
    EXPECT_TRUE(pad->readings().rumbles);
    seen.rumble_fails = 1;
    pad->rumble(1, 1);
    ASSERT_TRUE(until([&] { return !pad->readings().rumbles; })) << "an account without the right to write";
    EXPECT_TRUE(pad->take().connected) << "works without";
}

TEST_F(GameControllers, ALibraryThatHangsIsADeviceThatDoesNotAnswerAndDoesNotStopTheProgram) {
    auto pad = GameController::open();
    settle();
    page->controller[0].axis[axis_left_x] = 32767;
    settle();
    page->hang = 1;
    ASSERT_TRUE(until([&] { return !pad->readings().connected; }));
    EXPECT_FALSE(pad->take().connected);
    EXPECT_NE(pad->trouble().words().find("does not answer"), std::string::npos);
    const std::int64_t begin = monotonic_ns();
    pad.reset();
    EXPECT_LT(monotonic_ns() - begin, 5'000'000'000);
    page->hang = 0;
    ASSERT_TRUE(until([&] { return page->ended == page->started; }));
}

TEST_F(GameControllers, EachReasonForWhichNoneOpensIsNamedWithWhatToDo) {
    EXPECT_NE(refusal("Other").find("none of the name Other is connected"), std::string::npos);
    page->controller[0].opens = 0;
    EXPECT_NE(refusal().find("Left Pad cannot be opened: permission denied"), std::string::npos) << refusal();
    page->controller[0].known = 0;
    EXPECT_NE(refusal().find("SDL does not know the sticks"), std::string::npos);
    EXPECT_NE(refusal().find("SDL_GAMECONTROLLERCONFIG"), std::string::npos);
    page->controller[0].plugged = 0;
    EXPECT_NE(refusal().find("none is connected"), std::string::npos);
    page->init_fails = 1;
    EXPECT_NE(refusal().find("does not start: no udev"), std::string::npos);
    EXPECT_EQ(GameController::look().failure, "no udev");
    const auto with_library = [](const char* file) {
        const Variable named("FULCRUM_LIBSDL2", file);
        return refusal();
    };
    EXPECT_NE(with_library("/nowhere/libSDL2.so").find("is not installed (/nowhere/libSDL2.so"),
              std::string::npos);
    const std::string old = with_library(test::fake_library("libSDL2_old.so").c_str());
    EXPECT_NE(old.find("lacks a function that Fulcrum needs (SDL_GameControllerRumble)"), std::string::npos)
        << old;
    EXPECT_NE(old.find("libsdl2-2.0-0"), std::string::npos);
    setenv("FULCRUM_LIBSDL2", test::fake_library("libSDL2.so").c_str(), 1);
}

TEST_F(GameControllers, AreListedWhileOneIsReadAndWhileNoneIs) {
    page->controller[1].plugged = 1;
    page->controller[1].known = 0;
    const auto expect_both = [] {
        const ControllerLook look = GameController::look();
        ASSERT_EQ(look.connected.size(), 2U);
        EXPECT_EQ(look.connected[0].name, "Left Pad");
        EXPECT_TRUE(look.connected[0].known);
        EXPECT_FALSE(look.connected[1].known);
    };
    expect_both();
    {
        const auto pad = GameController::open("Left Pad");
        expect_both();
        page->controller[1].plugged = 0;
        ASSERT_TRUE(until([] { return GameController::look().connected.size() == 1; }));
    }
    EXPECT_EQ(page->started, page->ended);
}

TEST_F(GameControllers, MeasuresItsRateInAGermanProgram) {
    const test::GermanLocale german;
    ASSERT_TRUE(german.in_force()) << "localedef cannot make de_DE: install the package locales";
    const auto pad = GameController::open();
    ASSERT_TRUE(until([&] { return pad->readings().rate > 0; }));
    const ControllerReadings now = pad->readings();
    EXPECT_GT(now.rate, 100);
    EXPECT_LT(now.rate, 260);
    EXPECT_GT(now.worst_gap, 0.003);
}

/// SDL 2 itself, loaded as the program loads it, with a controller that exists in it alone.
TEST(GameControllerOfSdl, AVirtualControllerIsReadAndRumbles) {
    void* const library = dlopen("libSDL2-2.0.so.0", RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << dlerror();
    const auto function = [library](const char* name) { return dlsym(library, name); };
    const auto init = reinterpret_cast<decltype(&SDL_InitSubSystem)>(function("SDL_InitSubSystem"));
    const auto quit = reinterpret_cast<decltype(&SDL_QuitSubSystem)>(function("SDL_QuitSubSystem"));
    const auto attach =
        reinterpret_cast<decltype(&SDL_JoystickAttachVirtualEx)>(function("SDL_JoystickAttachVirtualEx"));
    const auto detach =
        reinterpret_cast<decltype(&SDL_JoystickDetachVirtual)>(function("SDL_JoystickDetachVirtual"));
    const auto open = reinterpret_cast<decltype(&SDL_JoystickOpen)>(function("SDL_JoystickOpen"));
    const auto set_axis =
        reinterpret_cast<decltype(&SDL_JoystickSetVirtualAxis)>(function("SDL_JoystickSetVirtualAxis"));
    ASSERT_NE(attach, nullptr) << "this SDL 2 has no virtual controllers: install one from 2.24 on";
    ASSERT_EQ(init(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER), 0);
    static std::atomic<int> slow{-1};
    SDL_VirtualJoystickDesc description{};
    description.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    description.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
    description.naxes = 6;
    description.nbuttons = 15;
    description.name = "Virtual Pad";
    description.Rumble = [](void*, Uint16 low, Uint16) {
        slow = low;
        return 0;
    };
    const int index = attach(&description);
    ASSERT_GE(index, 0);
    SDL_Joystick* const virtual_pad = open(index);
    ASSERT_NE(virtual_pad, nullptr);
    {
        const auto pad = GameController::open("Virtual Pad");
        EXPECT_EQ(pad->name(), "Virtual Pad");
        ASSERT_TRUE(until([&] { return pad->readings().begun[0]; }));
        set_axis(virtual_pad, SDL_CONTROLLER_AXIS_LEFTX, 32767);
        ASSERT_TRUE(until([&] { return pad->take().across[0][0] > 0; }));
        pad->rumble(1, 0);
        ASSERT_TRUE(until([&] { return slow == 65535; }));
        pad->rumble(0, 0);
        ASSERT_TRUE(until([&] { return slow == 0; }));
        ASSERT_EQ(detach(index), 0);
        ASSERT_TRUE(until([&] { return !pad->take().connected; }));
    }
    quit(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER);
}

}  // namespace
}  // namespace fulcrum
