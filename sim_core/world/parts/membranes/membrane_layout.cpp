// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/membranes/membrane_layout.h"

#include "sim_core/anatomy/scene_anatomy.h"

namespace fulcrum {
namespace {

// Held along the bowel (first column) and along the root (last column).
MembraneSheet mesentery_sheet(const MesenteryShape& shape) {
    MembraneSheet sheet;
    sheet.mesh = shape.mesh;
    for (int row = 0; row < shape.rows; ++row) {
        sheet.bowel_vertices.push_back(row * shape.columns);
        sheet.bowel_arc_lengths.push_back(
            shape.vertices[static_cast<std::size_t>(row * shape.columns)].arc_length);
        sheet.wall_vertices.push_back((row + 1) * shape.columns - 1);
    }
    return sheet;
}

}  // namespace

std::vector<MembraneSheet> lay_out_membranes(const Scene& scene) {
    std::vector<MembraneSheet> sheets;
    if (scene.membranes.empty() || !scene.bowel || !scene.cavity) return sheets;
    const CavityShape cavity = make_cavity(pelvis_parameters(*scene.cavity));
    BowelShape whole = make_bowel(bowel_parameters(*scene.bowel), cavity);
    for (const MembraneSpec& spec : scene.membranes)
        sheets.push_back(mesentery_sheet(make_mesentery(whole, cavity, spec.first, spec.last)));
    return sheets;
}

}  // namespace fulcrum
