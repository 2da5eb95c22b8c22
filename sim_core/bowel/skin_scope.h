// SPDX-License-Identifier: Apache-2.0
// How many rings of the cage carry a vertex of the bowel's surface (docs/THEORY.md, sections 1.4 and 8).
#pragma once

#include <cstdint>

namespace fulcrum {

enum class SkinScope : std::uint8_t {
    local,   ///< k = 1: BowelSkin's own rows
    local2,  ///< k = 2
    global,  ///< the whole closed cage
};

}  // namespace fulcrum
