// SPDX-License-Identifier: Apache-2.0
// A membrane as the viewport sees it after a step (WorldSnapshot::membranes).
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

/// A membrane to be drawn: open sheet, seen from both sides.
struct MembraneView {
    std::vector<Vector3> positions;   ///< m, patient frame
    std::vector<Triangle> triangles;  ///< change with `topology` only
    std::uint32_t topology = 0;

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(positions, triangles, topology);
    }
};

}  // namespace fulcrum
