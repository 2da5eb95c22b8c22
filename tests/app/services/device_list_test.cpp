// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/device_list.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

void plug_in(const std::filesystem::path& folder, const char* port, const char* vendor, const char* product,
             const char* title) {
    std::filesystem::create_directories(folder / port);
    std::ofstream(folder / port / "idVendor") << vendor << '\n';
    std::ofstream(folder / port / "idProduct") << product << '\n';
    if (*title != '\0') std::ofstream(folder / port / "product") << title << '\n';
}

const ListedDevice& row(const std::vector<ListedDevice>& devices, const std::string& kind) {
    for (const ListedDevice& device : devices)
        if (device.kind == kind) return device;
    ADD_FAILURE() << kind;
    return devices.front();
}

TEST(DeviceList, EveryDeviceThatCannotBeUsedSaysWhyAndWhatToDo) {
    const fulcrum::test::OwnFolder usb;
    plug_in(usb.path(), "1-1", "2988", "0302", "Touch");
    plug_in(usb.path(), "1-2", "0403", "6001",
            "serial adapter");  // the vendor of a Falcon's chip, not a Falcon
    plug_in(usb.path(), "usb1", "1d6b", "0002", "");
    for (const bool display : {false, true}) {
        for (const std::vector<std::string>& mice : {std::vector<std::string>{}, {"one"}, {"one", "two"}}) {
            const auto devices = list_devices(usb.path().string(), "/none/fulcrum-hapticd", display, mice);
            for (const ListedDevice& device : devices) {
                const bool usable = device.state == DeviceState::usable;
                EXPECT_EQ(device.why.empty(), usable) << device.kind;
                EXPECT_EQ(device.what_to_do.empty(), usable) << device.kind;
            }
            EXPECT_EQ(row(devices, "touch").state, DeviceState::connected);
            EXPECT_EQ(row(devices, "touch").found, std::vector<std::string>{"Touch (2988:0302)"});
            EXPECT_EQ(row(devices, "force-dimension").state, DeviceState::absent);
            EXPECT_EQ(row(devices, "two-mice").state, mice.size() == 2   ? DeviceState::usable
                                                      : mice.size() == 1 ? DeviceState::connected
                                                                         : DeviceState::absent);
            EXPECT_EQ(row(devices, "mouse-keyboard").state,
                      display ? DeviceState::usable : DeviceState::absent);
            EXPECT_NE(row(devices, "virtual").why.find("/none/fulcrum-hapticd"), std::string::npos);
            EXPECT_EQ(devices_json(devices).size(), devices.size());
        }
    }
}

TEST(DeviceList, ASystemWithoutAListOfUsbDevicesHasNone) {
    const auto devices = list_devices("/none", "/bin/sh", true, {});
    EXPECT_EQ(row(devices, "touch").state, DeviceState::absent);
    EXPECT_EQ(row(devices, "virtual").state, DeviceState::usable);
}

}  // namespace
}  // namespace fulcrum::app::program_test
