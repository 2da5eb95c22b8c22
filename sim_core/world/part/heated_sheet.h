// SPDX-License-Identifier: Apache-2.0
// A sheet as the energy of instruments finds it: the triangles that it was made of, each a patch of tissue
// that takes heat, and which of them is under a hand's instrument.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

/// What of a sheet is under a hand's instrument.
struct SheetUnder {
    std::int32_t root = -1;  ///< triangle of HeatedSheet::mesh(), -1: none
    bool fat = false;        ///< beyond the tissue that is to be divided
};

class HeatedSheet {
  public:
    virtual ~HeatedSheet() = default;
    /// As it was made; any thread.
    virtual const TriangleMesh& mesh() const noexcept = 0;
    /// m, where the mesh's vertices are now, and then others.
    virtual const std::vector<Vector3>& vertices_now() const noexcept = 0;
    /// Whether a triangle, as it was made, lies beyond the tissue that is to be divided.
    virtual bool root_in_fat(std::int32_t root) const = 0;
    /// In the step's solution.
    virtual SheetUnder under(int hand) const noexcept = 0;
};

}  // namespace fulcrum
