// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/device_table.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

#include "sim_core/devices/usb_devices.h"
#include "sim_core/hapticd/backend.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

std::string refusal_of(const std::string& specification) {
    try {
        hapticd::make_backend(specification);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(DeviceTable, TheDaemonMakesExactlyTheDevicesThatItReads) {
    const std::string unknown = "is not the name of a kind of device";
    for (const DeviceRow& row : device_table) {
        const bool made = refusal_of(std::string(row.name) + ":").find(unknown) == std::string::npos;
        EXPECT_EQ(made, row.read_by == ReadBy::daemon) << row.name;
        const bool has_library = hapticd::look_at_own_library(row.name).detail != row.name;
        EXPECT_EQ(has_library, row.found_by == FoundBy::library) << row.name;
    }
    const std::string refusal = refusal_of("Touch");
    EXPECT_NE(refusal.find("'Touch' " + unknown), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("two-mice, controller, virtual:SCRIPT.json, touch, "), std::string::npos);
    EXPECT_NE(refusal_of("virtual").find(unknown), std::string::npos);
}

TEST(DeviceTable, EveryRowIsCompleteAndDescribedInTheDocuments) {
    std::ifstream file(test::source_path("docs/DEVICES.md"));
    const std::string document((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::set<std::string> names;
    for (const DeviceRow& row : device_table) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(device_row(row.typed), &row);
        EXPECT_EQ(device_row(std::string(row.name) + ":x"), &row);
        EXPECT_FALSE(std::string(row.title).empty()) << row.name;
        EXPECT_NE(row.moves & moves_hands, 0U) << row.name;
        const bool always = row.found_by == FoundBy::script;
        EXPECT_EQ(std::string(row.absent).empty(), always) << row.name;
        EXPECT_EQ(std::string(row.connect).empty(), always) << row.name;
        EXPECT_EQ(row.ports[0] != 0, row.found_by == FoundBy::port) << row.name;
        EXPECT_EQ(*row.library.install != '\0', row.found_by == FoundBy::library) << row.name;
        for (const UsbNumber& number : row.usb)
            EXPECT_TRUE(std::string(number.vendor).size() % 4 == 0 &&
                        std::string(number.product).size() % 4 == 0)
                << row.name;
        EXPECT_NE(document.find("| " + std::string(row_of(device_classes, row.device_class).name)),
                  std::string::npos);
        EXPECT_TRUE(row.read_by == ReadBy::window ||
                    document.find(std::string("`") + row.typed) != std::string::npos ||
                    document.find(std::string("=") + row.name) != std::string::npos)
            << row.name << " is not described in docs/DEVICES.md";
    }
    EXPECT_EQ(device_row("mouse"), nullptr);
    EXPECT_EQ(device_row(""), nullptr);
}

TEST(DeviceTable, EveryFaultSaysWhatToDoAndANumberThatIsNoneSaysNothing) {
    std::set<std::string> words;
    for (const FaultRow& row : device_faults) {
        EXPECT_TRUE(words.insert(row.words).second) << row.words;
        EXPECT_EQ(*row.words == '\0', row.kind == DeviceFault::none);
        EXPECT_GT(row.remembered, 0);
    }
    const auto outside = static_cast<DeviceFault>(std::size(device_faults));
    EXPECT_STREQ(words_of(outside), "");
    EXPECT_FALSE(needs_opening(outside));
}

TEST(DeviceTable, TheRulesFileThatIsInstalledHasTheLinesOfEveryDevice) {
    std::ifstream file(test::source_path("assets/udev/70-fulcrum.rules"));
    std::set<std::string> installed, wanted;
    for (std::string line; std::getline(file, line);)
        if (!line.empty() && line[0] != '#') installed.insert(line);
    for (const DeviceRow& row : device_table) {
        std::string added;
        for (const std::string& rule : udev_rules_of(row)) {
            if (wanted.insert(rule).second && installed.count(rule) == 0) added += rule + "\n";
        }
        if (added.empty() || std::getenv("FULCRUM_WRITE_REFERENCES") == nullptr) continue;
        std::ofstream(test::source_path("assets/udev/70-fulcrum.rules"), std::ios::app)
            << "\n# " << row.title << "\n"
            << added;
        ADD_FAILURE() << "added the lines of " << row.title << ": run the test again";
    }
    EXPECT_EQ(installed, wanted);
    for (const char* kind : {"controller", "touch", "force-dimension", "space-mouse", "trainer", "joystick"})
        EXPECT_FALSE(udev_rules_of(*device_row(kind)).empty()) << kind;
    EXPECT_TRUE(udev_rules_of(*device_row("haply")).empty()) << "its service opens it";
    // What is said where the permission is missing has the same lines.
    for (const char* kind : {"touch", "force-dimension"})
        EXPECT_NE(std::string(device_row(kind)->rule).find(udev_rules_of(*device_row(kind)).front()),
                  std::string::npos);
}

TEST(DeviceTable, UsbNumbersNameTheDevicesOfARow) {
    UsbDevice falcon{"0403", "cb48", "Falcon", {}}, adapter{"0403", "6001", "serial adapter", {}};
    EXPECT_TRUE(is_of(*device_row("force-dimension"), falcon));
    EXPECT_FALSE(is_of(*device_row("force-dimension"), adapter));
    EXPECT_FALSE(is_of(*device_row("haply"), UsbDevice{})) << "no numbers are no wildcard";
}

}  // namespace
}  // namespace fulcrum
