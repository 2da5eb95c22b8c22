// SPDX-License-Identifier: Apache-2.0
// How far a rod's step is solved (docs/THEORY.md, section 8).
#pragma once

#include <cstdint>

namespace fulcrum {

enum class RodLevel : std::uint8_t { linearised, newton_k, newton };

}  // namespace fulcrum
