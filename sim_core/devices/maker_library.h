// SPDX-License-Identifier: Apache-2.0
// The library of a device's maker, which fulcrum-hapticd loads and the person installs: whether it is there,
// and what to do where it is not.
#pragma once

#include <string>

namespace fulcrum {

struct DeviceRow;

enum class LibraryState {
    ready,       ///< every function that is needed was found
    missing,     ///< no file of this name
    incomplete,  ///< a library that it needs is missing
    outdated,    ///< a function is missing
    unusable     ///< it does not load, or ends the process that loads it
};
/// Texts in English, translated in the context "errors".
const char* problem_of(LibraryState state);
const char* hint_of(const DeviceRow& device, LibraryState state);

/// What loading the library gave; `detail` is what the system says.
struct LibraryLook {
    LibraryState state = LibraryState::ready;
    std::string detail;
};
/// Asks `program` (fulcrum-hapticd), which loads the library in a process of its own: nothing of the maker's
/// runs here. Waits for at most 3 s.
LibraryLook look_at_library(const std::string& program, const std::string& kind);

}  // namespace fulcrum
