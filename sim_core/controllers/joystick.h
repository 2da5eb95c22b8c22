// SPDX-License-Identifier: Apache-2.0
// A joystick as SDL 2 reports it: axes and buttons without a meaning. It need not know it as a controller.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim_core/devices/run_time_library.h"

namespace fulcrum {

namespace controllers {
struct SdlJoystick;  ///< a type of the library that is only passed on

/// The functions of SDL 2 for joysticks (sdl_library.h has those for controllers).
struct SdlJoystickLibrary {
    int (*set_hint)(const char* name, const char* value) = nullptr;
    int (*init)(std::uint32_t what) = nullptr;
    void (*quit)(std::uint32_t what) = nullptr;
    const char* (*error)() = nullptr;
    int (*events)(int state) = nullptr;
    int (*count)() = nullptr;
    const char* (*name)(int index) = nullptr;
    SdlJoystick* (*open)(int index) = nullptr;
    void (*close)(SdlJoystick* joystick) = nullptr;
    int (*attached)(SdlJoystick* joystick) = nullptr;
    void (*update)() = nullptr;
    int (*axis_count)(SdlJoystick* joystick) = nullptr;
    std::int16_t (*axis)(SdlJoystick* joystick, int axis) = nullptr;
    int (*button_count)(SdlJoystick* joystick) = nullptr;
    std::uint8_t (*button)(SdlJoystick* joystick, int button) = nullptr;

    LibraryLook load();
};
}  // namespace controllers

inline constexpr int most_joystick_axes = 16;

/// What it reports now.
struct JoystickReading {
    double axis[most_joystick_axes] = {};  ///< -1 to 1
    std::uint64_t buttons = 0;             ///< bit: button
};

/// One thread makes, reads and destroys it; while it exists nothing else in the process may use joysticks of
/// SDL.
class Joystick {
  public:
    /// Opens the first one, or the one of this name. Throws InputError where there is none, with what to do.
    explicit Joystick(const std::string& name);
    ~Joystick();
    Joystick(const Joystick&) = delete;
    Joystick& operator=(const Joystick&) = delete;
    const std::string& name() const { return name_; }
    int axes() const { return axes_; }
    /// False: it was unplugged.
    bool read(JoystickReading& reading);

  private:
    controllers::SdlJoystickLibrary sdl_;
    controllers::SdlJoystick* joystick_ = nullptr;
    std::string name_;
    int axes_ = 0, buttons_ = 0;
};

}  // namespace fulcrum
