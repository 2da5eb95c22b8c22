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
    return ports;
}

}  // namespace fulcrum
