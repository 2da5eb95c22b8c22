// SPDX-License-Identifier: Apache-2.0
// What a scene's spec of a sheet (MembraneSpec, SheetSpec) says of its springs. Start of an attempt; any
// thread.
#pragma once

#include "sim_core/geometry/mesh.h"
#include "sim_core/membrane/springs.h"

namespace fulcrum {

/// mesh: the sheet at rest, m; its area carries the spec's surface density.
template <typename Spec>
MembraneMaterial sheet_material(const Spec& spec, const TriangleMesh& mesh) {
    MembraneMaterial material;
    material.structural_stiffness = spec.structural_stiffness;
    material.shear_stiffness = spec.shear_stiffness;
    material.bend_stiffness = spec.bend_stiffness;
    material.mass = spec.surface_density * surface_area(mesh);
    material.pre_strain = spec.pre_strain;
    material.stiffness_damping = spec.stiffness_damping;
    material.mass_damping = spec.mass_damping;
    return material;
}

}  // namespace fulcrum
