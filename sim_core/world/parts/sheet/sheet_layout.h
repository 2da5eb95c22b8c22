// SPDX-License-Identifier: Apache-2.0
// How a scene's sheet lies and is held before anything is done to it: a rectangle (`sheet`) or septa behind
// the rectum (`septa`). Start of an attempt; any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/anatomy/rectum.h"
#include "sim_core/geometry/mesh.h"
#include "sim_core/membrane/cut_membrane.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

struct SheetLayout {
    /// vertex = (piece * rows + row) * columns + column; row 0 the fixed edge, columns along the marked line.
    /// Counterclockwise seen from along x across.
    TriangleMesh mesh;
    std::int32_t columns = 0, rows = 0, pieces = 1;
    std::vector<CutMembrane::Attachment> attachments;
    std::vector<std::int32_t> held;  ///< vertices of them
    std::vector<double> zones;       ///< of the springs' stiffness, by triangle; empty: one zone
    // Septa only; empty for a rectangle, whose rest is flat.
    std::vector<Vector3> rest;         ///< by vertex, as SheetView::rest
    std::vector<std::int32_t> driven;  ///< vertices on the rectum's wall
    std::vector<double> arc_lengths;   ///< m along the rectum, by piece
    std::int32_t envelope_row = 0;     ///< where the fat begins
};

SheetLayout lay_out_sheet(const SheetSpec& spec);
SheetLayout lay_out_septa(const SeptaSpec& spec, const SacralCurve& curve);

/// What a sheet and septa have in common: springs, spacing, thickness, blade and tissue of the areolar zone.
SheetSpec common_spec(const SeptaSpec& spec);

}  // namespace fulcrum
