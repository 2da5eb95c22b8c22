// SPDX-License-Identifier: Apache-2.0
// The sheet that is divided as the viewport, the monitor and the operators see it after a step
// (WorldSnapshot::sheet).
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"
#include "sim_core/numerics/types.h"
#include "sim_core/world/part/used_vector.h"

namespace fulcrum {

/// A sheet that is divided along a marked line.
struct SheetView {
    std::vector<Vector3>
        line;  ///< m, where the marked line's points are now, patient frame; empty without a sheet
    std::vector<double> line_positions;      ///< m at rest from the line's start, rising; one for each point
    std::vector<double> line_traction;       ///< N/m across the line at each point; 0 where it is divided
    std::vector<std::uint8_t> line_divided;  ///< 1 where the sheet is divided across the line at this point
    std::vector<Vector3> flap;  ///< m, the free edge that can be taken hold of, in the line's direction
    /// To be drawn: an open sheet, seen from both sides. Fixed capacity, *_count valid; rest and triangles
    /// change with `topology` only.
    UsedVector<Vector3> positions;  ///< m, patient frame
    UsedVector<Vector3> rest;  ///< m, in the sheet as it was made: x along the marked line from its start, y
                               ///< from it towards the flap, z = 0
    UsedVector<Triangle> triangles;  ///< visible ones
    UsedVector<std::int32_t>
        roots;  ///< of each: the triangle as it was made that it is a part of, StructuresView::sheet_char
    std::int32_t vertex_count = 0, triangle_count = 0;
    std::uint32_t topology = 0;
    double thickness = 0;  ///< m
    // Septa: the marked lines laid end to end, the first the most cranial; septum = floor(x / septum_length).
    double septum_length = 0;       ///< m; 0: one sheet
    double fat_from = 0;            ///< m, y at rest where the fat of the mesorectum begins
    std::vector<Vector3> envelope;  ///< m, where that border is now, septum * envelope_columns + column, the
                                    ///< patient's right first; where the tissue is gone its last place
    std::int32_t envelope_columns = 0;
    double visible_area = 0, removed_area = 0;  ///< m2 at rest

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(line, line_positions, line_traction, line_divided, flap, positions, rest, triangles, roots,
              vertex_count, triangle_count, topology, thickness, septum_length, fat_from, envelope,
              envelope_columns, visible_area, removed_area);
    }
};

}  // namespace fulcrum
