// SPDX-License-Identifier: Apache-2.0
// The functions and numbers of SDL 2 that game controllers need, declared here so that the program is built
// without it. Checked against its header (tests/sim_core/controllers).
#pragma once

#include <cstdint>
#include <mutex>

#include "sim_core/devices/run_time_library.h"

namespace fulcrum::controllers {

/// Types of the library that are only passed on.
struct SdlController;

inline constexpr std::uint32_t sdl_init_joystick = 0x200, sdl_init_controller = 0x2000;
inline constexpr int sdl_ignore = 0;  ///< no events: the state is read
enum SdlAxis { axis_left_x, axis_left_y, axis_right_x, axis_right_y, axis_left_trigger, axis_right_trigger };
enum SdlButton {
    button_south,
    button_east,
    button_west,
    button_north,
    button_back,
    button_guide,
    button_start,
    button_left_stick,
    button_right_stick,
    button_left_shoulder,
    button_right_shoulder,
    button_pad_up,
    button_pad_down,
    button_pad_left,
    button_pad_right,
    button_count
};

struct SdlLibrary {
    int (*set_hint)(const char* name, const char* value) = nullptr;
    int (*init)(std::uint32_t what) = nullptr;
    void (*quit)(std::uint32_t what) = nullptr;
    const char* (*error)() = nullptr;
    int (*joystick_events)(int state) = nullptr;
    int (*joystick_count)() = nullptr;
    const char* (*joystick_name)(int index) = nullptr;
    int (*is_controller)(int index) = nullptr;
    const char* (*controller_name)(int index) = nullptr;
    SdlController* (*open)(int index) = nullptr;
    void (*close)(SdlController* controller) = nullptr;
    int (*attached)(SdlController* controller) = nullptr;
    void (*update)() = nullptr;
    std::int16_t (*axis)(SdlController* controller, int axis) = nullptr;
    std::uint8_t (*button)(SdlController* controller, int button) = nullptr;
    int (*rumble)(SdlController* controller, std::uint16_t low, std::uint16_t high,
                  std::uint32_t milliseconds) = nullptr;

    /// FULCRUM_LIBSDL2 names another file.
    LibraryLook load();
};

/// Held while a part of SDL is started or ended: its controllers and its sound have threads of their own
/// here, and SDL counts its parts without a lock.
std::mutex& sdl_start();

/// What is wrong with the library and what to do, for a list of devices; texts of the context "errors".
const char* sdl_problem(LibraryState state);
const char* sdl_hint(LibraryState state);

}  // namespace fulcrum::controllers
