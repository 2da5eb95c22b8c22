// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/vendor_drivers.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <nlohmann/json.hpp>

#include "sim_core/devices/packets.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum {
namespace {

constexpr int look_limit_ms = 3000;

}  // namespace

const std::vector<VendorDriver>& vendor_drivers() {
    // USB numbers: the makers' udev rules.
    static const std::vector<VendorDriver> drivers = {
        {"touch",
         QT_TRANSLATE_NOOP("errors", "3D Systems Touch"),
         "FULCRUM_LIBHD",
         {{"2988", ""}, {"0301", "2988"}},
         QT_TRANSLATE_NOOP("errors",
                           "install OpenHaptics for Linux and the Touch driver of 3D Systems, then run "
                           "`sudo ldconfig`"),
         QT_TRANSLATE_NOOP("errors",
                           "install that library: libPhantomIOLib42.so comes with the Touch driver, "
                           "libncurses.so.5 and libtinfo.so.5 with the packages libncurses5 and libtinfo5"),
         QT_TRANSLATE_NOOP(
             "errors",
             "write the line SUBSYSTEMS==\"usb\", ATTRS{idVendor}==\"2988\", MODE=\"0660\", TAG+=\"uaccess\" "
             "to /etc/udev/rules.d/70-fulcrum-touch.rules, then unplug the device and connect it again")},
        {"force-dimension",
         QT_TRANSLATE_NOOP("errors", "Force Dimension, Novint Falcon"),
         "FULCRUM_LIBDRD",
         {{"1451", ""}, {"0403", "cb48"}},
         QT_TRANSLATE_NOOP("errors",
                           "install the Force Dimension SDK and name its folder in FDSDK, or copy its "
                           "libdrd.so to /usr/local/lib and run `sudo ldconfig`"),
         QT_TRANSLATE_NOOP("errors",
                           "install that library: libusb-1.0.so.0 comes with the package libusb-1.0-0"),
         QT_TRANSLATE_NOOP(
             "errors",
             "write the lines SUBSYSTEMS==\"usb\", ATTRS{idVendor}==\"1451\", MODE=\"0660\", "
             "TAG+=\"uaccess\" and SUBSYSTEMS==\"usb\", ATTRS{idVendor}==\"0403\", "
             "ATTRS{idProduct}==\"cb48\", MODE=\"0660\", TAG+=\"uaccess\" to "
             "/etc/udev/rules.d/70-fulcrum-force-dimension.rules, then unplug the device and connect it "
             "again")},
    };
    return drivers;
}

const VendorDriver* vendor_driver(const std::string& kind) {
    for (const VendorDriver& driver : vendor_drivers())
        if (kind == driver.kind) return &driver;
    return nullptr;
}

const char* problem_of(LibraryState state) {
    switch (state) {
        case LibraryState::ready:
            return "";
        case LibraryState::missing:
            return QT_TRANSLATE_NOOP("errors", "the maker's library is not installed");
        case LibraryState::incomplete:
            return QT_TRANSLATE_NOOP("errors", "the maker's library needs another one that is missing");
        case LibraryState::outdated:
            return QT_TRANSLATE_NOOP("errors", "the maker's library lacks a function that Fulcrum needs");
        case LibraryState::unusable:
            return QT_TRANSLATE_NOOP("errors", "the maker's library cannot be loaded");
    }
    return "";
}

const char* hint_of(const VendorDriver& driver, LibraryState state) {
    switch (state) {
        case LibraryState::ready:
            return "";
        case LibraryState::missing:
            return driver.install;
        case LibraryState::incomplete:
            return driver.needs;
        case LibraryState::outdated:
        case LibraryState::unusable:
            return QT_TRANSLATE_NOOP("errors", "install the newest version of the maker's driver");
    }
    return "";
}

bool is_of(const VendorDriver& driver, const UsbDevice& device) {
    return std::any_of(driver.numbers.begin(), driver.numbers.end(), [&device](const UsbNumber& number) {
        return device.vendor == number.vendor &&
               (*number.product == '\0' || device.product == number.product);
    });
}

LibraryLook look_at_library(const std::string& program, const std::string& kind) {
    LibraryLook look{LibraryState::unusable, {}};
    int ends[2];
    make_socket_pair(ends);
    const int passed = fcntl(ends[1], F_DUPFD, 3);  // not closed on exec
    std::string words[] = {program, "--look", std::to_string(passed), kind};
    char* const arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    pid_t child = 0;
    const int failed =
        passed < 0 ? errno : posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environ);
    close(ends[1]);
    if (passed >= 0) close(passed);
    if (failed != 0) {
        look.detail = program + ": " + std::strerror(failed);
        close(ends[0]);
        return look;
    }
    if (const std::optional<Packet> packet = receive_packet(ends[0], look_limit_ms)) {
        for (const int descriptor : packet->descriptors) close(descriptor);
        const auto line = nlohmann::json::parse(packet->text, nullptr, false);
        if (line.is_object()) {
            const int state = line.value("state", static_cast<int>(LibraryState::unusable));
            look.state =
                static_cast<LibraryState>(std::clamp(state, 0, static_cast<int>(LibraryState::unusable)));
            look.detail = line.value("detail", std::string());
        }
    }
    close(ends[0]);
    kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status) && WTERMSIG(status) != SIGKILL && look.state == LibraryState::unusable)
        look.detail = strsignal(WTERMSIG(status));
    return look;
}

}  // namespace fulcrum
