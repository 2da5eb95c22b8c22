// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/calibrate_device.h"

#include <poll.h>
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/services/calibration.h"
#include "ui/style/text.h"

namespace fulcrum::app {
namespace {

std::string calibration_words(const Sentence& sentence) {
    return ui::plain(ui::sentence_text(sentence));
}

/// The next key that was entered, without waiting longer than 20 ms: 0 none, -1 the end of the input.
int entered() {
    pollfd one{STDIN_FILENO, POLLIN, 0};
    if (poll(&one, 1, 20) <= 0) return 0;
    char key = 0;
    return read(STDIN_FILENO, &key, 1) == 1 ? key : -1;
}

void print_step(const ui::CalibrationState& now) {
    std::cout << now.step << '/' << now.steps << "  " << calibration_words(now.what_to_do) << '\n';
    const Sentence how(now.can_skip
                           ? QT_TRANSLATE_NOOP("commands", "     Enter: done; s and Enter: leave it out")
                           : QT_TRANSLATE_NOOP("commands", "     Enter: done"));
    std::cout << how.words(help_words) << std::endl;
}

}  // namespace

int calibrate_device(const Arguments& arguments, const std::string& device) {
    const std::string kind = device.substr(0, device.find(':'));
    if (!can_calibrate(kind))
        throw UsageError("--calibrate " + device,
                         QT_TRANSLATE_NOOP("errors", "there is nothing to calibrate for this kind of device"),
                         {QT_TRANSLATE_NOOP("errors", "use one of %1"),
                          "touch, haply, force-dimension, trainer, joystick, controller"});
    const std::string hand = arguments.value("--hand").value_or("right");
    const bool quiet = arguments.has("--json");
    const auto calibration = begin_calibration(device, hand == "left" ? 0 : 1, nullptr);
    int shown = 0;
    bool skips = false, ended = false;
    ui::CalibrationState now = calibration->look();
    while (now.runs && !ended) {
        if (now.step != shown && !quiet) print_step(now);
        shown = now.step;
        const int key = entered();
        if (key == 's') skips = true;
        if (key == '\n') {
            if (!skips && !calibration->look().ready && !quiet)
                std::cout << "     " << calibration_words(calibration->look().seen) << std::endl;
            if (skips)
                calibration->skip();
            else
                calibration->next();
            skips = false;
        }
        now = calibration->look();
        ended = key < 0;
    }
    if (quiet)
        print_json({{"device", kind},
                    {"hand", calibrates_hands(kind) ? nlohmann::json(hand) : nlohmann::json()},
                    {"stored", now.good},
                    {"steps_done", now.good ? now.steps : now.step - 1},
                    {"steps", now.steps}});
    else
        std::cout << calibration_words(ended ? Sentence(QT_TRANSLATE_NOOP(
                                                   "errors", "The calibration was ended; nothing is stored."))
                                             : now.result)
                  << '\n';
    return now.good ? 0 : 1;
}

}  // namespace fulcrum::app
