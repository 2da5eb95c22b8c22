// SPDX-License-Identifier: Apache-2.0
// Reference for a rod without bending stiffness: the elastic catenary in closed form (Irvine, Cable
// Structures, 1981, section 1.3).
#pragma once

namespace fulcrum::lab {

struct Catenary {
    double length = 1;           ///< m, unstretched
    double span = 0.6;           ///< m, between supports of equal height
    double weight = 1;           ///< N/m of unstretched length
    double axial_stiffness = 1;  ///< N, EA
};

/// Horizontal part of the tension, N; the one unknown of the closed form, by bisection.
double catenary_tension(const Catenary& catenary);
/// Position of the point at unstretched arc length s: x from the left support, z (negative) below it, m.
struct CatenaryPoint {
    double x = 0, z = 0;
};
CatenaryPoint catenary_point(const Catenary& catenary, double tension, double s);

}  // namespace fulcrum::lab
