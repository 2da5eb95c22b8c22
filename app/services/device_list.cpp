// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/device_list.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim_core/devices/daemon_client.h"
#include "ui/theatre/two_mice.h"

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* usb_folder = "/sys/bus/usb/devices";

/// USB numbers in hexadecimal, as the system writes them; a product of "" is any product of the vendor.
struct UsbNumber {
    const char *vendor, *product;
};
struct UsbKind {
    const char *kind, *title;
    DeviceClass device_class;
    std::vector<UsbNumber> numbers;
};

const std::vector<UsbKind>& usb_kinds() {
    static const std::vector<UsbKind> kinds = {
        {"touch",
         QT_TRANSLATE_NOOP("fulcrum::device_list", "3D Systems Touch"),
         DeviceClass::haptic,
         {{"2988", ""}, {"0301", "2988"}}},
        {"force-dimension",
         QT_TRANSLATE_NOOP("fulcrum::device_list", "Force Dimension, Novint Falcon"),
         DeviceClass::haptic,
         {{"1451", ""}, {"0403", "cb48"}}},
        {"space-mouse",
         QT_TRANSLATE_NOOP("fulcrum::device_list", "SpaceMouse"),
         DeviceClass::controller,
         {{"256f", ""}}}};
    return kinds;
}

std::string line_of(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

struct UsbDevice {
    std::string vendor, product, title;
};

std::vector<UsbDevice> usb_devices(const std::string& folder) {
    std::vector<UsbDevice> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        UsbDevice device{line_of(entry.path() / "idVendor"), line_of(entry.path() / "idProduct"),
                         line_of(entry.path() / "product")};
        if (!device.vendor.empty()) found.push_back(std::move(device));
    }
    std::sort(found.begin(), found.end(), [](const UsbDevice& a, const UsbDevice& b) {
        return a.vendor + a.product < b.vendor + b.product;
    });
    return found;
}

bool is(const UsbDevice& device, const UsbNumber& number) {
    return device.vendor == number.vendor && (*number.product == '\0' || device.product == number.product);
}

}  // namespace

std::function<std::vector<ListedDevice>()> devices_of_machine() {
    const bool display = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    std::vector<std::string> mice;
    for (const ui::MouseDevice& mouse : ui::TwoMice::connected(false)) mice.push_back(mouse.name);
    return [display, mice, daemon = hapticd_program()] {
        return list_devices(usb_folder, daemon, display, mice);
    };
}

std::vector<ListedDevice> list_devices(const std::string& usb, const std::string& daemon, bool display,
                                       const std::vector<std::string>& mice) {
    std::vector<ListedDevice> listed;
    ListedDevice mouse{"mouse-keyboard",
                       QT_TRANSLATE_NOOP("fulcrum::device_list", "mouse and keyboard"),
                       DeviceClass::mouse_keyboard,
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

    ListedDevice scripted{"virtual",
                          QT_TRANSLATE_NOOP("fulcrum::device_list", "virtual device: a script"),
                          DeviceClass::haptic,
                          {},
                          {},
                          {},
                          {}};
    if (access(daemon.c_str(), X_OK) == 0) {
        scripted.state = DeviceState::usable;
        scripted.found.push_back(
            QT_TRANSLATE_NOOP("fulcrum::device_list", "virtual:SCRIPT.json, for practice only"));
    } else {
        scripted.state = DeviceState::absent;
        scripted.why = daemon + ": " + std::strerror(errno);
        scripted.what_to_do = QT_TRANSLATE_NOOP(
            "fulcrum::device_list", "install fulcrum-hapticd next to fulcrum, or name it in FULCRUM_HAPTICD");
    }
    listed.push_back(scripted);

    const std::vector<UsbDevice> connected = usb_devices(usb);
    for (const UsbKind& kind : usb_kinds()) {
        ListedDevice device{kind.kind, kind.title, kind.device_class, {}, {}, {}, {}};
        for (const UsbDevice& one : connected) {
            if (std::any_of(kind.numbers.begin(), kind.numbers.end(),
                            [&one](const UsbNumber& number) { return is(one, number); }))
                device.found.push_back((one.title.empty() ? std::string("USB device") : one.title) + " (" +
                                       one.vendor + ":" + one.product + ")");
        }
        device.state = device.found.empty() ? DeviceState::absent : DeviceState::connected;
        device.why = QT_TRANSLATE_NOOP("fulcrum::device_list", "this version of Fulcrum cannot drive it");
        device.what_to_do = QT_TRANSLATE_NOOP("fulcrum::device_list", "use mouse and keyboard");
        listed.push_back(device);
    }
    return listed;
}

nlohmann::json devices_json(const std::vector<ListedDevice>& devices) {
    nlohmann::json document = nlohmann::json::array();
    for (const ListedDevice& device : devices)
        document.push_back({{"kind", device.kind},
                            {"title", device.title},
                            {"device_class", row_of(device_classes, device.device_class).name},
                            {"state", row_of(device_states, device.state).name},
                            {"found", device.found},
                            {"why", device.why.empty() ? nlohmann::json() : nlohmann::json(device.why)},
                            {"what_to_do", device.what_to_do.empty() ? nlohmann::json()
                                                                     : nlohmann::json(device.what_to_do)}});
    return document;
}

}  // namespace fulcrum::app
