// SPDX-License-Identifier: Apache-2.0
// The pelvic cavity: its values in a scene. SI units.
#pragma once

#include <cstdint>
#include <string>

namespace fulcrum {

/// Its wall is what instruments feel.
struct CavitySpec {
    double pelvis_width = 0.125;  ///< m, transverse diameter of the inlet
    double pelvis_depth = 0.115;  ///< m, inlet to floor
    std::uint64_t seed = 1;
    std::string tissue = "wall";
};

}  // namespace fulcrum
