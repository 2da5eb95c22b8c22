// SPDX-License-Identifier: Apache-2.0
// How a membrane is stepped in time (docs/THEORY.md, section 8).
#pragma once

#include <cstdint>

namespace fulcrum {

enum class MembraneIntegrator : std::uint8_t { symplectic, global_local, implicit };

}  // namespace fulcrum
