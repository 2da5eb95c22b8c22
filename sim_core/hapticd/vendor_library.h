// SPDX-License-Identifier: Apache-2.0
// A maker's library, loaded while the program runs and never linked. Nothing of it is in this repository: the
// names and types of its functions are facts that docs/BIBLIOGRAPHY.md names the sources of.
#pragma once

#include <string>
#include <vector>

#include "sim_core/devices/device_table.h"
#include "sim_core/devices/run_time_library.h"
#include "sim_core/devices/usb_devices.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum::hapticd {

/// Loads the library that the variable of the device names, else the first of `names` that exists, and finds
/// every symbol. It stays loaded: the makers' libraries are not made to be closed.
LibraryLook load_library(const DeviceRow& device, const std::vector<std::string>& names,
                         const std::vector<Symbol>& symbols);

/// What a library said is about the firmware. Any thread, no allocation.
bool names_firmware(const char* words) noexcept;
/// What to do then.
const char* firmware_hint();

/// Throws InputError where the library is not ready.
void require_ready(const DeviceRow& device, const LibraryLook& look);

/// What keeps a device from opening that its library cannot reach: none is connected, or its file may not be
/// opened. Throws InputError with that, else with `problem` and `hint`.
[[noreturn]] void refuse_to_open(const DeviceRow& kind, const std::string& device, const Sentence& problem,
                                 const Sentence& hint, const UsbFolders& folders = {});

}  // namespace fulcrum::hapticd
