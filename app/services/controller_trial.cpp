// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/controller_trial.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "sim_core/devices/device_page.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum::app {
namespace {

constexpr const char* side_names[2] = {"left", "right"};
constexpr const char* axis_names[2] = {"to_the_right", "up"};
constexpr const char* button_names[] = {"south",       "east",          "west",           "north",
                                        "back",        "guide",         "start",          "left stick",
                                        "right stick", "left shoulder", "right shoulder", "pad up",
                                        "pad down",    "pad left",      "pad right"};

void widen(ControllerTrial::Range& range, double value) {
    range.least = std::min(range.least, value);
    range.most = std::max(range.most, value);
}

nlohmann::json range_json(const ControllerTrial::Range& range) {
    return {range.least, range.most};
}

std::vector<std::string> pressed(const ControllerTrial& trial) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::size(button_names); ++i)
        if ((trial.buttons >> i & 1U) != 0) names.emplace_back(button_names[i]);
    return names;
}

std::string percent(double share) {
    return decimal_text(100 * share, 0);
}

}  // namespace

ControllerTrial try_controller(const std::string& named, double seconds, bool rumble) {
    const std::size_t colon = named.find(':');
    const auto pad =
        GameController::open(colon == std::string::npos ? std::string() : named.substr(colon + 1));
    ControllerTrial trial;
    trial.name = pad->name();
    trial.rumble_asked = rumble;
    const std::int64_t begin = monotonic_ns();
    const std::uint64_t first = pad->readings().readings;
    const auto lasted = [begin] { return 1e-9 * static_cast<double>(monotonic_ns() - begin); };
    ControllerReadings now;
    while (lasted() < seconds) {
        std::this_thread::sleep_for(std::chrono::milliseconds(4));
        const bool shakes = rumble && lasted() > seconds / 3 && lasted() < seconds / 3 + 0.5;
        pad->rumble(shakes ? 0.6 : 0, shakes ? 0.3 : 0);
        now = pad->readings();
        for (int h = 0; h < 2; ++h) {
            for (int axis = 0; axis < 2; ++axis) widen(trial.stick[h][axis], now.stick[h][axis]);
            widen(trial.trigger[h], now.trigger[h]);
            trial.in_middle[h] = now.begun[h];
        }
        trial.buttons |= now.buttons;
        trial.worst_gap = std::max(trial.worst_gap, now.worst_gap);
    }
    trial.seconds = lasted();
    trial.rate = static_cast<double>(now.readings - std::min(first, now.readings)) / trial.seconds;
    trial.connected = now.connected;
    trial.rumbled = rumble && now.rumbles;
    return trial;
}

nlohmann::json controller_json(const ControllerTrial& trial) {
    nlohmann::json document = {{"device", {{"kind", "controller"}, {"title", trial.name}}},
                               {"device_class", "controller"},
                               {"seconds", trial.seconds},
                               {"rate_hz", trial.rate},
                               {"worst_gap_us", 1e6 * trial.worst_gap},
                               {"connected", trial.connected},
                               {"buttons", pressed(trial)}};
    for (int h = 0; h < 2; ++h) {
        nlohmann::json& side = document[side_names[h]];
        for (int axis = 0; axis < 2; ++axis) side[axis_names[axis]] = range_json(trial.stick[h][axis]);
        side["trigger"] = range_json(trial.trigger[h]);
        side["stick_was_in_middle"] = trial.in_middle[h];
    }
    if (trial.rumble_asked) document["rumbled"] = trial.rumbled;
    return document;
}

void print_controller(const ControllerTrial& trial) {
    std::cout << trial.name << '\n'
              << "rate: " << decimal_text(trial.rate, 1) << " readings a second; longest gap "
              << decimal_text(1e3 * trial.worst_gap, 1) << " ms\n";
    for (int h = 0; h < 2; ++h) {
        const auto& stick = trial.stick[h];
        std::cout << side_names[h] << " stick: " << percent(stick[0].least) << " to "
                  << percent(stick[0].most) << " % to the right, " << percent(stick[1].least) << " to "
                  << percent(stick[1].most) << " % up"
                  << (trial.in_middle[h] ? "" : "; never in its middle: it moves nothing")
                  << "; trigger up to " << percent(trial.trigger[h].most) << " %\n";
    }
    const std::vector<std::string> buttons = pressed(trial);
    std::cout << "buttons pressed:";
    for (const std::string& one : buttons) std::cout << (&one == buttons.data() ? " " : ", ") << one;
    std::cout << (buttons.empty() ? " none\n" : "\n");
    if (trial.rumble_asked)
        std::cout << "rumble: " << (trial.rumbled ? "sent\n" : "refused by the controller\n");
}

}  // namespace fulcrum::app
