// SPDX-License-Identifier: Apache-2.0
// The functions and numbers of SDL 2 that are declared here are those of its header.
#include <gtest/gtest.h>

#include <type_traits>

#include "sim_core/controllers/sdl_library.h"

#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>

namespace fulcrum::controllers {
namespace {

/// A parameter or result as the machine passes it: pointers, enums and integers by their size and sign.
template <typename T>
struct Passed {
    template <typename U>
    static auto integer() {
        if constexpr (std::is_enum_v<U>) {
            return std::make_signed_t<std::underlying_type_t<U>>{};
        } else {
            return U{};
        }
    }
    static auto make() {
        if constexpr (std::is_void_v<T>) {
            return static_cast<char*>(nullptr);  // of no interest: nothing is read
        } else if constexpr (std::is_pointer_v<T>) {
            return static_cast<const void*>(nullptr);
        } else {
            return integer<T>();
        }
    }
    using Type = decltype(make());
};

template <typename Ours, typename Theirs>
struct Same : std::false_type {};
template <typename R1, typename... A1, typename R2, typename... A2>
struct Same<R1 (*)(A1...), R2 (*)(A2...)> {
    static constexpr bool value = [] {
        if constexpr (sizeof...(A1) != sizeof...(A2)) {
            return false;
        } else {
            return std::is_same_v<typename Passed<R1>::Type, typename Passed<R2>::Type> &&
                   (std::is_same_v<typename Passed<A1>::Type, typename Passed<A2>::Type> && ...);
        }
    }();
};

TEST(SdlLibrary, DeclaresTheFunctionsOfTheHeader) {
#define SAME(ours, theirs) \
    EXPECT_TRUE((Same<decltype(SdlLibrary::ours), decltype(&theirs)>::value)) << #theirs
    SAME(set_hint, SDL_SetHint);
    SAME(init, SDL_InitSubSystem);
    SAME(quit, SDL_QuitSubSystem);
    SAME(error, SDL_GetError);
    SAME(joystick_events, SDL_JoystickEventState);
    SAME(joystick_count, SDL_NumJoysticks);
    SAME(joystick_name, SDL_JoystickNameForIndex);
    SAME(is_controller, SDL_IsGameController);
    SAME(controller_name, SDL_GameControllerNameForIndex);
    SAME(open, SDL_GameControllerOpen);
    SAME(close, SDL_GameControllerClose);
    SAME(attached, SDL_GameControllerGetAttached);
    SAME(update, SDL_GameControllerUpdate);
    SAME(axis, SDL_GameControllerGetAxis);
    SAME(button, SDL_GameControllerGetButton);
    SAME(rumble, SDL_GameControllerRumble);
#undef SAME
    EXPECT_FALSE((Same<int (*)(std::uint16_t), int (*)(std::int16_t)>::value)) << "the comparison itself";
}

TEST(SdlLibrary, KnowsTheNumbersOfTheHeader) {
    EXPECT_EQ(sdl_init_joystick, SDL_INIT_JOYSTICK);
    EXPECT_EQ(sdl_init_controller, SDL_INIT_GAMECONTROLLER);
    EXPECT_EQ(sdl_ignore, SDL_IGNORE);
    const int axes[][2] = {{axis_left_x, SDL_CONTROLLER_AXIS_LEFTX},
                           {axis_left_y, SDL_CONTROLLER_AXIS_LEFTY},
                           {axis_right_x, SDL_CONTROLLER_AXIS_RIGHTX},
                           {axis_right_y, SDL_CONTROLLER_AXIS_RIGHTY},
                           {axis_left_trigger, SDL_CONTROLLER_AXIS_TRIGGERLEFT},
                           {axis_right_trigger, SDL_CONTROLLER_AXIS_TRIGGERRIGHT}};
    for (const auto& one : axes) EXPECT_EQ(one[0], one[1]);
    const int buttons[][2] = {{button_south, SDL_CONTROLLER_BUTTON_A},
                              {button_east, SDL_CONTROLLER_BUTTON_B},
                              {button_west, SDL_CONTROLLER_BUTTON_X},
                              {button_north, SDL_CONTROLLER_BUTTON_Y},
                              {button_back, SDL_CONTROLLER_BUTTON_BACK},
                              {button_guide, SDL_CONTROLLER_BUTTON_GUIDE},
                              {button_start, SDL_CONTROLLER_BUTTON_START},
                              {button_left_stick, SDL_CONTROLLER_BUTTON_LEFTSTICK},
                              {button_right_stick, SDL_CONTROLLER_BUTTON_RIGHTSTICK},
                              {button_left_shoulder, SDL_CONTROLLER_BUTTON_LEFTSHOULDER},
                              {button_right_shoulder, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER},
                              {button_pad_up, SDL_CONTROLLER_BUTTON_DPAD_UP},
                              {button_pad_down, SDL_CONTROLLER_BUTTON_DPAD_DOWN},
                              {button_pad_left, SDL_CONTROLLER_BUTTON_DPAD_LEFT},
                              {button_pad_right, SDL_CONTROLLER_BUTTON_DPAD_RIGHT}};
    for (const auto& one : buttons) EXPECT_EQ(one[0], one[1]);
    EXPECT_STREQ(SDL_HINT_NO_SIGNAL_HANDLERS, "SDL_NO_SIGNAL_HANDLERS");
    EXPECT_STREQ(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS");
    EXPECT_STREQ(SDL_HINT_GAMECONTROLLER_USE_BUTTON_LABELS, "SDL_GAMECONTROLLER_USE_BUTTON_LABELS");
}

}  // namespace
}  // namespace fulcrum::controllers
