// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/device_list.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim_core/controllers/sdl_library.h"
#include "sim_core/devices/daemon_client.h"
#include "sim_core/devices/spacenavd_socket.h"
#include "sim_core/igtl/connection.h"
#include "ui/theatre/two_mice.h"

namespace fulcrum::app {
namespace {

constexpr const char* space_mouse_vendor = "256f";
constexpr int haply_port = 10001, older_haply_port = 10000;

std::string words_of(const UsbDevice& device) {
    return (device.title.empty() ? std::string("USB device") : device.title) + " (" + device.vendor + ":" +
           device.product + ")";
}

void no_daemon(ListedDevice& device, const std::string& daemon, int error) {
    device.state = DeviceState::absent;
    device.why = daemon + ": " + std::strerror(error);
    device.what_to_do = QT_TRANSLATE_NOOP(
        "fulcrum::device_list", "install fulcrum-hapticd next to fulcrum, or name it in FULCRUM_HAPTICD");
}

/// A device that a library of its maker drives.
ListedDevice driven_by_library(const VendorDriver& driver, const Machine& machine,
                               const std::vector<UsbDevice>& connected) {
    ListedDevice listed{driver.kind, driver.title, DeviceClass::haptic, {}, {}, {}, {}, {}};
    std::string closed;
    for (const UsbDevice& device : connected) {
        if (!is_of(driver, device)) continue;
        listed.found.push_back(words_of(device));
        for (const std::string& node : device.nodes)
            if (!machine.may_open(node)) closed = node;
    }
    listed.state = listed.found.empty() ? DeviceState::absent : DeviceState::connected;
    if (access(machine.daemon.c_str(), X_OK) != 0) {
        const DeviceState state = listed.state;
        no_daemon(listed, machine.daemon, errno);
        listed.state = state;
        return listed;
    }
    const LibraryLook look = machine.look(driver.kind);
    if (look.state != LibraryState::ready) {
        listed.why = problem_of(look.state);
        listed.detail = look.detail;
        listed.what_to_do = hint_of(driver, look.state);
    } else if (listed.found.empty()) {
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "no USB device of this kind was found");
        listed.what_to_do = QT_TRANSLATE_NOOP("fulcrum::device_list",
                                              "connect it and its power supply; a model for a network card "
                                              "can be tried with `fulcrum devices --test`");
    } else if (!closed.empty()) {
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "you have no permission to open the device");
        listed.detail = closed;
        listed.what_to_do = driver.rule;
    } else {
        listed.state = DeviceState::usable;
        listed.found.push_back("FULCRUM_DEVICE=" + std::string(driver.kind));
    }
    return listed;
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

ListedDevice tracked_instruments(const Machine& machine) {
    const igtl::Address standard;
    ListedDevice listed{"openigtlink",
                        QT_TRANSLATE_NOOP("fulcrum::device_list", "tracked instruments over OpenIGTLink"),
                        DeviceClass::tracked,
                        {},
                        {},
                        {},
                        {},
                        {}};
    listed.state = DeviceState::absent;
    if (access(machine.daemon.c_str(), X_OK) != 0) {
        no_daemon(listed, machine.daemon, errno);
    } else if (machine.sends_at.find(":" + std::to_string(standard.port)) != std::string::npos) {
        listed.why = QT_TRANSLATE_NOOP(
            "fulcrum::device_list", "Fulcrum itself sends attempts at the port where a tracker is expected");
        listed.what_to_do = QT_TRANSLATE_NOOP(
            "fulcrum::device_list",
            "switch that off, or name the tracker's server: FULCRUM_DEVICE=openigtlink:HOST:PORT");
    } else if (is_listened_to(machine.sockets, standard.port)) {
        listed.state = DeviceState::usable;
        listed.found.push_back("FULCRUM_DEVICE=openigtlink:" + standard.text());
    } else {
        listed.why =
            QT_TRANSLATE_NOOP("fulcrum::device_list", "no server listens at port 18944 of this computer");
        listed.what_to_do = QT_TRANSLATE_NOOP(
            "fulcrum::device_list",
            "start PLUS, 3D Slicer or the tracker's program with an OpenIGTLink server; for one on another "
            "computer start Fulcrum with FULCRUM_DEVICE=openigtlink:HOST:PORT");
    }
    return listed;
}

ListedDevice listed_haply(const Machine& machine) {
    ListedDevice listed{"haply",
                        QT_TRANSLATE_NOOP("fulcrum::device_list", "Haply Inverse3, VerseGrip"),
                        DeviceClass::haptic,
                        {},
                        {},
                        {},
                        {},
                        {}};
    listed.state = DeviceState::absent;
    if (access(machine.daemon.c_str(), X_OK) != 0) {
        no_daemon(listed, machine.daemon, errno);
    } else if (is_listened_to(machine.sockets, haply_port) ||
               is_listened_to(machine.sockets, older_haply_port)) {
        // Which devices are connected is known to the service alone.
        listed.state = DeviceState::usable;
        listed.found.emplace_back("FULCRUM_DEVICE=haply");
    } else {
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list",
                                       "the Inverse service of Haply does not run: nothing listens at port "
                                       "10001 of this computer");
        listed.what_to_do = QT_TRANSLATE_NOOP(
            "fulcrum::device_list",
            "install the Inverse service from Haply and start it; connect the device and its power supply");
    }
    return listed;
}

ListedDevice listed_space_mouse(const Machine& machine, const std::vector<UsbDevice>& connected) {
    ListedDevice listed{"space-mouse",
                        QT_TRANSLATE_NOOP("fulcrum::device_list", "SpaceMouse"),
                        DeviceClass::controller,
                        {},
                        {},
                        {},
                        {},
                        {}};
    for (const UsbDevice& one : connected)
        if (one.vendor == space_mouse_vendor) listed.found.push_back(words_of(one));
    listed.state = listed.found.empty() ? DeviceState::absent : DeviceState::connected;
    if (access(machine.daemon.c_str(), X_OK) != 0) {
        const DeviceState state = listed.state;
        no_daemon(listed, machine.daemon, errno);
        listed.state = state;
    } else if (access(machine.spacenavd.c_str(), W_OK) != 0) {
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "spacenavd, which reads it, does not run");
        listed.detail = machine.spacenavd + ": " + std::strerror(errno);
        listed.what_to_do = QT_TRANSLATE_NOOP(
            "fulcrum::device_list",
            "install the package spacenavd and start it with `sudo systemctl restart spacenavd`");
    } else {  // a wireless one has a USB number that does not say so
        listed.state = DeviceState::usable;
        listed.found.emplace_back("FULCRUM_DEVICE=space-mouse");
    }
    return listed;
}

ListedDevice game_controllers(const ControllerLook& look) {
    using namespace controllers;
    ListedDevice listed{"controller",
                        QT_TRANSLATE_NOOP("fulcrum::device_list", "game controller"),
                        DeviceClass::controller,
                        {},
                        {},
                        {},
                        {},
                        {}};
    bool known = false;
    for (const ConnectedController& one : look.connected) {
        listed.found.push_back(one.name);
        known = known || one.known;
    }
    listed.state = known                  ? DeviceState::usable
                   : listed.found.empty() ? DeviceState::absent
                                          : DeviceState::connected;
    if (look.library.state != LibraryState::ready) {
        listed.state = DeviceState::absent;
        listed.why = sdl_problem(look.library.state);
        listed.detail = look.library.detail;
        listed.what_to_do = sdl_hint(look.library.state);
    } else if (known) {
        listed.found.emplace_back("FULCRUM_DEVICE=controller");
    } else if (!listed.found.empty()) {
        listed.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "SDL does not know its sticks and buttons");
        listed.what_to_do = QT_TRANSLATE_NOOP(
            "fulcrum::device_list", "set SDL_GAMECONTROLLERCONFIG to its mapping, or use another controller");
    } else {
        listed.why = look.failure.empty() ? QT_TRANSLATE_NOOP("fulcrum::device_list", "none is connected")
                                          : QT_TRANSLATE_NOOP("fulcrum::device_list", "SDL 2 does not start");
        listed.detail = look.failure;
        listed.what_to_do =
            QT_TRANSLATE_NOOP("fulcrum::device_list",
                              "connect one by cable or Bluetooth and switch it on; your account "
                              "needs the right to read /dev/input/event*");
    }
    return listed;
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
    machine.sends_at = sends_at;
    return [machine] { return list_devices(machine); };
}

std::vector<ListedDevice> list_devices(const Machine& machine) {
    const bool display = machine.display;
    const std::vector<std::string>& mice = machine.mice;
    std::vector<ListedDevice> listed;
    ListedDevice mouse{"mouse-keyboard",
                       QT_TRANSLATE_NOOP("fulcrum::device_list", "mouse and keyboard"),
                       DeviceClass::mouse_keyboard,
                       {},
                       {},
                       {},
                       {},
                       {}};
    mouse.state = display ? DeviceState::usable : DeviceState::absent;
    if (!display) {
        mouse.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "there is no screen here");
        mouse.what_to_do =
            QT_TRANSLATE_NOOP("fulcrum::device_list", "start Fulcrum on a desktop, or set DISPLAY");
    }
    listed.push_back(mouse);

    ListedDevice two{"two-mice",
                     QT_TRANSLATE_NOOP("fulcrum::device_list", "two mice, one for each hand"),
                     DeviceClass::mouse_keyboard,
                     {},
                     mice,
                     {},
                     {},
                     {}};
    two.state = mice.size() >= 2 ? DeviceState::usable
                : mice.empty()   ? DeviceState::absent
                                 : DeviceState::connected;
    if (mice.size() < 2) {
        two.why = mice.empty()
                      ? QT_TRANSLATE_NOOP("fulcrum::device_list",
                                          "no mouse that an X server with XInput 2.1 reads by itself")
                      : QT_TRANSLATE_NOOP("fulcrum::device_list", "one mouse only");
        two.what_to_do = mice.empty()
                             ? QT_TRANSLATE_NOOP("fulcrum::device_list",
                                                 "start Fulcrum in an X11 session and connect two mice")
                             : QT_TRANSLATE_NOOP("fulcrum::device_list", "connect a second mouse");
    }
    listed.push_back(two);
    if (machine.controllers) listed.push_back(game_controllers(machine.controllers()));

    ListedDevice scripted{"virtual",
                          QT_TRANSLATE_NOOP("fulcrum::device_list", "virtual device: a script"),
                          DeviceClass::haptic,
                          {},
                          {},
                          {},
                          {},
                          {}};
    if (access(machine.daemon.c_str(), X_OK) == 0) {
        scripted.state = DeviceState::usable;
        scripted.found.push_back(
            QT_TRANSLATE_NOOP("fulcrum::device_list", "virtual:SCRIPT.json, for practice only"));
    } else {
        no_daemon(scripted, machine.daemon, errno);
    }
    listed.push_back(scripted);

    const std::vector<UsbDevice> connected = usb_devices(machine.usb);
    for (const VendorDriver& driver : vendor_drivers())
        listed.push_back(driven_by_library(driver, machine, connected));
    listed.push_back(listed_haply(machine));
    listed.push_back(tracked_instruments(machine));
    listed.push_back(listed_space_mouse(machine, connected));
    return listed;
}

nlohmann::json devices_json(const std::vector<ListedDevice>& devices) {
    nlohmann::json document = nlohmann::json::array();
    for (const ListedDevice& device : devices)
        document.push_back(
            {{"kind", device.kind},
             {"title", device.title},
             {"device_class", row_of(device_classes, device.device_class).name},
             {"state", row_of(device_states, device.state).name},
             {"found", device.found},
             {"why", device.why.empty() ? nlohmann::json() : nlohmann::json(device.why)},
             {"detail", device.detail.empty() ? nlohmann::json() : nlohmann::json(device.detail)},
             {"what_to_do",
              device.what_to_do.empty() ? nlohmann::json() : nlohmann::json(device.what_to_do)}});
    return document;
}

}  // namespace fulcrum::app
