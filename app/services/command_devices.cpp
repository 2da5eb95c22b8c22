// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum devices: what is connected, what is not and why; and a test of one device.
#include <QCoreApplication>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/live/device_trial.h"
#include "app/services/calibrate_device.h"
#include "app/services/calibration.h"
#include "app/services/controller_trial.h"
#include "app/services/device_list.h"
#include "app/services/devices.h"
#include "app/services/program.h"
#include "sim_core/devices/device_table.h"
#include "sim_core/numerics/number_text.h"
#include "ui/shell/devices_card.h"
#include "ui/style/text.h"

namespace fulcrum::app {
namespace {

constexpr double gentle_n = 0.3;
constexpr const char* slot_words[device_slots] = {QT_TRANSLATE_NOOP("commands", "left"),
                                                  QT_TRANSLATE_NOOP("commands", "right"),
                                                  QT_TRANSLATE_NOOP("commands", "scope")};

/// A line in the language in use.
void say(const Sentence& line) {
    std::cout << line.words(help_words) << '\n';
}
std::string device_text(const std::string& english) {
    return ui::plain(ui::device_words(english));
}

nlohmann::json to_json(const Durations& durations) {
    return {{"p50", durations.p50_us},
            {"p99", durations.p99_us},
            {"p99_9", durations.p999_us},
            {"worst", durations.worst_us}};
}

/// How it moves the instruments, where that was changed.
void print_use(const std::string& kind) {
    const double motion = Devices::motion_scale(kind == "mouse-keyboard" ? std::string() : kind);
    if (motion != 1)
        say({QT_TRANSLATE_NOOP("commands", "    movement of the instrument: %1 %"),
             decimal_text(100 * motion, 0)});
    const ui::SlotChoice parts = Devices::slot_choice(kind);
    if (parts == ui::SlotChoice()) return;
    const auto part = [](int slot) {
        return slot >= 0 && slot < device_slots
                   ? Sentence(slot_words[slot])
                   : Sentence(QT_TRANSLATE_NOOP("commands", "mouse and keyboard"));
    };
    say({QT_TRANSLATE_NOOP("commands", "    left instrument: %1; right instrument: %2; scope: %3"),
         part(parts.left), part(parts.right), part(parts.scope)});
}

void print_list(const std::vector<ListedDevice>& devices) {
    for (const ListedDevice& device : devices) {
        std::cout << device_text(device.title) << ": "
                  << ui::plain(QCoreApplication::translate("fulcrum::device_states",
                                                           row_of(device_states, device.state).title))
                  << '\n';
        for (const std::string& found : device.found) std::cout << "    " << device_text(found) << '\n';
        if (!device.why.empty())
            say({QT_TRANSLATE_NOOP("commands", "    why: %1"),
                 device_text(device.why) +
                     (device.detail.empty() ? std::string() : " (" + device.detail + ")")});
        if (!device.what_to_do.empty())
            say({QT_TRANSLATE_NOOP("commands", "    what to do: %1"), device_text(device.what_to_do)});
        if (device.state != DeviceState::usable)
            for (const std::string& rule : device.rules)
                say({QT_TRANSLATE_NOOP("commands", "    udev rule: %1"), rule});
        if (const std::string at = calibrated_at(device.kind); !at.empty())
            say({QT_TRANSLATE_NOOP("commands", "    calibrated: %1"), at});
        print_use(device.kind);
    }
}

bool needs_calibration(const DaemonClient& client) {
    FaultReport fault;
    return client.state().fault.read(fault) &&
           fault.fault == static_cast<std::uint64_t>(DeviceFault::needs_calibration);
}

/// How far each slot went in the test: to the right, up, and away from the person.
nlohmann::json frame_json(const DaemonClient& client, const DeviceTrial& trial) {
    nlohmann::json document = nlohmann::json::object();
    for (int i = 0; i < device_slots; ++i) {
        if (!client.facts().slot[i] || !trial.moved[i]) continue;
        const WorkspaceBox& box = *trial.moved[i];
        document[device_slot_names[i]] = {{"left_right_m", {box.least.x(), box.most.x()}},
                                          {"down_up_m", {box.least.y(), box.most.y()}},
                                          {"towards_away_m", {-box.most.z(), -box.least.z()}}};
    }
    return document;
}

nlohmann::json use_json(const std::string& kind) {
    const ui::SlotChoice parts = Devices::slot_choice(kind);
    return {{"motion_scale", Devices::motion_scale(kind)},
            {"force_scale", Devices::force_scale(kind)},
            {"left", parts.left},
            {"right", parts.right},
            {"scope", parts.scope},
            {"pedal", parts.pedal}};
}

nlohmann::json trial_json(const DaemonClient& client, const DeviceTrial& trial) {
    nlohmann::json document = {{"device", fulcrum::to_json(client.facts())},
                               {"device_class", row_of(device_classes, class_of(client.facts())).name},
                               {"notes", client.notes()},
                               {"seconds", trial.seconds},
                               {"rate_hz", trial.rate},
                               {"ticks", trial.device_ticks},
                               {"late_ticks", trial.device_late},
                               {"late_ticks_own", trial.device_late_own},
                               {"jitter_us", to_json(trial.device_wake)},
                               {"pose_age_us", to_json(trial.pose_age)},
                               {"force_delay_us", to_json(trial.force_delay)},
                               {"force_sent_n", trial.force_sent},
                               {"force_rendered_n", trial.force_rendered},
                               {"needs_calibration", needs_calibration(client)},
                               {"frame_check", frame_json(client, trial)},
                               {"use", use_json(client.facts().kind)}};
    for (int i = 0; i < device_slots; ++i) {
        if (!client.facts().slot[i]) continue;
        const DevicePose& pose = trial.newest[i];
        document["poses"][device_slot_names[i]] = {{"present", pose.present != 0},
                                                   {"position_m", pose.position},
                                                   {"roll_rad", pose.roll},
                                                   {"jaw", pose.jaw},
                                                   {"buttons", pose.buttons}};
    }
    return document;
}

void print_trial(const DaemonClient& client, const DeviceTrial& trial) {
    const auto row = [](const char* what, const Durations& durations) {
        say({QT_TRANSLATE_NOOP("commands", "%1: median %2 us, 99.9 % %3 us, worst %4 us"), Sentence(what),
             decimal_text(durations.p50_us, 0), decimal_text(durations.p999_us, 0),
             decimal_text(durations.worst_us, 0)});
    };
    std::cout << client.facts().title << '\n';
    say({QT_TRANSLATE_NOOP("commands",
                           "rate: %1 readings a second of %2; %3 of %4 ticks a period late or more"),
         decimal_text(trial.rate, 1), decimal_text(client.facts().rate, 0), trial.device_late,
         trial.device_ticks});
    row(QT_TRANSLATE_NOOP("commands", "jitter of the device's readings"), trial.device_wake);
    row(QT_TRANSLATE_NOOP("commands", "age of a pose when it is used"), trial.pose_age);
    if (trial.force_sent > 0) {
        row(QT_TRANSLATE_NOOP("commands", "force, from command to motors"), trial.force_delay);
        say({QT_TRANSLATE_NOOP("commands", "force: sent up to %1 N, rendered up to %2 N"),
             decimal_text(trial.force_sent, 2), decimal_text(trial.force_rendered, 2)});
    }
    for (int i = 0; i < device_slots; ++i) {
        if (!client.facts().slot[i]) continue;
        const DevicePose& pose = trial.newest[i];
        const Sentence slot(slot_words[i]);
        if (pose.present == 0)
            say({QT_TRANSLATE_NOOP("commands", "%1: does not answer"), slot});
        else
            say({QT_TRANSLATE_NOOP("commands", "%1: at (%2, %3, %4) mm, jaws %5 % open, buttons %6"), slot,
                 decimal_text(1e3 * pose.position[0], 1), decimal_text(1e3 * pose.position[1], 1),
                 decimal_text(1e3 * pose.position[2], 1), decimal_text(100 * pose.jaw, 0), pose.buttons});
    }
    for (int i = 0; i < device_slots; ++i) {
        if (const auto& box = client.facts().workspace[i]; client.facts().slot[i] && box)
            say({QT_TRANSLATE_NOOP("commands", "%1: workspace %2 x %3 x %4 mm (across, up, deep)"),
                 Sentence(slot_words[i]), decimal_text(1e3 * box->size().x(), 0),
                 decimal_text(1e3 * box->size().y(), 0), decimal_text(1e3 * box->size().z(), 0)});
        if (const auto& box = trial.moved[i]; client.facts().slot[i] && box)
            say({QT_TRANSLATE_NOOP(
                     "commands",
                     "%1: went %2 mm to the right, %3 mm to the left, %4 mm up, %5 mm down, %6 mm away from "
                     "you, %7 mm towards you"),
                 Sentence(slot_words[i]), decimal_text(1e3 * box->most.x(), 0),
                 decimal_text(-1e3 * box->least.x(), 0), decimal_text(1e3 * box->most.y(), 0),
                 decimal_text(-1e3 * box->least.y(), 0), decimal_text(-1e3 * box->least.z(), 0),
                 decimal_text(1e3 * box->most.z(), 0)});
    }
    if (!client.facts().firmware.empty())
        say({QT_TRANSLATE_NOOP("commands", "versions: %1"), client.facts().firmware});
    if (can_calibrate(client.facts().kind))
        say(needs_calibration(client) ? QT_TRANSLATE_NOOP("commands", "calibration: needed")
                                      : QT_TRANSLATE_NOOP("commands", "calibration: valid"));
    for (const std::string& note : client.notes()) say({QT_TRANSLATE_NOOP("commands", "note: %1"), note});
}

/// No slot of the device answers.
bool present_nowhere(const DaemonClient& client, const DeviceTrial& trial) {
    for (int i = 0; i < device_slots; ++i)
        if (client.facts().slot[i] && trial.newest[i].present != 0) return false;
    return true;
}

int test_controller(const Arguments& arguments, const std::string& named) {
    if (arguments.has("--force"))
        throw UsageError("--force",
                         QT_TRANSLATE_NOOP("errors", "is not possible: this device renders no force"),
                         QT_TRANSLATE_NOOP("errors", "use --rumble"));
    const auto seconds = static_cast<double>(arguments.integer("--seconds", 5, 1, 3600));
    const ControllerTrial trial = try_controller(named, seconds, arguments.has("--rumble"));
    if (arguments.has("--json"))
        print_json(controller_json(trial));
    else
        print_controller(trial);
    return trial.connected ? 0 : 1;
}

/// What is no device for this test is named before anything is opened.
void require_testable(const std::string& specification) {
    const std::string place = "--test " + specification;
    const std::size_t colon = specification.find(':');
    const DeviceRow* const row = device_row(specification);
    if (row != nullptr && row->read_by == ReadBy::window)
        throw UsageError(place, QT_TRANSLATE_NOOP("errors", "needs a window: mice and keys are read there"),
                         QT_TRANSLATE_NOOP("errors", "start fulcrum and try it on the page Settings"));
    if (row != nullptr && row->found_by == FoundBy::script &&
        (colon == std::string::npos || colon + 1 == specification.size()))
        throw UsageError(place, QT_TRANSLATE_NOOP("errors", "names no script"),
                         QT_TRANSLATE_NOOP("errors", "write --test virtual:SCRIPT.json"));
    if (row != nullptr) return;
    std::string small = specification.substr(0, colon);
    for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const DeviceRow* const meant = device_row(small);
    if (meant != nullptr && meant->read_by != ReadBy::window)
        throw UsageError(place, QT_TRANSLATE_NOOP("errors", "is not the name of a kind of device"),
                         {QT_TRANSLATE_NOOP("errors", "write it in small letters: --test %1"), small});
    throw UsageError(place, QT_TRANSLATE_NOOP("errors", "is not the name of a kind of device"),
                     {QT_TRANSLATE_NOOP("errors", "use one of %1; `fulcrum devices` lists what is connected"),
                      typed_devices(false)});
}

int test_device(const Arguments& arguments, const std::string& specification) {
    require_testable(specification);
    if (device_row(specification)->read_by == ReadBy::program)
        return test_controller(arguments, specification);
    if (arguments.has("--rumble"))
        throw UsageError("--rumble", QT_TRANSLATE_NOOP("errors", "is for game controllers"),
                         QT_TRANSLATE_NOOP("errors", "leave it out"));
    const auto seconds = static_cast<double>(arguments.integer("--seconds", 5, 1, 3600));
    DaemonClient client(hapticd_program(), with_calibration(specification));
    double peak = 0;
    if (arguments.has("--force")) {
        for (const auto& force : client.facts().force)
            if (force) peak = std::max(peak, std::min(gentle_n, force->continuous));
        if (peak == 0)
            throw UsageError("--force",
                             QT_TRANSLATE_NOOP("errors", "is not possible: this device renders no force"),
                             QT_TRANSLATE_NOOP("errors", "leave it out"));
    }
    const DeviceTrial trial = try_device(client, seconds, peak);
    if (arguments.has("--json"))
        print_json(trial_json(client, trial));
    else
        print_trial(client, trial);
    const bool ended = client.poll() == DaemonClient::Health::ended;
    if (client.message().empty()) return 0;
    std::cerr << "fulcrum: " << ui::plain(ui::sentence_text(client.message())) << '\n';
    return ended || present_nowhere(client, trial) ? 1 : 0;
}

int run_devices(const Arguments& arguments) {
    if (const auto device = arguments.value("--calibrate")) return calibrate_device(arguments, *device);
    if (arguments.has("--hand"))
        throw UsageError("--hand", QT_TRANSLATE_NOOP("errors", "has no meaning without --calibrate"),
                         QT_TRANSLATE_NOOP("errors", "name a device: --calibrate DEVICE"));
    if (const auto specification = arguments.value("--test")) return test_device(arguments, *specification);
    for (const char* option : {"--seconds", "--force", "--rumble"})
        if (arguments.has(option))
            throw UsageError(option, QT_TRANSLATE_NOOP("errors", "has no meaning without --test"),
                             QT_TRANSLATE_NOOP("errors", "name a device: --test DEVICE"));
    const std::vector<ListedDevice> devices = devices_of_machine()();
    if (arguments.has("--json"))
        print_json({{"devices", devices_json(devices)}});
    else
        print_list(devices);
    return 0;
}

}  // namespace

Command devices_command() {
    return {
        "devices",
        "",
        0,
        0,
        QT_TRANSLATE_NOOP(
            "commands",
            "Lists the devices for the hands: what is connected, what is not, why and what to do."),
        {{"--test",
          "DEVICE",
          {QT_TRANSLATE_NOOP("commands", "Open this device (%1) and measure rate, jitter and delays."),
           typed_devices(false)}},
         {"--calibrate",
          "DEVICE",
          {QT_TRANSLATE_NOOP("commands", "Calibrate this device step by step (%1)."),
           std::string("touch, haply, force-dimension, trainer, joystick, controller")}},
         {"--hand",
          "HAND",
          QT_TRANSLATE_NOOP("commands", "Hand whose instrument is calibrated."),
          "right",
          {"left", "right"}},
         {"--seconds", "S", QT_TRANSLATE_NOOP("commands", "How long the test lasts: 1 to 3600."), "5"},
         {"--force", "",
          QT_TRANSLATE_NOOP("commands",
                            "Also send a force that rises slowly to 0.3 N along each axis in turn.")},
         {"--rumble", "", QT_TRANSLATE_NOOP("commands", "Let a game controller rumble for half a second.")},
         json_option()},
        run_devices};
}

}  // namespace fulcrum::app
