// SPDX-License-Identifier: Apache-2.0
// A library that is loaded while the program runs and never linked: where it is missing, the program says so
// and works with other devices.
#pragma once

#include <string>
#include <vector>

#include "sim_core/devices/maker_library.h"

namespace fulcrum {

/// A function of a library and where its address is put.
struct Symbol {
    const char* name;
    void** address;
};
template <typename Function>
Symbol symbol(const char* name, Function*& function) {
    return {name, reinterpret_cast<void**>(&function)};
}

/// Loads the library that the environment `variable` names, else the first of `names` that exists, and finds
/// every symbol. It stays loaded. `detail` is in English.
LibraryLook load_run_time_library(const char* variable, const std::vector<std::string>& names,
                                  const std::vector<Symbol>& symbols);

}  // namespace fulcrum
