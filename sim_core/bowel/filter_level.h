// SPDX-License-Identifier: Apache-2.0
// Levels of the force filter (docs/THEORY.md, section 8).
#pragma once

#include <cstdint>

namespace fulcrum {

enum class FilterLevel : std::uint8_t { off, grade_0, grade_1, grade_2, adaptive };

}  // namespace fulcrum
