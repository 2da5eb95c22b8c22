// SPDX-License-Identifier: Apache-2.0
// What a measured page says of where it was measured, and of what.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fulcrum::lab {

/// Of the program: compiler with version, flags of its code, commit (with a word when the sources differed
/// from it). Defined by the target fulcrum_build_info, made anew by each build; only programs that print
/// pages link it.
struct BuildInfo {
    std::string compiler, flags, commit;
};
BuildInfo build_info();

/// Of the machine that runs it, with the build.
struct Machine {
    std::string processor;
    unsigned cores = 0;  ///< that this process may use
    BuildInfo build;
    /// "Intel Xeon, 2 cores; GCC 12.2.0, -O3 ..."
    std::string text() const;
};
Machine this_machine(const BuildInfo& build);
nlohmann::json to_json(const Machine& machine);

}  // namespace fulcrum::lab
