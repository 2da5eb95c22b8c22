// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/usb_devices.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace fulcrum {
namespace {

namespace fs = std::filesystem;

std::string line_of(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

/// "005" of 5.
std::string three_digits(const std::string& number) {
    char text[16];
    std::snprintf(text, sizeof text, "%03d", std::atoi(number.c_str()));
    return text;
}

std::vector<std::string> nodes_of(const fs::path& device, const fs::path& files) {
    std::vector<std::string> nodes;
    const auto add = [&nodes](const fs::path& node) {
        std::error_code error;
        if (fs::exists(node, error)) nodes.push_back(node.string());
    };
    std::error_code error;
    for (auto entry = fs::recursive_directory_iterator(device, error);
         !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.rfind("ttyACM", 0) == 0 || (name.rfind("hidraw", 0) == 0 && name != "hidraw"))
            add(files / name);
    }
    const std::string bus = line_of(device / "busnum"), number = line_of(device / "devnum");
    if (!bus.empty() && !number.empty())
        add(files / "bus" / "usb" / three_digits(bus) / three_digits(number));
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}  // namespace

std::vector<UsbDevice> usb_devices(const UsbFolders& folders) {
    std::vector<UsbDevice> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folders.list, error)) {
        UsbDevice device{line_of(entry.path() / "idVendor"), line_of(entry.path() / "idProduct"), {}, {}};
        if (device.vendor.empty()) continue;
        device.title = line_of(entry.path() / "product");
        device.nodes = nodes_of(entry.path(), folders.files);
        found.push_back(std::move(device));
    }
    std::sort(found.begin(), found.end(), [](const UsbDevice& a, const UsbDevice& b) {
        return a.vendor + a.product < b.vendor + b.product;
    });
    return found;
}

}  // namespace fulcrum
