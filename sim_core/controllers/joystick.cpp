// SPDX-License-Identifier: Apache-2.0
#include "sim_core/controllers/joystick.h"

#include <algorithm>

#include "sim_core/controllers/sdl_library.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace controllers {

LibraryLook SdlJoystickLibrary::load() {
    return load_run_time_library(
        "FULCRUM_LIBSDL2", {"libSDL2-2.0.so.0", "libSDL2-2.0.so", "libSDL2.so"},
        {symbol("SDL_SetHint", set_hint), symbol("SDL_InitSubSystem", init),
         symbol("SDL_QuitSubSystem", quit), symbol("SDL_GetError", error),
         symbol("SDL_JoystickEventState", events), symbol("SDL_NumJoysticks", count),
         symbol("SDL_JoystickNameForIndex", name), symbol("SDL_JoystickOpen", open),
         symbol("SDL_JoystickClose", close), symbol("SDL_JoystickGetAttached", attached),
         symbol("SDL_JoystickUpdate", update), symbol("SDL_JoystickNumAxes", axis_count),
         symbol("SDL_JoystickGetAxis", axis), symbol("SDL_JoystickNumButtons", button_count),
         symbol("SDL_JoystickGetButton", button)});
}

}  // namespace controllers

using namespace controllers;

namespace {

[[noreturn]] void refuse_joystick(const Sentence& problem, const Sentence& hint) {
    throw InputError(QT_TRANSLATE_NOOP("errors", "joystick"), "", problem, hint);
}

std::string said(const char* words) {
    return words != nullptr ? words : "";
}

}  // namespace

Joystick::Joystick(const std::string& name) {
    const LibraryLook look = sdl_.load();
    if (look.state != LibraryState::ready)
        refuse_joystick({"%1 (%2)", Sentence(sdl_problem(look.state)), look.detail}, sdl_hint(look.state));
    {
        const std::lock_guard lock(sdl_start());
        sdl_.set_hint("SDL_NO_SIGNAL_HANDLERS", "1");
        sdl_.set_hint("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1");
        if (sdl_.init(sdl_init_joystick) != 0)
            refuse_joystick(
                {QT_TRANSLATE_NOOP("errors", "the library SDL 2 does not start: %1"), said(sdl_.error())},
                sdl_hint(LibraryState::unusable));
    }
    sdl_.events(sdl_ignore);
    sdl_.update();
    bool found = false;
    for (int i = 0; i < sdl_.count() && joystick_ == nullptr; ++i) {
        const std::string this_name = said(sdl_.name(i));
        if (!name.empty() && this_name != name) continue;
        found = true;
        joystick_ = sdl_.open(i);
        name_ = this_name;
    }
    if (joystick_ != nullptr) {
        axes_ = std::clamp(sdl_.axis_count(joystick_), 0, most_joystick_axes);
        buttons_ = std::clamp(sdl_.button_count(joystick_), 0, 64);
        return;
    }
    const std::string why = said(sdl_.error());
    {
        const std::lock_guard lock(sdl_start());
        sdl_.quit(sdl_init_joystick);
    }
    if (found)
        refuse_joystick({QT_TRANSLATE_NOOP("errors", "%1 cannot be opened: %2"), name_, why},
                        QT_TRANSLATE_NOOP("errors",
                                          "close other programs that use it; on Linux your account needs the "
                                          "right to read /dev/input/event*"));
    if (name.empty())
        refuse_joystick(QT_TRANSLATE_NOOP("errors", "none is connected"),
                        QT_TRANSLATE_NOOP("errors", "connect it, then try again"));
    refuse_joystick({QT_TRANSLATE_NOOP("errors", "none of the name %1 is connected"), name},
                    QT_TRANSLATE_NOOP("errors", "connect it, or calibrate the one that is connected"));
}

Joystick::~Joystick() {
    sdl_.close(joystick_);
    const std::lock_guard lock(sdl_start());
    sdl_.quit(sdl_init_joystick);
}

bool Joystick::read(JoystickReading& reading) {
    sdl_.update();
    if (sdl_.attached(joystick_) == 0) return false;
    for (int i = 0; i < axes_; ++i)
        reading.axis[i] = std::clamp(sdl_.axis(joystick_, i) / 32767.0, -1.0, 1.0);
    reading.buttons = 0;
    for (int i = 0; i < buttons_; ++i)
        if (sdl_.button(joystick_, i) != 0) reading.buttons |= std::uint64_t{1} << static_cast<unsigned>(i);
    return true;
}

}  // namespace fulcrum
