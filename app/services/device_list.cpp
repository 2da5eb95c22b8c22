// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/device_list.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "app/services/calibration.h"
#include "sim_core/controllers/sdl_library.h"
#include "sim_core/devices/daemon_client.h"
#include "sim_core/devices/device_table.h"
#include "sim_core/devices/spacenavd_socket.h"
#include "ui/theatre/two_mice.h"

namespace fulcrum::app {
namespace {

std::string words_of(const UsbDevice& device) {
    const std::string number = device.vendor + ":" + device.product;
    return device.title.empty() ? "USB " + number : device.title + " (" + number + ")";
}

void not_found(const DeviceRow& row, ListedDevice& listed) {
    listed.why = row.absent;
    listed.what_to_do = row.connect;
}

/// How the person names it, with the address that was found.
void can_be_used(const std::string& typed, ListedDevice& listed) {
    listed.state = DeviceState::usable;
    listed.found.push_back("FULCRUM_DEVICE=" + typed);
}

void see_screen(const DeviceRow& row, const Machine& machine, ListedDevice& listed) {
    if (machine.display)
        listed.state = DeviceState::usable;
    else
        not_found(row, listed);
}

void see_mice(const DeviceRow& row, const Machine& machine, ListedDevice& listed) {
    listed.found = machine.mice;
    if (machine.mice.size() >= 2) {
        listed.state = DeviceState::usable;
    } else if (machine.mice.empty()) {
        not_found(row, listed);
    } else {
        listed.state = DeviceState::connected;
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "one mouse only");
        listed.what_to_do = QT_TRANSLATE_NOOP("fulcrum::device_list", "connect a second mouse");
    }
}

void see_controllers(const DeviceRow& row, const ControllerLook& look, ListedDevice& listed) {
    using namespace controllers;
    bool known = false;
    for (const ConnectedController& one : look.connected) {
        listed.found.push_back(one.name);
        known = known || one.known;
    }
    if (look.library.state != LibraryState::ready) {
        listed.why = sdl_problem(look.library.state);
        listed.detail = look.library.detail;
        listed.what_to_do = sdl_hint(look.library.state);
    } else if (known) {
        can_be_used(row.name, listed);
    } else if (!listed.found.empty()) {
        listed.state = DeviceState::connected;
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "SDL does not know its sticks and buttons");
        listed.what_to_do = QT_TRANSLATE_NOOP(
            "fulcrum::device_list", "set SDL_GAMECONTROLLERCONFIG to its mapping, or use another controller");
    } else {
        not_found(row, listed);
        if (!look.failure.empty())
            listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "SDL 2 does not start");
        listed.detail = look.failure;
    }
}

/// A device that a library of its maker drives. `closed`: a file of it that may not be opened.
void see_library(const DeviceRow& row, const Machine& machine, const std::string& closed,
                 ListedDevice& listed) {
    const LibraryLook look = machine.look(row.name);
    if (look.state != LibraryState::ready) {
        listed.why = problem_of(look.state);
        listed.detail = look.detail;
        listed.what_to_do = hint_of(row, look.state);
    } else if (listed.found.empty()) {
        not_found(row, listed);
    } else if (!closed.empty()) {
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "you have no permission to open the device");
        listed.detail = closed;
        listed.what_to_do = row.rule;
    } else {
        can_be_used(row.name, listed);
    }
}

/// A program listens at this port; looked up without connecting, since some servers take one client only.
bool is_listened_to(const std::string& sockets, int port) {
    constexpr const char* listening = "0A";
    char wanted[8];
    std::snprintf(wanted, sizeof wanted, ":%04X", static_cast<unsigned>(port) & 0xffffU);
    for (const char* name : {"/tcp", "/tcp6"}) {
        std::ifstream lines(sockets + name);
        std::string line;
        while (std::getline(lines, line)) {
            std::istringstream words(line);
            std::string number, own, other, state;
            words >> number >> own >> other >> state;
            if (state == listening && own.size() > 5 && own.compare(own.size() - 5, 5, wanted) == 0)
                return true;
        }
    }
    return false;
}

/// Which devices are connected is known to the program alone that listens there.
void see_port(const DeviceRow& row, const Machine& machine, ListedDevice& listed) {
    not_found(row, listed);
    for (const int port : row.ports) {
        if (port == 0) continue;
        const std::string number = std::to_string(port);
        if (machine.sends_at.find(":" + number) != std::string::npos) {
            listed.why =
                QT_TRANSLATE_NOOP("fulcrum::device_list",
                                  "Fulcrum itself sends attempts at the port where a tracker is expected");
            listed.what_to_do = QT_TRANSLATE_NOOP(
                "fulcrum::device_list",
                "switch that off, or name the tracker's server: FULCRUM_DEVICE=openigtlink:HOST:PORT");
        } else if (is_listened_to(machine.sockets, port)) {
            listed.why = listed.what_to_do = "";
            std::string typed = row.typed;
            if (const std::size_t at = typed.find("HOST:PORT"); at != std::string::npos)
                typed.replace(at, std::string::npos, "127.0.0.1:" + number);
            return can_be_used(typed, listed);
        }
    }
}

/// Any joystick, whether SDL knows it as a controller or not.
void see_joystick(const DeviceRow& row, const Machine& machine, const ControllerLook& look,
                  ListedDevice& listed) {
    for (const ConnectedController& one : look.connected) listed.found.push_back(one.name);
    if (look.library.state != LibraryState::ready) {
        listed.why = controllers::sdl_problem(look.library.state);
        listed.detail = look.library.detail;
        listed.what_to_do = controllers::sdl_hint(look.library.state);
    } else if (look.connected.empty()) {
        not_found(row, listed);
        if (!look.failure.empty())
            listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "SDL 2 does not start");
        listed.detail = look.failure;
    } else if (access(machine.joystick_file.c_str(), R_OK) == 0) {
        can_be_used(row.name, listed);
    } else {
        listed.state = DeviceState::connected;
        listed.needs_calibration = true;
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "it is not calibrated");
        listed.what_to_do = QT_TRANSLATE_NOOP(
            "fulcrum::device_list",
            "choose it here and calibrate it, or run `fulcrum devices --calibrate joystick`");
    }
}

void see_spacenavd(const DeviceRow& row, const Machine& machine, ListedDevice& listed) {
    if (access(machine.spacenavd.c_str(), W_OK) == 0) {
        // a wireless one has a USB number that does not say so
        can_be_used(row.name, listed);
        return;
    }
    const int why = errno;
    listed.detail = machine.spacenavd + ": " + std::strerror(why);
    not_found(row, listed);
    if (why != EACCES) return;
    listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "you have no permission to use its socket");
    listed.what_to_do = QT_TRANSLATE_NOOP("fulcrum::device_list",
                                          "ask the administrator for the right to read and write the socket");
}

/// Whether it is a trainer is known when it is opened: nothing is sent to a board that may be another's.
void see_serial(const DeviceRow& row, const Machine& machine, const std::vector<UsbDevice>& connected,
                ListedDevice& listed) {
    const std::vector<std::string> ports = serial_ports_of(row, connected);
    std::string closed;
    for (const std::string& port : ports)
        if (!machine.may_open(port)) closed = port;
    if (ports.empty()) {
        not_found(row, listed);
    } else if (!closed.empty()) {
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "you have no permission to open the device");
        listed.detail = closed;
        listed.what_to_do = row.rule;
    } else if (ports.size() > 1) {
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "more than one serial port can be its port");
        for (const std::string& port : ports) listed.detail += (listed.detail.empty() ? "" : ", ") + port;
        listed.what_to_do = QT_TRANSLATE_NOOP("fulcrum::device_list",
                                              "unplug the others, or name the port: "
                                              "FULCRUM_DEVICE=trainer:PORT");
    } else {
        can_be_used(row.name, listed);
    }
}

/// What fulcrum-hapticd reads.
void see_driven(const DeviceRow& row, const Machine& machine, const std::vector<UsbDevice>& connected,
                ListedDevice& listed) {
    std::string closed;
    for (const UsbDevice& device : connected) {
        if (!is_of(row, device)) continue;
        listed.state = DeviceState::connected;
        listed.found.push_back(words_of(device));
        for (const std::string& node : device.nodes)
            if (!machine.may_open(node)) closed = node;
    }
    if (access(machine.daemon.c_str(), X_OK) != 0) {
        listed.why = machine.daemon + ": " + std::strerror(errno);
        listed.what_to_do = QT_TRANSLATE_NOOP(
            "fulcrum::device_list", "install fulcrum-hapticd next to fulcrum, or name it in FULCRUM_HAPTICD");
        return;
    }
    if (row.found_by == FoundBy::library) see_library(row, machine, closed, listed);
    if (row.found_by == FoundBy::port) see_port(row, machine, listed);
    if (row.found_by == FoundBy::spacenavd) see_spacenavd(row, machine, listed);
    if (row.found_by == FoundBy::serial) see_serial(row, machine, connected, listed);
    if (row.found_by == FoundBy::script) {
        listed.state = DeviceState::usable;
        listed.found.emplace_back(
            QT_TRANSLATE_NOOP("fulcrum::device_list", "virtual:SCRIPT.json, for practice only"));
    }
}

}  // namespace

std::function<std::vector<ListedDevice>()> devices_of_machine(const std::string& sends_at) {
    const bool display = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    std::vector<std::string> mice;
    for (const ui::MouseDevice& mouse : ui::TwoMice::connected(false)) mice.push_back(mouse.name);
    Machine machine;
    machine.daemon = hapticd_program();
    machine.display = display;
    machine.mice = mice;
    machine.may_open = [](const std::string& file) { return access(file.c_str(), R_OK | W_OK) == 0; };
    machine.look = [daemon = machine.daemon](const std::string& kind) {
        return look_at_library(daemon, kind);
    };
    machine.controllers = GameController::look;
    machine.sockets = "/proc/net";
    machine.spacenavd = spacenavd_socket();
    machine.joystick_file = joystick_file();
    machine.sends_at = sends_at;
    return [machine] { return list_devices(machine); };
}

std::vector<ListedDevice> list_devices(const Machine& machine) {
    std::vector<ListedDevice> devices;
    const std::vector<UsbDevice> connected = usb_devices(machine.usb);
    std::optional<ControllerLook> controllers;
    for (const DeviceRow& row : device_table) {
        const bool by_sdl = row.found_by == FoundBy::sdl || row.found_by == FoundBy::joystick;
        if (by_sdl && !machine.controllers) continue;
        if (by_sdl && !controllers) controllers = machine.controllers();
        ListedDevice listed;
        listed.kind = row.name;
        listed.title = row.title;
        listed.device_class = row.device_class;
        listed.can_be_chosen = can_be_chosen(row);
        if (row.found_by == FoundBy::screen)
            see_screen(row, machine, listed);
        else if (row.found_by == FoundBy::mice)
            see_mice(row, machine, listed);
        else if (row.found_by == FoundBy::sdl)
            see_controllers(row, *controllers, listed);
        else
            see_driven(row, machine, connected, listed);
        if (row.found_by == FoundBy::joystick && listed.why.empty())
            see_joystick(row, machine, *controllers, listed);
        listed.rules = udev_rules_of(row);
        devices.push_back(std::move(listed));
    }
    return devices;
}

static nlohmann::json calibration_json(const ListedDevice& device) {
    if (!can_calibrate(device.kind)) return nullptr;
    const std::string at = calibrated_at(device.kind);
    return {{"needed", device.needs_calibration}, {"at", at.empty() ? nlohmann::json() : nlohmann::json(at)}};
}

nlohmann::json devices_json(const std::vector<ListedDevice>& devices) {
    nlohmann::json document = nlohmann::json::array();
    for (const ListedDevice& device : devices) {
        nlohmann::json moves = nlohmann::json::array();
        if (const DeviceRow* const row = device_row(device.kind))
            for (const auto& [bit, name] : device_parts)
                if ((row->moves & bit) != 0) moves.push_back(name);
        document.push_back(
            {{"kind", device.kind},
             {"title", device.title},
             {"device_class", row_of(device_classes, device.device_class).name},
             {"moves", moves},
             {"state", row_of(device_states, device.state).name},
             {"found", device.found},
             {"calibration", calibration_json(device)},
             {"udev_rules", device.rules},
             {"why", device.why.empty() ? nlohmann::json() : nlohmann::json(device.why)},
             {"detail", device.detail.empty() ? nlohmann::json() : nlohmann::json(device.detail)},
             {"what_to_do",
              device.what_to_do.empty() ? nlohmann::json() : nlohmann::json(device.what_to_do)}});
    }
    return document;
}

}  // namespace fulcrum::app
