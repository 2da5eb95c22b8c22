// SPDX-License-Identifier: Apache-2.0
#include "sim_core/controllers/sdl_library.h"

#include "sim_core/numerics/sentence.h"

namespace fulcrum::controllers {

LibraryLook SdlLibrary::load() {
    return load_run_time_library(
        "FULCRUM_LIBSDL2", {"libSDL2-2.0.so.0", "libSDL2-2.0.so", "libSDL2.so"},
        {symbol("SDL_SetHint", set_hint), symbol("SDL_InitSubSystem", init),
         symbol("SDL_QuitSubSystem", quit), symbol("SDL_GetError", error),
         symbol("SDL_JoystickEventState", joystick_events), symbol("SDL_NumJoysticks", joystick_count),
         symbol("SDL_JoystickNameForIndex", joystick_name), symbol("SDL_IsGameController", is_controller),
         symbol("SDL_GameControllerNameForIndex", controller_name), symbol("SDL_GameControllerOpen", open),
         symbol("SDL_GameControllerClose", close), symbol("SDL_GameControllerGetAttached", attached),
         symbol("SDL_GameControllerUpdate", update), symbol("SDL_GameControllerGetAxis", axis),
         symbol("SDL_GameControllerGetButton", button), symbol("SDL_GameControllerRumble", rumble)});
}

std::mutex& sdl_start() {
    static std::mutex one;
    return one;
}

const char* sdl_problem(LibraryState state) {
    switch (state) {
        case LibraryState::ready:
            return "";
        case LibraryState::missing:
            return QT_TRANSLATE_NOOP("errors", "the library SDL 2 is not installed");
        case LibraryState::incomplete:
            return QT_TRANSLATE_NOOP("errors", "the library SDL 2 needs another one that is missing");
        case LibraryState::outdated:
            return QT_TRANSLATE_NOOP("errors", "the library SDL 2 lacks a function that Fulcrum needs");
        case LibraryState::unusable:
            return QT_TRANSLATE_NOOP("errors", "the library SDL 2 cannot be loaded");
    }
    return "";
}

const char* sdl_hint(LibraryState state) {
    return state == LibraryState::ready ? ""
                                        : QT_TRANSLATE_NOOP("errors",
                                                            "install the newest libSDL2-2.0.so.0: on Debian "
                                                            "and Ubuntu the package libsdl2-2.0-0");
}

}  // namespace fulcrum::controllers
