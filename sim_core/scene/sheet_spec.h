// SPDX-License-Identifier: Apache-2.0
// The sheet of B2: its values in a scene. SI units.
#pragma once

#include <optional>
#include <string>

#include "sim_core/numerics/types.h"
#include "sim_core/scene/fibre_spec.h"

namespace fulcrum {

/// A rectangle of layered tissue between a fixed edge and a flap, to be held under traction and divided along
/// a marked line (B2).
struct SheetSpec {
    std::string kind = "areolar";  ///< "areolar", the only one
    std::string tissue = "areolar";
    Vector3 centre = Vector3::Zero();    ///< m
    Vector3 along = Vector3(0, 1, 0);    ///< unit, of the marked line
    Vector3 across = Vector3(1, 0, 0);   ///< unit, from the fixed edge to the flap, at right angles to it
    double length = 0.12, width = 0.05;  ///< m, along and across
    double spacing = 0.004;              ///< m between vertices
    double thickness = 0.0015;           ///< m
    double line_length = 0.10;           ///< m, in the middle of the length
    double line_at = 0.5;                ///< fraction of the width from the fixed edge
    double flap_stiffness = 300;         ///< N/m, of the support of the whole flap edge
    double structural_stiffness = 20;    ///< N/m each spring, as shear and bend
    double shear_stiffness = 8;
    double bend_stiffness = 1;
    double surface_density = 0.8;  ///< kg/m2
    double pre_strain = 0.06;
    double stiffness_damping = 3e-5;  ///< s
    double mass_damping = 12;         ///< 1/s
    double weight = 0.3;              ///< fraction of its weight not carried by the tissue beneath
    double blade_width = 0.0006;      ///< m, of the band that a blade removes
    std::optional<FibreSpec> fibres;  ///< absent: only a blade divides the tissue
};

}  // namespace fulcrum
