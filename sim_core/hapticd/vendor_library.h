// SPDX-License-Identifier: Apache-2.0
// A maker's library, loaded while the program runs and never linked. Nothing of it is in this repository: the
// names and types of its functions are facts that docs/BIBLIOGRAPHY.md names the sources of.
#pragma once

#include <string>
#include <vector>

#include "sim_core/devices/run_time_library.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum::hapticd {

/// Loads the library that the driver's variable names, else the first of `names` that exists, and finds every
/// symbol. It stays loaded: the makers' libraries are not made to be closed.
LibraryLook load_library(const VendorDriver& driver, const std::vector<std::string>& names,
                         const std::vector<Symbol>& symbols);

/// Throws InputError where the library is not ready.
void require_ready(const VendorDriver& driver, const LibraryLook& look);

/// Loads the library of this kind of device and reports what is missing.
LibraryLook look_at_own_library(const std::string& kind);

/// What keeps a device from opening that its library cannot reach: none is connected, or its file may not be
/// opened. Throws InputError with that, else with `problem` and `hint`.
[[noreturn]] void refuse_to_open(const VendorDriver& driver, const std::string& device,
                                 const Sentence& problem, const Sentence& hint,
                                 const UsbFolders& folders = {});

}  // namespace fulcrum::hapticd
