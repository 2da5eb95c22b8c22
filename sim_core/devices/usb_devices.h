// SPDX-License-Identifier: Apache-2.0
// The USB devices of this machine and the files under /dev that their drivers open.
#pragma once

#include <string>
#include <vector>

namespace fulcrum {

struct UsbDevice {
    std::string vendor, product;     ///< four hexadecimal digits, as the system writes them
    std::string title;               ///< may be empty
    std::vector<std::string> nodes;  ///< serial ports, hidraw files and the USB node itself that exist
};

struct UsbFolders {
    std::string list = "/sys/bus/usb/devices";  ///< the system's list
    std::string files = "/dev";
};
/// Sorted by numbers; empty where the system has no list.
std::vector<UsbDevice> usb_devices(const UsbFolders& folders = {});

}  // namespace fulcrum
