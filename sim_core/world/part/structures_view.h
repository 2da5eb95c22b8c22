// SPDX-License-Identifier: Apache-2.0
// The veins of a wall, and what energy has done to the sheet in front of it, as the viewport, the monitor and
// the operators see them after a step (WorldSnapshot::structures). Vectors have their final size from the
// start.
#pragma once

#include <vector>

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// A vein beneath a wall.
struct VeinView {
    std::vector<Vector3> line;  ///< m, above it on the wall
    double radius = 0;          ///< m
    double depth = 0;           ///< m, wall to vein

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(line, radius, depth);
    }
};

struct StructuresView {
    std::vector<VeinView> veins;
    /// Of a sheet that energy divides, by its root triangle as it was made (SheetView::roots); empty without.
    std::vector<float> sheet_char;  ///< 0 moist .. 1 dry and black
    std::vector<float> sheet_dose;  ///< min (CEM43)

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(veins, sheet_char, sheet_dose);
    }
};

}  // namespace fulcrum
