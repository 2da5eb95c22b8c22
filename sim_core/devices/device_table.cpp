// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/device_table.h"

#include <algorithm>

#include "sim_core/devices/usb_devices.h"

namespace fulcrum {

std::string typed_devices(bool of_window) {
    std::string names;
    for (const DeviceRow& row : device_table) {
        // Without a device of its own the window uses mouse and keyboard: that is not typed.
        if (row.found_by == FoundBy::screen || (row.read_by == ReadBy::window && !of_window)) continue;
        names += (names.empty() ? "" : ", ") + std::string(row.typed);
    }
    return names;
}

bool is_of(const DeviceRow& row, const UsbDevice& device) {
    return std::any_of(std::begin(row.usb), std::end(row.usb), [&device](const UsbNumber& number) {
        return *number.vendor != '\0' && device.vendor == number.vendor &&
               (*number.product == '\0' || device.product == number.product);
    });
}

std::vector<std::string> serial_ports_of(const DeviceRow& row, const std::vector<UsbDevice>& connected) {
    std::vector<std::string> ports;
    for (const UsbDevice& device : connected) {
        if (!is_of(row, device)) continue;
        for (const std::string& node : device.nodes)
            if (node.find("/tty") != std::string::npos) ports.push_back(node);
    }
    // The order in which a folder is read depends on its file system.
    std::sort(ports.begin(), ports.end());
    return ports;
}

std::optional<WorkspaceBox> published_workspace(const DeviceRow& row) {
    const double* const mm = row.workspace;
    const WorkspaceBox box{1e-3 * Vector3(mm[0], mm[1], mm[2]), 1e-3 * Vector3(mm[3], mm[4], mm[5])};
    return is_usable(box) ? std::optional<WorkspaceBox>(box) : std::nullopt;
}

std::vector<std::string> udev_rules_of(const DeviceRow& row) {
    const std::string access = "MODE=\"0660\", TAG+=\"uaccess\"";
    if (row.found_by == FoundBy::sdl || row.found_by == FoundBy::joystick)
        return {R"(SUBSYSTEM=="input", KERNEL=="event*", ENV{ID_INPUT_JOYSTICK}=="1", )" + access};
    const char* const match = row.found_by == FoundBy::serial ? "SUBSYSTEM==\"tty\"" : "SUBSYSTEMS==\"usb\"";
    std::vector<std::string> rules;
    for (const UsbNumber& number : row.usb) {
        if (*number.vendor == '\0') continue;
        std::string rule = match + std::string(", ATTRS{idVendor}==\"") + number.vendor + "\", ";
        if (*number.product != '\0') rule += std::string("ATTRS{idProduct}==\"") + number.product + "\", ";
        rules.push_back(rule + access);
    }
    return rules;
}

}  // namespace fulcrum
