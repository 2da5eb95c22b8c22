// SPDX-License-Identifier: GPL-3.0-or-later
// The test of a game controller without a window: rate, delays, the range of each stick and trigger, the
// buttons that were pressed; on request a rumble in the middle of it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sim_core/controllers/game_controller.h"

namespace fulcrum::app {

struct ControllerTrial {
    std::string name;
    double seconds = 0, rate = 0;  ///< s; Hz
    double worst_gap = 0;          ///< s between two readings
    struct Range {
        double least = 0, most = 0;
    } stick[2][2], trigger[2];  ///< left first; to the right, up
    bool in_middle[2] = {};     ///< the stick was in its middle
    std::uint32_t buttons = 0;  ///< pressed at least once; bit: button of SDL
    bool rumble_asked = false, rumbled = false;
    bool connected = false;  ///< at the end
};

/// `named`: "controller" or "controller:NAME". Throws InputError.
ControllerTrial try_controller(const std::string& named, double seconds, bool rumble);
nlohmann::json controller_json(const ControllerTrial& trial);
void print_controller(const ControllerTrial& trial);

}  // namespace fulcrum::app
