// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/controller_trial.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/command.h"
#include "sim_core/devices/device_page.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum::app {
namespace {

constexpr const char* side_names[2] = {"left", "right"};
constexpr const char* axis_names[2] = {"to_the_right", "up"};
constexpr const char* button_names[] = {
    QT_TRANSLATE_NOOP("commands", "south"),          QT_TRANSLATE_NOOP("commands", "east"),
    QT_TRANSLATE_NOOP("commands", "west"),           QT_TRANSLATE_NOOP("commands", "north"),
    QT_TRANSLATE_NOOP("commands", "back"),           QT_TRANSLATE_NOOP("commands", "guide"),
    QT_TRANSLATE_NOOP("commands", "start"),          QT_TRANSLATE_NOOP("commands", "left stick"),
    QT_TRANSLATE_NOOP("commands", "right stick"),    QT_TRANSLATE_NOOP("commands", "left shoulder"),
    QT_TRANSLATE_NOOP("commands", "right shoulder"), QT_TRANSLATE_NOOP("commands", "pad up"),
    QT_TRANSLATE_NOOP("commands", "pad down"),       QT_TRANSLATE_NOOP("commands", "pad left"),
    QT_TRANSLATE_NOOP("commands", "pad right")};
constexpr const char* stick_names[2] = {QT_TRANSLATE_NOOP("commands", "left stick"),
                                        QT_TRANSLATE_NOOP("commands", "right stick")};

void widen(ControllerTrial::Range& range, double value) {
    range.least = std::min(range.least, value);
    range.most = std::max(range.most, value);
}

nlohmann::json range_json(const ControllerTrial::Range& range) {
    return {range.least, range.most};
}

std::vector<const char*> pressed(const ControllerTrial& trial) {
    std::vector<const char*> names;
    for (std::size_t i = 0; i < std::size(button_names); ++i)
        if ((trial.buttons >> i & 1U) != 0) names.push_back(button_names[i]);
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
    const auto say = [](const Sentence& line) { std::cout << line.words(help_words) << '\n'; };
    std::cout << trial.name << '\n';
    say({QT_TRANSLATE_NOOP("commands", "rate: %1 readings a second; longest gap %2 ms"),
         decimal_text(trial.rate, 1), decimal_text(1e3 * trial.worst_gap, 1)});
    for (int h = 0; h < 2; ++h) {
        const auto& stick = trial.stick[h];
        const Sentence still =
            trial.in_middle[h]
                ? Sentence()
                : Sentence(QT_TRANSLATE_NOOP("commands", "; never in its middle: it moves nothing"));
        say({QT_TRANSLATE_NOOP("commands",
                               "%1: %2 to %3 % to the right, %4 to %5 % up%6; trigger up to %7 %"),
             Sentence(stick_names[h]), percent(stick[0].least), percent(stick[0].most),
             percent(stick[1].least), percent(stick[1].most), still, percent(trial.trigger[h].most)});
    }
    Sentence buttons;
    for (const char* one : pressed(trial))
        buttons = buttons.empty() ? Sentence(one) : Sentence("%1, %2", buttons, Sentence(one));
    if (buttons.empty()) buttons = QT_TRANSLATE_NOOP("commands", "none");
    say({QT_TRANSLATE_NOOP("commands", "buttons pressed: %1"), buttons});
    if (trial.rumble_asked)
        say(trial.rumbled ? Sentence(QT_TRANSLATE_NOOP("commands", "rumble: sent"))
                          : Sentence(QT_TRANSLATE_NOOP("commands", "rumble: refused by the controller")));
}

}  // namespace fulcrum::app
