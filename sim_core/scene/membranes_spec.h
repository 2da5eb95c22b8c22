// SPDX-License-Identifier: Apache-2.0
// The mesentery as sheets of masses and springs: their values in a scene. SI units.
#pragma once

#include <string>

namespace fulcrum {

/// A membrane of masses and springs from the bowel's wall to the wall of the cavity: the mesentery, as an
/// alternative to tethers.
struct MembraneSpec {
    std::string kind = "mesentery";    ///< "mesentery", the only one
    double first = 0.10, last = 0.90;  ///< fractions of the bowel's length that carry it
    double structural_stiffness = 12;  ///< N/m each spring, as shear and bend
    double shear_stiffness = 6;
    double bend_stiffness = 0.6;
    double surface_density = 1.0;     ///< kg/m2
    double pre_strain = 0;            ///< -0.5 .. 1; below 0: slack
    double stiffness_damping = 5e-5;  ///< s
    double mass_damping = 4;          ///< 1/s
    double weight = 0;                ///< fraction of its weight not carried by the wall beneath
};

}  // namespace fulcrum
