// SPDX-License-Identifier: Apache-2.0
// The functions of libdrd that are used (Force Dimension SDK), loaded while the program runs. Names, types
// and numbers: docs/BIBLIOGRAPHY.md.
#pragma once

#include "sim_core/hapticd/vendor_library.h"

namespace fulcrum::hapticd {

namespace dhd {
/// Places in the list that get_status() fills.
enum Status : std::size_t { power = 0, connected = 1, reset = 3, force = 5, error = 9, force_off_cause = 14 };
inline constexpr std::size_t status_count = 64;  ///< 17 in SDK 3.17; room for more
/// Why the device switched its motors off.
enum ForceOffCause : int {
    not_off = 0,
    button = 1,
    velocity = 2,
    watchdog = 3,
    software = 4,
    usb = 5,
    dead_man = 6
};
}  // namespace dhd

/// `char` is the number of the device. Functions return a negative number where they failed.
struct ForceDimensionLibrary {
    int (*device_count)() = nullptr;
    int (*open)(char) = nullptr;
    int (*close)(char) = nullptr;
    const char* (*name)(char) = nullptr;
    int (*get_pose)(double*, double*, double*, double (*)[3], char) = nullptr;
    int (*get_gripper)(double*, char) = nullptr;
    unsigned int (*get_buttons)(char) = nullptr;
    int (*enable_force)(unsigned char, char) = nullptr;
    int (*set_force)(double, double, double, double, double, double, double, char) = nullptr;
    int (*set_max_force)(double, char) = nullptr;
    int (*get_status)(int*, char) = nullptr;
    const char* (*last_error)() = nullptr;

    LibraryLook load();
};

}  // namespace fulcrum::hapticd
