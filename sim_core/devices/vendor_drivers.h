// SPDX-License-Identifier: Apache-2.0
// The devices that fulcrum-hapticd drives through a library of their maker, which the person installs: how
// they are named, what their USB numbers are, and what to do where the library or a right is missing.
#pragma once

#include <string>
#include <vector>

#include "sim_core/devices/usb_devices.h"

namespace fulcrum {

/// A product of "" is any product of the vendor.
struct UsbNumber {
    const char *vendor, *product;
};

enum class LibraryState {
    ready,       ///< every function that is needed was found
    missing,     ///< no file of this name
    incomplete,  ///< a library that it needs is missing
    outdated,    ///< a function is missing
    unusable     ///< it does not load, or ends the process that loads it
};

/// Texts in English, translated in the context "errors".
struct VendorDriver {
    const char* kind;      ///< the specification without particulars: "touch"
    const char* title;     ///< for people
    const char* variable;  ///< environment variable with the path of another library, for tests
    std::vector<UsbNumber> numbers;
    const char *install, *needs, *rule;  ///< what to do where it is missing, incomplete, not permitted
};
const std::vector<VendorDriver>& vendor_drivers();
/// Null where no library of a maker drives this kind.
const VendorDriver* vendor_driver(const std::string& kind);

const char* problem_of(LibraryState state);
const char* hint_of(const VendorDriver& driver, LibraryState state);

bool is_of(const VendorDriver& driver, const UsbDevice& device);

/// What loading the library gave; `detail` is what the system says.
struct LibraryLook {
    LibraryState state = LibraryState::ready;
    std::string detail;
};
/// Asks `program` (fulcrum-hapticd), which loads the library in a process of its own: nothing of the maker's
/// runs here. Waits for at most 3 s.
LibraryLook look_at_library(const std::string& program, const std::string& kind);

}  // namespace fulcrum
